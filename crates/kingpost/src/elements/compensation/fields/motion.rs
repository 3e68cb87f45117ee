//! Compensation of a ship's motion in several axes.

use kingpost_derive::fields;

use crate::scenario::leaf::Leaf;
use crate::scenario::schema::{Fraction, HeavePrediction, Name, NonNegative, Positive, SetsInputs, yes};

/// Compensation in three axes: slewing and luffing, or any chain of driven joints, hold the crane's tip over a point of
/// the world, and the winch holds the load's height. Its inputs are a lever with its name, from 0 (off) to 1 (on), and
/// the speeds `NAME.x_speed` and `NAME.y_speed` (m/s of the tip, along the world's axes) and `NAME.lowering_speed` (m/s
/// at the load, positive: down), which are added to its commands. Its outputs are `compensation_offset` (m),
/// `compensation_ship_velocity` (m/s) and `compensation_utilisation`. The set-points of its drives do not count.
#[fields]
pub struct ThreeAxisCompensation<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// Whether it is switched on at the start.
    #[serde(default = "yes")]
    pub begins_on: bool,
    /// The rope, which begins at a drum. The place before its last end is the crane's tip.
    pub rope: Name,
    /// The controlled drive of the drum, with a speed as its set-point.
    pub drive: Name,
    /// The controlled drives that move the tip: of slewing, luffing, knuckle, telescope. At least two.
    pub joints: Vec<CompensationDrive>,
    /// The motion reference unit with horizontal motion, or the inertial unit, that measures the tip's motion; without
    /// it, the compensation uses the exact motion without delay.
    pub sensor: Option<Name>,
    /// Time between two commands, s; at least simulation.step_s.
    pub period_s: Positive,
    /// Feed-forward gain: share of the ship's velocity at the tip that is commanded.
    #[serde(default = "whole::<S>")]
    pub feed_forward: Fraction<S>,
    /// Commanded speed per position error, 1/s.
    #[serde(default = "gain::<S>")]
    pub position_gain_per_s: NonNegative<S>,
    /// Speed of the tip, m/s, below which a direction counts as near a singularity: if the joints at full speed move
    /// the tip slower than this in a direction, the commands in that direction are reduced.
    #[serde(default = "damped_below::<S>")]
    pub damped_below_m_s: NonNegative<S>,
    /// Prediction over all delays; without it, the measured velocity is commanded.
    pub prediction: Option<HeavePrediction<S>>,
}

/// A platform below a crane's pedestal that three or more driven joints keep level and at its height. Its lever is an
/// input with its name, from 0 (off) to 1 (on). Its outputs are `platform_offset` (sines of the tilt, and m) and
/// `compensation_utilisation`. The set-points of its drives do not count.
#[fields]
pub struct PlatformCompensation<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// Whether it is switched on at the start.
    #[serde(default = "yes")]
    pub begins_on: bool,
    /// The body that stays level.
    pub body: Name,
    /// The point of the body that stays at its height, in the body's drawing frame, m.
    #[serde(default)]
    pub position_m: [S; 3],
    /// The controlled drives that move it. At least three.
    pub joints: Vec<CompensationDrive>,
    /// The motion reference unit or inertial unit, on the ship, that measures the motion; without it, the compensation
    /// uses the exact motion without delay.
    pub sensor: Option<Name>,
    /// Time between two commands, s; at least simulation.step_s.
    pub period_s: Positive,
    /// Feed-forward gain: share of the ship's motion that is commanded.
    #[serde(default = "whole::<S>")]
    pub feed_forward: Fraction<S>,
    /// Commanded speed per error of tilt and height, 1/s.
    #[serde(default = "gain::<S>")]
    pub position_gain_per_s: NonNegative<S>,
    /// Prediction over all delays; without it, the measured velocities are commanded.
    pub prediction: Option<HeavePrediction<S>>,
}

/// A drive that a compensation commands.
#[fields]
pub struct CompensationDrive {
    /// The controlled drive, with a speed as its set-point.
    pub drive: Name,
}

fn whole<S: Leaf>() -> Fraction<S> {
    Fraction::literal(1.0)
}

fn gain<S: Leaf>() -> NonNegative<S> {
    NonNegative::literal(0.1)
}

fn damped_below<S: Leaf>() -> NonNegative<S> {
    NonNegative::literal(0.1)
}

impl<S> SetsInputs for ThreeAxisCompensation<S> {
    fn targets(&self) -> Vec<(String, &str)> {
        let winch = ("drive".to_owned(), &*self.drive);
        if self.enabled { joint_targets(&self.joints).chain([winch]).collect() } else { Vec::new() }
    }

    fn sets_drives(&self) -> bool {
        true
    }
}

impl<S> SetsInputs for PlatformCompensation<S> {
    fn targets(&self) -> Vec<(String, &str)> {
        if self.enabled { joint_targets(&self.joints).collect() } else { Vec::new() }
    }

    fn sets_drives(&self) -> bool {
        true
    }
}

fn joint_targets(joints: &[CompensationDrive]) -> impl Iterator<Item = (String, &str)> {
    joints.iter().enumerate().map(|(k, joint)| (format!("joints.{k}.drive"), &*joint.drive))
}
