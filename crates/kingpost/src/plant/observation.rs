//! Observation of a plant at a state.

use super::Plant;
use super::element_contexts::ElementContexts;
use crate::dynamics::Kinematics;
use crate::dynamics::inverse::InverseDynamics;
use crate::dynamics::loops::LoopSolver;
use crate::integrate::Stage;
use crate::model::Model;
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// The part of a plant that is observed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum ObservedPart {
    /// Positions and velocities of the bodies, and the outputs of these elements.
    MotionAnd(Vec<usize>),
    /// Everything.
    #[default]
    Everything,
}

/// Borrowed results of [`Plant::observe`](super::Plant::observe). Parts outside its [`ObservedPart`] belong to another
/// state.
pub struct Observation<'a, S = f64> {
    /// The model.
    pub model: &'a Model<S>,
    /// Kinematics of `model.tree`.
    pub bodies: &'a Kinematics<S>,
    /// Accelerations and joint wrenches of the bodies.
    pub inverse: &'a InverseDynamics<S>,
    /// Constraints of the closed loops, and their forces.
    pub loops: &'a LoopSolver<S>,
    /// The outputs of the observed elements, one after another.
    pub outputs: &'a [S],
    /// Energy and momentum.
    pub totals: Totals<S>,
}

/// Energy and momentum of all bodies.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Totals<S = f64> {
    /// Kinetic energy with that of the added mass, J.
    pub kinetic_energy: S,
    /// Potential energy, J.
    pub potential_energy: S,
    /// Linear momentum, kg m/s, world.
    pub linear_momentum: Vector3<S>,
    /// Angular momentum, N m s, about [`ledger::reference_point`](crate::ledger::reference_point), world.
    pub angular_momentum: Vector3<S>,
}

impl<S: Scalar> Plant<S> {
    /// Appends the points of the elements' lines at a stage, x, y and z (m, world) of each.
    pub fn draw(&mut self, at: Stage<'_, S>, points: &mut Vec<S>) {
        self.links.update(&self.model, at.q, at.v);
        let Self { model, world, links, elements, layout, evaluation, .. } = self;
        let mut contexts = ElementContexts::new(layout, world, model, links, *evaluation, at);
        for (i, element) in elements.iter_mut().enumerate() {
            element.draw(contexts.of(i), points);
        }
    }
}
