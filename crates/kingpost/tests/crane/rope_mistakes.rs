//! Mistakes that a user can make with a rope: each is reported at its place.

use crate::common;

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
fn a_rope_without_a_load_is_refused() {
    let path = "- drum: {joint: winch, radius_m: 0.5}
        - sheave: {body: world, radius_m: 0.3, axis: [0, 1, 0]}
        - point: {body: load}";
    let of = |first: &str| refused(path, &format!("- point: {{{first}}}\n        - point: {{body: load}}"));
    let one = of("body: load, position_m: [0, 0, 1]");
    let expected = "forces.fall.rope.path: found places that are all on load, allowed: places on two bodies";
    assert!(one.contains(expected), "{one}");
    let short = of("body: world, position_m: [0.3, 0, -3]");
    assert!(short.contains("forces.fall.rope.path: found a path of 0.0000 m, allowed: one of at least "), "{short}");
}

#[test]
fn falls_are_a_whole_number() {
    let error = refused("- point: {body: load}", "- point: {body: load, falls: 1.5}");
    let expected = "forces.fall.rope.path.2.point.falls: found 1.5, allowed: a whole number not less than 0";
    assert!(error.contains(expected), "{error}");
}

#[test]
fn an_invalid_path_is_refused_at_its_place() {
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
            "forces.fall.rope.path.1: found a place 4.0000 m from the place before it, allowed: a distance above 4.3000 m",
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

/// The load's sphere of 0.6 m is not a sheave: the rope ends at its centre, which the winch hauls into the
/// fixed sheave.
#[test]
fn a_winch_that_hauls_its_load_into_the_sheave_is_an_event() {
    let text = TEXT.replace("rate_rad_s: 0", "rate_rad_s: -2").replace("step_s: 0.002", "step_s: 0.001");
    let mut hauling = simulation(&text);
    for _ in 0..20_000 {
        if hauling.step(1).is_err() {
            break;
        }
        if let Some(event) = hauling.events().first() {
            assert_eq!(
                event.what,
                "wraps a sheave or drum beyond the valid angle, or two neighbouring places of its path overlap"
            );
            // 2.7 m are left where it begins, less what the acceleration takes.
            assert!((4.0..6.0).contains(&event.time_s), "{event:?}");
            // The path was one until then: the energy closes but for the bends of the drive's limits.
            let error = values(&mut hauling, "energy_error")[0] / values(&mut hauling, "work_by_drives")[0];
            assert!(error.abs() < 1e-4, "{error:e}");
            return;
        }
    }
    panic!("no event");
}

/// 1 t on 10 m of rope, free.
fn hanging(more: &str) -> String {
    format!(
        "version: 1
title: A load on a rope
parameters: [{{name: length_m, label: Length, unit: m, default: 10, range: [5, 15], live: true, writes: [forces.fall.rope.unstretched_length_m]}}]
simulation: {{step_s: 0.002, duration_s: 60, begin_at_equilibrium: true}}
bodies:
  load:
    mass_kg: 1000
    shape: {{sphere: {{radius_m: 0.6}}}}
    joint: {{floating: {{initial: {{position_m: [0, 0, -10]}}}}}}
forces:
  gravity: {{gravity: {{}}}}
  fall:
    rope:
      path: [{{point: {{body: world}}}}, {{point: {{body: load}}}}]
      unstretched_length_m: 10
      axial_stiffness_N: 1e6{more}
"
    )
}

#[test]
fn a_rope_that_cannot_carry_its_load_at_rest_is_refused() {
    let text = hanging("\n      breaking_load_N: 5000");
    let error = read(&text, "hoist.yaml", &[]).and_then(|scenario| scenario.setup()).expect_err("too weak").to_string();
    assert!(error.contains("forces.fall.rope.breaking_load_N: found 5000, allowed: more than 9807 N"), "{error}");
}

/// The tension from the damper at 2 m/s is k tau v = 20 kN as the rope becomes taut.
#[test]
fn a_rope_parts_when_its_damper_exceeds_the_breaking_load_as_it_becomes_taut() {
    let drop = |load: &str| {
        let text = hanging(&format!("\n      damping_time_s: 0.1\n      breaking_load_kN: {load}"));
        let text = text.replace("begin_at_equilibrium: true", "begin_at_equilibrium: false");
        let mut falling = simulation(&text.replace("[0, 0, -10]}", "[0, 0, -9.9], velocity_m_s: [0, 0, -2]}"));
        falling.step(100).expect("a fall");
        let parted = falling.events().iter().any(|event| event.what == "comes taut") && falling.state().m == [3];
        (parted, values(&mut falling, "rope_tension")[0])
    };
    assert_eq!(drop("15"), (true, 0.0));
    let (parted, tension) = drop("60");
    assert!(!parted && tension > 1e4, "{tension}");
}

/// A rope that is lengthened or shortened during a run becomes slack or taut from then on.
#[test]
fn a_rope_whose_length_is_set_during_a_run_goes_slack_and_taut() {
    let text = hanging("");
    let scenario = read(&text, "hoist.yaml", &[]).expect("it reads");
    let mut hanging = scenario.simulation().expect("it builds");
    let set = |hanging: &mut kingpost::Simulation, length: f64| {
        let overrides = [("length_m".to_owned(), serde_json::json!(length))];
        let next = read(&text, "hoist.yaml", &overrides).expect("it reads").simulation().expect("it builds");
        hanging.go_on_as(next, "length_m").expect("a live number");
    };
    set(&mut hanging, 12.0);
    assert_eq!(values(&mut hanging, "rope_tension"), [0.0]);
    assert!((hanging.acceleration(None).unwrap()[2] + 9.80665).abs() < 1e-12);
    set(&mut hanging, 9.99);
    // k (e + 1 cm), k = 1e6 N / 9.99 m.
    let pull = values(&mut hanging, "rope_tension")[0];
    let stretch = 1000.0 * 9.80665 * 10.0 / 1e6 + 0.01;
    assert!((pull / (1e6 / 9.99 * stretch) - 1.0).abs() < 1e-6, "{pull}");
}
