//! Load charts of cranes: radius, rated load and hook load, against hand calculations.

use crate::common;

use common::{simulation, values};
use kingpost::scenario::read;

const G: f64 = 9.80665;

/// A crane of radius 12 m, heeled and slewed, and a load 10 m below its tip in the crane's axes, and off to
/// port by this distance, m. The rope carries 1e6 N per unit strain.
fn crane([heel_deg, slew_deg, off]: [f64; 3], path: &str, more: &str) -> String {
    let (sin, cos) = slew_deg.to_radians().sin_cos();
    let [x, y, z] = [12.0 * cos - off * sin, 12.0 * sin + off * cos, 10.0];
    let (sin, cos) = heel_deg.to_radians().sin_cos();
    let [x, y, z] = [x + 3.0, cos * y - sin * z - 2.0, sin * y + cos * z + 1.0];
    format!(
        "version: 1
title: A crane with a load chart
simulation: {{step_s: 0.001, duration_s: 1, record_every_s: 0.01}}
bodies:
  post:
    mass_kg: 1000
    shape: {{box: {{length_m: 10, width_m: 1, height_m: 1}}}}
    joint:
      revolute:
        name: slew
        axis: [0, 0, 1]
        position_m: [3, -2, 1]
        orientation_deg: [{heel_deg}, 0, 0]
        initial_angle_deg: {slew_deg}
        mode: held
  load:
    mass_kg: 1000
    shape: {{sphere: {{radius_m: 1}}}}
    joint: {{floating: {{initial: {{position_m: [{x}, {y}, {z}]}}}}}}
forces:
  gravity: {{gravity: {{}}}}
  hoist:
    rope:
      path:
        - point: {{body: post, position_m: [1, 0, 20]}}
        - point: {{body: post, position_m: [12, 0, 20]}}
{path}      axial_stiffness_N: 1e6
      load_chart: {{joint: slew, radii_m: [5, 10, 20], rated_loads_t: [8, 4, 1]}}
{more}"
    )
}

const SINGLE: &str = "        - point: {body: load}\n";
const DOUBLE: &str = "        - point: {body: load, falls: 2}\n";
const DEAD_END_ON_THE_BOOM: &str =
    "        - point: {body: load}\n        - point: {body: post, position_m: [12, 0, 20]}\n";

/// Returns the length as text and the tension, N, of a rope with 11 m on the boom and this number of falls of
/// 10 m, too short by 20 mm.
fn short(falls: f64) -> (String, f64) {
    let length = 11.0 + 10.0 * falls - 0.02;
    (format!("      unstretched_length_m: {length}\n"), 1e6 * 0.02 / length)
}

/// Heel and slew rotate the crane as a whole: its radius stays 12 m, and its rated load 3.4 t.
#[test]
fn the_radius_is_relative_to_the_crane_and_the_hook_load_includes_every_fall() {
    for place in [[0.0, 0.0, 0.0], [0.0, 130.0, 0.0], [7.0, -40.0, 0.0]] {
        for (path, falls) in [(SINGLE, 1.0), (DOUBLE, 2.0), (DEAD_END_ON_THE_BOOM, 2.0)] {
            let (length, tension) = short(falls);
            let mut found = simulation(&crane(place, path, &length));
            let exact = [12.0, 3400.0, falls * tension / G, falls * tension / G / 3400.0];
            let variables = ["load_radius", "rated_load", "hook_load", "load_utilisation"];
            for (variable, exact) in variables.into_iter().zip(exact) {
                let value = values(&mut found, variable)[0];
                assert!((value / exact - 1.0).abs() < 1e-9, "{variable} {place:?} {falls}: {value} {exact}");
            }
        }
    }
}

#[test]
fn a_load_off_to_the_side_has_its_full_hook_load_and_the_radius_of_the_tip() {
    let mut found = simulation(&crane([0.0, 20.0, 4.0], SINGLE, "      unstretched_length_m: 21.7\n"));
    let tension = 1e6 * (11.0 + 116.0_f64.sqrt() - 21.7) / 21.7;
    assert!((values(&mut found, "hook_load")[0] * G / tension - 1.0).abs() < 1e-9);
    assert!((values(&mut found, "load_radius")[0] - 12.0).abs() < 1e-12);
    let mut slack = simulation(&crane([0.0, 20.0, 4.0], SINGLE, "      unstretched_length_m: 25\n"));
    assert_eq!([values(&mut slack, "hook_load"), values(&mut slack, "load_utilisation")], [[0.0], [0.0]]);
}

