//! Gas springs of sliding joints, against the thermodynamics of an ideal gas.

use crate::common;

use common::{simulation, values};
use kingpost::Simulation;
use kingpost::scenario::read;
use serde_json::json;
use std::f64::consts::TAU;

const MASS: f64 = 500.0;
const AREA: f64 = 0.02;
const VOLUME: f64 = 0.03;
const PRESSURE: f64 = 6e5;
const ATMOSPHERE: f64 = 101_325.0;

/// A piston of 500 kg on a level slide before 30 l of gas of 6 bar.
fn piston(exponent: f64, more: &str) -> String {
    format!(
        "
version: 1
title: A piston before gas
simulation: {{step_s: 0.0005, duration_s: 4}}
bodies:
  piston:
    mass_kg: {MASS}
    shape: {{box: {{length_m: 1, width_m: 0.2, height_m: 0.2}}}}
    joint:
      prismatic:
        axis: [1, 0, 0]
        limits: {{lower_m: -1, stiffness_N_per_m: 1.0e6}}
        gas_spring: {{piston_area_m2: {AREA}, gas_volume_m3: {VOLUME}, pressure_bar: 6, polytropic_exponent: {exponent}{more}}}
"
    )
}

/// Extension and speed.
fn state(simulation: &Simulation) -> [f64; 2] {
    [simulation.state().q[0], simulation.state().v[0]]
}

#[test]
fn an_expanding_gas_does_the_work_of_a_polytropic_process_on_the_piston() {
    // Cengel & Boles, Thermodynamics, 7th ed., eqs 4-9 and 4-10. The exponents near 1 are on both sides of the series.
    for exponent in [1.0, 1.0 + 1e-9, 1.0 + 1e-4, 1.2, 1.4, 2.0] {
        let mut simulation = simulation(&piston(exponent, ""));
        for _ in 0..3 {
            simulation.step(400).unwrap();
            let [extension, speed] = state(&simulation);
            let ratio = 1.0 + AREA * extension / VOLUME;
            let work = match exponent - 1.0 {
                excess if excess < 1e-8 => PRESSURE * VOLUME * ratio.ln(),
                excess => PRESSURE * VOLUME * (1.0 - ratio.powf(-excess)) / excess,
            };
            let kinetic = 0.5 * MASS * speed * speed;
            let error = kinetic - (work - ATMOSPHERE * AREA * extension);
            // Fourth order: (h / time scale of 0.3 s)^4 is 1e-11.
            assert!(error.abs() < 1e-8 * kinetic, "n = {exponent}: {error:e} of {kinetic} J at {extension} m");
            assert!(values(&mut simulation, "energy_error")[0].abs() < 1e-8 * kinetic, "n = {exponent}");
            let pressure = values(&mut simulation, "gas_spring_pressure")[0];
            assert!(
                (pressure / (PRESSURE * ratio.powf(-exponent)) - 1.0).abs() < 1e-12,
                "n = {exponent}: {pressure} Pa"
            );
            let force = values(&mut simulation, "gas_spring_force")[0];
            assert!((force - (pressure - ATMOSPHERE) * AREA).abs() < 1e-9 * force.abs(), "n = {exponent}: {force} N");
        }
    }
}

#[test]
fn a_piston_in_balance_swings_with_the_stiffness_n_p_a2_over_v() {
    // In balance with the pressure outside, from a thousandth of the gas' length: beyond the linear law by 1e-6 of it.
    for exponent in [1.0, 1.4] {
        let start = 1e-3 * VOLUME / AREA;
        let text = piston(exponent, &format!(", outside_pressure_Pa: {PRESSURE}"));
        let text = text.replace("axis: [1, 0, 0]", &format!("axis: [1, 0, 0]\n        initial_extension_m: {start}"));
        let period = TAU * (MASS * VOLUME / (exponent * PRESSURE * AREA * AREA)).sqrt();
        let mut simulation = simulation(&text.replace("step_s: 0.0005", &format!("step_s: {}", period / 1000.0)));
        simulation.step(1000).unwrap();
        let [extension, speed] = state(&simulation);
        assert!((extension / start - 1.0).abs() < 1e-5, "n = {exponent}: {extension} m after a period of {period} s");
        // The quadratic term shifts the swing by its square: 5 w^2 x0^2 / 48 and the like, below 1e-5.
        assert!(speed.abs() < 1e-4 * start * TAU / period, "n = {exponent}: {speed} m/s");
    }
}

