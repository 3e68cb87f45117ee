//! The mechanics of bodies and joints: both forms, closed forms, conservation.

#[path = "../common/mod.rs"]
mod common;

mod analysis;
mod bias_force;
mod closed_forms;
mod closed_loops;
mod described;
mod flexible_bodies;
mod formulas;
mod gas_springs;
mod joint_features;
mod joint_kinds;
mod ledger;
mod loops_two_forms;
mod motions;
mod new_element;
mod random_trees;
mod reactions;
mod tops_and_pendulums;
mod two_forms;
