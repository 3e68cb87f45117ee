//! Sensors that sample, and wires that connect their values to inputs of other elements.

use crate::common;

use common::values;
use kingpost::batch;
use kingpost::scenario::{Files, Scenario, ScenarioError, read, read_with};
use kingpost::simulation::{InputError, Simulation};
use serde_json::{Value, json};
use std::collections::HashMap;

/// A deck that rises at a constant speed, and a block below it on a winch that pays out the rise of the deck.
const DECK: &str = "
version: 1
title: A deck that rises, and a load that stays
simulation: {step_s: 0.01, duration_s: 2, record_every_s: 0.01}
bodies:
  deck:
    mass_kg: 1000
    shape: {box: {length_m: 4, width_m: 2, height_m: 1}}
    joint: {prismatic: {axis: [0, 0, 1], mode: {prescribed: {speed_m_s: 0.5}}}}
  block:
    parent: deck
    mass_kg: 100
    shape: {box: {length_m: 1, width_m: 1, height_m: 1}}
    joint: {prismatic: {name: rope, axis: [0, 0, -1], initial_extension_m: 3.00098}}
forces:
  gravity: {gravity: {}}
drives:
  winch:
    linear_servo: {joint: rope, target_m: 3, stiffness_N_per_m: 1.0e6, damping_N_s_per_m: 2.0e4, force_limit_N: 1.0e5}
  slew: {linear_motor: {joint: rope, force_N: 1, history: lever}}
sensors:
  mru: {motion_reference_unit: {body: deck, position_m: [1, 0, 0], period_s: 0.1, delay_samples: 2}}
wires:
  compensation: {from: mru.measured_heave, to: winch.target_offset}
";

fn deck(changes: &[(&str, Value)]) -> Result<Scenario, ScenarioError> {
    let changes: Vec<(String, Value)> =
        changes.iter().map(|(path, value)| ((*path).to_owned(), value.clone())).collect();
    read(DECK, "deck.yaml", &changes)
}

fn simulation(changes: &[(&str, Value)]) -> Simulation {
    let scenario = deck(changes).unwrap_or_else(|error| panic!("{error}"));
    scenario.simulation().expect("it builds")
}

fn error(changes: &[(&str, Value)]) -> String {
    deck(changes).map(drop).expect_err("a mistake").to_string()
}

#[test]
fn a_sensor_with_delay_holds_the_value_of_an_earlier_sample() {
    let mut simulation = simulation(&[]);
    for step in 0..200_u32 {
        // Ticks every tenth of a second, two of them late: 0.5 m/s times the time of that tick.
        let tick = (step / 10).saturating_sub(2);
        let expected = 0.05 * f64::from(tick);
        let heave = values(&mut simulation, "measured_heave")[0];
        assert!((heave - expected).abs() < 1e-12, "{heave} m, not {expected} m at step {step}");
        assert_eq!(values(&mut simulation, "measured_roll"), [0.0]);
        let rate = values(&mut simulation, "measured_heave_rate")[0];
        assert!((rate - 0.5).abs() < 1e-12, "{rate} m/s");
        simulation.step(1).unwrap();
    }
}

#[test]
fn a_sensor_on_a_rotating_body_measures_its_roll_and_its_yaw_rate() {
    let text = "
version: 1
title: A drum
simulation: {step_s: 0.01}
bodies:
  drum:
    mass_kg: 10
    shape: {box: {length_m: 1, width_m: 1, height_m: 1}}
    joint: {revolute: {axis: [1, 0, 0], mode: {prescribed: {rate_rad_s: 0.3}}}}
sensors:
  mru: {motion_reference_unit: {body: drum, position_m: [0, 2, 0], period_s: 0.05}}
";
    let mut simulation = read(text, "drum.yaml", &[]).and_then(|drum| drum.simulation()).expect("it builds");
    simulation.step(100).unwrap();
    // Roll 0.3 rad at 1 s; the point 2 m to port is 2 sin(roll) up and rises at 2 cos(roll) 0.3.
    let near = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-12, "{found}, not {expected}");
    near(values(&mut simulation, "measured_roll")[0], 0.3);
    near(values(&mut simulation, "measured_heave")[0], 2.0 * 0.3_f64.sin());
    near(values(&mut simulation, "measured_heave_rate")[0], 0.6 * 0.3_f64.cos());
    let turning = values(&mut simulation, "measured_angular_velocity");
    assert!((turning[0] - 0.3).abs() < 1e-12 && turning[1] == 0.0 && turning[2] == 0.0, "{turning:?}");
}

