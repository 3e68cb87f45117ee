//! Spherical joint in the recursion: three equations about the ball.
//!
//! About the ball the joint's axes are `S = [I; 0]`, so the joint transmits only a force: with the
//! articulated inertia `[J, C; C^T, L]` about the ball, it transmits only `L - C^T J^-1 C` (Featherstone
//! 2008, sec. 7.2, with S about the joint).

use crate::model::{Link, MotionType};
use crate::scalar::Scalar;
use crate::spatial::{Frame, SpatialInertia, Symmetric3, Twist, Vector3, Wrench};

/// A link with a ball joint, root axes.
pub(super) struct Ball<'a, S> {
    plan: &'a Link<S>,
    /// Frame of the link in its root's frame.
    in_root: &'a Frame<S>,
    /// Vector from the root's origin to the ball, m.
    position: Vector3<S>,
}

impl<'a, S: Scalar> Ball<'a, S> {
    pub(super) fn new(plan: &'a Link<S>, in_root: &'a Frame<S>) -> Self {
        Self { plan, in_root, position: in_root.point(-plan.to_child) }
    }

    /// Returns the twist about the root's origin for a rate, or the derivative of a rate, in child axes.
    pub(super) fn twist(&self, rate: &[S]) -> Twist<S> {
        let angular = self.in_root.rotation * Vector3::from_slice(rate);
        Twist { angular, linear: self.position.cross(angular) }
    }

    /// Returns the twists for a unit rate about each axis of the child.
    pub(super) fn axes(&self) -> [Twist<S>; 3] {
        core::array::from_fn(|k| {
            let mut rate = [S::ZERO; 3];
            rate[k] = S::ONE;
            self.twist(&rate)
        })
    }

    /// Returns the articulated inertia and bias that the ball transmits to the parent.
    pub(super) fn transmitted(
        &self,
        inertia: &SpatialInertia<S>,
        bias: &Wrench<S>,
        force: &[S],
    ) -> (SpatialInertia<S>, Wrench<S>) {
        if self.plan.mode != MotionType::Free {
            return (*inertia, *bias);
        }
        let to_ball = Frame::translation(-self.position);
        let (about_ball, bias) = (inertia.to_parent(&to_ball), to_ball.wrench_to_parent(bias));
        let (applied, inverse) = (self.moment(force), about_ball.angular.inverse());
        let yielding = about_ball.coupling.transpose() * (inverse.to_matrix() * about_ball.coupling);
        let linear = Symmetric3::from_upper(&(about_ball.linear.to_matrix() - yielding));
        let reduced = SpatialInertia { linear, ..SpatialInertia::default() };
        let push = bias.force + about_ball.coupling.transpose_times(inverse * (applied - bias.moment));
        let from_ball = Frame::translation(self.position);
        let reduced = reduced.to_parent(&from_ball);
        let carried = from_ball.wrench_to_parent(&Wrench { moment: applied, force: push });
        (reduced, carried)
    }

    /// Returns the moment that is applied in the joint, from the loads along all coordinates.
    fn moment(&self, force: &[S]) -> Vector3<S> {
        self.in_root.rotation * Vector3::from_slice(&force[self.plan.velocities..])
    }

    /// Returns the acceleration of the link, from `carried`, which is that of the parent plus the velocity
    /// terms; writes the accelerations of the joint's coordinates.
    pub(super) fn accelerate(
        &self,
        inertia: &SpatialInertia<S>,
        bias: &Wrench<S>,
        carried: &Twist<S>,
        force: &[S],
        v_dot: &mut [S],
    ) -> Twist<S> {
        self.accelerate_under(self.moment(force), inertia, bias, carried, v_dot)
    }

    /// Returns the acceleration of the link under a moment applied in the joint, root axes; writes the
    /// accelerations of the joint's coordinates.
    fn accelerate_under(
        &self,
        applied: Vector3<S>,
        inertia: &SpatialInertia<S>,
        bias: &Wrench<S>,
        carried: &Twist<S>,
        v_dot: &mut [S],
    ) -> Twist<S> {
        let to_ball = Frame::translation(-self.position);
        let load = inertia.times(carried) + *bias;
        let missing = applied - to_ball.wrench_to_parent(&load).moment;
        let rate = if self.plan.mode == MotionType::Free {
            inertia.to_parent(&to_ball).angular.inverse() * missing
        } else {
            Vector3::zero()
        };
        let in_child = self.in_root.rotation.transpose_times(rate);
        in_child.write_to(&mut v_dot[self.plan.velocities..]);
        *carried + self.twist(&in_child.0)
    }

    /// Returns the part of a bias that the ball transmits, without velocities and other loads.
    pub(super) fn passes(&self, inertia: &SpatialInertia<S>, bias: &Wrench<S>) -> Wrench<S> {
        if self.plan.mode != MotionType::Free {
            return *bias;
        }
        let to_ball = Frame::translation(-self.position);
        let (about_ball, bias) = (inertia.to_parent(&to_ball), to_ball.wrench_to_parent(bias));
        let yielding = about_ball.coupling.transpose_times(about_ball.angular.inverse() * bias.moment);
        let force = bias.force - yielding;
        Frame::translation(self.position).wrench_to_parent(&Wrench { moment: Vector3::zero(), force })
    }

    /// Returns the acceleration due to a bias alone; writes the accelerations of the joint's coordinates.
    pub(super) fn respond(
        &self,
        inertia: &SpatialInertia<S>,
        bias: &Wrench<S>,
        carried: &Twist<S>,
        rates: &mut [S],
    ) -> Twist<S> {
        self.accelerate_under(Vector3::zero(), inertia, bias, carried, rates)
    }
}
