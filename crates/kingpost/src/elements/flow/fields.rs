//! Fields of the loads of wind and current by coefficients.

use kingpost_derive::fields;

use crate::scenario::schema::flow::ten_metres;
use crate::scenario::schema::{Name, NonNegative, Positive, yes};

/// Speed of a current profile that a load uses.
#[fields]
#[derive(Copy, Default)]
pub enum CurrentSpeed<S = f64> {
    /// The root mean square over the draught, as drag needs it.
    #[default]
    MeanSquare,
    /// The mean over the draught.
    Mean,
    /// The speed at a depth.
    AtDepth(CurrentAtDepth<S>),
}

/// A depth.
#[fields]
#[derive(Copy)]
pub struct CurrentAtDepth<S = f64> {
    /// Under the still water, m.
    pub depth_m: NonNegative<S>,
}

/// The wind on a body by coefficients of its relative velocity.
#[fields]
pub struct WindLoad<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The body.
    pub body: Name,
    /// The point where the force acts and whose velocity is used, in the body's drawing frame, m.
    #[serde(default)]
    pub position_m: [S; 3],
    /// Height above the still water at which the wind speed is taken, m.
    #[serde(default = "ten_metres::<S>")]
    pub height_m: Positive<S>,
    /// The coefficients.
    pub coefficients: FlowCoefficients<S>,
}

/// The current on a body by coefficients of its relative velocity. The load also damps surge, sway and yaw: add no
/// other damping for the current.
#[fields]
pub struct CurrentLoad<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The body.
    pub body: Name,
    /// The point where the force acts and whose velocity is used, in the body's drawing frame, m.
    #[serde(default)]
    pub position_m: [S; 3],
    /// Draught over which a current profile is averaged, m.
    pub draught_m: Option<Positive<S>>,
    /// Speed of the current profile that is used.
    #[serde(default)]
    pub speed: CurrentSpeed<S>,
    /// The coefficients.
    pub coefficients: FlowCoefficients<S>,
}

/// C_x, C_y, C_n in F_x = rho/2 V^2 A_x C_x, F_y = rho/2 V^2 A_y C_y, M_z = rho/2 V^2 A_y L C_n, in the body's axes, with V the
/// relative velocity; a smooth curve through the points.
#[fields]
pub struct FlowCoefficients<S = f64> {
    /// Directions towards which the fluid flows, from the body's x axis, counter-clockwise, rad, increasing: 0 is flow
    /// from astern, pi from ahead, as in OCIMF.
    pub directions_rad: Vec<f64>,
    /// Whether port and starboard are alike: the directions then go from 0 to pi and are mirrored.
    pub symmetric: bool,
    /// C_x at each direction, forward.
    pub surge: Vec<S>,
    /// C_y at each direction, to port.
    pub sway: Vec<S>,
    /// C_n at each direction, bow to port.
    pub yaw: Vec<S>,
    /// A_x, m^2.
    pub frontal_area_m2: Positive<S>,
    /// A_y, m^2.
    pub lateral_area_m2: Positive<S>,
    /// L, m.
    pub length_m: Positive<S>,
}
