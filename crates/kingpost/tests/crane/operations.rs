//! Operations as timelines: steps that change inputs until a condition holds, and limits against which a run
//! is checked.

use crate::common;

use common::{relative_difference, simulation, values};
use kingpost::Simulation;
use kingpost::analysis::gradient;
use kingpost::batch;
use kingpost::scenario::{Files, read};
use kingpost::simulation::InputError;

/// A cage of 2 kg on a slide that a force of up to 10 N pushes by a lever, and an operation.
pub fn slide(step_s: f64, rest: &str) -> String {
    format!(
        "version: 1
title: A slide
simulation: {{step_s: {step_s}, duration_s: 4, record_every_s: {step_s}}}
bodies:
  cage:
    mass_kg: 2
    shape: {{point: {{}}}}
    joint: {{prismatic: {{name: slide, axis: [1, 0, 0]}}}}
drives:
  push: {{linear_motor: {{joint: slide, force_N: 10, history: lever}}}}
{rest}"
    )
}

/// Full force for 1 s, coasting until the cage is beyond 4 m, braking until it is at rest, and then no force.
pub const PUSH_COAST_BRAKE: &str = "operation:
  steps:
    - {name: push, set: [{input: push, to: 1}], until: {after_s: 1}}
    - {name: coast, set: [{input: push, to: 0}], until: {value: {column: slide.joint_position, above: 4}}}
    - {name: brake, set: [{input: push, to: -1}], until: {value: {column: slide.joint_velocity, below: 0}}, time_out_s: 3}
    - {name: rest, set: [{input: push, to: 0}]}
";

pub fn run(text: &str) -> Simulation {
    let mut simulation = simulation(text);
    simulation.run(|_| true).status.expect("it ends");
    simulation
}

#[test]
fn steps_start_and_end_by_their_conditions() {
    let found = run(&slide(0.01, PUSH_COAST_BRAKE));
    let events: Vec<(f64, &str)> = found.events().iter().map(|event| (event.time_s, event.what.as_ref())).collect();
    // x = a t^2 / 2 with a = 5 m/s^2 is 2.5 m after 1 s, at 5 m/s: 4 m at 1.3 s, or a step later; it stands 1 s after that.
    let exact = [(0.0, "begins \"push\""), (1.0, "begins \"coast\""), (1.31, "begins \"brake\"")];
    for ((time_s, what), exact) in events.iter().zip(exact) {
        assert!((time_s - exact.0).abs() < 1e-9 && *what == exact.1, "{time_s} {what}");
    }
    let [.., (stands_s, "begins \"rest\""), (ends_s, "ends")] = events[..] else { panic!("{events:?}") };
    assert!((2.31..2.33).contains(&stands_s) && ends_s == stands_s, "{stands_s} {ends_s}");
    assert!(found.events().iter().all(|event| event.element == "operation"));
}

#[test]
fn the_current_step_is_a_column_of_the_results() {
    let mut found = simulation(&slide(0.01, PUSH_COAST_BRAKE));
    for (time_s, step) in [(0.5, 1.0), (1.2, 2.0), (2.0, 3.0), (3.0, 5.0)] {
        while found.time_s() < time_s - 1e-9 {
            found.step(1).expect("it moves");
        }
        assert_eq!(values(&mut found, "operation_step"), [step], "{time_s}");
    }
}

#[test]
fn an_input_that_moves_over_a_time_is_followed_in_second_order_of_the_step() {
    // F = 10 t / 2 over 2 s on 2 kg: x = 10 t^3 / 24, and from there with F = 10 on for 2 s more.
    let rest = "operation: {steps: [{name: more, set: [{input: push, to: 1, in_s: 2}]}, {name: hold}]}\n";
    let exact = [10.0 * 8.0 / 24.0 + 5.0 * 2.0 + 0.5 * 5.0 * 4.0, 5.0 + 5.0 * 2.0];
    let error = |step_s: f64| {
        let found = run(&slide(step_s, rest));
        [found.state().q[0] - exact[0], found.state().v[0] - exact[1]].map(f64::abs)
    };
    let [coarse, fine] = [error(0.04), error(0.02)];
    // The impulse of the middle's values is exact; the place is off by a h^2 / 24 for each unit of time of the ramp.
    assert!(coarse[1] < 1e-12 && fine[1] < 1e-12, "{coarse:?} {fine:?}");
    assert!((coarse[0] / fine[0] - 4.0).abs() < 0.01 && coarse[0] < 1e-3, "{coarse:?} {fine:?}");
}

