//! Linear feedback at sampling times: the map over a common period of all laws, and its eigenvalues.

use crate::spatial::exponential;
use core::ops::Range;
use nalgebra::{Complex, DMatrix, DVector, Schur};

/// Largest number of samples in a common period, after which all laws sample at the same time again.
const MOST_SAMPLES: u64 = 1000;
/// Largest number of past values kept for the delays of sensors; if more are needed, they are kept at longer
/// intervals.
const MOST_PAST: u64 = 100;
/// Iterations of the search for eigenvalues.
const MOST_ITERATIONS: usize = 20_000;
/// Shift from the eigenvalue in the inverse iteration, as a share of the eigenvalue's modulus.
const BESIDE: f64 = 1e-9;

/// A linear law, with the indices of its inputs among those of all laws, and its sampling interval in steps.
pub(super) struct FeedbackLoop {
    pub(super) name: String,
    pub(super) gains: DMatrix<f64>,
    /// Gains of the integrals; no rows if the law has no integral action.
    pub(super) integral_gains: DMatrix<f64>,
    /// Rows of C for the columns that the law reads.
    pub(super) reads: DMatrix<f64>,
    /// Sampling and delay of each column's sensor; `None` if the column is read without delay.
    pub(super) sensed: Vec<Option<Sensed>>,
    pub(super) first: usize,
    pub(super) steps: u64,
}

/// Sampling interval and delay of a sensor, in steps.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sensed {
    /// Steps between two samples.
    pub(super) steps: u64,
    /// Age of a value when the law reads it, in steps.
    pub(super) age: u64,
}

impl FeedbackLoop {
    /// Returns the age of each column that the law reads, in multiples of `unit`.
    fn ages(&self, unit: u64) -> impl Iterator<Item = usize> + '_ {
        self.sensed.iter().map(move |sensed| sensed.map_or(0, |sensed| ((sensed.age + unit / 2) / unit) as usize))
    }

    fn inputs(&self) -> Range<usize> {
        self.first..self.first + self.gains.nrows()
    }
}

/// A and B over an interval with constant inputs.
pub(super) struct HeldInputs {
    pub(super) a: DMatrix<f64>,
    pub(super) b: DMatrix<f64>,
    pub(super) step_s: f64,
}

/// Indices of the parts of the map: states first, then held inputs, integrals, and past values for delayed
/// sensors.
struct Parts {
    inputs: usize,
    sums: Option<usize>,
    past: usize,
    all: usize,
}

impl HeldInputs {
    /// Returns the map of states, held inputs, integrals and past values over a common period of all laws,
    /// and the period, s.
    pub(super) fn map(&self, loops: &[&FeedbackLoop]) -> Option<(DMatrix<f64>, f64)> {
        let (n, m) = self.b.shape();
        let unit = unit(loops);
        let samples = samples(loops, unit)?;
        let between_s = unit as f64 * self.step_s;
        let has_sums = loops.iter().any(|one| one.integral_gains.nrows() > 0);
        let past = n + if has_sums { 2 * m } else { m };
        let all = past + loops.iter().flat_map(|one| one.ages(unit)).sum::<usize>();
        let parts = Parts { inputs: n, sums: has_sums.then_some(n + m), past, all };
        let mut rates = DMatrix::zeros(n + m, n + m);
        rates.view_mut((0, 0), (n, n)).copy_from(&(&self.a * between_s));
        rates.view_mut((0, n), (n, m)).copy_from(&(&self.b * between_s));
        let mut between = remember(loops, unit, &parts);
        let later = between.columns(0, all).rows(0, n + m).into_owned();
        between.rows_mut(0, n + m).copy_from(&(exponential(rates) * later));
        let mut past = parts.past;
        let updates = loops.iter().map(|one| {
            let update = self.sampled(one, &seen(one, unit, past, all), &parts);
            past += one.ages(unit).sum::<usize>();
            (one.steps / unit, update)
        });
        let updates: Vec<(u64, DMatrix<f64>)> = updates.collect();
        let mut map = DMatrix::identity(all, all);
        for sample in 0..samples {
            for (_, update) in updates.iter().filter(|(every, _)| sample % every == 0) {
                map = update * map;
            }
            map = &between * map;
        }
        // Inputs that no loop sets and integrals of no loop stay zero.
        for input in 0..m {
            let of = loops.iter().find(|one| one.inputs().contains(&input));
            let unset = of.is_none().then_some(parts.inputs + input);
            let is_summed = of.is_some_and(|one| one.integral_gains.nrows() > 0);
            let unsummed = parts.sums.filter(|_| !is_summed).map(|sums| sums + input);
            for place in unset.into_iter().chain(unsummed) {
                map.column_mut(place).fill(0.0);
                map.row_mut(place).fill(0.0);
            }
        }
        Some((map, samples as f64 * between_s))
    }

