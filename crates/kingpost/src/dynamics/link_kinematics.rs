//! Kinematics of the links for the recursion, in the axes of each branch's root: one pass from the roots
//! outward.
//!
//! In a common frame the twists of a branch can be added, and inertias are not transformed from link to link.
//! The root's frame is near, so lengths are at most the size of the crane, even if the ship is far from the
//! world's origin.

use super::moving_link::MovingLink;
use crate::model::{Attachment, Carrier, LinkInertia, Model};
use crate::scalar::Scalar;
use crate::spatial::{Frame, SpatialInertia, Twist, Vector3};
use std::sync::OnceLock;

/// Positions and velocities of the links. "Root" is the first link of a branch; its frame is at its centre of mass.
#[derive(Clone, Debug)]
pub struct LinkKinematics<S = f64> {
    /// One record per link.
    links: Vec<MovingLink<S>>,
    /// World frame of each root, at the root's index; the identity for other links.
    root_in_world: Vec<Frame<S>>,
    /// Inertias that are not those of rigid bodies, by link, about the root's origin in its axes.
    full: Vec<(usize, SpatialInertia<S>)>,
    /// World frames of the bodies, each stored at first use: ropes, hulls and the ledger need the same few
    /// frames.
    body_frames: Vec<OnceLock<Frame<S>>>,
}

impl<S: Scalar> LinkKinematics<S> {
    /// Allocates the memory for a model.
    pub fn new(model: &Model<S>) -> Self {
        let n = model.plan.len();
        Self {
            links: model.plan.iter().map(MovingLink::still).collect(),
            root_in_world: vec![Frame::identity(); n],
            full: Vec::with_capacity(n),
            body_frames: vec![OnceLock::new(); model.bodies.len()],
        }
    }

    /// Computes all members from q and v.
    pub fn update(&mut self, model: &Model<S>, q: &[S], v: &[S]) {
        self.full.clear();
        // A stage needs few frames: most locks are empty and are not changed.
        for stored in self.body_frames.iter_mut().filter(|frame| frame.get().is_some()) {
            *stored = OnceLock::new();
        }
        for (i, plan) in model.plan.iter().enumerate() {
            let (before, rest) = self.links.split_at_mut(i);
            let link = &mut rest[0];
            match plan.carrier {
                Carrier::World => {
                    let (q, v) = (&q[plan.positions..], &v[plan.velocities..]);
                    link.stand(plan, q, v, &mut self.root_in_world[i]);
                }
                Carrier::Root(p) => link.mount_on_root(plan, &before[p], q, v),
                Carrier::Branch(p) => link.mount(plan, &before[p], q, v),
            }
            match &plan.inertia {
                LinkInertia::Central { mass, moments } => link.take_central(*mass, moments),
                LinkInertia::Rigid(rigid) => link.take_rigid(rigid),
                LinkInertia::Full(full) => self.full.push((i, link.take_full(full))),
            }
        }
    }

    /// Returns the world frame of a root.
    #[inline]
    pub fn root_in_world(&self, root: usize) -> &Frame<S> {
        &self.root_in_world[root]
    }

    /// Returns the frame of a link in its root's frame.
    #[inline]
    pub fn in_root(&self, link: usize) -> &Frame<S> {
        &self.links[link].in_root
    }

    /// Returns the twist of a link about the root's origin, root axes.
    #[inline]
    pub fn twist(&self, link: usize) -> &Twist<S> {
        &self.links[link].motion.twist
    }

    /// Returns the twist per unit rate of the link's own joint, about the root's origin, root axes; zero if the joint
    /// does not have one axis.
    #[inline]
    pub fn axis(&self, link: usize) -> &Twist<S> {
        &self.links[link].axis
    }

    /// Returns the records of all links.
    #[inline]
    pub(super) fn moving(&self) -> &[MovingLink<S>] {
        &self.links
    }

    /// Returns the inertias that are not those of rigid bodies, by link, about the root's origin in its axes.
    pub(super) fn full(&self) -> &[(usize, SpatialInertia<S>)] {
        &self.full
    }

    /// Returns the world frame of a body.
    pub fn body_frame(&self, model: &Model<S>, body: usize) -> Frame<S> {
        *self.body_frames[body].get_or_init(|| self.body_in_world(model, body))
    }

    /// Returns the world frame of an attachment.
    pub fn attachment_frame(&self, model: &Model<S>, at: &Attachment<S>) -> Frame<S> {
        at.body.map_or(at.in_body, |body| self.body_frame(model, body).times(&at.in_body))
    }

    fn body_in_world(&self, model: &Model<S>, body: usize) -> Frame<S> {
        let body = &model.bodies[body];
        let Some(link) = body.link else { return body.in_link };
        let root = model.roots[link];
        // The root is at the origin of its own frame.
        if root == link {
            self.root_in_world[root].times(&body.in_link)
        } else {
            self.root_in_world[root].times(self.in_root(link)).times(&body.in_link)
        }
    }

    /// Returns the twist of a body in its axes about its centre of mass.
    pub fn body_twist(&self, model: &Model<S>, body: usize) -> Twist<S> {
        self.to_body(model, body, |link| *self.twist(link))
    }

    /// Converts a twist of a body's link, or its spatial rate, from root axes to the body's axes about its
    /// centre of mass; zero for a body that is fixed to the world.
    pub fn to_body(&self, model: &Model<S>, body: usize, of_link: impl Fn(usize) -> Twist<S>) -> Twist<S> {
        let body = &model.bodies[body];
        let carried = |link: usize| body.in_link.twist_to_child(&self.in_root(link).twist_to_child(&of_link(link)));
        body.link.map_or(Twist::zero(), carried)
    }

    /// Converts a vector from world components to the axes of a body.
    pub fn to_body_axes(&self, model: &Model<S>, body: usize, world: Vector3<S>) -> Vector3<S> {
        let body = &model.bodies[body];
        let in_link = body.link.map_or(world, |link| {
            let in_root = self.root_in_world[model.roots[link]].rotation.transpose_times(world);
            self.in_root(link).rotation.transpose_times(in_root)
        });
        body.in_link.rotation.transpose_times(in_link)
    }
}
