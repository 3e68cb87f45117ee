//! Sensors of a crane, and the parts common to all sensors: noise, bias, resolution, delay, drop-outs, and the gains of
//! filters.

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
