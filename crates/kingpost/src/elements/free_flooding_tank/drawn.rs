//! Room of a free-flooding tank, as views draw it.

use super::{FloodedColumn, LEVEL};
use crate::elements::TankRoom;
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// Returns the tank as a box; `place` is the middle of its opening relative to the carrier's centre of mass.
pub(super) fn room<S: Scalar>(name: &str, place: Vector3<S>, column: &FloodedColumn<S>) -> TankRoom {
    let [x, y, z] = place.0.map(Scalar::value);
    let [length, breadth, height] = column.edges.map(Scalar::value);
    TankRoom {
        low_m: [x - length / 2.0, y - breadth / 2.0, z],
        high_m: [x + length / 2.0, y + breadth / 2.0, z + height],
        level_m: column.level.value(),
        level_column: Some(format!("{name}.{LEVEL}")),
        level_zero_m: 0.0,
    }
}
