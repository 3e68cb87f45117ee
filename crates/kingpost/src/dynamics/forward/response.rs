//! What wrenches on links alone make of the accelerations: M^-1 times a column of J^T.
//!
//! The second half of the recursion once more, without velocities and other loads, over the
//! articulated inertias that [`forward_dynamics`](super::forward_dynamics) left behind. It is linear
//! in the wrenches, so that responses add to the accelerations that stand.

use super::Workspace;
use crate::dynamics::LinkKinematics;
use crate::dynamics::ball::Ball;
use crate::model::{JointKind, Mode, Model, joint::Floating};
use crate::scalar::Scalar;
use crate::spatial::{SpatialInertia, Twist, Vector3, Wrench};

/// Wrenches and the accelerations that they make, root axes.
#[derive(Clone, Debug)]
pub struct Response<S = f64> {
    /// By link: less the wrench, with what comes down the branch.
    bias: Vec<Wrench<S>>,
    /// By link.
    acceleration: Vec<Twist<S>>,
    /// By coordinate of v.
    rates: Vec<S>,
}

impl<S: Scalar> Response<S> {
    /// Room for a model.
    pub fn new(model: &Model<S>) -> Self {
        let n = model.links.nodes.len();
        Self {
            bias: vec![Wrench::zero(); n],
            acceleration: vec![Twist::zero(); n],
            rates: vec![S::ZERO; model.velocity_count],
        }
    }

    /// Takes all wrenches off.
    pub fn clear(&mut self) {
        self.bias.fill(Wrench::zero());
    }

    /// Puts a wrench on a link, about its root's origin in root axes; on the world it does nothing.
    #[inline]
    pub fn add(&mut self, link: Option<usize>, wrench: &Wrench<S>) {
        if let Some(link) = link {
            self.bias[link] -= *wrench;
        }
    }

    /// Computes the response of all links.
    pub fn update(&mut self, model: &Model<S>, links: &LinkKinematics<S>, work: &Workspace<S>) {
        for (i, node) in model.links.nodes.iter().enumerate().rev() {
            let Some(parent) = node.parent else { continue };
            let (link, bias) = (&work.links[i], self.bias[i]);
            let passed = match &node.kind {
                JointKind::Spherical(joint) => Ball::new(joint, node, &links.in_root[i]).passes(&link.inertia, &bias),
                _ if node.mode == Mode::Free => bias - link.gain * (bias.dot(&links.axis[i]) * link.compliance),
                _ => bias,
            };
            self.bias[parent] += passed;
        }
        for (i, node) in model.links.nodes.iter().enumerate() {
            let carried = node.parent.map_or(Twist::zero(), |p| self.acceleration[p]);
            let (link, bias, at) = (&work.links[i], &self.bias[i], node.velocities);
            self.acceleration[i] = match &node.kind {
                JointKind::Floating(floating) => {
                    let twist = float(floating, &link.inertia, &-*bias);
                    (links.root_in_world[i].rotation * twist.linear).write_to(&mut self.rates[at..]);
                    twist.angular.write_to(&mut self.rates[at + 3..]);
                    twist
                }
                JointKind::Spherical(joint) => {
                    let ball = Ball::new(joint, node, &links.in_root[i]);
                    ball.respond(&link.inertia, bias, &carried, &mut self.rates)
                }
                _ => {
                    let free = -(bias.dot(&links.axis[i]) + link.gain.dot(&carried)) * link.compliance;
                    self.rates[at] = if node.mode == Mode::Free { free } else { S::ZERO };
                    carried + links.axis[i] * self.rates[at]
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

    /// Adds the response to what [`forward_dynamics`](super::forward_dynamics) left, so that the
    /// joints carry it too.
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

/// The acceleration of a floating link: six equations, or the three that are not held.
fn float<S: Scalar>(floating: &Floating, inertia: &SpatialInertia<S>, net: &Wrench<S>) -> Twist<S> {
    let still = Vector3::zero();
    match (floating.hold_translation, floating.hold_rotation) {
        (false, false) => inertia.solve(net),
        (true, false) => Twist { angular: inertia.angular.inverse() * net.moment, linear: still },
        (false, true) => Twist { angular: still, linear: inertia.linear.inverse() * net.force },
        (true, true) => Twist::zero(),
    }
}
