//! Sensors, and the wires from their outputs to inputs.

use kingpost_derive::fields;

use super::{
    AirGap, Clearance, Encoder, Gangway, InertialUnit, LinearEncoder, LoadCell, MotionReferenceUnit, SatelliteReceiver,
    SignalName, SwingEstimator, yes,
};

/// Sensors. Clearances, air gaps and gangways are measured in every row of the results, the others at their own interval.
// `assembled`: each kind assembles its elements in its room, by `Assemble` in `elements/KIND/assembly.rs`.
#[fields(assembled)]
pub enum Sensor<S = f64> {
    /// Roll, pitch, heave, heave rate and angular velocity at a point of a body.
    MotionReferenceUnit(Box<MotionReferenceUnit<S>>),
    /// Attitude and motion of a point of a body, by accelerometers and gyroscopes.
    InertialUnit(Box<InertialUnit<S>>),
    /// How a load swings, by gyroscopes on it.
    SwingEstimator(SwingEstimator<S>),
    /// The angle of a joint.
    Encoder(Encoder<S>),
    /// The extension of a joint.
    LinearEncoder(LinearEncoder<S>),
    /// The tension of a rope.
    LoadCell(LoadCell<S>),
    /// Where an antenna is.
    SatelliteReceiver(SatelliteReceiver<S>),
    /// The distance between two points or solids.
    Clearance(Clearance<S>),
    /// The height of a point above the surface of the sea.
    AirGap(AirGap<S>),
    /// Stroke and angles of a gangway between two bodies.
    Gangway(Gangway<S>),
}

/// A connection from a sampled output to an input, which keeps each sample until the next. Both have the same unit.
#[fields]
pub struct Wire {
    /// Whether it connects them; if not, the user sets the input.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The output, by its column in the results: `mru.measured_heave`.
    pub from: SignalName,
    /// The input: a drive's lever by the drive's name, or `winch.target_offset`, which a servo adds to its target.
    pub to: SignalName,
}
