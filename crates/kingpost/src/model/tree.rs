//! Kinematic tree for the dynamics, and its local coordinates.

use super::joint::{JointKind, MotionType};
use crate::scalar::Scalar;
use crate::spatial::{Frame, SpatialInertia};

/// A body or a link, with its parent, joint and inertia.
#[derive(Clone, Copy, Debug)]
pub struct Node<S = f64> {
    /// Index of the parent node, always smaller; `None` is the world.
    pub parent: Option<usize>,
    /// The joint to the parent.
    pub kind: JointKind<S>,
    /// Mode of a joint of one axis (free, held or prescribed), or whether a spherical joint is held; floating
    /// joints and lists of axes contain their modes.
    pub mode: MotionType,
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
    /// Appends the links of a body's joint to the link `carrier`, in which the parent's frame is
    /// `in_carrier`; the inertia of the new links is zero. Returns the index of the last one.
    pub(super) fn append(&mut self, body: &Node<S>, carrier: Option<usize>, in_carrier: &Frame<S>) -> usize {
        let inertia = SpatialInertia::default();
        match body.kind.seen_from(in_carrier) {
            JointKind::AxisList(list) => {
                for (k, (kind, mode)) in list.split().enumerate() {
                    let parent = if k == 0 { carrier } else { Some(self.nodes.len() - 1) };
                    let (positions, velocities) = (body.positions + k, body.velocities + k);
                    self.nodes.push(Node { parent, kind, mode, positions, velocities, inertia });
                }
            }
            kind => self.nodes.push(Node { parent: carrier, kind, inertia, ..*body }),
        }
        self.nodes.len() - 1
    }

    /// Returns the length of v.
    pub fn velocity_count(&self) -> usize {
        self.nodes.last().map_or(0, |node| node.velocities + node.kind.velocity_count())
    }

    /// `out = q retracted by xi`: on rotations `R exp(hat(xi))`, elsewhere the sum.
    pub fn retract(&self, q: &[S], xi: &[S], out: &mut [S]) {
        for node in &self.nodes {
            let (p, v) = (node.positions, node.velocities);
            match &node.kind {
                JointKind::Revolute(_) | JointKind::Prismatic(_) => out[p] = q[p] + xi[v],
                kind => kind.retract(&q[p..], &xi[v..], &mut out[p..]),
            }
        }
    }

    /// Computes `out = xi'`, the rate of the local coordinates for the velocity `v`.
    pub fn dexp_inverse(&self, xi: &[S], v: &[S], out: &mut [S]) {
        for node in &self.nodes {
            let i = node.velocities;
            match &node.kind {
                JointKind::Revolute(_) | JointKind::Prismatic(_) => out[i] = v[i],
                kind => kind.dexp_inverse(&xi[i..], &v[i..], &mut out[i..]),
            }
        }
    }
}
