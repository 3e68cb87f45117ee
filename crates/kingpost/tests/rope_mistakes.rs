//! What a person may get wrong with a rope: each has an answer at its place.

mod common;

use common::{simulation, values};
use kingpost::scenario::read;

/// A crane on the world: a drum, a boom with a sheave, a free load.
const TEXT: &str = "version: 1
title: A hoist
simulation: {step_s: 0.002, duration_s: 60}
bodies:
  drum:
    mass_kg: 200
    shape: {cylinder: {radius_m: 0.5, length_m: 1, axis: y}}
    joint: {revolute: {name: winch, position_m: [-4, 0, 0], axis: [0, 1, 0]}}
  load:
    mass_kg: 500
    shape: {sphere: {radius_m: 0.6}}
    joint: {floating: {initial: {position_m: [0.3, 0, -3]}}}
forces:
  gravity: {gravity: {}}
  fall:
    rope:
      path:
        - drum: {joint: winch, radius_m: 0.5}
        - sheave: {body: world, radius_m: 0.3, axis: [0, 1, 0]}
        - point: {body: load}
      axial_stiffness_N: 1e6
      damping_time_s: 0.02
drives:
  hoist:
    controlled_drive:
      {joint: winch, set_point: {speed: {rate_rad_s: 0}}, speed_limit_rad_s: 2, acceleration_limit_rad_s2: 0.5,
        torque_limit_kN_m: 40, stiffness_kN_m_per_rad: 200, damping_kN_m_s_per_rad: 6}
";

fn refused(from: &str, to: &str) -> String {
    assert!(TEXT.contains(from), "{from}");
    let text = TEXT.replacen(from, to, 1);
    let error = read(&text, "hoist.yaml", &[]).and_then(|scenario| scenario.setup()).expect_err("a mistake");
    error.to_string()
}

#[test]
fn a_path_that_is_none_is_refused_at_its_place() {
    let cases = [
        (
            "- drum: {joint: winch, radius_m: 0.5}\n",
            "- sheave: {body: world, radius_m: 0.1, axis: [0, 1, 0]}\n",
            "forces.fall.rope.path.0: found a sheave, allowed: a point or a drum, where a rope begins",
        ),
        (
            "- point: {body: load}",
            "- sheave: {body: load, radius_m: 0.1, axis: [0, 1, 0]}",
            "forces.fall.rope.path.2: found a sheave, allowed: a point, where a rope ends",
        ),
        (
            "- sheave: {body: world, radius_m: 0.3, axis: [0, 1, 0]}",
            "- drum: {joint: winch, radius_m: 0.5}",
            "forces.fall.rope.path.1: found a drum, allowed: a point or a sheave",
        ),
        (
            "{joint: winch, radius_m: 0.5}\n        - sheave",
            "{joint: winc, radius_m: 0.5}\n        - sheave",
            "forces.fall.rope.path.0.drum.joint: found winc, allowed: one of winch",
        ),
        ("- point: {body: load}", "- point: {body: lode}", "forces.fall.rope.path.2.point.body: found lode"),
        (
            "- point: {body: load}",
            "- point: {body: load, falls: 4}",
            "forces.fall.rope.path.2.point.falls: found 4 from a sheave, allowed: 1",
        ),
        ("- point: {body: load}", "- point: {body: load, falls: 0}", "forces.fall.rope.path.2.point.falls: found 0"),
        (
            "radius_m: 0.3, axis",
            "radius_m: 3.8, axis",
            "forces.fall.rope.path.1: found a place 4.0000 m from the one before it, allowed: one farther from it than 4.3000 m",
        ),
        (
            "radius_m: 0.3, axis",
            "efficiency_hoisting: 0, radius_m: 0.3, axis",
            "path.1.sheave.efficiency_hoisting: found 0",
        ),
        (
            "axial_stiffness_N: 1e6",
            "axial_stiffness_N: 1e6\n      unstretched_length_m: 5",
            "forces.fall.rope.unstretched_length_m: found 5 m, on a path of",
        ),
    ];
    for (from, to, expected) in cases {
        let error = refused(from, to);
        assert!(error.contains(expected), "{error}");
        assert!(error.starts_with("hoist.yaml:"), "{error}");
    }
}

/// The winch hauls until nothing is left: an event, and no number that is none.
#[test]
fn a_winch_that_hauls_all_its_rope_in_is_an_event() {
    let mut hauling =
        simulation(&TEXT.replace("rate_rad_s: 0", "rate_rad_s: -2").replace("step_s: 0.002", "step_s: 0.004"));
    let mut ended = false;
    for _ in 0..5000 {
        if hauling.step(1).is_err() {
            ended = true;
            break;
        }
    }
    let happened: Vec<&str> = hauling.events().iter().map(|event| event.what).collect();
    let warned = happened.iter().any(|what| what.starts_with("turns about") || what.starts_with("is hauled"));
    assert!(warned, "{ended} {happened:?} {:?}", values(&mut hauling, "rope_length"));
    assert!(values(&mut hauling, "rope_tension")[0].is_finite());
}
