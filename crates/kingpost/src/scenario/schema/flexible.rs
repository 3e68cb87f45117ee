//! Flexible bodies: beams of rigid segments with elastic joints between them.

use kingpost_derive::fields;

use super::{NonNegative, Positive};
use crate::scenario::leaf::Leaf;

/// Makes a body a uniform beam along its x axis, centred on its centre of mass. Its mass is the body's, its length is
/// the shape's unless it is given.
///
/// The beam is cut into pieces with an elastic joint in the middle of each. The body keeps its name for the first half
/// piece, with the body's joint; the segments after it are `boom.1`, `boom.2`, and so on. A child of the body is
/// attached to the segment at its `position_m`.
#[fields]
pub struct Flexible<S = f64> {
    /// Number of elastic joints along the beam, from 1 to 64.
    pub segments: u64,
    /// Young's modulus, Pa.
    pub youngs_modulus_pa: Positive<S>,
    /// Poisson's ratio, between -1 and 0.5; the shear modulus is E / (2 (1 + nu)).
    #[serde(default = "steel::<S>")]
    pub poissons_ratio: S,
    /// The cross-section.
    pub section: Section<S>,
    /// Length, m.
    pub length_m: Option<Positive<S>>,
    /// Damping in proportion to the stiffness; none when absent.
    pub damping: Option<FlexibleDamping<S>>,
}

fn steel<S: Leaf>() -> S {
    S::literal(0.3)
}

/// A beam's cross-section: y to port, z up.
#[fields]
pub enum Section<S = f64> {
    /// A round tube or bar.
    CircularTube(CircularTube<S>),
    /// A rectangular tube.
    RectangularTube(RectangularTube<S>),
    /// Any section, by its numbers.
    General(GeneralSection<S>),
}

/// A round tube; a solid bar if the wall is half of the diameter.
#[fields]
pub struct CircularTube<S = f64> {
    /// Outer diameter, m.
    pub outer_diameter_m: Positive<S>,
    /// Thickness of the wall, m; at most half of the diameter.
    pub wall_m: Positive<S>,
}

/// A rectangular tube with walls of one thickness.
#[fields]
pub struct RectangularTube<S = f64> {
    /// Outer extent along y, m.
    pub width_m: Positive<S>,
    /// Outer extent along z, m.
    pub height_m: Positive<S>,
    /// Thickness of the walls, m; less than half of width and height.
    pub wall_m: Positive<S>,
}

/// A cross-section by its numbers.
#[fields]
pub struct GeneralSection<S = f64> {
    /// Area, m^2.
    pub area_m2: Positive<S>,
    /// Second moments of area about y (integral of z^2) and about z (integral of y^2), m^4.
    pub second_moments_m4: [Positive<S>; 2],
    /// Torsion constant, m^4.
    pub torsion_constant_m4: Positive<S>,
    /// Shear areas for forces along y and along z, m^2; without them the beam does not shear.
    pub shear_areas_m2: Option<[Positive<S>; 2]>,
}

/// Damping in proportion to the stiffness: each elastic joint's moment is K (angle + time rate).
#[fields]
pub enum FlexibleDamping<S = f64> {
    /// From the damping ratio of a mode of a given frequency.
    Ratio(DampingRatio<S>),
    /// By damping over stiffness, a time.
    StiffnessTime(StiffnessTime<S>),
}

/// The damping ratio of a mode; those of other modes are in proportion to their frequencies.
#[fields]
pub struct DampingRatio<S = f64> {
    /// Damping over critical damping.
    pub ratio: NonNegative<S>,
    /// Frequency of the mode, Hz.
    pub frequency_hz: Positive<S>,
}

/// Damping over stiffness.
#[fields]
pub struct StiffnessTime<S = f64> {
    /// s.
    pub time_s: NonNegative<S>,
}
