//! Frames and twists of every node of a tree (eqs. 24-29, 36-43).

use crate::model::{JointKind, Tree, joint::Floating};
use crate::scalar::Scalar;
use crate::spatial::{Frame, Twist};

/// Positions and velocities of the nodes of a tree.
#[derive(Clone, Debug)]
pub struct Kinematics<S = f64> {
    /// E(child/parent), by node.
    pub relative: Vec<Frame<S>>,
    /// E, by node: in the world.
    pub world: Vec<Frame<S>>,
    /// Omega, by node: body components about the node's origin.
    pub twist: Vec<Twist<S>>,
    /// The part of the twist from the node's own joint.
    pub joint_twist: Vec<Twist<S>>,
    /// That part's rate, component by component, at constant rates of the joint's coordinates: zero except for joints
    /// with columns that are not constant.
    pub joint_bias_acceleration: Vec<Twist<S>>,
    /// By coordinate of v: the twist per unit rate of the node whose joint owns it.
    pub columns: Vec<Twist<S>>,
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
            joint_bias_acceleration: vec![Twist::zero(); n],
            columns: vec![Twist::zero(); tree.velocity_count()],
        }
    }

    /// Computes everything from q and v.
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

/// Columns times rates.
fn combined<S: Scalar>(columns: &[Twist<S>], rates: &[S]) -> Twist<S> {
    let mut terms = columns.iter().zip(rates).map(|(column, rate)| *column * *rate);
    terms.next().map_or(Twist::zero(), |first| terms.fold(first, |sum, term| sum + term))
}
