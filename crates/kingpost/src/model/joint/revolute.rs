//! Rotation about one axis: the tower's slew (eq. 34) and the arm's luff (eq. 40).

use super::Mounted;
use crate::scalar::Scalar;
use crate::spatial::{Frame, Matrix3, Twist, Vector3, hat};

/// A hinge. Its relative frame connection matrix is
/// `[I, s_J][R(axis, angle), 0][I, s_C]` (before eq. 36).
#[derive(Clone, Copy, Debug)]
pub struct Revolute<S = f64> {
    /// The joint's frame in the parent's: child axes at zero angle, origin at the hinge.
    placement: Frame<S>,
    /// From the hinge to the child's centre of mass, child axes, m: the paper's s_C.
    to_child: Vector3<S>,
    /// Child's twist per unit rate.
    twist: Twist<S>,
    /// The same in parent axes about the parent's origin: a constant too.
    twist_in_parent: Twist<S>,
    /// R = constant + sin(angle) * sine + cos(angle) * cosine, from Rodrigues' formula.
    constant: Matrix3<S>,
    sine: Matrix3<S>,
    cosine: Matrix3<S>,
}

impl<S: Scalar> Revolute<S> {
    /// A hinge about the unit vector `axis` (child axes).
    pub fn new(placement: Frame<S>, axis: Vector3<S>, to_child: Vector3<S>) -> Self {
        let along = Matrix3::outer(axis, axis);
        let at_hinge = Twist { angular: axis, linear: Vector3::zero() };
        Self {
            placement,
            to_child,
            twist: Twist { angular: axis, linear: axis.cross(to_child) },
            twist_in_parent: placement.twist_to_parent(&at_hinge),
            constant: placement.rotation * along,
            sine: placement.rotation * hat(axis),
            cosine: placement.rotation * (Matrix3::identity() - along),
        }
    }

    /// The same hinge on another parent frame.
    pub fn seen_from(&self, parent: &Frame<S>) -> Self {
        Self::new(parent.times(&self.placement), self.twist.angular, self.to_child)
    }

    /// The same hinge, the child's frame moved by `offset`, child axes, m.
    pub fn with_child_moved(&self, offset: Vector3<S>) -> Self {
        Self::new(self.placement, self.twist.angular, self.to_child + offset)
    }

    /// E(child/parent) at an angle in rad.
    #[inline]
    pub fn relative(&self, angle: S) -> Frame<S> {
        let rotation = self.rotation(angle);
        Frame { rotation, position: self.placement.position + rotation * self.to_child }
    }

    /// R(child/parent) at an angle in rad.
    #[inline]
    fn rotation(&self, angle: S) -> Matrix3<S> {
        let (sin, cos) = angle.sin_cos();
        let entry = |i: usize, j: usize| self.constant.0[i][j] + self.sine.0[i][j] * sin + self.cosine.0[i][j] * cos;
        Matrix3::from_fn(entry)
    }

    /// See [`JointKind::mounted`](super::JointKind::mounted).
    #[inline]
    pub fn mounted(&self, parent: Option<&Frame<S>>, angle: S) -> Mounted<S> {
        let (turned, hinge) = (self.rotation(angle), self.placement.position);
        let (rotation, pivot, axis) = match parent {
            None => (turned, hinge, self.twist_in_parent),
            Some(parent) => {
                let (pivot, angular) = (parent.point(hinge), parent.rotation * self.twist_in_parent.angular);
                (parent.rotation * turned, pivot, Twist { angular, linear: pivot.cross(angular) })
            }
        };
        Mounted { frame: Frame { rotation, position: pivot + rotation * self.to_child }, pivot, axis }
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

    /// From the hinge to the child's centre of mass, child axes, m.
    pub fn to_child(&self) -> Vector3<S> {
        self.to_child
    }
}