    /// Returns the map of states, held inputs and integrals over a sample of a loop; `seen` maps them to the
    /// columns that the loop reads.
    fn sampled(&self, one: &FeedbackLoop, seen: &DMatrix<f64>, parts: &Parts) -> DMatrix<f64> {
        let mut update = DMatrix::identity(parts.all, parts.all);
        let mut law = &one.gains * seen;
        let rows = law.nrows();
        let first = parts.inputs + one.first;
        if let Some(sums) = parts.sums.filter(|_| one.integral_gains.nrows() > 0).map(|sums| sums + one.first) {
            let summed = &one.integral_gains * seen * (one.steps as f64 * self.step_s);
            let mut kept = update.rows_mut(sums, rows);
            kept += &summed;
            law += &summed;
            (0..rows).for_each(|k| law[(k, sums + k)] += 1.0);
        }
        update.rows_mut(first, rows).copy_from(&law);
        update
    }

    /// Returns the growth rate of the fastest-growing mode with these laws, 1/s.
    pub(super) fn growth(&self, loops: &[&FeedbackLoop]) -> Option<f64> {
        let (map, time_s) = self.map(loops)?;
        Some(libm::log(fastest(&map)?.norm_sqr()) / (2.0 * time_s))
    }
}

/// Returns the time step of the map, in steps of the integrator: all laws sample at whole multiples of it,
/// and so do the delayed sensors unless that needs too many past values or samples.
fn unit(loops: &[&FeedbackLoop]) -> u64 {
    let of_laws = loops.iter().fold(0, |unit, one| divisor(unit, one.steps)).max(1);
    let late = || loops.iter().flat_map(|one| one.sensed.iter().flatten()).filter(|sensed| sensed.age > 0);
    let unit = late().fold(of_laws, |unit, sensed| divisor(unit, sensed.steps));
    let is_small = late().map(|sensed| sensed.age / unit).sum::<u64>() <= MOST_PAST && samples(loops, unit).is_some();
    if is_small { unit } else { of_laws }
}

/// Returns the number of time steps of the map in a common period of all laws; `None` if there are too many.
fn samples(loops: &[&FeedbackLoop], unit: u64) -> Option<u64> {
    loops.iter().try_fold(1, |all: u64, one| {
        let own = one.steps / unit;
        (all / divisor(all, own)).checked_mul(own).filter(|all| *all <= MOST_SAMPLES)
    })
}

/// Returns the rows of the columns that a loop reads: at the present time, or from the oldest of its past
/// values, which start at index `past`.
fn seen(one: &FeedbackLoop, unit: u64, mut past: usize, all: usize) -> DMatrix<f64> {
    let mut seen = DMatrix::zeros(one.reads.nrows(), all);
    for (read, age) in one.ages(unit).enumerate() {
        if age == 0 {
            seen.view_mut((read, 0), (1, one.reads.ncols())).copy_from(&one.reads.row(read));
        } else {
            past += age;
            seen[(read, past - 1)] = 1.0;
        }
    }
    seen
}

/// Shifts the past values by one and stores the present ones as the newest.
fn remember(loops: &[&FeedbackLoop], unit: u64, parts: &Parts) -> DMatrix<f64> {
    let mut moved = DMatrix::identity(parts.all, parts.all);
    let mut first = parts.past;
    for one in loops {
        for (read, age) in one.ages(unit).enumerate().filter(|(_, age)| *age > 0) {
            for place in first..first + age {
                moved.row_mut(place).fill(0.0);
                if place > first {
                    moved[(place, place - 1)] = 1.0;
                }
            }
            moved.view_mut((first, 0), (1, one.reads.ncols())).copy_from(&one.reads.row(read));
            first += age;
        }
    }
    moved
}

/// Returns the eigenvalue with the largest modulus.
pub(super) fn fastest(map: &DMatrix<f64>) -> Option<Complex<f64>> {
    if !map.iter().all(|x| x.is_finite()) {
        return None;
    }
    let values = Schur::try_new(map.clone(), f64::EPSILON, MOST_ITERATIONS)?.complex_eigenvalues();
    values.iter().copied().max_by(|one, other| one.norm_sqr().total_cmp(&other.norm_sqr()))
}

/// Returns the eigenvector of an eigenvalue, by inverse iteration with a shift; zero if there is none.
pub(super) fn vector(map: &DMatrix<f64>, value: Complex<f64>) -> DVector<Complex<f64>> {
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

/// Returns the greatest common divisor.
fn divisor(one: u64, other: u64) -> u64 {
    if other == 0 { one } else { divisor(other, one % other) }
}
