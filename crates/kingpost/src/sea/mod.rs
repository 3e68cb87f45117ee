//! The sea and what floats in it: waves, hulls, and what potential theory knows of them.

pub mod database;
pub mod hull;
pub mod raos;
pub mod waves;
