//! Hydraulic cylinders: against statics, at their limits, along levers, and in the ledger.

use crate::common;

use common::{simulation, values};
use kingpost::scenario::read;

const GRAVITY: f64 = 9.80665;

/// A level boom of 4 m and 100 kg on a hinge at the origin, held from below by a cylinder whose pins
/// stand 3 m under the hinge and at the boom's tip: 5 m apart at the start.
fn boom(cylinder: &str) -> String {
    format!(
        "
version: 1
title: A boom on a cylinder
simulation: {{step_s: 0.001, duration_s: 4}}
bodies:
  boom: {{mass_kg: 100, shape: {{box: {{length_m: 4, width_m: 0.5, height_m: 0.5}}}}, joint: {{revolute: {{axis: [0, -1, 0], child_position_m: [-2, 0, 0]}}}}}}
drives:
  luffing:
    cylinder:
      first: {{body: world, position_m: [0, 0, -3]}}
      second: {{body: boom, position_m: [2, 0, 0]}}
      shortest_m: 4.5
      longest_m: 5.6
      stiffness_N_per_m: 200000
      damping_N_s_per_m: 8000
      push_limit_N: 3000
      pull_limit_N: 3000
      speed_limit_m_s: 0.1
      {cylinder}
forces: {{gravity: {{gravity: {{}}}}}}
"
    )
}

fn reading(simulation: &mut kingpost::Simulation) -> [f64; 3] {
    ["cylinder_length", "cylinder_rate", "cylinder_force"].map(|variable| values(simulation, variable)[0])
}

/// Returns energy and both momenta, relative to the work and impulse of the weight in a second.
fn assert_ledger_closes(simulation: &mut kingpost::Simulation) {
    for error in ["energy_error", "momentum_error", "linear_momentum_error"] {
        let value = values(simulation, error)[0];
        assert!(value.abs() < 1e-6 * 100.0 * GRAVITY, "{error}: {value:e}");
    }
}

#[test]
fn a_cylinder_that_holds_a_boom_carries_the_static_force() {
    // Moments about the hinge: F times its lever is the weight times 2 m cos(angle); at rest the
    // spring has given way by F / k.
    for form in ["recursive", "moving_frame"] {
        let mut simulation = simulation(&boom("target: hold").replace("{step_s", &format!("{{form: {form}, step_s")));
        simulation.step(4000).unwrap();
        let ([length, rate, force], angle) = (reading(&mut simulation), simulation.state().q[0]);
        let lever = 3.0 * 4.0 * angle.cos() / length;
        assert!((force * lever - 100.0 * GRAVITY * 2.0 * angle.cos()).abs() < 1e-6 * force, "{force} N");
        assert!((5.0 - length - force / 2e5).abs() < 1e-9 && rate.abs() < 1e-9, "{length} m, {rate} m/s");
        assert_ledger_closes(&mut simulation);
    }
}

#[test]
fn a_cylinder_reaches_its_length_at_its_speed_limit() {
    let mut simulation = simulation(&boom("target: {length: {length_m: 5.2}}"));
    let mut fastest = 0.0_f64;
    for _ in 0..40 {
        simulation.step(50).unwrap();
        fastest = fastest.max(reading(&mut simulation)[1]);
    }
    // 0.2 m at 0.1 m/s take two seconds; on its way it lags by the weight and the damping over k.
    let [length, ..] = reading(&mut simulation);
    assert!((5.2 - length) < 0.1 * 8e3 / 2e5 + 3000.0 / 2e5 && length < 5.2, "{length} m after 2 s");
    assert!(fastest < 0.12, "{fastest} m/s");
    simulation.step(2000).unwrap();
    let [length, rate, force] = reading(&mut simulation);
    assert!((5.2 - length - force / 2e5).abs() < 1e-8 && rate.abs() < 1e-8, "{length} m, {rate} m/s");
    assert_eq!(values(&mut simulation, "cylinder_effort_utilisation"), [force / 3000.0]);
    assert_ledger_closes(&mut simulation);
}

