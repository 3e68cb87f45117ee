//! Inverse dynamics: the wrench in every joint, from given accelerations.
//!
//! The recursive Newton-Euler algorithm (Featherstone 2008, ch. 5) over all bodies, including those at fixed
//! joints, so that the reaction of a lashed load is also computed.

use super::{Kinematics, Loads};
use crate::model::{JointKind, Model};
use crate::scalar::Scalar;
use crate::spatial::{Twist, Vector3, Wrench};

/// Accelerations and joint wrenches of all bodies.
#[derive(Clone, Debug)]
pub struct InverseDynamics<S = f64> {
    /// Rate of each body's twist, component by component, in body axes.
    pub acceleration: Vec<Twist<S>>,
    /// Wrench that each body's joint transmits to it, in body axes about its centre of mass.
    pub joint_wrench: Vec<Wrench<S>>,
}

impl<S: Scalar> InverseDynamics<S> {
    /// Allocates the memory for a model.
    pub fn new(model: &Model<S>) -> Self {
        let n = model.bodies.len();
        Self { acceleration: vec![Twist::zero(); n], joint_wrench: vec![Wrench::zero(); n] }
    }

    /// Computes accelerations and joint wrenches from the accelerations `v_dot` of all coordinates; `bodies`
    /// is the kinematics of `model.tree`. `loads.force` is not needed: it is part of the result.
    pub fn update(&mut self, model: &Model<S>, bodies: &Kinematics<S>, v: &[S], v_dot: &[S], loads: &Loads<S>) {
        for (i, node) in model.tree.nodes.iter().enumerate() {
            let twist = &bodies.twist[i];
            let carried =
                node.parent.map_or(Twist::zero(), |p| bodies.relative[i].twist_to_child(&self.acceleration[p]));
            let at = node.velocities;
            let own = match &node.kind {
                JointKind::Floating(_) => {
                    let rotation = &bodies.world[i].rotation;
                    let body = |w: &[S]| rotation.transpose_times(Vector3::from_slice(w));
                    let turning = twist.angular.cross(body(&v[at..]));
                    Twist { angular: Vector3::from_slice(&v_dot[at + 3..]), linear: body(&v_dot[at..]) - turning }
                }
                _ => {
                    let rates = &v_dot[at..][..node.kind.velocity_count()];
                    let columns = bodies.columns[at..].iter().zip(rates);
                    let turning = bodies.joint_bias_acceleration[i] + twist.cross(&bodies.joint_twist[i]);
                    columns.fold(turning, |sum, (column, rate)| *column * *rate + sum)
                }
            };
            self.acceleration[i] = carried + own;
            self.joint_wrench[i] =
                node.inertia.times(&self.acceleration[i]) + twist.cross_momentum(&node.inertia.times(twist));
        }
        for (body, wrench) in &loads.wrenches {
            self.joint_wrench[*body] -= *wrench;
        }
        for (i, body) in model.bodies.iter().enumerate() {
            if let Some(weight) = loads.weight(body.mass) {
                self.joint_wrench[i].force -= bodies.world[i].rotation.transpose_times(weight);
            }
        }
        for (body, added) in &loads.added_inertia {
            let twist = &bodies.twist[*body];
            self.joint_wrench[*body] +=
                added.times(&self.acceleration[*body]) + twist.cross_momentum(&added.times(twist));
        }
        for ([first, second], added) in &loads.added_inertia_between {
            let (twist, other) = (&bodies.twist[*first], &bodies.twist[*second]);
            let [rate, rate_of_other] = [first, second].map(|body| &self.acceleration[*body]);
            let on_first = added.times(rate_of_other) + twist.cross_momentum(&added.times(other));
            let on_second = added.transpose_times(rate) + other.cross_momentum(&added.transpose_times(twist));
            self.joint_wrench[*first] += on_first;
            self.joint_wrench[*second] += on_second;
        }
        for i in (0..model.tree.nodes.len()).rev() {
            if let Some(parent) = model.tree.nodes[i].parent {
                let carried = bodies.relative[i].wrench_to_parent(&self.joint_wrench[i]);
                self.joint_wrench[parent] += carried;
            }
        }
    }

    /// Returns the generalized force along each coordinate of v for the accelerations `v_dot`: the joint
    /// wrenches projected on the joints' axes, plus the torques that accelerate the rotors.
    pub fn generalized_force(&self, model: &Model<S>, bodies: &Kinematics<S>, v_dot: &[S], out: &mut [S]) {
        for (i, node) in model.tree.nodes.iter().enumerate() {
            for at in (node.velocities..).take(node.kind.velocity_count()) {
                out[at] = self.joint_wrench[i].dot(&bodies.columns[at]) + model.rotor_inertia[at] * v_dot[at];
            }
        }
    }
}
