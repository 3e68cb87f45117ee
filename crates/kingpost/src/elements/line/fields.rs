//! Lines with mass.

use kingpost_derive::fields;

use crate::scenario::leaf::Leaf;
use crate::scenario::schema::{Direction, Name, NonNegative, Pin, Positive, RopeStation, yes};

/// A wire or chain with mass between two points on bodies or in the world: a mooring line, a hoisting wire in deep water.
/// It has axial stiffness and damping, bending stiffness, weight, buoyancy, added mass and drag in waves and current, and can lie
/// on the seabed. A run begins with the line at rest between its ends. It has two ends, or a path over a drum and
/// sheaves, from which its first section is paid out.
///
/// With `rk4` and `euler` the line is advanced implicitly within each step, so that its axial waves do not limit the step;
/// `dormand_prince` resolves them.
#[fields]
pub struct DynamicLine<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// One end: a fairlead, a crane's tip.
    pub first: Option<Pin<S>>,
    /// The other end: an anchor in the `world`, or a point of another body.
    pub second: Option<Pin<S>>,
    /// Whether the second end is free, instead of `second`. The line begins at rest straight down, or up if it floats, as far as the
    /// seabed or the surface, and beyond down its slope, along the current or along x.
    #[serde(default)]
    pub second_free: bool,
    /// Where on another line the second end is fastened, instead of `second`: the line is a branch of that one, as a leg of a
    /// bridle is. Several lines may be fastened to the same place, and branches to branches.
    pub second_on: Option<SectionEnd>,
    /// Direction in which it leaves the first end, in the axes of that body: the end is clamped, with bending stiffness in the
    /// first section. Without it, the line turns freely there.
    pub first_direction: Option<Direction<S>>,
    /// Direction in which it arrives at the second end, in the axes of that body: the end is clamped, with bending stiffness in
    /// the last section. Without it, the line turns freely there.
    pub second_direction: Option<Direction<S>>,
    /// Instead of both ends, the places of a path as of a `rope`, with one fall: the line is its last leg, from the last drum or
    /// sheave, taken as a point, to the last point. Up to there it does not stretch and has no mass; the mass of what is paid
    /// out is taken from the first place, whose body has the mass of the wire there at the start. The moment of inertia of a drum
    /// stays.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub path: Vec<RopeStation<S>>,
    /// Its sections, from the first end. With a path the length of the first one is that at the start.
    pub sections: Vec<DynamicLineSection<S>>,
    /// The plane seabed on which it can lie; without it, the line does not touch the seabed.
    pub seabed: Option<LineSeabed<S>>,
    /// Number of points along it at which the results have its tension, evenly spaced along its unstretched length with both
    /// ends: 2 to 200, or 0 for none.
    #[serde(default = "points_along")]
    pub points_along: usize,
}

/// The end of a section of another line, towards the second end of that one. Lines that meet there turn freely about it, and its
/// clump weight is that of the section.
#[fields]
pub struct SectionEnd {
    /// The other line, one with mass.
    pub line: Name,
    /// The section, counted from 0: not the last one, unless that line ends free.
    pub section: usize,
}

