//! The kinematic tree that the dynamics runs over, and its local coordinates.

use super::joint::{JointKind, Mode};
use crate::scalar::Scalar;
use crate::spatial::SpatialInertia;

/// One body or link: its parent, its joint and its inertia.
#[derive(Clone, Copy, Debug)]
pub struct Node<S = f64> {
    /// Index of the parent node, always smaller; `None` is the world.
    pub parent: Option<usize>,
    /// The joint to the parent.
    pub kind: JointKind<S>,
    /// Whether the joint moves freely, is held or follows a prescribed motion.
    pub mode: Mode,
    /// First entry in q.
    pub positions: usize,
    /// First entry in v.
    pub velocities: usize,
    /// Inertia in the node's axes about its origin.
    pub inertia: SpatialInertia<S>,
}

/// Nodes, parents first.
#[derive(Clone, Debug, Default)]
pub struct Tree<S = f64> {
    /// The nodes.
    pub nodes: Vec<Node<S>>,
}

impl<S: Scalar> Tree<S> {
    /// `out = q retracted by xi`: on rotations `R exp(hat(xi))`, elsewhere the sum.
    pub fn retract(&self, q: &[S], xi: &[S], out: &mut [S]) {
        for node in &self.nodes {
            let (p, v) = (node.positions, node.velocities);
            node.kind.retract(&q[p..], &xi[v..], &mut out[p..]);
        }
    }

    /// `out = xi'`: the rate of the local coordinates that the velocity `v` gives at `xi`.
    pub fn dexp_inverse(&self, xi: &[S], v: &[S], out: &mut [S]) {
        for node in &self.nodes {
            let i = node.velocities;
            node.kind.dexp_inverse(&xi[i..], &v[i..], &mut out[i..]);
        }
    }
}
