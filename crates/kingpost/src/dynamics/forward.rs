//! Forward dynamics by recursion: accelerations from loads.
//!
//! The articulated-body algorithm (Featherstone, *Rigid Body Dynamics Algorithms*, 2008, ch. 7)
//! with prescribed joints (ch. 9), over the fused links, in the axes of each branch's root. It
//! solves M* q'' + N* q' = F* (eq. 61) without forming the matrices, and allocates nothing.
//!
//! The velocities' part of every link's acceleration, its drift, is known beforehand; what the drift
//! takes (N* q') joins the loads, and the recursion is over the rest: `a = drift + response`, with
//! the response linear in q''.

mod response;

pub use response::Response;

use super::ball::Ball;
use super::drift::{Drift, Relative};
use super::{LinkKinematics, Loads};
use crate::model::{JointKind, LinkInertia, Mode, Model, Node, joint::Floating};
use crate::scalar::Scalar;
use crate::spatial::{Matrix3, RigidInertia, SpatialInertia, Symmetric3, Twist, Vector3, Wrench};

/// Working memory of [`forward_dynamics`], by link, root axes.
#[derive(Clone, Debug)]
pub struct Workspace<S = f64> {
    links: Vec<Articulated<S>>,
    /// Whether nothing hangs on a link and its joint has one axis: then it stays a rigid body.
    ends: Vec<bool>,
}

/// A link with all that hangs on it.
#[derive(Clone, Copy, Debug, Default)]
struct Articulated<S> {
    /// Whether it is no more than `rigid`; else its articulated inertia is `inertia`.
    is_rigid: bool,
    /// Ten numbers for 21.
    rigid: RigidInertia<S>,
    /// Articulated inertia.
    inertia: SpatialInertia<S>,
    /// Articulated bias force: what the drift takes, less the loads.
    bias: Wrench<S>,
    /// Velocity term of the acceleration.
    drift: Drift<S>,
    /// Articulated inertia times the joint's axis.
    gain: Wrench<S>,
    /// Reciprocal inertia along the joint's axis, the rotor's included, 1/kg or 1/(kg m^2).
    compliance: S,
    /// Force along the joint's axis that is left to accelerate it.
    drive: S,
    /// Acceleration beyond the drift.
    response: Twist<S>,
}

impl<S: Scalar> Workspace<S> {
    /// Room for a model.
    pub fn new(model: &Model<S>) -> Self {
        let nodes = &model.links.nodes;
        let end = |(i, node): (usize, &Node<S>)| {
            let rigid = matches!(model.link_inertias[i], LinkInertia::Central { .. });
            rigid && node.kind.axis_twist().is_some() && nodes.iter().all(|other| other.parent != Some(i))
        };
        let ends = nodes.iter().enumerate().map(end).collect();
        Self { links: vec![Articulated::default(); nodes.len()], ends }
    }

    /// Inertia of a link with all that hangs on it and gives way, root axes.
    pub fn articulated_inertia(&self, link: usize) -> SpatialInertia<S> {
        self.links[link].inertia()
    }

    /// Spatial acceleration of a link, root axes.
    #[inline]
    pub fn acceleration(&self, links: &LinkKinematics<S>, link: usize) -> Twist<S> {
        let Articulated { drift, response, .. } = &self.links[link];
        drift.spatial(links.in_root[link].position, &links.twist[link]) + *response
    }

    /// The wrench that the joint of a link carries to it, about the root's origin, root axes.
    pub fn joint_wrench(&self, link: usize) -> Wrench<S> {
        let link = &self.links[link];
        link.times(&link.response) + link.bias
    }
}

impl<S: Scalar> Articulated<S> {
    #[inline]
    fn inertia(&self) -> SpatialInertia<S> {
        if self.is_rigid { self.rigid.to_spatial() } else { self.inertia }
    }

    /// Articulated inertia times a twist.
    #[inline]
    fn times(&self, twist: &Twist<S>) -> Wrench<S> {
        if self.is_rigid { self.rigid.times(twist) } else { self.inertia.times(twist) }
    }

