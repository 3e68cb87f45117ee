//! How links accelerate by their velocities alone.
//!
//! With every coordinate's acceleration at zero, the points of a link still accelerate: towards the
//! axes that they turn about, and by Coriolis' term along slides. Splitting this known part off
//! leaves the recursion linear in what is sought, with no velocity term in any articulated body.

use crate::scalar::Scalar;
use crate::spatial::{Matrix3, Twist, Vector3, hat};

/// The acceleration of a link's points, root axes: `linear + gradient (x - origin)` at x, with the
/// gradient `R'' R^T = hat(alpha) + hat(omega)^2`, the second derivative of a rotation matrix.
/// Linear velocity does not enter.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Drift<S> {
    /// Angular acceleration, rad/s^2.
    pub angular: Vector3<S>,
    /// Of the origin of the link's frame, m/s^2.
    pub linear: Vector3<S>,
    /// 1/s^2.
    pub gradient: Matrix3<S>,
}

/// How a link moves against its parent, root axes.
pub(super) struct Relative<S> {
    /// Angular velocity, rad/s.
    pub turning: Vector3<S>,
    /// Velocity along a slide, m/s.
    pub sliding: Option<Vector3<S>>,
}

impl<S: Scalar> Drift<S> {
    /// Of a floating link that turns with `omega`: its origin's acceleration is a coordinate's.
    #[inline]
    pub fn floating(omega: Vector3<S>) -> Self {
        Self { angular: Vector3::zero(), linear: Vector3::zero(), gradient: centripetal(omega) }
    }

    /// Of a link on this parent, which turns with `omega` about its origin: `pivot` is the joint's
    /// point that moves with both, `origin` and `own` are the link's.
    #[inline]
    pub fn carry(
        &self,
        (parent_origin, omega): (Vector3<S>, Vector3<S>),
        pivot: Vector3<S>,
        relative: &Relative<S>,
        (origin, own): (Vector3<S>, Vector3<S>),
        link: &mut Self,
    ) {
        link.angular = self.angular + omega.cross(relative.turning);
        link.gradient = hat(link.angular) + centripetal(own);
        link.linear = self.linear + self.gradient * (pivot - parent_origin) + link.gradient * (origin - pivot);
        if let Some(sliding) = relative.sliding {
            link.linear += omega.cross(sliding) * S::constant(2.0);
        }
    }

    /// The same as the rate of the link's twist about the root's origin.
    #[inline]
    pub fn spatial(&self, origin: Vector3<S>, twist: &Twist<S>) -> Twist<S> {
        let linear = self.linear - self.gradient * origin - twist.angular.cross(twist.linear);
        Twist { angular: self.angular, linear }
    }
}

/// `hat(omega)^2 = omega omega^T - |omega|^2 I`.
#[inline]
fn centripetal<S: Scalar>(omega: Vector3<S>) -> Matrix3<S> {
    let [x, y, z] = omega.0;
    let (xx, yy, zz, xy, xz, yz) = (x * x, y * y, z * z, x * y, x * z, y * z);
    Matrix3([[-(yy + zz), xy, xz], [xy, -(xx + zz), yz], [xz, yz, -(xx + yy)]])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spatial::exp;

    #[test]
    fn the_gradient_is_the_second_derivative_of_a_rotation() {
        // R(t) turns at omega + alpha t; its frame's axes are taken at t = 0, where R = I.
        let (omega, alpha, h) = (Vector3::new(0.7, -1.1, 0.4), Vector3::new(-0.3, 0.2, 0.9), 1e-3);
        let turned = |t: f64| {
            let steps = 1000;
            let dt = t / f64::from(steps);
            (0..steps).fold(Matrix3::identity(), |r, k| exp((omega + alpha * (dt * (f64::from(k) + 0.5))) * dt) * r)
        };
        let second = (turned(h) + turned(-h) - Matrix3::identity().scaled(2.0)).scaled(1.0 / (h * h));
        let mut drift = Drift::default();
        let relative = Relative { turning: Vector3::zero(), sliding: None };
        let still = Drift { angular: alpha, ..Drift::default() };
        let nowhere = (Vector3::zero(), Vector3::zero());
        still.carry(nowhere, Vector3::zero(), &relative, (Vector3::zero(), omega), &mut drift);
        // Second order in h, and rounding over h^2.
        assert!((drift.gradient - second).0.iter().flatten().all(|x: &f64| x.abs() < 5e-6));
    }
}
