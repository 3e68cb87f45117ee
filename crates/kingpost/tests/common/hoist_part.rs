//! A part that is a hoist, a ship on which it is mounted, and functions that read both.

use kingpost::scenario::{Files, Scenario, ScenarioError, read_with};
use serde_json::Value;

/// A hoist: a trolley on a rail, a block on it, a winch, a stay to what it stands on, and a line.
pub const HOIST: &str = "\
version: 1
title: A hoist
parameters:
  - {name: load_t, label: Load, unit: t, default: 2, range: [1, 9], writes: [bodies.block.mass_t]}
  - {name: reach_m, default: 1, writes: [drives.winch.linear_servo.target_m]}
bodies:
  trolley:
    mass_t: 1
    shape: {sphere: {radius_m: 0.5}}
    joint: {prismatic: {name: rail, axis: [1, 0, 0], position_m: [0.5, 0, 2], orientation_deg: [0, 0, 10]}}
    points: {eye: {position_m: [0, 0, -1]}}
  block:
    parent: trolley
    mass_t: 1
    shape: {sphere: {radius_m: 0.2}}
    joint: {universal: {first_axis: [1, 0, 0], second_axis: [0, 1, 0], child_position_m: [0, 0, 3]}}
loops:
  stay: {enabled: false, first: {body: world, position_m: [1, 2, 3], orientation_deg: [0, 0, 20]}, second: {body: block}, constraints: [x]}
forces:
  line: {spring_line: {first: {body: trolley}, second: {body: world, position_m: [0, 0, 9]}, unstretched_length_m: 20, axial_stiffness_N: 5}}
drives:
  winch: {linear_servo: {joint: rail, target_m: 1, stiffness_N_per_m: 1, damping_N_s_per_m: 1, force_limit_N: 1}}
  grip: {brake: {joint: block.first, torque_N_m: 1, state: lever}}
";

pub const SHIP: &str = "\
version: 1
title: A ship
bodies:
  ship: {mass_t: 100, shape: {box: {length_m: 20, width_m: 6, height_m: 3}}, joint: {floating: {}}}
parts:
  crane: {part: hoist.yaml, on: ship, position_m: [4, 0, 1.5]}
";

/// Texts by name; `ship.yaml` is the main one.
pub fn texts(given: &[(&str, &str)]) -> Files {
    Files::new(given.iter().map(|(name, text)| ((*name).to_owned(), (*text).to_owned())))
}

pub fn with_hoist(ship: &str, set: &[(&str, Value)]) -> Result<Scenario, ScenarioError> {
    let set: Vec<_> = set.iter().map(|(name, value)| ((*name).to_owned(), value.clone())).collect();
    read_with(ship, "ships/ship.yaml", &set, &texts(&[("hoist.yaml", HOIST)]))
}

#[track_caller]
pub fn error(ship: &str, hoist: &str, set: &[(&str, Value)]) -> String {
    let set: Vec<_> = set.iter().map(|(name, value)| ((*name).to_owned(), value.clone())).collect();
    let files = texts(&[("hoist.yaml", hoist), ("ship.yaml", ship)]);
    read_with(ship, "ships/ship.yaml", &set, &files).map(drop).expect_err("this should be refused").to_string()
}

/// The place `line:column` at which this stands in a text.
#[track_caller]
pub fn place(text: &str, at: &str) -> String {
    let before = &text[..text.find(at).unwrap_or_else(|| panic!("no {at:?} in the text"))];
    let line = before.matches('\n').count() + 1;
    format!("{line}:{}", before.chars().rev().take_while(|c| *c != '\n').count() + 1)
}

pub fn json_of(scenario: &Scenario) -> Value {
    serde_json::from_str(&scenario.to_json()).expect("it is JSON")
}
