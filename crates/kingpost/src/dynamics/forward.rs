//! Forward dynamics by recursion: accelerations from loads.
//!
//! The articulated-body algorithm (Featherstone, *Rigid Body Dynamics Algorithms*, 2008, ch. 7)
//! with prescribed joints (ch. 9), in body components, over the fused tree. It solves
//! M* q'' + N* q' = F* (eq. 61) without forming the matrices, and allocates nothing.

use super::{Kinematics, Loads};
use crate::model::{JointKind, Mode, Model, Node, joint::Floating};
use crate::scalar::Scalar;
use crate::spatial::{SpatialInertia, Twist, Vector3, Wrench};

/// Working memory of [`forward_dynamics`], by link, and what it leaves behind.
#[derive(Clone, Debug)]
pub struct Workspace<S = f64> {
    /// Articulated inertia: the link with all that hangs on it.
    inertia: Vec<SpatialInertia<S>>,
    /// Articulated bias force.
    bias: Vec<Wrench<S>>,
    /// Velocity term of the acceleration, twist x joint twist.
    drift: Vec<Twist<S>>,
    /// Articulated inertia times the joint's axis.
    gain: Vec<Wrench<S>>,
    /// Reciprocal inertia along the joint's axis, 1/kg or 1/(kg m^2).
    compliance: Vec<S>,
    /// Force along the joint's axis that is left to accelerate it.
    drive: Vec<S>,
    /// Rate of the twist, component by component.
    acceleration: Vec<Twist<S>>,
}

impl<S: Scalar> Workspace<S> {
    /// Room for a model.
    pub fn new(model: &Model<S>) -> Self {
        let n = model.links.nodes.len();
        Self {
            inertia: vec![SpatialInertia::default(); n],
            bias: vec![Wrench::zero(); n],
            drift: vec![Twist::zero(); n],
            gain: vec![Wrench::zero(); n],
            compliance: vec![S::ZERO; n],
            drive: vec![S::ZERO; n],
            acceleration: vec![Twist::zero(); n],
        }
    }

    /// The wrench that the joint of a link carries to it, in link axes about the link's origin.
    pub fn joint_wrench(&self, link: usize) -> Wrench<S> {
        self.inertia[link].times(&self.acceleration[link]) + self.bias[link]
    }
}

/// Computes the acceleration of every coordinate of v; held ones get zero, prescribed ones what
/// `loads` says. `links` is the kinematics of `model.links`.
pub fn forward_dynamics<S: Scalar>(
    model: &Model<S>,
    links: &Kinematics<S>,
    v: &[S],
    loads: &Loads<S>,
    work: &mut Workspace<S>,
    v_dot: &mut [S],
) {
    gather(model, links, loads, work);
    for i in (0..model.links.nodes.len()).rev() {
        let node = &model.links.nodes[i];
        if !matches!(node.kind, JointKind::Floating(_)) {
            carry_to_parent(i, node, links, loads, work);
        }
    }
    for (i, node) in model.links.nodes.iter().enumerate() {
        match &node.kind {
            JointKind::Floating(floating) => accelerate_floating(i, *floating, node, links, v, loads, work, v_dot),
            _ => accelerate_axis(i, node, links, loads, work, v_dot),
        }
    }
}

/// Every link by itself: inertia, velocity term (Kirchhoff's v x* I v) and outside loads.
fn gather<S: Scalar>(model: &Model<S>, links: &Kinematics<S>, loads: &Loads<S>, work: &mut Workspace<S>) {
    for (i, node) in model.links.nodes.iter().enumerate() {
        work.inertia[i] = node.inertia;
    }
    for (body, added) in &loads.added_inertia {
        if let Some(link) = model.bodies[*body].link {
            work.inertia[link] += added.to_parent(&model.bodies[*body].in_link);
        }
    }
    for (i, twist) in links.twist.iter().enumerate() {
        work.bias[i] = twist.cross_momentum(&work.inertia[i].times(twist));
        work.drift[i] = twist.cross(&links.joint_twist[i]);
    }
    for (body, wrench) in model.bodies.iter().zip(&loads.wrench) {
        if let Some(link) = body.link {
            work.bias[link] = work.bias[link] - body.in_link.wrench_to_parent(wrench);
        }
    }
}

