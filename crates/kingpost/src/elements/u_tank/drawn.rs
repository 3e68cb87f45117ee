//! Rooms of a U-tank, as views draw them.

use super::{LEVELS, UTankGeometry};
use crate::elements::TankRoom;
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// Returns the columns and the duct between them as boxes; `place` is the middle of the duct relative to the carrier's centre
/// of mass, `top` the height of the columns above it. The levels of a tank that is disabled have no columns.
pub(super) fn rooms<S: Scalar>(
    name: &str,
    place: Vector3<S>,
    geometry: &UTankGeometry<S>,
    top: S,
    enabled: bool,
) -> Vec<TankRoom> {
    let [x, y, z] = place.0.map(Scalar::value);
    let [length, breadth] = geometry.column.map(|edge| edge.value() / 2.0);
    let [duct_length, duct_height] = geometry.duct.map(|edge| edge.value() / 2.0);
    let (distance, top, level) = (geometry.distance.value() / 2.0, top.value(), geometry.level.value());
    let column = |side: f64, level_column: &str| TankRoom {
        low_m: [x - length, y + side * distance - breadth, z - duct_height],
        high_m: [x + length, y + side * distance + breadth, z + top],
        level_m: level + duct_height,
        level_column: enabled.then(|| format!("{name}.{level_column}")),
        level_zero_m: duct_height,
    };
    let inner = distance - breadth;
    let duct = TankRoom {
        low_m: [x - duct_length, y - inner, z - duct_height],
        high_m: [x + duct_length, y + inner, z + duct_height],
        level_m: 2.0 * duct_height,
        level_column: None,
        level_zero_m: 0.0,
    };
    vec![column(1.0, LEVELS[0]), column(-1.0, LEVELS[1]), duct]
}
