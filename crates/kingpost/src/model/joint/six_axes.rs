//! Six axes: the whole motion of a body as three translations and three rotations.

use super::{AxisList, ElementaryAxis};
use crate::scalar::Scalar;
use crate::spatial::{Frame, Vector3};

impl<S: Scalar> AxisList<S> {
    /// Returns a joint that slides along x, y and z of the placement, then rotates about z, y and x:
    /// coordinates `x`, `y`, `z` (m), `yaw`, `pitch` and `roll` (rad).
    pub fn six_axes(placement: Frame<S>, to_child: Vector3<S>) -> Self {
        let along = |k: usize| Vector3(core::array::from_fn(|i| if i == k { S::ONE } else { S::ZERO }));
        let slides = [0, 1, 2].map(|k| ElementaryAxis::translation(along(k)));
        let turns = [2, 1, 0].map(|k| ElementaryAxis::rotation(along(k)));
        let axes = [slides[0], slides[1], slides[2], turns[0], turns[1], turns[2]];
        Self::new(placement, &axes, &["x", "y", "z", "yaw", "pitch", "roll"], to_child)
    }
}