#[test]
fn a_piston_far_into_its_stop_keeps_finite_numbers_and_its_energy() {
    let text = piston(1.4, "").replace("axis: [1, 0, 0]", "axis: [1, 0, 0]\n        initial_speed_m_s: -30");
    let mut simulation = simulation(&text.replace("stiffness_N_per_m: 1.0e6", "stiffness_N_per_m: 1.0e3"));
    simulation.step(2000).unwrap();
    let [extension, speed] = state(&simulation);
    assert!(extension.is_finite() && speed > 0.0, "{extension} m, {speed} m/s");
    // Where the gas is below half its volume at the stop, the force has a kink: a step over it is of second order.
    let error = values(&mut simulation, "energy_error")[0];
    assert!(error.abs() < 1e-4 * 0.5 * MASS * 900.0, "{error} J");
}

#[test]
fn a_gas_spring_without_gas_at_the_end_of_its_travel_is_refused() {
    let error = |changes: &[(&str, serde_json::Value)]| {
        let changes: Vec<_> = changes.iter().map(|(path, value)| ((*path).to_owned(), value.clone())).collect();
        let scenario = read(&piston(1.4, ""), "piston.yaml", &changes);
        scenario.and_then(|scenario| scenario.simulation().map(drop)).expect_err("refused").to_string()
    };
    let limits = "bodies.piston.joint.prismatic.limits";
    let found = error(&[(&format!("{limits}.lower_m"), json!(-1.5))]);
    let expected = format!(
        "{limits}.lower_m: found -1.5, with a gas volume of 0 m3 in the gas spring, allowed: more than -1.5000"
    );
    assert!(found.contains(&expected), "{found}");
    let found = error(&[(limits, json!({"upper_m": 1, "stiffness_N_per_m": 1e6}))]);
    assert!(found.contains(&format!("{limits}: found no lower limit, allowed: limits with lower_m")), "{found}");
    let found = error(&[("bodies.piston.joint.prismatic.gas_spring.pressure_Pa", json!(-1))]);
    assert!(found.contains("gas_spring.pressure_Pa: found -1, allowed: a number greater than 0"), "{found}");
}

/// At 100 m the water has 101 325 + 1025 * 9.80665 * 100 Pa, 1.106 MPa.
#[test]
fn a_gas_spring_under_water_with_the_pressure_of_the_atmosphere_outside_gives_a_warning() {
    let warnings = |height: f64, sea: &str, more: &str| {
        let text =
            piston(1.4, more).replace("        axis:", &format!("        position_m: [0, 0, {height}]\n        axis:"));
        let text = format!("{text}forces: {{gravity: {{gravity: {{acceleration_m_s2: 9.80665}}}}}}\n{sea}");
        read(&text, "piston.yaml", &[]).expect("it reads").describe().expect("it builds").warnings
    };
    let sea = "sea: {density_kg_m3: 1025}\n";
    let found = warnings(-100.0, sea, "");
    let [warning] = found.as_slice() else { panic!("{found:?}") };
    let expected = "piston: its gas spring begins 100 m under water, where the pressure is 1.11 MPa absolute, and its \
                    outside_pressure_Pa is 0.101 MPa: its force is 20.1 kN too large";
    assert!(warning.starts_with(expected), "{warning}");
    for none in [warnings(5.0, sea, ""), warnings(-100.0, "", ""), warnings(-100.0, sea, ", outside_pressure_bar: 11")]
    {
        assert_eq!(none, Vec::<String>::new());
    }
}
