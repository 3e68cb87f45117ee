//! Analysis of a model without a run, and of a run beyond its numbers: exact linearisation and gradients along
//! parameters.

#[cfg(not(target_family = "wasm"))]
mod gradient;
#[cfg(not(target_family = "wasm"))]
mod linearization;
mod natural_modes;
#[cfg(not(target_family = "wasm"))]
mod response;

#[cfg(not(target_family = "wasm"))]
pub use gradient::{Gradient, gradient};
#[cfg(not(target_family = "wasm"))]
pub use linearization::{LinearNames, Linearization, Linearizer};
pub use natural_modes::{ModesError, NaturalMode, natural_modes};
#[cfg(not(target_family = "wasm"))]
pub use response::{ColumnResponse, NotLinear, Resonance, ResponseError, WaveGrid, WaveResponse};
