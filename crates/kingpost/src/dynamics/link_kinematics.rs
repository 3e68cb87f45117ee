//! Kinematics of the fused links for the recursion, in the axes of each branch's root.
//!
//! Seen from one frame, twists of a branch simply add and inertias need no moving from link to
//! link. The root's frame is near, so that lengths stay as small as the crane, however far the ship
//! is from the world's origin.

use super::ball::Ball;
use crate::model::{JointKind, Model, joint::Floating};
use crate::scalar::Scalar;
use crate::spatial::{Frame, Twist, Vector3};

/// Where the links are and how they move. "Root" is the link at the foot of a link's branch; its
/// frame is at its centre of mass.
#[derive(Clone, Debug)]
pub struct LinkKinematics<S = f64> {
    /// World frame of each root, at the root's own index; the identity elsewhere.
    pub root_in_world: Vec<Frame<S>>,
    /// Each link in its root's frame.
    pub in_root: Vec<Frame<S>>,
    /// Twist of each link about the root's origin, root axes.
    pub twist: Vec<Twist<S>>,
    /// The same per unit rate of the link's own joint, where that has one axis; zero elsewhere.
    pub axis: Vec<Twist<S>>,
}

impl<S: Scalar> LinkKinematics<S> {
    /// Room for a model.
    pub fn new(model: &Model<S>) -> Self {
        let n = model.links.nodes.len();
        Self {
            root_in_world: vec![Frame::identity(); n],
            in_root: vec![Frame::identity(); n],
            twist: vec![Twist::zero(); n],
            axis: vec![Twist::zero(); n],
        }
    }

    /// Computes everything from q and v.
    pub fn update(&mut self, model: &Model<S>, q: &[S], v: &[S]) {
        for (i, node) in model.links.nodes.iter().enumerate() {
            let relative = node.kind.relative(&q[node.positions..]);
            let (axis, carried) = match node.parent {
                Some(p) => {
                    let on_root = model.links.nodes[p].parent.is_none();
                    self.in_root[i] = if on_root { relative } else { self.in_root[p].times(&relative) };
                    let own = node.kind.axis_twist().map_or(Twist::zero(), |t| self.in_root[i].twist_to_parent(t));
                    (own, self.twist[p])
                }
                None => {
                    self.root_in_world[i] = relative;
                    (node.kind.axis_twist().copied().unwrap_or(Twist::zero()), Twist::zero())
                }
            };
            self.axis[i] = axis;
            self.twist[i] = match &node.kind {
                JointKind::Floating(_) => Floating::twist(&relative, &v[node.velocities..]),
                JointKind::Spherical(joint) => {
                    carried + Ball::new(joint, node, &self.in_root[i]).twist(&v[node.velocities..])
                }
                _ => carried + axis * v[node.velocities],
            };
        }
    }

    /// World frame of a body.
    pub fn body_frame(&self, model: &Model<S>, body: usize) -> Frame<S> {
        let body = &model.bodies[body];
        body.link.map_or(body.in_link, |link| {
            self.root_in_world[model.roots[link]].times(&self.in_root[link]).times(&body.in_link)
        })
    }

    /// Twist of a body in its own axes about its centre of mass.
    pub fn body_twist(&self, model: &Model<S>, body: usize) -> Twist<S> {
        let body = &model.bodies[body];
        body.link.map_or(Twist::zero(), |link| {
            body.in_link.twist_to_child(&self.in_root[link].twist_to_child(&self.twist[link]))
        })
    }

    /// World components of a vector in the axes of a body.
    pub fn to_body_axes(&self, model: &Model<S>, body: usize, world: Vector3<S>) -> Vector3<S> {
        let body = &model.bodies[body];
        let in_link = body.link.map_or(world, |link| {
            let in_root = self.root_in_world[model.roots[link]].rotation.transpose_times(world);
            self.in_root[link].rotation.transpose_times(in_root)
        });
        body.in_link.rotation.transpose_times(in_link)
    }
}
