//! Ropes with weight and drums with layers, against closed forms and conservation laws.

use super::ropes::{crane_in_space, ledger};
use crate::common;

use common::{simulation, values};
use kingpost::scenario::read;

/// Free fall, m/s^2.
const GRAVITY: f64 = 9.80665;
/// Mass of a wire rope of 50 mm, kg/m.
const MASS_KG_PER_M: f64 = 10.0;

/// A load of 1 t on a rope from a drum of 300 kg m2 in the world, 20 m over its place.
fn falling(drum_height_m: f64, drum: &str, rope: &str) -> String {
    let load_height_m = drum_height_m - 20.0;
    format!(
        "version: 1
title: A load on a drum
simulation: {{step_s: 0.005, duration_s: 10}}
bodies:
  drum:
    mass_kg: 2400
    shape: {{cylinder: {{radius_m: 0.5, length_m: 1, axis: y}}}}
    joint: {{revolute: {{name: winch, position_m: [-0.5, 0, {drum_height_m}], axis: [0, 1, 0]}}}}
  load:
    mass_kg: 1000
    shape: {{point: {{}}}}
    joint: {{prismatic: {{name: lift, position_m: [0, 0, {load_height_m}], axis: [0, 0, 1]}}}}
forces:
  gravity: {{gravity: {{acceleration_m_s2: {GRAVITY}}}}}
  hoist: {{rope: {{path: [{{drum: {{joint: winch, radius_m: 0.5{drum}}}}}, {{point: {{body: load}}}}], mass_kg_per_m: {MASS_KG_PER_M}{rope}}}}}
"
    )
}

#[test]
fn a_rope_that_unwinds_a_drum_runs_away_by_its_own_weight() {
    // (I + M R^2) theta'' = R (M g + w L) with L' = R theta': L + M g / w = (L0 + M g / w) cosh(sqrt(a w) t), a = R^2 / (I + M R^2).
    let mut moving = simulation(&falling(100.0, "", ""));
    moving.step(400).unwrap();
    let (w, weight) = (MASS_KG_PER_M * GRAVITY, 1000.0 * GRAVITY);
    let a = 0.25 / (300.0 + 250.0);
    let length = (20.0 + weight / w) * ((a * w).sqrt() * 2.0).cosh() - weight / w;
    // The weight is on the line to the drum's centre, which is longer than the rope by (R / L)^2 / 2.
    let slant = 0.5 * (0.5_f64 / 20.0).powi(2);
    let found = values(&mut moving, "rope_length")[0];
    assert!((found / length - 1.0).abs() < slant, "{found} {length}");
    // The drum holds w L more than the load feels, and both follow from their accelerations.
    let speed_up = a * (weight + w * found);
    let [last, first] = ["rope_tension", "rope_first_tension"].map(|name| values(&mut moving, name)[0]);
    assert!((last / (1000.0 * (GRAVITY - speed_up)) - 1.0).abs() < slant, "{last}");
    assert!(((first - last) / (w * found) - 1.0).abs() < 1e-9, "{first} {last}");
    assert!(values(&mut moving, "energy_error")[0].abs() < 1e-9 * weight * 20.0);
}

/// A hook of 100 kg at rest on an elastic rope from a deck at z = 2 over a sheave at z = 30 down to some z = -25.
fn over_a_sheave(rope: &str) -> String {
    format!(
        "version: 1
title: A hook below water
simulation: {{step_s: 0.01, duration_s: 10, begin_at_equilibrium: true}}
bodies:
  hook: {{mass_kg: 100, shape: {{point: {{}}}}, joint: {{prismatic: {{name: lift, position_m: [1, 0, -25], axis: [0, 0, 1]}}}}}}
forces:
  gravity: {{gravity: {{acceleration_m_s2: {GRAVITY}}}}}
  hoist:
    rope:
      path:
        - point: {{body: world, position_m: [-1, 0, 2]}}
        - sheave: {{body: world, position_m: [0, 0, 30], radius_m: 1, axis: [0, 1, 0]}}
        - point: {{body: hook}}
      mass_kg_per_m: {MASS_KG_PER_M}
      axial_stiffness_N: 1e7
{rope}"
    )
}

/// The tensions at both ends of that, and the height of the hook.
fn hanging(rope: &str) -> [f64; 3] {
    let mut still = simulation(&over_a_sheave(rope));
    let [first, last] = ["rope_first_tension", "rope_tension"].map(|name| values(&mut still, name)[0]);
    [first, last, still.state().q[0] - 25.0]
}

