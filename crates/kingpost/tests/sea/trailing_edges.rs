//! Swimming fins: Lighthill's force at the trailing edge, and bodies that change their shape in an ideal
//! fluid.

use crate::common;

use common::{simulation, values};
use kingpost::Simulation;
use std::f64::consts::{FRAC_PI_4, PI, TAU};

const SPEED: f64 = 1.5;
const PERIOD: f64 = 0.8;
const CHORD_BEHIND: f64 = 0.12;
const SPAN: f64 = 0.3;
const PHASE: f64 = -1.9;
const SAMPLES: usize = 400;

/// A fin 5 m below the surface that heaves and pitches while a carriage tows it.
fn towed(heave: f64, pitch: f64) -> String {
    let ramp = 2.0 * PERIOD;
    format!(
        "
version: 1
title: A fin towed in still water
simulation: {{step_s: {step}, duration_s: 10}}
sea: {{density_kg_m3: 1000}}
bodies:
  carriage:
    mass_kg: 1
    shape: {{sphere: {{radius_m: 0.01}}}}
    joint: {{prismatic: {{axis: [1, 0, 0], position_m: [0, 0, -5], mode: {{prescribed: {{speed_m_s: {SPEED}}}}}}}}}
  slide:
    parent: carriage
    mass_kg: 1
    shape: {{sphere: {{radius_m: 0.01}}}}
    joint: {{prismatic: {{axis: [0, 1, 0], mode: {{oscillation: {{amplitude_m: {heave}, period_s: {PERIOD}, ramp_s: {ramp}}}}}}}}}
  fin:
    parent: slide
    mass_kg: 1
    shape: {{box: {{length_m: 0.2, width_m: 0.01, height_m: {SPAN}}}}}
    joint:
      revolute:
        axis: [0, 0, 1]
        mode: {{oscillation: {{amplitude_rad: {pitch}, period_s: {PERIOD}, phase_rad: {PHASE}, ramp_s: {ramp}}}}}
forces:
  gravity: {{gravity: {{}}}}
  fin_in_water:
    submerged:
      body: fin
      shape: {{box: {{length_m: 0.2, width_m: 0.01, height_m: {SPAN}}}}}
      added_mass: {{coefficients: [0, 12, 0], moments_kg_m2: [0, 0, 0.02]}}
  edge: {{trailing_edge: {{body: fin, position_m: [{back}, 0, 0], span_m: {SPAN}}}}}
",
        step = PERIOD / SAMPLES as f64,
        back = -CHORD_BEHIND,
    )
}

/// m.
fn mass_per_length() -> f64 {
    FRAC_PI_4 * 1000.0 * SPAN * SPAN
}

/// Mean thrust over one period of the steady oscillation: the reduction of the carriage's force, and the
/// force at the edge.
fn thrusts(text: &str) -> [f64; 2] {
    let mut simulation = simulation(text);
    simulation.step(3 * SAMPLES).unwrap();
    let mut means = [0.0; 2];
    for _ in 0..SAMPLES {
        simulation.step(1).unwrap();
        means[0] -= values(&mut simulation, "joint_force")[0] / SAMPLES as f64;
        means[1] += values(&mut simulation, "trailing_edge_force")[0] / SAMPLES as f64;
    }
    means
}

/// The mean over a period of `m w (w cos / 2 + u sin)`, by the motion of the edge. Sums over a period of a smooth
/// periodic function have no error beyond rounding.
fn mean_by_the_motion(heave: f64, pitch: f64) -> f64 {
    let omega = TAU / PERIOD;
    let force = |time: f64| {
        let (angle, rate) = (pitch * (omega * time + PHASE).sin(), pitch * omega * (omega * time + PHASE).cos());
        let (sin, cos) = angle.sin_cos();
        let x_rate = SPEED + CHORD_BEHIND * rate * sin;
        let y_rate = heave * omega * (omega * time).cos() - CHORD_BEHIND * rate * cos;
        let (along, across) = (x_rate * cos + y_rate * sin, y_rate * cos - x_rate * sin);
        mass_per_length() * across * (0.5 * across * cos + along * sin)
    };
    (0..SAMPLES).map(|k| force(PERIOD * k as f64 / SAMPLES as f64)).sum::<f64>() / SAMPLES as f64
}

