//! Forward dynamics by recursion: accelerations from loads.
//!
//! The articulated-body algorithm (Featherstone, *Rigid Body Dynamics Algorithms*, 2008, ch. 7) with
//! prescribed joints (ch. 9), over the links, in the axes of each branch's root. It solves M* q'' + N* q' =
//! F* (eq. 61) without forming the matrices, and allocates nothing.
//!
//! The velocity part of every link's acceleration, its bias acceleration, is known from the
//! [`LinkKinematics`]. Its force (N* q') is added to the loads, and the recursion computes the rest: `a =
//! bias + fall + response`, with the response linear in q''. Under gravity all links have the acceleration of
//! free fall in common: relative to it, links have no weight.

mod articulated;
mod coupled_roots;
mod response;
mod root;

pub use response::Response;

use super::ball::Ball;
use super::{LinkKinematics, Loads};
use crate::model::{Carrier, Link, LinkJoint, Model, MotionType};
use crate::scalar::Scalar;
use crate::spatial::{SpatialInertia, Twist, Vector3, Wrench};
use articulated::Articulated;
use coupled_roots::CoupledRoots;

/// Working memory of [`forward_dynamics`], by link, root axes.
#[derive(Clone, Debug)]
pub struct Workspace<S = f64> {
    links: Vec<Articulated<S>>,
    /// Acceleration of free fall in root axes, by root, m/s^2.
    fall: Vec<Vector3<S>>,
    /// Whether there is gravity.
    has_fall: bool,
    /// Root of each link's branch.
    roots: Vec<usize>,
    /// Roots whose accelerations are found together.
    coupled: CoupledRoots<S>,
    /// Their accelerations.
    found: Vec<S>,
}

impl<S: Scalar> Workspace<S> {
    /// Allocates the memory for a model.
    pub fn new(model: &Model<S>) -> Self {
        let n = model.plan.len();
        let (links, fall) = (vec![Articulated::default(); n], vec![Vector3::zero(); n]);
        let (roots, coupled) = (model.roots.clone(), CoupledRoots::new());
        Self { links, fall, has_fall: false, roots, coupled, found: Vec::new() }
    }

    /// Returns the articulated inertia of a link with its subtree, root axes.
    pub fn articulated_inertia(&self, links: &LinkKinematics<S>, link: usize) -> SpatialInertia<S> {
        self.links[link].inertia(&links.moving()[link])
    }

    /// Returns the spatial acceleration of a link, root axes.
    #[inline]
    pub fn acceleration(&self, links: &LinkKinematics<S>, link: usize) -> Twist<S> {
        let fall = Twist { angular: Vector3::zero(), linear: self.fall[self.roots[link]] };
        links.moving()[link].spatial_bias_acceleration() + fall + self.links[link].response
    }

    /// Returns the wrench that the joint transmits to a link, about the root's origin, root axes.
    pub fn joint_wrench(&self, links: &LinkKinematics<S>, link: usize) -> Wrench<S> {
        let Articulated { response, bias, .. } = &self.links[link];
        self.articulated_inertia(links, link).times(response) + *bias
    }
}

/// Computes the acceleration of every coordinate of v; it is zero for held ones, and that in `loads` for
/// prescribed ones. `links` must be the kinematics for the present velocities.
pub fn forward_dynamics<S: Scalar>(
    model: &Model<S>,
    links: &LinkKinematics<S>,
    loads: &Loads<S>,
    work: &mut Workspace<S>,
    v_dot: &mut [S],
) {
    link_inertias_and_loads(model, links, loads, work);
    articulated_inertia_pass(model, links, loads, work);
    coupled_root_pass(model, links, loads, work);
    acceleration_pass(model, links, loads, work, v_dot);
}

/// Computes inertia and bias force of each link, with the external loads on it.
#[inline]
fn link_inertias_and_loads<S: Scalar>(
    model: &Model<S>,
    links: &LinkKinematics<S>,
    loads: &Loads<S>,
    work: &mut Workspace<S>,
) {
    for (link, moving) in work.links.iter_mut().zip(links.moving()) {
        (link.has_more, link.bias) = (false, moving.bias);
    }
    for (i, full) in links.full() {
        work.links[*i].carry(full);
    }
    fall_freely(model, links, loads.gravity, work);
    for (body, added) in &loads.added_inertia {
        let body = &model.bodies[*body];
        if let Some(i) = body.link {
            let (link, moving) = (&mut work.links[i], &links.moving()[i]);
            let added = added.to_parent(&moving.in_root.times(&body.in_link));
            link.carry(&added);
            let fall = Twist { angular: Vector3::zero(), linear: work.fall[work.roots[i]] };
            link.bias += moving.kirchhoff(&added) + added.times(&fall);
        }
    }
    work.coupled.take(model, links, loads);
    work.coupled.add_bias(links.moving(), &work.fall, &mut work.links);
    for (body, wrench) in &loads.wrenches {
        let body = &model.bodies[*body];
        if let Some(i) = body.link {
            let in_link = body.in_link.wrench_to_parent(wrench);
            work.links[i].bias -= links.in_root(i).wrench_to_parent(&in_link);
        }
    }
}