/// Hands a link's articulated inertia and bias to its parent, as its joint transmits them.
#[inline]
fn carry_to_parent<S: Scalar>(
    i: usize,
    node: &Node<S>,
    links: &Kinematics<S>,
    loads: &Loads<S>,
    work: &mut Workspace<S>,
) {
    let Some(axis) = node.kind.axis_twist() else { return };
    let coordinate = node.velocities;
    let (inertia, bias) = if node.mode == Mode::Free {
        let gain = work.inertia[i].times(axis);
        let compliance = S::ONE / gain.dot(axis);
        let drive = loads.force[coordinate] - work.bias[i].dot(axis);
        (work.gain[i], work.compliance[i], work.drive[i]) = (gain, compliance, drive);
        let reduced = work.inertia[i].minus_outer(&gain, compliance);
        let bias = work.bias[i] + reduced.times(&work.drift[i]) + gain * (drive * compliance);
        (reduced, bias)
    } else {
        let given = work.drift[i] + *axis * given_acceleration(node, loads);
        (work.inertia[i], work.bias[i] + work.inertia[i].times(&given))
    };
    if let Some(parent) = node.parent {
        let relative = &links.relative[i];
        work.inertia[parent] += inertia.to_parent(relative);
        work.bias[parent] += relative.wrench_to_parent(&bias);
    }
}

/// The acceleration of a joint that is not free.
#[inline]
fn given_acceleration<S: Scalar>(node: &Node<S>, loads: &Loads<S>) -> S {
    if node.mode == Mode::Prescribed { loads.acceleration[node.velocities] } else { S::ZERO }
}

/// Acceleration of a joint with one axis, once its parent's is known.
#[inline]
fn accelerate_axis<S: Scalar>(
    i: usize,
    node: &Node<S>,
    links: &Kinematics<S>,
    loads: &Loads<S>,
    work: &mut Workspace<S>,
    v_dot: &mut [S],
) {
    let Some(axis) = node.kind.axis_twist() else { return };
    let carried = node.parent.map_or(Twist::zero(), |p| links.relative[i].twist_to_child(&work.acceleration[p]));
    let acceleration = carried + work.drift[i];
    let rate = if node.mode == Mode::Free {
        (work.drive[i] - work.gain[i].dot(&acceleration)) * work.compliance[i]
    } else {
        given_acceleration(node, loads)
    };
    work.acceleration[i] = acceleration + *axis * rate;
    v_dot[node.velocities] = rate;
}

/// Acceleration of a floating link: six equations, or the three that are not held.
#[allow(clippy::too_many_arguments)] // the recursion's whole context; a struct would only rename it
fn accelerate_floating<S: Scalar>(
    i: usize,
    floating: Floating,
    node: &Node<S>,
    links: &Kinematics<S>,
    v: &[S],
    loads: &Loads<S>,
    work: &mut Workspace<S>,
    v_dot: &mut [S],
) {
    let (rotation, at) = (&links.world[i].rotation, node.velocities);
    let generalized = Wrench {
        moment: Vector3::from_slice(&loads.force[at + 3..]),
        force: rotation.transpose_times(Vector3::from_slice(&loads.force[at..])),
    };
    let net = generalized - work.bias[i];
    let inertia = &work.inertia[i];
    let omega = links.twist[i].angular;
    // The world velocity's rate is R (v' + omega x v): a held centre has the linear part below.
    let turning = omega.cross(rotation.transpose_times(Vector3::from_slice(&v[at..])));
    let acceleration = match (floating.hold_translation, floating.hold_rotation) {
        (false, false) => inertia.solve(&net),
        (true, false) => {
            let moment = net.moment + inertia.coupling * turning;
            Twist { angular: inertia.angular.inverse() * moment, linear: -turning }
        }
        (false, true) => Twist { angular: Vector3::zero(), linear: inertia.linear.inverse() * net.force },
        (true, true) => Twist::zero(),
    };
    work.acceleration[i] = acceleration;
    if floating.hold_translation {
        Vector3::zero().write_to(&mut v_dot[at..]);
    } else {
        (*rotation * (acceleration.linear + turning)).write_to(&mut v_dot[at..]);
    }
    acceleration.angular.write_to(&mut v_dot[at + 3..]);
}
