//! Rotation about a point, such as a load on its hook or a ball in its socket.

use super::Columns;
use crate::scalar::Scalar;
use crate::spatial::{Frame, Quaternion, Twist, Vector3, dexp_inverse_body};

/// A ball joint. q: unit quaternion (w, x, y, z) from child axes to those of the placement. v: angular
/// velocity relative to the parent in child axes, rad/s. Only all three rotations together can be held.
#[derive(Clone, Copy, Debug)]
pub struct Spherical<S = f64> {
    /// The joint's frame in the parent's: child axes at no rotation, origin at the ball.
    placement: Frame<S>,
    /// Vector from the ball to the child's centre of mass, child axes, m.
    to_child: Vector3<S>,
}

impl<S: Scalar> Spherical<S> {
    /// Names of the three coordinates of v: body rates, which are not derivatives of angles.
    pub const LABELS: [&'static str; 3] = ["x", "y", "z"];

    /// Creates a ball joint at `placement` in the parent's frame; `to_child` is the vector to the child's
    /// centre of mass.
    pub fn new(placement: Frame<S>, to_child: Vector3<S>) -> Self {
        Self { placement, to_child }
    }

    /// Returns a copy of the joint relative to another parent frame.
    pub fn seen_from(&self, parent: &Frame<S>) -> Self {
        Self { placement: parent.times(&self.placement), ..*self }
    }

    /// Returns a copy of the joint with the child's frame moved by `offset`, child axes, m.
    pub fn with_child_moved(&self, offset: Vector3<S>) -> Self {
        Self { to_child: self.to_child + offset, ..*self }
    }

    /// E(child/parent) at a unit quaternion.
    pub fn relative(&self, q: &[S]) -> Frame<S> {
        let rotation = self.placement.rotation * Quaternion::from_slice(q).to_matrix();
        Frame { rotation, position: self.placement.position + rotation * self.to_child }
    }

    /// Returns the child's twists per unit rate about each of its axes; they are constant in these axes.
    pub fn columns(&self) -> Columns<S> {
        let unit = |k: usize| {
            let mut angular = Vector3::zero();
            angular[k] = S::ONE;
            Twist { angular, linear: angular.cross(self.to_child) }
        };
        Columns::of(&[unit(0), unit(1), unit(2)])
    }

    /// The joint's frame in the parent's.
    pub fn placement(&self) -> &Frame<S> {
        &self.placement
    }

    /// Returns the vector from the ball to the child's centre of mass, child axes, m.
    #[inline]
    pub fn to_child(&self) -> Vector3<S> {
        self.to_child
    }

    /// Multiplies the rotation by the exponential of the local rotation vector.
    #[inline]
    pub fn retract(q: &[S], xi: &[S], out: &mut [S]) {
        let turned = Quaternion::from_slice(q).times(Quaternion::exp(Vector3::from_slice(xi))).normalized();
        out[..4].copy_from_slice(&turned.0);
    }

    /// Rate of the local rotation vector.
    #[inline]
    pub fn dexp_inverse(xi: &[S], v: &[S], out: &mut [S]) {
        dexp_inverse_body(Vector3::from_slice(xi), Vector3::from_slice(v)).write_to(out);
    }
}
