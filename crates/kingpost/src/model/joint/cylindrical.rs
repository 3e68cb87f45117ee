//! Rotation about and translation along one axis: the rod of a hydraulic cylinder.

use super::{AxisList, ElementaryAxis};
use crate::scalar::Scalar;
use crate::spatial::{Frame, Vector3};

impl<S: Scalar> AxisList<S> {
    /// Returns a joint that rotates about and slides along the unit vector `axis` (child axes): coordinates
    /// `rotation` (rad) and `translation` (m).
    pub fn cylindrical(placement: Frame<S>, axis: Vector3<S>, to_child: Vector3<S>) -> Self {
        let axes = [ElementaryAxis::rotation(axis), ElementaryAxis::translation(axis)];
        Self::new(placement, &axes, &["rotation", "translation"], to_child)
    }
}