/// At rest the falls carry the load alone: the rope's own weight hangs above the hook.
#[test]
fn a_load_at_rest_on_a_heavy_rope_or_an_inextensible_one_shows_its_mass() {
    let at_rest = |path: &str, more: &str| {
        let text = crane([0.0, 0.0, 0.0], path, more);
        simulation(&text.replace("record_every_s: 0.01", "record_every_s: 0.01, begin_at_equilibrium: true"))
    };
    let heavy = "      mass_kg_per_m: 5\n      damping_time_s: 0.01\n      unstretched_length_m: 31\n";
    let mut found = at_rest(DOUBLE, heavy);
    assert!((values(&mut found, "hook_load")[0] - 1000.0).abs() < 1e-4);
    let text = crane([0.0, 0.0, 0.0], DOUBLE, "").replace("      axial_stiffness_N: 1e6\n", "");
    let mut held = simulation(&text);
    held.step(1).expect("it hangs");
    assert!((values(&mut held, "hook_load")[0] - 1000.0).abs() < 1e-6);
}

/// Linear between 10 m and 20 m, and constant at 5 m and at 20 m, with a warning there.
#[test]
fn the_rated_load_is_linear_between_radii_and_constant_beyond_the_chart_with_a_warning() {
    for (tip, rated_t, outside) in [(5.0, 8.0, false), (7.5, 6.0, false), (15.0, 2.5, false), (20.0, 1.0, false)]
        .into_iter()
        .chain([(3.0, 8.0, true), (24.0, 1.0, true)])
    {
        let text = crane([0.0; 3], SINGLE, "").replace("[12, 0, 20]", &format!("[{tip}, 0, 20]"));
        let mut found = simulation(&text.replace("[15, -2, 11]", &format!("[{}, -2, 11]", tip + 3.0)));
        assert!((values(&mut found, "rated_load")[0] / 1000.0 / rated_t - 1.0).abs() < 1e-12, "{tip}");
        let warnings = found.run(|_| true).warnings;
        let text = format!("at a radius of {tip} m, outside of the load chart, which is for 5 to 20 m");
        let warned = warnings.iter().any(|warning| warning.name == "hoist" && warning.text.contains(&text));
        assert_eq!(warned, outside, "{tip}: {warnings:?}");
    }
}

/// A mass that is released on a spring pulls with twice its weight: 2 t at 12 m, of 3.4 t, and of 1.7 t.
#[test]
fn a_load_beyond_the_chart_gives_a_warning_with_the_largest_utilisation() {
    let let_go = |rated: &str| {
        let text = crane([0.0; 3], SINGLE, "").replace("rated_loads_t: [8, 4, 1]", rated);
        let mut found = simulation(&text);
        found.run(|_| true).warnings.into_iter().filter(|warning| warning.name == "hoist").collect::<Vec<_>>()
    };
    assert!(let_go("rated_loads_t: [8, 4, 1]").iter().all(|warning| !warning.text.contains("rated load")));
    let found = let_go("rated_loads_t: [4, 2, 0.5]");
    assert!(found[0].text.starts_with("its hook load was 117.6 % of the rated load at"), "{found:?}");
}

#[test]
fn an_invalid_chart_is_refused_at_its_place() {
    let whole = "{joint: slew, radii_m: [5, 10, 20], rated_loads_t: [8, 4, 1]}";
    for (chart, wording) in [
        (
            "{joint: luff, radii_m: [5, 10], rated_loads_t: [8, 4]}",
            "load_chart.joint: found luff, allowed: one of slew",
        ),
        (
            "{joint: slew, radii_m: [5], rated_loads_t: [8]}",
            "load_chart.radii_m: found 1 numbers, allowed: 2 radii or more",
        ),
        (
            "{joint: slew, radii_m: [5, 10], rated_loads_t: [8]}",
            "load_chart.rated_loads_kg: found 1 numbers, allowed: 2, one for each radius",
        ),
        (
            "{joint: slew, radii_m: [5, 10, 9], rated_loads_t: [8, 4, 1]}",
            "load_chart.radii_m.2: found 9, allowed: more than the radius before, 10",
        ),
        (
            "{joint: slew, radii_m: [-5, 10], rated_loads_t: [8, 4]}",
            "load_chart.radii_m.0: found -5, allowed: a number, at least 0",
        ),
        ("{joint: slew, radii_m: [5, 10], rated_loads_t: [8, 0]}", "load_chart.rated_loads_t.1: found 0"),
    ] {
        let text = crane([0.0; 3], SINGLE, "").replace(whole, chart);
        let error = read(&text, "crane.yaml", &[]).and_then(|scenario| scenario.setup()).expect_err(chart).to_string();
        assert!(error.contains(wording), "{error}");
    }
}
