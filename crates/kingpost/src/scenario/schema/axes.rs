//! Axes of joints: their initial values, how their motion is set, and the forces in them.

use crate::elements::drives::fields::histories::{
    AngleOscillation, AngleTravel, History, HistoryList, LengthOscillation, LengthTravel, RatePulse,
};
use crate::elements::drives::fields::slow;
use crate::elements::gas_spring::fields::GasSpring;
use crate::scenario::leaf::Leaf;
use crate::scenario::schema::{NonNegative, Positive};
use kingpost_derive::fields;

/// One axis that a joint turns about.
#[fields(default)]
pub struct AngleAxis<S = f64> {
    /// Angle at the start, rad.
    pub initial_angle_rad: S,
    /// Rate at the start, rad/s.
    pub initial_rate_rad_s: S,
    /// Free, held or prescribed.
    pub mode: RevoluteMode<S>,
    /// Viscous damping moment per rate, N m s.
    pub damping_n_m_s: NonNegative<S>,
    /// Dry friction.
    pub friction: Option<AngleFriction<S>>,
    /// A spring.
    pub spring: Option<AngleSpring<S>>,
    /// Stops at the ends of the travel.
    pub limits: Option<AngleLimits<S>>,
    /// Moment of inertia of the motor's rotor about its own axis, kg m^2.
    pub rotor_inertia_kg_m2: NonNegative<S>,
    /// Turns of the rotor for one turn about the axis.
    pub gear_ratio: Positive<S>,
}

impl<S: Leaf> Default for AngleAxis<S> {
    fn default() -> Self {
        Self {
            initial_angle_rad: S::default(),
            initial_rate_rad_s: S::default(),
            mode: RevoluteMode::Free,
            damping_n_m_s: NonNegative::default(),
            friction: None,
            spring: None,
            limits: None,
            rotor_inertia_kg_m2: NonNegative::default(),
            gear_ratio: one(),
        }
    }
}

/// One axis that a joint slides along.
#[fields(default)]
pub struct LengthAxis<S = f64> {
    /// Extension at the start, m.
    pub initial_extension_m: S,
    /// Speed at the start, m/s.
    pub initial_speed_m_s: S,
    /// Free, held or prescribed.
    pub mode: PrismaticMode<S>,
    /// Viscous damping force per speed, N s/m.
    pub damping_n_s_m: NonNegative<S>,
    /// Dry friction.
    pub friction: Option<LengthFriction<S>>,
    /// A spring.
    pub spring: Option<LengthSpring<S>>,
    /// A gas spring, which pushes towards larger extensions.
    pub gas_spring: Option<GasSpring<S>>,
    /// Stops at the ends of the travel.
    pub limits: Option<LengthLimits<S>>,
    /// Moment of inertia of the motor's rotor about its own axis, kg m^2.
    pub rotor_inertia_kg_m2: NonNegative<S>,
    /// Angle of the rotor per extension, rad/m.
    pub gear_ratio_rad_per_m: Positive<S>,
}

impl<S: Leaf> Default for LengthAxis<S> {
    fn default() -> Self {
        Self {
            initial_extension_m: S::default(),
            initial_speed_m_s: S::default(),
            mode: PrismaticMode::Free,
            damping_n_s_m: NonNegative::default(),
            friction: None,
            spring: None,
            gas_spring: None,
            limits: None,
            rotor_inertia_kg_m2: NonNegative::default(),
            gear_ratio_rad_per_m: one(),
        }
    }
}

/// The default of a gear ratio.
pub(crate) fn one<S: Leaf>() -> Positive<S> {
    Positive::literal(1.0)
}

/// How the angle about an axis is set.
#[fields]
#[derive(Default)]
pub enum RevoluteMode<S = f64> {
    /// The dynamics do.
    #[default]
    Free,
    /// It stays at its initial angle.
    Held,
    /// A given rate does.
    Prescribed(Box<PrescribedRate<S>>),
    /// It turns by a given angle, from rest to rest.
    Travel(AngleTravel<S>),
    /// It oscillates about its initial angle.
    Oscillation(AngleOscillation<S>),
}

/// A rate of turning as a given function of time.
#[fields]
pub struct PrescribedRate<S = f64> {
    /// Full rate, rad/s.
    pub rate_rad_s: S,
    /// How the rate varies over time.
    #[serde(default)]
    pub history: History,
    /// The times of the history `pulse`.
    pub pulse: Option<RatePulse>,
    /// The times and shares of the history `list`; a rate cannot jump.
    pub list: Option<HistoryList<S>>,
}

