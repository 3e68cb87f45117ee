//! Loads on the bodies, one file each.
//!
//! A new force is one new file and one arm in each `match` of [`Force`].

mod coulomb_friction;
pub mod drives;
pub mod dynamic_positioning;
pub mod flow;
mod gravity;
pub mod hull;
mod joint_damping;
mod joint_spring;
mod joint_stop;
pub mod lines;
mod quadratic_damping;
mod slack_tank;
mod viscous_damping;

pub use coulomb_friction::CoulombFriction;
pub use dynamic_positioning::{DynamicPositioning, PositioningReading, ThrusterReading};
pub use flow::FlowLoad;
pub use gravity::Gravity;
pub use hull::Hull;
pub use joint_damping::JointDamping;
pub use joint_spring::JointSpring;
pub use joint_stop::{JointStop, StopSide, hunt_crossley};
pub use lines::{CatenaryLine, LineReading, SpringLine};
pub use quadratic_damping::QuadraticDamping;
pub use slack_tank::SlackTank;
pub use viscous_damping::ViscousDamping;

use crate::dynamics::{LinkKinematics, Loads, Moment};
use crate::model::Model;
use crate::scalar::Scalar;

/// The kinds of force.
#[derive(Clone, Debug)]
pub enum Force<S = f64> {
    /// Weight of every body.
    Gravity(Gravity<S>),
    /// Damping of one body, in proportion to its rates.
    ViscousDamping(Box<ViscousDamping<S>>),
    /// Drag on one body, by the square of its speed.
    QuadraticDamping(QuadraticDamping<S>),
    /// Viscous friction in a joint.
    JointDamping(JointDamping<S>),
    /// Dry friction in a joint.
    CoulombFriction(CoulombFriction<S>),
    /// A spring in a joint.
    JointSpring(JointSpring<S>),
    /// A stop in a joint.
    JointStop(JointStop<S>),
    /// The water on a hull.
    Hull(Box<Hull<S>>),
    /// The free surface of a tank.
    SlackTank(Box<SlackTank<S>>),
    /// A line without weight.
    SpringLine(Box<SpringLine<S>>),
    /// A mooring line that hangs.
    CatenaryLine(Box<CatenaryLine<S>>),
    /// Wind or current by coefficients.
    FlowLoad(Box<FlowLoad<S>>),
    /// Thrusters that keep a ship in its place.
    DynamicPositioning(Box<DynamicPositioning<S>>),
}

impl<S: Scalar> Force<S> {
    /// Adds this force to the loads.
    pub fn apply(&mut self, at: &Moment<'_, S>, loads: &mut Loads<S>) {
        match self {
            Force::Gravity(gravity) => gravity.apply(loads),
            Force::ViscousDamping(damping) => damping.apply(at, loads),
            Force::QuadraticDamping(damping) => damping.apply(at, loads),
            Force::JointDamping(damping) => damping.apply(at.v, loads),
            Force::CoulombFriction(friction) => friction.apply(at.v, loads),
            Force::JointSpring(spring) => spring.apply(at.q, loads),
            Force::JointStop(stop) => stop.apply(at.q, at.v, loads),
            Force::Hull(hull) => hull.apply(at, loads),
            Force::SlackTank(tank) => tank.apply(at, loads),
            Force::SpringLine(line) => line.apply(at, loads),
            Force::CatenaryLine(line) => line.apply(at, loads),
            Force::FlowLoad(load) => load.apply(at, loads),
            Force::DynamicPositioning(positioning) => positioning.apply(at, loads),
        }
    }

    /// Potential energy, J; zero for forces that have none.
    pub fn potential_energy(&mut self, model: &Model<S>, links: &LinkKinematics<S>, q: &[S]) -> S {
        match self {
            Force::Gravity(gravity) => gravity.potential_energy(model, links),
            Force::JointSpring(spring) => spring.potential_energy(q),
            Force::JointStop(stop) => stop.potential_energy(q),
            Force::Hull(hull) => hull.potential_energy(model, links),
            Force::SlackTank(tank) => tank.potential_energy(model, links),
            Force::SpringLine(line) => line.potential_energy(model, links),
            Force::CatenaryLine(line) => line.potential_energy(model, links),
            Force::ViscousDamping(_)
            | Force::QuadraticDamping(_)
            | Force::FlowLoad(_)
            | Force::DynamicPositioning(_)
            | Force::JointDamping(_)
            | Force::CoulombFriction(_) => S::ZERO,
        }
    }

    /// The hull, where it is the water on one.
    pub fn hull(&self) -> Option<&Hull<S>> {
        if let Force::Hull(hull) = self { Some(hull) } else { None }
    }

    /// The hull, to be asked what changes nothing but its working memory.
    pub fn hull_mut(&mut self) -> Option<&mut Hull<S>> {
        if let Force::Hull(hull) = self { Some(hull) } else { None }
    }

    /// The slack tank, where it is one.
    pub fn slack_tank(&self) -> Option<&SlackTank<S>> {
        if let Force::SlackTank(tank) = self { Some(tank) } else { None }
    }

    /// The load of wind or current, where it is one.
    pub fn flow_load(&self) -> Option<&FlowLoad<S>> {
        if let Force::FlowLoad(load) = self { Some(load) } else { None }
    }

    /// The dynamic positioning, where it is one.
    pub fn dynamic_positioning(&self) -> Option<&DynamicPositioning<S>> {
        if let Force::DynamicPositioning(positioning) = self { Some(positioning) } else { None }
    }

    /// The dynamic positioning, to change how it begins or whether it settles.
    pub fn dynamic_positioning_mut(&mut self) -> Option<&mut DynamicPositioning<S>> {
        if let Force::DynamicPositioning(positioning) = self { Some(positioning) } else { None }
    }

    /// The name of the line, where it is one.
    pub fn line(&self) -> Option<&str> {
        match self {
            Force::SpringLine(line) => Some(&line.name),
            Force::CatenaryLine(line) => Some(&line.name),
            _ => None,
        }
    }

    /// What there is to see of the line, where it is one.
    pub fn line_reading(&self, at: &Moment<'_, S>) -> Option<LineReading<S>> {
        match self {
            Force::SpringLine(line) => Some(line.reading(at)),
            Force::CatenaryLine(line) => Some(line.reading(at)),
            _ => None,
        }
    }

    /// Number of its extra states.
    pub fn state_count(&self) -> usize {
        match self {
            Force::Hull(hull) => hull.state_count(),
            Force::DynamicPositioning(positioning) => positioning.state_count(),
            _ => 0,
        }
    }

    /// Number of the values that it holds over a step.
    pub fn held_count(&self) -> usize {
        self.hull().map_or(0, |_| hull::SlowFilter::<S>::LEN)
    }
}
