//! Rotation about one axis, such as the tower's slew (eq. 34) and the arm's luff (eq. 40).

use crate::scalar::Scalar;
use crate::spatial::{Frame, Matrix3, Twist, Vector3, hat};

/// A revolute joint. Its relative frame connection matrix is `[I, s_J][R(axis, angle), 0][I, s_C]` (before
/// eq. 36).
#[derive(Clone, Copy, Debug)]
pub struct Revolute<S = f64> {
    /// The joint's frame in the parent's: child axes at zero angle, origin at the hinge.
    placement: Frame<S>,
    /// Vector from the hinge to the child's centre of mass, child axes, m: the paper's s_C.
    to_child: Vector3<S>,
    /// Child's twist per unit rate.
    twist: Twist<S>,
    /// R = constant + sin(angle) * sine + cos(angle) * cosine, from Rodrigues' formula.
    constant: Matrix3<S>,
    sine: Matrix3<S>,
    cosine: Matrix3<S>,
}

impl<S: Scalar> Revolute<S> {
    /// Creates a revolute joint about the unit vector `axis` (child axes).
    pub fn new(placement: Frame<S>, axis: Vector3<S>, to_child: Vector3<S>) -> Self {
        let along = Matrix3::outer(axis, axis);
        Self {
            placement,
            to_child,
            twist: Twist { angular: axis, linear: axis.cross(to_child) },
            constant: placement.rotation * along,
            sine: placement.rotation * hat(axis),
            cosine: placement.rotation * (Matrix3::identity() - along),
        }
    }

    /// Returns a copy of the joint relative to another parent frame.
    pub fn seen_from(&self, parent: &Frame<S>) -> Self {
        Self::new(parent.times(&self.placement), self.twist.angular, self.to_child)
    }

    /// Returns a copy of the joint with the child's frame moved to `to`, relative to its present pose.
    pub fn with_child_moved(&self, to: &Frame<S>) -> Self {
        let turned = |v: Vector3<S>| to.rotation.transpose_times(v);
        let placement = Frame { rotation: self.placement.rotation * to.rotation, ..self.placement };
        Self::new(placement, turned(self.twist.angular), turned(self.to_child + to.position))
    }

    /// Returns E(child/parent) at an angle in rad.
    #[inline]
    pub fn relative(&self, angle: S) -> Frame<S> {
        let rotation = self.rotation(angle);
        Frame { rotation, position: self.placement.position + rotation * self.to_child }
    }

    /// Returns R(child/parent) at an angle in rad.
    #[inline]
    fn rotation(&self, angle: S) -> Matrix3<S> {
        let (sin, cos) = angle.sin_cos();
        let entry = |i: usize, j: usize| self.constant.0[i][j] + self.sine.0[i][j] * sin + self.cosine.0[i][j] * cos;
        Matrix3::from_fn(entry)
    }

    /// The joint's frame in the parent's.
    pub fn placement(&self) -> &Frame<S> {
        &self.placement
    }

    /// Child's twist per unit rate.
    #[inline]
    pub fn axis_twist(&self) -> &Twist<S> {
        &self.twist
    }

    /// Unit axis, child axes.
    pub fn axis(&self) -> Vector3<S> {
        self.twist.angular
    }

    /// Returns the vector from the hinge to the child's centre of mass, child axes, m.
    pub fn to_child(&self) -> Vector3<S> {
        self.to_child
    }
}
