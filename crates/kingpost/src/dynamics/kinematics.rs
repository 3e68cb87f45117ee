//! Frames and twists of every node of a tree (eqs. 24-29, 36-43).

use crate::model::{JointKind, Tree, joint::Floating};
use crate::scalar::Scalar;
use crate::spatial::{Frame, Twist};

/// Positions and velocities of the nodes of a tree.
#[derive(Clone, Debug)]
pub struct Kinematics<S = f64> {
    /// Relative frame E(child/parent), by node.
    pub relative: Vec<Frame<S>>,
    /// Frame E in the world, by node.
    pub world: Vec<Frame<S>>,
    /// Twist Omega by node: body components about the node's origin.
    pub twist: Vec<Twist<S>>,
    /// Contribution of the node's own joint to the twist.
    pub joint_twist: Vec<Twist<S>>,
    /// Rate of this contribution, component by component, at constant rates of the joint's coordinates: zero
    /// for joints with constant columns.
    pub joint_bias_acceleration: Vec<Twist<S>>,
    /// Twist per unit rate, for each coordinate of v, of the node whose joint has this coordinate.
    pub columns: Vec<Twist<S>>,
}

impl<S: Scalar> Kinematics<S> {
    /// Allocates the memory for a tree.
    pub fn new(tree: &Tree<S>) -> Self {
        let n = tree.nodes.len();
        Self {
            relative: vec![Frame::identity(); n],
            world: vec![Frame::identity(); n],
            twist: vec![Twist::zero(); n],
            joint_twist: vec![Twist::zero(); n],
            joint_bias_acceleration: vec![Twist::zero(); n],
            columns: vec![Twist::zero(); tree.velocity_count()],
        }
    }

    /// Computes all members from q and v.
    pub fn update(&mut self, tree: &Tree<S>, q: &[S], v: &[S]) {
        for (i, node) in tree.nodes.iter().enumerate() {
            let (q, v) = (&q[node.positions..], &v[node.velocities..]);
            let relative = node.kind.relative(q);
            let (world, carried) = match node.parent {
                Some(p) => (self.world[p].times(&relative), relative.twist_to_child(&self.twist[p])),
                None => (relative, Twist::zero()),
            };
            let columns = node.kind.columns(q, &world);
            let own = match &node.kind {
                JointKind::Floating(_) => Floating::twist(&world, v),
                _ => combined(&columns, v),
            };
            let twist = carried + own;
            self.relative[i] = relative;
            self.world[i] = world;
            self.joint_twist[i] = own;
            self.twist[i] = twist;
            self.joint_bias_acceleration[i] = combined(&node.kind.column_rates(&columns, v, twist.angular), v);
            self.columns[node.velocities..][..columns.len()].copy_from_slice(&columns);
        }
    }
}

/// Returns columns times rates.
fn combined<S: Scalar>(columns: &[Twist<S>], rates: &[S]) -> Twist<S> {
    let mut terms = columns.iter().zip(rates).map(|(column, rate)| *column * *rate);
    terms.next().map_or(Twist::zero(), |first| terms.fold(first, |sum, term| sum + term))
}
