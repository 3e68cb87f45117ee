//! Flexible bodies: beams of rigid segments with elastic joints between them.

use serde::{Deserialize, Serialize};

use super::{NonNegative, Positive};

/// Makes a body a uniform beam along its x axis, centred on its centre of mass. Its mass is the body's, its length
/// that of the shape unless it is given.
///
/// The beam is cut into pieces with an elastic joint in the middle of each. The body keeps its name for the first
/// half piece, with the body's joint; the segments after it are `boom.1`, `boom.2`, and so on. What hangs on the body
/// hangs on the segment at its `position_m`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Flexible {
    /// Number of elastic joints along the beam, from 1 to 64.
    pub segments: u64,
    /// Young's modulus, Pa.
    #[serde(rename = "youngs_modulus_Pa")]
    pub youngs_modulus_pa: Positive,
    /// Poisson's ratio, between -1 and 0.5; the shear modulus is E / (2 (1 + nu)).
    #[serde(default = "steel")]
    pub poissons_ratio: f64,
    /// The cross-section.
    pub section: Section,
    /// Length, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub length_m: Option<Positive>,
    /// Damping in proportion to the stiffness; none when absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub damping: Option<FlexibleDamping>,
}

fn steel() -> f64 {
    0.3
}

/// A beam's cross-section: y to port, z up.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Section {
    /// A round tube or bar.
    CircularTube(CircularTube),
    /// A rectangular tube.
    RectangularTube(RectangularTube),
    /// Any section, by its numbers.
    General(GeneralSection),
}

/// A round tube; a bar where the wall is half of the diameter.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct CircularTube {
    /// Outer diameter, m.
    pub outer_diameter_m: Positive,
    /// Thickness of the wall, m; at most half of the diameter.
    pub wall_m: Positive,
}

/// A rectangular tube with walls of one thickness.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct RectangularTube {
    /// Outer extent along y, m.
    pub width_m: Positive,
    /// Outer extent along z, m.
    pub height_m: Positive,
    /// Thickness of the walls, m; less than half of width and height.
    pub wall_m: Positive,
}

/// A cross-section by its numbers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct GeneralSection {
    /// Area, m^2.
    pub area_m2: Positive,
    /// Second moments of area about y (integral of z^2) and about z (integral of y^2), m^4.
    pub second_moments_m4: [Positive; 2],
    /// Torsion constant, m^4.
    pub torsion_constant_m4: Positive,
    /// Shear areas for forces along y and along z, m^2; without them the beam does not shear.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shear_areas_m2: Option<[Positive; 2]>,
}

/// Damping in proportion to the stiffness: each elastic joint's moment is K (angle + time rate).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum FlexibleDamping {
    /// By the damping ratio that a mode of a frequency has.
    Ratio(DampingRatio),
    /// By the time.
    StiffnessTime(StiffnessTime),
}

/// The damping ratio of a mode; modes of other frequencies have it in proportion to theirs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct DampingRatio {
    /// Damping over critical damping.
    pub ratio: NonNegative,
    /// Frequency of the mode, Hz.
    #[serde(rename = "frequency_Hz")]
    pub frequency_hz: Positive,
}

/// Damping over stiffness.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct StiffnessTime {
    /// s.
    pub time_s: NonNegative,
}
