//! The sea and what floats in it: waves, hulls, and their data from potential theory.

pub mod database;
pub mod hull;
pub mod raos;
pub mod waves;
