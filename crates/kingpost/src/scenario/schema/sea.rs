//! The sea: the water, its depth, its waves.

use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

use super::{CurrentProfile, Name, NonNegative, Positive, Waves};

/// The water that hulls float in, and what moves it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct Sea {
    /// Density of the water, kg/m^3.
    pub density_kg_m3: Positive,
    /// Depth of the still water, m; without it, infinite.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub depth_m: Option<Positive>,
    /// The wave systems by name: wind sea, swell.
    pub waves: IndexMap<Name, Waves>,
    /// Time over which the waves grow from nothing at the start, s.
    pub ramp_s: NonNegative,
    /// Velocity of the water at the surface along the world's x and y, m/s.
    pub current_m_s: [f64; 2],
    /// How the current goes with depth: for loads of the current by coefficients; damping and radiation see that at the
    /// surface.
    pub current_profile: CurrentProfile,
}

impl Default for Sea {
    fn default() -> Self {
        Self {
            density_kg_m3: Positive::literal(1025.0),
            depth_m: None,
            waves: IndexMap::new(),
            ramp_s: NonNegative::literal(0.0),
            current_m_s: [0.0; 2],
            current_profile: CurrentProfile::Uniform,
        }
    }
}
