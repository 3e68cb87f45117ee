//! Natural oscillations of a model about its equilibrium.

use super::shifted::Shifted;
use crate::simulation::{NoEquilibrium, Simulation};
use core::f64::consts::TAU;
use nalgebra::linalg::balancing::balance_parlett_reinsch;
use nalgebra::{Complex, DMatrix, DVector, Schur};
use serde::Serialize;
use thiserror::Error;

/// An oscillation `exp(-zeta w t) cos(w_d t)` of small motions of bodies; modes of filters alone, or of the
/// water's memory alone, do not count.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct NaturalMode {
    /// The coordinate with the largest share of the kinetic energy, each coordinate considered alone.
    pub coordinate: String,
    /// Time between two maxima, 2 pi / w_d, s.
    pub period_s: f64,
    /// zeta; the oscillation grows if it is negative.
    pub damping_ratio: f64,
}

/// Reason why there are no modes.
#[derive(Clone, Debug, Error)]
pub enum ModesError {
    /// There is no equilibrium nearby.
    #[error(transparent)]
    Settle(#[from] NoEquilibrium),
    /// The eigenvalues do not converge.
    #[error("modes: found no eigenvalues in {MOST_ITERATIONS} iterations, allowed: rates of comparable size")]
    NoEigenvalues,
}

/// Largest number of iterations in the search for eigenvalues; each eigenvalue takes about three.
const MOST_ITERATIONS: usize = 20_000;
/// Longest period of an oscillation, s; a longer one counts as drift.
const LONGEST_PERIOD_S: f64 = 1e4;
/// Smallest participation of coordinates and their rates for which a mode counts as one of bodies.
const LEAST_SHARE: f64 = 0.5;
/// Shift from the eigenvalue in the inverse iteration, as a share of the eigenvalue's modulus.
const BESIDE: f64 = 1e-9;

/// The oscillations about the equilibrium nearest to the state of a simulation, the longest period first.
///
/// The eigenvalues of A of [`Simulation::small_motions`], of which the modes of bodies are those where coordinates and
/// their rates have half or more of the participation factors l_k x_k / l x, with the left and right eigenvector l and
/// x (Perez-Arriaga, Verghese & Schweppe, *IEEE Trans. PAS* 101(9), 1982). The Python package's `modes` gives all
/// modes, with their shapes.
///
/// ```
/// // A pendulum of 2 m: 2 pi sqrt(L / g).
/// let text = "version: 1\ntitle: Pendulum\nsimulation: {step_s: 0.01, duration_s: 1}\nbodies:\n  bob: {mass_kg: 3, shape: \
///     {point: {}}, joint: {revolute: {axis: [0, 1, 0], child_position_m: [0, 0, 2]}}}\nforces: {gravity: {gravity: {}}}\n";
/// let scenario = kingpost::scenario::read(text, "pendulum.yaml", &[])?;
/// let modes = kingpost::analysis::natural_modes(&scenario.simulation()?).expect("it hangs");
/// let period_s = std::f64::consts::TAU * (2.0_f64 / 9.80665).sqrt();
/// assert!((modes[0].period_s / period_s - 1.0).abs() < 1e-9 && modes[0].damping_ratio.abs() < 1e-9);
/// # Ok::<(), kingpost::scenario::ScenarioError>(())
/// ```
///
/// # Errors
/// No equilibrium nearby, or rates of such different magnitudes that no eigenvalues are found.
pub fn natural_modes(simulation: &Simulation) -> Result<Vec<NaturalMode>, ModesError> {
    let mut settled = simulation.clone();
    settled.settle()?;
    let coordinates = settled.coordinates();
    // Diagonal entries of the matrix.
    let masses: Vec<f64> = settled.mass_matrix().into_iter().step_by(coordinates.len() + 1).collect();
    of_system(&coordinates, &masses, settled.small_motions())
}

fn of_system(coordinates: &[String], masses: &[f64], mut a: DMatrix<f64>) -> Result<Vec<NaturalMode>, ModesError> {
    if masses.is_empty() {
        return Ok(Vec::new());
    }
    // Balances A: scales the states so that its rows and columns have equal size.
    let units = balance_parlett_reinsch(&mut a);
    let schur = Schur::try_new(a.clone(), f64::EPSILON, MOST_ITERATIONS).ok_or(ModesError::NoEigenvalues)?;
    let slowest = TAU / LONGEST_PERIOD_S;
    let values = schur.complex_eigenvalues();
    let both = [Shifted::new(&a), Shifted::new(&a.transpose())];
    let mut modes: Vec<NaturalMode> = values
        .iter()
        .filter(|value| value.im > slowest)
        .filter_map(|&value| mode(coordinates, masses, &both, &units, value))
        .collect();
    modes.sort_by(|one, other| other.period_s.total_cmp(&one.period_s));
    Ok(modes)
}

/// Returns the mode of an eigenvalue; `None` if the participation of bodies is small.
fn mode(
    coordinates: &[String],
    masses: &[f64],
    [a, transposed]: &[Shifted; 2],
    units: &DVector<f64>,
    value: Complex<f64>,
) -> Option<NaturalMode> {
    let (right, left) = (vector(a, units.len(), value)?, vector(transposed, units.len(), value)?);
    let parts: Vec<Complex<f64>> = left.iter().zip(&right).map(|(l, x)| l * x).collect();
    let whole: Complex<f64> = parts.iter().sum();
    let of_bodies: f64 = parts[..2 * masses.len()].iter().map(|part| (part / whole).re).sum();
    if of_bodies.is_nan() || of_bodies < LEAST_SHARE {
        return None;
    }
    let energy = |i: usize| masses[i] * (right[i] * units[i]).norm_sqr();
    let largest = (0..masses.len()).max_by(|&i, &j| energy(i).total_cmp(&energy(j)))?;
    Some(NaturalMode {
        coordinate: coordinates[largest].clone(),
        period_s: TAU / value.im,
        damping_ratio: -value.re / size(value),
    })
}

fn size(value: Complex<f64>) -> f64 {
    libm::hypot(value.re, value.im)
}

/// Returns the eigenvector of an eigenvalue, by inverse iteration with a shift.
fn vector(a: &Shifted, n: usize, value: Complex<f64>) -> Option<DVector<Complex<f64>>> {
    let beside = value * (1.0 + BESIDE);
    // All entries differ, so that the start is not orthogonal to an eigenvector.
    let mut found = DMatrix::from_fn(n, 1, |i, _| Complex::new(1.0 + 0.1 * (i % 7) as f64, 0.3));
    for _ in 0..2 {
        found = a.solve(beside, &found)?;
        let size = found.norm();
        found.unscale_mut(size);
    }
    found.iter().all(|x| x.re.is_finite() && x.im.is_finite()).then(|| found.column(0).into_owned())
}
