//! What there is to see of a plant at a state.

use crate::dynamics::Kinematics;
use crate::dynamics::inverse::InverseDynamics;
use crate::dynamics::loops::LoopSolver;
use crate::elements::drives::CylinderReading;
use crate::elements::hull::HullReading;
use crate::elements::{LineReading, PositioningReading, ThrusterReading};
use crate::model::Model;
use crate::spatial::Vector3;

/// Borrowed results of [`Plant::observe`](super::Plant::observe).
pub struct Observation<'a, S = f64> {
    /// The model.
    pub model: &'a Model<S>,
    /// Kinematics of `model.tree`.
    pub bodies: &'a Kinematics<S>,
    /// Accelerations and joint wrenches of the bodies.
    pub inverse: &'a InverseDynamics<S>,
    /// Constraints of the closed loops, and what they carry.
    pub loops: &'a LoopSolver<S>,
    /// The hydraulic cylinders, in the order of the drives.
    pub cylinders: &'a [CylinderReading<S>],
    /// The sea at the hulls, in the order of the forces.
    pub hulls: &'a [HullReading<S>],
    /// The lines, in the order of the forces.
    pub lines: &'a [LineReading<S>],
    /// Loads of wind and current, in the order of the forces: force (N), then moment (N m).
    pub flow_forces: &'a [[S; 6]],
    /// Dynamic positioning, in the order of the forces.
    pub positioning: &'a [PositioningReading<S>],
    /// The thrusters of each, one after another.
    pub thrusters: &'a [ThrusterReading<S>],
    /// Energy and momentum.
    pub totals: Totals<S>,
}

/// Energy and momentum of all bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
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
