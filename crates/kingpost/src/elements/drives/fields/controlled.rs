//! Drives that follow set-points within their limits.

use kingpost_derive::fields;

use crate::scenario::leaf::Leaf;
use crate::scenario::schema::{CoordinateName, Positive, yes};

/// A drive that turns an axis to follow a set-point within limits, such as a winch or a slewing gear.
#[fields]
pub struct ControlledDrive<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The revolute joint, or `joint.axis` for an axis that another joint turns about.
    pub joint: CoordinateName,
    /// The set-point that it follows. An input with the drive's name is added to it.
    pub set_point: AngleSetPoints<S>,
    /// Largest rate of its reference, rad/s.
    pub speed_limit_rad_s: Positive<S>,
    /// Largest acceleration of its reference, rad/s^2.
    pub acceleration_limit_rad_s2: Positive<S>,
    /// Largest jerk of its reference, rad/s^3; without it, the acceleration may jump.
    pub jerk_limit_rad_s3: Option<Positive<S>>,
    /// Largest torque, N m.
    pub torque_limit_n_m: Positive<S>,
    /// Largest power that it delivers, W. It does not limit braking: only the torque limit does.
    pub power_limit_w: Option<Positive<S>>,
    /// Torque per angle error against its reference, N m/rad.
    pub stiffness_n_m_per_rad: Positive<S>,
    /// Torque per rate error against its reference, N m s/rad.
    pub damping_n_m_s_per_rad: Positive<S>,
    /// Time in which its reference reaches a new rate if no limit acts, s. A jerk limit makes this time longer.
    #[serde(default = "response_time::<S>")]
    pub response_time_s: Positive<S>,
}

/// The set-point of a drive that turns an axis.
#[fields]
#[derive(Copy)]
pub enum AngleSetPoints<S = f64> {
    /// A torque, at once.
    Torque(TorqueSetPoint<S>),
    /// A rate.
    Speed(RateSetPoint<S>),
    /// An angle.
    Position(AngleSetPoint<S>),
}

/// A torque set-point.
#[fields]
#[derive(Copy)]
pub struct TorqueSetPoint<S = f64> {
    /// The torque, N m.
    #[serde(default)]
    pub torque_n_m: S,
}

/// A rate set-point.
#[fields]
#[derive(Copy)]
pub struct RateSetPoint<S = f64> {
    /// The rate, rad/s.
    #[serde(default)]
    pub rate_rad_s: S,
}

/// An angle set-point.
#[fields]
#[derive(Copy)]
pub struct AngleSetPoint<S = f64> {
    /// The angle, rad.
    #[serde(default)]
    pub angle_rad: S,
}

/// A drive that slides an axis to follow a set-point within limits.
#[fields]
pub struct LinearControlledDrive<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The prismatic joint, or `joint.axis` for an axis that another joint slides along.
    pub joint: CoordinateName,
    /// The set-point that it follows. An input with the drive's name is added to it.
    pub set_point: LengthSetPoints<S>,
    /// Largest speed of its reference, m/s.
    pub speed_limit_m_s: Positive<S>,
    /// Largest acceleration of its reference, m/s^2.
    pub acceleration_limit_m_s2: Positive<S>,
    /// Largest jerk of its reference, m/s^3; without it, the acceleration may jump.
    pub jerk_limit_m_s3: Option<Positive<S>>,
    /// Largest force, N.
    pub force_limit_n: Positive<S>,
    /// Largest power that it delivers, W. It does not limit braking: only the force limit does.
    pub power_limit_w: Option<Positive<S>>,
    /// Force per extension error against its reference, N/m.
    pub stiffness_n_per_m: Positive<S>,
    /// Force per speed error against its reference, N s/m.
    pub damping_n_s_per_m: Positive<S>,
    /// Time in which its reference reaches a new speed if no limit acts, s. A jerk limit makes this time longer.
    #[serde(default = "response_time::<S>")]
    pub response_time_s: Positive<S>,
}

/// The set-point of a drive that slides an axis.
#[fields]
#[derive(Copy)]
pub enum LengthSetPoints<S = f64> {
    /// A force, at once.
    Force(ForceSetPoint<S>),
    /// A speed.
    Speed(SpeedSetPoint<S>),
    /// An extension.
    Position(ExtensionSetPoint<S>),
}

/// A force set-point.
#[fields]
#[derive(Copy)]
pub struct ForceSetPoint<S = f64> {
    /// The force, N.
    #[serde(default)]
    pub force_n: S,
}

/// A speed set-point.
#[fields]
#[derive(Copy)]
pub struct SpeedSetPoint<S = f64> {
    /// The speed, m/s.
    #[serde(default)]
    pub speed_m_s: S,
}

/// An extension set-point.
#[fields]
#[derive(Copy)]
pub struct ExtensionSetPoint<S = f64> {
    /// The extension, m.
    #[serde(default)]
    pub extension_m: S,
}

/// The default of `response_time_s`.
fn response_time<S: Leaf>() -> Positive<S> {
    Positive::literal(0.1)
}
