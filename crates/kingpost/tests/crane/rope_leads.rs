//! Offlead and sidelead of ropes: the angles of the leg between crane and load, from the positions of both.

use crate::common;

use common::{simulation, values};

/// A crane that stands turned by an azimuth, with its tip at a radius of 12 m and a height of 20 m, and a load at rest at so
/// much outward, to the boom's port side and below the tip, m.
fn crane(azimuth_deg: f64, [outward, aside, below]: [f64; 3], path: &str) -> String {
    let (sin, cos) = azimuth_deg.to_radians().sin_cos();
    let radius = 12.0 + outward;
    let [x, y, z] = [cos * radius - sin * aside, sin * radius + cos * aside, 20.0 - below];
    format!(
        "version: 1
title: A crane
simulation: {{step_s: 0.001, duration_s: 1}}
bodies:
  boom:
    mass_kg: 1000
    shape: {{box: {{length_m: 10, width_m: 1, height_m: 1}}}}
    joint: {{fixed: {{orientation_deg: [0, 0, {azimuth_deg}]}}}}
  drum:
    parent: boom
    mass_kg: 100
    shape: {{cylinder: {{radius_m: 0.5, length_m: 1, axis: y}}}}
    joint: {{revolute: {{name: winch, position_m: [1, 0, 2], axis: [0, 1, 0], mode: held}}}}
  load:
    mass_kg: 1000
    shape: {{sphere: {{radius_m: 1}}}}
    joint: {{floating: {{initial: {{position_m: [{x}, {y}, {z}]}}}}}}
forces:
  hoist:
    rope:
      path:
        - drum: {{joint: winch, radius_m: 0.5}}
        - sheave: {{body: boom, position_m: [12, 0, 20], radius_m: 0.0001, axis: [0, 1, 0]}}
{path}      axial_stiffness_N: 1e6
"
    )
}

const SINGLE: &str = "        - point: {body: load}\n";
const DEAD_END_ON_THE_BOOM: &str =
    "        - point: {body: load}\n        - point: {body: boom, position_m: [12, 0, 20]}\n";
const DEAD_END_ON_THE_LOAD: &str = "        - point: {body: load}
        - point: {body: boom, position_m: [12, 0, 20]}
        - point: {body: load}
";

#[test]
fn the_lead_angles_of_the_leg_to_the_load_follow_the_loads_position() {
    for azimuth_deg in [0.0, 37.0, -150.0] {
        for place in [[0.0, 0.0, 10.0], [2.0, 0.0, 10.0], [-1.0, 0.0, 8.0], [0.0, 1.5, 10.0], [1.0, -2.0, 6.0_f64]] {
            for path in [SINGLE, DEAD_END_ON_THE_BOOM, DEAD_END_ON_THE_LOAD] {
                let mut found = simulation(&crane(azimuth_deg, place, path));
                let [outward, aside, below] = place;
                let exact = [outward.atan2(below), (aside / (outward.hypot(below).hypot(aside))).asin()];
                // The axis of the sheave points to port; its radius moves the rope by 0.1 mm of at least 6 m.
                for (variable, exact) in ["rope_offlead", "rope_sidelead"].into_iter().zip(exact) {
                    let angle = values(&mut found, variable)[0];
                    assert!((angle - exact).abs() < 2e-5, "{variable} {place:?} at {azimuth_deg}: {angle} {exact}");
                }
            }
        }
    }
}

#[test]
fn about_a_vertical_axis_a_rope_has_zero_offlead_and_its_angle_to_the_horizontal_as_sidelead() {
    let path = "        - point: {body: load}\n";
    let text = crane(0.0, [3.0, 0.0, 4.0], path)
        .replace("radius_m: 0.0001, axis: [0, 1, 0]", "radius_m: 0.0001, axis: [0, 0, 1]");
    let mut found = simulation(&text);
    assert_eq!(values(&mut found, "rope_offlead")[0], 0.0);
    assert!((values(&mut found, "rope_sidelead")[0] + (4.0_f64 / 5.0).asin()).abs() < 1e-4);
}

#[test]
fn a_rope_without_a_sheave_on_its_crane_has_no_leads() {
    let text = crane(0.0, [0.0, 0.0, 5.0], SINGLE);
    let sling = "  sling: {rope: {path: [{point: {body: boom}}, {point: {body: load}}], axial_stiffness_N: 1e6}}\n";
    let channels = simulation(&format!("{text}{sling}"));
    let of = |variable: &str| {
        let channel = channels.channels().iter().find(|channel| channel.variable == variable);
        channel.expect("a rope shows it").columns.clone()
    };
    assert_eq!(of("rope_tension"), ["hoist.rope_tension", "sling.rope_tension"]);
    assert_eq!(of("rope_offlead"), ["hoist.rope_offlead"]);
}
