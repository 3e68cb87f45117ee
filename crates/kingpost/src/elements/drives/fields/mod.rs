//! Drives: forces between two bodies, mostly in the joint that connects them.

pub(crate) mod controlled;
pub(crate) mod cylinder;
pub(crate) mod histories;

use kingpost_derive::fields;

use crate::scenario::leaf::Leaf;
use crate::scenario::schema::{
    ControlledDrive, CoordinateName, Cylinder, LinearControlledDrive, NonNegative, Positive, yes,
};
use histories::{History, HistoryList};

/// Forces between two bodies, mostly in the joint that connects them.
#[fields]
pub enum Drive<S = f64> {
    /// A torque about an axis.
    Motor(Motor<S>),
    /// A force along an axis.
    LinearMotor(LinearMotor<S>),
    /// A spring and damper with a torque limit that turns an axis to a target.
    Servo(Servo<S>),
    /// A spring and damper with a force limit that moves an axis to a target.
    LinearServo(LinearServo<S>),
    /// A drive that turns an axis to follow a set-point within limits.
    ControlledDrive(Box<ControlledDrive<S>>),
    /// A drive that slides an axis to follow a set-point within limits.
    LinearControlledDrive(Box<LinearControlledDrive<S>>),
    /// Dry friction about an axis, set and released.
    Brake(Brake<S>),
    /// Dry friction along an axis, set and released.
    LinearBrake(LinearBrake<S>),
    /// A hydraulic cylinder between two pins, on any two bodies.
    Cylinder(Cylinder<S>),
}

/// Times of a pulse of strength T: from 0 to T in `rise_s`, T for `hold_s`, back to 0 in `rise_s`, and 0 from then on.
/// With a `reverse_s`, after the hold: from T to -T in twice `rise_s`, -T for `reverse_s`, and then back to 0.
#[fields]
pub struct Pulse {
    /// When it begins, s.
    #[serde(default)]
    pub start_s: NonNegative,
    /// Duration of the ramp from 0 to full strength, s; 0 is a jump.
    pub rise_s: NonNegative,
    /// Time at full strength, s.
    pub hold_s: NonNegative,
    /// Time at full strength in the other direction, s; 0 is a pulse that does not reverse.
    #[serde(default)]
    pub reverse_s: NonNegative,
}

/// A torque in a revolute joint; the reaction acts on the parent.
#[fields]
pub struct Motor<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The revolute joint, or `joint.axis` for an axis that another joint turns about.
    pub joint: CoordinateName,
    /// Full torque, positive about the joint's axis, N m.
    pub torque_n_m: S,
    /// How the torque varies over time.
    #[serde(default)]
    pub history: History,
    /// The times of the history `pulse`.
    pub pulse: Option<Pulse>,
    /// The times and shares of the history `list`.
    pub list: Option<HistoryList<S>>,
}

/// A force in a prismatic joint; the reaction acts on the parent.
#[fields]
pub struct LinearMotor<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The prismatic joint, or `joint.axis` for an axis that another joint slides along.
    pub joint: CoordinateName,
    /// Full force, positive along the joint's axis, N.
    pub force_n: S,
    /// How the force varies over time.
    #[serde(default)]
    pub history: History,
    /// The times of the history `pulse`.
    pub pulse: Option<Pulse>,
    /// The times and shares of the history `list`.
    pub list: Option<HistoryList<S>>,
}

/// A torque `stiffness (target - angle) - damping rate` in a revolute joint, clipped at the torque limit.
#[fields]
pub struct Servo<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The revolute joint, or `joint.axis` for an axis that another joint turns about.
    pub joint: CoordinateName,
    /// The angle to hold, rad.
    pub target_rad: S,
    /// Torque per angle, N m/rad.
    pub stiffness_n_m_per_rad: NonNegative<S>,
    /// Torque per rate, N m s/rad.
    pub damping_n_m_s_per_rad: NonNegative<S>,
    /// Largest torque, N m.
    pub torque_limit_n_m: NonNegative<S>,
}

/// A force `stiffness (target - extension) - damping speed` in a prismatic joint, clipped at the force limit.
#[fields]
pub struct LinearServo<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The prismatic joint, or `joint.axis` for an axis that another joint slides along.
    pub joint: CoordinateName,
    /// The extension to hold, m.
    pub target_m: S,
    /// Force per extension, N/m.
    pub stiffness_n_per_m: NonNegative<S>,
    /// Force per speed, N s/m.
    pub damping_n_s_per_m: NonNegative<S>,
    /// Largest force, N.
    pub force_limit_n: NonNegative<S>,
}

/// State of a brake.
#[fields]
#[derive(Copy, Default, Eq)]
pub enum BrakeState {
    /// At its full capacity.
    #[default]
    Set,
    /// Not at all.
    Released,
    /// By an input in [0, 1] with the drive's name; it begins at 1, set.
    Lever,
}

/// Dry friction about an axis, `torque rate / sqrt(rate^2 + smoothing^2)` when set.
#[fields]
pub struct Brake<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The revolute joint, or `joint.axis` for an axis that another joint turns about.
    pub joint: CoordinateName,
    /// Capacity: the torque that it can hold, N m.
    pub torque_n_m: NonNegative<S>,
    /// Smoothing rate over which the torque changes sign, rad/s. A held joint creeps more slowly than this rate.
    #[serde(default = "slow::<S>")]
    pub smoothing_rad_s: Positive<S>,
    /// Set, released, or moved by a lever.
    #[serde(default)]
    pub state: BrakeState,
}

/// Dry friction along an axis, `force speed / sqrt(speed^2 + smoothing^2)` when set.
#[fields]
pub struct LinearBrake<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The prismatic joint, or `joint.axis` for an axis that another joint slides along.
    pub joint: CoordinateName,
    /// Capacity: the force that it can hold, N.
    pub force_n: NonNegative<S>,
    /// Smoothing speed over which the force changes sign, m/s. A held joint creeps more slowly than this speed.
    #[serde(default = "slow::<S>")]
    pub smoothing_m_s: Positive<S>,
    /// Set, released, or moved by a lever.
    #[serde(default)]
    pub state: BrakeState,
}

/// The default of a smoothing speed.
pub(crate) fn slow<S: Leaf>() -> Positive<S> {
    Positive::literal(0.01)
}