#[test]
fn a_cylinder_too_weak_for_its_load_yields_to_its_stop() {
    // 817 N would hold the boom; 500 N do not. The stop carries the rest; friction in the hinge
    // brings the boom to rest on it.
    let weak = boom("target: hold\n      stop_stiffness_N_per_m: 1000000")
        .replace("push_limit_N: 3000", "push_limit_N: 500")
        .replace("axis: [0, -1, 0]", "axis: [0, -1, 0], damping_N_m_s: 5000");
    let mut simulation = simulation(&weak);
    simulation.step(300).unwrap();
    assert!((reading(&mut simulation)[2] - 500.0).abs() < 1e-9, "clipped while it sinks");
    assert_eq!(values(&mut simulation, "cylinder_effort_utilisation"), [1.0]);
    simulation.step(7700).unwrap();
    let ([length, _, force], angle) = (reading(&mut simulation), simulation.state().q[0]);
    assert!((4.5 - length - (force - 500.0) / 1e6).abs() < 1e-9, "{length} m, {force} N");
    let lever = 12.0 * angle.cos() / length;
    assert!((force * lever - 200.0 * GRAVITY * angle.cos()).abs() < 1e-5 * force * lever, "{force} N");
    // Contact begins within a step, at some 0.3 m/s: what the step misses of it is k (v h)^2 / 2.
    let error = values(&mut simulation, "energy_error")[0];
    assert!(error.abs() < 0.05, "{error} J");
}

#[test]
fn a_lever_changes_the_target_length_within_the_stroke() {
    let mut simulation = simulation(&boom("target: lever"));
    simulation.step(500).unwrap();
    let [rest, ..] = reading(&mut simulation);
    simulation.set_input("luffing", 0.5).unwrap();
    simulation.step(2000).unwrap();
    simulation.set_input("luffing", 0.0).unwrap();
    simulation.step(1500).unwrap();
    let [length, rate, _] = reading(&mut simulation);
    // Two seconds at half of 0.1 m/s; the weight's share changes a little with the angle.
    assert!((length - rest - 0.1).abs() < 1e-3 && rate.abs() < 1e-6, "{rest} m to {length} m");
    assert_ledger_closes(&mut simulation);
    // All the way out, it stops at the end of the stroke.
    simulation.set_input("luffing", 1.0).unwrap();
    simulation.step(8000).unwrap();
    assert!((simulation.state().s.last().unwrap() - 5.6).abs() < 1e-3, "{:?}", simulation.state().s.last());
}

#[test]
fn a_cylinder_between_two_free_bodies_changes_no_momentum() {
    let text = "
version: 1
title: Two pontoons and a cylinder
simulation: {step_s: 0.001}
bodies:
  one: {mass_kg: 100, shape: {box: {length_m: 4, width_m: 1, height_m: 1}}, joint: {floating: {}}}
  two: {mass_kg: 300, shape: {box: {length_m: 4, width_m: 1, height_m: 1}}, joint: {floating: {initial: {position_m: [1, 4, 0.5]}}}}
drives:
  ram:
    cylinder:
      first: {body: one, position_m: [2, 0.5, 0]}
      second: {body: two, position_m: [-1, -0.5, 0]}
      shortest_m: 1
      longest_m: 9
      target: {length: {length_m: 6}}
      speed_limit_m_s: 0.5
      push_limit_N: 1000
      pull_limit_N: 1000
      stiffness_N_per_m: 5000
      damping_N_s_per_m: 800
";
    let mut simulation = simulation(text);
    simulation.step(3000).unwrap();
    assert!(values(&mut simulation, "kinetic_energy")[0] > 1.0);
    for momentum in ["linear_momentum", "angular_momentum"] {
        assert!(values(&mut simulation, momentum).iter().all(|p| p.abs() < 1e-9), "{momentum}");
    }
    assert_ledger_closes(&mut simulation);
}

#[test]
fn an_invalid_cylinder_is_refused() {
    let error = |text: &str| read(text, "test.yaml", &[]).map(drop).expect_err("refused").to_string();
    let text = boom("target: hold");
    let outside = error(&text.replace("longest_m: 5.6", "longest_m: 4.8"));
    assert!(outside.contains("drives.luffing.cylinder: found pins 5.0000 m apart at the start, allowed: a length within the stroke, 4.5 to 4.8 m"), "{outside}");
    let together = error(&text.replace("position_m: [2, 0, 0]", "position_m: [-2, 0, -3]"));
    assert!(together.contains("found pins 0.0000 m apart"), "{together}");
    let turned = error(&text.replace("longest_m: 5.6", "longest_m: 4.4"));
    assert!(turned.contains("longest_m: found 4.4, allowed: more than shortest_m, 4.5"), "{turned}");
    let target = error(&boom("target: {length: {length_m: 6}}"));
    assert!(
        target.contains("target.length.length_m: found 6, allowed: a length within the stroke, 4.5 to 5.6"),
        "{target}"
    );
    let body = error(&text.replace("body: boom", "body: bom"));
    assert!(body.contains("drives.luffing.cylinder.second.body: found bom"), "{body}");
}
