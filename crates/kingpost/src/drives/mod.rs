//! What makes joints move, one file each.
//!
//! A new drive is one new file and one arm in each `match` of [`Drive`].

mod brake;
mod motor;
mod prescribed;
mod profile;
mod servo;

pub use brake::Brake;
pub use motor::Motor;
pub use prescribed::PrescribedMotion;
pub use profile::{Clock, Profile, Pulse};
pub use servo::Servo;

use crate::dynamics::Loads;
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
}

impl<S: Scalar> Drive<S> {
    /// Adds this drive to the loads. `inputs` are the values of the input table.
    pub fn apply(&self, clock: Clock, q: &[S], v: &[S], inputs: &[S], loads: &mut Loads<S>) {
        match self {
            Drive::Motor(motor) => motor.apply(clock, v, inputs, loads),
            Drive::Servo(servo) => servo.apply(q, v, loads),
            Drive::Brake(brake) => brake.apply(v, inputs, loads),
            Drive::Prescribed(motion) => motion.apply(clock, loads),
        }
    }

    /// Times at which the drive's law changes its form, s: steps end there.
    pub fn edges(&self) -> &[f64] {
        match self {
            Drive::Motor(motor) => motor.profile.edges(),
            Drive::Prescribed(motion) => motion.profile.edges(),
            Drive::Servo(_) | Drive::Brake(_) => &[],
        }
    }
}
