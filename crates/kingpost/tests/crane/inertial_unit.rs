//! Inertial unit: the motion that its filter estimates, and the effect of errors of its instruments.

use crate::common;

use common::{values, with_changes};
use kingpost::simulation::Simulation;
use serde_json::{Value, json};
use std::f64::consts::TAU;

/// A raft with prescribed heave, and roll about an axis 5 m below its unit.
const TEXT: &str = "
version: 1
title: An inertial unit
simulation: {step_s: 0.02, duration_s: 4, record_every_s: 0.1}
bodies:
  stem:
    mass_kg: 1000
    shape: {box: {length_m: 1, width_m: 1, height_m: 1}}
    joint: {prismatic: {name: heave, axis: [0, 0, 1], mode: {oscillation: {amplitude_m: 1, period_s: 8, ramp_s: 30}}}}
  raft:
    parent: stem
    mass_kg: 1000
    shape: {box: {length_m: 1, width_m: 1, height_m: 1}}
    joint: {revolute: {name: roll, axis: [1, 0, 0], mode: {oscillation: {amplitude_deg: 10, period_s: 10, ramp_s: 30}}}}
forces:
  gravity: {gravity: {}}
sensors:
  inertial:
    inertial_unit: {body: raft, position_m: [0, 0, 5], period_s: 0.02, filter: {wave_period_s: 9, wave_motion_m: 0.7}}
";

fn changed(changes: &[(&str, Value)]) -> Simulation {
    with_changes(TEXT, changes).unwrap_or_else(|error| panic!("{error}"))
}

const UNIT: &str = "sensors.inertial.inertial_unit";

/// Returns the unit's estimates over 40 s after 400 s: roll (rad), heave (m), heave rate (m/s), with their
/// true values.
fn settled(changes: &[(&str, Value)]) -> Vec<[[f64; 2]; 3]> {
    let mut simulation = changed(changes);
    simulation.step(20_000).unwrap();
    let mut rows = Vec::new();
    for _ in 0..400 {
        simulation.step(5).unwrap();
        let mut of = |variable: &str| values(&mut simulation, variable)[0];
        let (found_roll, found, found_rate) = (of("measured_roll"), of("measured_heave"), of("measured_heave_rate"));
        let joints = values(&mut simulation, "joint_position");
        let rates = values(&mut simulation, "joint_velocity");
        let (heave, roll) = (joints[0], joints[1]);
        let rate = rates[0] - 5.0 * roll.sin() * rates[1];
        rows.push([[found_roll, roll], [found, heave + 5.0 * (roll.cos() - 1.0)], [found_rate, rate]]);
    }
    rows
}

/// Returns the largest deviation of the estimate from the true value, without its mean.
fn largest(rows: &[[[f64; 2]; 3]], quantity: usize) -> f64 {
    let off: Vec<f64> = rows.iter().map(|row| row[quantity][0] - row[quantity][1]).collect();
    let mean = off.iter().sum::<f64>() / off.len() as f64;
    off.iter().fold(0.0, |largest, x| largest.max((x - mean).abs()))
}

/// The unit is accelerated sideways by a lever arm of 5 m times 10 degrees at 10 s, 0.34 m/s^2: an
/// inclinometer would have an error of 2 degrees. Waves pass the stationary gains by a few per cent of the
/// displacement at most, and by less of the velocity and of the tilt.
#[test]
fn an_inertial_unit_estimates_roll_heave_and_heave_rate_in_waves() {
    let rows = settled(&[]);
    let [roll, heave, rate] = [0, 1, 2].map(|quantity| largest(&rows, quantity));
    assert!(roll.to_degrees() < 0.05, "roll is off by {} deg", roll.to_degrees());
    assert!(heave < 0.03, "heave is off by {heave} m of 1 m");
    assert!(rate < 0.01 * TAU / 8.0, "the heave rate is off by {rate} m/s");
}

/// At this period, the filter of a motion reference unit with a cut-off of 20 s leads by 34 degrees.
#[test]
fn the_phase_is_correct_for_waves_of_half_or_twice_the_assumed_period() {
    for period_s in [4.5, 18.0] {
        let rows = settled(&[("sensors.inertial.inertial_unit.filter.wave_period_s", json!(period_s))]);
        let rate = largest(&rows, 2);
        assert!(rate < 0.03 * TAU / 8.0, "{period_s} s: the heave rate is off by {rate} m/s");
    }
}

/// A unit that was at rest before knows the errors along its vertical and of its rates; what its accelerometers err by
/// across it tilts its horizon by bias over g.
#[test]
fn constant_errors_of_an_inertial_unit_only_tilt_its_horizon() {
    let upright = [("bodies.raft.joint.revolute.mode", json!("held"))];
    let biased = [
        upright[0].clone(),
        ("sensors.inertial.inertial_unit.acceleration_errors", json!({"bias_m_s2": 0.02})),
        ("sensors.inertial.inertial_unit.rate_errors", json!({"bias_rad_s": 1e-4})),
    ];
    let (exact, found) = (settled(&upright), settled(&biased));
    for (exact, found) in exact.iter().zip(&found) {
        // The rest is of the order of the tilt squared.
        assert!((found[1][0] - exact[1][0]).abs() < 1e-4 && (found[2][0] - exact[2][0]).abs() < 1e-4, "{found:?}");
        assert!((found[0][0].abs() - 0.02 / 9.80665).abs() < 1e-4, "{found:?}");
    }
}

