//! Forward dynamics by recursion: accelerations from loads.
//!
//! The articulated-body algorithm (Featherstone, *Rigid Body Dynamics Algorithms*, 2008, ch. 7)
//! with prescribed joints (ch. 9), over the fused links, in the axes of each branch's root. It
//! solves M* q'' + N* q' = F* (eq. 61) without forming the matrices, and allocates nothing.

mod response;

pub use response::Response;

use super::ball::Ball;
use super::{LinkKinematics, Loads};
use crate::model::{JointKind, Mode, Model, Node, joint::Floating};
use crate::scalar::Scalar;
use crate::spatial::{SpatialInertia, Twist, Vector3, Wrench};

/// Working memory of [`forward_dynamics`], by link, root axes.
#[derive(Clone, Debug)]
pub struct Workspace<S = f64> {
    links: Vec<Articulated<S>>,
}

/// A link with all that hangs on it.
#[derive(Clone, Copy, Debug, Default)]
struct Articulated<S> {
    /// Articulated inertia.
    inertia: SpatialInertia<S>,
    /// Articulated bias force.
    bias: Wrench<S>,
    /// Velocity term of the acceleration, twist x joint twist.
    drift: Twist<S>,
    /// Articulated inertia times the joint's axis.
    gain: Wrench<S>,
    /// Reciprocal inertia along the joint's axis, the rotor's included, 1/kg or 1/(kg m^2).
    compliance: S,
    /// Force along the joint's axis that is left to accelerate it.
    drive: S,
    /// Spatial acceleration.
    acceleration: Twist<S>,
}

impl<S: Scalar> Workspace<S> {
    /// Room for a model.
    pub fn new(model: &Model<S>) -> Self {
        Self { links: vec![Articulated::default(); model.links.nodes.len()] }
    }

    /// Inertia of a link with all that hangs on it and gives way, root axes.
    pub fn articulated_inertia(&self, link: usize) -> SpatialInertia<S> {
        self.links[link].inertia
    }

    /// Spatial acceleration of a link, root axes.
    #[inline]
    pub fn acceleration(&self, link: usize) -> &Twist<S> {
        &self.links[link].acceleration
    }

