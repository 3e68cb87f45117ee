//! Ropes over sheaves, and the drums that wind them up.

use serde::{Deserialize, Serialize};

use super::{CoordinateName, Direction, Fraction, Name, NonNegative, Positive, yes};
use crate::scenario::leaf::Leaf;

/// A rope without inertia that runs over sheaves: a hoist, a sling, a tugger line. It pulls where its path is longer than the rope,
/// else it is slack. Without a stiffness it is inextensible: it comes taut without a rebound, and its tension there is none that
/// a load could be sized by.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "Rope", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(deny_unknown_fields, bound(deserialize = "S: Leaf"))]
pub struct Rope<S = f64> {
    /// Whether it is there.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// What it runs over, from its first end to its last: it begins at a point or a drum and ends at a point.
    pub path: Vec<RopeStation<S>>,
    /// Length without tension of the rope on its path at the start, m; without it, the rope is just taut at the start.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub unstretched_length_m: Option<Positive<S>>,
    /// EA: tension per strain, N; without it, the rope itself does not stretch.
    #[serde(default, rename = "axial_stiffness_N", skip_serializing_if = "Option::is_none")]
    pub axial_stiffness_n: Option<Positive<S>>,
    /// Stiffness of what gives way in series with the rope, the crane's boom and foundation say, N/m; without it, nothing
    /// does.
    #[serde(default, rename = "series_stiffness_N_per_m", skip_serializing_if = "Option::is_none")]
    pub series_stiffness_n_per_m: Option<Positive<S>>,
    /// Damping over stiffness, s: at the rate e' of its stretch the rope pulls k tau e' beside k e. For wire ropes it is 0.01
    /// to 0.02 s.
    #[serde(default)]
    pub damping_time_s: NonNegative<S>,
    /// Its mass, kg/m, which is weight alone; without it, the rope weighs nothing. Its legs stay straight.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mass_kg_per_m: Option<Positive<S>>,
    /// Diameter of the circle that displaces as much water as the rope below the still water line, m; without it, none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub diameter_m: Option<Positive<S>>,
    /// Tension at which the rope parts, N; without it, it does not.
    #[serde(default, rename = "breaking_load_N", skip_serializing_if = "Option::is_none")]
    pub breaking_load_n: Option<Positive<S>>,
    /// What hangs on it: its dynamic amplification factor is its tension over that of this load at rest in air.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub carries: Vec<CarriedByRope<S>>,
    /// What the crane may lift by it at which radius; without it, nothing is known of that.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load_chart: Option<LoadChart<S>>,
    /// Whether it can be released: an input in [0, 1] of the rope's name begins at 0, and at 0.5 the load is lost.
    #[serde(default)]
    pub can_be_released: bool,
}

/// The load chart of a crane: rated loads over the radius, which is the distance from the slewing axis to where the rope leaves
/// the crane for the load. The results have `load_radius` (m), `rated_load` and `hook_load` (kg) and `load_utilisation`, hook load
/// over rated load; a run warns where that passes 1, and of a radius outside of the chart.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "LoadChart", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(deny_unknown_fields, bound(deserialize = "S: Leaf"))]
pub struct LoadChart<S = f64> {
    /// The revolute joint by which the crane slews.
    pub joint: CoordinateName,
    /// Radii that increase, m: two or more.
    pub radii_m: Vec<f64>,
    /// The rated load at each radius, with what hangs between rope and load, kg: linear between, before the first and beyond the
    /// last as there.
    pub rated_loads_kg: Vec<Positive<S>>,
}

/// A body that hangs on a rope.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "CarriedByRope", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(deny_unknown_fields, bound(deserialize = "S: Leaf"))]
pub struct CarriedByRope<S = f64> {
    /// The body: the load, the hook block.
    pub body: Name,
    /// Tension of the rope at rest over the weight of the body; without it, one over the number of falls that the rope ends with.
    /// Of each of n slings at an angle b to the level it is 1 / (n sin b).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub share: Option<Positive<S>>,
}

/// A line whose winch pays out and hauls in so that its tension stays: a tugger line or a tag line. The winch stands at its
/// first end.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "TuggerLine", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(deny_unknown_fields, bound(deserialize = "S: Leaf"))]
pub struct TuggerLine<S = f64> {
    /// Whether it is there.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// What it runs over, from its winch to the load: it begins and ends at a point.
    pub path: Vec<RopeStation<S>>,
    /// Its tension at the load, N.
    #[serde(rename = "tension_N")]
    pub tension_n: NonNegative<S>,
}

