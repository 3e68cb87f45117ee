//! Clearances of points and their air gap, against hand calculations.

use crate::common;

use common::splash::Wave;
use common::{simulation, values};
use kingpost::scenario::{Files, read, read_with};
use kingpost::simulation::Simulation;
use serde_json::Value;
use std::collections::HashMap;

/// An arm that rotates at 0.3 rad/s about the vertical through the origin, with a hook at 5 m radius and 2 m
/// height, and a cart that moves along x at 0.5 m/s from x = 8 m, at z = -1 m.
fn arm_and_cart(sensors: &str) -> String {
    format!(
        "version: 1
title: An arm and a cart
simulation: {{step_s: 0.05, duration_s: 8, record_every_s: 0.05}}
bodies:
  arm:
    mass_kg: 100
    centre_of_mass_m: [0.4, 0, 0]
    shape: {{box: {{length_m: 6, width_m: 1, height_m: 1}}}}
    joint: {{revolute: {{axis: [0, 0, 1], mode: {{prescribed: {{rate_rad_s: 0.3}}}}}}}}
    points: {{hook: {{position_m: [5, 0, 2]}}}}
  cart:
    mass_kg: 100
    centre_of_mass_m: [0, 0, 0.7]
    shape: {{box: {{length_m: 4, width_m: 2, height_m: 2}}}}
    joint: {{prismatic: {{axis: [1, 0, 0], position_m: [8, 0, -1], mode: {{prescribed: {{speed_m_s: 0.5}}}}}}}}
    points: {{roof: {{position_m: [0, 0, 1]}}}}
forces:
  gravity: {{gravity: {{}}}}
{sensors}"
    )
}

/// Returns the position of the hook in a frame on the cart.
fn hook_from_cart(time_s: f64) -> [f64; 3] {
    let (sin, cos) = (0.3 * time_s).sin_cos();
    [5.0 * cos - 8.0 - 0.5 * time_s, 5.0 * sin, 3.0]
}

