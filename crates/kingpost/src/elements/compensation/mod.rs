//! Compensation of a ship's motion: measurement, prediction, driven joints and controllers.

pub(crate) mod assembly;
mod chain;
mod estimate;
pub(crate) mod fields;
mod forecast;
mod heave;
mod hoist;
mod lever;
mod measurement;
mod platform;
mod predictor;
mod three_axis;

pub use chain::{DrivenChain, DrivenJoint};
pub use estimate::{Estimate, Estimator, Prediction};
pub use forecast::{HeaveForecast, SCORED};
pub use heave::HeaveCompensation;
pub use hoist::{Hoist, LetOut, MovedSheaves};
pub use measurement::{Measured, Measurement};
pub use platform::PlatformCompensation;
pub use predictor::{Dynamics, FilterBank, PeriodBand};
pub use three_axis::ThreeAxisCompensation;
