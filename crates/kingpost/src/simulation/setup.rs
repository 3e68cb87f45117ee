//! The setup of a simulation.

use super::Limit;
use crate::elements::{AnyElement, AnyWatcher};
use crate::integrate::{Scheme, Sizes, Tolerances};
use crate::model::Model;
use crate::plant::Form;
use crate::scalar::Scalar;
use crate::world::World;

/// The integration schemes by name, with their settings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SchemeName {
    /// See [`Scheme::forward_euler`].
    ForwardEuler,
    /// See [`Scheme::midpoint_euler`].
    MidpointEuler,
    /// See [`Scheme::semi_implicit_euler`].
    SemiImplicitEuler,
    /// See [`Scheme::runge_kutta_4`].
    RungeKutta4,
    /// See [`Scheme::dormand_prince`].
    DormandPrince(Tolerances),
    /// See [`Scheme::newmark`].
    Newmark {
        /// Weight of the acceleration at the end in the position.
        beta: f64,
        /// Weight of the acceleration at the end in the velocity.
        gamma: f64,
    },
    /// See [`Scheme::generalized_alpha`].
    GeneralizedAlpha {
        /// Spectral radius at infinite frequency: factor by which a step reduces the fastest oscillations.
        rho_infinity: f64,
    },
    /// See [`Scheme::implicit_midpoint`].
    ImplicitMidpoint,
}

/// Time stepping and recording.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// The scheme.
    pub scheme: SchemeName,
    /// Step, s.
    pub step_s: f64,
    /// Length of a run, s.
    pub duration_s: f64,
    /// Interval between recorded rows, s.
    pub record_every_s: f64,
    /// Largest rate, rad/s or m/s; a run beyond it counts as diverged.
    pub rate_limit: f64,
    /// The form of the equations of motion.
    pub form: Form,
}

impl Settings {
    /// Whether its steps take exact derivatives, from a setup over dual numbers. In the browser they are finite differences:
    /// the engine over dual numbers would double the download. Newton's iteration ends within its tolerance either way.
    #[cfg(not(target_family = "wasm"))]
    pub(crate) fn wants_derivatives(&self) -> bool {
        self.scheme.is_implicit() && self.form == Form::Recursive
    }

    /// Returns the number of rows that a run records, without those at the start and the end.
    pub fn rows(&self) -> f64 {
        self.duration_s / self.record_every_s.max(self.step_s)
    }
}

/// Everything that a simulation consists of.
#[derive(Clone, Debug)]
pub struct Setup<S: Scalar = f64> {
    /// The mechanical model.
    pub model: Model<S>,
    /// The world outside the model.
    pub world: World<S>,
    /// The elements.
    pub elements: Vec<AnyElement<S>>,
    /// Inputs that are connected to the sampled output of an element, each with the column of that output; in
    /// addition to those that elements declare.
    pub wires: Vec<(String, String)>,
    /// Watchers of the model's joints and closed loops; elements have watchers in addition.
    pub watchers: Vec<AnyWatcher>,
    /// Limits on columns of the results.
    pub limits: Vec<Limit>,
    /// Time stepping and recording.
    pub settings: Settings,
    /// Initial positions.
    pub q: Vec<S>,
    /// Initial velocities.
    pub v: Vec<S>,
    /// A digest that is equal only for setups of the same scenario; snapshots contain it. 0 for a setup that is built
    /// by hand.
    pub fingerprint: u64,
}

impl SchemeName {
    /// Returns whether the scheme is implicit, and so needs derivatives.
    pub fn is_implicit(self) -> bool {
        matches!(self, Self::Newmark { .. } | Self::GeneralizedAlpha { .. } | Self::ImplicitMidpoint)
    }

    /// Creates the scheme with its working memory, for this size of step.
    pub fn scheme<S: Scalar>(self, sizes: Sizes, step_s: f64) -> Scheme<S> {
        match self {
            Self::ForwardEuler => Scheme::forward_euler(sizes),
            Self::MidpointEuler => Scheme::midpoint_euler(sizes),
            Self::SemiImplicitEuler => Scheme::semi_implicit_euler(sizes),
            Self::RungeKutta4 => Scheme::runge_kutta_4(sizes),
            Self::DormandPrince(tolerances) => Scheme::dormand_prince(sizes, tolerances, step_s),
            Self::Newmark { beta, gamma } => Scheme::newmark(sizes, beta, gamma),
            Self::GeneralizedAlpha { rho_infinity } => Scheme::generalized_alpha(sizes, rho_infinity),
            Self::ImplicitMidpoint => Scheme::implicit_midpoint(sizes),
        }
    }
}
