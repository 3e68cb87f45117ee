//! Stepping: schemes, events, batches, changes during a run.

#[path = "../common/mod.rs"]
mod common;

mod batch;
mod copies;
mod dormand_prince;
mod events;
mod integrators;
mod live_parameters;
mod orders;
mod orders_with_states;
mod run_warnings;
mod steps;
