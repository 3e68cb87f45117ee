//! The accelerations due to wrenches on links and loads along joints: M*^-1 times a column of J^T.
//!
//! The second half of the recursion once more, without velocities and other loads, with the articulated inertias of the
//! last [`forward_dynamics`](super::forward_dynamics). It is linear in the wrenches, so responses can be added to the
//! accelerations.

use super::{Workspace, root};
use crate::dynamics::LinkKinematics;
use crate::dynamics::ball::Ball;
use crate::model::{LinkJoint, Model, MotionType};
use crate::scalar::Scalar;
use crate::spatial::{Twist, Vector3, Wrench};

/// Wrenches and the accelerations due to them, root axes.
#[derive(Clone, Debug)]
pub struct Response<S = f64> {
    /// By link: minus the wrench, including that from the rest of the branch.
    bias: Vec<Wrench<S>>,
    /// Loads along the axes of joints, by coordinate of v.
    force: Vec<S>,
    /// Acceleration by link.
    acceleration: Vec<Twist<S>>,
    /// Acceleration by coordinate of v.
    rates: Vec<S>,
    /// Accelerations of the coupled roots.
    found: Vec<S>,
}

impl<S: Scalar> Response<S> {
    /// Room for a model.
    pub fn new(model: &Model<S>) -> Self {
        let n = model.plan.len();
        Self {
            bias: vec![Wrench::zero(); n],
            force: vec![S::ZERO; model.velocity_count],
            acceleration: vec![Twist::zero(); n],
            rates: vec![S::ZERO; model.velocity_count],
            found: Vec::new(),
        }
    }

    /// Removes all wrenches and loads.
    pub fn clear(&mut self) {
        self.bias.fill(Wrench::zero());
        self.force.fill(S::ZERO);
    }

    /// Adds a load along the coordinate of a joint with one axis, with its reaction on the parent.
    #[inline]
    pub fn add_along(&mut self, coordinate: usize, load: S) {
        self.force[coordinate] += load;
    }

    /// Adds a wrench on a link, about its root's origin in root axes; on the world it has no effect.
    #[inline]
    pub fn add(&mut self, link: Option<usize>, wrench: &Wrench<S>) {
        if let Some(link) = link {
            self.bias[link] -= *wrench;
        }
    }

    /// Computes the response of all links.
    pub fn update(&mut self, model: &Model<S>, links: &LinkKinematics<S>, work: &Workspace<S>) {
        let plan = || model.plan.iter().zip(links.moving()).enumerate();
        for (i, (plan, moving)) in plan().rev() {
            let Some(parent) = plan.parent() else { continue };
            let (link, bias) = (&work.links[i], self.bias[i]);
            let passed = match plan.joint {
                LinkJoint::Spherical => Ball::new(plan, &moving.in_root).passes(&link.inertia(moving), &bias),
                _ if plan.mode == MotionType::Free => {
                    let drive = self.force[plan.velocities] - bias.dot(&moving.axis);
                    bias + link.gain * (drive * link.compliance)
                }
                _ => bias,
            };
            self.bias[parent] += passed;
        }
        if !work.coupled.is_empty() {
            let Self { bias, acceleration, found, .. } = self;
            work.coupled.solve(|root| -bias[root], found);
            work.coupled.accelerations(found).for_each(|(root, of_root)| acceleration[root] = of_root);
            work.coupled.reactions(found).for_each(|(root, reaction)| bias[root] += reaction);
        }
        for (i, (plan, moving)) in plan() {
            let carried = plan.parent().map_or(Twist::zero(), |p| self.acceleration[p]);
            let (link, bias, at) = (&work.links[i], &self.bias[i], plan.velocities);
            self.acceleration[i] = match plan.joint {
                LinkJoint::Floating => {
                    let twist = match work.coupled.place(i) {
                        Some(_) => self.acceleration[i],
                        None => root::accelerate(plan.floating, &link.inertia(moving), &-*bias, Vector3::zero()),
                    };
                    root::write(&twist, Vector3::zero(), &links.root_in_world(i).rotation, &mut self.rates[at..]);
                    twist
                }
                LinkJoint::Spherical => {
                    let ball = Ball::new(plan, &moving.in_root);
                    ball.respond(&link.inertia(moving), bias, &carried, &mut self.rates)
                }
                LinkJoint::Revolute | LinkJoint::Prismatic => {
                    let drive = self.force[at] - bias.dot(&moving.axis);
                    let free = (drive - link.gain.dot(&carried)) * link.compliance;
                    self.rates[at] = if plan.mode == MotionType::Free { free } else { S::ZERO };
                    carried + moving.axis * self.rates[at]
                }
            };
        }
    }

    /// Acceleration of a link.
    #[inline]
    pub fn acceleration(&self, link: usize) -> &Twist<S> {
        &self.acceleration[link]
    }

    /// Accelerations of the coordinates of v.
    pub fn rates(&self) -> &[S] {
        &self.rates
    }

    /// Adds the response to the results of [`forward_dynamics`](super::forward_dynamics), so that the joint loads
    /// contain it.
    pub fn add_to(&self, work: &mut Workspace<S>, v_dot: &mut [S]) {
        for ((link, bias), acceleration) in work.links.iter_mut().zip(&self.bias).zip(&self.acceleration) {
            link.bias += *bias;
            link.response = link.response + *acceleration;
        }
        for (v_dot, rate) in v_dot.iter_mut().zip(&self.rates) {
            *v_dot += *rate;
        }
    }
}
