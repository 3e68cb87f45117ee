//! Motion in a plane, such as a body that slides on a deck.

use super::{AxisList, ElementaryAxis};
use crate::scalar::Scalar;
use crate::spatial::{Frame, Vector3};

impl<S: Scalar> AxisList<S> {
    /// Returns a joint that slides along the unit vector `x` and along `normal x x`, then rotates about the
    /// unit vector `normal`: coordinates `x`, `y` (m, along axes of the parent) and `rotation` (rad). Both
    /// vectors are perpendicular, and given in child axes at angle 0.
    pub fn planar(placement: Frame<S>, normal: Vector3<S>, x: Vector3<S>, to_child: Vector3<S>) -> Self {
        let axes = [
            ElementaryAxis::translation(x),
            ElementaryAxis::translation(normal.cross(x)),
            ElementaryAxis::rotation(normal),
        ];
        Self::new(placement, &axes, &["x", "y", "rotation"], to_child)
    }
}
