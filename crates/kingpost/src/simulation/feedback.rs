//! Small motions with the feedback of the elements that state a linear law: which modes grow.

use super::sampled_loops::{FeedbackLoop, HeldInputs, Sensed, fastest, vector};
use super::small_motions::{Changed, DIFFERENCE};
use super::{MOST_DENSE, Simulation, stage};
use crate::elements::{EvaluationMode, LinearLaw};
use crate::integrate::Stage;
use crate::results::Sample;
use core::f64::consts::{PI, TAU};
use nalgebra::{Complex, DMatrix, DVector};

/// A mode that grows with feedback.
#[derive(Clone, Debug, PartialEq)]
pub struct GrowingMode {
    /// The coordinate with the largest kinetic energy, each taken by itself.
    pub coordinate: String,
    /// Time between two maxima, s; `None` if it does not oscillate.
    pub period_s: Option<f64>,
    /// Time in which it grows e-fold, s.
    pub growth_time_s: f64,
    /// The elements without which it does not grow so; empty if it grows without any of them too.
    pub because_of: Vec<String>,
}

/// Modes that grow more slowly than this count as standing still, 1/s: free motions have zero eigenvalues in pairs, which
/// differences find to the root of their error.
const SLOWEST_GROWTH: f64 = 1e-3;
/// A law is the reason if without it nothing grows at more than this share of the rate.
const SHARE: f64 = 0.5;
impl Simulation {
    /// The mode that grows fastest from here with the feedback of all elements that state a
    /// [linear law](crate::elements::Element::linear_law); `None` if none grows, or nothing is fed back.
    ///
    /// Between samples `x' = A x + B u` with u held, so `x -> e^(A h) x + (integral of e^(A s) ds) B u` (Franklin, Powell &
    /// Workman, *Digital Control of Dynamic Systems*, 3rd ed., 1998, sec. 4.3), at a sample `u = G C x + H (sum of C x T)`.
    /// The eigenvalues z of the map over a time in which all laws begin anew are those of modes that grow by |z|. A, B and C
    /// are by differences, in still water and with prescribed motions held; sensors are taken as exact, with their
    /// delays.
    pub fn growing_with_feedback(&mut self) -> Option<GrowingMode> {
        let laws = self.laws();
        if laws.is_empty() || self.plant.model.velocity_count > MOST_DENSE {
            return None;
        }
        let a = self.small_motions();
        self.plant.set_evaluation_mode(EvaluationMode::Unsampled);
        let (b, loops) = self.loops(laws, a.nrows());
        self.plant.set_evaluation_mode(EvaluationMode::Running);
        let held = HeldInputs { a, b, step_s: self.settings.step_s };
        let all: Vec<&FeedbackLoop> = loops.iter().collect();
        let (map, time_s) = held.map(&all)?;
        let value = fastest(&map)?;
        let rate = libm::log(value.norm_sqr()) / (2.0 * time_s);
        if rate < SLOWEST_GROWTH {
            return None;
        }
        let slower = |without: &[&FeedbackLoop]| held.growth(without).is_none_or(|other| other < SHARE * rate);
        let is_reason =
            |one: &&FeedbackLoop| slower(&loops.iter().filter(|other| other.first != one.first).collect::<Vec<_>>());
        let mut because: Vec<&FeedbackLoop> = loops.iter().filter(is_reason).collect();
        if because.is_empty() && slower(&[]) {
            because = loops.iter().collect();
        }
        let turn = libm::atan2(value.im, value.re).abs();
        Some(GrowingMode {
            coordinate: self.moves_most(&map, value),
            // Below 1e-6 of half a circle the turn of an eigenvalue is rounding: the mode grows without oscillation.
            period_s: (turn > 1e-6 * PI).then(|| TAU * time_s / turn),
            growth_time_s: 1.0 / rate,
            because_of: because.into_iter().map(|one| one.name.clone()).collect(),
        })
    }

    /// The laws, each with the number of the steering element.
    fn laws(&self) -> Vec<(usize, LinearLaw)> {
        let steers = self.plant.layout().steers.iter().enumerate();
        steers.filter_map(|(k, steer)| Some((k, self.plant.elements()[steer.element].linear_law()?))).collect()
    }

