//! Learned policies against their control law, selectors against their inputs, and the linear check of both.

use crate::common;

use common::simulation;
use kingpost::Simulation;
use kingpost::scenario::read;
use serde_json::{Value, json};

/// A mass of 2 kg on a spring of 20 N/m, pushed by a lever of 10 N, with these controllers.
fn cage(controllers: &str) -> String {
    format!(
        "version: 1
title: A cage on a spring
simulation: {{step_s: 0.01, duration_s: 5, record_every_s: 0.1}}
bodies:
  cage:
    mass_kg: 2
    shape: {{point: {{}}}}
    joint: {{prismatic: {{name: slide, axis: [1, 0, 0], initial_extension_m: 0.3, spring: {{stiffness_N_per_m: 20, rest_m: 0}}}}}}
drives:
  push: {{linear_motor: {{joint: slide, force_N: 10, history: lever}}}}
controllers:
{controllers}"
    )
}

/// Two tanh units between two readings and the lever.
const LEARNED: &str = "  learned:
    policy:
      reads:
        - {column: slide.joint_position, also: [{column: slide.joint_position}], reference: 0.1, scale: 0.02}
        - {column: slide.joint_velocity, scale: 2}
      steers: [{to: push, lower: -0.3, upper: 0.5}]
      layers:
        - {weights: [[0.4, -0.7], [-0.2, 0.9]], biases: [0.1, -0.3]}
        - {weights: [[-1.1, 0.6]], biases: [0.2]}
      period_s: 0.02
";

fn value(simulation: &mut Simulation, column: &str) -> f64 {
    let mut readings = simulation.readings(&[column.to_owned()]);
    let mut found = Vec::new();
    simulation.read(&mut readings, &mut found);
    found[0]
}

/// The law by libm's tanh, which errs by a unit of rounding.
fn law(position: f64, velocity: f64) -> f64 {
    let seen = [((2.0 * position - 0.1) / 0.02).clamp(-10.0, 10.0), velocity / 2.0];
    let hidden = [libm::tanh(0.4 * seen[0] - 0.7 * seen[1] + 0.1), libm::tanh(-0.2 * seen[0] + 0.9 * seen[1] - 0.3)];
    -0.3 + (libm::tanh(-1.1 * hidden[0] + 0.6 * hidden[1] + 0.2) + 1.0) * 0.4
}

#[test]
fn a_policy_evaluates_its_law_at_its_samples_and_adds_its_command() {
    let mut found = simulation(&cage(LEARNED));
    let (mut added, mut clipped) = (0.0, 0);
    for step in 0..300 {
        if step == 150 {
            found.set_input("learned", 0.25).expect("its command");
        }
        let [position, velocity] = ["position", "velocity"].map(|of| value(&mut found, &format!("slide.joint_{of}")));
        if step % 2 == 0 {
            added = law(position, velocity);
            clipped += usize::from((2.0 * position - 0.1).abs() > 0.2);
        }
        found.step(1).expect("it runs");
        let command = if step < 150 { 0.0 } else { 0.25 };
        let action = value(&mut found, "learned.commanded_lever");
        assert!((action - (command + added).clamp(-1.0, 1.0)).abs() < 1e-15, "step {step}: {action}");
    }
    assert!((10..140).contains(&clipped), "{clipped} samples are clipped");
}

#[test]
fn a_disabled_policy_passes_its_command() {
    let mut found = simulation(&cage(&LEARNED.replace("reads:", "enabled: false\n      reads:")));
    found.set_input("learned", 0.25).expect("its command");
    found.step(3).expect("it runs");
    assert_eq!(value(&mut found, "learned.commanded_lever"), 0.25);
}

/// Two feedbacks before a selector.
fn choice(selected: &str) -> String {
    let feedback = |name: &str, gain: f64| {
        format!(
            "  {name}:
    state_feedback:
      reads: [{{column: slide.joint_velocity}}]
      steers: [{{to: choice.{name}.push, gains: [{gain}]}}]
      period_s: 0.02
"
        )
    };
    let selector =
        format!("  choice: {{selector: {{selected: {selected}, branches: [good, bad], steers: [{{to: push}}]}}}}\n");
    selector + &feedback("good", 0.5) + &feedback("bad", -0.4)
}

#[test]
fn a_selector_passes_one_branch_and_no_other() {
    for (selected, gain) in [("good", 0.5), ("bad", -0.4)] {
        let mut found = simulation(&cage(&choice(selected)));
        for _ in 0..50 {
            let velocity = value(&mut found, "slide.joint_velocity");
            found.step(1).expect("it runs");
            let lever = found.inputs().into_iter().find(|input| input.name == "push").expect("an input").value;
            assert_eq!(lever.to_bits(), (0.0 - gain * velocity).clamp(-1.0, 1.0).to_bits());
            found.step(1).expect("it runs");
        }
    }
}