#[test]
fn moves_of_one_step_start_at_their_times_from_the_end_of_the_previous_move() {
    let rest = "operation:
  steps:
    - name: all
      set:
        - {input: push, to: 0.5, at_s: 1}
        - {input: push, to: -0.5, at_s: 2, in_s: 1}
        - {input: push, to: 0.25, at_s: 3.5}
";
    let mut found = simulation(&slide(0.01, rest));
    let mut at = |time_s: f64| {
        while found.time_s() < time_s - 1e-9 {
            found.step(1).expect("it moves");
        }
        found.inputs()[0].value
    };
    // Between two steps an input has the value of the step before.
    for (time_s, value) in [(0.99, 0.0), (1.01, 0.5), (2.0, 0.5), (2.5, 0.005), (3.2, -0.5), (3.6, 0.25)] {
        assert!((at(time_s) - value).abs() < 1e-9, "{time_s}");
    }
}

#[test]
fn conditions_are_combined_by_all_and_any() {
    let ends = |until: &str| {
        let steps = format!("[{{name: push, set: [{{input: push, to: 1}}], until: {until}}}]");
        let found = run(&slide(0.01, &format!("operation: {{steps: {steps}}}\n")));
        found.events().last().map(|event| event.time_s).expect("it ends")
    };
    let (far, fast) = (
        "{value: {column: slide.joint_position, above: 2.499}}",
        "{value: {column: slide.joint_velocity, above: 2.49}}",
    );
    assert!((ends(far) - 1.0).abs() < 1e-9);
    assert!((ends(fast) - 0.5).abs() < 1e-9);
    assert!((ends(&format!("{{all: [{far}, {fast}]}}")) - 1.0).abs() < 1e-9);
    assert!((ends(&format!("{{any: [{far}, {fast}]}}")) - 0.5).abs() < 1e-9);
    assert!((ends(&format!("{{all: [{{after_s: 2}}, {{any: [{far}, {fast}]}}]}}")) - 2.0).abs() < 1e-9);
}

/// Time at which a step ends in which the lever is thrown every half second.
fn ends_while_pushed_to_and_fro(until: &str) -> Result<f64, String> {
    let moves = (0..7).map(|k| format!("{{input: push, to: {}, at_s: {}}}", 1 - 2 * (k % 2), 0.5 * f64::from(k)));
    let steps =
        format!("[{{name: shake, set: [{}], time_out_s: 3.5, until: {until}}}]", moves.collect::<Vec<_>>().join(", "));
    let mut found = simulation(&slide(0.01, &format!("operation: {{steps: {steps}}}\n")));
    found.run(|_| true).status.map_err(|error| error.to_string())?;
    Ok(found.events().last().map(|event| event.time_s).expect("it ends"))
}

