//! Ship-and-crane dynamics at sea by the moving frame method.
//!
//! The modules are listed in reading order, which is the order of dependency: each uses only those before it.
//! Data flow in one direction:
//!
//! ```text
//! scenario -> model -> dynamics (+ loads from forces, drives) -> integrator -> results -> views
//! ```
//!
//! The engine does not read or write files, print, read a clock, or use random numbers without a seed.

#![forbid(unsafe_code)]
#![warn(missing_docs)]

pub mod scalar;
pub mod spatial;

pub mod model;
pub mod state;

pub mod dynamics;

pub mod sea;
pub mod world;

pub mod elements;

pub mod integrate;
pub mod ledger;
pub mod plant;
pub mod results;
pub mod simulation;

pub mod scenario;

pub mod hydrostatics;

pub mod analysis;
#[cfg(not(target_family = "wasm"))]
pub mod batch;

pub use scenario::Scenario;
pub use simulation::Simulation;