    /// Takes what a joint lets through.
    #[inline]
    fn carry(&mut self, inertia: &SpatialInertia<S>, bias: &Wrench<S>) {
        self.inertia += *inertia;
        self.bias += *bias;
    }
}

/// Computes the acceleration of every coordinate of v; held ones get zero, prescribed ones what
/// `loads` says.
pub fn forward_dynamics<S: Scalar>(
    model: &Model<S>,
    links: &LinkKinematics<S>,
    v: &[S],
    loads: &Loads<S>,
    work: &mut Workspace<S>,
    v_dot: &mut [S],
) {
    gather(model, links, v, work);
    load(model, links, loads, work);
    articulate(model, links, loads, work);
    respond(model, links, loads, work, v_dot);
}

/// Every link by itself: inertia, drift, and what the drift takes.
#[inline]
fn gather<S: Scalar>(model: &Model<S>, links: &LinkKinematics<S>, v: &[S], work: &mut Workspace<S>) {
    let nodes = model.links.nodes.as_slice();
    let (inertias, ends, work) = (&model.link_inertias[..nodes.len()], &work.ends[..nodes.len()], &mut work.links);
    let (in_root, twist) = (&links.in_root[..nodes.len()], &links.twist[..nodes.len()]);
    for (i, node) in nodes.iter().enumerate() {
        let (before, rest) = work.split_at_mut(i);
        let (link, frame, twist) = (&mut rest[0], &in_root[i], &twist[i]);
        drift(node, i, links, v, before, &mut link.drift);
        link.is_rigid = ends[i];
        match &inertias[i] {
            LinkInertia::Massless => {
                (link.inertia, link.bias) = (SpatialInertia::default(), Wrench::zero());
            }
            LinkInertia::Central { mass, moments } => {
                let moments = if node.parent.is_some() { moments.rotated(&frame.rotation) } else { *moments };
                link.bias = newton_euler(*mass, &moments, frame.position, twist.angular, &link.drift);
                link.rigid = RigidInertia::of_centre(*mass, frame.position, &moments);
                if !link.is_rigid {
                    link.inertia = link.rigid.to_spatial();
                }
            }
            LinkInertia::Rigid(rigid) => {
                link.inertia = rigid.to_spatial();
                link.bias = turning(rigid, twist.angular, &link.drift);
            }
            LinkInertia::Full => {
                link.inertia = if node.parent.is_some() { node.inertia.to_parent(frame) } else { node.inertia };
                link.bias = kirchhoff(&link.inertia, twist, &link.drift.spatial(frame.position, twist));
            }
        }
    }
}

/// From the ends of the branches to their roots: what hangs on each link.
#[inline]
fn articulate<S: Scalar>(model: &Model<S>, links: &LinkKinematics<S>, loads: &Loads<S>, work: &mut Workspace<S>) {
    let (nodes, work) = (model.links.nodes.as_slice(), &mut work.links);
    for (i, node) in nodes.iter().enumerate().rev() {
        let (before, rest) = work.split_at_mut(i);
        let (link, parent) = (&mut rest[0], node.parent.map(|p| &mut before[p]));
        match &node.kind {
            JointKind::Floating(_) => {}
            JointKind::Spherical(joint) => {
                let ball = Ball::new(joint, node, &links.in_root[i]);
                let (inertia, bias) = ball.transmitted(&link.inertia, &link.bias, loads);
                parent.into_iter().for_each(|parent| parent.carry(&inertia, &bias));
            }
            _ => transmit(node, &links.axis[i], model.rotor_inertia[node.velocities], loads, link, parent),
        }
    }
}

