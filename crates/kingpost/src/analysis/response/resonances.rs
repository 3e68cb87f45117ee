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

/// Largest number of iterations in the search for eigenvalues; it takes some three for each.
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

/// The widths of a peak at which it is looked at to either side, each 1.4 times the last.
const FIRST_WIDTH: f64 = 0.35;
const NEXT_WIDTH: f64 = 1.4;
/// The least width of a peak, as a share of its frequency: one of an undamped motion has none.
const LEAST_WIDTH: f64 = 1e-5;

/// A grid of frequencies with more of them about each resonance that is narrower than its steps: so close that what lies
/// between two is a curve that they show.
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
    // Relative: the eigenvalues of a pair of modes agree to some nine digits.
    all.dedup_by(|next, last| *next - *last <= 1e-9 * *next);
    all
}