#[test]
fn a_condition_ends_a_step_when_it_has_held_for_a_time_or_begun_a_number_of_times() {
    // The speed is a triangle between 0 and 2.5 m/s with a period of 1 s: above 2 m/s from 0.4 to 0.6 s, and so on.
    let fast = "{value: {column: slide.joint_velocity, above: 2.001}}";
    let ends = |until: &str| ends_while_pushed_to_and_fro(until).expect("it ends");
    let near = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-9, "{found} {expected}");
    // Checked at each step of 10 ms; first above at 0.41 s.
    near(ends(fast), 0.41);
    near(ends(&format!("{{holds: {{for_s: 0.15, condition: {fast}}}}}")), 0.56);
    near(ends(&format!("{{count: {{times: 3, condition: {fast}}}}}")), 2.41);
    near(ends(&format!("{{count: {{times: 2, condition: {{holds: {{for_s: 0.15, condition: {fast}}}}}}}}}")), 1.56);
    near(
        ends(&format!(
            "{{any: [{{count: {{times: 9, condition: {fast}}}}}, {{holds: {{for_s: 0.1, condition: {fast}}}}}]}}"
        )),
        0.51,
    );
    let never =
        ends_while_pushed_to_and_fro(&format!("{{holds: {{for_s: 0.3, condition: {fast}}}}}")).expect_err("0.2 s");
    assert!(never.contains("found a condition that has held for 0.09 s, allowed: at least 0.3 s"), "{never}");
    let rare =
        ends_while_pushed_to_and_fro(&format!("{{count: {{times: 5, condition: {fast}}}}}")).expect_err("4 times");
    assert!(rare.contains("found a condition that began to hold 4 times, allowed: at least 5"), "{rare}");
}

#[test]
fn a_condition_compares_two_columns() {
    // The cage is beyond y = 0 after the first step.
    let ends = |value: &str| ends_while_pushed_to_and_fro(&format!("{{value: {value}}}"));
    let beyond = ends("{column: slide.joint_position, above_column: cage.position.y}").expect("it ends");
    assert!((beyond - 0.01).abs() < 1e-9, "{beyond}");
    let error = ends("{column: slide.joint_position, below_column: cage.position.y}").expect_err("it never does");
    assert!(error.contains("allowed: below cage.position.y, 0 m"), "{error}");
}

#[test]
fn a_snapshot_between_two_touches_keeps_their_count() {
    let until = "{count: {times: 3, condition: {value: {column: slide.joint_velocity, above: 2.001}}}}";
    let moves = (0..7).map(|k| format!("{{input: push, to: {}, at_s: {}}}", 1 - 2 * (k % 2), 0.5 * f64::from(k)));
    let moves = moves.collect::<Vec<_>>().join(", ");
    let text = slide(0.01, &format!("operation: {{steps: [{{name: shake, set: [{moves}], until: {until}}}]}}\n"));
    let (mut whole, mut parted) = (simulation(&text), simulation(&text));
    parted.step(150).expect("it moves");
    let kept = parted.snapshot();
    parted.step(150).expect("it moves");
    parted.restore(&kept).expect("its own");
    parted.step(150).expect("it moves");
    whole.step(300).expect("it moves");
    assert_eq!(whole.state(), parted.state());
}

#[test]
fn a_condition_that_is_never_met_ends_the_run_and_is_named() {
    let steps = "[{name: push on, set: [{input: push, to: 1}], time_out_s: 0.5, until: {any: [{value: {column: \
                 slide.joint_position, above: 900, below: 1000}}, {value: {column: slide.joint_velocity, below: -1}}]}}]";
    let mut found = simulation(&slide(0.01, &format!("operation: {{steps: {steps}}}\n")));
    let run = found.run(|_| true);
    assert_eq!(
        run.status.expect_err("it waits").to_string(),
        "operation at 0.5 s: step \"push on\" did not end within 0.5 s: found slide.joint_position 0.625 m, allowed: above \
         900 m and below 1000 m, or found slide.joint_velocity 2.5 m/s, allowed: below -1 m/s"
    );
    // What was computed stays.
    assert_eq!(run.rows.len() / run.columns, 51);
}

#[test]
fn a_run_after_a_reset_or_a_snapshot_is_bitwise_identical() {
    let mut found = run(&slide(0.01, PUSH_COAST_BRAKE));
    let (end, events) = (found.state().q.clone(), found.events().to_vec());
    found.reset();
    found.step(150).expect("it moves");
    let (snapshot, meanwhile) = (found.snapshot(), found.events().to_vec());
    found.step(250).expect("it moves");
    assert_eq!((&found.state().q, found.events()), (&end, &events[..]));
    let mut other = simulation(&slide(0.01, PUSH_COAST_BRAKE));
    other.restore(&snapshot).expect("of the same scenario");
    other.step(250).expect("it moves");
    assert_eq!((&other.state().q, other.events()), (&end, &events[meanwhile.len()..]));
}

