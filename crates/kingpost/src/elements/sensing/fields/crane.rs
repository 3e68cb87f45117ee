//! Sensors of a crane that sample: encoders, load cells, satellite receivers.

use kingpost_derive::fields;

use crate::scenario::schema::{AngleErrors, CoordinateName, DropOuts, ForceErrors, LengthErrors, Name, Positive, yes};

/// Measures the angle of a joint: `measured_angle`, rad.
#[fields]
pub struct Encoder<S = f64> {
    /// Whether the sensor measures.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The revolute joint, or `joint.axis` for an axis that another joint turns about.
    pub joint: CoordinateName,
    /// Time between two samples, s.
    pub period_s: Positive,
    /// Delay of its output, in samples: 0 to 1000.
    #[serde(default)]
    pub delay_samples: usize,
    /// Its errors; without them it is exact.
    pub errors: Option<AngleErrors<S>>,
    /// Its failures; without them it always works.
    pub drop_outs: Option<DropOuts>,
}

/// Measures the extension of a joint: `measured_extension`, m.
#[fields]
pub struct LinearEncoder<S = f64> {
    /// Whether the sensor measures.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The prismatic joint, or `joint.axis` for an axis that another joint slides along.
    pub joint: CoordinateName,
    /// Time between two samples, s.
    pub period_s: Positive,
    /// Delay of its output, in samples: 0 to 1000.
    #[serde(default)]
    pub delay_samples: usize,
    /// Its errors; without them it is exact.
    pub errors: Option<LengthErrors<S>>,
    /// Its failures; without them it always works.
    pub drop_outs: Option<DropOuts>,
}

/// Measures the tension of a rope: `measured_tension`, N. It samples at the start of the first step at or after each
/// multiple of its period.
#[fields]
pub struct LoadCell<S = f64> {
    /// Whether the sensor measures.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The rope.
    pub rope: Name,
    /// The end of the rope.
    #[serde(default)]
    pub end: RopeEnd,
    /// Time between two samples, s.
    pub period_s: Positive,
    /// Delay of its output, in samples: 0 to 1000.
    #[serde(default)]
    pub delay_samples: usize,
    /// Its errors; without them it is exact.
    pub errors: Option<ForceErrors<S>>,
    /// Its failures; without them it always works.
    pub drop_outs: Option<DropOuts>,
}

/// An end of a rope.
#[fields]
#[derive(Copy, Default, Eq)]
pub enum RopeEnd {
    /// The last: the hook.
    #[default]
    Last,
    /// The first: the drum.
    First,
}

/// Measures the position of its antenna: `measured_position.x`, `.y`, `.z`, m in the world.
#[fields]
pub struct SatelliteReceiver<S = f64> {
    /// Whether the sensor measures.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The body.
    pub body: Name,
    /// The antenna, in the body's drawing frame, m.
    #[serde(default)]
    pub position_m: [S; 3],
    /// Time between two samples, s.
    pub period_s: Positive,
    /// Delay of its outputs, in samples: 0 to 1000.
    #[serde(default)]
    pub delay_samples: usize,
    /// Errors along x and y each; without them both are exact.
    pub horizontal_errors: Option<LengthErrors<S>>,
    /// Errors of the height; without them it is exact.
    pub vertical_errors: Option<LengthErrors<S>>,
    /// Its failures; without them it always works.
    pub drop_outs: Option<DropOuts>,
}
