//! Frame connections: the group SE(3).

use super::{Matrix3, Twist, Vector3, Wrench};
use crate::scalar::Scalar;

/// A frame connection matrix E (eq. 20, absolute; eq. 24, relative): the position and rotation of a frame relative to
/// its parent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame<S = f64> {
    /// R: converts child components to parent components.
    pub rotation: Matrix3<S>,
    /// Origin of the child in parent components, m.
    pub position: Vector3<S>,
}

impl<S: Scalar> Default for Frame<S> {
    fn default() -> Self {
        Self::identity()
    }
}

impl<S: Scalar> Frame<S> {
    /// Returns the frame of a child that coincides with its parent.
    pub const fn identity() -> Self {
        Self { rotation: Matrix3::identity(), position: Vector3::zero() }
    }

    /// Returns a translation without rotation ("translate, do not rotate").
    pub fn translation(position: Vector3<S>) -> Self {
        Self { rotation: Matrix3::identity(), position }
    }

    /// Returns the product of frame connection matrices (eq. 26): `E(b seen from the parent) = self * b`.
    #[inline]
    pub fn times(&self, b: &Self) -> Self {
        Self { rotation: self.rotation * b.rotation, position: self.position + self.rotation * b.position }
    }

    /// Returns the group inverse (eq. 22).
    #[inline]
    pub fn inverse(&self) -> Self {
        let rotation = self.rotation.transpose();
        Self { rotation, position: -(rotation * self.position) }
    }

    /// Returns a point of the child in parent components, m.
    #[inline]
    pub fn point(&self, p: Vector3<S>) -> Vector3<S> {
        self.position + self.rotation * p
    }

    /// Returns the twist of a child that is fixed to the parent (the first terms of eqs. 36-37): about the
    /// child's origin, in child components.
    #[inline]
    pub fn twist_to_child(&self, parent: &Twist<S>) -> Twist<S> {
        let linear = parent.linear + parent.angular.cross(self.position);
        Twist { angular: self.rotation.transpose_times(parent.angular), linear: self.rotation.transpose_times(linear) }
    }

    /// Converts a twist about the child's origin in child components to one about the parent's origin in
    /// parent components.
    #[inline]
    pub fn twist_to_parent(&self, child: &Twist<S>) -> Twist<S> {
        let angular = self.rotation * child.angular;
        Twist { angular, linear: self.rotation * child.linear + self.position.cross(angular) }
    }

    /// Converts a wrench about the child's origin in child components to one about the parent's origin in
    /// parent components: the dual of [`Frame::twist_to_child`].
    #[inline]
    pub fn wrench_to_parent(&self, child: &Wrench<S>) -> Wrench<S> {
        let force = self.rotation * child.force;
        Wrench { moment: self.rotation * child.moment + self.position.cross(force), force }
    }

    /// Returns the inverse of [`Frame::wrench_to_parent`].
    #[inline]
    pub fn wrench_to_child(&self, parent: &Wrench<S>) -> Wrench<S> {
        let moment = parent.moment - self.position.cross(parent.force);
        Wrench { moment: self.rotation.transpose_times(moment), force: self.rotation.transpose_times(parent.force) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spatial::exp;

    #[test]
    fn power_is_the_same_in_both_frames() {
        let e = Frame { rotation: exp(Vector3::new(0.4, -0.7, 1.1)), position: Vector3::new(1.0, 2.0, -0.5) };
        let twist = Twist { angular: Vector3::new(0.2, 0.5, -0.3), linear: Vector3::new(1.0, -2.0, 0.7) };
        let wrench = Wrench { moment: Vector3::new(3.0, 1.0, 2.0), force: Vector3::new(-4.0, 0.5, 1.5) };
        let (child, parent): (f64, f64) =
            (wrench.dot(&e.twist_to_child(&twist)), e.wrench_to_parent(&wrench).dot(&twist));
        assert!((child - parent).abs() < 1e-13);
        let there = e.twist_to_parent(&e.twist_to_child(&twist)) - twist;
        assert!(there.angular.norm() + there.linear.norm() < 1e-14);
        let back = e.wrench_to_child(&e.wrench_to_parent(&wrench));
        assert!((back.moment - wrench.moment).norm() + (back.force - wrench.force).norm() < 1e-13);
    }

    #[test]
    fn the_inverse_frame_cancels_the_frame() {
        let e = Frame { rotation: exp(Vector3::new(0.4, -0.7, 1.1)), position: Vector3::new(1.0, 2.0, -0.5) };
        let i = e.times(&e.inverse());
        assert!(i.position.norm() < 1e-15 && (i.rotation.0[0][0] - 1.0_f64).abs() < 1e-15);
    }
}
