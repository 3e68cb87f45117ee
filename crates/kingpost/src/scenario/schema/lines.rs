//! Mooring lines and hawsers.

use serde::{Deserialize, Serialize};

use super::{NonNegative, Pin, Positive, yes};

/// A line without weight between two points on bodies, or on a body and in the world: a spring that pulls when it is
/// longer than its unstretched length.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct SpringLine {
    /// Whether it is there.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// One end: the fairlead, say.
    pub first: Pin,
    /// The other end: a bollard on the `world`, or on another body.
    pub second: Pin,
    /// Length without tension, m.
    pub unstretched_length_m: Positive,
    /// EA: tension per strain, N.
    #[serde(rename = "axial_stiffness_N")]
    pub axial_stiffness_n: Positive,
    /// Damping along the line: a in T = EA/L0 s (1 + a s') at the stretch s, never less than 0, s/m.
    #[serde(default)]
    pub dissipation_s_per_m: NonNegative,
}
