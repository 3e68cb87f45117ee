//! Motions of lifted objects in the water: closed forms, energy and momentum, both forms of the equations,
//! the order of a scheme.

use crate::common;

use common::splash::{BOX, DENSITY, GRAVITY, Wave, lowered};
use common::{simulation, values};
use kingpost::analysis::Linearizer;
use kingpost::scenario::read;
use std::f64::consts::PI;

#[test]
fn a_sinking_body_reaches_its_terminal_speed() {
    let text = lowered(
        "axis: [0, 0, 1], position_m: [0, 0, -10]",
        "",
        "shape: {sphere: {radius_m: 1}}, added_mass: {coefficients: [0.5, 0.5, 0.5]}, drag: {coefficients: [0.5, 0.5, 0.5]}",
        "step_s: 0.05, duration_s: 60",
    );
    let mut load = simulation(&text);
    load.step(1200).unwrap();
    let weight = 20000.0 - DENSITY * PI * 4.0 / 3.0;
    let exact = (2.0 * weight * GRAVITY / (DENSITY * 0.5 * PI)).sqrt();
    assert!((load.state().v[0] + exact).abs() < 1e-9 * exact, "{} {exact}", load.state().v[0]);
}

#[test]
fn a_floating_body_heaves_with_the_period_of_its_waterplane_and_added_mass() {
    let mass = 0.6 * DENSITY * 24.0;
    let text = lowered(
        "axis: [0, 0, 1]",
        &Wave::new(1.0, 8.0, 0.0).sea(),
        &format!("shape: {BOX}, added_mass: {{coefficients: [0, 0, 0.8]}}"),
        "step_s: 0.01, duration_s: 1, begin_at_equilibrium: true",
    )
    .replace("20000", &mass.to_string());
    let scenario = read(&text, "test.yaml", &[]).unwrap();
    let load = scenario.simulation().unwrap();
    // At rest there are no waves: 0.6 of it is under water.
    assert!((load.state().q[0] + 0.2).abs() < 1e-9, "{:?}", load.state().q);
    let linear = Linearizer::new(&scenario).unwrap().at_rest().at(&load);
    let exact = -DENSITY * GRAVITY * 12.0 / (mass + DENSITY * 0.6 * 0.8 * 24.0);
    let found = linear.stiffness()[(0, 0)];
    assert!((found / exact - 1.0).abs() < 1e-7, "{found} {exact}");
}

#[test]
fn a_deep_neutrally_buoyant_body_follows_the_orbit_of_the_water() {
    let (wave, radius, depth) = (Wave::new(0.1, 8.0, 0.0), 0.5_f64, 6.0);
    let decay = (-wave.number * depth).exp();
    let (orbit, mass) = (wave.amplitude * decay, DENSITY * PI * 4.0 / 3.0 * radius.powi(3));
    let [ux, uz, ..] = wave.water(0.0, -depth);
    let text = format!(
        "version: 1
title: A body in a deep orbit
simulation: {{step_s: 0.02, duration_s: 8}}
sea: {{{}}}
bodies:
  load:
    mass_kg: {mass}
    shape: {{sphere: {{radius_m: 0.5}}}}
    joint: {{floating: {{initial: {{position_m: [0, 0, {}], velocity_m_s: [{ux}, 0, {uz}]}}}}}}
forces:
  gravity: {{gravity: {{}}}}
  water: {{submerged: {{body: load, shape: {{sphere: {{radius_m: 0.5}}}}, added_mass: {{coefficients: [0.5, 0.5, 0.5]}}}}}}
",
        wave.sea(),
        -depth + orbit
    );
    let mut load = simulation(&text);
    let mut worst: f64 = 0.0;
    for _ in 0..40 {
        load.step(10).unwrap();
        // Of the centre (0, -depth): along x -sin, along z cos of k x - w t.
        let (sin, cos) = wave.angle(load.time_s());
        let [x, _, z] = [load.state().q[0] + orbit * sin, 0.0, load.state().q[2] + depth - orbit * cos];
        worst = worst.max(x.hypot(z));
    }
    // Of second order over one period: Stokes' drift, k w r^2 t, and the convective acceleration k w^2 r^2 of the water,
    // which the local acceleration leaves out, times t^2 / 2.
    let second_order = (2.0 * PI + 2.0 * PI * PI) * wave.number * orbit;
    assert!(worst < second_order * orbit, "{} of {}", worst / orbit, second_order);
}

/// A body thrown into waves and current, with rotation.
fn thrown(scheme: &str, step: f64) -> String {
    format!(
        "version: 1
title: A body that is thrown into the sea
simulation: {{integrator: {scheme}, step_s: {step}, duration_s: 6,
  dormand_prince: {{absolute_tolerance: 1e-11, relative_tolerance: 1e-11, largest_step_s: 0.02}}}}
sea: {{waves: {{one: {{regular: {{height_m: 1, period_s: 6, direction_rad: 0.5}}}}, two: {{regular: {{height_m: 0.6, period_s: 4, direction_rad: 2}}}}}}, ramp_s: 3, current_m_s: [0.3, 0.2]}}
wind: {{speed_m_s: 12, direction_rad: 1}}
bodies:
  load:
    mass_kg: 20000
    centre_of_mass_m: [0.1, 0, -0.3]
    inertia: {{tensor: {{moments_kg_m2: [21000, 33000, 41000]}}}}
    joint: {{floating: {{initial: {{position_m: [0, 0, 1.9], orientation_rad: [0.2, 0.3, 0.1], velocity_m_s: [0.5, 0, -1], angular_velocity_rad_s: [0.2, 0.1, 0.3]}}}}}}
forces:
  gravity: {{gravity: {{}}}}
  water:
    submerged:
      body: load
      position_m: [0, 0, 0]
      shape: {BOX}
      added_mass: {{coefficients: [0.4, 0.6, 0.9], moments_kg_m2: [6000, 9000, 3000], growth: {{shares: [0, 0.3, 1], factors: [0, 0.6, 1]}}}}
      drag: {{coefficients: [1.1, 1.3, 1.8], linear_N_s_m: [500, 400, 300]}}
      wind: {{coefficients: [1, 1.1, 1]}}
"
    )
}

