//! Accelerations of links due to their velocities alone.
//!
//! If the accelerations of all coordinates are zero, the points of a link still accelerate: towards the axes
//! of rotation, and by the Coriolis term along prismatic joints. Without this known part the recursion is
//! linear in the unknowns, and an articulated body has no velocity terms.

use crate::scalar::Scalar;
use crate::spatial::{Matrix3, Twist, Vector3, hat};

/// Acceleration of a link's points, root axes: `linear + gradient (x - origin)` at x, with the gradient `R''
/// R^T = hat(alpha) + hat(omega)^2`, the second derivative of a rotation matrix. It does not depend on linear
/// velocity.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct BiasAcceleration<S> {
    /// Angular acceleration, rad/s^2.
    pub angular: Vector3<S>,
    /// Acceleration of the origin of the link's frame, m/s^2.
    pub linear: Vector3<S>,
    /// Gradient of the acceleration, 1/s^2.
    pub gradient: Matrix3<S>,
}

/// Motion of a link that follows from velocities alone.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct LinkMotion<S> {
    /// Twist about the root's origin.
    pub twist: Twist<S>,
    /// Acceleration of the link's points for zero accelerations of all coordinates.
    pub bias_acceleration: BiasAcceleration<S>,
}

impl<S: Scalar> LinkMotion<S> {
    /// Returns the motion of a floating link; the acceleration of its origin is that of a coordinate.
    #[inline]
    pub fn floating(twist: Twist<S>) -> Self {
        let bias_acceleration = BiasAcceleration {
            angular: Vector3::zero(),
            linear: Vector3::zero(),
            gradient: centripetal(twist.angular),
        };
        Self { twist, bias_acceleration }
    }

    /// Returns the motion of a child link that rotates relative to this link with the twist `own`, about a
    /// pivot on both: `way` is the vector from this link's origin to the pivot, and `arm` from the pivot to
    /// the child's origin.
    ///
    /// `alpha = alpha_p + omega_p x omega_own`, `a = a_p + G_p way + G arm`.
    #[inline]
    pub fn turned(&self, own: &Twist<S>, way: Vector3<S>, arm: Vector3<S>) -> Self {
        let twist = self.twist + *own;
        let angular = self.bias_acceleration.angular + self.twist.angular.cross(own.angular);
        let gradient = hat(angular) + centripetal(twist.angular);
        let linear = self.bias_acceleration.linear + self.bias_acceleration.gradient * way + gradient * arm;
        Self { twist, bias_acceleration: BiasAcceleration { angular, linear, gradient } }
    }

    /// Returns the motion of a child link that slides on this link at a velocity; `way` is the vector from
    /// this link's origin to the child's.
    ///
    /// `a = a_p + G_p way + 2 omega_p x v_own`, with the Coriolis term.
    #[inline]
    pub fn slid(&self, sliding: Vector3<S>, way: Vector3<S>) -> Self {
        let own = Twist { angular: Vector3::zero(), linear: sliding };
        let coriolis = self.twist.angular.cross(sliding) * S::constant(2.0);
        let linear = self.bias_acceleration.linear + self.bias_acceleration.gradient * way + coriolis;
        Self { twist: self.twist + own, bias_acceleration: BiasAcceleration { linear, ..self.bias_acceleration } }
    }

    /// Returns the bias acceleration as the rate of the link's twist about the root's origin; `origin` is
    /// that of the link.
    #[inline]
    pub fn spatial_bias_acceleration(&self, origin: Vector3<S>) -> Twist<S> {
        let BiasAcceleration { angular, linear, gradient } = &self.bias_acceleration;
        Twist { angular: *angular, linear: *linear - *gradient * origin - self.twist.angular.cross(self.twist.linear) }
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
        // R(t) rotates at omega + alpha t; the axes of its frame are those at t = 0, where R = I.
        let (omega, alpha, h) = (Vector3::new(0.7, -1.1, 0.4), Vector3::new(-0.3, 0.2, 0.9), 1e-3);
        let turned = |t: f64| {
            let steps = 1000;
            let dt = t / f64::from(steps);
            (0..steps).fold(Matrix3::identity(), |r, k| exp((omega + alpha * (dt * (f64::from(k) + 0.5))) * dt) * r)
        };
        let second = (turned(h) + turned(-h) - Matrix3::identity().scaled(2.0)).scaled(1.0 / (h * h));
        let motion = LinkMotion {
            bias_acceleration: BiasAcceleration { angular: alpha, ..BiasAcceleration::default() },
            ..LinkMotion::default()
        };
        let own = Twist { angular: omega, linear: Vector3::zero() };
        let bias_acceleration = motion.turned(&own, Vector3::zero(), Vector3::zero()).bias_acceleration;
        // The error is of second order in h, plus rounding over h^2.
        assert!((bias_acceleration.gradient - second).0.iter().flatten().all(|x: &f64| x.abs() < 5e-6));
    }
}
