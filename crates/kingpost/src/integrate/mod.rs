//! Time stepping on the Lie group, with one file for each scheme.
//!
//! A scheme uses a [`System`] in local coordinates, which form a vector space: positions move by `retract`,
//! and `dexp_inverse` turns a velocity into the rate of the local coordinates (Munthe-Kaas 1998). So every
//! scheme is written once and has its order also for rotations. The implicit schemes share one Newton
//! iteration, with derivatives from the system ([`System::jacobian`]). A new scheme needs one new file and
//! one arm in each `match` of [`Scheme`].

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
    /// Start, s.
    pub start_s: f64,
    /// End, s.
    pub end_s: f64,
}

impl Interval {
    /// Returns the middle of the interval, s.
    pub fn middle_s(self) -> f64 {
        0.5 * (self.start_s + self.end_s)
    }
}

/// Sizes of the arrays of a scheme.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sizes {
    /// Length of q.
    pub positions: usize,
    /// Length of v.
    pub velocities: usize,
    /// Length of s.
    pub extras: usize,
    /// Number of passive entries at the start of s: no rate depends on these integrals.
    pub passive: usize,
}

impl Sizes {
    /// Returns the number of active entries at the end of s: rates depend on them.
    pub fn active(self) -> usize {
        self.extras - self.passive
    }
}

/// The system that a scheme integrates: `q' = v` on the group, `v' = f`, `s' = g`. Time is a plain number:
/// all lanes, and a number and its derivatives, have the same steps.
pub trait System<S: Scalar = f64> {
    /// Lengths of the arrays.
    fn sizes(&self) -> Sizes;

    /// Writes v' and s' at a time of the interval; `state` contains the discrete states, and q, v, s are
    /// those of the stage.
    fn rates(&mut self, at: Stage<'_, S>, v_dot: &mut [S], s_dot: &mut [S]);

    /// Marks the evaluations since the last call as part of the step; later trials do not change this.
    fn accept(&mut self) {}

    /// Marks the evaluations since the last call of [`accept`](Self::accept) or of this function as a
    /// rejected trial.
    fn reject(&mut self) {}

    /// Returns the entries of s that are motions: a scheme with error control resolves them like v.
    fn motions(&self) -> &[usize] {
        &[]
    }

    /// Begins a step of an explicit Runge-Kutta scheme with a fixed step at its base.
    fn begin_stages(&mut self, _base: Stage<'_, S>) {}

    /// Replaces states in s that the system advances itself by their values at a stage, whose q and v are given with its
    /// time; `is_end` marks the end of the step.
    ///
    /// # Errors
    /// The system cannot advance them.
    fn advance(&mut self, _at: Stage<'_, S>, _s: &mut [S], _is_end: bool) -> Result<(), StepError> {
        Ok(())
    }

    /// Projects q and v onto the constraints; returns whether there are any. Under loads that do not change
    /// the inertia, equal q and v give bitwise identical results.
    fn close(&mut self, _q: &mut [S], _v: &mut [S]) -> bool {
        false
    }

    /// `out = q` moved by the local coordinates `xi`.
    fn retract(&self, q: &[S], xi: &[S], out: &mut [S]);

    /// Computes `out = xi'`, the rate of the local coordinates at `xi` for the velocity `v`.
    fn dexp_inverse(&self, xi: &[S], v: &[S], out: &mut [S]);

    /// Returns whether a coordinate of v is a body rate of a rotation in space. Such coordinates are in
    /// groups of three: x, y, z of one rotation.
    fn is_rotation_rate(&self, coordinate: usize) -> bool;

    /// Returns whether the acceleration of a coordinate follows from the state: not if the coordinate is held
    /// or prescribed over time.
    fn is_free(&self, _coordinate: usize) -> bool {
        true
    }

    /// Writes the derivatives of v' and of the active s' with respect to xi, v and the active s, at a stage
    /// with `q = retract(base, xi)`, its time and its d. The columns of coordinates that are not free can be
    /// zero.
    ///
    /// This default uses differences, which cost one evaluation per column; a system whose equations can
    /// carry derivatives returns exact columns instead.
    fn jacobian(&mut self, base: &[S], xi: &[S], at: Stage<'_, S>, out: &mut Jacobian<S>)
    where
        Self: Sized,
    {
        out.by_differences(self, base, xi, at);
    }
}

/// Point at which the right-hand side is evaluated.
#[derive(Clone, Copy, Debug)]
pub struct Stage<'a, S = f64> {
    /// Time, s.
    pub time_s: f64,
    /// Interval of the present step.
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

/// Returns the largest absolute value of an entry, over all lanes; NaN if an entry is NaN.
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
