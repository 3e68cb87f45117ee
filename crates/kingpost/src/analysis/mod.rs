//! What is known of a model without a run, and of a run beside its numbers: exact linearisation
//! and gradients along parameters.

mod gradient;
mod linearization;

pub use gradient::{Gradient, gradient};
pub use linearization::{Linearization, Linearizer};
