//! Frequency response of the columns of results: motions computed in another way, Newton's law, and the waves
//! themselves.

use crate::common;

use common::barge::{excitation, scenario};
use kingpost::Simulation;
use kingpost::analysis::{ColumnResponse, NotLinear, ResponseError, WaveGrid, WaveResponse};
use kingpost::scenario::Scenario;
use nalgebra::Complex;
use serde_json::{Value, json};

const DIRECTIONS: [f64; 2] = [0.4, 2.0];
const OMEGAS: [f64; 3] = [0.5, 1.1, 1.7];
const GRAVITY: f64 = 9.80665;
const LOAD_KG: f64 = 10e3;

fn grid() -> WaveGrid {
    WaveGrid { directions_rad: DIRECTIONS.to_vec(), frequencies_rad_s: OMEGAS.to_vec() }
}

fn simulation(scenario: &Scenario) -> Simulation {
    Simulation::new(scenario.setup().expect("it builds"))
}

fn response(scenario: &Scenario, columns: &[&str]) -> ColumnResponse {
    let columns: Vec<String> = columns.iter().map(|column| (*column).to_owned()).collect();
    let found = scenario.column_response(&simulation(scenario), &grid(), &columns, false);
    found.unwrap_or_else(|error| panic!("{error}"))
}

/// A barge with a list, whose mast is off the middle, so that all motions are coupled.
fn listing() -> Scenario {
    scenario(&[("shift_m", json!(0.3))])
}

/// H of a column at a direction and a frequency.
fn h(found: &ColumnResponse, name: &str, (direction, frequency): (usize, usize)) -> Complex<f64> {
    let column = found.columns.iter().position(|column| column == name).unwrap_or_else(|| panic!("{name}"));
    let [re, im] = found.amplitudes[(direction * OMEGAS.len() + frequency) * found.columns.len() + column];
    Complex::new(re, im)
}

fn size(of: Complex<f64>) -> f64 {
    libm::hypot(of.re, of.im)
}

/// Every direction with every frequency.
fn each_wave() -> impl Iterator<Item = (usize, usize)> {
    (0..DIRECTIONS.len()).flat_map(|direction| (0..OMEGAS.len()).map(move |frequency| (direction, frequency)))
}

fn assert_near(found: Complex<f64>, expected: Complex<f64>, scale: f64, what: &str) {
    assert!(size(found - expected) <= 1e-9 * scale, "{what}: {found} beside {expected}");
}

/// Source: the response of positions, angles and coordinates by the bodies' Jacobians, without rows of
/// results.
#[test]
fn positions_angles_and_coordinates_have_the_frequency_response_of_motions() {
    let barge = listing();
    let found = response(&barge, &[]);
    let motions: WaveResponse = barge.wave_response(&simulation(&barge), &grid()).expect("it answers");
    let width = motions.real.len() / (DIRECTIONS.len() * OMEGAS.len());
    let mut rows: Vec<String> = Vec::new();
    for place in &motions.places {
        let variable = if place.contains('.') { "point_position" } else { "position" };
        rows.extend(["x", "y", "z"].map(|axis| format!("{place}.{variable}.{axis}")));
    }
    rows.extend(motions.bodies.iter().flat_map(|body| ["roll", "pitch", "yaw"].map(|angle| format!("{body}.{angle}"))));
    for wave in each_wave() {
        for (row, name) in rows.iter().enumerate() {
            let at = (wave.0 * OMEGAS.len() + wave.1) * width + row;
            let expected = Complex::new(motions.real[at], motions.imaginary[at]);
            assert_near(h(&found, name, wave), expected, 1.0, name);
        }
    }
}

/// Source: the derivative of `e^(-i w t)`.
#[test]
fn velocities_and_accelerations_are_rates_of_positions() {
    let found = response(&listing(), &[]);
    for wave in each_wave() {
        let rate = Complex::new(0.0, -OMEGAS[wave.1]);
        for body in ["hull", "mast", "load"] {
            for axis in ["x", "y", "z"] {
                let position = h(&found, &format!("{body}.position.{axis}"), wave);
                let name = format!("{body}.velocity.{axis}");
                assert_near(h(&found, &name, wave), rate * position, 1.0, &name);
                let name = format!("{body}.acceleration.{axis}");
                assert_near(h(&found, &name, wave), rate * rate * position, 1.0, &name);
            }
        }
    }
}

/// Source: Newton's law of the load, `F = m (a - g)` in its own axes: of first order `m (a_x - g pitch)`, `m (a_y + g roll)`,
/// `m a_z`, about `m g`.
#[test]
fn the_pendulum_carries_the_weight_and_the_acceleration_of_its_load() {
    let even = scenario(&[("bodies.mast.joint.prismatic.position_m", json!([0.0, 0.0, 7.0]))]);
    let found = response(&even, &[]);
    let joint = found.columns.iter().find(|column| column.starts_with("load") && column.ends_with("reaction.force_z"));
    let joint = joint.expect("the joint of the load").trim_end_matches("z").to_owned();
    let place = found.columns.iter().position(|column| *column == format!("{joint}z")).expect("it is there");
    assert!((found.mean[place] - LOAD_KG * GRAVITY).abs() < 1e-6 * LOAD_KG * GRAVITY);
    for wave in each_wave() {
        let of = |column: &str| h(&found, column, wave);
        let expected = [
            of("load.acceleration.x") - GRAVITY * of("load.pitch"),
            of("load.acceleration.y") + GRAVITY * of("load.roll"),
            of("load.acceleration.z"),
        ];
        for (axis, expected) in ["x", "y", "z"].into_iter().zip(expected) {
            let name = format!("{joint}{axis}");
            assert_near(of(&name), LOAD_KG * expected, LOAD_KG * GRAVITY, &name);
        }
    }
}

