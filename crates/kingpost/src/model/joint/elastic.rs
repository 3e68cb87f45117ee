//! Deformations between a segment of a beam and the next one.

use super::{AxisList, ElementaryAxis};
use crate::scalar::Scalar;
use crate::spatial::{Frame, Vector3};

impl<S: Scalar> AxisList<S> {
    /// Returns the joint between two segments of a beam along x: coordinates `shear_y`, `shear_z` (m), then
    /// `torsion` about x, `bending_y` about y and `bending_z` about z (rad). The beam does not stretch.
    pub fn elastic(placement: Frame<S>, to_child: Vector3<S>) -> Self {
        let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vector3::constant);
        let axes = [
            ElementaryAxis::translation(y),
            ElementaryAxis::translation(z),
            ElementaryAxis::rotation(x),
            ElementaryAxis::rotation(y),
            ElementaryAxis::rotation(z),
        ];
        Self::new(placement, &axes, &["shear_y", "shear_z", "torsion", "bending_y", "bending_z"], to_child)
    }
}
