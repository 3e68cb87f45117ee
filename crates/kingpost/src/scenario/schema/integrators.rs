//! The schemes that step the state, and their settings.

use kingpost_derive::fields;

use crate::scenario::range::{Fraction, NonNegative, Positive};

/// The scheme that steps the state.
#[fields]
#[derive(Copy, Default, Eq)]
pub enum Integrator {
    /// Explicit Euler with the start-of-step angular velocity in Rodrigues' formula, as in the paper; order 1.
    ForwardEuler,
    /// Explicit Euler with the mean of the start-of-step and end-of-step angular velocity in Rodrigues' formula; order 1.
    MidpointEuler,
    /// Velocities first, then positions with the new velocities; order 1, without drift of the energy.
    SemiImplicitEuler,
    /// The classical Runge-Kutta scheme in Munthe-Kaas' form; order 4, on rotations too.
    #[default]
    Rk4,
    /// Dormand and Prince's pair of order 5(4) with error control and dense output: it chooses its steps by the
    /// tolerances; step_s only sets how often the state is output. See dormand_prince.
    DormandPrince,
    /// Newmark's method, implicit; order 2, stable at any step on linear oscillations. See newmark.
    Newmark,
    /// The generalized-alpha method, implicit; order 2, stable at any step on linear oscillations, with numerical damping
    /// of fast ones. See generalized_alpha.
    GeneralizedAlpha,
    /// The implicit midpoint rule; order 2, stable at any step on linear oscillations, without numerical damping.
    ImplicitMidpoint,
}

/// Tolerances of the dormand_prince integrator.
#[fields(default)]
#[derive(Copy)]
pub struct DormandPrinceSettings {
    /// Error that a step may make in each coordinate, rad or m, and in each rate, rad/s or m/s.
    pub absolute_tolerance: Positive,
    /// Added to it: error relative to the coordinate's motion in the step, and to the rate.
    pub relative_tolerance: NonNegative,
    /// Largest step that it takes, s.
    pub largest_step_s: Positive,
}

impl Default for DormandPrinceSettings {
    fn default() -> Self {
        Self {
            absolute_tolerance: Positive::literal(1e-8),
            relative_tolerance: NonNegative::literal(1e-6),
            largest_step_s: Positive::literal(0.1),
        }
    }
}

/// The weights of the newmark integrator. It is stable at any step where 2 beta >= gamma >= 1/2.
#[fields(default)]
#[derive(Copy)]
pub struct NewmarkSettings {
    /// Weight of the acceleration at the end of the step in the position, from 0 to 0.5.
    pub beta: Fraction,
    /// Weight of the acceleration at the end of the step in the velocity, from 0.5 to 1: above 0.5 it damps, and the order
    /// is 1.
    pub gamma: Fraction,
}

impl Default for NewmarkSettings {
    fn default() -> Self {
        Self { beta: Fraction::literal(0.25), gamma: Fraction::literal(0.5) }
    }
}

/// How much the generalized_alpha integrator damps.
#[fields(default)]
#[derive(Copy)]
pub struct GeneralizedAlphaSettings {
    /// Factor by which one step reduces oscillations much faster than the step: from 0, all removed, to 1, no damping.
    pub rho_infinity: Fraction,
}

impl Default for GeneralizedAlphaSettings {
    fn default() -> Self {
        Self { rho_infinity: Fraction::literal(0.8) }
    }
}
