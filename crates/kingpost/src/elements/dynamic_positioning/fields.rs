//! Dynamic positioning: thrusters that keep a ship in position.

use indexmap::IndexMap;
use kingpost_derive::fields;

use crate::scenario::leaf::Leaf;
use crate::scenario::schema::{Name, NonNegative, Positive, yes};

/// A controller with thrusters that holds a point of a ship at a position, and the ship on a heading.
#[fields]
pub struct DynamicPositioning<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The ship.
    pub body: Name,
    /// The held point in the body's drawing frame, m. Forces and moments refer to this point.
    #[serde(default)]
    pub position_m: [S; 3],
    /// The position and heading to hold.
    #[serde(default)]
    #[placed(Station)]
    pub target: StationTarget<S>,
    /// The controller's gains.
    pub gains: PositioningGains<S>,
    /// The filter that prevents thruster response to wave-frequency motion; without it, the thrusters respond to every
    /// wave.
    pub wave_filter: Option<WaveFilter<S>>,
    /// Priority of yaw moment or force when a thruster is at its limit.
    #[serde(default)]
    pub priority: ThrustPriority,
    /// Anti-windup time constant, s, with which the integrals follow the force and moment of the thrusters while a
    /// thruster is at its limit. Without it, sqrt(K_d / K_i) for surge, sway and yaw each.
    pub anti_windup_time_s: Option<Positive<S>>,
    /// The thrusters by name.
    pub thrusters: IndexMap<Name, Thruster<S>>,
}

/// A position and a heading.
#[fields(default)]
#[derive(Copy, Default)]
pub struct StationTarget<S = f64> {
    /// x in the world, m.
    pub x_m: S,
    /// y in the world, m.
    pub y_m: S,
    /// Heading from the world's x axis, counter-clockwise, rad.
    pub heading_rad: S,
}

/// Gains of surge, sway and yaw.
#[fields]
pub enum PositioningGains<S = f64> {
    /// From the natural period and the damping ratio of the controlled ship.
    NaturalPeriods(Box<NaturalPeriods<S>>),
    /// Gains given as numbers.
    Stated(Box<StatedGains<S>>),
}

/// K_p = m omega^2, K_d = 2 zeta omega m, K_i = K_p / T_i with omega = 2 pi / period.
#[fields]
pub struct NaturalPeriods<S = f64> {
    /// Tuning of surge, along the ship.
    pub surge: TranslationTuning<S>,
    /// Tuning of sway, athwartships.
    pub sway: TranslationTuning<S>,
    /// Tuning of yaw, about the vertical.
    pub yaw: RotationTuning<S>,
    /// Whether integral action balances the mean load on the ship.
    #[serde(default = "yes")]
    pub integral: bool,
}

/// The response in surge or sway.
#[fields]
#[derive(Copy)]
pub struct TranslationTuning<S = f64> {
    /// Mass of the ship plus its low-frequency added mass, kg.
    pub mass_kg: Positive<S>,
    /// Natural period, s.
    pub period_s: Positive<S>,
    /// Damping ratio.
    #[serde(default = "damping_ratio::<S>")]
    pub damping_ratio: Positive<S>,
    /// T_i, s; without it 10 / omega.
    pub integral_time_s: Option<Positive<S>>,
}

/// The response in yaw.
#[fields]
#[derive(Copy)]
pub struct RotationTuning<S = f64> {
    /// Moment of inertia about the vertical, added moment of inertia included, kg m^2.
    pub inertia_kg_m2: Positive<S>,
    /// Natural period, s.
    pub period_s: Positive<S>,
    /// Damping ratio.
    #[serde(default = "damping_ratio::<S>")]
    pub damping_ratio: Positive<S>,
    /// T_i, s; without it 10 / omega.
    pub integral_time_s: Option<Positive<S>>,
}

fn damping_ratio<S: Leaf>() -> Positive<S> {
    Positive::literal(0.8)
}

/// Gains as numbers: of surge and sway, and of yaw.
#[fields]
pub struct StatedGains<S = f64> {
    /// Force per error, N/m.
    pub stiffness_n_per_m: [Positive<S>; 2],
    /// Force per velocity, N s/m.
    pub damping_n_s_per_m: [NonNegative<S>; 2],
    /// Rate of the force per error, N/(m s).
    #[serde(default)]
    pub integral_n_per_m_s: [NonNegative<S>; 2],
    /// Moment per error, N m/rad.
    pub yaw_stiffness_n_m_per_rad: Positive<S>,
    /// Moment per rate, N m s/rad.
    pub yaw_damping_n_m_s_per_rad: NonNegative<S>,
    /// Rate of the moment per error, N m/(rad s).
    #[serde(default)]
    pub yaw_integral_n_m_per_rad_s: NonNegative<S>,
}

