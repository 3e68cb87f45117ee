//! Ships of which only the RAOs are known.

use kingpost_derive::fields;

use super::{Name, RaosPath};

/// A body that moves with the waves by displacement RAOs, whatever forces act on it. Its parent is the world. Its
/// coordinates `x`, `y`, `z`, `yaw`, `pitch` and `roll` are those of the RAOs' vessel axes relative to their mean
/// place.
#[fields]
pub struct MovedByWaves<S = f64> {
    /// Name of the joint; without it, the body's name.
    pub name: Option<Name>,
    /// The file of the RAOs: CSV whose column names state the conventions, or OrcaFlex's YAML with one vessel type.
    pub raos: RaosPath,
    /// Whether port and starboard are alike, for a CSV file with waves from 0 to 180 degrees only.
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