    /// The wrench that the joint of a link carries to it, about the root's origin, root axes.
    pub fn joint_wrench(&self, link: usize) -> Wrench<S> {
        let link = &self.links[link];
        link.inertia.times(&link.acceleration) + link.bias
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
    gather(model, links, v, loads, work);
    for (i, node) in model.links.nodes.iter().enumerate().rev() {
        let link = &mut work.links[i];
        let (inertia, bias) = match &node.kind {
            JointKind::Floating(_) => continue,
            JointKind::Spherical(joint) => {
                let ball = Ball::new(joint, node, &links.in_root[i]);
                ball.transmitted(&link.inertia, &link.bias, &link.drift, loads)
            }
            _ => transmitted(node, &links.axis[i], model.rotor_inertia[node.velocities], loads, link),
        };
        if let Some(parent) = node.parent {
            let parent = &mut work.links[parent];
            parent.inertia += inertia;
            parent.bias += bias;
        }
    }
    for (i, node) in model.links.nodes.iter().enumerate() {
        let (carried, link) = match node.parent {
            Some(p) => (work.links[p].acceleration, &mut work.links[i]),
            None => (Twist::zero(), &mut work.links[i]),
        };
        match &node.kind {
            JointKind::Floating(floating) => {
                let (rotation, omega) = (links.root_in_world[i].rotation, links.twist[i].angular);
                Root { floating: *floating, node, rotation, omega }.accelerate(v, loads, link, v_dot);
            }
            JointKind::Spherical(joint) => {
                let (ball, carried) = (Ball::new(joint, node, &links.in_root[i]), carried + link.drift);
                link.acceleration = ball.accelerate(&link.inertia, &link.bias, &carried, loads, v_dot);
            }
            _ => v_dot[node.velocities] = accelerate(node, &links.axis[i], carried, loads, link),
        }
    }
}

/// Every link by itself: inertia, velocity term (Kirchhoff's v x* I v) and outside loads.
#[inline]
fn gather<S: Scalar>(model: &Model<S>, links: &LinkKinematics<S>, v: &[S], loads: &Loads<S>, work: &mut Workspace<S>) {
    for (i, node) in model.links.nodes.iter().enumerate() {
        let (link, twist) = (&mut work.links[i], &links.twist[i]);
        let momentum = match &model.rigid_links[i] {
            Some(rigid) => {
                let rigid = if node.parent.is_some() { rigid.to_parent(&links.in_root[i]) } else { *rigid };
                link.inertia = rigid.to_spatial();
                rigid.times(twist)
            }
            None => {
                link.inertia = node.inertia.to_parent(&links.in_root[i]);
                link.inertia.times(twist)
            }
        };
        link.bias = twist.cross_momentum(&momentum);
        match &node.kind {
            JointKind::Floating(_) => {}
            JointKind::Spherical(joint) => {
                let ball = Ball::new(joint, node, &links.in_root[i]);
                link.drift = twist.cross(&ball.twist(&v[node.velocities..]));
            }
            _ => link.drift = twist.cross(&links.axis[i]) * v[node.velocities],
        }
    }
    for (body, added) in &loads.added_inertia {
        let body = &model.bodies[*body];
        if let Some(link) = body.link {
            let added = added.to_parent(&links.in_root[link].times(&body.in_link));
            let twist = &links.twist[link];
            work.links[link].inertia += added;
            work.links[link].bias += twist.cross_momentum(&added.times(twist));
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

/// What a link's joint lets through to the parent: articulated inertia and bias.
#[inline]
fn transmitted<S: Scalar>(
    node: &Node<S>,
    axis: &Twist<S>,
    rotor_inertia: S,
    loads: &Loads<S>,
    link: &mut Articulated<S>,
) -> (SpatialInertia<S>, Wrench<S>) {
    if node.mode != Mode::Free {
        let given = link.drift + *axis * given_acceleration(node, loads);
        return (link.inertia, link.bias + link.inertia.times(&given));
    }
    link.gain = link.inertia.times(axis);
    link.compliance = S::ONE / (link.gain.dot(axis) + rotor_inertia);
    link.drive = loads.force[node.velocities] - link.bias.dot(axis);
    let reduced = link.inertia.minus_outer(&link.gain, link.compliance);
    let bias = link.bias + reduced.times(&link.drift) + link.gain * (link.drive * link.compliance);
    (reduced, bias)
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
    carried: Twist<S>,
    loads: &Loads<S>,
    link: &mut Articulated<S>,
) -> S {
    let acceleration = carried + link.drift;
    let rate = if node.mode == Mode::Free {
        (link.drive - link.gain.dot(&acceleration)) * link.compliance
    } else {
        given_acceleration(node, loads)
    };
    link.acceleration = acceleration + *axis * rate;
    rate
}

/// A floating link, whose frame the branch is seen from.
struct Root<'a, S> {
    floating: Floating,
    node: &'a Node<S>,
    rotation: crate::spatial::Matrix3<S>,
    omega: Vector3<S>,
}

impl<S: Scalar> Root<'_, S> {
    /// Its acceleration: six equations, or the three that are not held.
    #[inline]
    fn accelerate(&self, v: &[S], loads: &Loads<S>, link: &mut Articulated<S>, v_dot: &mut [S]) {
        let (rotation, at) = (&self.rotation, self.node.velocities);
        let generalized = Wrench {
            moment: Vector3::from_slice(&loads.force[at + 3..]),
            force: rotation.transpose_times(Vector3::from_slice(&loads.force[at..])),
        };
        let net = generalized - link.bias;
        // The world velocity's rate is R (v' + omega x v): a held centre has the linear part below.
        let turning = self.omega.cross(rotation.transpose_times(Vector3::from_slice(&v[at..])));
        let inertia = &link.inertia;
        link.acceleration = match (self.floating.hold_translation, self.floating.hold_rotation) {
            (false, false) => inertia.solve(&net),
            (true, false) => {
                let moment = net.moment + inertia.coupling * turning;
                Twist { angular: inertia.angular.inverse() * moment, linear: -turning }
            }
            (false, true) => Twist { angular: Vector3::zero(), linear: inertia.linear.inverse() * net.force },
            (true, true) => Twist::zero(),
        };
        if self.floating.hold_translation {
            Vector3::zero().write_to(&mut v_dot[at..]);
        } else {
            (*rotation * (link.acceleration.linear + turning)).write_to(&mut v_dot[at..]);
        }
        link.acceleration.angular.write_to(&mut v_dot[at + 3..]);
    }
}
