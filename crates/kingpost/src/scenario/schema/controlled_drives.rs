//! Drives that follow set-points within their limits.

use serde::{Deserialize, Serialize};

use super::{CoordinateName, Positive, yes};
use crate::scenario::leaf::Leaf;

/// A drive that turns an axis to follow a set-point within limits: a winch, a slewing gear.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "ControlledDrive", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(deny_unknown_fields, bound(deserialize = "S: Leaf"))]
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
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub jerk_limit_rad_s3: Option<Positive<S>>,
    /// Largest torque, N m.
    #[serde(rename = "torque_limit_N_m")]
    pub torque_limit_n_m: Positive<S>,
    /// Largest power that it delivers, W. It does not limit braking: only the torque limit does.
    #[serde(default, rename = "power_limit_W", skip_serializing_if = "Option::is_none")]
    pub power_limit_w: Option<Positive<S>>,
    /// Torque per angle error against its reference, N m/rad.
    #[serde(rename = "stiffness_N_m_per_rad")]
    pub stiffness_n_m_per_rad: Positive<S>,
    /// Torque per rate error against its reference, N m s/rad.
    #[serde(rename = "damping_N_m_s_per_rad")]
    pub damping_n_m_s_per_rad: Positive<S>,
    /// Time in which its reference reaches a new rate where no limit acts, s. A jerk limit makes it longer.
    #[serde(default = "response_time::<S>")]
    pub response_time_s: Positive<S>,
}

/// The set-point of a drive that turns an axis.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "AngleSetPoints", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(rename_all = "snake_case", bound(deserialize = "S: Leaf"))]
pub enum AngleSetPoints<S = f64> {
    /// A torque, at once.
    Torque(TorqueSetPoint<S>),
    /// A rate.
    Speed(RateSetPoint<S>),
    /// An angle.
    Position(AngleSetPoint<S>),
}

/// A torque to give.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "TorqueSetPoint", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(deny_unknown_fields, bound(deserialize = "S: Leaf"))]
pub struct TorqueSetPoint<S = f64> {
    /// The torque, N m.
    #[serde(default, rename = "torque_N_m")]
    pub torque_n_m: S,
}

/// A rate to keep.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "RateSetPoint", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(deny_unknown_fields, bound(deserialize = "S: Leaf"))]
pub struct RateSetPoint<S = f64> {
    /// The rate, rad/s.
    #[serde(default)]
    pub rate_rad_s: S,
}

/// An angle to go to.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "AngleSetPoint", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(deny_unknown_fields, bound(deserialize = "S: Leaf"))]
pub struct AngleSetPoint<S = f64> {
    /// The angle, rad.
    #[serde(default)]
    pub angle_rad: S,
}

/// A drive that slides an axis to follow a set-point within limits.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "LinearControlledDrive", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(deny_unknown_fields, bound(deserialize = "S: Leaf"))]
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
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub jerk_limit_m_s3: Option<Positive<S>>,
    /// Largest force, N.
    #[serde(rename = "force_limit_N")]
    pub force_limit_n: Positive<S>,
    /// Largest power that it delivers, W. It does not limit braking: only the force limit does.
    #[serde(default, rename = "power_limit_W", skip_serializing_if = "Option::is_none")]
    pub power_limit_w: Option<Positive<S>>,
    /// Force per extension error against its reference, N/m.
    #[serde(rename = "stiffness_N_per_m")]
    pub stiffness_n_per_m: Positive<S>,
    /// Force per speed error against its reference, N s/m.
    #[serde(rename = "damping_N_s_per_m")]
    pub damping_n_s_per_m: Positive<S>,
    /// Time in which its reference reaches a new speed where no limit acts, s. A jerk limit makes it longer.
    #[serde(default = "response_time::<S>")]
    pub response_time_s: Positive<S>,
}

/// The set-point of a drive that slides an axis.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "LengthSetPoints", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(rename_all = "snake_case", bound(deserialize = "S: Leaf"))]
pub enum LengthSetPoints<S = f64> {
    /// A force, at once.
    Force(ForceSetPoint<S>),
    /// A speed.
    Speed(SpeedSetPoint<S>),
    /// An extension.
    Position(ExtensionSetPoint<S>),
}

/// A force to give.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "ForceSetPoint", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(deny_unknown_fields, bound(deserialize = "S: Leaf"))]
pub struct ForceSetPoint<S = f64> {
    /// The force, N.
    #[serde(default, rename = "force_N")]
    pub force_n: S,
}

/// A speed to keep.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "SpeedSetPoint", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(deny_unknown_fields, bound(deserialize = "S: Leaf"))]
pub struct SpeedSetPoint<S = f64> {
    /// The speed, m/s.
    #[serde(default)]
    pub speed_m_s: S,
}

/// An extension to go to.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "ExtensionSetPoint", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(deny_unknown_fields, bound(deserialize = "S: Leaf"))]
pub struct ExtensionSetPoint<S = f64> {
    /// The extension, m.
    #[serde(default)]
    pub extension_m: S,
}

/// The default of `response_time_s`.
fn response_time<S: Leaf>() -> Positive<S> {
    Positive::literal(0.1)
}