#[test]
fn a_user_cannot_set_an_input_of_an_operation() {
    let mut found = simulation(&slide(0.01, PUSH_COAST_BRAKE));
    let (name, signal) = ("push".to_owned(), "operation".to_owned());
    assert_eq!(found.set_input("push", 0.5), Err(InputError::Wired { name, signal }));
    assert_eq!(found.inputs()[0].signal.as_deref(), Some("operation"));
    let mut off = simulation(&slide(0.01, &PUSH_COAST_BRAKE.replacen(":\n", ":\n  enabled: false\n", 1)));
    off.set_input("push", 0.5).expect("the operation is off");
}

#[test]
fn a_batch_is_bitwise_identical_to_each_run_alone_although_steps_end_at_different_times() {
    let text = slide(0.01, PUSH_COAST_BRAKE);
    let variant = |mass: f64| vec![("bodies.cage.mass_kg".to_owned(), mass.into())];
    let masses = [1.0, 1.5, 2.0, 2.5, 3.0];
    let files = Files::default();
    let batch = batch::run(&text, "slide.yaml", &files, &masses.map(variant), 2, |_| true).expect("they read");
    for (mass, run) in masses.iter().zip(&batch.runs) {
        let mut alone = simulation(&text.replacen("mass_kg: 2", &format!("mass_kg: {mass}"), 1));
        assert_eq!(alone.run(|_| true).rows, run.rows, "{mass}");
        assert_eq!(alone.events(), run.events);
    }
}

#[test]
fn a_result_has_a_derivative_with_respect_to_the_target_of_an_input() {
    // x = F / (2 m) (t - 1)^2 from 1 s on, to 4 s: dx/dlever = 10 / 4 * 9.
    let rest = "operation: {steps: [{name: push, set: [{input: push, to: 0.6, at_s: 1}]}]}\n";
    let scenario = read(&slide(0.01, rest), "slide.yaml", &[]).expect("it reads");
    let found = gradient(&scenario, &["operation.steps.0.set.0.to"], |_| true).expect("a number");
    let place = kingpost::Simulation::new(scenario.setup().expect("it builds"));
    let place = place.channels().iter().find(|channel| channel.variable == "joint_position").expect("a slide").offset;
    let last = found.derivatives[0].len() - found.columns;
    assert!(relative_difference(&[found.derivatives[0][last + place]], &[22.5]) < 1e-12);
}

#[test]
fn limits_report_whether_they_held_and_the_worst_value_with_its_time() {
    let rest = format!(
        "{PUSH_COAST_BRAKE}limits:
  speed: {{column: slide.joint_velocity, within: 4.9}}
  place: {{column: slide.joint_position, at_least: -1, at_most: 7}}
  late: {{column: slide.joint_velocity, at_most: 0.1, from_s: 3}}
  never: {{column: slide.joint_velocity, at_most: 0.1, from_s: 30}}
  coasting: {{column: slide.joint_velocity, at_most: 4.99, steps: [coast]}}
  braking: {{column: slide.joint_position, at_most: 3, steps: [brake, rest]}}
  early: {{column: slide.joint_velocity, at_most: 4.6, until_s: 0.9}}
  off: {{enabled: false, column: slide.joint_velocity, at_most: 0.1}}
"
    );
    let found = run(&slide(0.01, &rest)).limits();
    let [speed, place, late, never, coasting, braking, early] = &found[..] else { panic!("{found:?}") };
    assert_eq!((speed.held, speed.at_least, speed.at_most), (Some(false), Some(-4.9), Some(4.9)));
    assert!((speed.worst.unwrap() - 5.0).abs() < 1e-9 && (speed.worst_time_s.unwrap() - 1.0).abs() < 1e-9);
    assert_eq!(place.held, Some(true));
    assert!((place.worst.unwrap() - 6.55).abs() < 0.03, "{place:?}");
    assert_eq!((late.held, never.held, never.worst), (Some(true), None, None));
    assert!(coasting.held == Some(false) && (1.0..1.31).contains(&coasting.worst_time_s.unwrap()), "{coasting:?}");
    assert!(braking.held == Some(false) && (braking.worst.unwrap() - 6.55).abs() < 0.03, "{braking:?}");
    assert_eq!(early.held, Some(true));
}

