//! The sea and what floats in it: waves, hulls.

pub mod hull;
pub mod waves;
