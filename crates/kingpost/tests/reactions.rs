//! What joints carry, against statics.

mod common;

use common::{simulation, values};

const GRAVITY: f64 = 9.80665;

/// A pedestal on the world, a level boom held on it, a load lashed to the boom's tip.
fn at_rest() -> Vec<[f64; 6]> {
    let text = "
version: 1
title: Statics
bodies:
  pedestal: {mass_kg: 1000, shape: {box: {length_m: 1, width_m: 1, height_m: 2}}, joint: {fixed: {child_position_m: [0, 0, -1]}}}
  boom:
    parent: pedestal
    mass_kg: 100
    shape: {box: {length_m: 4, width_m: 1, height_m: 1}}
    joint: {revolute: {axis: [0, 1, 0], position_m: [0, 0, 1], child_position_m: [-2, 0, 0], mode: held}}
  load: {parent: boom, mass_kg: 50, shape: {point: {}}, joint: {fixed: {position_m: [2, 0, 0]}}}
forces: {gravity: {gravity: {}}}
";
    let mut simulation = simulation(text);
    values(&mut simulation, "joint_reaction").chunks(6).map(|c| c.try_into().unwrap()).collect()
}

fn assert_close(found: [f64; 6], expected: [f64; 6]) {
    assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9 * GRAVITY * 1e3), "{found:?} {expected:?}");
}

#[test]
fn a_lashed_load_hangs_on_its_lashing() {
    assert_close(at_rest()[2], [0.0, 0.0, 50.0 * GRAVITY, 0.0, 0.0, 0.0]);
}

#[test]
fn a_held_boom_has_its_cantilever_moment_at_the_hinge() {
    // Weights at 2 m and 4 m pull the tip down, a positive moment about y; the hinge carries the
    // opposite.
    let moment = -(100.0 * 2.0 + 50.0 * 4.0) * GRAVITY;
    assert_close(at_rest()[1], [0.0, 0.0, 150.0 * GRAVITY, 0.0, moment, 0.0]);
}

#[test]
fn a_pedestal_hands_everything_to_the_world() {
    let moment = -(100.0 * 2.0 + 50.0 * 4.0) * GRAVITY;
    assert_close(at_rest()[0], [0.0, 0.0, 1150.0 * GRAVITY, 0.0, moment, 0.0]);
}

#[test]
fn a_motor_and_its_friction_are_the_force_along_the_joint() {
    let text = "
version: 1
title: A motor against friction
bodies:
  drum:
    mass_kg: 10
    shape: {cylinder: {radius_m: 1, length_m: 1}}
    joint: {revolute: {axis: [0, 0, 1], damping_N_m_s: 4, initial_rate_rad_s: 3}}
drives: {motor: {motor: {joint: drum, torque_N_m: 20}}}
";
    let force = values(&mut simulation(text), "joint_force");
    assert!((force[0] - (20.0 - 4.0 * 3.0)).abs() < 1e-12, "{force:?}");
}
