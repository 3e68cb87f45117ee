//! Swing estimator: the swing that its filter estimates, and the effect of errors of its gyroscopes.

use crate::common;

use common::{values, with_changes};
use serde_json::{Value, json};

/// A load on 20 m of rope, 9 s, under a trolley; it hangs by a universal joint and turns with the trolley's turntable.
const TEXT: &str = "
version: 1
title: A swing estimator
simulation: {step_s: 0.02, duration_s: 4, record_every_s: 0.1}
bodies:
  trolley:
    mass_kg: 1000
    shape: {box: {length_m: 1, width_m: 1, height_m: 1}}
    joint: {prismatic: {name: travel, axis: [0, 1, 0], mode: held}}
  turntable:
    parent: trolley
    mass_kg: 100
    shape: {box: {length_m: 1, width_m: 1, height_m: 1}}
    joint: {revolute: {name: turn, axis: [0, 0, 1], mode: held}}
  load:
    parent: turntable
    mass_kg: 20000
    shape: {box: {length_m: 1, width_m: 1, height_m: 1}}
    joint:
      universal:
        name: pendant
        first_axis: [1, 0, 0]
        second_axis: [0, 1, 0]
        child_position_m: [0, 0, 20]
        first: {initial_angle_deg: 3}
        second: {initial_angle_deg: -2}
forces:
  gravity: {gravity: {}}
sensors:
  gyros: {swing_estimator: {body: load, period_s: 0.02, filter: {swing_period_s: 9, swing_rad: 0.03}}}
";

const GYROS: &str = "sensors.gyros.swing_estimator";

/// Returns the largest error of roll and pitch over 60 s after a time, rad, and the largest swing in this
/// time.
fn largest_error(after_s: f64, changes: &[(&str, Value)]) -> [f64; 2] {
    let mut simulation = with_changes(TEXT, changes).unwrap_or_else(|error| panic!("{error}"));
    simulation.step((after_s / 0.02) as usize).unwrap();
    let (mut error, mut swing) = (0.0_f64, 0.0_f64);
    for _ in 0..600 {
        simulation.step(5).unwrap();
        let bodies = ["roll", "pitch"].map(|angle| values(&mut simulation, angle)[2]);
        let found = ["measured_roll", "measured_pitch"].map(|angle| values(&mut simulation, angle)[0]);
        for (found, exact) in found.into_iter().zip(bodies) {
            error = error.max((found - exact).abs());
            swing = swing.max(exact.abs());
        }
    }
    [error, swing]
}

/// Checks the error with the stationary gains: it is below a per cent for a steady swing of the assumed period, and a
/// few per cent for half and twice that period.
#[test]
fn the_estimator_finds_phase_and_amplitude_of_a_free_swing() {
    let [error, swing] = largest_error(300.0, &[]);
    assert!(swing > 0.04 && error < 0.01 * swing, "{error} of {swing}");
    for period_s in [4.5, 18.0] {
        let [error, swing] = largest_error(300.0, &[(&format!("{GYROS}.filter.swing_period_s"), json!(period_s))]);
        assert!(error < 0.05 * swing, "{period_s} s: {error} of {swing}");
    }
}

/// The swing keeps its plane while the load rotates below it at 3 degrees per second: the states of the
/// filter rotate back.
#[test]
fn a_turning_load_does_not_turn_the_swing_in_the_filter() {
    let turning = json!({"travel": {"angle_deg": 1800, "start_s": 5, "duration_s": 600, "ramp_s": 10}});
    let [error, swing] = largest_error(300.0, &[("bodies.turntable.joint.revolute.mode", turning)]);
    assert!(swing > 0.03 && error < 0.015 * swing, "{error} of {swing}");
}

/// The pivot starts, travels and stops: the load swings as the acceleration makes it, which no gyroscope measures.
#[test]
fn a_swing_caused_by_a_travel_is_estimated_at_once() {
    let still = json!(0);
    let travel = json!({"travel": {"length_m": 20, "start_s": 20, "duration_s": 30, "ramp_s": 6}});
    let [error, swing] = largest_error(
        0.0,
        &[
            ("bodies.trolley.joint.prismatic.mode", travel),
            ("bodies.load.joint.universal.first.initial_angle_deg", still.clone()),
            ("bodies.load.joint.universal.second.initial_angle_deg", still),
        ],
    );
    assert!(swing > 0.01 && error < 0.05 * swing, "{error} of {swing}");
}

/// An error of the gyroscopes of 0.1 degrees per second would be 60 degrees in ten minutes. What noise leaves follows from its
/// integral over the time constant of the filter, about 1e-4 rad.
#[test]
fn errors_of_the_gyroscopes_do_not_accumulate() {
    let errors = json!({"bias_rad_s": 1.7e-3, "noise_rad_s": 3e-4});
    let [error, swing] = largest_error(600.0, &[(&format!("{GYROS}.rate_errors"), errors)]);
    assert!(swing > 0.04 && error < 0.015 * swing, "{error} of {swing}");
}

#[test]
fn what_cannot_be_is_named_with_its_place() {
    for (field, value, what) in [
        ("body", json!("loat"), "load"),
        ("filter", json!({"swing_period_s": 0.05}), "at least four times period_s"),
        ("filter", json!({"swing_rad": 1e-200}), "finite filter gains"),
        ("delay_samples", json!(1001), "0 to 1000"),
    ] {
        let found = with_changes(TEXT, &[(&format!("{GYROS}.{field}"), value)])
            .map_or_else(|error| error.to_string(), |_| String::new());
        assert!(found.contains(&format!("{GYROS}.{field}")) && found.contains(what), "{found}");
    }
}