fn length(vector: [f64; 3]) -> f64 {
    vector.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Returns the distance from a box with these half edges, for a point outside it.
fn from_box(point: [f64; 3], half: [f64; 3]) -> f64 {
    length(std::array::from_fn(|k| (point[k].abs() - half[k]).max(0.0)))
}

/// Prescribed motions at constant rates are exact: the remaining error is rounding.
#[test]
fn the_clearance_of_two_points_is_the_distance_from_their_motions() {
    let text = arm_and_cart(
        "sensors:
  by_name: {clearance: {first: {body: arm, point: hook}, second: {body: cart, point: roof}}}
  by_place: {clearance: {first: {body: arm, position_m: [5, 0, 2]}, second: {body: cart, position_m: [0, 0, 1]}}}
  beside: {clearance: {first: {body: arm, point: hook, position_m: [0, 0, -2]}, second: {body: world, position_m: [0, 0, 0]}}}
",
    );
    let mut run = simulation(&text);
    for _ in 0..8 {
        run.step(20).expect("it moves");
        let [x, y, z] = hook_from_cart(run.time_s());
        let exact = length([x, y, z - 1.0]);
        let found = values(&mut run, "clearance");
        for (found, exact) in found.iter().zip([exact, exact, 5.0]) {
            assert!((found - exact).abs() < 1e-12, "{found} m, not {exact} m");
        }
    }
}

#[test]
fn the_clearance_to_a_solid_is_the_distance_to_its_nearest_face_edge_or_corner() {
    let text = arm_and_cart(
        "sensors:
  own: {clearance: {first: {body: arm, point: hook}, second: {body: cart, shape: own}}}
  cabin: {clearance: {first: {body: arm, point: hook}, second: {body: cart, position_m: [-1, 0, 1], shape: {box: {length_m: 1, width_m: 1, height_m: 2}}}}}
  lamp: {clearance: {first: {body: arm, point: hook}, second: {body: cart, point: roof, shape: {sphere: {radius_m: 0.4}}}}}
  mast: {clearance: {first: {body: arm, point: hook}, second: {body: cart, orientation_rad: [1.5707963267948966, 0, 0], shape: {cylinder: {radius_m: 0.5, length_m: 3, axis: y}}}}}
  quay: {clearance: {first: {body: arm, point: hook}, second: {body: world, position_m: [0, 6, 0], shape: {plane: {normal: [0, -2, 0]}}}}}
",
    );
    let mut run = simulation(&text);
    for _ in 0..8 {
        run.step(20).expect("it moves");
        let [x, y, z] = hook_from_cart(run.time_s());
        // A cylinder along y that is rolled by a quarter turn stands upright.
        let (off, above) = (x.hypot(y) - 0.5, z - 1.5);
        let exact = [
            from_box([x, y, z - 0.7], [2.0, 1.0, 1.0]),
            from_box([x + 1.0, y, z - 1.0], [0.5, 0.5, 1.0]),
            length([x, y, z - 1.0]) - 0.4,
            off.max(0.0).hypot(above),
            6.0 - y,
        ];
        for (found, exact) in values(&mut run, "clearance").iter().zip(exact) {
            assert!((found - exact).abs() < 1e-12, "{found} m, not {exact} m");
        }
    }
}

#[test]
fn a_point_inside_a_solid_has_a_negative_clearance() {
    // Of a box that holds the hook, the nearest face is above it.
    let text = arm_and_cart(
        "sensors:
  inside: {clearance: {first: {body: arm, point: hook}, second: {body: world, position_m: [5, 0, 1], shape: {box: {length_m: 6, width_m: 6, height_m: 3}}}}}
",
    );
    let found = values(&mut simulation(&text), "clearance")[0];
    assert!((found + 0.5).abs() < 1e-15, "{found}");
}

/// A scenario with a sea, and with a clearance in addition to the air gaps.
fn over_waves(wave: &Wave, rest: &str) -> String {
    let text = arm_and_cart(
        "sensors:
  platform: {air_gap: {body: world, position_m: [0, 0, 7]}}
  roof: {air_gap: {body: cart, point: roof}}
",
    );
    text.replacen("bodies:", &format!("sea: {{{}}}\nbodies:", wave.sea()), 1) + rest
}

/// Airy's wave in deep water, eta = a cos(k x - w t + phase); for phases of a few turns the rounding is 1e-14
/// m.
#[test]
fn the_air_gap_is_the_height_over_a_regular_wave_at_the_point() {
    let wave = Wave::new(3.0, 7.0, 0.4);
    let mut run = simulation(&over_waves(&wave, ""));
    for _ in 0..8 {
        run.step(20).expect("it moves");
        let time_s = run.time_s();
        let x = 8.0 + 0.5 * time_s;
        let along = wave.amplitude * (wave.number * x - wave.frequency * time_s + wave.phase).cos();
        let exact = [7.0 - wave.surface(time_s)[0], 0.0 - along];
        for (found, exact) in values(&mut run, "air_gap").iter().zip(exact) {
            assert!((found - exact).abs() < 1e-12, "{found} m, not {exact} m at {time_s} s");
        }
    }
}

#[test]
fn over_still_water_the_air_gap_is_the_height() {
    let text = arm_and_cart(
        "sensors: {hook: {air_gap: {body: arm, point: hook}}, keel: {air_gap: {body: cart, position_m: [0, 0, -3]}}}\n",
    );
    let mut run = simulation(&text);
    run.step(30).expect("it moves");
    for (found, exact) in values(&mut run, "air_gap").iter().zip([2.0, -4.0]) {
        assert!((found - exact).abs() < 1e-15, "{found} {exact}");
    }
}

fn whole_run(text: &str) -> Simulation {
    let mut run = simulation(text);
    run.run(|_| true).status.expect("it ends");
    run
}

/// A crest passes the platform after half a period, 3.5 s, because the phase starts with a trough.
#[test]
fn a_limit_on_an_air_gap_is_exceeded_when_the_crest_passes() {
    let wave = Wave::new(3.0, 7.0, std::f64::consts::PI);
    let limits = "limits:
  dry: {column: platform.air_gap, at_least: 5.4}
  wet: {column: platform.air_gap, at_least: 5.6}
";
    let found = whole_run(&over_waves(&wave, limits)).limits();
    assert_eq!(found.iter().map(|limit| limit.held).collect::<Vec<_>>(), [Some(true), Some(false)]);
    for limit in &found {
        assert!((limit.worst.unwrap() - 5.5).abs() < 1e-12, "{limit:?}");
        assert!((limit.worst_time_s.unwrap() - 3.5).abs() < 1e-9, "{limit:?}");
    }
}

/// The cart moves to the quay at 0.5 m/s: its front is 4 m away at the start of the run and 0 m at its end, 8
/// s later.
#[test]
fn a_limit_on_a_clearance_reports_the_smallest_value_and_its_time() {
    let rest = "sensors:
  fender: {clearance: {first: {body: cart, position_m: [2, 0, 0]}, second: {body: world, position_m: [14, 0, 0], shape: {plane: {normal: [-1, 0, 0]}}}}}
limits:
  fender: {column: fender.clearance, at_least: 0.1}
";
    let found = whole_run(&arm_and_cart(rest)).limits();
    let [fender] = &found[..] else { panic!("{found:?}") };
    assert_eq!(fender.held, Some(false));
    assert!(fender.worst.unwrap().abs() < 1e-12 && (fender.worst_time_s.unwrap() - 8.0).abs() < 1e-9, "{fender:?}");
}

/// Checks that a sensor does not change the motion: runs with and without it are bitwise identical.
#[test]
fn a_sensor_changes_no_number_of_the_motion() {
    let wave = Wave::new(3.0, 7.0, 0.4);
    let with = over_waves(&wave, "");
    let without = with.replacen("sensors:\n", "sensors: {}\nwires: {}\n", 1);
    let without: String =
        without.lines().filter(|line| !line.contains("air_gap")).flat_map(|line| [line, "\n"]).collect();
    let [with, without] = [with, without].map(|text| whole_run(&text));
    assert_eq!(with.state().q, without.state().q);
    assert_eq!(with.state().v, without.state().v);
    assert_eq!(with.state().s, without.state().s);
}

#[test]
fn a_sensor_on_a_disabled_body_does_not_exist() {
    let text = arm_and_cart(
        "sensors: {roof: {air_gap: {body: cart, point: roof}}, gap: {clearance: {first: {body: arm, point: hook}, second: {body: cart}}}}\n",
    );
    let off = read(&text, "cart.yaml", &[("bodies.cart.enabled".to_owned(), false.into())]).unwrap();
    let run = off.simulation().expect("it builds");
    assert!(run.channels().iter().all(|channel| !["air_gap", "clearance"].contains(&channel.variable)));
}

#[test]
fn a_mistake_in_a_sensor_is_reported_at_its_place() {
    let good = "sensors:
  gap: {clearance: {first: {body: arm, point: hook}, second: {body: cart, point: roof}}}
  air: {air_gap: {body: arm, point: hook}}
";
    assert!(read(&arm_and_cart(good), "cart.yaml", &[]).is_ok());
    for (from, to, expected) in [
        (
            "first: {body: arm, point: hook}",
            "first: {body: arn}",
            "gap.clearance.first.body: found arn, allowed: one of arm, cart, world",
        ),
        (
            "first: {body: arm, point: hook}",
            "first: {body: arm, point: hok}",
            "gap.clearance.first.point: found hok, allowed: hook; did you mean hook?",
        ),
        (
            "first: {body: arm, point: hook}",
            "first: {body: world, point: hook}",
            "gap.clearance.first.point: found hook, allowed: none: world has no points",
        ),
        (
            "first: {body: arm, point: hook}",
            "first: {body: cart}",
            "gap.clearance.second.body: found cart, allowed: another body than first.body, cart",
        ),
        ("point: roof}", "point: root}", "gap.clearance.second.point: found root, allowed: roof; did you mean roof?"),
        (
            "point: roof}",
            "point: roof, shape: own}",
            "gap.clearance.second.point: found a place, allowed: none: a body's own shape",
        ),
        (
            "point: roof}",
            "position_m: [0, 0, 1], shape: own}",
            "gap.clearance.second.position_m: found a place, allowed: none",
        ),
        (
            "second: {body: cart, point: roof}",
            "second: {body: world, shape: own}",
            "gap.clearance.second.shape: found own, but world is not a solid",
        ),
        (
            "point: roof}",
            "shape: {box: {length_m: 0, width_m: 1, height_m: 1}}}",
            "gap.clearance.second.shape.box.length_m: found 0",
        ),
        (
            "point: roof}",
            "shape: {wall: {}}}",
            "gap.clearance.second.shape: found \"wall\", allowed: one of own, plane, box, cylinder, sphere",
        ),
        (
            "air_gap: {body: arm",
            "air_gap: {body: arms",
            "air.air_gap.body: found arms, allowed: one of arm, cart, world",
        ),
        (
            "air_gap: {body: arm, point: hook",
            "air_gap: {body: arm, point: roof",
            "air.air_gap.point: found roof, allowed: hook",
        ),
    ] {
        assert!(good.contains(from), "{from}");
        let text = arm_and_cart(&good.replacen(from, to, 1));
        let found =
            read(&text, "cart.yaml", &[]).and_then(|scenario| scenario.setup()).expect_err("a mistake").to_string();
        assert!(found.contains(&format!("sensors.{expected}")), "{found}\n{expected}");
    }
}

/// The prefix of the part is added to a body, and a point keeps its name; entries on the world move to the
/// mounting.
#[test]
fn a_sensor_of_a_part_moves_to_the_mounting_of_the_part() {
    let part = arm_and_cart("sensors:\n  gap: {clearance: {first: {body: arm, point: hook}, second: {body: world, position_m: [1, 0, 0], shape: {plane: {}}}}}\n")
        .replace("simulation: {step_s: 0.05, duration_s: 8, record_every_s: 0.05}\n", "")
        .replace("forces:\n  gravity: {gravity: {}}\n", "");
    let texts = HashMap::from([("arm.yaml".to_owned(), part)]);
    let whole = "version: 1
title: Two arms
bodies: {}
parts: {port: {part: arm.yaml}, starboard: {part: arm.yaml, position_m: [0, -30, 4]}}
";
    let scenario = read_with(whole, "whole.yaml", &[], &Files::new(texts)).unwrap_or_else(|error| panic!("{error}"));
    let written: Value = serde_json::from_str(&scenario.to_json()).unwrap();
    let gap = &written["sensors"]["starboard_gap"]["clearance"];
    assert_eq!((&gap["first"]["body"], &gap["first"]["point"]), (&"starboard_arm".into(), &"hook".into()));
    let mut run = scenario.simulation().expect("it builds");
    let channel = run.channels().iter().find(|channel| channel.variable == "clearance").expect("it is measured");
    assert_eq!(channel.columns, ["port_gap.clearance", "starboard_gap.clearance"]);
    // Each is 2 m above its own plane.
    for found in values(&mut run, "clearance") {
        assert!((found - 2.0).abs() < 1e-14, "{found}");
    }
}

/// A box of half edges 3, 0.5, 0.5 m on the arm, at rest in its first position, and shapes at known distances along x.
#[test]
fn the_clearance_between_two_solids_is_that_of_their_nearest_points() {
    let first = "first: {body: arm, position_m: [0.4, 0, 0], shape: {box: {length_m: 6, width_m: 1, height_m: 1}}}";
    let second = |shape: &str| format!("second: {{body: world, position_m: [6, 0, 0], shape: {{{shape}}}}}");
    let hull = "convex: {positions_m: [[-1, 0, 0], [1, -1, -1], [1, 1, -1], [1, 0, 1]]}";
    let cases = [
        ("sphere: {radius_m: 0.6}", 2.0),
        ("box: {length_m: 8, width_m: 1, height_m: 1}", -1.0),
        ("capsule: {radius_m: 0.4, length_m: 3, axis: y}", 2.2),
        ("cylinder: {radius_m: 0.5, length_m: 3, axis: z}", 2.1),
        ("plane: {normal: [-1, 0, 0]}", 2.6),
        (hull, 1.6),
    ];
    let mut sensors = "sensors:\n".to_owned();
    for (i, (shape, _)) in cases.iter().enumerate() {
        sensors += &format!("  at_{i}: {{clearance: {{{first}, {}}}}}\n", second(shape));
    }
    // Own shapes, with a cone that points back along x.
    let cone = "{body: world, position_m: [6, 0, 0], orientation_deg: [0, -90, 0], shape: {cone: {half_angle_deg: 20, length_m: 1}}}";
    sensors += &format!("  own: {{clearance: {{first: {{body: arm, shape: own}}, second: {cone}}}}}\n");
    let mut run = simulation(&arm_and_cart(&sensors));
    let mut row = Vec::new();
    run.write_row(&mut row);
    let found: Vec<f64> = run
        .channels()
        .iter()
        .filter(|channel| channel.variable == "clearance")
        .map(|channel| row[channel.offset])
        .collect();
    for (found, exact) in found.iter().zip(cases.iter().map(|(_, exact)| *exact).chain([2.6])) {
        assert!((found - exact).abs() < 1e-9, "{found} m, not {exact} m");
    }
}
