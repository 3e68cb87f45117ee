//! Drag in a random sea, linearised together with the response.

use super::excitation::WaveLoads;
use super::random_drags::RandomDrags;
use super::{AtRest, ResponseError, WaveGrid};
use crate::analysis::shifted::Shifted;
use crate::scenario::BuiltScenario;
use crate::simulation::Simulation;
use crate::spatial::Symmetric3;
use nalgebra::{Complex, DMatrix};
use serde::Deserialize;

/// Variances of the waves of a random sea.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct RandomSea {
    /// Directions and frequencies.
    pub waves: WaveGrid,
    /// Variance of the elevation by direction and frequency, m^2.
    pub variances_m2: Vec<Vec<f64>>,
}

/// Standard deviation of the relative velocity along each axis with which the iteration starts, m/s.
const FIRST_M_S: f64 = 0.1;
/// Largest change of a node's variance in the last iteration, as a share: its standard deviation, and the drag, change by half of it.
const CONVERGED: f64 = 1e-4;
/// Smallest variance of a node whose change counts, as a share of the largest: below it the drag is a thousandth.
const LEAST: f64 = 1e-6;
/// Largest number of iterations; 5 to 15 are usual.
const MOST_ITERATIONS: usize = 60;
/// Number of iterations that settle the model again. Where a node hardly touches the seabed, the mean drag lifts it off and lays it down in
/// turns; then the covariances are those about the last position.
const MOST_SETTLED: usize = 12;
/// Power of the last variance in the next one. At a resonance the variance is inversely proportional to the damping and so to the root
/// of the last variance: this power makes the iteration quadratic there, and a factor of 1/3 where the motion is forced.
const OF_LAST: f64 = 1.0 / 3.0;

/// Finds the covariances of relative velocities that the response with the drag over them has itself in this sea; `None` if no
/// element has random drag.
///
/// # Errors
/// The errors of the response, and covariances that do not converge.
pub(super) fn find(
    scenario: &BuiltScenario,
    simulation: &Simulation,
    sea: &RandomSea,
) -> Result<Option<RandomDrags>, ResponseError> {
    let elements = scenario.elements_in_waves()?;
    let first = Symmetric3::diagonal([FIRST_M_S * FIRST_M_S; 3]);
    let nodes = elements.iter().filter_map(|element| Some(element.random_drag()?.nodes()));
    let spreads: Vec<_> = nodes.map(|nodes| vec![first; nodes]).collect();
    let mut drags = RandomDrags { at_rest: spreads.clone(), spreads };
    if drags.spreads.is_empty() {
        return Ok(None);
    }
    sea.check()?;
    let (mut rest, mut change) = (simulation.clone(), f64::INFINITY);
    for iterations in 1..=MOST_ITERATIONS {
        let mut at = AtRest::new(scenario, &rest, Some(drags.clone()))?;
        let loads = WaveLoads::new(elements, &mut at.rest, &at.free)?;
        let next = covariances(&at, &loads, sea)?;
        change = largest_change(&drags.spreads, &next);
        if change.is_nan() {
            return Err(ResponseError::Drag { iterations, change, allowed: CONVERGED });
        }
        if change <= CONVERGED {
            return Ok(Some(RandomDrags { spreads: next, ..drags }));
        }
        drags.spreads = between(&drags.spreads, &next);
        if iterations < MOST_SETTLED {
            drags.at_rest.clone_from(&drags.spreads);
        }
        rest = at.rest;
    }
    Err(ResponseError::Drag { iterations: MOST_ITERATIONS, change, allowed: CONVERGED })
}

impl RandomSea {
    /// Checks that there is a variance, not negative, for each direction and frequency.
    fn check(&self) -> Result<(), ResponseError> {
        let WaveGrid { directions_rad, frequencies_rad_s } = &self.waves;
        super::check_directions(directions_rad)?;
        let allowed = || format!("{} numbers of at least 0 in each direction", frequencies_rad_s.len());
        let wrong = |found: f64| ResponseError::Wave { quantity: "variances_m2", found, allowed: allowed() };
        if self.variances_m2.len() != directions_rad.len() {
            return Err(wrong(self.variances_m2.len() as f64));
        }
        for row in &self.variances_m2 {
            if row.len() != frequencies_rad_s.len() {
                return Err(wrong(row.len() as f64));
            }
            if let Some(found) = row.iter().find(|variance| !(variance.is_finite() && **variance >= 0.0)) {
                return Err(wrong(*found));
            }
        }
        Ok(())
    }
}

