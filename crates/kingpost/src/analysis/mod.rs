//! What is known of a model without a run, and of a run beside its numbers: exact linearisation,
//! equilibrium, gradients along parameters.

mod equilibrium;
mod gradient;
mod linearization;

pub use equilibrium::{Equilibrium, NoEquilibrium, settle};
pub use gradient::{Gradient, gradient};
pub use linearization::{Linearization, Linearizer};