#[test]
fn a_towed_fin_has_lighthills_mean_thrust() {
    // Large: Lighthill, Proc. R. Soc. Lond. B 179 (1971), p. 125. The mean of the added mass' force is zero.
    for (heave, pitch) in [(0.1, 0.35), (0.2, 0.1), (0.05, 0.6)] {
        let [carriage, edge] = thrusts(&towed(heave, pitch));
        let expected = mean_by_the_motion(heave, pitch);
        // Positions follow from the rates by RK4, whose error is (w h)^4 / 2880 = 2e-11 of the amplitude in each step.
        assert!((edge - expected).abs() < 1e-7 * edge.abs(), "{edge} N for {expected} N");
        assert!((carriage - expected).abs() < 1e-7 * edge.abs(), "{carriage} N for {expected} N");
    }
    // Small: 1/2 m (<(dh/dt)^2> - U^2 <(dh/dx)^2>) at the edge (Lighthill, J. Fluid Mech. 9 (1960), p. 305), with an
    // error of the amplitude squared.
    let omega = TAU / PERIOD;
    for share in [0.1, 0.05] {
        let (heave, pitch) = (0.1 * share, 0.35 * share);
        let in_phase = CHORD_BEHIND * pitch * PHASE.cos();
        let off = CHORD_BEHIND * pitch * PHASE.sin();
        let rate_squared = 0.5 * omega * omega * ((heave - in_phase).powi(2) + off * off);
        let expected = 0.5 * mass_per_length() * (rate_squared - 0.5 * SPEED * SPEED * pitch * pitch);
        let [_, edge] = thrusts(&towed(heave, pitch));
        assert!((edge / expected - 1.0).abs() < share * share, "{edge} N for {expected} N");
    }
}

#[test]
fn a_fin_in_a_current_has_the_force_of_a_towed_fin() {
    let text = towed(0.1, 0.35);
    let held = text
        .replace(&format!("speed_m_s: {SPEED}"), "speed_m_s: 0")
        .replace("density_kg_m3: 1000", &format!("density_kg_m3: 1000, current_m_s: [-{SPEED}, 0]"));
    assert_ne!(text, held);
    let ([_, towed], [_, held]) = (thrusts(&text), thrusts(&held));
    assert!((towed - held).abs() < 1e-10 * towed.abs(), "{towed} N and {held} N");
}

#[test]
fn a_trailing_edge_acts_with_the_submerged_share_of_its_span() {
    let thrust_at = |depth: f64| {
        let text = towed(0.1, 0.35).replace("position_m: [0, 0, -5]", &format!("position_m: [0, 0, {}]", -depth));
        thrusts(&text)[1]
    };
    let whole = thrust_at(5.0);
    for (depth, share) in [(0.16, 1.0), (0.075, 0.75), (0.0, 0.5), (-0.075, 0.25), (-0.16, 0.0)] {
        assert!((thrust_at(depth) - share * share * whole).abs() < 1e-9 * whole, "at a depth of {depth} m");
    }
}