/// Returns the covariances of the relative velocities in the response of a linearised system to a sea.
fn covariances(at: &AtRest, loads: &WaveLoads<'_>, sea: &RandomSea) -> Result<Vec<Vec<Symmetric3>>, ResponseError> {
    let (Some(water), Some(drags)) = (&at.water, &at.drags) else { return Ok(Vec::new()) };
    let shifted = Shifted::new(&at.linear.a);
    let WaveGrid { directions_rad, frequencies_rad_s } = &sea.waves;
    let mut sums = vec![Symmetric3::default(); drags.spreads.iter().map(Vec::len).sum()];
    for (k, &omega) in loads.frequencies(frequencies_rad_s)?.iter().enumerate() {
        let variances: Vec<f64> = sea.variances_m2.iter().map(|row| row[k]).collect();
        if variances.iter().all(|variance| *variance == 0.0) {
            continue;
        }
        let right = at.forcing(loads, omega, directions_rad);
        let states =
            shifted.solve(Complex::new(0.0, -omega), &right).ok_or(ResponseError::Resonance { found: omega })?;
        let relative = water.relative(&water.amplitudes(loads, omega, directions_rad), &states);
        add_covariances(&relative, &variances, &mut sums);
    }
    let mut all = sums.into_iter();
    Ok(drags.spreads.iter().map(|own| all.by_ref().take(own.len()).collect()).collect())
}

/// Adds the covariances of velocities, three of each node, in waves of these variances.
fn add_covariances(relative: &DMatrix<Complex<f64>>, variances: &[f64], sums: &mut [Symmetric3]) {
    for (wave, &variance) in variances.iter().enumerate() {
        for (node, sum) in sums.iter_mut().enumerate() {
            let [x, y, z] = [0, 1, 2].map(|axis| relative[(3 * node + axis, wave)]);
            let of = |a: Complex<f64>, b: Complex<f64>| variance * (a.re * b.re + a.im * b.im);
            *sum += Symmetric3 { xx: of(x, x), xy: of(x, y), xz: of(x, z), yy: of(y, y), yz: of(y, z), zz: of(z, z) };
        }
    }
}

/// Returns each node's sums of variances along three axes.
fn traces(spreads: &[Vec<Symmetric3>]) -> impl Iterator<Item = f64> {
    spreads.iter().flatten().map(|spread| spread.xx + spread.yy + spread.zz)
}

/// Returns the largest change of a variance, as a share; NaN if one is not a number.
fn largest_change(last: &[Vec<Symmetric3>], next: &[Vec<Symmetric3>]) -> f64 {
    let least = LEAST * traces(next).fold(f64::MIN_POSITIVE, f64::max);
    let changes = traces(last).zip(traces(next)).map(|(last, next)| (next - last).abs() / last.max(least));
    changes.fold(0.0, |most: f64, change| if change.is_nan() || change > most { change } else { most })
}

/// Returns the next covariances, with their size between those of the last and of the response to them.
fn between(last: &[Vec<Symmetric3>], next: &[Vec<Symmetric3>]) -> Vec<Vec<Symmetric3>> {
    let of = |(last, next): (&Symmetric3, &Symmetric3)| {
        let [before, after] = [last, next].map(|spread| spread.xx + spread.yy + spread.zz);
        let scale = if before > 0.0 && after > 0.0 { libm::pow(before / after, OF_LAST) } else { 1.0 };
        let Symmetric3 { xx, xy, xz, yy, yz, zz } = *next;
        let [xx, xy, xz, yy, yz, zz] = [xx, xy, xz, yy, yz, zz].map(|entry| entry * scale);
        Symmetric3 { xx, xy, xz, yy, yz, zz }
    };
    last.iter().zip(next).map(|(last, next)| last.iter().zip(next).map(of).collect()).collect()
}
