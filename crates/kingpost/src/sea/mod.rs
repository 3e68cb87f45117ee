//! The sea and floating bodies: waves, hulls, and hull data from potential theory.

pub mod database;
pub mod hull;
pub mod raos;
pub mod waves;
