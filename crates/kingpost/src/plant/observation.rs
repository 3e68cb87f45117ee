//! What there is to see of a plant at a state.

use crate::dynamics::Kinematics;
use crate::dynamics::inverse::InverseDynamics;
use crate::dynamics::loops::LoopSolver;
use crate::model::Model;
use crate::spatial::Vector3;

/// How much of a plant is observed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum ObservedPart {
    /// Positions and velocities of the bodies, and what these elements show.
    MotionAnd(Vec<usize>),
    /// Everything.
    #[default]
    Everything,
}

/// Borrowed results of [`Plant::observe`](super::Plant::observe). What its [`ObservedPart`] leaves out is of another state.
pub struct Observation<'a, S = f64> {
    /// The model.
    pub model: &'a Model<S>,
    /// Kinematics of `model.tree`.
    pub bodies: &'a Kinematics<S>,
    /// Accelerations and joint wrenches of the bodies.
    pub inverse: &'a InverseDynamics<S>,
    /// Constraints of the closed loops, and what they carry.
    pub loops: &'a LoopSolver<S>,
    /// What the elements of the extent show, one after another.
    pub outputs: &'a [S],
    /// Energy and momentum.
    pub totals: Totals<S>,
}

/// Energy and momentum of all bodies.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Totals<S = f64> {
    /// With that of the water that moves with hulls, J.
    pub kinetic_energy: S,
    /// J.
    pub potential_energy: S,
    /// kg m/s, world.
    pub linear_momentum: Vector3<S>,
    /// N m s about [`ledger::reference_point`](crate::ledger::reference_point), world.
    pub angular_momentum: Vector3<S>,
}