/// From the roots out: how each link responds.
#[inline]
fn respond<S: Scalar>(
    model: &Model<S>,
    links: &LinkKinematics<S>,
    loads: &Loads<S>,
    work: &mut Workspace<S>,
    v_dot: &mut [S],
) {
    let (nodes, work) = (model.links.nodes.as_slice(), &mut work.links);
    for (i, node) in nodes.iter().enumerate() {
        let (before, rest) = work.split_at_mut(i);
        let (link, parent) = (&mut rest[0], node.parent.map(|p| &before[p].response));
        match &node.kind {
            JointKind::Floating(floating) => {
                Root { floating: *floating, node, rotation: &links.root_in_world[i].rotation }
                    .accelerate(loads, link, v_dot);
            }
            JointKind::Spherical(joint) => {
                let ball = Ball::new(joint, node, &links.in_root[i]);
                let carried = parent.copied().unwrap_or(Twist::zero());
                link.response = ball.accelerate(&link.inertia, &link.bias, &carried, loads, v_dot);
            }
            _ => v_dot[node.velocities] = accelerate(node, &links.axis[i], parent, loads, link),
        }
    }
}

/// The drift of a link, from that of the links before it.
#[inline]
fn drift<S: Scalar>(
    node: &Node<S>,
    i: usize,
    links: &LinkKinematics<S>,
    v: &[S],
    before: &[Articulated<S>],
    drift: &mut Drift<S>,
) {
    let own = links.twist[i].angular;
    let relative = match &node.kind {
        JointKind::Floating(_) => {
            *drift = Drift::floating(own);
            return;
        }
        JointKind::Spherical(_) => {
            let carried = node.parent.map_or(Vector3::zero(), |p| links.twist[p].angular);
            Relative { turning: own - carried, sliding: None }
        }
        JointKind::Prismatic(_) => {
            let sliding = links.axis[i].linear * v[node.velocities];
            Relative { turning: Vector3::zero(), sliding: Some(sliding) }
        }
        _ => Relative { turning: links.axis[i].angular * v[node.velocities], sliding: None },
    };
    let here = (links.in_root[i].position, own);
    match node.parent {
        Some(p) => {
            let there = (links.in_root[p].position, links.twist[p].angular);
            before[p].drift.carry(there, links.pivot[i], &relative, here, drift);
        }
        None => {
            Drift::default().carry((Vector3::zero(), Vector3::zero()), links.pivot[i], &relative, here, drift);
        }
    }
}

/// What the drift of a link takes, about the root's origin: `f = m a`, `n = J alpha + omega x J omega`
/// about the centre of mass.
#[inline]
fn newton_euler<S: Scalar>(
    mass: S,
    moments: &Symmetric3<S>,
    centre: Vector3<S>,
    omega: Vector3<S>,
    drift: &Drift<S>,
) -> Wrench<S> {
    let force = drift.linear * mass;
    let moment = *moments * drift.angular + omega.cross(*moments * omega) + centre.cross(force);
    Wrench { moment, force }
}

/// What it takes to turn a rigid body at a steady rate about its frame's origin, which is let go.
#[inline]
fn turning<S: Scalar>(rigid: &RigidInertia<S>, omega: Vector3<S>, drift: &Drift<S>) -> Wrench<S> {
    Wrench { moment: omega.cross(rigid.moments * omega), force: drift.gradient * rigid.first_moment }
}

/// Kirchhoff's equations: `I a + v x* I v`.
#[inline]
fn kirchhoff<S: Scalar>(inertia: &SpatialInertia<S>, twist: &Twist<S>, rate: &Twist<S>) -> Wrench<S> {
    inertia.times(rate) + twist.cross_momentum(&inertia.times(twist))
}

