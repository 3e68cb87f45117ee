//! Properties of every scenario: it reads back to itself, and no text makes the reader panic.

use crate::common::paper_text;

use kingpost::scenario::{Scenario, parse_assignment, read};
use paper_text::{PAPER, set, try_set};
use proptest::prelude::*;
use serde_json::{Value, json};

/// A scenario with every kind of body, joint, force and drive once.
const EVERYTHING: &str = r#"
version: 1
title: Everything
simulation: {integrator: midpoint_euler, step_s: 0.003, duration_s: 0.7, record_every_s: 0.1, rate_limit: 500, seed: 18446744073709551615}
bodies:
  hull:
    mass_t: 12.34567890123
    inertia: {tensor: {moments_kg_m2: [100000.1, 200000.2, 250000.3], products_kg_m2: [1, -2, 3]}}
    centre_of_mass_m: [0.1, 0.2, 0.3]
    joint: {floating: {name: sea, hold_rotation: false, initial: {position_m: [1, 2, 3], orientation_deg: [1, 2, 3], velocity_m_s: [0.1, 0, 0], angular_velocity_deg_s: [0, 1, 0]}}}
  post:
    parent: hull
    mass_kg: 10
    shape: {sphere: {radius_m: 0.5}}
    joint: {revolute: {axis: [0, 3, 4], orientation_deg: [0, 0, 30], initial_angle_deg: 7, damping_kN_m_s: 0.1, mode: {prescribed: {rate_deg_s: 3, history: pulse, pulse: {rise_s: 0.1, hold_s: 0.1, reverse_s: 0.1}}}}}
  ram:
    parent: post
    mass_kg: 5
    inertia: {radii_of_gyration: {radii_m: [0.3, 0.3, 0.3]}}
    joint: {prismatic: {axis: [1, 0, 0], initial_extension_m: 1, damping_N_s_m: 5}}
    points: {nose: {position_m: [0, 0, 1]}, heel: {position_m: [0, 0, -1]}}
  boom:
    parent: post
    mass_kg: 7
    shape: {cylinder: {radius_m: 0.1, length_m: 2}}
    joint: {revolute: {axis: [1, 0, 0], mode: {travel: {angle_deg: 5, start_s: 1, duration_s: 4, ramp_s: 1}}, initial_angle_rad: 0.1}}
  hook: {parent: boom, mass_kg: 1, shape: {point: {}}, joint: {fixed: {orientation_rad: [0.1, 0.2, 0.3]}}}
  crate:
    parent: hull
    mass_kg: 3
    shape: {box: {length_m: 1, width_m: 2, height_m: 3}}
    joint: {revolute: {name: turn, axis: [0, 0, 1], friction: {torque_kN_m: 0.1}, spring: {stiffness_kN_m_per_rad: 1, rest_deg: 5}, limits: {lower_deg: -90, upper_deg: 90, stiffness_kN_m_per_rad: 9}, rotor_inertia_kg_m2: 0.01, gear_ratio: 50}}
  rod:
    parent: boom
    mass_kg: 2
    shape: {cylinder: {radius_m: 0.1, length_m: 2}}
    joint:
      cylindrical:
        axis: [1, 0, 0]
        rotation: {initial_angle_deg: 5, damping_N_m_s: 1, mode: held}
        translation: {friction: {force_kN: 0.1, smoothing_m_s: 0.02}, spring: {stiffness_kN_per_m: 1, rest_m: 0.1}, limits: {upper_m: 2, stiffness_kN_per_m: 9, dissipation_s_per_m: 0.3}, rotor_inertia_kg_m2: 0.01, gear_ratio_rad_per_m: 20}
  block:
    parent: boom
    mass_kg: 2
    shape: {sphere: {radius_m: 0.2}}
    joint: {universal: {first_axis: [1, 0, 0], second_axis: [0, 2, 0], child_position_m: [0, 0, 1], first: {initial_rate_deg_s: 3}, second: {mode: {prescribed: {rate_rad_s: 0.2}}}}}
  sledge: {mass_kg: 9, shape: {box: {length_m: 1, width_m: 2, height_m: 1}}, joint: {planar: {normal: [0, 0, 1], x_axis: [1, 0, 0], x: {initial_speed_m_s: 1}, y: {mode: held}}}}
  load:
    parent: block
    mass_kg: 8
    shape: {sphere: {radius_m: 0.3}}
    joint: {spherical: {child_position_m: [0, 0, 2], initial_orientation_deg: [5, 0, 0], initial_angular_velocity_deg_s: [0, 5, 0], damping_N_m_s: 3}}
forces:
  weight: {gravity: {}}
  water: {viscous_damping: {body: hull, linear_kN_s_m: [1, 2, 3]}}
