//! Forces: what acts on the bodies from outside.

use serde::{Deserialize, Serialize};

use super::{
    CatenaryLine, CurrentLoad, DynamicPositioning, Hydrodynamics, Name, NonNegative, SlackTank, SpringLine, WindLoad,
    yes,
};

/// What acts on the bodies from outside.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Force {
    /// Weight, downwards along the world's z axis.
    Gravity(Gravity),
    /// Damping proportional to a body's rates.
    ViscousDamping(ViscousDamping),
    /// Drag by the square of a body's rates.
    QuadraticDamping(QuadraticDamping),
    /// The water on a hull.
    Hydrodynamics(Hydrodynamics),
    /// The free surface of a tank that is neither empty nor full.
    SlackTank(Box<SlackTank>),
    /// A line without weight that pulls between two points.
    SpringLine(SpringLine),
    /// A mooring line that hangs, and may lie on the seabed.
    CatenaryLine(CatenaryLine),
    /// The wind on a body, by coefficients.
    WindLoad(Box<WindLoad>),
    /// The current on a body, by coefficients.
    CurrentLoad(Box<CurrentLoad>),
    /// Thrusters that keep a ship in its place.
    DynamicPositioning(Box<DynamicPositioning>),
}

/// Weight of every body, downwards along the world's z axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct Gravity {
    /// Whether it acts.
    pub enabled: bool,
    /// Acceleration of free fall, m/s^2.
    pub acceleration_m_s2: NonNegative,
}

impl Default for Gravity {
    fn default() -> Self {
        Self { enabled: true, acceleration_m_s2: NonNegative::literal(9.80665) }
    }
}

/// A force and a moment against a body's velocity and angular velocity, each in body axes. Velocity is relative to the
/// water where the sea has a current.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct ViscousDamping {
    /// Whether it acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The body.
    pub body: Name,
    /// The point that the force acts at, and whose velocity counts, in the body's drawing frame, m; without it, the
    /// centre of mass.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub position_m: Option<[f64; 3]>,
    /// Force per velocity of the point along x, y, z of the body, N s/m.
    #[serde(default, rename = "linear_N_s_m")]
    pub linear_n_s_m: [NonNegative; 3],
    /// Moment per roll, pitch, yaw rate, N m s.
    #[serde(default, rename = "angular_N_m_s")]
    pub angular_n_m_s: [NonNegative; 3],
    /// Added to these: rows of force x, y, z (N) and moment x, y, z (N m), columns of velocity x, y, z (m/s) and roll,
    /// pitch, yaw rate (rad/s). No motion may gain energy from it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub matrix: Option<Box<[[f64; 6]; 6]>>,
}

/// A force -c |v| v and a moment -c |omega| omega, component by component in body axes; v is relative to the water where
/// the sea has a current.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct QuadraticDamping {
    /// Whether it acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The body.
    pub body: Name,
    /// The point that the force acts at, and whose velocity counts, in the body's drawing frame, m.
    #[serde(default)]
    pub position_m: [f64; 3],
    /// Force per square of velocity along x, y, z of the body, N s^2/m^2.
    #[serde(default, rename = "linear_N_s2_m2")]
    pub linear_n_s2_m2: [NonNegative; 3],
    /// Moment per square of the roll, pitch, yaw rate, N m s^2.
    #[serde(default, rename = "angular_N_m_s2")]
    pub angular_n_m_s2: [NonNegative; 3],
}
