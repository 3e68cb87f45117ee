//! Stability of small motions with feedback: the growing modes of a model with the linear control laws of its
//! elements.

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
    /// The coordinate with the largest kinetic energy in the mode, each coordinate considered alone.
    pub coordinate: String,
    /// Time between two maxima, s; `None` if it does not oscillate.
    pub period_s: Option<f64>,
    /// Time in which the amplitude grows by a factor of e, s.
    pub growth_time_s: f64,
    /// The elements whose feedback causes the growth: without it the mode grows more slowly or not at all.
    /// Empty if the mode also grows without any feedback.
    pub because_of: Vec<String>,
}

/// Growth rate below which a mode counts as not growing, 1/s: free motions have zero eigenvalues in pairs,
/// and differences find these with the square root of their error.
const SLOWEST_GROWTH: f64 = 1e-3;
/// A control law causes the growth if, without it, no mode grows faster than this share of the rate.
const SHARE: f64 = 0.5;
impl Simulation {
    /// Returns the fastest-growing mode about the present state, with the feedback of all elements that have
    /// a [linear law](crate::elements::Element::linear_law); `None` if no mode grows, or there is no
    /// feedback.
    ///
    /// Between samples `x' = A x + B u` with u held, so `x -> e^(A h) x + (integral of e^(A s) ds) B u`
    /// (Franklin, Powell & Workman, *Digital Control of Dynamic Systems*, 3rd ed., 1998, sec. 4.3), at a
    /// sample `u = G C x + H (sum of C x T)`. An eigenvalue z of the map over a common period of all laws
    /// belongs to a mode that grows by the factor |z|. A, B and C are computed by differences, in still water
    /// and with prescribed motions held; sensors have no errors but their delays.
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
            // An angle of an eigenvalue below 1e-6 of half a turn is rounding: the mode grows without
            // oscillation.
            period_s: (turn > 1e-6 * PI).then(|| TAU * time_s / turn),
            growth_time_s: 1.0 / rate,
            because_of: because.into_iter().map(|one| one.name.clone()).collect(),
        })
    }

    /// Returns the linear laws, each with the number of its steering element.
    fn laws(&self) -> Vec<(usize, LinearLaw)> {
        let steers = self.plant.layout().steers.iter().enumerate();
        steers.filter_map(|(k, steer)| Some((k, self.plant.elements()[steer.element].linear_law()?))).collect()
    }

    /// Returns B of the inputs that the laws set, and the laws with C of the columns that they read.
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

    /// Returns the final input to which controllers pass an input on without delay: the input itself if it
    /// belongs to no controller; `None` if a controller in between does not pass it on.
    fn passed_to(&self, input: usize) -> Option<usize> {
        let layout = self.plant.layout();
        let mut at = input;
        // Each controller precedes the next one, so the search ends.
        while let Some(steer) = layout.steers.iter().find(|steer| layout.slices[steer.element].inputs.contains(&at)) {
            let first = layout.slices[steer.element].inputs.start;
            let passed = self.plant.elements()[steer.element].passes_to(at - first)?;
            at = *steer.inputs.get(passed)?;
        }
        Some(at)
    }

    /// Returns, for each column that a steering element reads, how its sensor delivers it; `every` is the
    /// interval between readings in steps. A value that is held for longer than this interval is older on
    /// average, by half the difference.
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

    /// Returns the derivatives of the columns that a steering element reads, with respect to the states.
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

    /// Returns the coordinate with the largest kinetic energy in a mode of the map.
    fn moves_most(&mut self, map: &DMatrix<f64>, value: Complex<f64>) -> String {
        let names = self.coordinates();
        let masses: Vec<f64> = self.mass_matrix().into_iter().step_by(names.len() + 1).collect();
        let shape = vector(map, value);
        let energy = |i: usize| masses[i] * shape[names.len() + i].norm_sqr();
        let largest = (0..names.len()).max_by(|&i, &j| energy(i).total_cmp(&energy(j)));
        largest.map_or_else(String::new, |i| names[i].clone())
    }
}
