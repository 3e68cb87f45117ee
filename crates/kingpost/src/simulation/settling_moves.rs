//! Moves of the search for an equilibrium: Newton's method with pseudo-transient continuation (Kelley & Keyes, SIAM J.
//! Numer. Anal. 35, 1998).

use nalgebra::{DMatrix, DVector};

/// Accelerations below this count as 0, m/s^2 or rad/s^2: about 1e-11 of g, which displaces a pendulum of 1
/// km by 10 nm.
pub(super) const AT_REST: f64 = 1e-10;
/// If a move leaves more than this share of an acceleration, the rest is rounding error: near the solution a
/// move of Newton's method squares the error.
const STAGNANT: f64 = 0.5;
/// Smallest norm of A that counts, 1/s^2: for a body without restoring forces A is zero.
const SMALLEST_STIFFNESS: f64 = 1e-10;
/// Longest move of a coordinate in one iteration, m or rad.
const LONGEST_MOVE: f64 = 0.5;
/// Growth of the accelerations in one move that counts as a move into a stiff spring.
const HIT: f64 = 1e3;
/// Smallest growth factor of the pseudo-time step while accelerations fall.
const LEAST_GROWTH: f64 = 2.0;
/// Smallest stiffness that is kept against drift along zero modes, as a share of the largest entry of A.
pub(super) const SMALLEST_SHARE: f64 = 1e-9;

/// The linear system of an iteration.
pub(super) struct Linear {
    pub acceleration: DVector<f64>,
    pub stiffness: DMatrix<f64>,
}

/// The pseudo-time step of a move, the accelerations at its start, its longest allowed entry, and whether that entry was
/// reached.
#[derive(Clone, Copy)]
pub(super) struct LastMove {
    delta: f64,
    acceleration: f64,
    limit: f64,
    is_limited: bool,
}

impl LastMove {
    /// Returns the state after a transfer of the holding forces: the accelerations are no measure for the next move.
    pub fn anew(delta: f64) -> Self {
        Self { delta, acceleration: f64::MAX, limit: LONGEST_MOVE, is_limited: false }
    }

    /// Returns the longest move of a coordinate after this one, m or rad. A move of full length into a stiff spring is
    /// halved next time: a rope that rounding makes slack would fall into its spring again and again.
    fn next_limit(self, acceleration: f64) -> f64 {
        let hits = self.is_limited && acceleration > HIT * self.acceleration;
        if hits { 0.5 * self.limit } else { self.limit }
    }
}

/// Returns the next move of the free coordinates, tangent to the loops' J; `None` if the linear system has no
/// solution.
pub(super) fn next_move(linear: &Linear, j: &DMatrix<f64>, last: Option<LastMove>) -> Option<(DVector<f64>, LastMove)> {
    let (acceleration, norm) = (&linear.acceleration, linear.acceleration.norm());
    // Larger than the largest stiffness, so that the move also goes downhill along an unstable direction.
    let grown = last.map_or(0.5 / linear.size(), |last| last.delta * growth(last.acceleration / norm));
    let delta = grown.min(linear.largest_delta());
    let right = acceleration.clone().resize_vertically(acceleration.len() + j.nrows(), 0.0);
    let xi = linear.bordered(j, delta).lu().solve(&right)?.rows(0, acceleration.len()).into_owned();
    let (longest, limit) = (xi.amax(), last.map_or(LONGEST_MOVE, |last| last.next_limit(norm)));
    let is_limited = longest > limit;
    let xi = if is_limited { xi * (limit / longest) } else { xi };
    longest.is_finite().then_some((xi, LastMove { delta, acceleration: norm, limit, is_limited }))
}

impl Linear {
    pub fn size(&self) -> f64 {
        self.stiffness.norm().max(SMALLEST_STIFFNESS)
    }

    /// Returns whether each acceleration is 0, or a rounding error that the last move could not reduce.
    pub fn rests(&self, allowed: &DVector<f64>, last: Option<LastMove>) -> bool {
        if self.acceleration.iter().all(|a| a.abs() < AT_REST) {
            return true;
        }
        let is_rounding = self.acceleration.iter().zip(allowed).all(|(a, allowed)| a.abs() < *allowed);
        is_rounding && last.is_some_and(|last| self.acceleration.norm() > STAGNANT * last.acceleration)
    }

    pub fn largest_delta(&self) -> f64 {
        1.0 / (SMALLEST_SHARE * self.size())
    }

    /// Returns `1/delta - A`, bordered by the loops' J.
    pub fn bordered(&self, j: &DMatrix<f64>, delta: f64) -> DMatrix<f64> {
        let (n, constraints) = (self.acceleration.len(), j.nrows());
        let mut bordered = DMatrix::zeros(n + constraints, n + constraints);
        bordered.view_mut((0, 0), (n, n)).copy_from(&(DMatrix::identity(n, n) / delta - &self.stiffness));
        bordered.view_mut((0, n), (n, constraints)).copy_from(&j.transpose());
        bordered.view_mut((n, 0), (constraints, n)).copy_from(j);
        bordered
    }
}

/// Returns the growth factor of the pseudo-time step if the accelerations have fallen by `fallen_by`, or its
/// reduction if they have risen. Stiff parts reach rest long before soft parts begin to move: meanwhile the
/// step has to grow.
fn growth(fallen_by: f64) -> f64 {
    if fallen_by < 1.0 { fallen_by } else { fallen_by.max(LEAST_GROWTH) }
}
