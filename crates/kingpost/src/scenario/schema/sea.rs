//! The sea: the water, its depth, its waves.

use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

use super::{CurrentProfile, Name, NonNegative, Positive, Waves};
use crate::scenario::leaf::Leaf;

/// The water, its waves and its current.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "Sea", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(deny_unknown_fields, default, bound(deserialize = "S: Leaf"))]
pub struct Sea<S = f64> {
    /// Density of the water, kg/m^3.
    pub density_kg_m3: Positive<S>,
    /// Depth of the still water, m; without it, infinite.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub depth_m: Option<Positive<S>>,
    /// The wave systems by name: wind sea, swell.
    pub waves: IndexMap<Name, Waves<S>>,
    /// Time over which the waves grow from zero at the start, s.
    pub ramp_s: NonNegative,
    /// Velocity of the current at the surface along the world's x and y, m/s; leave it out for a current by a table.
    pub current_m_s: [S; 2],
    /// How the current varies with depth. Current loads by coefficients use it; damping, radiation and drift use the
    /// current at the surface.
    pub current_profile: CurrentProfile<S>,
}

impl<S: Leaf> Default for Sea<S> {
    fn default() -> Self {
        Self {
            density_kg_m3: Positive::literal(1025.0),
            depth_m: None,
            waves: IndexMap::new(),
            ramp_s: NonNegative::literal(0.0),
            current_m_s: [S::default(); 2],
            current_profile: CurrentProfile::Uniform,
        }
    }
}
