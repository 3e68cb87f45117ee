//! A hydraulic cylinder.

use kingpost_derive::fields;

use crate::scenario::leaf::Leaf;
use crate::scenario::schema::{Name, NonNegative, Positive, yes};

/// A hydraulic cylinder between two pins: a force `stiffness (target length - length) - damping rate` along the line
/// between them, within the push and pull limits. The target length changes no faster than the speed limit.
#[fields]
pub struct Cylinder<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// Pin on one body.
    pub first: Pin<S>,
    /// Pin on the other.
    pub second: Pin<S>,
    /// Length between the pins when fully retracted, m, limited by a stop.
    pub shortest_m: Positive<S>,
    /// Length between the pins when fully extended, m, limited by a stop.
    pub longest_m: Positive<S>,
    /// The target length.
    #[serde(default)]
    pub target: CylinderTarget<S>,
    /// Largest rate of the target length, m/s.
    pub speed_limit_m_s: Positive<S>,
    /// Largest force outwards, N.
    pub push_limit_n: NonNegative<S>,
    /// Largest force inwards, N.
    pub pull_limit_n: NonNegative<S>,
    /// Force per length, N/m.
    pub stiffness_n_per_m: NonNegative<S>,
    /// Force per speed, N s/m.
    pub damping_n_s_per_m: NonNegative<S>,
    /// Stiffness of the stops at both ends of the stroke, N/m.
    #[serde(default = "stop_stiffness::<S>")]
    pub stop_stiffness_n_per_m: NonNegative<S>,
    /// Dissipation of the stops, s/m: at a speed u into a stop, the stop's force is its spring force times (1 +
    /// dissipation u).
    #[serde(default = "stop_dissipation::<S>")]
    pub stop_dissipation_s_per_m: NonNegative<S>,
}

/// The default of `stop_stiffness_N_per_m`.
fn stop_stiffness<S: Leaf>() -> NonNegative<S> {
    NonNegative::literal(1.0e8)
}

/// The default of `stop_dissipation_s_per_m`.
fn stop_dissipation<S: Leaf>() -> NonNegative<S> {
    NonNegative::literal(1.0)
}

/// A point on a body, or in the world.
#[fields]
pub struct Pin<S = f64> {
    /// The body, or `world`.
    pub body: Name,
    /// The point in the body's drawing frame, m.
    #[serde(default)]
    pub position_m: [S; 3],
}

/// The target length of a cylinder.
#[fields]
#[derive(Copy, Default)]
pub enum CylinderTarget<S = f64> {
    /// Keeps the length at the start.
    #[default]
    Hold,
    /// Moves to this length, from the start on.
    Length(TargetLength<S>),
    /// Moves at the rate of the speed limit times an input in [-1, 1] with the drive's name.
    Lever,
}

/// A target length.
#[fields]
#[derive(Copy)]
pub struct TargetLength<S = f64> {
    /// Length between the pins, m.
    pub length_m: Positive<S>,
}

impl<S: Leaf> Pin<S> {
    /// Returns the name of the body; `None` for the world.
    pub fn named_body(&self) -> Option<&Name> {
        (self.body != crate::scenario::schema::WORLD).then_some(&self.body)
    }
}