#[test]
fn the_tension_of_a_rope_differs_by_its_weight_per_height() {
    // The tension of a taut rope without friction changes by w per height: Irvine, Cable Structures, 1981, ch. 1. In sea water a
    // rope of 50 mm loses rho A. The line of centres to the hook is out of the vertical by 1 m in 55 m, 2e-4 of the tension, and a
    // strain of 5 kN over 10 MN thins the rope by 5e-4.
    let [first, last, height] = hanging("");
    let w = MASS_KG_PER_M * GRAVITY;
    assert!((last / (100.0 * GRAVITY) - 1.0).abs() < 1e-3, "{last}");
    assert!(((first - last) / (w * (2.0 - height)) - 1.0).abs() < 1e-3, "{first} {last}");
    let [first, last, height] = hanging("      diameter_m: 0.05\n");
    let displaced = 1025.0 * GRAVITY * std::f64::consts::PI * 0.025 * 0.025;
    assert!(((first - last) / (w * (2.0 - height) + displaced * height) - 1.0).abs() < 1e-3, "{first} {last}");
}

#[test]
fn a_rope_parts_where_its_weight_makes_its_tension_largest() {
    // The sheave at z = 30 sees 28 m more than the deck: 6.5 kN there, 3.7 kN at the deck, 1 kN at the hook.
    let [first, ..] = hanging("");
    let top = first + MASS_KG_PER_M * GRAVITY * 28.0;
    let of = |load: f64| {
        let text = over_a_sheave(&format!("      breaking_load_N: {load}\n"));
        read(&text, "hook.yaml", &[]).and_then(|scenario| scenario.setup())
    };
    assert!(of(top * 1.01).is_ok());
    let error = of(top * 0.99).expect_err("too much").to_string();
    assert!(error.contains("forces.hoist.rope.breaking_load_N") && error.contains("which it carries"), "{error}");
}

#[test]
fn a_level_rope_has_equal_tensions_at_both_ends() {
    // The mass of two loads beside a level rope of 10 m: each carries half of its weight, so that both fall as fast as free.
    let side = |name: &str, x: f64| {
        format!(
            "  {name}: {{mass_kg: 50, shape: {{point: {{}}}}, joint: {{prismatic: {{name: {name}_z, position_m: [{x}, 0, 5], axis: [0, 0, 1]}}}}}}\n"
        )
    };
    let text = format!(
        "version: 1
title: A level rope
simulation: {{step_s: 0.01, duration_s: 1}}
bodies:
{}{}forces:
  gravity: {{gravity: {{acceleration_m_s2: {GRAVITY}}}}}
  rope: {{rope: {{path: [{{point: {{body: left}}}}, {{point: {{body: right}}}}], mass_kg_per_m: {MASS_KG_PER_M}, axial_stiffness_N: 1e6}}}}
",
        side("left", 0.0),
        side("right", 10.0)
    );
    let mut both = simulation(&text);
    both.step(50).unwrap();
    // 50 kg of load and 50 kg of rope without inertia on each: 2 g.
    let fall = 0.5 * 2.0 * GRAVITY * 0.25;
    for height in &both.state().q {
        assert!((height + fall).abs() < 1e-12, "{height}");
    }
}

/// The crane of free space where it weighs, over water.
fn weighing(integrator: &str) -> String {
    let text = crane_in_space("")
        .replace("axial_stiffness_N", "mass_kg_per_m: 20\n      diameter_m: 0.1\n      axial_stiffness_N");
    let text =
        text.replace("forces:\n", &format!("forces:\n  gravity: {{gravity: {{acceleration_m_s2: {GRAVITY}}}}}\n"));
    text.replace("integrator: dormand_prince, step_s: 0.01", integrator)
}

#[test]
fn a_rope_with_weight_conserves_energy_through_slack_taut_and_the_water_line() {
    let layers = "radius_m: 0.3, layers: {turns_per_layer: 2, height_m: 0.03, innermost_radius_m: 0.2}";
    for drum in ["radius_m: 0.3", layers] {
        let text = weighing("integrator: dormand_prince, step_s: 0.01");
        let mut moving = simulation(&text.replace("joint: winch, radius_m: 0.3", &format!("joint: winch, {drum}")));
        moving.step(140).unwrap();
        let events: Vec<_> = moving.events().iter().map(|event| event.what.to_string()).collect();
        assert!(events.iter().any(|what| what == "comes taut"), "{events:?}");
        let [error, energy] = ["energy_error", "kinetic_energy"].map(|name| values(&mut moving, name)[0]);
        assert!(error.abs() < 1e-9 * energy, "{error:e} of {energy:e}");
    }
}