#[test]
fn an_inertial_unit_at_rest_measures_the_reaction_to_its_weight() {
    let mut simulation = changed(&[
        ("bodies.stem.joint.prismatic.mode", json!("held")),
        ("bodies.raft.joint.revolute.mode", json!("held")),
        ("bodies.raft.joint.revolute.initial_angle_deg", json!(30)),
    ]);
    simulation.step(100).unwrap();
    let [x, y, z] = values(&mut simulation, "measured_specific_force")[..] else { panic!("three components") };
    let expected = [0.0, 9.80665 * 0.5, 9.80665 * 30_f64.to_radians().cos()];
    assert!([x, y, z].iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-12), "{x} {y} {z}");
    assert!((values(&mut simulation, "measured_roll")[0] - 30_f64.to_radians()).abs() < 1e-12);
    assert!(values(&mut simulation, "measured_heave")[0].abs() < 1e-12);
}

/// A ship whose draught increases by 2 m over two minutes: without a receiver this does not count as motion;
/// with a receiver it is estimated.
fn sinking(with: &[(&str, Value)]) -> [f64; 2] {
    let history = json!({"travel": {"length_m": -2, "start_s": 10, "duration_s": 120, "ramp_s": 30}});
    let mut changes =
        vec![("bodies.stem.joint.prismatic.mode", history), ("bodies.raft.joint.revolute.mode", json!("held"))];
    changes.extend_from_slice(with);
    let mut simulation = changed(&changes);
    simulation.step(15_000).unwrap();
    [values(&mut simulation, "measured_heave")[0], values(&mut simulation, "joint_position")[0]]
}

#[test]
fn an_inertial_unit_with_a_receiver_estimates_slow_motion_and_continues_after_a_drop_out() {
    let receiver = |more: Value| {
        let mut receiver = json!({"body": "raft", "position_m": [3, -2, 8], "period_s": 0.1, "delay_samples": 1});
        receiver.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
        json!({"satellite_receiver": receiver})
    };
    let with = |more: Value| {
        vec![("sensors.gnss", receiver(more)), ("sensors.inertial.inertial_unit.receiver", json!("gnss"))]
    };
    let [alone, depth] = sinking(&[]);
    let [helped, _] = sinking(&with(json!({})));
    let [noisy, _] = sinking(&with(json!({"vertical_errors": {"noise_m": 0.02}})));
    let [failing, _] = sinking(&with(json!({"drop_outs": {"mean_interval_s": 20, "mean_duration_s": 5}})));
    assert!((depth + 2.0).abs() < 1e-9 && alone.abs() < 0.2, "{alone} of {depth}");
    assert!((helped + 2.0).abs() < 1e-3 && (noisy + 2.0).abs() < 0.05, "{helped}, {noisy}");
    assert!((failing + 2.0).abs() < 0.2, "{failing}");
}

#[test]
fn what_cannot_be_is_named_with_its_place() {
    let error = |changes: &[(&str, Value)]| {
        with_changes(TEXT, changes).map_or_else(|error| error.to_string(), |_| "none".to_owned())
    };
    let stem = json!({"satellite_receiver": {"body": "stem", "period_s": 0.1}});
    for (changes, place, what) in [
        (vec![("body", json!("rat"))], "body", "raft"),
        (vec![("receiver", json!("gnss"))], "receiver", "does not have a satellite receiver"),
        (vec![("filter", json!({"wave_period_s": 0.05}))], "filter.wave_period_s", "at least four times period_s"),
        (vec![("filter", json!({"wave_motion_m": 1e-200}))], "filter", "finite filter gains"),
        (vec![("delay_samples", json!(1001))], "delay_samples", "0 to 1000"),
    ] {
        let changes: Vec<(String, Value)> =
            changes.into_iter().map(|(rest, value)| (format!("{UNIT}.{rest}"), value)).collect();
        let changes: Vec<(&str, Value)> = changes.iter().map(|(path, value)| (path.as_str(), value.clone())).collect();
        let found = error(&changes);
        assert!(found.contains(&format!("{UNIT}.{place}")) && found.contains(what), "{found}");
    }
    let on_another = [("sensors.gnss", stem), ("sensors.inertial.inertial_unit.receiver", json!("gnss"))];
    let found = error(&on_another);
    assert!(found.contains("which is on stem") && found.contains("a satellite receiver on raft"), "{found}");
}

/// The heading is that of the gyrocompass, with its constant error from the start.
#[test]
fn the_yaw_of_an_inertial_unit_is_that_of_the_gyrocompass() {
    let errors = [("sensors.inertial.inertial_unit.heading_errors", json!({"bias_rad": 0.01}))];
    let mut simulation = changed(&errors);
    for _ in 0..20 {
        simulation.step(50).unwrap();
        let yaw = values(&mut simulation, "measured_yaw")[0];
        assert!((yaw - 0.01).abs() < 1e-4, "{yaw}");
    }
}