/// Transforms the acceleration of free fall g to the axes of each root. A link whose inertia I contains added
/// mass in addition to its mass m would fall with the force `I g`: the difference from its weight is added to
/// its bias.
#[inline]
fn fall_freely<S: Scalar>(
    model: &Model<S>,
    links: &LinkKinematics<S>,
    gravity: Option<Vector3<S>>,
    work: &mut Workspace<S>,
) {
    if gravity.is_none() && work.has_fall {
        work.fall.fill(Vector3::zero());
    }
    work.has_fall = gravity.is_some();
    let Some(gravity) = gravity else { return };
    for (i, (plan, moving)) in model.plan.iter().zip(links.moving()).enumerate() {
        if plan.carrier == Carrier::World {
            work.fall[i] = links.root_in_world(i).rotation.transpose_times(gravity);
        }
        if !plan.falls {
            let fall = work.fall[work.roots[i]];
            let taken = work.links[i].inertia(moving).times(&Twist { angular: Vector3::zero(), linear: fall });
            let centred = moving.in_root.position * plan.mass + moving.in_root.rotation * plan.first_moment;
            let weight = Wrench { moment: centred.cross(fall), force: fall * plan.mass };
            work.links[i].bias += taken - weight;
        }
    }
}

/// Computes articulated inertias and bias forces, from the ends of the branches to their roots (Featherstone,
/// *Rigid Body Dynamics Algorithms*, 2008, sec. 7.3, second pass).
#[inline]
fn articulated_inertia_pass<S: Scalar>(
    model: &Model<S>,
    links: &LinkKinematics<S>,
    loads: &Loads<S>,
    work: &mut Workspace<S>,
) {
    for (i, (plan, moving)) in model.plan.iter().zip(links.moving()).enumerate().rev() {
        let (before, rest) = work.links.split_at_mut(i);
        let (link, parent) = (&mut rest[0], plan.parent().map(|p| &mut before[p]));
        match plan.joint {
            LinkJoint::Floating => {}
            LinkJoint::Spherical => {
                if let Some(parent) = parent {
                    let (inertia, bias) =
                        Ball::new(plan, &moving.in_root).transmitted(&link.inertia(moving), &link.bias, &loads.force);
                    parent.carry(&inertia);
                    parent.bias += bias;
                }
            }
            LinkJoint::Revolute | LinkJoint::Prismatic if plan.mode == MotionType::Free => {
                let (force, rotor) = (loads.force[plan.velocities], model.rotor_inertia[plan.velocities]);
                link.project_articulated_inertia(moving, force, rotor, parent);
            }
            LinkJoint::Revolute | LinkJoint::Prismatic => {
                if let Some(parent) = parent {
                    let (inertia, given) = (link.inertia(moving), moving.axis * given_acceleration(plan, loads));
                    parent.carry(&inertia);
                    parent.bias += link.bias + inertia.times(&given);
                }
            }
        }
    }
}

/// Computes the accelerations of roots with inertia between them. Afterwards the bias force of each contains the reaction
/// from the others.
#[inline]
fn coupled_root_pass<S: Scalar>(
    model: &Model<S>,
    links: &LinkKinematics<S>,
    loads: &Loads<S>,
    work: &mut Workspace<S>,
) {
    if work.coupled.is_empty() {
        return;
    }
    let Workspace { links: of_links, coupled, found, .. } = work;
    coupled.factor(links.moving(), of_links);
    let net = |root: usize| {
        let (at, rotation) = (model.plan[root].velocities, &links.root_in_world(root).rotation);
        root::force(&loads.force[at..], rotation) - of_links[root].bias
    };
    coupled.solve(net, found);
    coupled.accelerations(found).for_each(|(root, acceleration)| of_links[root].response = acceleration);
    coupled.reactions(found).for_each(|(root, reaction)| of_links[root].bias += reaction);
}

/// Computes accelerations, from the roots outward (Featherstone, sec. 7.3, third pass).
#[inline]
fn acceleration_pass<S: Scalar>(
    model: &Model<S>,
    links: &LinkKinematics<S>,
    loads: &Loads<S>,
    work: &mut Workspace<S>,
    v_dot: &mut [S],
) {
    for (i, (plan, moving)) in model.plan.iter().zip(links.moving()).enumerate() {
        let (before, rest) = work.links.split_at_mut(i);
        let link = &mut rest[0];
        let fall = &work.fall;
        let carried = || match plan.parent() {
            Some(p) => before[p].response,
            None => Twist { angular: Vector3::zero(), linear: -fall[i] },
        };
        match plan.joint {
            LinkJoint::Floating => {
                let (at, rotation) = (plan.velocities, &links.root_in_world(i).rotation);
                if work.coupled.place(i).is_none() {
                    let net = root::force(&loads.force[at..], rotation) - link.bias;
                    link.response = root::accelerate(plan.floating, &link.inertia(moving), &net, fall[i]);
                }
                root::write(&link.response, fall[i], rotation, &mut v_dot[at..]);
            }
            LinkJoint::Spherical => {
                let ball = Ball::new(plan, &moving.in_root);
                link.response = ball.accelerate(&link.inertia(moving), &link.bias, &carried(), &loads.force, v_dot);
            }
            LinkJoint::Revolute | LinkJoint::Prismatic => {
                let carried = carried();
                let rate = match plan.mode {
                    MotionType::Free => (link.drive - link.gain.dot(&carried)) * link.compliance,
                    _ => given_acceleration(plan, loads),
                };
                link.response = carried + moving.axis * rate;
                v_dot[plan.velocities] = rate;
            }
        }
    }
}

/// Returns the acceleration of a joint that is not free.
#[inline]
fn given_acceleration<S: Scalar>(plan: &Link<S>, loads: &Loads<S>) -> S {
    if plan.mode == MotionType::Prescribed { loads.acceleration[plan.velocities] } else { S::ZERO }
}