#[test]
fn energy_and_momentum_are_kept_by_work_and_heat() {
    let by_share = thrown("dormand_prince", 0.02);
    let by_depth = by_share.replace("shares: [0, 0.3, 1]", "depths_m: [0, 0.6, 2]");
    let by_coefficient = by_share.replace("      drag:", "      slamming: {coefficient: 4.5}\n      drag:");
    for text in [by_share, by_depth, by_coefficient] {
        let mut load = simulation(&text);
        load.step(250).unwrap_or_else(|error| panic!("{error}: {text}"));
        let scale = values(&mut load, "energy_dissipated")[0];
        let error = values(&mut load, "energy_error")[0];
        assert!(scale > 1e4 && error.abs() < 1e-7 * scale, "{error:e} of {scale:e}");
        for name in ["linear_momentum_error", "momentum_error"] {
            let error = values(&mut load, name)[0];
            assert!(error < 1e-7 * 20000.0, "{name}: {error:e}");
        }
        assert!(load.events().iter().any(|event| event.what == "meets the water"), "{:?}", load.events());
    }
}

#[test]
fn the_water_only_takes_energy_from_a_bobbing_body() {
    let text = lowered(
        "axis: [0, 0, 1], position_m: [0, 0, -4]",
        "",
        &format!("shape: {BOX}, added_mass: {{coefficients: [0, 0, 0.9]}}"),
        "step_s: 0.01, duration_s: 30",
    )
    .replace("20000", "4000");
    let mut load = simulation(&text);
    let mut before = f64::INFINITY;
    for _ in 0..1500 {
        load.step(1).unwrap();
        let energy = values(&mut load, "kinetic_energy")[0] + values(&mut load, "potential_energy")[0];
        let (rate, added) = (load.state().v[0], values(&mut load, "submerged_added_mass")[2]);
        let whole = energy + 0.5 * added * rate * rate;
        assert!(whole < before + 1e-5 * 4000.0, "{whole} after {before}");
        assert!(rate < 0.0 || values(&mut load, "submerged_slamming")[2] == 0.0);
        before = whole;
    }
    let count = |what: &str| load.events().iter().filter(|event| event.what == what).count();
    assert!(count("leaves the water") > 0 && count("meets the water") > 0, "{:?}", load.events());
}

#[test]
fn matrices_and_recursion_give_a_submerged_body_the_same_motion() {
    let run = |form: &str| {
        let text = thrown("rk4", 0.02).replace("integrator: rk4", &format!("integrator: rk4, form: {form}"));
        let mut load = simulation(&text);
        load.step(150).unwrap();
        load.state().q.clone()
    };
    let apart = common::relative_difference(&run("recursive"), &run("moving_frame"));
    assert!(apart < 1e-10, "{apart:e}");
}

#[test]
fn a_submerged_body_has_exact_derivatives_in_waves() {
    common::assert_linearised(&thrown("rk4", 0.01));
}

#[test]
fn the_order_of_the_scheme_is_kept_through_the_surface() {
    // A box falls flat into still water: its added mass grows at once.
    let end = |step: f64| {
        let text = lowered(
            "axis: [0, 0, 1], position_m: [0, 0, 1.237]",
            "",
            &format!("shape: {BOX}, added_mass: {{coefficients: [0, 0, 0.9]}}, drag: {{coefficients: [1, 1, 1.8]}}"),
            &format!("integrator: rk4, step_s: {step}, duration_s: 3"),
        )
        .replace("20000", "26000");
        let mut load = simulation(&text);
        load.step((2.4 / step).round() as usize).unwrap();
        (load.state().q[0], load.events().len())
    };
    let (exact, events) = end(0.0025);
    assert!(events >= 2, "{events}");
    let [coarse, fine] = [0.04, 0.02].map(|step| (end(step).0 - exact).abs());
    assert!(coarse / fine > 11.0, "{coarse:e} {fine:e}");
}

#[test]
fn a_current_carries_a_body_along_and_the_slip_becomes_heat() {
    let text = lowered(
        "axis: [1, 0, 0], position_m: [0, 0, -6]",
        "current_m_s: [0.8, 0]",
        &format!("shape: {BOX}, added_mass: {{coefficients: [0.6, 0, 0]}}, drag: {{linear_N_s_m: [900, 0, 0]}}"),
        "step_s: 0.05, duration_s: 60",
    );
    let mut load = simulation(&text);
    load.step(600).unwrap();
    // (m + A) v' = c (u - v) from rest.
    let time = (20000.0 + DENSITY * 0.6 * 24.0) / 900.0;
    let speed = 0.8 * (1.0 - (-30.0_f64 / time).exp());
    assert!((load.state().v[0] - speed).abs() < 1e-8, "{} {speed}", load.state().v[0]);
    // Heat is the integral of c (u - v)^2.
    let heat = 900.0 * 0.64 * time / 2.0 * (1.0 - (-60.0_f64 / time).exp());
    assert!((values(&mut load, "energy_dissipated")[0] / heat - 1.0).abs() < 1e-8);
}
