//! Rotation about two perpendicular axes, such as a Cardan joint or a hook in its block.

use super::{AxisList, ElementaryAxis};
use crate::scalar::Scalar;
use crate::spatial::{Frame, Vector3};

impl<S: Scalar> AxisList<S> {
    /// Returns a joint that rotates about the unit vector `first`, fixed in the parent, then about the unit
    /// vector `second`, fixed in the child: coordinates `first` and `second`, rad. Both vectors are
    /// perpendicular, and given in child axes at angle 0.
    pub fn universal(placement: Frame<S>, first: Vector3<S>, second: Vector3<S>, to_child: Vector3<S>) -> Self {
        let axes = [ElementaryAxis::rotation(first), ElementaryAxis::rotation(second)];
        Self::new(placement, &axes, &["first", "second"], to_child)
    }
}
