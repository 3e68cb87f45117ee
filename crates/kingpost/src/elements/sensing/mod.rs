//! Sensors of a crane, and what all sensors have in common: noise, bias, resolution, delay, drop-outs.

mod encoder;
mod errors;
mod load_cell;
mod sampler;
mod satellite_receiver;
mod slow_motion;

pub use encoder::Encoder;
pub use errors::{DropOuts, SensorNoise, SignalErrors};
pub use load_cell::LoadCell;
pub use sampler::Sampler;
pub use satellite_receiver::SatelliteReceiver;
pub use slow_motion::SlowMotion;
