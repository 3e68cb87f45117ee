//! Frames and twists of every node of a tree (eqs. 24-29, 36-43).

use crate::model::{JointKind, Tree, joint::Floating};
use crate::scalar::Scalar;
use crate::spatial::{Frame, Twist};

/// Where the nodes of a tree are and how they move.
#[derive(Clone, Debug)]
pub struct Kinematics<S = f64> {
    /// E(child/parent), by node.
    pub relative: Vec<Frame<S>>,
    /// E, by node: in the world.
    pub world: Vec<Frame<S>>,
    /// Omega, by node: body components about the node's origin.
    pub twist: Vec<Twist<S>>,
    /// The part of the twist that the node's own joint makes.
    pub joint_twist: Vec<Twist<S>>,
}

impl<S: Scalar> Kinematics<S> {
    /// Room for a tree.
    pub fn new(tree: &Tree<S>) -> Self {
        let n = tree.nodes.len();
        Self {
            relative: vec![Frame::identity(); n],
            world: vec![Frame::identity(); n],
            twist: vec![Twist::zero(); n],
            joint_twist: vec![Twist::zero(); n],
        }
    }

    /// Computes everything from q and v.
    pub fn update(&mut self, tree: &Tree<S>, q: &[S], v: &[S]) {
        for (i, node) in tree.nodes.iter().enumerate() {
            let relative = node.kind.relative(&q[node.positions..]);
            let (world, carried) = match node.parent {
                Some(p) => (self.world[p].times(&relative), relative.twist_to_child(&self.twist[p])),
                None => (relative, Twist::zero()),
            };
            let own = match &node.kind {
                JointKind::Floating(_) => Floating::twist(&world, &v[node.velocities..]),
                JointKind::Fixed(_) => Twist::zero(),
                kind => kind.axis_twist().map_or(Twist::zero(), |axis| *axis * v[node.velocities]),
            };
            self.relative[i] = relative;
            self.world[i] = world;
            self.joint_twist[i] = own;
            self.twist[i] = carried + own;
        }
    }
}
