//! Axes of joints: how they begin, what decides their motion, and what acts in them.

use serde::{Deserialize, Deserializer, Serialize};

use super::histories::{AngleTravel, HistoryList, LengthTravel, RatePulse};
use super::{History, NonNegative, Positive};

/// One axis that a joint turns about.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct AngleAxis {
    /// Angle at the start, rad.
    pub initial_angle_rad: f64,
    /// Rate at the start, rad/s.
    pub initial_rate_rad_s: f64,
    /// Free, held or prescribed.
    pub mode: RevoluteMode,
    /// Viscous damping moment per rate, N m s.
    #[serde(rename = "damping_N_m_s")]
    pub damping_n_m_s: NonNegative,
    /// Dry friction.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub friction: Option<AngleFriction>,
    /// A spring.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub spring: Option<AngleSpring>,
    /// Stops at the ends of the travel.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limits: Option<AngleLimits>,
    /// Moment of inertia of the motor's rotor about its own axis, kg m^2.
    pub rotor_inertia_kg_m2: NonNegative,
    /// Turns of the rotor for one turn about the axis.
    pub gear_ratio: Positive,
}

impl Default for AngleAxis {
    fn default() -> Self {
        Self {
            initial_angle_rad: 0.0,
            initial_rate_rad_s: 0.0,
            mode: RevoluteMode::Free,
            damping_n_m_s: NonNegative::ZERO,
            friction: None,
            spring: None,
            limits: None,
            rotor_inertia_kg_m2: NonNegative::ZERO,
            gear_ratio: one(),
        }
    }
}

/// One axis that a joint slides along.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct LengthAxis {
    /// Extension at the start, m.
    pub initial_extension_m: f64,
    /// Speed at the start, m/s.
    pub initial_speed_m_s: f64,
    /// Free, held or prescribed.
    pub mode: PrismaticMode,
    /// Viscous damping force per speed, N s/m.
    #[serde(rename = "damping_N_s_m")]
    pub damping_n_s_m: NonNegative,
    /// Dry friction.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub friction: Option<LengthFriction>,
    /// A spring.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub spring: Option<LengthSpring>,
    /// Stops at the ends of the travel.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limits: Option<LengthLimits>,
    /// Moment of inertia of the motor's rotor about its own axis, kg m^2.
    pub rotor_inertia_kg_m2: NonNegative,
    /// Angle of the rotor per extension, rad/m.
    pub gear_ratio_rad_per_m: Positive,
}

impl Default for LengthAxis {
    fn default() -> Self {
        Self {
            initial_extension_m: 0.0,
            initial_speed_m_s: 0.0,
            mode: PrismaticMode::Free,
            damping_n_s_m: NonNegative::ZERO,
            friction: None,
            spring: None,
            limits: None,
            rotor_inertia_kg_m2: NonNegative::ZERO,
            gear_ratio_rad_per_m: one(),
        }
    }
}

/// The default of a gear ratio.
pub(super) const fn one() -> Positive {
    Positive::literal(1.0)
}

/// The default of a smoothing speed.
pub(super) const fn slow() -> Positive {
    Positive::literal(0.01)
}

/// A number that may be absent, but not empty where it is named.
fn present<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<f64>, D::Error> {
    f64::deserialize(deserializer).map(Some)
}

/// What decides the angle about an axis.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum RevoluteMode {
    /// The dynamics do.
    #[default]
    Free,
    /// It stays at its initial angle.
    Held,
    /// A given rate does.
    Prescribed(Box<PrescribedRate>),
    /// It turns by a given angle, from rest to rest.
    Travel(AngleTravel),
}

/// A rate of turning as a given function of time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct PrescribedRate {
    /// Full rate, rad/s.
    pub rate_rad_s: f64,
    /// How the rate goes with time.
    #[serde(default)]
    pub history: History,
    /// The times of the history `pulse`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pulse: Option<RatePulse>,
    /// The times and shares of the history `list`; a rate cannot jump.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub list: Option<HistoryList>,
}

