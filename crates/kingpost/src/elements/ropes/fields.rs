//! Ropes over sheaves, and the drums that they are wound on.

use kingpost_derive::fields;

use crate::scenario::leaf::Leaf;
use crate::scenario::schema::{CoordinateName, Direction, Fraction, Name, NonNegative, Positive, yes};

/// A rope without inertia that runs over sheaves: a hoist or a sling. It pulls when its path is longer
/// than the rope, else it is slack. Without a stiffness it is inextensible: it comes taut without a rebound, and its
/// peak tension at that moment must not be used for design.
#[fields]
pub struct Rope<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The points, sheaves and drum of its path, from the first end to the last. A path begins at a point or a drum and
    /// ends at a point.
    pub path: Vec<RopeStation<S>>,
    /// Unstretched length of the rope on its path at the start, m; without it, the rope is just taut at the start.
    pub unstretched_length_m: Option<Positive<S>>,
    /// EA: tension per strain, N; without it, the rope itself does not stretch.
    pub axial_stiffness_n: Option<Positive<S>>,
    /// Stiffness in series with the rope, N/m, such as that of the crane's boom and foundation; without it, they are
    /// rigid.
    pub series_stiffness_n_per_m: Option<Positive<S>>,
    /// tau: damping over stiffness, s. At the rate e' of its stretch the rope pulls with k tau e' in addition to k e.
    /// For wire ropes it is 0.01 to 0.02 s.
    #[serde(default)]
    pub damping_time_s: NonNegative<S>,
    /// Mass of the rope, kg/m. The mass acts as weight only, without inertia, and the legs stay straight; without it,
    /// the rope has no weight.
    pub mass_kg_per_m: Option<Positive<S>>,
    /// Diameter of the circular section that displaces the same volume of water as the rope, below the still waterline,
    /// m; without it, the rope has no buoyancy.
    pub diameter_m: Option<Positive<S>>,
    /// Tension at which the rope parts, N; without it, the rope never parts.
    pub breaking_load_n: Option<Positive<S>>,
    /// The bodies that hang on it, all of them: hook block, slings' bodies, load. The dynamic amplification factor is the
    /// rope's tension over its tension with these bodies at rest in air; it is 1 while they hang at rest.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub carries: Vec<CarriedByRope<S>>,
    /// The crane's load chart for this rope; without it, the load is not checked.
    pub load_chart: Option<LoadChart<S>>,
    /// Whether it can be released, by an input in [0, 1] with the rope's name. At 0.5 the load is released. Below 0.5
    /// the rope is hooked on again as soon as its path is shorter than the rope.
    #[serde(default)]
    pub can_be_released: bool,
    /// Whether it begins released: its input then begins at 1.
    #[serde(default)]
    pub begins_released: bool,
}

/// The load chart of a crane: rated loads over the radius, the distance from the slewing axis to the point where the
/// rope leaves the crane. The results have `load_radius` (m), `rated_load` and `hook_load` (kg) and `load_utilisation`,
/// hook load over rated load; a run warns when the utilisation exceeds 1 or the radius is outside the chart.
#[fields]
pub struct LoadChart<S = f64> {
    /// The revolute joint about which the crane slews.
    pub joint: CoordinateName,
    /// Radii that increase, m: two or more.
    pub radii_m: Vec<f64>,
    /// Rated load at each radius, kg, including the lifting gear between rope and load. Linear between radii; constant
    /// below the first radius and above the last.
    pub rated_loads_kg: Vec<Positive<S>>,
}

/// A body that hangs on a rope.
#[fields]
pub struct CarriedByRope<S = f64> {
    /// The body: the load, the hook block.
    pub body: Name,
    /// Pull of the rope at rest, of all its falls at the load together, over the weight of the body: 1 for a rope that
    /// carries the body alone, on any number of falls; 1 / (n sin b) for each of n slings at an angle b to the
    /// horizontal; 0.5 for each of two cranes that share a load evenly.
    #[serde(default = "whole::<S>")]
    pub share: Positive<S>,
}