drives:
  push: {linear_motor: {joint: ram, force_kN: 0.001, history: lever}}
  hold: {linear_servo: {enabled: false, joint: ram, target_m: 1, stiffness_kN_per_m: 1, damping_kN_s_per_m: 1, force_limit_kN: 1}}
  swing: {servo: {joint: turn, target_deg: 20, stiffness_kN_m_per_rad: 1, damping_kN_m_s_per_rad: 0.1, torque_limit_kN_m: 1}}
  grip: {brake: {joint: block.first, torque_kN_m: 0.05, state: lever}}
  clamp: {linear_brake: {joint: rod.translation, force_kN: 0.2, smoothing_m_s: 0.001}}
  spin: {motor: {enabled: false, joint: turn, torque_kN_m: 1}}
"#;

#[track_caller]
fn reads_back(scenario: &Scenario) {
    let text = scenario.to_json();
    let again = read(&text, "resolved.json", &[]).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(again, *scenario);
    assert_eq!(again.to_json(), text);
    let names = |scenario: &Scenario| scenario.bodies.keys().map(ToString::to_string).collect::<Vec<_>>();
    assert_eq!(names(&again), names(scenario));
}

#[test]
fn a_resolved_scenario_reads_back_to_itself() {
    reads_back(&set(&[]));
    reads_back(&set(&["motor_2=on", "load=on", "torque_history=pulse", "crane_x_m=0.1"]));
    reads_back(&set(&["drives.motor_2.motor.history=lever", "bodies.tower.joint.revolute.position_m.0=40"]));
    reads_back(&set(&["description=", "bodies.ship.mass_t=0.3"]));
    reads_back(&try_set(EVERYTHING, &[]).unwrap());
}

#[test]
fn bodies_and_drives_keep_the_order_of_the_file() {
    let scenario = try_set(EVERYTHING, &[]).unwrap();
    let bodies: Vec<&str> = scenario.bodies.keys().map(|name| name.as_str()).collect();
    assert_eq!(bodies, ["hull", "post", "ram", "boom", "hook", "crate", "rod", "block", "sledge", "load"]);
    let points: Vec<&str> = scenario.bodies["ram"].points.keys().map(|name| name.as_str()).collect();
    assert_eq!(points, ["nose", "heel"]);
}

#[test]
fn json_reads_as_yaml_does() {
    let scenario = set(&[]);
    assert_eq!(read(&scenario.to_json(), "paper.json", &[]).unwrap(), scenario);
}

/// Every path of a number in a value.
fn numbers(value: &Value, path: &str, into: &mut Vec<String>) {
    let join = |segment: &str| if path.is_empty() { segment.to_owned() } else { format!("{path}.{segment}") };
    match value {
        Value::Number(_) => into.push(path.to_owned()),
        Value::Array(entries) => {
            entries.iter().enumerate().for_each(|(index, entry)| numbers(entry, &join(&index.to_string()), into));
        }
        Value::Object(fields) => fields.iter().for_each(|(name, field)| numbers(field, &join(name), into)),
        _ => {}
    }
}

fn number_fields() -> Vec<String> {
    let whole: Value = serde_json::from_str(&try_set(EVERYTHING, &[]).unwrap().to_json()).unwrap();
    let mut paths = Vec::new();
    numbers(&whole, "", &mut paths);
    assert!(paths.len() > 80, "{}", paths.len());
    paths
}

/// Returns the sign that the last name of a path implies: `Some(true)` greater than 0, `Some(false)` not less than 0.
fn sign(path: &str) -> Option<bool> {
    let name = path.split('.').rfind(|segment| segment.parse::<usize>().is_err()).unwrap_or_default();
    let positive = [
        "mass_kg",
        "step_s",
        "duration_s",
        "ramp_s",
        "record_every_s",
        "rate_limit",
        "radius_m",
        "length_m",
        "width_m",
        "height_m",
        "gear_ratio",
        "gear_ratio_rad_per_m",
        "smoothing_rad_s",
        "smoothing_m_s",
        "absolute_tolerance",
        "largest_step_s",
    ];
    let non_negative = [
        "damping",
        "stiffness",
        "torque_limit",
        "force_limit",
        "linear_N",
        "angular_N",
        "moments",
        "radii_m",
        "start_s",
        "rise_s",
        "hold_s",
        "reverse_s",
        "acceleration",
        "seed",
        "dissipation",
        "rotor_inertia",
        "relative_tolerance",
    ];
    let is_stop = path.contains(".limits.stiffness");
    let is_rise_of_rate = path.contains("prescribed.pulse.rise_s");
    let is_friction =
        ["friction.torque", "friction.force", "brake.torque", "brake.force"].iter().any(|p| path.contains(p));
    if is_friction {
        Some(false)
    } else if is_stop || is_rise_of_rate || positive.contains(&name) {
        Some(true)
    } else {
        non_negative.iter().any(|start| name.starts_with(start)).then_some(false)
    }
}

