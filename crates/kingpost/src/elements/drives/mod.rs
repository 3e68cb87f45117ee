//! Drives of joints, one file each.

pub(crate) mod assembly;
mod brake;
mod controlled_drive;
mod cylinder;
pub(crate) mod fields;
mod motor;
mod oscillation;
mod prescribed;
mod servo;
mod time_function;
mod wave_motion;

pub use brake::Brake;
pub use controlled_drive::{ControlledDrive, DriveLimits, SetPoint};
pub use cylinder::{Aim, Cylinder};
pub use motor::Motor;
pub use oscillation::Oscillation;
pub use prescribed::PrescribedMotion;
pub use servo::Servo;
pub use time_function::{Pulse, TimeFunction};
pub use wave_motion::WaveMotion;
