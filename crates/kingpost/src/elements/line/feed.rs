//! The motion of a line along itself, as it is paid out (`pay_out.rs`).

use super::mesh::LineMesh;
use super::strain::{slopes, sum};
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// The motion of a line along itself, and the force on its supply.
#[derive(Clone, Debug)]
pub struct LineFeed<S> {
    /// c at the nodes of the first part, without that at its end, where it is zero.
    pub(super) drifts: Vec<Vector3<S>>,
    /// L', m/s.
    pub(super) rate: S,
    /// Velocity of the body at the first end, world, m/s.
    pub(super) tip: Vector3<S>,
    /// Q of strain and of the nodes between the ends, N.
    pub force: S,
    /// Q of the last node, if it grows, N.
    pub of_end: S,
    /// Thrust on the first end, world, N.
    pub thrust: Vector3<S>,
    /// Momentum that the nodes between the ends take up as material comes in and moves through them, world, N.
    pub taken_up: Vector3<S>,
    /// Kinetic energy of the material that comes in with the velocity of the first end, without what the last node takes, W.
    pub entering: S,
}

impl<S: Scalar> LineFeed<S> {
    /// Allocates the memory for the nodes of a mesh.
    pub fn new(mesh: &LineMesh<S>) -> Self {
        let zero = Vector3::zero();
        let drifts = vec![zero; 2 * mesh.supplied];
        let [rate, force, of_end, entering] = [S::ZERO; 4];
        Self { drifts, rate, tip: zero, force, of_end, thrust: zero, taken_up: zero, entering }
    }

    /// Returns c at a node.
    pub fn drift(&self, node: usize) -> Vector3<S> {
        self.drifts.get(node).copied().unwrap_or(Vector3::zero())
    }
}

/// Returns `xi df/ds` at a node in the first part of a line, behind its first one, for a vector f of the material at the nodes.
pub fn convected<S: Scalar>(mesh: &LineMesh<S>, node: usize, f: impl Fn(usize) -> Vector3<S>) -> Vector3<S> {
    let per_length = S::constant(mesh.nodes[node].share) / mesh.elements[node / 2].length;
    (f(node - 1) - f(node + 1)) * per_length
}

/// Writes c at the nodes of the first part of a line at these positions.
pub fn write_drifts<S: Scalar>(mesh: &LineMesh<S>, position: impl Fn(usize) -> Vector3<S>, out: &mut [Vector3<S>]) {
    for (node, drift) in out.iter_mut().enumerate() {
        let length = mesh.elements[node / 2].length;
        let towards_first = match node {
            0 => -sum(&slopes(-1.0, length), &[0, 1, 2].map(&position)),
            _ => (position(node - 1) - position(node + 1)) * (S::ONE / length),
        };
        *drift = towards_first * S::constant(mesh.nodes[node].share);
    }
}