#[test]
fn a_mistake_in_an_operation_is_refused_at_its_place() {
    let cases = [
        (
            "{name: a, set: [{input: pusch, to: 1}]}",
            "operation.steps.0.set.0.input: found pusch, allowed: push; did you mean push?",
        ),
        ("{name: a, set: [{input: push, to: 2}]}", "operation.steps.0.set.0.to: found 2, allowed: -1 to 1"),
        ("{name: a, set: [{input: push, to: 1, unit: kN}]}", "operation.steps.0.set.0.unit: found kN, allowed: 1"),
        (
            "{name: a, set: [{input: push, to: 1, in_s: 2}, {input: push, to: 0, at_s: 1}]}",
            "operation.steps.0.set.1.at_s: found 1, allowed: at least 2, the end of the previous move of the same input",
        ),
        ("{name: a, until: {all: []}}", "operation.steps.0.until.all: found none, allowed: at least one condition"),
        (
            "{name: a, until: {value: {column: slide.joint_position}}}",
            "operation.steps.0.until.value: found no bound, allowed: above or below, above_column or below_column, or one of each",
        ),
        (
            "{name: a, until: {value: {column: slide.joint_position, above_column: slide.joint_velocity}}}",
            "operation.steps.0.until.value.above_column: found slide.joint_velocity, in m/s, allowed: a column in m",
        ),
        (
            "{name: a, until: {value: {column: slide.joint_position, above: 1, above_column: cage.position.y}}}",
            "operation.steps.0.until.value.above_column: found with above, allowed: one of the two",
        ),
        (
            "{name: a, until: {count: {times: 0, condition: {after_s: 1}}}}",
            "operation.steps.0.until.count.times: found 0, allowed: 1 or more",
        ),
        (
            "{name: a, time_out_s: 4, until: {any: [{holds: {for_s: 5, condition: {after_s: 1}}}, {after_s: 6}]}}",
            "operation.steps.0.time_out_s: found 4, allowed: at least 6 s, the least duration of its condition",
        ),
        (
            "{name: a, until: {value: {column: slide.joint_position, above: 2, below: 1}}}",
            "operation.steps.0.until.value.above: found 2, allowed: less than below, 1",
        ),
        (
            "{name: a, until: {value: {column: slide.joint_velocity, above: 2, unit: kN}}}",
            "operation.steps.0.until.value.unit: found kN, allowed: m/s",
        ),
        (
            "{name: a, until: {any: [{after_s: 1}, {value: {column: slide.joint_postion, above: 2}}]}}",
            "operation.steps.0.until.any.1.value.column: found slide.joint_postion, allowed: ",
        ),
        (
            "{name: a, until: {value: {column: \"\", above: 2}}}",
            "operation.steps.0.until.value.column: found \"\", allowed: a column of the results",
        ),
        (
            "{name: \" \", until: {after_s: 1}}",
            "operation.steps.0.name: found \" \", allowed: a text that describes the step",
        ),
    ];
    for (step, expected) in cases {
        refused(&slide(0.01, &format!("operation: {{steps: [{step}]}}\n")), expected);
    }
    refused(&slide(0.01, "operation: {steps: []}\n"), "operation.steps: found none, allowed: at least one step");
    refused(
        &slide(0.01, "operation: {steps: [{name: hold}, {name: push, set: [{input: push, to: 1}]}]}\n"),
        "operation.steps.0: found neither set nor until, allowed: set, or until",
    );
    refused(
        &slide(0.01, "operation: {steps: [{name: hold, time_out_s: 30}]}\n"),
        "operation.steps.0.time_out_s: found a time-out without until, allowed: until",
    );
}

