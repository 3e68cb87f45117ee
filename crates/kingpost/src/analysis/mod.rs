//! Analyses of a model: linearisation, natural modes and response to waves, without a run, and gradients of a
//! run's results with respect to parameters.

#[cfg(not(target_family = "wasm"))]
mod gradient;
#[cfg(not(target_family = "wasm"))]
mod linearization;
mod natural_modes;
#[cfg(not(target_family = "wasm"))]
mod response;
mod shifted;

#[cfg(not(target_family = "wasm"))]
pub use gradient::{Gradient, gradient};
#[cfg(not(target_family = "wasm"))]
pub use linearization::{LinearNames, Linearization, Linearizer};
pub use natural_modes::{ModesError, NaturalMode, natural_modes};
#[cfg(not(target_family = "wasm"))]
pub use response::{ColumnResponse, NotLinear, RandomSea, Resonance, ResponseError, WaveGrid, WaveResponse};
