//! Sensors, and the wires from their outputs to inputs.

use serde::{Deserialize, Serialize};

use super::{AirGap, Clearance, Name, Positive, SignalName, yes};
use crate::scenario::leaf::Leaf;

/// Sensors. A motion reference unit measures at its own interval, the others in every row of the results.
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

/// Measures the motion of a point of a body, without noise. Its outputs, which wires can use, are `measured_roll` and
/// `measured_pitch` (rad), `measured_heave` (m, relative to the start of the run), `measured_heave_rate` (m/s) and
/// `measured_angular_velocity.x`, `.y`, `.z` (rad/s, body axes), constant between two samples.
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
    /// Delay of its outputs, in samples: 0 to 1000.
    #[serde(default)]
    pub delay_samples: usize,
}

/// A connection from a sampled output to an input, which keeps each sample until the next. Both have the same unit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Wire {
    /// Whether it connects them; if not, the user sets the input.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The output, by its column in the results: `mru.measured_heave`.
    pub from: SignalName,
    /// The input: a drive's lever by the drive's name, or `winch.target_offset`, which a servo adds to its target.
    pub to: SignalName,
}