/// Only the feedback of the selected branch grows, as without a selector between it and the drive.
#[test]
fn the_linear_check_includes_feedback_through_a_selector() {
    let growing = |controllers: &str| simulation(&cage(controllers)).growing_with_feedback();
    assert_eq!(growing(&choice("good")), None);
    let behind = growing(&choice("bad")).expect("it grows");
    let direct = "  bad:
    state_feedback:
      reads: [{column: slide.joint_velocity}]
      steers: [{to: push, gains: [-0.4]}]
      period_s: 0.02
";
    let before = growing(direct).expect("it grows");
    assert_eq!(behind.because_of, ["bad"]);
    assert!((behind.growth_time_s / before.growth_time_s - 1.0).abs() < 1e-9);
}

/// The law of a policy for small motions is its Jacobian at zero: W_2 diag(1 - tanh^2) W_1 / scale times half of the range.
#[test]
fn the_linear_check_of_a_policy_is_that_of_its_jacobian() {
    let policy = "  learned:
    policy:
      reads: [{column: slide.joint_position, scale: 0.5}, {column: slide.joint_velocity, scale: 0.2}]
      steers: [{to: push, lower: -0.5, upper: 0.5}]
      layers: [{weights: [[0.3, -0.2], [0.1, 0.4]], biases: [0.2, 0.0]}, {weights: [[0.5, 0.7]], biases: [-0.1]}]
      period_s: 0.02
";
    let hidden = [libm::tanh(0.2), 0.0];
    let slopes = hidden.map(|unit| 1.0 - unit * unit);
    let last = libm::tanh(0.5 * hidden[0] - 0.1);
    let by = |column: [f64; 2]| (1.0 - last * last) * (0.5 * slopes[0] * column[0] + 0.7 * slopes[1] * column[1]);
    let gains = [-0.5 * by([0.3, 0.1]) / 0.5, -0.5 * by([-0.2, 0.4]) / 0.2];
    let same = format!(
        "  learned:
    state_feedback:
      reads: [{{column: slide.joint_position}}, {{column: slide.joint_velocity}}]
      steers: [{{to: push, gains: [{}, {}]}}]
      period_s: 0.02
",
        gains[0], gains[1]
    );
    let [found, expected] =
        [policy, &same].map(|text| simulation(&cage(text)).growing_with_feedback().expect("it grows"));
    assert!((found.growth_time_s / expected.growth_time_s - 1.0).abs() < 1e-9, "{found:?}, {expected:?}");
}

#[test]
fn mistakes_are_reported_with_their_place_and_what_is_allowed() {
    let error_of = |text: &str, path: &str, value: Value| {
        let built = read(text, "cage.yaml", &[(path.to_owned(), value)]).and_then(|scenario| scenario.setup());
        built.err().map_or_else(|| panic!("{path} is allowed"), |error| error.to_string())
    };
    let learned = "controllers.learned.policy";
    for (path, value, expected) in [
        ("reads", json!([]), "reads: found none, allowed: at least one"),
        ("layers", json!([]), "layers: found none, allowed: at least one"),
        ("reads.0.scale", json!(0.0), "reads.0.scale: found 0"),
        ("reads.0.also.0.column", json!("slide.joint_velocity"), "also.0.column: found slide.joint_velocity, in m/s"),
        ("reads.0.column", json!("slide.joint_positon"), "allowed: one of slide.joint_position"),
        ("layers.0.weights.1", json!([1.0]), "layers.0.weights.1: found 1 numbers, allowed: 2, one for each input"),
        ("layers.0.weights", json!([[1.0, 1.0]]), "layers.0.weights: found 1 entries, allowed: 2"),
        ("layers.1.biases", json!([1.0, 2.0]), "layers.1.biases: found 2 entries, allowed: 1"),
        ("steers.0.upper", json!(1.5), "steers.0.upper: found 1.5, allowed: -1 to 1 1"),
        ("steers.0.upper", json!(-0.5), "steers.0.lower: found a range of"),
        ("period_s", json!(0.015), "period_s: found 0.015, allowed: a whole number of steps"),
    ] {
        let found = error_of(&cage(LEARNED), &format!("{learned}.{path}"), value);
        assert!(found.contains(expected), "{found}\n{expected}");
    }
    let chosen = "controllers.choice.selector";
    for (path, value, expected) in [
        ("selected", json!("goood"), "selected: found goood, allowed: good or bad"),
        ("branches", json!(["bad", "bad"]), "branches.1: found bad a second time"),
        ("steers.0.to", json!("pull"), "steers.0.to: found pull"),
    ] {
        let found = error_of(&cage(&choice("bad")), &format!("{chosen}.{path}"), value);
        assert!(found.contains(expected), "{found}\n{expected}");
    }
}
