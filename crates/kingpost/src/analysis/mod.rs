//! What is known of a model without a run, and of a run beside its numbers: exact linearisation
//! and gradients along parameters.

mod gradient;
mod linearization;
mod response;

pub use gradient::{Gradient, gradient};
pub use linearization::{LinearNames, Linearization, Linearizer};
pub use response::{ResponseError, WaveGrid, WaveResponse};