/// What decides the extension along an axis.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum PrismaticMode {
    /// The dynamics do.
    #[default]
    Free,
    /// It stays at its initial extension.
    Held,
    /// A given speed does.
    Prescribed(Box<PrescribedSpeed>),
    /// It slides by a given length, from rest to rest.
    Travel(LengthTravel),
}

/// A speed of sliding as a given function of time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct PrescribedSpeed {
    /// Full speed, m/s.
    pub speed_m_s: f64,
    /// How the speed goes with time.
    #[serde(default)]
    pub history: History,
    /// The times of the history `pulse`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pulse: Option<RatePulse>,
    /// The times and shares of the history `list`; a rate cannot jump.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub list: Option<HistoryList>,
}

/// Dry friction against turning, `torque rate / sqrt(rate^2 + smoothing^2)`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct AngleFriction {
    /// Its torque, N m.
    #[serde(rename = "torque_N_m")]
    pub torque_n_m: NonNegative,
    /// Rate about which it changes its sign smoothly, rad/s; what should stick creeps below it.
    #[serde(default = "slow")]
    pub smoothing_rad_s: Positive,
}

/// Dry friction against sliding, `force speed / sqrt(speed^2 + smoothing^2)`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct LengthFriction {
    /// Its force, N.
    #[serde(rename = "force_N")]
    pub force_n: NonNegative,
    /// Speed about which it changes its sign smoothly, m/s; what should stick creeps below it.
    #[serde(default = "slow")]
    pub smoothing_m_s: Positive,
}

/// A linear spring about an axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct AngleSpring {
    /// Moment per angle, N m/rad.
    #[serde(rename = "stiffness_N_m_per_rad")]
    pub stiffness_n_m_per_rad: NonNegative,
    /// Angle at which it is slack, rad.
    #[serde(default)]
    pub rest_rad: f64,
}

/// A linear spring along an axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct LengthSpring {
    /// Force per extension, N/m.
    #[serde(rename = "stiffness_N_per_m")]
    pub stiffness_n_per_m: NonNegative,
    /// Extension at which it is slack, m.
    #[serde(default)]
    pub rest_m: f64,
}

/// Stops that push back with `stiffness d (1 + dissipation d')` at the depth d beyond a limit, never outwards.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct AngleLimits {
    /// Smallest angle, rad; none when absent.
    #[serde(default, skip_serializing_if = "Option::is_none", deserialize_with = "present")]
    #[cfg_attr(feature = "schema", schemars(with = "f64"))]
    pub lower_rad: Option<f64>,
    /// Largest angle, rad; none when absent.
    #[serde(default, skip_serializing_if = "Option::is_none", deserialize_with = "present")]
    #[cfg_attr(feature = "schema", schemars(with = "f64"))]
    pub upper_rad: Option<f64>,
    /// Moment per angle beyond a limit, N m/rad.
    #[serde(rename = "stiffness_N_m_per_rad")]
    pub stiffness_n_m_per_rad: Positive,
    /// What is lost: of a small rate u a stop gives back about `u (1 - 2/3 dissipation u)`, s/rad.
    #[serde(default)]
    pub dissipation_s_per_rad: NonNegative,
}

/// Stops that push back with `stiffness d (1 + dissipation d')` at the depth d beyond a limit, never outwards.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct LengthLimits {
    /// Smallest extension, m; none when absent.
    #[serde(default, skip_serializing_if = "Option::is_none", deserialize_with = "present")]
    #[cfg_attr(feature = "schema", schemars(with = "f64"))]
    pub lower_m: Option<f64>,
    /// Largest extension, m; none when absent.
    #[serde(default, skip_serializing_if = "Option::is_none", deserialize_with = "present")]
    #[cfg_attr(feature = "schema", schemars(with = "f64"))]
    pub upper_m: Option<f64>,
    /// Force per extension beyond a limit, N/m.
    #[serde(rename = "stiffness_N_per_m")]
    pub stiffness_n_per_m: Positive,
    /// What is lost: of a small speed u a stop gives back about `u (1 - 2/3 dissipation u)`, s/m.
    #[serde(default)]
    pub dissipation_s_per_m: NonNegative,
}
