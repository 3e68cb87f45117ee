//! Loads on the bodies, one file each.
//!
//! A new force is one new file and one arm in each `match` of [`Force`].

mod coulomb_friction;
mod gravity;
mod joint_damping;
mod joint_spring;
mod joint_stop;
mod viscous_damping;

pub use coulomb_friction::CoulombFriction;
pub use gravity::Gravity;
pub use joint_damping::JointDamping;
pub use joint_spring::JointSpring;
pub use joint_stop::{JointStop, StopSide, hunt_crossley};
pub use viscous_damping::ViscousDamping;

use crate::dynamics::{LinkKinematics, Loads};
use crate::model::Model;
use crate::scalar::Scalar;

/// The kinds of force.
#[derive(Clone, Debug)]
pub enum Force<S = f64> {
    /// Weight of every body.
    Gravity(Gravity<S>),
    /// Viscous moment and force on one body's own rates.
    ViscousDamping(ViscousDamping<S>),
    /// Viscous friction in a joint.
    JointDamping(JointDamping<S>),
    /// Dry friction in a joint.
    CoulombFriction(CoulombFriction<S>),
    /// A spring in a joint.
    JointSpring(JointSpring<S>),
    /// A stop in a joint.
    JointStop(JointStop<S>),
}

impl<S: Scalar> Force<S> {
    /// Adds this force to the loads; `links` is the kinematics of `model.links`.
    pub fn apply(&self, model: &Model<S>, links: &LinkKinematics<S>, q: &[S], v: &[S], loads: &mut Loads<S>) {
        match self {
            Force::Gravity(gravity) => gravity.apply(model, links, loads),
            Force::ViscousDamping(damping) => damping.apply(model, links, loads),
            Force::JointDamping(damping) => damping.apply(v, loads),
            Force::CoulombFriction(friction) => friction.apply(v, loads),
            Force::JointSpring(spring) => spring.apply(q, loads),
            Force::JointStop(stop) => stop.apply(q, v, loads),
        }
    }

    /// Potential energy, J; zero for forces that have none.
    pub fn potential_energy(&self, model: &Model<S>, links: &LinkKinematics<S>, q: &[S]) -> S {
        match self {
            Force::Gravity(gravity) => gravity.potential_energy(model, links),
            Force::JointSpring(spring) => spring.potential_energy(q),
            Force::JointStop(stop) => stop.potential_energy(q),
            Force::ViscousDamping(_) | Force::JointDamping(_) | Force::CoulombFriction(_) => S::ZERO,
        }
    }
}