#[test]
fn a_limit_in_a_last_step_that_waits_for_nothing_applies_to_the_end() {
    let rest = "operation: {steps: [{name: push, set: [{input: push, to: 1}], until: {after_s: 1}}, {name: coast}]}
limits: {late: {column: slide.joint_position, at_most: 100, steps: [coast]}}\n";
    let found = run(&slide(0.01, rest)).limits();
    assert!(found[0].worst_time_s.is_some_and(|time_s| (time_s - 4.0).abs() < 1e-9), "{found:?}");
}

#[test]
fn a_mistake_in_a_limit_is_refused_at_its_place() {
    let cases = [
        ("{column: slide.joint_velocity}", "limits.a: found no bound, allowed: at_most, at_least, both, or within"),
        (
            "{column: slide.joint_velocity, at_most: 1, within: 1}",
            "limits.a: found within together with at_most or at_least",
        ),
        (
            "{column: slide.joint_velocity, at_most: 1, at_least: 2}",
            "limits.a.at_least: found 2, allowed: not more than at_most, 1",
        ),
        (
            "{column: slide.joint_velocity, at_most: 1, from_s: 3, until_s: 2}",
            "limits.a.until_s: found 2, allowed: more than from_s, 3 s",
        ),
        (
            "{column: slide.joint_velocity, at_most: 1, steps: [coast]}",
            "limits.a.steps.0: found coast, allowed: a scenario with an operation, which has steps",
        ),
        ("{column: cage.jont_velocity, at_most: 1}", "limits.a.column: found cage.jont_velocity, allowed: "),
        ("{column: slide.joint_velocity, at_most: 1, unit: deg}", "limits.a.unit: found deg, allowed: m/s"),
        ("{column: slide.joint_velocity, at_most: 1, unit: \"\"}", "limits.a.unit: found \"\", allowed: m/s"),
    ];
    for (limit, expected) in cases {
        refused(&slide(0.01, &format!("limits: {{a: {limit}}}\n")), expected);
    }
}

#[test]
fn a_misspelt_column_gets_a_suggestion_among_many() {
    let text = slide(0.01, "limits: {a: {column: cage.velocty.x, at_most: 1}}\n");
    refused(&text, "; did you mean cage.velocity.x?");
}

pub fn refused(text: &str, expected: &str) {
    let error = read(text, "slide.yaml", &[]).and_then(|scenario| scenario.setup()).expect_err("a mistake").to_string();
    assert!(error.contains(expected), "{error}\n{expected}");
}

#[test]
fn every_dimension_of_the_results_has_one_list_of_labels() {
    // A drive that turns beside one that slides: the one has a torque, the other a force, both have a power.
    let rest = "  turn: {controlled_drive: {joint: turn, set_point: {speed: {rate_rad_s: 1}}, speed_limit_rad_s: 2, \
                acceleration_limit_rad_s2: 1, torque_limit_N_m: 9, stiffness_N_m_per_rad: 9, damping_N_m_s_per_rad: 9}}
";
    let more = "  wheel: {mass_kg: 1, shape: {sphere: {radius_m: 1}}, joint: {revolute: {name: turn, axis: [1, 0, 0]}}}
drives:
  pull: {linear_controlled_drive: {joint: slide, set_point: {speed: {speed_m_s: 1}}, speed_limit_m_s: 2, \
                acceleration_limit_m_s2: 1, force_limit_N: 9, stiffness_N_per_m: 9, damping_N_s_per_m: 9}}
";
    let mixed = simulation(&slide(0.01, rest).replacen("drives:\n", more, 1));
    let mut found: Vec<(String, Vec<String>)> = Vec::new();
    for channel in mixed.channels() {
        for (dimension, labels) in channel.dims.iter().zip(&channel.labels) {
            match found.iter().find(|(known, _)| known == dimension) {
                Some((_, known)) => assert_eq!(known, labels, "{}", channel.variable),
                None => found.push((dimension.clone(), labels.clone())),
            }
        }
    }
    let labels = |name: &str| found.iter().find(|(known, _)| known == name).expect("a dimension").1.join(" ");
    assert_eq!([labels("drive"), labels("drive_with_drive_torque")], ["pull turn", "turn"]);
}
