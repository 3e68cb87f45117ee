//! Twists and wrenches.

use super::Vector3;
use crate::scalar::Scalar;
use core::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

/// Omega of eq. 29: velocity of a body in body components, about the body's origin.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Twist<S = f64> {
    /// Angular velocity, rad/s.
    pub angular: Vector3<S>,
    /// Velocity of the origin, m/s.
    pub linear: Vector3<S>,
}

/// Moment and force in body components, about the body's origin.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wrench<S = f64> {
    /// Moment, N m.
    pub moment: Vector3<S>,
    /// Force, N.
    pub force: Vector3<S>,
}

impl<S: Scalar> Twist<S> {
    /// Returns the twist of a body at rest.
    pub const fn zero() -> Self {
        Self { angular: Vector3::zero(), linear: Vector3::zero() }
    }

    /// Returns the Lie bracket of se(3): the rate of the twist `b` that is fixed in a frame moving with
    /// `self`.
    #[inline]
    pub fn cross(&self, b: &Self) -> Self {
        Self {
            angular: self.angular.cross(b.angular),
            linear: self.angular.cross(b.linear) + self.linear.cross(b.angular),
        }
    }

    /// Returns the dual bracket: the rate of the momentum `p` that is fixed in a frame moving with `self`.
    /// For `p = I v` it is the velocity term of Kirchhoff's equations.
    #[inline]
    pub fn cross_momentum(&self, p: &Wrench<S>) -> Wrench<S> {
        Wrench { moment: self.angular.cross(p.moment) + self.linear.cross(p.force), force: self.angular.cross(p.force) }
    }
}

impl<S: Scalar> Wrench<S> {
    /// Returns the zero wrench.
    pub const fn zero() -> Self {
        Self { moment: Vector3::zero(), force: Vector3::zero() }
    }

    /// Returns the power of the wrench on a twist, W: `M . omega + F . v` (Table 1).
    #[inline]
    pub fn dot(&self, t: &Twist<S>) -> S {
        self.moment.dot(t.angular) + self.force.dot(t.linear)
    }
}

impl<S: Scalar> Add for Twist<S> {
    type Output = Self;
    #[inline]
    fn add(self, b: Self) -> Self {
        Self { angular: self.angular + b.angular, linear: self.linear + b.linear }
    }
}

impl<S: Scalar> Sub for Twist<S> {
    type Output = Self;
    #[inline]
    fn sub(self, b: Self) -> Self {
        Self { angular: self.angular - b.angular, linear: self.linear - b.linear }
    }
}

impl<S: Scalar> Mul<S> for Twist<S> {
    type Output = Self;
    #[inline]
    fn mul(self, k: S) -> Self {
        Self { angular: self.angular * k, linear: self.linear * k }
    }
}

impl<S: Scalar> Add for Wrench<S> {
    type Output = Self;
    #[inline]
    fn add(self, b: Self) -> Self {
        Self { moment: self.moment + b.moment, force: self.force + b.force }
    }
}

impl<S: Scalar> Sub for Wrench<S> {
    type Output = Self;
    #[inline]
    fn sub(self, b: Self) -> Self {
        Self { moment: self.moment - b.moment, force: self.force - b.force }
    }
}

impl<S: Scalar> Mul<S> for Wrench<S> {
    type Output = Self;
    #[inline]
    fn mul(self, k: S) -> Self {
        Self { moment: self.moment * k, force: self.force * k }
    }
}

impl<S: Scalar> Neg for Wrench<S> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { moment: -self.moment, force: -self.force }
    }
}

impl<S: Scalar> AddAssign for Wrench<S> {
    #[inline]
    fn add_assign(&mut self, b: Self) {
        *self = *self + b;
    }
}

impl<S: Scalar> SubAssign for Wrench<S> {
    #[inline]
    fn sub_assign(&mut self, b: Self) {
        *self = *self - b;
    }
}
