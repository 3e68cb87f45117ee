//! Resonances: frequencies at which a response can have a narrow peak.

use nalgebra::linalg::{Schur, balancing::balance_parlett_reinsch};
use nalgebra::{Complex, DMatrix};
use serde::Serialize;

/// A natural frequency and the damping of its mode.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Resonance {
    /// Imaginary part of the eigenvalue, rad/s.
    pub frequency_rad_s: f64,
    /// Negative real part of the eigenvalue, 1/s: half the width of the peak at half the square of its
    /// height.
    pub decay_per_s: f64,
}

/// Largest number of iterations in the search for eigenvalues; each eigenvalue takes about three.
const MOST_ITERATIONS: usize = 20_000;

/// Returns the oscillating eigenvalues of A; empty if they are not found.
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

/// Distance of the first added frequency from a peak, in widths of the peak; each further distance is longer
/// by the factor `NEXT_WIDTH`.
const FIRST_WIDTH: f64 = 0.35;
const NEXT_WIDTH: f64 = 1.4;
/// Smallest width of a peak, as a share of its frequency: the peak of an undamped motion has zero width.
const LEAST_WIDTH: f64 = 1e-5;

/// Returns a grid of frequencies with more points about each resonance that is narrower than the grid's
/// steps, so close that they resolve the peak.
pub(super) fn resolved(grid: &[f64], resonances: &[Resonance]) -> Vec<f64> {
    let (Some(lowest), Some(highest)) = (grid.first(), grid.last()) else { return Vec::new() };
    let mut all = grid.to_vec();
    for resonance in resonances {
        let centre = resonance.frequency_rad_s;
        let after = grid.partition_point(|omega| *omega < centre).clamp(1, grid.len().max(2) - 1);
        let Some(step) = grid.get(after).map(|next| next - grid[after - 1]) else { continue };
        let mut off = FIRST_WIDTH * resonance.decay_per_s.abs().max(LEAST_WIDTH * centre);
        if off < step {
            all.push(centre);
        }
        while off < step {
            all.extend([centre - off, centre + off]);
            off *= NEXT_WIDTH;
        }
    }
    all.retain(|omega| (*lowest..=*highest).contains(omega));
    all.sort_by(f64::total_cmp);
    // Relative tolerance: the eigenvalues of a pair of modes agree to about nine digits.
    all.dedup_by(|next, last| *next - *last <= 1e-9 * *next);
    all
}