#[test]
fn a_winch_wired_to_a_sensor_pays_out_the_rise_of_the_deck() {
    let mut wired = simulation(&[]);
    let mut without = simulation(&[("wires.compensation.enabled", json!(false))]);
    wired.step(200).unwrap();
    without.step(200).unwrap();
    let height = |simulation: &mut Simulation| values(simulation, "position")[5];
    let (stays, rises) = (height(&mut wired) + 3.0, height(&mut without) + 3.0);
    // The block lags by three samples at most, and by c / k of the servo: 0.5 m/s times 0.32 s; the weight's stretch is 1 mm.
    assert!(stays > 0.0 && stays < 0.5 * 0.32 + 0.002, "{stays} m");
    assert!((rises - 1.0).abs() < 0.01, "{rises} m");
    let inputs = wired.inputs();
    let offset = inputs.iter().find(|input| input.name == "winch.target_offset").expect("the wired input");
    assert_eq!(offset.value, values(&mut wired, "measured_heave")[0]);
    assert_eq!(offset.signal.as_deref(), Some("mru.measured_heave"));
    assert!(without.inputs().iter().all(|input| input.name != "winch.target_offset"));
}

#[test]
fn a_user_cannot_set_a_wired_input() {
    let refused = simulation(&[]).set_input("winch.target_offset", 1.0);
    let (name, signal) = ("winch.target_offset".to_owned(), "mru.measured_heave".to_owned());
    assert_eq!(refused, Err(InputError::Wired { name, signal }));
}

#[test]
fn an_error_of_a_wire_without_an_existing_end_lists_the_existing_ones() {
    let found = error(&[("wires.compensation.from", json!("mru.measured_heav"))]);
    assert!(
        found.contains("wires.compensation.from: found mru.measured_heav, allowed: one of mru.measured_roll"),
        "{found}"
    );
    assert!(found.contains("did you mean mru.measured_heave?"), "{found}");
    let found = error(&[("wires.compensation.to", json!("winch"))]);
    assert!(found.contains("wires.compensation.to: found winch, allowed: slew or winch.target_offset"), "{found}");
    let found = error(&[("sensors.mru.motion_reference_unit.enabled", json!(false))]);
    assert!(found.contains("allowed: none: the scenario does not have an enabled sensor"), "{found}");
}

#[test]
fn a_wire_between_different_units_or_a_second_wire_to_an_input_is_refused() {
    let found = error(&[("wires.compensation.from", json!("mru.measured_roll"))]);
    assert!(
        found.contains("found mru.measured_roll, in rad, allowed: a signal in m, as winch.target_offset"),
        "{found}"
    );
    let found = error(&[("wires.again", json!({"from": "mru.measured_heave", "to": "winch.target_offset"}))]);
    assert!(found.contains("wires.again.to: found winch.target_offset a second time"), "{found}");
    let found = error(&[("sensors.mru.motion_reference_unit.delay_samples", json!(1001))]);
    assert!(found.contains("delay_samples: found 1001, allowed: a number from 0 to 1000"), "{found}");
}

#[test]
fn wires_of_a_part_have_its_prefix_at_both_ends() {
    let part = DECK
        .replace("simulation: {step_s: 0.01, duration_s: 2, record_every_s: 0.01}", "")
        .replace("forces:\n  gravity: {gravity: {}}\n", "");
    let texts = HashMap::from([("deck.yaml".to_owned(), part)]);
    let whole = "
version: 1
title: Two decks
bodies: {}
parts: {port: {part: deck.yaml}, starboard: {part: deck.yaml, position_m: [10, 0, 0]}}
";
    let scenario = read_with(whole, "whole.yaml", &[], &Files::new(texts)).unwrap_or_else(|error| panic!("{error}"));
    let written: Value = serde_json::from_str(&scenario.to_json()).unwrap();
    let wire = &written["wires"]["port_compensation"];
    assert_eq!((&wire["from"], &wire["to"]), (&json!("port_mru.measured_heave"), &json!("port_winch.target_offset")));
    let inputs = scenario.simulation().expect("it builds").inputs();
    let signals: Vec<&str> = inputs.iter().filter_map(|input| input.signal.as_deref()).collect();
    assert_eq!(signals, ["port_mru.measured_heave", "starboard_mru.measured_heave"]);
}

#[test]
fn wired_runs_in_lanes_have_the_rows_of_single_runs() {
    let variant = |speed: f64| {
        let speed = ("bodies.deck.joint.prismatic.mode.prescribed.speed_m_s".to_owned(), speed.into());
        vec![speed, ("simulation.duration_s".to_owned(), 1.0.into())]
    };
    let variants: Vec<_> = [0.5, 0.4, -0.2, 0.1].map(variant).to_vec();
    let batch = batch::run(DECK, "deck.yaml", &Files::default(), &variants, 1, |_| true).expect("they run");
    for (run, variant) in batch.runs.iter().zip(&variants) {
        let alone =
            read(DECK, "deck.yaml", variant).and_then(|deck| deck.simulation()).expect("it builds").run(|_| true);
        assert_eq!(run.rows, alone.rows);
    }
}

#[test]
fn a_snapshot_contains_the_delayed_values_of_a_sensor() {
    let mut simulation = simulation(&[]);
    simulation.step(37).unwrap();
    let snapshot = simulation.snapshot();
    simulation.step(63).unwrap();
    let expected = simulation.state().clone();
    simulation.reset();
    simulation.restore(&snapshot).unwrap();
    simulation.step(63).unwrap();
    assert_eq!(*simulation.state(), expected);
}