/// Links of 0.4 m that turn about upright axes, without weight in the water. The added mass of an ellipse of the same
/// length: [`PI`] rho a^2 across, PI rho b^2 along, PI rho (a^2 - b^2)^2 / 8 about its centre, for a height of 0.2 m.
fn links(joints: &[&str], edge: &str) -> String {
    let (a, b, height) = (0.2, 0.04, 0.2);
    let mass = 1000.0 * PI * a * b * height;
    let shape = format!("{{box: {{length_m: 0.4, width_m: {}, height_m: {height}}}}}", 0.25 * PI * 2.0 * b);
    let along = b / a;
    let moment = 1000.0 * PI * (a * a - b * b).powi(2) / 8.0 * height;
    let mut bodies = format!(
        "  link0:
    mass_kg: {mass}
    shape: {shape}
    joint: {{floating: {{initial: {{position_m: [0, 0, -5]}}}}}}\n"
    );
    let mut forces = String::from("  gravity: {gravity: {}}\n");
    for (k, mode) in joints.iter().enumerate() {
        bodies += &format!(
            "  link{}:
    parent: link{k}
    mass_kg: {mass}
    shape: {shape}
    joint: {{revolute: {{axis: [0, 0, 1], position_m: [-0.22, 0, 0], child_position_m: [0.22, 0, 0], mode: {mode}}}}}\n",
            k + 1
        );
    }
    for k in 0..=joints.len() {
        forces += &format!(
            "  water{k}:
    submerged:
      body: link{k}
      shape: {shape}
      added_mass: {{coefficients: [{along}, {}, 0], moments_kg_m2: [0, 0, {moment}]}}\n",
            a / b
        );
    }
    format!(
        "
version: 1
title: Links in an ideal fluid
simulation: {{step_s: 0.005, duration_s: 20}}
sea: {{density_kg_m3: 1000}}
bodies:
{bodies}forces:
{forces}{edge}"
    )
}

fn swing(amplitude: f64, phase: f64) -> String {
    format!("{{oscillation: {{amplitude_rad: {amplitude}, period_s: 1, phase_rad: {phase}, ramp_s: 2}}}}")
}

fn place(simulation: &Simulation) -> [f64; 2] {
    [simulation.state().q[0], simulation.state().q[1]]
}

#[test]
fn one_hinge_does_not_swim_in_an_ideal_fluid_but_two_do() {
    // The scallop theorem holds without vorticity as well: Kanso, Marsden, Rowley & Melli-Huber, "Locomotion of
    // articulated bodies in a perfect fluid", J. Nonlinear Sci. 15 (2005), p. 255.
    let drift = |joints: &[&str]| {
        let mut simulation = simulation(&links(joints, ""));
        simulation.step(600).unwrap();
        let before = place(&simulation);
        simulation.step(400).unwrap();
        let after = place(&simulation);
        let error = values(&mut simulation, "energy_error")[0].abs() / values(&mut simulation, "energy_scale")[0];
        assert!(error < 1e-6, "energy off balance by {error:e}");
        (after[0] - before[0]).hypot(after[1] - before[1])
    };
    let scallop = drift(&[&swing(1.0, 0.0)]);
    let eel = drift(&[&swing(1.0, 0.0), &swing(1.0, 1.6)]);
    // RK4 with w h = 0.03: (w h)^4 = 1e-6 of a swing of 0.1 m, in each stroke.
    assert!(scallop < 1e-6, "{scallop} m in two strokes");
    assert!(eel > 0.05, "{eel} m in two strokes");
}

#[test]
fn a_swimmer_with_an_edge_leaves_energy_in_its_wake_and_the_balance_closes() {
    let edge = "  edge: {trailing_edge: {body: link2, position_m: [-0.2, 0, 0], span_m: 0.2}}\n";
    let mut swimmer = simulation(&links(&[&swing(0.3, 0.0), &swing(0.5, -1.2)], edge));
    swimmer.step(4000).unwrap();
    assert!(place(&swimmer)[0] > 3.0, "it swims forward: {:?}", place(&swimmer));
    let [error, scale, wake] = ["energy_error", "energy_scale", "wake_power"].map(|name| values(&mut swimmer, name)[0]);
    assert!(error.abs() < 1e-5 * scale, "energy off balance by {error} J of {scale} J");
    assert!(wake >= 0.0, "{wake} W");
    assert!(values(&mut swimmer, "energy_dissipated")[0] > 0.1 * scale);
}

#[test]
fn the_linear_model_of_a_swimmer_has_the_exact_derivatives_of_its_edge() {
    let edge = "  edge: {trailing_edge: {body: link2, position_m: [-0.2, 0, 0], span_m: 0.2}}\n";
    common::assert_linearised(&links(&["{prescribed: {rate_rad_s: 0.7}}", "free"], edge));
}
