//! Parts: other files that a scenario is made of.

use indexmap::IndexMap;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::Name;

/// A part in its place. What stands on the world in the part's file stands on the mounting here.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Mounting {
    /// A part of the gallery by its name, or a YAML or JSON file, its path from this file's folder.
    pub part: String,
    /// What the names of the part's bodies, joints, forces, drives, loops and parameters begin with here, before a `_`;
    /// without it, the name of this entry. Empty, they stay as they are.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub prefix: Option<String>,
    /// The body that the part stands on, or `world`.
    #[serde(default = "Name::world")]
    pub on: Name,
    /// Origin of the part in the drawing frame of that body, m.
    #[serde(default)]
    pub position_m: [f64; 3],
    /// The part's axes in that body's: roll, pitch, yaw (intrinsic z-y-x angles), rad.
    #[serde(default)]
    pub orientation_rad: [f64; 3],
    /// Values for the part, by the names of its parameters or by dotted paths of its fields. Parameters without a value here
    /// are parameters of the whole.
    #[serde(default, skip_serializing_if = "IndexMap::is_empty")]
    pub parameters: IndexMap<String, Value>,
}

impl Mounting {
    /// What the names of the part begin with in the whole, with the `_` at its end; `name` is that of the entry.
    pub(in crate::scenario) fn prefix(&self, name: &str) -> String {
        match self.prefix.as_deref().unwrap_or(name) {
            "" => String::new(),
            prefix => format!("{prefix}_"),
        }
    }
}
