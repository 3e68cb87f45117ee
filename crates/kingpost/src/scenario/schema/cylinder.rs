//! A hydraulic cylinder.

use serde::{Deserialize, Serialize};

use super::{Name, NonNegative, Positive, yes};

/// A hydraulic cylinder between two pins: a force `stiffness (wanted length - length) - damping rate` along the line
/// between them, clipped at what it can push and pull. The length wanted moves at the speed limit at most.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Cylinder {
    /// Whether it acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// Pin on one body.
    pub first: Pin,
    /// Pin on the other.
    pub second: Pin,
    /// Length between the pins where the cylinder is drawn in, m: a stop.
    pub shortest_m: Positive,
    /// Length between the pins where it is all the way out, m: a stop.
    pub longest_m: Positive,
    /// What it is after.
    #[serde(default)]
    pub target: CylinderTarget,
    /// Largest speed of the length wanted, m/s.
    pub speed_limit_m_s: Positive,
    /// Largest force outwards, N.
    #[serde(rename = "push_limit_N")]
    pub push_limit_n: NonNegative,
    /// Largest force inwards, N.
    #[serde(rename = "pull_limit_N")]
    pub pull_limit_n: NonNegative,
    /// Force per length, N/m.
    #[serde(rename = "stiffness_N_per_m")]
    pub stiffness_n_per_m: NonNegative,
    /// Force per speed, N s/m.
    #[serde(rename = "damping_N_s_per_m")]
    pub damping_n_s_per_m: NonNegative,
    /// Force per length of the stops at both ends of the stroke, N/m.
    #[serde(default = "stop_stiffness", rename = "stop_stiffness_N_per_m")]
    pub stop_stiffness_n_per_m: NonNegative,
    /// Dissipation of the stops, s/m: at a speed u into a stop its force is 1 + dissipation u times that of its spring.
    #[serde(default = "stop_dissipation")]
    pub stop_dissipation_s_per_m: NonNegative,
}

/// The default of `stop_stiffness_N_per_m`.
const fn stop_stiffness() -> NonNegative {
    NonNegative::literal(1.0e8)
}

/// The default of `stop_dissipation_s_per_m`.
const fn stop_dissipation() -> NonNegative {
    NonNegative::literal(1.0)
}

/// A point on a body, or on the world.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Pin {
    /// The body, or `world`.
    pub body: Name,
    /// The point in the body's drawing frame, m.
    #[serde(default)]
    pub position_m: [f64; 3],
}

/// What a cylinder is after.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum CylinderTarget {
    /// The length that it has at the start.
    #[default]
    Hold,
    /// A length, from the start on.
    Length(TargetLength),
    /// Where an input in [-1, 1], named as the drive, leads: its share of the speed limit.
    Lever,
}

/// A length to go to.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct TargetLength {
    /// Length between the pins, m.
    pub length_m: Positive,
}

impl Pin {
    /// The body; `None` for the world.
    pub fn named_body(&self) -> Option<&Name> {
        (self.body != super::WORLD).then_some(&self.body)
    }
}
