//! Translation along one axis, such as a telescope.

use crate::scalar::Scalar;
use crate::spatial::{Frame, Twist, Vector3};

/// A prismatic joint.
#[derive(Clone, Copy, Debug)]
pub struct Prismatic<S = f64> {
    /// The joint's frame in the parent's: child axes, origin at zero extension.
    placement: Frame<S>,
    /// Vector from the joint's origin on the child to the child's centre of mass, child axes, m.
    to_child: Vector3<S>,
    /// Child's twist per unit rate.
    twist: Twist<S>,
}

impl<S: Scalar> Prismatic<S> {
    /// Creates a prismatic joint along the unit vector `axis` (child axes).
    pub fn new(placement: Frame<S>, axis: Vector3<S>, to_child: Vector3<S>) -> Self {
        Self { placement, to_child, twist: Twist { angular: Vector3::zero(), linear: axis } }
    }

    /// Returns a copy of the joint relative to another parent frame.
    pub fn seen_from(&self, parent: &Frame<S>) -> Self {
        Self { placement: parent.times(&self.placement), ..*self }
    }

    /// Returns a copy of the joint with the child's frame moved to `to`, relative to its present pose.
    pub fn with_child_moved(&self, to: &Frame<S>) -> Self {
        let turned = |v: Vector3<S>| to.rotation.transpose_times(v);
        let placement = Frame { rotation: self.placement.rotation * to.rotation, ..self.placement };
        Self::new(placement, turned(self.twist.linear), turned(self.to_child + to.position))
    }

    /// Returns E(child/parent) at a displacement in m.
    #[inline]
    pub fn relative(&self, extension: S) -> Frame<S> {
        let position = self.placement.point(self.twist.linear * extension + self.to_child);
        Frame { rotation: self.placement.rotation, position }
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
        self.twist.linear
    }

    /// Returns the vector from the joint's origin on the child to the child's centre of mass, child axes, m.
    pub fn to_child(&self) -> Vector3<S> {
        self.to_child
    }
}