/// How the extension along an axis is set.
#[fields]
#[derive(Default)]
pub enum PrismaticMode<S = f64> {
    /// The dynamics do.
    #[default]
    Free,
    /// It stays at its initial extension.
    Held,
    /// A given speed does.
    Prescribed(Box<PrescribedSpeed<S>>),
    /// It slides by a given length, from rest to rest.
    Travel(LengthTravel<S>),
    /// It oscillates about its initial extension.
    Oscillation(LengthOscillation<S>),
}

/// A speed of sliding as a given function of time.
#[fields]
pub struct PrescribedSpeed<S = f64> {
    /// Full speed, m/s.
    pub speed_m_s: S,
    /// How the speed varies over time.
    #[serde(default)]
    pub history: History,
    /// The times of the history `pulse`.
    pub pulse: Option<RatePulse>,
    /// The times and shares of the history `list`; a rate cannot jump.
    pub list: Option<HistoryList<S>>,
}

/// Dry friction against turning, `torque rate / sqrt(rate^2 + smoothing^2)`.
#[fields]
pub struct AngleFriction<S = f64> {
    /// Its torque, N m.
    pub torque_n_m: NonNegative<S>,
    /// Rate scale over which the friction changes sign smoothly, rad/s. A joint that should stick creeps more slowly
    /// than this.
    #[serde(default = "slow::<S>")]
    pub smoothing_rad_s: Positive<S>,
}

/// Dry friction against sliding, `force speed / sqrt(speed^2 + smoothing^2)`.
#[fields]
pub struct LengthFriction<S = f64> {
    /// Its force, N.
    pub force_n: NonNegative<S>,
    /// Speed scale over which the friction changes sign smoothly, m/s. A joint that should stick creeps more slowly
    /// than this.
    #[serde(default = "slow::<S>")]
    pub smoothing_m_s: Positive<S>,
}

/// A linear spring about an axis.
#[fields]
pub struct AngleSpring<S = f64> {
    /// Moment per angle, N m/rad.
    pub stiffness_n_m_per_rad: NonNegative<S>,
    /// Angle at which the spring has no moment, rad.
    #[serde(default)]
    pub rest_rad: S,
}

/// A linear spring along an axis.
#[fields]
pub struct LengthSpring<S = f64> {
    /// Force per extension, N/m.
    pub stiffness_n_per_m: NonNegative<S>,
    /// Extension at which the spring has no force, m.
    #[serde(default)]
    pub rest_m: S,
}

/// Stops. At a depth d beyond a limit a stop pushes back with `stiffness d (1 + dissipation d')`; it never pulls.
#[fields]
pub struct AngleLimits<S = f64> {
    /// Smallest angle, rad; none when absent.
    #[not_null]
    #[cfg_attr(feature = "schema", schemars(with = "f64"))]
    pub lower_rad: Option<S>,
    /// Largest angle, rad; none when absent.
    #[not_null]
    #[cfg_attr(feature = "schema", schemars(with = "f64"))]
    pub upper_rad: Option<S>,
    /// Moment per angle beyond a limit, N m/rad.
    pub stiffness_n_m_per_rad: Positive<S>,
    /// Energy loss of the stop, s/rad: after an impact at a small rate u the axis leaves at about `u (1 - 2/3
    /// dissipation u)`.
    #[serde(default)]
    pub dissipation_s_per_rad: NonNegative<S>,
}

/// Stops. At a depth d beyond a limit a stop pushes back with `stiffness d (1 + dissipation d')`; it never pulls.
#[fields]
pub struct LengthLimits<S = f64> {
    /// Smallest extension, m; none when absent.
    #[not_null]
    #[cfg_attr(feature = "schema", schemars(with = "f64"))]
    pub lower_m: Option<S>,
    /// Largest extension, m; none when absent.
    #[not_null]
    #[cfg_attr(feature = "schema", schemars(with = "f64"))]
    pub upper_m: Option<S>,
    /// Force per extension beyond a limit, N/m.
    pub stiffness_n_per_m: Positive<S>,
    /// Energy loss of the stop, s/m: after an impact at a small speed u the axis leaves at about `u (1 - 2/3
    /// dissipation u)`.
    #[serde(default)]
    pub dissipation_s_per_m: NonNegative<S>,
}
