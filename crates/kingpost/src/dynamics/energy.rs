//! Kinetic energy and momentum.

use super::Kinematics;
use crate::model::{Model, Tree};
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// Returns the kinetic energy, J: half the sum of `v^T I v` (eqs. 47, 49).
pub fn kinetic_energy<S: Scalar>(tree: &Tree<S>, kinematics: &Kinematics<S>) -> S {
    let twice = tree
        .nodes
        .iter()
        .zip(&kinematics.twist)
        .fold(S::ZERO, |sum, (node, twist)| sum + node.inertia.quadratic(twist));
    twice * S::constant(0.5)
}

/// Returns the kinetic energy of the rotors in the joints, J.
pub fn rotor_energy<S: Scalar>(model: &Model<S>, v: &[S]) -> S {
    let twice = model.rotor_inertia.iter().zip(v).fold(S::ZERO, |sum, (inertia, v)| sum + *inertia * *v * *v);
    twice * S::constant(0.5)
}

/// Returns linear momentum (kg m/s) and angular momentum about `centre` (N m s), world components.
pub fn momentum<S: Scalar>(tree: &Tree<S>, kinematics: &Kinematics<S>, centre: Vector3<S>) -> (Vector3<S>, Vector3<S>) {
    let (mut linear, mut angular) = (Vector3::zero(), Vector3::zero());
    for (i, node) in tree.nodes.iter().enumerate() {
        let frame = &kinematics.world[i];
        let momentum = node.inertia.times(&kinematics.twist[i]);
        let p = frame.rotation * momentum.force;
        linear += p;
        angular += frame.rotation * momentum.moment + (frame.position - centre).cross(p);
    }
    (linear, angular)
}