/// A section of a line, with the same properties along it.
#[fields]
pub struct DynamicLineSection<S = f64> {
    /// Length without tension, m.
    pub unstretched_length_m: Positive<S>,
    /// Number of its elements, each with two nodes: the error falls with the fourth power of the number; with the second where
    /// drag or bending curves the line.
    pub elements: usize,
    /// Mass, kg/m.
    pub mass_kg_per_m: Positive<S>,
    /// Diameter of the circular section that displaces the same volume of water, m. That of a chain is 1.8 times the
    /// diameter of its bar without studs.
    pub diameter_m: Positive<S>,
    /// EA: tension per strain, N.
    pub axial_stiffness_n: Positive<S>,
    /// tau: axial damping over stiffness, s. The tension is EA (e + tau e') at the strain e: at the period T the damping is
    /// pi tau / T of the critical one. Without damping, axial waves that are shorter than the step ring.
    #[serde(default = "damping_time::<S>")]
    pub damping_time_s: NonNegative<S>,
    /// EI: bending moment per curvature, N m^2; none for a section that is paid out. A section with it also pushes, one without
    /// becomes slack.
    #[serde(default)]
    pub bending_stiffness_n_m2: NonNegative<S>,
    /// Added mass over the mass of the displaced water, across the line.
    #[serde(default = "one::<S>")]
    pub added_mass_across: NonNegative<S>,
    /// Added mass over the mass of the displaced water, along the line.
    #[serde(default)]
    pub added_mass_along: NonNegative<S>,
    /// Drag coefficient of the flow across the line, with the area of diameter times length: 1.2 for a wire, 2.4 for a chain
    /// over its bar diameter, which is 1.3 over the diameter of the displaced water (DNV-OS-E301).
    #[serde(default = "drag_across::<S>")]
    pub drag_across: NonNegative<S>,
    /// Drag coefficient of the flow along the line, with the area of pi times diameter times length.
    #[serde(default)]
    pub drag_along: NonNegative<S>,
    /// A clump weight or a buoy at its end towards the second end of the line; in the last section only with a free end.
    pub clump_weight: Option<LineClumpWeight<S>>,
}

/// A clump weight or a buoy on a line: a point with mass, buoyancy, added mass and drag, which turns freely.
#[fields]
pub struct LineClumpWeight<S = f64> {
    /// Mass, kg.
    pub mass_kg: NonNegative<S>,
    /// Displaced volume, m^3. At the surface the wet share is that of a body as high as a sphere of this volume.
    #[serde(default)]
    pub volume_m3: NonNegative<S>,
    /// Drag coefficient times area, m^2, in every direction.
    #[serde(default)]
    pub drag_area_m2: NonNegative<S>,
    /// Added mass over the mass of the displaced water; that of a sphere is 0.5.
    #[serde(default = "half::<S>")]
    pub added_mass: NonNegative<S>,
}

/// The seabed under a line.
#[fields]
pub struct LineSeabed<S = f64> {
    /// Its depth below the still waterline at the origin of the world, m; without it, that of the sea.
    pub depth_m: Option<Positive<S>>,
    /// Its slope, rad: up to 60 degrees. A run begins with the line at rest without friction, also on a slope.
    #[serde(default)]
    pub slope_rad: NonNegative<S>,
    /// Horizontal direction in which it falls, rad, from x towards y.
    #[serde(default)]
    pub slope_direction_rad: S,
    /// Coefficient of Coulomb friction, along and across the line.
    pub friction: NonNegative<S>,
    /// Pressure per depth of penetration, N/m^3: the force per length is this times the diameter times the depth.
    #[serde(default = "seabed_stiffness::<S>")]
    pub stiffness_n_per_m3: Positive<S>,
    /// Damping over stiffness, s: a line that falls on it at a speed v is braked from a height of this time times v on.
    #[serde(default = "seabed_damping::<S>")]
    pub damping_time_s: NonNegative<S>,
}

/// Every twentieth of the length.
fn points_along() -> usize {
    21
}

/// 0.4 % of critical damping at 8 s, as of steel wire.
fn damping_time<S: Leaf>() -> NonNegative<S> {
    NonNegative::literal(0.01)
}

fn half<S: Leaf>() -> NonNegative<S> {
    NonNegative::literal(0.5)
}

fn one<S: Leaf>() -> NonNegative<S> {
    NonNegative::literal(1.0)
}

fn drag_across<S: Leaf>() -> NonNegative<S> {
    NonNegative::literal(1.2)
}

/// The default of MoorDyn 2.
fn seabed_stiffness<S: Leaf>() -> Positive<S> {
    Positive::literal(3e6)
}

/// The default of MoorDyn 2: 3e5 over 3e6.
fn seabed_damping<S: Leaf>() -> NonNegative<S> {
    NonNegative::literal(0.1)
}
