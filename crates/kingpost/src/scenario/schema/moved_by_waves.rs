//! Ships of which nothing is known but how they move in waves.

use serde::{Deserialize, Serialize};

use super::Name;
use crate::scenario::leaf::Leaf;

/// A body that moves with the waves of the sea by displacement RAOs, whatever acts on it. Its parent is the world. Its
/// coordinates `x`, `y`, `z`, `yaw`, `pitch` and `roll` are those of the RAOs' vessel axes about their mean place.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "MovedByWaves", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(deny_unknown_fields, bound(deserialize = "S: Leaf"))]
pub struct MovedByWaves<S = f64> {
    /// Name of the joint; the body's when absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<Name>,
    /// The file of the RAOs: CSV whose names state its conventions, or OrcaFlex's YAML with one vessel type.
    pub raos: String,
    /// Whether port is as starboard, where a CSV file holds waves from 0 to 180 degrees only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub symmetric: Option<bool>,
    /// The origin of the file's vessel axes in this body's drawing frame, m.
    #[serde(default)]
    pub origin_m: [S; 3],
    /// Mean place of that origin in the world, m.
    #[serde(default)]
    pub position_m: [S; 3],
    /// Mean heading, from the world's x axis counter-clockwise, rad.
    #[serde(default)]
    pub heading_rad: S,
}
