//! The work of a crane: ropes, drives, contact, splash zone, operations.

#[path = "../common/mod.rs"]
mod common;

mod clearances;
mod connections;
mod contact_friction;
mod contact_mistakes;
mod contact_motions;
mod contacts;
mod controlled_drives;
mod controllers;
mod cylinder_compensators;
mod cylinders;
mod entrained_water;
mod heave_compensation;
mod inertial_unit;
mod inextensible_ropes;
mod line_along;
mod line_bending;
mod line_dynamics;
mod line_free_end;
mod line_joined;
mod line_joined_mistakes;
mod line_slope;
mod line_statics;
mod line_steps;
mod line_supply;
mod linear_check;
mod load_charts;
mod motion_compensation;
mod omitted_line_dynamics;
mod operations;
mod policies;
mod replays;
mod rope_leads;
mod rope_mistakes;
mod rope_motions;
mod rope_release_and_tuggers;
mod rope_weight;
mod ropes;
mod sensor_errors;
mod sensors;
mod submerged;
mod submerged_mistakes;
mod submerged_motions;
mod swing_estimator;