#[test]
fn every_number_refuses_a_text_a_boolean_a_list_and_nothing() {
    for path in number_fields() {
        for value in [json!("x"), json!(true), json!([[1]]), Value::Null] {
            let error = read(EVERYTHING, "all.yaml", &[(path.clone(), value.clone())]).unwrap_err();
            assert!(error.allowed.contains("number") || error.field == "version", "{error}");
            assert_eq!(error.field, path, "{error}");
        }
    }
}

#[test]
fn every_number_refuses_a_value_outside_its_range_with_the_range() {
    for path in number_fields().into_iter().filter(|path| path != "version") {
        let refused = |value: f64| match read(EVERYTHING, "all.yaml", &[(path.clone(), json!(value))]) {
            Err(error) if error.field == path && error.allowed.contains("than 0") => true,
            Ok(_) | Err(_) => false,
        };
        match sign(&path) {
            Some(positive) => {
                assert!(refused(-1.5), "{path}");
                // A seed is a whole number, and refuses 0.0 in other words.
                let other = path.ends_with("seed");
                assert!(other || refused(0.0) == positive, "{path}");
            }
            None => assert!(!refused(-1.5) && !refused(0.0), "{path}"),
        }
    }
}

/// Fragments of text that resemble YAML.
fn near_yaml() -> impl Strategy<Value = String> {
    let token = prop::sample::select(vec![
        "version: 1",
        "title: x",
        "bodies:",
        "  ship:",
        "    mass_kg: ",
        "    mass_t: ",
        "parameters:",
        "  - ",
        "name: ",
        "writes: [",
        "]",
        "{",
        "}",
        "[",
        ",",
        ": ",
        "\n",
        "\n  ",
        "\n    ",
        "&a ",
        "*a",
        "<<: ",
        "!x ",
        "!!int ",
        "| ",
        "> ",
        "'",
        "\"",
        "#",
        "- ",
        "? ",
        "---",
        "...",
        "%YAML 1.2",
        ".nan",
        "-.inf",
        "1e400",
        "0x1F",
        "-0",
        "9223372036854775808",
        "true",
        "~",
        "\t",
        "\u{feff}",
        "\u{0}",
        "é",
        "🚢",
        "shape: {box: {}}",
        "joint: {floating: {}}",
        "default: ",
        "bodies.ship.mass_kg",
        "forces: ",
        "drives: ",
        "simulation: {step_s: ",
    ]);
    prop::collection::vec(token, 0..40).prop_map(|tokens| tokens.concat())
}

/// The paper's scenario with a stretch of characters replaced.
fn damaged() -> impl Strategy<Value = String> {
    (0..PAPER.len(), 0..12_usize, "\\PC{0,6}").prop_map(|(start, length, new)| {
        let mut text: Vec<char> = PAPER.chars().collect();
        let start = start.min(text.len());
        let end = (start + length).min(text.len());
        text.splice(start..end, new.chars());
        text.into_iter().collect()
    })
}

fn check_error(text: &str) {
    if let Err(error) = read(text, "any.yaml", &[]) {
        let shown = error.to_string();
        assert!(!shown.contains('\n') && !error.found.is_empty() && !error.allowed.is_empty(), "{shown}");
        let lines = text.lines().count().max(1);
        assert!(error.line.is_some_and(|line| line >= 1 && line <= lines + 1), "{shown}");
    }
}

proptest! {
    #[test]
    fn no_text_makes_the_reader_panic(text in any::<String>()) {
        check_error(&text);
    }

    #[test]
    fn no_text_near_yaml_makes_the_reader_panic(text in near_yaml()) {
        check_error(&text);
        check_error(&format!("version: 1\ntitle: x\n{text}"));
    }

    #[test]
    fn no_damage_to_a_scenario_makes_the_reader_panic(text in damaged()) {
        check_error(&text);
    }

    #[test]
    fn no_assignment_makes_the_reader_panic(text in "\\PC{0,20}", path in "[a-z_.0-9]{0,30}") {
        for assignment in [text.clone(), format!("{path}={text}"), format!("bodies.ship.{path}={text}")] {
            if let Ok(pair) = parse_assignment(&assignment) {
                let _ = read(PAPER, "paper.yaml", &[pair]);
            }
        }
    }

    #[test]
    fn numbers_are_read_and_written_without_rounding(mass in 1e-300..1e300_f64, x in prop::num::f64::NORMAL) {
        let text = format!("version: 1\ntitle: x\nbodies: {{a: {{mass_kg: {mass:?}, centre_of_mass_m: [{x:?}, 0, -0.0], shape: {{point: {{}}}}, joint: {{fixed: {{}}}}}}}}");
        if let Ok(scenario) = read(&text, "a.yaml", &[]) {
            let again = read(&scenario.to_json(), "a.json", &[]).unwrap();
            for scenario in [&scenario, &again] {
                let body = &scenario.bodies["a"];
                prop_assert_eq!(body.mass_kg.get().to_bits(), mass.to_bits());
                prop_assert_eq!(body.centre_of_mass_m.map(f64::to_bits), [x, 0.0, -0.0].map(f64::to_bits));
            }
        }
    }
}