/// A place on a rope's path.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "RopeStation", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(rename_all = "snake_case", bound(deserialize = "S: Leaf"))]
pub enum RopeStation<S = f64> {
    /// A point that the rope ends at, or runs through freely.
    Point(RopePoint<S>),
    /// A sheave.
    Sheave(Sheave<S>),
    /// The drum that the rope is wound on: only where it begins.
    Drum(RopeDrum<S>),
}

/// A point on a rope's path.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "RopePoint", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(deny_unknown_fields, bound(deserialize = "S: Leaf"))]
pub struct RopePoint<S = f64> {
    /// The body, or `world`.
    pub body: Name,
    /// The point in the body's drawing frame, m.
    #[serde(default)]
    pub position_m: [S; 3],
    /// Number of parallel falls between the place before and this one. Together they pull with that many times the tension.
    #[serde(default = "one")]
    pub falls: u32,
}

/// A sheave that a rope runs over.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "Sheave", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(deny_unknown_fields, bound(deserialize = "S: Leaf"))]
pub struct Sheave<S = f64> {
    /// The body, or `world`.
    pub body: Name,
    /// The centre in the body's drawing frame, m.
    #[serde(default)]
    pub position_m: [S; 3],
    /// To the middle of the rope, m.
    pub radius_m: Positive<S>,
    /// The axis in the body's axes, any length: the rope turns about it, by the right hand, on its way from the first end
    /// to the last, from -90 to 270 degrees.
    pub axis: Direction<S>,
    /// The smaller over the larger tension at the sheave while the rope is hauled in, towards its first end.
    #[serde(default = "all::<S>")]
    pub efficiency_hoisting: Fraction<S>,
    /// The same while it is paid out.
    #[serde(default = "all::<S>")]
    pub efficiency_lowering: Fraction<S>,
}

/// A drum that a rope is wound on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "RopeDrum", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(deny_unknown_fields, bound(deserialize = "S: Leaf"))]
pub struct RopeDrum<S = f64> {
    /// The revolute joint by which the drum turns, on the body that carries it.
    pub joint: CoordinateName,
    /// To the middle of the rope that it pays out at the start, m.
    pub radius_m: Positive<S>,
    /// Where the rope lies on it in layers; without them it is paid out at one radius.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub layers: Option<DrumLayers<S>>,
    /// The rate of the joint that pays out rope. The rope leaves the drum on the side that moves along with it then.
    #[serde(default)]
    pub pays_out: PaysOut,
    /// Tension of the rope times the radius over the torque that hauls it in.
    #[serde(default = "all::<S>")]
    pub efficiency_hoisting: Fraction<S>,
    /// The torque that holds the rope over its tension times the radius while it is paid out.
    #[serde(default = "all::<S>")]
    pub efficiency_lowering: Fraction<S>,
}

/// Layers of rope on a drum: its radius falls by the height of a layer for the turns of one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "DrumLayers", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(deny_unknown_fields, bound(deserialize = "S: Leaf"))]
pub struct DrumLayers<S = f64> {
    /// Turns of rope side by side.
    pub turns_per_layer: Positive<S>,
    /// Of a layer, m: the diameter of a rope that lies on top of the one below, 0.87 of it in the grooves between.
    pub height_m: Positive<S>,
    /// To the middle of the rope in the innermost layer, m. The radius falls no further, and an event says so.
    pub innermost_radius_m: Positive<S>,
}

/// The rate of a drum's joint that pays out rope.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum PaysOut {
    /// Positive rates.
    #[default]
    WithPositiveRate,
    /// Negative rates.
    WithNegativeRate,
}

/// The default of `falls`.
const fn one() -> u32 {
    1
}

/// The default of efficiencies: no friction.
fn all<S: Leaf>() -> Fraction<S> {
    Fraction::literal(1.0)
}

impl<S: Leaf> RopeStation<S> {
    /// The name of its kind, and the body that it names; `None` for a drum, which stands on a joint.
    pub fn on(&self) -> (&'static str, Option<&Name>) {
        match self {
            Self::Point(point) => ("point", Some(&point.body)),
            Self::Sheave(sheave) => ("sheave", Some(&sheave.body)),
            Self::Drum(_) => ("drum", None),
        }
    }
}
