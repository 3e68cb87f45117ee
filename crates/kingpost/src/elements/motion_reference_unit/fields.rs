//! Fields of a motion reference unit.

use kingpost_derive::fields;

use crate::scenario::leaf::Leaf;
use crate::scenario::schema::{AngleErrors, DropOuts, LengthErrors, Name, Positive, RateErrors, SpeedErrors, yes};

/// Measures the motion of a point of a body. Its outputs, which wires can use, are `measured_roll` and
/// `measured_pitch` (rad), `measured_heave` (m, relative to the start of the run), `measured_heave_rate` (m/s) and
/// `measured_angular_velocity.x`, `.y`, `.z` (rad/s, body axes), constant between two samples; with horizontal motion also
/// `measured_x`, `measured_y` (m, along the world's axes, relative to the start), `measured_x_velocity`,
/// `measured_y_velocity` (m/s) and `measured_yaw` (rad).
#[fields]
pub struct MotionReferenceUnit<S = f64> {
    /// Whether the sensor measures.
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
    /// Whether it also measures its horizontal motion, with the filter and the errors of heave, and its yaw, with the
    /// errors of the angles, like a unit with a gyrocompass.
    #[serde(default)]
    pub horizontal_motion: bool,
    /// The filter that removes the drift of heave and heave rate, as in real units; without it, both are unfiltered.
    pub heave_filter: Option<HeaveFilter<S>>,
    /// Errors of roll and pitch each; without them both are exact.
    pub angle_errors: Option<AngleErrors<S>>,
    /// Errors of heave, after its filter.
    pub heave_errors: Option<LengthErrors<S>>,
    /// Errors of the heave rate, after its filter.
    pub heave_rate_errors: Option<SpeedErrors<S>>,
    /// Errors of each component of the angular velocity.
    pub rate_errors: Option<RateErrors<S>>,
    /// Its failures; without them it always works.
    pub drop_outs: Option<DropOuts>,
}

/// A second-order high-pass filter: it removes motions with periods much longer than its cut-off period, and gives
/// shorter ones a phase lead. A satellite receiver restores the removed motion.
#[fields]
pub struct HeaveFilter<S = f64> {
    /// Cut-off period, s.
    pub cutoff_period_s: Positive<S>,
    /// Damping ratio.
    #[serde(default = "damping_ratio::<S>")]
    pub damping_ratio: Positive<S>,
    /// A satellite receiver on the same body, whose positions restore the motion that the filter removes.
    pub receiver: Option<Name>,
}

fn damping_ratio<S: Leaf>() -> Positive<S> {
    Positive::literal(0.7)
}
