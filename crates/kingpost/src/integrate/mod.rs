//! Time stepping on the Lie group, one file a scheme.
//!
//! A scheme sees a [`System`] through vector-space local coordinates: positions move by `retract`,
//! and `dexp_inverse` turns a velocity into the rate of the local coordinates (Munthe-Kaas 1998).
//! So every scheme is written once and keeps its order on the rotation too. The implicit schemes
//! share one Newton iteration, whose derivatives the system gives ([`System::jacobian`]). A new
//! scheme is one new file and one arm in each `match` of [`Scheme`].

mod dormand_prince;
mod error;
mod forward_euler;
mod generalized_alpha;
mod implicit_midpoint;
mod jacobian;
mod linear;
mod midpoint_euler;
mod newmark;
mod newton;
mod runge_kutta;
mod scheme;
mod semi_implicit_euler;

pub use dormand_prince::{DormandPrince, Tolerances};
pub use error::StepError;
pub(crate) use error::shown;
pub use forward_euler::FORWARD_EULER;
pub use generalized_alpha::GeneralizedAlpha;
pub use implicit_midpoint::ImplicitMidpoint;
pub use jacobian::Jacobian;
pub use midpoint_euler::MidpointEuler;
pub use newmark::Newmark;
pub use runge_kutta::{ExplicitRungeKutta, RUNGE_KUTTA_4, Tableau};
pub use scheme::Scheme;
pub use semi_implicit_euler::SemiImplicitEuler;

use crate::scalar::Scalar;
use core::cell::Cell;

/// An interval of time over which no law changes its form, s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Begin, s.
    pub start_s: f64,
    /// End, s.
    pub end_s: f64,
}

impl Interval {
    /// Its middle, s.
    pub fn middle_s(self) -> f64 {
        0.5 * (self.start_s + self.end_s)
    }
}

/// Sizes of the arrays that a scheme works on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sizes {
    /// Length of q.
    pub positions: usize,
    /// Length of v.
    pub velocities: usize,
    /// Length of s.
    pub extras: usize,
    /// Number of the first entries of s, on which no rate depends: integrals that are carried along.
    pub passive: usize,
}

impl Sizes {
    /// Number of the last entries of s, on which rates depend.
    pub fn active(self) -> usize {
        self.extras - self.passive
    }
}

/// The system that a scheme integrates: `q' = v` on the group, `v' = f`, `s' = g`. Time is a plain number: all lanes,
/// and a number and its derivatives, step together.
pub trait System<S: Scalar = f64> {
    /// Lengths of the arrays.
    fn sizes(&self) -> Sizes;

    /// Writes v' and s' at a time of the interval; `state` holds the discrete states, and q, v, s
    /// are the stage's.
    fn rates(&mut self, at: Stage<'_, S>, v_dot: &mut [S], s_dot: &mut [S]);

    /// Marks the evaluations since the last call as part of the step, whatever trials follow.
    fn accept(&mut self) {}

    /// Marks the evaluations since then as a rejected trial.
    fn reject(&mut self) {}

    /// Projects q and v back onto the constraints; returns whether there are any. The same q and v, under loads that do
    /// not change the inertia, give the same bits.
    fn close(&mut self, _q: &mut [S], _v: &mut [S]) -> bool {
        false
    }

    /// `out = q` moved by the local coordinates `xi`.
    fn retract(&self, q: &[S], xi: &[S], out: &mut [S]);

    /// `out = xi'` that the velocity `v` gives at `xi`.
    fn dexp_inverse(&self, xi: &[S], v: &[S], out: &mut [S]);

    /// Whether a coordinate of v is a body rate of a rotation in space. Such coordinates come in
    /// threes: x, y, z of one rotation, one after another.
    fn is_rotation_rate(&self, coordinate: usize) -> bool;

    /// Whether the acceleration of a coordinate follows from the state. It does not if the coordinate is held or
    /// prescribed over time.
    fn is_free(&self, _coordinate: usize) -> bool {
        true
    }

    /// Writes the derivatives of v' and of the active s' by xi, v and the active s at a stage with `q = retract(base,
    /// xi)`, its time and its d. The columns of coordinates that are not free may stay zero.
    ///
    /// This default takes differences, which cost one evaluation per column; a system that can carry derivatives
    /// through its equations gives exact columns instead.
    fn jacobian(&mut self, base: &[S], xi: &[S], at: Stage<'_, S>, out: &mut Jacobian<S>)
    where
        Self: Sized,
    {
        out.by_differences(self, base, xi, at);
    }
}

/// The point at which the right-hand side is evaluated.
#[derive(Clone, Copy, Debug)]
pub struct Stage<'a, S = f64> {
    /// Time, s.
    pub time_s: f64,
    /// The interval being stepped.
    pub interval: Interval,
    /// Positions.
    pub q: &'a [S],
    /// Velocities.
    pub v: &'a [S],
    /// Extra states.
    pub s: &'a [S],
    /// Discrete numbers, constant over a step.
    pub d: &'a [S],
    /// Modes, constant over a step.
    pub m: &'a [i64],
}

/// `sum += k b`, entry by entry.
fn accumulate<S: Scalar>(sum: &mut [S], k: f64, b: &[S]) {
    let k = S::constant(k);
    for (sum, b) in sum.iter_mut().zip(b) {
        *sum += k * *b;
    }
}

/// The largest absolute value of an entry, over all lanes; NaN if an entry is NaN.
fn largest<S: Scalar>(values: &[S]) -> f64 {
    let largest = Cell::new(0.0_f64);
    let keep = |x: f64| {
        if x.is_nan() || x.abs() > largest.get() {
            largest.set(x.abs());
        }
        true
    };
    values.iter().for_each(|x| {
        x.all(keep);
    });
    largest.get()
}
