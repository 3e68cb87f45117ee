//! What makes joints move, one file each.
//!
//! A new drive is one new file and one arm in each `match` of [`Drive`].

mod brake;
mod cylinder;
mod motor;
mod prescribed;
mod profile;
mod servo;
mod wave_motion;

pub use brake::Brake;
pub use cylinder::{Aim, Cylinder, CylinderReading};
pub use motor::Motor;
pub use prescribed::PrescribedMotion;
pub use profile::{Profile, Pulse};
pub use servo::Servo;
pub use wave_motion::WaveMotion;

use crate::dynamics::{LinkKinematics, Loads, Moment};
use crate::model::Model;
use crate::scalar::Scalar;

/// The kinds of drive.
#[derive(Clone, Debug)]
pub enum Drive<S = f64> {
    /// A torque or force as a function of time.
    Motor(Motor<S>),
    /// A position servo with a limit.
    Servo(Servo<S>),
    /// Friction that a lever sets.
    Brake(Brake<S>),
    /// A motion that happens whatever it takes.
    Prescribed(PrescribedMotion<S>),
    /// A motion with the waves, whatever it takes.
    WaveMotion(WaveMotion<S>),
    /// A hydraulic cylinder between two bodies.
    Cylinder(Cylinder<S>),
}

impl<S: Scalar> Drive<S> {
    /// Adds this drive to the loads.
    pub fn apply(&self, at: &Moment<'_, S>, loads: &mut Loads<S>) {
        match self {
            Drive::Motor(motor) => motor.apply(at.clock, at.v, at.held, loads),
            Drive::Servo(servo) => servo.apply(at.q, at.v, loads),
            Drive::Brake(brake) => brake.apply(at.v, at.held, loads),
            Drive::Prescribed(motion) => motion.apply(at.clock, loads),
            Drive::WaveMotion(motion) => motion.apply(at.clock.time_s, loads),
            Drive::Cylinder(cylinder) => cylinder.apply(at, loads),
        }
    }

    /// The cylinder, where it is one.
    pub fn cylinder(&self) -> Option<&Cylinder<S>> {
        if let Drive::Cylinder(cylinder) = self { Some(cylinder) } else { None }
    }

    /// Energy that the drive stores, J; zero for drives that store none.
    pub fn potential_energy(&self, model: &Model<S>, links: &LinkKinematics<S>) -> S {
        self.cylinder().map_or(S::ZERO, |cylinder| cylinder.potential_energy(model, links))
    }

    /// Whether it has an extra state: the length that a lever leads a cylinder to.
    pub fn has_state(&self) -> bool {
        self.cylinder().is_some_and(|cylinder| matches!(cylinder.aim, Aim::Lever { .. }))
    }

    /// Times at which the drive's law changes its form, s: steps end there.
    pub fn edges(&self) -> &[f64] {
        match self {
            Drive::Cylinder(cylinder) => &cylinder.arrival_s,
            _ => self.profile().map_or(&[], Profile::edges),
        }
    }

    /// The history that it follows, if it follows one.
    pub fn profile(&self) -> Option<&Profile<S>> {
        match self {
            Drive::Motor(motor) => Some(&motor.profile),
            Drive::Prescribed(motion) => Some(&motion.profile),
            Drive::Servo(_) | Drive::Cylinder(_) | Drive::Brake(_) | Drive::WaveMotion(_) => None,
        }
    }
}
