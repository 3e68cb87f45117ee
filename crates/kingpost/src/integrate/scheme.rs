//! Integration schemes by name.

use super::{
    DormandPrince, ExplicitRungeKutta, FORWARD_EULER, GeneralizedAlpha, ImplicitMidpoint, Interval, MidpointEuler,
    Newmark, RUNGE_KUTTA_4, SemiImplicitEuler, Sizes, StepError, System, Tolerances,
};
use crate::scalar::Scalar;
use crate::state::State;

/// An integration scheme.
#[derive(Clone, Debug)]
pub enum Scheme<S = f64> {
    /// Explicit Runge-Kutta in Munthe-Kaas' form: forward Euler and RK4.
    RungeKutta(ExplicitRungeKutta<S>),
    /// Forward Euler with the mean rate in the rotation.
    MidpointEuler(MidpointEuler<S>),
    /// Semi-implicit Euler: velocities first, then positions.
    SemiImplicitEuler(SemiImplicitEuler<S>),
    /// Dormand-Prince: order 5 with error control.
    DormandPrince(DormandPrince<S>),
    /// Newmark's method.
    Newmark(Newmark<S>),
    /// Newmark's rule with numerical damping of fast oscillations.
    GeneralizedAlpha(GeneralizedAlpha<S>),
    /// The implicit midpoint rule.
    ImplicitMidpoint(ImplicitMidpoint<S>),
}

impl<S: Scalar> Scheme<S> {
    /// Returns the paper's scheme: rates at the start of the step everywhere, Rodrigues' formula for the
    /// rotation.
    pub fn forward_euler(sizes: Sizes) -> Self {
        Self::RungeKutta(ExplicitRungeKutta::new(&FORWARD_EULER, sizes))
    }

    /// Returns forward Euler with the mean of the old and the new angular velocity for the rotation.
    pub fn midpoint_euler(sizes: Sizes) -> Self {
        Self::MidpointEuler(MidpointEuler::new(sizes))
    }

    /// Returns semi-implicit Euler: see [`SemiImplicitEuler`].
    pub fn semi_implicit_euler(sizes: Sizes) -> Self {
        Self::SemiImplicitEuler(SemiImplicitEuler::new(sizes))
    }

    /// Returns the classical scheme of order 4.
    pub fn runge_kutta_4(sizes: Sizes) -> Self {
        Self::RungeKutta(ExplicitRungeKutta::new(&RUNGE_KUTTA_4, sizes))
    }

    /// Returns the scheme of order 5 with error control: see [`DormandPrince`].
    pub fn dormand_prince(sizes: Sizes, tolerances: Tolerances, step_s: f64) -> Self {
        Self::DormandPrince(DormandPrince::new(sizes, tolerances, step_s))
    }

    /// See [`Newmark`].
    pub fn newmark(sizes: Sizes, beta: f64, gamma: f64) -> Self {
        Self::Newmark(Newmark::new(sizes, beta, gamma))
    }

    /// See [`GeneralizedAlpha`].
    pub fn generalized_alpha(sizes: Sizes, rho_infinity: f64) -> Self {
        Self::GeneralizedAlpha(GeneralizedAlpha::new(sizes, rho_infinity))
    }

    /// See [`ImplicitMidpoint`].
    pub fn implicit_midpoint(sizes: Sizes) -> Self {
        Self::ImplicitMidpoint(ImplicitMidpoint::new(sizes))
    }

    /// Returns the number of entries in the state's memory for this scheme, all zero at first, with
    /// `discrete` discrete numbers and modes.
    pub fn memory_len(&self, discrete: usize) -> usize {
        match self {
            Self::DormandPrince(scheme) => scheme.memory_len(discrete),
            Self::Newmark(scheme) => scheme.memory_len(),
            Self::GeneralizedAlpha(scheme) => scheme.memory_len(),
            Self::ImplicitMidpoint(scheme) => scheme.memory_len(),
            _ => 0,
        }
    }

    /// Moves q, v and s of a state back to a time within its last step, if the scheme has dense output;
    /// returns whether it has.
    pub fn interpolate<Y: System<S>>(&mut self, system: &Y, time_s: f64, state: &mut State<S>) -> bool {
        match self {
            Self::DormandPrince(scheme) => scheme.interpolate(system, time_s, state),
            _ => false,
        }
    }

    /// Moves q, v and s of the state over an interval. Allocates nothing. `edge_s` is the next time at which
    /// a law changes form, at the end of the interval or later, s; infinity if there is none. On an error the
    /// state is undefined.
    pub fn step<Y: System<S>>(
        &mut self,
        system: &mut Y,
        interval: Interval,
        edge_s: f64,
        state: &mut State<S>,
    ) -> Result<(), StepError> {
        match self {
            Self::RungeKutta(scheme) => return scheme.step(system, interval, state),
            Self::MidpointEuler(scheme) => scheme.step(system, interval, state),
            Self::SemiImplicitEuler(scheme) => scheme.step(system, interval, state),
            Self::DormandPrince(scheme) => return scheme.step(system, interval, edge_s, state),
            Self::Newmark(scheme) => return scheme.step(system, interval, state),
            Self::GeneralizedAlpha(scheme) => return scheme.step(system, interval, state),
            Self::ImplicitMidpoint(scheme) => return scheme.step(system, interval, state),
        }
        Ok(())
    }
}