/// What acts from outside: added inertia with what its drift takes, and wrenches.
#[inline]
fn load<S: Scalar>(model: &Model<S>, links: &LinkKinematics<S>, loads: &Loads<S>, work: &mut Workspace<S>) {
    for (body, added) in &loads.added_inertia {
        let body = &model.bodies[*body];
        if let Some(i) = body.link {
            let added = added.to_parent(&links.in_root[i].times(&body.in_link));
            let (twist, link) = (&links.twist[i], &mut work.links[i]);
            link.inertia = link.inertia() + added;
            link.is_rigid = false;
            link.bias += kirchhoff(&added, twist, &link.drift.spatial(links.in_root[i].position, twist));
        }
    }
    for (body, wrench) in &loads.wrenches {
        let body = &model.bodies[*body];
        if let Some(link) = body.link {
            let in_root = links.in_root[link].wrench_to_parent(&body.in_link.wrench_to_parent(wrench));
            work.links[link].bias -= in_root;
        }
    }
}

/// Hands to the parent what a link's joint lets through: articulated inertia and bias.
#[inline]
fn transmit<S: Scalar>(
    node: &Node<S>,
    axis: &Twist<S>,
    rotor_inertia: S,
    loads: &Loads<S>,
    link: &mut Articulated<S>,
    parent: Option<&mut Articulated<S>>,
) {
    if node.mode != Mode::Free {
        let given = *axis * given_acceleration(node, loads);
        let bias = link.bias + link.times(&given);
        return parent.into_iter().for_each(|parent| parent.carry(&link.inertia(), &bias));
    }
    link.gain = link.times(axis);
    link.compliance = S::ONE / (link.gain.dot(axis) + rotor_inertia);
    link.drive = loads.force[node.velocities] - link.bias.dot(axis);
    let Some(parent) = parent else { return };
    let bias = link.bias + link.gain * (link.drive * link.compliance);
    if link.is_rigid {
        parent.carry(&link.rigid.to_spatial().minus_outer(&link.gain, link.compliance), &bias);
    } else {
        parent.carry(&link.inertia.minus_outer(&link.gain, link.compliance), &bias);
    }
}

/// The acceleration of a joint that is not free.
#[inline]
fn given_acceleration<S: Scalar>(node: &Node<S>, loads: &Loads<S>) -> S {
    if node.mode == Mode::Prescribed { loads.acceleration[node.velocities] } else { S::ZERO }
}

/// Acceleration of a joint with one axis, once its parent's is known.
#[inline]
fn accelerate<S: Scalar>(
    node: &Node<S>,
    axis: &Twist<S>,
    parent: Option<&Twist<S>>,
    loads: &Loads<S>,
    link: &mut Articulated<S>,
) -> S {
    let own =
        |drive: S| if node.mode == Mode::Free { drive * link.compliance } else { given_acceleration(node, loads) };
    let Some(carried) = parent else {
        let rate = own(link.drive);
        link.response = *axis * rate;
        return rate;
    };
    let rate = own(link.drive - link.gain.dot(carried));
    link.response = *carried + *axis * rate;
    rate
}

/// A floating link, whose frame the branch is seen from.
struct Root<'a, S> {
    floating: Floating,
    node: &'a Node<S>,
    rotation: &'a Matrix3<S>,
}

impl<S: Scalar> Root<'_, S> {
    /// Its acceleration: six equations, or the three that are not held.
    #[inline]
    fn accelerate(&self, loads: &Loads<S>, link: &mut Articulated<S>, v_dot: &mut [S]) {
        let (rotation, at) = (self.rotation, self.node.velocities);
        let generalized = Wrench {
            moment: Vector3::from_slice(&loads.force[at + 3..]),
            force: rotation.transpose_times(Vector3::from_slice(&loads.force[at..])),
        };
        let (net, inertia) = (generalized - link.bias, &link.inertia);
        link.response = match (self.floating.hold_translation, self.floating.hold_rotation) {
            (false, false) => inertia.solve(&net),
            (true, false) => Twist { angular: inertia.angular.inverse() * net.moment, linear: Vector3::zero() },
            (false, true) => Twist { angular: Vector3::zero(), linear: inertia.linear.inverse() * net.force },
            (true, true) => Twist::zero(),
        };
        (*rotation * link.response.linear).write_to(&mut v_dot[at..]);
        link.response.angular.write_to(&mut v_dot[at + 3..]);
    }
}
