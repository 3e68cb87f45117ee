//! Where a response may have a narrow peak.

use nalgebra::linalg::{Schur, balancing::balance_parlett_reinsch};
use nalgebra::{Complex, DMatrix};
use serde::Serialize;

/// A natural frequency with its damping.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Resonance {
    /// Imaginary part of the eigenvalue, rad/s.
    pub frequency_rad_s: f64,
    /// Its real part, sign changed, 1/s: half the width of the peak at half its height squared.
    pub decay_per_s: f64,
}

/// Of the search for eigenvalues; it takes some three for each.
const MOST_ITERATIONS: usize = 20_000;

/// The oscillating eigenvalues of A; none where they are not found.
pub(super) fn resonances(a: &DMatrix<f64>) -> Vec<Resonance> {
    let mut balanced = a.clone();
    balance_parlett_reinsch(&mut balanced);
    let schur = Schur::try_new(balanced, f64::EPSILON, MOST_ITERATIONS);
    let values = schur.map(|schur| schur.complex_eigenvalues());
    let of = |value: &Complex<f64>| Resonance { frequency_rad_s: value.im, decay_per_s: -value.re };
    let mut found: Vec<Resonance> =
        values.iter().flat_map(|values| values.iter()).filter(|value| value.im > 0.0).map(of).collect();
    found.sort_by(|one, other| one.frequency_rad_s.total_cmp(&other.frequency_rad_s));
    found
}