/// Source: a wave of 1 m at the origin of the hull's data, and the database's own formula of the force.
#[test]
fn the_hull_shows_the_waves_and_their_force() {
    let found = response(&scenario(&[]), &[]);
    for wave in each_wave() {
        assert_near(h(&found, "water.wave_elevation", wave), Complex::new(1.0, 0.0), 1.0, "elevation");
        let [re, im] = excitation(OMEGAS[wave.1], DIRECTIONS[wave.0])[2];
        // The barge trims by its mast, by less than a tenth of a degree.
        let off = size(h(&found, "water.excitation_force.force_z", wave) - Complex::new(re, im));
        assert!(off < 1e-2 * re, "{off:e} of {re:e}");
    }
}

/// Source: z minus the elevation of the wave at the position of the point, `e^(i k . r)`.
#[test]
fn an_air_gap_is_the_height_over_the_wave_at_its_place() {
    let sensors = json!({"gap": {"air_gap": {"body": "hull", "position_m": [8.0, -3.0, 5.0]}}});
    let barge =
        scenario(&[("sensors", sensors), ("bodies.hull.points", json!({"bow": {"position_m": [8.0, -3.0, 5.0]}}))]);
    let found = response(&barge, &[]);
    for wave in each_wave() {
        let (k, direction) = (OMEGAS[wave.1] * OMEGAS[wave.1] / GRAVITY, DIRECTIONS[wave.0]);
        let place = |axis: &str| {
            let column = found.columns.iter().position(|column| *column == format!("hull.bow.point_position.{axis}"));
            found.mean[column.expect("the point")]
        };
        let [x, y] = [place("x") - found.reference_m[0], place("y") - found.reference_m[1]];
        let (sin, cos) = libm::sincos(k * (x * libm::cos(direction) + y * libm::sin(direction)));
        let expected = h(&found, "hull.bow.point_position.z", wave) - Complex::new(cos, sin);
        assert_near(h(&found, "gap.air_gap", wave), expected, 1.0, "air gap");
    }
}

#[test]
fn a_column_without_a_frequency_response_has_a_reason() {
    let found = response(&scenario(&[]), &[]);
    let reason = |name: &str| {
        let column = found.columns.iter().position(|column| column == name).unwrap_or_else(|| panic!("{name}"));
        let none = found.amplitudes[column][0].is_nan();
        assert_eq!(none, found.not_linear[column].is_some(), "{name}");
        found.not_linear[column]
    };
    assert_eq!(reason("time"), Some(NotLinear::OverTime));
    assert_eq!(reason("work_done"), Some(NotLinear::OverTime));
    assert_eq!(reason("energy_error"), Some(NotLinear::OverTime));
    assert_eq!(reason("kinetic_energy"), Some(NotLinear::SecondOrder));
    assert_eq!(reason("water.water_kinetic_energy"), Some(NotLinear::SecondOrder));
    assert_eq!(reason("water.drift_force.force_x"), Some(NotLinear::SecondOrder));
    // What is held does not move: in proportion, by nothing.
    let held = found.columns.iter().find(|column| column.starts_with("mast") && column.ends_with("joint_position"));
    let held = held.expect("the mast's joint");
    assert_eq!(reason(held), None);
    assert_near(h(&found, held, (0, 0)), Complex::new(0.0, 0.0), 1.0, held);
}

#[test]
fn a_resonance_gets_additional_frequencies() {
    let light = [
        ("bodies.load.joint.universal.first.damping_N_m_s", json!(100.0)),
        ("bodies.load.joint.universal.second.damping_N_m_s", json!(100.0)),
    ];
    let barge = scenario(&light);
    let waves = WaveGrid { directions_rad: vec![0.4], frequencies_rad_s: Vec::new() };
    let ask = |about| {
        let column = ["load.roll".to_owned()];
        barge.column_response(&simulation(&barge), &waves, &column, about).expect("it answers")
    };
    let (without, with) = (ask(false), ask(true));
    let narrow = with.resonances.iter().filter(|one| one.decay_per_s.abs() < 0.01 && one.frequency_rad_s > 0.1);
    let narrow: Vec<f64> = narrow.map(|one| one.frequency_rad_s).collect();
    assert!(!narrow.is_empty(), "{:?}", with.resonances);
    for omega in narrow.iter().filter(|omega| **omega < 4.0) {
        assert!(with.frequencies_rad_s.contains(omega), "{omega}");
    }
    assert!(without.frequencies_rad_s.iter().all(|omega| with.frequencies_rad_s.contains(omega)));
}

#[test]
fn a_column_that_does_not_exist_is_an_error() {
    let barge = scenario(&[]);
    let columns = ["hull.rol".to_owned()];
    let found = barge.column_response(&simulation(&barge), &grid(), &columns, false);
    assert_eq!(found, Err(ResponseError::Column("hull.rol".to_owned())));
    let deaf = scenario(&[("forces.water.hydrodynamics.excitation", Value::Bool(false))]);
    let found = deaf.column_response(&simulation(&deaf), &grid(), &[], false);
    assert_eq!(found, Err(ResponseError::NoHull));
}
