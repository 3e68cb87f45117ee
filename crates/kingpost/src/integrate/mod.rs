//! Time stepping on the Lie group, one file a scheme.
//!
//! A scheme sees a [`System`] through vector-space local coordinates: positions move by `retract`,
//! and `dexp_inverse` turns a velocity into the rate of the local coordinates (Munthe-Kaas 1998).
//! So every scheme is written once and keeps its order on the rotation too. A new scheme is one
//! new file and one arm in each `match` of [`Scheme`].

mod forward_euler;
mod midpoint_euler;
mod runge_kutta;

pub use forward_euler::FORWARD_EULER;
pub use midpoint_euler::MidpointEuler;
pub use runge_kutta::{ExplicitRungeKutta, RUNGE_KUTTA_4, Tableau};

use crate::scalar::Scalar;
use crate::state::State;

/// An interval of time over which no law changes its form, s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Begin, s.
    pub start_s: f64,
    /// End, s.
    pub end_s: f64,
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
}

/// What a scheme integrates: `q' = v` on the group, `v' = f`, `s' = g`. Time is no scalar `S`: all
/// lanes of a scalar, and a number and its derivatives, step together.
pub trait System<S: Scalar = f64> {
    /// Lengths of the arrays.
    fn sizes(&self) -> Sizes;

    /// Writes v' and s' at a time of the interval; `state` holds the discrete states, and q, v, s
    /// are the stage's.
    fn rates(&mut self, at: Stage<'_, S>, v_dot: &mut [S], s_dot: &mut [S]);

    /// `out = q` moved by the local coordinates `xi`.
    fn retract(&self, q: &[S], xi: &[S], out: &mut [S]);

    /// `out = xi'` that the velocity `v` gives at `xi`.
    fn dexp_inverse(&self, xi: &[S], v: &[S], out: &mut [S]);

    /// Whether a coordinate of v is a body rate of a rotation in space.
    fn is_rotation_rate(&self, coordinate: usize) -> bool;
}

/// Where the right-hand side is evaluated.
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
    /// Discrete states, constant over a step.
    pub d: &'a [S],
}

/// The schemes.
#[derive(Clone, Debug)]
pub enum Scheme<S = f64> {
    /// Explicit Runge-Kutta in Munthe-Kaas' form: forward Euler and RK4.
    RungeKutta(ExplicitRungeKutta<S>),
    /// Forward Euler with the mean rate in the rotation.
    MidpointEuler(MidpointEuler<S>),
}

impl<S: Scalar> Scheme<S> {
    /// The paper's scheme: start-of-step rates everywhere, Rodrigues' formula for the rotation.
    pub fn forward_euler(sizes: Sizes) -> Self {
        Self::RungeKutta(ExplicitRungeKutta::new(&FORWARD_EULER, sizes))
    }

    /// Forward Euler whose rotation takes the mean of the old and the new angular velocity.
    pub fn midpoint_euler(sizes: Sizes) -> Self {
        Self::MidpointEuler(MidpointEuler::new(sizes))
    }

    /// The classical scheme of order 4.
    pub fn runge_kutta_4(sizes: Sizes) -> Self {
        Self::RungeKutta(ExplicitRungeKutta::new(&RUNGE_KUTTA_4, sizes))
    }

    /// Moves q, v and s of the state over an interval. Allocates nothing.
    pub fn step<Y: System<S>>(&mut self, system: &mut Y, interval: Interval, state: &mut State<S>) {
        match self {
            Self::RungeKutta(scheme) => scheme.step(system, interval, state),
            Self::MidpointEuler(scheme) => scheme.step(system, interval, state),
        }
    }
}

/// `sum += k b`, entry by entry.
fn accumulate<S: Scalar>(sum: &mut [S], k: f64, b: &[S]) {
    let k = S::constant(k);
    for (sum, b) in sum.iter_mut().zip(b) {
        *sum += k * *b;
    }
}