/// Notch filters and then a low-pass filter on the proportional and derivative part of the controller; the integrals
/// are not filtered.
#[fields]
pub struct WaveFilter<S = f64> {
    /// Periods of the notches, s: the waves' peak period, or several periods around it.
    #[serde(default)]
    pub notch_periods_s: Vec<Positive<S>>,
    /// Gain of a notch at its own period: damping ratio of its numerator over that of its denominator.
    #[serde(default = "notch_ratio::<S>")]
    pub notch_damping_ratio: NonNegative<S>,
    /// Cut-off period of the second-order low-pass filter, s; without it, there is no low-pass filter.
    pub cutoff_period_s: Option<Positive<S>>,
    /// Damping ratio of the low pass.
    #[serde(default = "butterworth::<S>")]
    pub cutoff_damping_ratio: Positive<S>,
}

fn notch_ratio<S: Leaf>() -> NonNegative<S> {
    NonNegative::literal(0.1)
}

fn butterworth<S: Leaf>() -> Positive<S> {
    Positive::literal(core::f64::consts::FRAC_1_SQRT_2)
}

/// Priority of yaw moment or force when a thruster is at its limit.
#[fields]
#[derive(Copy, Default, Eq)]
pub enum ThrustPriority {
    /// The force is reduced and keeps its direction; the yaw moment is given first.
    #[default]
    Heading,
    /// Force and moment are reduced by the same factor.
    None,
}

/// A thruster.
#[fields]
pub enum Thruster<S = f64> {
    /// A propeller in a tunnel through the hull, with the same thrust both ways.
    Tunnel(TunnelThruster<S>),
    /// A propeller on a fixed shaft.
    MainPropeller(MainPropeller<S>),
    /// A propeller that turns about the vertical.
    Azimuth(AzimuthThruster<S>),
}

/// A propeller in a tunnel.
#[fields]
pub struct TunnelThruster<S = f64> {
    /// Whether the thruster runs.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// Where it acts, in the body's drawing frame, m.
    pub position_m: [S; 3],
    /// Direction of its positive thrust from the body's x axis to port, rad.
    #[serde(default = "athwartships::<S>")]
    pub direction_rad: S,
    /// Largest thrust, both ways, N.
    pub max_thrust_n: Positive<S>,
    /// Time constant with which the thrust follows its command, s.
    pub time_constant_s: Positive<S>,
    /// Weight in the thrust allocation: a thruster with a larger weight is used less.
    #[serde(default = "one::<S>")]
    pub weight: Positive<S>,
}

/// A propeller on a fixed shaft.
#[fields]
pub struct MainPropeller<S = f64> {
    /// Whether the thruster runs.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// Where it acts, in the body's drawing frame, m.
    pub position_m: [S; 3],
    /// Direction of its thrust ahead from the body's x axis to port, rad.
    #[serde(default)]
    pub direction_rad: S,
    /// Largest thrust ahead, N.
    pub max_thrust_n: Positive<S>,
    /// Largest thrust astern, N.
    pub max_astern_thrust_n: Positive<S>,
    /// Time constant with which the thrust follows its command, s.
    pub time_constant_s: Positive<S>,
    /// Weight in the thrust allocation: a thruster with a larger weight is used less.
    #[serde(default = "one::<S>")]
    pub weight: Positive<S>,
}

/// A propeller that turns about the vertical. Its thrust has two components; the magnitude of the thrust is limited.
#[fields]
pub struct AzimuthThruster<S = f64> {
    /// Whether the thruster runs.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// Where it acts, in the body's drawing frame, m.
    pub position_m: [S; 3],
    /// Largest thrust in any direction, N.
    pub max_thrust_n: Positive<S>,
    /// Time constant with which both components of the thrust follow their commands, s.
    pub time_constant_s: Positive<S>,
    /// Weight in the thrust allocation: a thruster with a larger weight is used less.
    #[serde(default = "one::<S>")]
    pub weight: Positive<S>,
}

fn athwartships<S: Leaf>() -> S {
    S::literal(core::f64::consts::FRAC_PI_2)
}

fn one<S: Leaf>() -> Positive<S> {
    Positive::literal(1.0)
}
