//! Lines that are paid out: closed forms, and conservation of energy.

use crate::common::values;
use kingpost::scenario::read;
use kingpost::simulation::{Setup, Simulation};

const G: f64 = 9.80665;
const MASS_PER_LENGTH: f64 = 30.0;

/// A load on a wire in air, below a drum in the world that is free or turns at a given rate.
struct Hoist {
    length: f64,
    load_kg: f64,
    axial_stiffness: f64,
    damping_time: f64,
    elements: usize,
    step_s: f64,
    /// Fields of the drum's joint.
    joint: &'static str,
    /// Stations between the drum, which is at the origin, and the load.
    between: &'static str,
    /// Horizontal distance of the load.
    across: f64,
}

impl Hoist {
    const FREE: &str = "rotor_inertia_kg_m2: 20000, gear_ratio: 1";

    fn simulation(&self, scheme: &str) -> Simulation {
        let Self { length, load_kg, axial_stiffness, damping_time, elements, step_s, joint, between, across } = self;
        let carried = load_kg + 0.5 * MASS_PER_LENGTH * length;
        let height = -length * (1.0 + carried * G / axial_stiffness);
        let text = format!(
            "version: 1
title: A load is lowered on a wire with mass
simulation: {{step_s: {step_s}, duration_s: 1, record_every_s: {step_s}, {scheme}}}
bodies:
  drum:
    mass_kg: 1
    shape: {{point: {{}}}}
    joint: {{revolute: {{name: winch, axis: [0, 1, 0], {joint}}}}}
  load:
    mass_kg: {load_kg}
    shape: {{point: {{}}}}
    joint: {{prismatic: {{name: lift, axis: [0, 0, 1], position_m: [{across}, 0, {height}]}}}}
forces:
  gravity: {{gravity: {{}}}}
  wire:
    line:
      path:
        - drum: {{joint: winch, radius_m: 1}}
        {between}
        - point: {{body: load}}
      sections:
        - unstretched_length_m: {length}
          elements: {elements}
          mass_kg_per_m: {MASS_PER_LENGTH}
          diameter_m: 1.0e-9
          axial_stiffness_N: {axial_stiffness}
          damping_time_s: {damping_time}
"
        );
        let setup: Setup = read(&text, "hoist.yaml", &[]).expect("it reads").setup().expect("it builds");
        Simulation::new(setup)
    }
}

#[test]
fn a_load_that_unwinds_its_drum_falls_by_its_energy() {
    let hoist = Hoist {
        length: 100.0,
        load_kg: 20e3,
        axial_stiffness: 8e8,
        damping_time: 0.02,
        elements: 4,
        step_s: 0.005,
        joint: Hoist::FREE,
        between: "",
        across: 0.0,
    };
    let mut run = hoist.simulation("integrator: rk4");
    for _ in 0..6 {
        run.step(200).expect("it does not diverge");
        let [length, rate] = ["line_length", "line_pay_out_rate"].map(|name| values(&mut run, name)[0]);
        // The drum turns with J / R^2 = 20 t; the wire on it is not counted in its inertia. Rigid wire:
        // (J / R^2 + M + mu L) L'^2 / 2 = M g (L - L0) + mu g (L^2 - L0^2) / 2.
        let fallen = 20e3 * (length - 100.0) + 0.5 * MASS_PER_LENGTH * (length * length - 1e4);
        let expected = (2.0 * G * fallen / (40e3 + MASS_PER_LENGTH * length)).sqrt();
        // The wire's stretch, 0.03 m, changes as the load is released: 1.3 % of the first metre, less than 1e-3 after ten.
        let tolerance = 0.01 / (length - 100.0).min(10.0);
        assert!((rate / expected - 1.0).abs() < tolerance, "{length} m: {rate} m/s, {expected} by the rigid wire");
        let [error, scale] = ["energy_error", "energy_scale"].map(|name| values(&mut run, name)[0]);
        assert!(error.abs() < 1e-5 * scale, "{error} of {scale} J");
    }
}

