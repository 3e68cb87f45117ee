//! Parts: other files that a scenario includes.

use indexmap::IndexMap;
use kingpost_derive::fields;
use serde_json::Value;

use super::Name;

/// A part and where it is mounted. Bodies that the part's file attaches to the world are attached to the mounting.
#[fields]
pub struct Mounting {
    /// The name of a part in the gallery, or the path of a YAML or JSON file from this file's folder.
    pub part: String,
    /// Prefix of the names of the part's bodies, joints, forces, drives, loops and parameters, followed by `_`; without
    /// it, the name of this entry. An empty prefix leaves the names as they are.
    pub prefix: Option<String>,
    /// The body that the part is mounted on, or `world`.
    #[serde(default = "Name::world")]
    pub on: Name,
    /// Origin of the part in the drawing frame of that body, m.
    #[serde(default)]
    pub position_m: [f64; 3],
    /// Orientation of the part's axes in that body's: roll, pitch, yaw (intrinsic z-y-x angles), rad.
    #[serde(default)]
    pub orientation_rad: [f64; 3],
    /// Values for the part, by the names of its parameters or by dotted paths of its fields. Parameters without a value
    /// here become parameters of this scenario.
    #[serde(default, skip_serializing_if = "IndexMap::is_empty")]
    pub parameters: IndexMap<String, Value>,
}

impl Mounting {
    /// The prefix of the part's names in the whole, including the `_`; `name` is the name of the entry.
    pub(in crate::scenario) fn prefix(&self, name: &str) -> String {
        match self.prefix.as_deref().unwrap_or(name) {
            "" => String::new(),
            prefix => format!("{prefix}_"),
        }
    }
}
