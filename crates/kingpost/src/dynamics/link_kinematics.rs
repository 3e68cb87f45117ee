//! Kinematics of the fused links for the recursion, in the axes of each branch's root.
//!
//! Seen from one frame, twists of a branch simply add and inertias need no moving from link to
//! link. The root's frame is near, so that lengths stay as small as the crane, however far the ship
//! is from the world's origin.

use super::ball::Ball;
use crate::model::joint::{Floating, Mounted};
use crate::model::{JointKind, Model, Node};
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
    /// From the root's origin to a point of each link's joint that moves with both its links, root
    /// axes, m; the link's own origin for a slide.
    pub pivot: Vec<Vector3<S>>,
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
            pivot: vec![Vector3::zero(); n],
            twist: vec![Twist::zero(); n],
            axis: vec![Twist::zero(); n],
        }
    }

    /// Computes everything from q and v.
    pub fn update(&mut self, model: &Model<S>, q: &[S], v: &[S]) {
        let nodes = &model.links.nodes;
        for (i, node) in nodes.iter().enumerate() {
            let (q, v) = (&q[node.positions..], &v[node.velocities..]);
            let Some(p) = node.parent else {
                self.update_root(i, node, q, v);
                continue;
            };
            let parent = nodes[p].parent.is_some().then(|| &self.in_root[p]);
            let Mounted { frame, pivot, axis } = node.kind.mounted(parent, q);
            let own = match &node.kind {
                JointKind::Spherical(joint) => Ball::new(joint, node, &frame).twist(v),
                _ => axis * v[0],
            };
            self.twist[i] = self.twist[p] + own;
            (self.in_root[i], self.pivot[i], self.axis[i]) = (frame, pivot, axis);
        }
    }

    /// A link on the world: its frame is what its branch is seen from.
    #[inline]
    fn update_root(&mut self, i: usize, node: &Node<S>, q: &[S], v: &[S]) {
        let frame = node.kind.relative(q);
        self.twist[i] = match &node.kind {
            JointKind::Floating(_) => Floating::twist(&frame, v),
            JointKind::Spherical(joint) => Ball::new(joint, node, &Frame::identity()).twist(v),
            kind => {
                self.axis[i] = kind.axis_twist().copied().unwrap_or(Twist::zero());
                self.axis[i] * v[0]
            }
        };
        self.pivot[i] =
            if matches!(node.kind, JointKind::Prismatic(_)) { Vector3::zero() } else { -node.kind.to_child() };
        self.root_in_world[i] = frame;
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
        self.to_body(model, body, |link| self.twist[link])
    }

    /// A twist of a body's link, or its spatial rate, in root axes, as that of the body, in its axes about its centre of
    /// mass; zero for a body that is fixed to the world.
    pub fn to_body(&self, model: &Model<S>, body: usize, of_link: impl Fn(usize) -> Twist<S>) -> Twist<S> {
        let body = &model.bodies[body];
        let carried = |link: usize| body.in_link.twist_to_child(&self.in_root[link].twist_to_child(&of_link(link)));
        body.link.map_or(Twist::zero(), carried)
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