/// A load that is lowered at 0.5 m/s, 0.8 MN on a wire that stretches by 1 m.
const LOWERED: Hoist = Hoist {
    length: 800.0,
    load_kg: 60e3,
    axial_stiffness: 8e8,
    damping_time: 0.02,
    elements: 6,
    step_s: 0.05,
    joint: "mode: {prescribed: {rate_rad_s: 0.5, history: pulse, pulse: {rise_s: 10, hold_s: 60}}}",
    between: "",
    across: 0.0,
};

#[test]
fn a_lowered_load_hangs_where_the_longer_wire_holds_it() {
    let mut run = LOWERED.simulation("integrator: rk4");
    run.step(2400).expect("it does not diverge");
    let [length, rate, tension] =
        ["line_length", "line_pay_out_rate", "line_tension"].map(|name| values(&mut run, name)[0]);
    assert!(rate.abs() < 1e-12 && (length - 835.0).abs() < 1e-9, "{length} {rate}");
    let stretched = length * (1.0 + (60e3 + 0.5 * MASS_PER_LENGTH * length) * G / 8e8);
    let moved = values(&mut run, "joint_position")[1];
    let at_start = 800.0 * (1.0 + (60e3 + 0.5 * MASS_PER_LENGTH * 800.0) * G / 8e8);
    assert!((moved - at_start + stretched).abs() < 1e-3, "{moved}");
    let expected = (60e3 + MASS_PER_LENGTH * length) * G;
    assert!((tension / expected - 1.0).abs() < 1e-4, "{tension} {expected}");
}

#[test]
fn energy_closes_while_a_wire_is_paid_out_under_tension() {
    let error = |step_s: f64, scheme: &str| {
        let mut run = Hoist { step_s, ..LOWERED }.simulation(scheme);
        let mut worst: f64 = 0.0;
        for _ in 0..9 {
            run.step((10.0 / step_s).round() as usize).expect("it does not diverge");
            let [error, scale] = ["energy_error", "energy_scale"].map(|name| values(&mut run, name)[0]);
            worst = worst.max(error.abs() / scale);
        }
        worst
    };
    // The equations of the nodes conserve energy; what is left is rounding.
    let coupled = error(0.05, "integrator: rk4");
    assert!(coupled < 1e-7, "{coupled}");
    let exact = error(
        0.05,
        "integrator: dormand_prince, dormand_prince: {absolute_tolerance: 1e-9, relative_tolerance: 1e-9, largest_step_s: 0.05}",
    );
    assert!(exact < 1e-9, "{exact}");
}

#[test]
fn friction_at_a_sheave_takes_its_share_of_the_work() {
    let over_sheave = Hoist {
        joint: "position_m: [-20, 0, -5], mode: {prescribed: {rate_rad_s: 0.5, history: pulse, pulse: {rise_s: 10, hold_s: 60}}}",
        between: "- sheave: {body: world, radius_m: 0.5, axis: [0, 1, 0], efficiency_hoisting: 0.95, efficiency_lowering: 0.95}",
        ..LOWERED
    };
    let mut run = over_sheave.simulation("integrator: rk4");
    let mut at = |steps: usize| {
        run.step(steps).expect("it does not diverge");
        ["line_tension", "line_length", "energy_dissipated", "work_by_drives", "energy_error", "energy_scale"]
            .map(|name| values(&mut run, name)[0])
    };
    let [[tension, length, heat, work, ..], [later_tension, later, heated, worked, error, scale]] = [at(400), at(800)];
    // A twentieth of the work of the mean tension; the weight of the wire that comes up from the drum by 5 m is not lost.
    let drawn = 0.5 * (tension + later_tension) - MASS_PER_LENGTH * 5.0 * G;
    let lost = 0.05 * drawn * (later - length);
    assert!(((heated - heat) / lost - 1.0).abs() < 1e-3, "{} {lost}", heated - heat);
    let held = -0.95 * drawn * (later - length);
    assert!(((worked - work) / held - 1.0).abs() < 1e-3, "{} {held}", worked - work);
    assert!(error.abs() < 1e-7 * scale, "{error} {scale}");
}