    /// B of the inputs that the laws set, and the laws with C of the columns that they read.
    fn loops(&mut self, laws: Vec<(usize, LinearLaw)>, size: usize) -> (DMatrix<f64>, Vec<FeedbackLoop>) {
        let (mut columns, mut loops) = (Vec::new(), Vec::new());
        for (steer, law) in laws {
            let steering = &self.plant.layout().steers[steer];
            let (name, inputs) = (self.plant.layout().names[steering.element].clone(), steering.inputs.clone());
            let first = columns.len();
            let reached: Vec<Option<usize>> = inputs.into_iter().map(|input| self.passed_to(input)).collect();
            let nothing = || DVector::zeros(size);
            let effect = |input: Option<usize>| input.map_or_else(nothing, |to| self.rates_by(Changed::Input(to)));
            columns.extend(reached.into_iter().map(effect));
            let reads: Vec<DVector<f64>> = (0..size).map(|state| self.columns_by_state(steer, state)).collect();
            let matrix = |rows: &[Vec<f64>]| DMatrix::from_fn(rows.len(), reads[0].len(), |i, j| rows[i][j]);
            let (gains, integral_gains) = (matrix(&law.gains), matrix(&law.integral_gains));
            let steps = self.whole_steps(law.period_s);
            let sensed = self.sensed(steer, steps);
            let reads = DMatrix::from_columns(&reads);
            loops.push(FeedbackLoop { name, gains, integral_gains, reads, sensed, first, steps });
        }
        (DMatrix::from_columns(&columns), loops)
    }

    /// The input of no controller to which an input is passed on at once, itself if it is that of none; `None` if a controller
    /// in between does not pass it.
    fn passed_to(&self, input: usize) -> Option<usize> {
        let layout = self.plant.layout();
        let mut at = input;
        // Each controller stands before the next: there are no circles.
        while let Some(steer) = layout.steers.iter().find(|steer| layout.slices[steer.element].inputs.contains(&at)) {
            let first = layout.slices[steer.element].inputs.start;
            let passed = self.plant.elements()[steer.element].passes_to(at - first)?;
            at = *steer.inputs.get(passed)?;
        }
        Some(at)
    }

    /// How the columns that a steering element reads at every so many steps are sensed, if they are those of sensors. A value
    /// that is held for longer than that is half the rest older on average.
    fn sensed(&self, steer: usize, every: u64) -> Vec<Option<Sensed>> {
        let layout = self.plant.layout();
        let signals = layout.signals();
        let of = |column: &String| {
            let signal = signals.iter().find(|signal| signal.name == *column)?;
            let share = &layout.slices[signal.element];
            let steps = self.whole_steps(share.period_s?);
            Some(Sensed { steps, age: share.delay_samples as u64 * steps + steps.saturating_sub(every) / 2 })
        };
        layout.steers[steer].reads.iter().map(of).collect()
    }

    fn whole_steps(&self, period_s: f64) -> u64 {
        libm::round(period_s / self.settings.step_s).max(1.0) as u64
    }

    /// The columns that a steering element reads, by a state.
    fn columns_by_state(&mut self, steer: usize, state: usize) -> DVector<f64> {
        let [more, less] = [DIFFERENCE, -DIFFERENCE].map(|change| self.columns_with(steer, state, change));
        (more - less) / (2.0 * DIFFERENCE)
    }

    fn columns_with(&mut self, steer: usize, state: usize, change: f64) -> DVector<f64> {
        let [q, v, s] = self.displaced(state, change);
        let interval = self.interval();
        let Self { plant, channels, state, steering, v_dot, .. } = self;
        let at = Stage { q: &q, v: &v, s: &s, ..stage(interval, state) };
        let mut read = Vec::new();
        let readings = steering.readings(steer);
        let observed = plant.observe(at, readings.extent(), v_dot);
        readings.read(&Sample { time_s: at.time_s, q: at.q, v: at.v, s: at.s, observed }, channels, &mut read);
        DVector::from_vec(read)
    }

    /// The coordinate with the largest kinetic energy in a mode of the map.
    fn moves_most(&mut self, map: &DMatrix<f64>, value: Complex<f64>) -> String {
        let names = self.coordinates();
        let masses: Vec<f64> = self.mass_matrix().into_iter().step_by(names.len() + 1).collect();
        let shape = vector(map, value);
        let energy = |i: usize| masses[i] * shape[names.len() + i].norm_sqr();
        let largest = (0..names.len()).max_by(|&i, &j| energy(i).total_cmp(&energy(j)));
        largest.map_or_else(String::new, |i| names[i].clone())
    }
}
