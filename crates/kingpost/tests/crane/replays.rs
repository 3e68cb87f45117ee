//! Replay of a user's inputs in a run, as a scenario.

use crate::operations::{PUSH_COAST_BRAKE, run, slide};
use kingpost::Simulation;
use kingpost::scenario::{Scenario, read};

/// Moves the lever of the slide in 400 steps of 0.01 s, at 0, 0.13, 0.7, 0.9 and 1.9 s.
fn by_hand(scenario: &Scenario) -> Simulation {
    let mut by_hand = scenario.simulation().expect("it builds");
    for (steps, value) in [(0, 0.25), (13, 0.7), (0, 0.3), (57, -1.0), (20, 0.123_456_789), (100, 0.0)] {
        by_hand.step(steps).expect("it moves");
        by_hand.set_input("push", value).expect("it is a lever");
    }
    by_hand.step(210).expect("it moves");
    by_hand
}

/// Reads a scenario's own text again, and runs it to its end.
fn run_again(scenario: &Scenario) -> Simulation {
    run(&scenario.to_json())
}

#[test]
fn a_replay_of_user_inputs_as_an_operation_is_bitwise_identical() {
    let free = read(&slide(0.01, ""), "slide.yaml", &[]).expect("it reads");
    let mut driven = by_hand(&free);
    // Of two moves between the same steps the last counts.
    assert_eq!(driven.lever_moves().len(), 5);
    let replayed = run_again(&free.replay(&driven).expect("it has no operation"));
    assert_eq!(replayed.state().q, driven.state().q);
    assert_eq!(replayed.state().v, driven.state().v);
    driven.reset();
    assert!(driven.lever_moves().is_empty());
    assert_eq!(free.replay(&driven), Ok(free));
}

#[test]
fn a_replay_lasts_as_long_as_the_run() {
    let short =
        read(&slide(0.01, ""), "slide.yaml", &[("simulation.duration_s".into(), 1.5.into())]).expect("it reads");
    let driven = by_hand(&short);
    let replayed = run_again(&short.replay(&driven).expect("it has no operation"));
    assert_eq!((replayed.time_s(), &replayed.state().q), (4.0, &driven.state().q));
}

#[test]
fn user_inputs_replace_a_disabled_operation_and_the_values_that_parameters_wrote_into_it() {
    let parameters = "parameters:
  - {name: steered, default: false, writes: [operation.enabled]}
  - {name: force, default: 0.5, writes: [operation.steps.0.set.0.to]}
  - {name: mass_kg, default: 2, writes: [operation.steps.2.set.0.to, bodies.cage.mass_kg]}
";
    let off = read(&slide(0.01, &format!("{PUSH_COAST_BRAKE}{parameters}")), "slide.yaml", &[]).expect("it reads");
    let driven = by_hand(&off);
    let replay = off.replay(&driven).expect("its operation is off");
    let left: Vec<(&str, Vec<String>)> =
        replay.parameters.iter().map(|parameter| (parameter.name.as_str(), parameter.writes.clone())).collect();
    let writes = |path: &str| vec![path.to_owned()];
    assert_eq!(left, [("steered", writes("operation.enabled")), ("mass_kg", writes("bodies.cage.mass_kg"))]);
    assert_eq!(run_again(&replay).state().q, driven.state().q);
}

#[test]
fn a_replay_with_an_enabled_operation_is_refused() {
    let other = "  hold: {linear_motor: {joint: slide, force_N: 1, history: lever}}\n";
    let on = read(&slide(0.01, &format!("{other}{PUSH_COAST_BRAKE}")), "slide.yaml", &[]).expect("it reads");
    let mut driven = on.simulation().expect("it builds");
    assert_eq!(on.replay(&driven).as_ref(), Ok(&on));
    driven.set_input("hold", 1.0).expect("the operation does not set it");
    let error = on.replay(&driven).expect_err("two operations");
    assert_eq!(error.to_string(), "operation: found one in the scenario, allowed: operation.enabled: false");
}