#[test]
fn a_rope_with_weight_on_a_drum_with_layers_has_exact_derivatives() {
    let layers = "joint: winch, radius_m: 0.3, layers: {turns_per_layer: 2, height_m: 0.03, innermost_radius_m: 0.2}";
    common::assert_linearised(&weighing("step_s: 0.001").replace("joint: winch, radius_m: 0.3", layers));
}

#[test]
fn the_torque_of_a_drum_decreases_with_the_remaining_layers() {
    // R = R0 - c theta, L = L0 + R0 theta - c theta^2 / 2, and of the energy of load and drum, without weight of the rope:
    // (I + M R^2) theta'^2 = 2 M g (L - L0).
    let layers = ", layers: {turns_per_layer: 4, height_m: 0.05, innermost_radius_m: 0.35}";
    let text = falling(100.0, layers, "").replace(&format!(", mass_kg_per_m: {MASS_KG_PER_M}"), "");
    let mut moving = simulation(&text);
    let c = 0.05 / (4.0 * std::f64::consts::TAU);
    for _ in 0..3 {
        moving.step(200).unwrap();
        let [angle, rate] = [moving.state().q[0], moving.state().v[0]];
        let radius = 0.5 - c * angle;
        let paid_out = 0.5 * angle - 0.5 * c * angle * angle;
        assert!((values(&mut moving, "rope_length")[0] - 20.0 - paid_out).abs() < 1e-9);
        let energy = 1000.0 * GRAVITY * paid_out;
        let kinetic = 0.5 * (300.0 + 1000.0 * radius * radius) * rate * rate;
        assert!((kinetic / energy - 1.0).abs() < 1e-9, "{kinetic} {energy}");
    }
}

#[test]
fn a_drum_reports_when_only_its_innermost_layer_remains() {
    // Two layers of 0.1 m and 4 turns: R falls to 0.4 m after 4 turns, from where it stays.
    let layers = ", layers: {turns_per_layer: 4, height_m: 0.1, innermost_radius_m: 0.4}";
    let mut moving = simulation(&falling(100.0, layers, ""));
    moving.step(1600).unwrap();
    let turned = 4.0 * std::f64::consts::TAU;
    let angle = moving.state().q[0];
    assert!(angle > turned + 1.0, "{angle}");
    let event = moving.events().iter().find(|event| event.what == "is paid out to the innermost layer of its drum");
    assert!(event.is_some());
    let length = 20.0 + 0.45 * turned + 0.4 * (angle - turned);
    assert!((values(&mut moving, "rope_length")[0] - length).abs() < 1e-9);
    let rate = values(&mut moving, "rope_pay_out_rate")[0];
    assert!((rate / (0.4 * moving.state().v[0]) - 1.0).abs() < 1e-12, "{rate}");
}

#[test]
fn a_rope_in_free_space_weighs_nothing() {
    let (error, _) =
        ledger(&crane_in_space("").replace("axial_stiffness_N", "mass_kg_per_m: 20\n      axial_stiffness_N"), 100);
    assert!(error < 1e-9, "{error:e}");
}

#[test]
fn layers_above_the_rope_and_a_rope_that_only_displaces_are_refused() {
    let refused = |drum: &str, rope: &str| {
        let text = falling(100.0, drum, rope);
        read(&text, "hoist.yaml", &[]).and_then(|scenario| scenario.setup()).expect_err("a mistake").to_string()
    };
    let layers = refused(", layers: {turns_per_layer: 4, height_m: 0.1, innermost_radius_m: 0.6}", "");
    let expected = "forces.hoist.rope.path.0.drum.layers.innermost_radius_m: found 0.6, allowed: at most radius_m: 0.5";
    assert!(layers.contains(expected), "{layers}");
    let text = falling(100.0, "", ", diameter_m: 0.05").replace(&format!("mass_kg_per_m: {MASS_KG_PER_M}, "), "");
    let error =
        read(&text, "hoist.yaml", &[]).and_then(|scenario| scenario.setup()).expect_err("a mistake").to_string();
    let expected = "forces.hoist.rope.mass_kg_per_m: found none, allowed: a mass for a rope with a diameter_m";
    assert!(error.contains(expected), "{error}");
}
