//! Small motions with the feedback of the elements that state a linear law: which modes grow.

use super::small_motions::{Changed, DIFFERENCE};
use super::{Simulation, stage};
use crate::elements::{LinearLaw, Situation};
use crate::integrate::Stage;
use crate::results::Sample;
use crate::spatial::exponential;
use core::f64::consts::{PI, TAU};
use nalgebra::{Complex, DMatrix, DVector, Schur};

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
/// Most samples after which all laws sample at once again.
const MOST_SAMPLES: u64 = 1000;
/// Iterations of the search for eigenvalues.
const MOST_ITERATIONS: usize = 20_000;
/// Shift from the eigenvalue in the inverse iteration, as a share of its modulus.
const BESIDE: f64 = 1e-9;

/// A law with the inputs that it sets, among those of all laws, and how often it samples, in steps.
struct FeedbackLoop {
    name: String,
    gains: DMatrix<f64>,
    /// Without rows if nothing is summed.
    integral_gains: DMatrix<f64>,
    reads: DMatrix<f64>,
    first: usize,
    steps: u64,
}

impl Simulation {
    /// The mode that grows fastest from here with the feedback of all elements that state a
    /// [linear law](crate::elements::Element::linear_law); `None` if none grows, or nothing is fed back.
    ///
    /// Between samples `x' = A x + B u` with u held, so `x -> e^(A h) x + (integral of e^(A s) ds) B u` (Franklin, Powell &
    /// Workman, *Digital Control of Dynamic Systems*, 3rd ed., 1998, sec. 4.3), at a sample `u = G C x + H (sum of C x T)`.
    /// The eigenvalues z of the map over a time in which all laws begin anew are those of modes that grow by |z|. A, B and C
    /// are by differences, in still water and with prescribed motions held.
    pub fn growing_with_feedback(&mut self) -> Option<GrowingMode> {
        let laws = self.laws();
        if laws.is_empty() {
            return None;
        }
        let a = self.small_motions();
        self.plant.set_situation(Situation::AtRest);
        let (b, loops) = self.loops(laws, a.nrows());
        self.plant.set_situation(Situation::Running);
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
            let steps = libm::round(law.period_s / self.settings.step_s).max(1.0) as u64;
            loops.push(FeedbackLoop {
                name,
                gains,
                integral_gains,
                reads: DMatrix::from_columns(&reads),
                first,
                steps,
            });
        }
        (DMatrix::from_columns(&columns), loops)
    }

    /// The input of no controller to which an input is passed on at once, itself if it is that of none; `None` if a controller
    /// in between does not pass it.
    fn passed_to(&self, input: usize) -> Option<usize> {
        let layout = self.plant.layout();
        let mut at = input;
        // Each controller stands before the next: there are no circles.
        while let Some(steer) = layout.steers.iter().find(|steer| layout.shares[steer.element].inputs.contains(&at)) {
            let first = layout.shares[steer.element].inputs.start;
            let passed = self.plant.elements()[steer.element].passes_to(at - first)?;
            at = *steer.inputs.get(passed)?;
        }
        Some(at)
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

/// A and B between samples.
struct HeldInputs {
    a: DMatrix<f64>,
    b: DMatrix<f64>,
    step_s: f64,
}

impl HeldInputs {
    /// The map of states, held inputs and sums over the time in which all laws begin anew, and this time, s.
    fn map(&self, loops: &[&FeedbackLoop]) -> Option<(DMatrix<f64>, f64)> {
        let (n, m) = self.b.shape();
        let unit = loops.iter().fold(0, |unit, one| divisor(unit, one.steps)).max(1);
        let samples = loops.iter().try_fold(1, |all: u64, one| {
            let own = one.steps / unit;
            (all / divisor(all, own)).checked_mul(own).filter(|all| *all <= MOST_SAMPLES)
        })?;
        let between_s = unit as f64 * self.step_s;
        let sums = if loops.iter().any(|one| one.integral_gains.nrows() > 0) { m } else { 0 };
        let mut rates = DMatrix::zeros(n + m + sums, n + m + sums);
        rates.view_mut((0, 0), (n, n)).copy_from(&(&self.a * between_s));
        rates.view_mut((0, n), (n, m)).copy_from(&(&self.b * between_s));
        let between = exponential(rates);
        let mut map = DMatrix::identity(n + m + sums, n + m + sums);
        for sample in 0..samples {
            for one in loops.iter().filter(|one| sample % (one.steps / unit) == 0) {
                map = self.sampled(one, sums) * map;
            }
            map = &between * map;
        }
        // Inputs that no loop sets stay zero, and so do sums that nothing adds to.
        for input in 0..m {
            let of = |one: &&&FeedbackLoop| (one.first..one.first + one.gains.nrows()).contains(&input);
            let of = loops.iter().find(of);
            let unset = of.is_none().then_some(n + input);
            let unsummed = of.is_none_or(|one| one.integral_gains.nrows() == 0) && sums > 0;
            for place in unset.into_iter().chain(unsummed.then_some(n + m + input)) {
                map.column_mut(place).fill(0.0);
                map.row_mut(place).fill(0.0);
            }
        }
        Some((map, samples as f64 * between_s))
    }

    /// What a sample of a loop does to states, held inputs and sums.
    fn sampled(&self, one: &FeedbackLoop, sums: usize) -> DMatrix<f64> {
        let (n, m) = self.b.shape();
        let mut update = DMatrix::identity(n + m + sums, n + m + sums);
        let mut law = &one.gains * &one.reads;
        if one.integral_gains.nrows() > 0 {
            let summed = &one.integral_gains * &one.reads * (one.steps as f64 * self.step_s);
            law += &summed;
            update.view_mut((n + m + one.first, 0), (law.nrows(), n)).copy_from(&summed);
            (0..law.nrows()).for_each(|k| update[(n + one.first + k, n + m + one.first + k)] = 1.0);
        }
        update.view_mut((n + one.first, 0), (law.nrows(), n)).copy_from(&law);
        (0..law.nrows()).for_each(|k| update[(n + one.first + k, n + one.first + k)] = 0.0);
        update
    }

    /// The rate of the fastest growth with these laws, 1/s.
    fn growth(&self, loops: &[&FeedbackLoop]) -> Option<f64> {
        let (map, time_s) = self.map(loops)?;
        Some(libm::log(fastest(&map)?.norm_sqr()) / (2.0 * time_s))
    }
}

/// The eigenvalue with the largest modulus.
fn fastest(map: &DMatrix<f64>) -> Option<Complex<f64>> {
    if !map.iter().all(|x| x.is_finite()) {
        return None;
    }
    let values = Schur::try_new(map.clone(), f64::EPSILON, MOST_ITERATIONS)?.complex_eigenvalues();
    values.iter().copied().max_by(|one, other| one.norm_sqr().total_cmp(&other.norm_sqr()))
}

/// The eigenvector of an eigenvalue, by inverse iteration with a shift; zero if there is none.
fn vector(map: &DMatrix<f64>, value: Complex<f64>) -> DVector<Complex<f64>> {
    let n = map.nrows();
    let beside = value * (1.0 + BESIDE);
    let shifted =
        DMatrix::from_fn(n, n, |i, j| Complex::from(map[(i, j)]) - if i == j { beside } else { Complex::ZERO });
    let factors = shifted.lu();
    let mut found = DVector::from_fn(n, |i, _| Complex::new(1.0 + 0.1 * (i % 7) as f64, 0.3));
    for _ in 0..2 {
        let Some(next) = factors.solve(&found) else { break };
        let size = next.norm();
        found = next.unscale(size);
    }
    found
}

/// Greatest common divisor.
fn divisor(one: u64, other: u64) -> u64 {
    if other == 0 { one } else { divisor(other, one % other) }
}