/// A line with a constant-tension winch at its first end: a tugger line or a tag line.
#[fields]
pub struct TuggerLine<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The points and sheaves of its path, from the winch to the load: it begins and ends at a point.
    pub path: Vec<RopeStation<S>>,
    /// Tension at the load while the length is constant, N.
    pub tension_n: NonNegative<S>,
    /// Damping that reduces swing, N s/m: increase of the tension per rate of paying out, and decrease per rate of
    /// hauling in.
    #[serde(default)]
    pub damping_n_s_per_m: NonNegative<S>,
    /// Largest tension at the load, N: at least `tension_N`. Without it, there is no upper limit. The tension is never
    /// negative.
    pub largest_tension_n: Option<Positive<S>>,
}

/// A place on a rope's path.
#[fields]
pub enum RopeStation<S = f64> {
    /// A point where the rope ends, or through which it runs freely.
    Point(RopePoint<S>),
    /// A sheave.
    Sheave(Sheave<S>),
    /// The drum on which the rope is wound: only at the beginning of the path.
    Drum(RopeDrum<S>),
}

/// A point on a rope's path.
#[fields]
pub struct RopePoint<S = f64> {
    /// The body, or `world`.
    pub body: Name,
    /// The point in the body's drawing frame, m.
    #[serde(default)]
    pub position_m: [S; 3],
    /// Number of parallel falls from the previous place to this one. Together they pull with this number times the
    /// tension.
    #[serde(default = "one")]
    pub falls: u32,
}

/// A sheave that a rope runs over.
#[fields]
pub struct Sheave<S = f64> {
    /// The body, or `world`.
    pub body: Name,
    /// The centre in the body's drawing frame, m.
    #[serde(default)]
    pub position_m: [S; 3],
    /// Radius to the middle of the rope, m.
    pub radius_m: Positive<S>,
    /// The sheave's axis in the body's axes, of any length except 0. From the first end to the last, the rope turns
    /// about this axis by the right-hand rule, by -90 to 270 degrees.
    pub axis: Direction<S>,
    /// Efficiency while the rope is hauled in, towards its first end: the smaller tension at the sheave over the
    /// larger.
    #[serde(default = "all::<S>")]
    pub efficiency_hoisting: Fraction<S>,
    /// Efficiency while the rope is paid out: the smaller tension at the sheave over the larger.
    #[serde(default = "all::<S>")]
    pub efficiency_lowering: Fraction<S>,
}

/// A drum that a rope is wound on.
#[fields]
pub struct RopeDrum<S = f64> {
    /// The revolute joint about which the drum turns, on the body that carries it.
    pub joint: CoordinateName,
    /// Radius to the middle of the rope that is paid out at the start, m.
    pub radius_m: Positive<S>,
    /// The layers of rope on the drum; without them the radius is constant.
    pub layers: Option<DrumLayers<S>>,
    /// Sign of the joint's rate that pays out rope. It determines the side on which the rope leaves the drum.
    #[serde(default)]
    pub pays_out: PaysOut,
    /// Efficiency while the drum hauls in: tension times radius over the torque.
    #[serde(default = "all::<S>")]
    pub efficiency_hoisting: Fraction<S>,
    /// Efficiency while the drum pays out: the torque that holds the rope over tension times radius.
    #[serde(default = "all::<S>")]
    pub efficiency_lowering: Fraction<S>,
}

/// Layers of rope on a drum: each layer that is paid out reduces the radius by its height.
#[fields]
pub struct DrumLayers<S = f64> {
    /// Turns of rope side by side.
    pub turns_per_layer: Positive<S>,
    /// Height of a layer, m: the rope's diameter if each turn lies on top of the one below, 0.87 of it if the turns lie
    /// in the grooves.
    pub height_m: Positive<S>,
    /// Radius to the middle of the rope in the innermost layer, m, at which the radius stops decreasing and an event is
    /// recorded.
    pub innermost_radius_m: Positive<S>,
}

/// The sign of a drum joint's rate that pays out rope.
#[fields]
#[derive(Copy, Default, Eq)]
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

/// The default of `share`.
fn whole<S: Leaf>() -> Positive<S> {
    Positive::literal(1.0)
}

/// The default of efficiencies: no friction.
fn all<S: Leaf>() -> Fraction<S> {
    Fraction::literal(1.0)
}

impl<S: Leaf> RopeStation<S> {
    /// Returns the name of its kind, and the name of its body; `None` for a drum, which is on a joint.
    pub fn on(&self) -> (&'static str, Option<&Name>) {
        match self {
            Self::Point(point) => ("point", Some(&point.body)),
            Self::Sheave(sheave) => ("sheave", Some(&sheave.body)),
            Self::Drum(_) => ("drum", None),
        }
    }
}
