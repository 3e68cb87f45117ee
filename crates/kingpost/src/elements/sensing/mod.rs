//! Sensors of a crane, and what all sensors have in common: noise, bias, resolution, delay, drop-outs, the gains of their filters.

pub(crate) mod assembly;
mod encoder;
mod errors;
pub(crate) mod fields;
mod load_cell;
mod position_aid;
mod process;
mod sampler;
mod satellite_receiver;

pub use encoder::Encoder;
pub use errors::{DropOuts, SensorNoise, SignalErrors, with_errors};
pub use load_cell::LoadCell;
pub use position_aid::{PositionAid, ReceiverSample};
pub use process::{Oscillating, Process, RATE_WANDERS, first};
pub use sampler::Sampler;
pub use satellite_receiver::SatelliteReceiver;
