//! The sea and what floats in it: water at rest, hulls.

pub mod hull;
