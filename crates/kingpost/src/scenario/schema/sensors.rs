//! Sensors, and the wires from what they say to what takes it.

use serde::{Deserialize, Serialize};

use super::{AirGap, Clearance, Name, Positive, SignalName, yes};
use crate::scenario::leaf::Leaf;

/// What measures: a motion reference unit at its own ticks, the others in every row of the results.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "Sensor", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(rename_all = "snake_case", bound(deserialize = "S: Leaf"))]
pub enum Sensor<S = f64> {
    /// Roll, pitch, heave, heave rate and angular velocity at a point of a body.
    MotionReferenceUnit(MotionReferenceUnit<S>),
    /// The distance of a point from another point, or from a solid.
    Clearance(Clearance<S>),
    /// The height of a point above the surface of the sea.
    AirGap(AirGap<S>),
}

/// Measures the motion of a point of a body, without noise. It shows, as signals for wires, `measured_roll` and
/// `measured_pitch` (rad), `measured_heave` (m, over where the run began), `measured_heave_rate` (m/s) and
/// `measured_angular_velocity.x`, `.y`, `.z` (rad/s, body axes), held between two samples.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "MotionReferenceUnit", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(deny_unknown_fields, bound(deserialize = "S: Leaf"))]
pub struct MotionReferenceUnit<S = f64> {
    /// Whether it measures.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The body.
    pub body: Name,
    /// The point, in the body's drawing frame, m.
    #[serde(default)]
    pub position_m: [S; 3],
    /// Time between two samples, s.
    pub period_s: Positive,
    /// By how many samples what it shows is late: 0 to 1000.
    #[serde(default)]
    pub delay_samples: usize,
}

/// An input that takes a sampled output, from each sample to the next. Both have the same unit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Wire {
    /// Whether it connects them; if not, a hand sets the input.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The output, as its column in the results: `mru.measured_heave`.
    pub from: SignalName,
    /// The input: a drive's lever by the drive's name, or `winch.target_offset`, which a servo adds to its target.
    pub to: SignalName,
}
