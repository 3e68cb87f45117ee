//! What makes joints move, one file each.
//!
//! A new drive is one new file and one arm in each `match` of [`Drive`].

mod motor;
mod prescribed;
mod profile;
mod servo;

pub use motor::Motor;
pub use prescribed::PrescribedMotion;
pub use profile::{Clock, Profile, Pulse};
pub use servo::Servo;

use crate::dynamics::Loads;

/// The kinds of drive.
#[derive(Clone, Debug)]
pub enum Drive {
    /// A torque or force as a function of time.
    Motor(Motor),
    /// A position servo with a limit.
    Servo(Servo),
    /// A motion that happens whatever it takes.
    Prescribed(PrescribedMotion),
}

impl Drive {
    /// Adds this drive to the loads. `inputs` are the values of the input table.
    pub fn apply(&self, clock: Clock, q: &[f64], v: &[f64], inputs: &[f64], loads: &mut Loads) {
        match self {
            Drive::Motor(motor) => motor.apply(clock, v, inputs, loads),
            Drive::Servo(servo) => servo.apply(q, v, loads),
            Drive::Prescribed(motion) => motion.apply(clock, loads),
        }
    }

    /// Times at which the drive's law changes its form, s: steps end there.
    pub fn edges(&self) -> &[f64] {
        match self {
            Drive::Motor(motor) => motor.profile.edges(),
            Drive::Prescribed(motion) => motion.profile.edges(),
            Drive::Servo(_) => &[],
        }
    }
}
