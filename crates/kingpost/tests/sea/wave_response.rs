//! Response amplitude operators: the engine's own runs, closed forms, limits, symmetry.

use crate::common;

use common::barge::{BEAM, DENSITY, GRAVITY, LENGTH, added_mass_infinite, excitation, retardation, scenario};
use kingpost::analysis::{ResponseError, WaveGrid, WaveResponse};
use kingpost::scenario::Scenario;
use kingpost::{Simulation, ledger};
use serde_json::{Value, json};

const ON: Value = Value::Bool(true);
const MAST: &str = "bodies.mast.joint.prismatic.position_m";
const BOTH_HELD: [(&str, &str); 2] =
    [("bodies.load.joint.universal.first.mode", "held"), ("bodies.load.joint.universal.second.mode", "held")];

fn response(scenario: &Scenario, directions_rad: &[f64], frequencies_rad_s: &[f64]) -> WaveResponse {
    let waves = WaveGrid { directions_rad: directions_rad.to_vec(), frequencies_rad_s: frequencies_rad_s.to_vec() };
    let simulation = Simulation::new(scenario.setup().expect("it builds"));
    scenario.wave_response(&simulation, &waves).unwrap_or_else(|error| panic!("{error}"))
}

/// H of a row at a direction and a frequency.
fn h(found: &WaveResponse, row: usize, direction: usize, frequency: usize) -> [f64; 2] {
    let rows = found.real.len() / (found.directions_rad.len() * found.frequencies_rad_s.len());
    let at = (direction * found.frequencies_rad_s.len() + frequency) * rows + row;
    [found.real[at], found.imaginary[at]]
}

/// Index of the row of a place's axis.
fn place(found: &WaveResponse, name: &str, axis: usize) -> usize {
    3 * found.places.iter().position(|place| place == name).expect("a place") + axis
}

/// Index of the row of a body's angle.
fn angle(found: &WaveResponse, body: &str, k: usize) -> usize {
    3 * found.places.len() + 3 * found.bodies.iter().position(|name| name == body).expect("a body") + k
}

fn times([a, b]: [f64; 2], [c, d]: [f64; 2]) -> [f64; 2] {
    [a * c - b * d, a * d + b * c]
}

/// Heave of a box whose weights are amidships is alone: `(-w^2 (m + A) - i w B + C) H = X`.
#[test]
fn heave_of_an_even_barge_is_its_closed_form() {
    let mut overrides: Vec<(&str, Value)> = vec![(MAST, json!([0.0, 0.0, 7.0]))];
    overrides.extend(BOTH_HELD.map(|(name, mode)| (name, json!(mode))));
    let omegas = [0.3, 0.8, 1.2, 2.1];
    let found = response(&scenario(&overrides), &[0.4, 2.0], &omegas);
    for (k, &omega) in omegas.iter().enumerate() {
        let [b, more] = retardation(2, omega);
        let mass = 410e3 + added_mass_infinite()[2][2] + more / omega;
        let impedance = [DENSITY * GRAVITY * LENGTH * BEAM - omega * omega * mass, -omega * b];
        for direction in [0, 1] {
            let force = times(impedance, h(&found, place(&found, "hull", 2), direction, k));
            let expected = excitation(omega, 0.0)[2];
            for part in [0, 1] {
                assert!((force[part] - expected[part]).abs() < 1e-6 * expected[0], "{omega}: {force:?} {expected:?}");
            }
        }
    }
}

/// The whole linear state is put on the wave's answer, and the engine's run stays on it: ship, mast,
/// pendulum, memory of the water, at a wave so small that terms of second order are 1e-4 of it.
#[test]
fn a_run_in_a_regular_wave_is_the_response_in_amplitude_and_phase() {
    let amplitude = 1e-3;
    for (period, direction, shift) in [(6.0, 60.0, 0.5), (4.5, 150.0, -0.3), (9.0, -100.0, 0.0)] {
        let omega = core::f64::consts::TAU / period;
        let overrides = [
            ("shift_m", json!(shift)),
            ("height_m", json!(2.0 * amplitude)),
            ("sea.waves.swell.regular.enabled", ON),
            ("sea.waves.swell.regular.period_s", json!(period)),
            ("sea.waves.swell.regular.direction_rad", json!(f64::to_radians(direction))),
            ("bodies.load.joint.universal.first.damping_N_m_s", json!(2e3)),
            ("bodies.load.joint.universal.second.damping_N_m_s", json!(1e3)),
            ("simulation.begin_at_equilibrium", ON),
            ("simulation.step_s", json!(0.01)),
        ];
        let scenario = scenario(&overrides);
        let found = response(&scenario, &[f64::to_radians(direction)], &[omega]);
        let mut simulation = Simulation::new(scenario.setup().expect("it builds"));
        begin_on(&mut simulation, &found, amplitude);

        let (mut largest, mut worst) = (vec![0.0_f64; 3], vec![0.0_f64; 3]);
        let load = place(&found, "load", 0);
        let rows = [place(&found, "hull", 2), load + 1, angle(&found, "hull", 0)];
        let still = readings(&scenario);
        for step in 0..=((3.0 * period / 0.01) as usize) {
            let (sin, cos) = libm::sincos(omega * 0.01 * step as f64);
            for (k, (now, row)) in readings_of(&mut simulation).into_iter().zip(rows).enumerate() {
                let [re, im] = h(&found, row, 0, 0);
                let expected = amplitude * (re * cos + im * sin);
                largest[k] = largest[k].max(amplitude * libm::hypot(re, im));
                worst[k] = worst[k].max((now - still[k] - expected).abs());
            }
            simulation.step(1).expect("it runs");
        }
        for k in 0..3 {
            assert!(largest[k] > 1e-6, "{k}: it answers, {:e}", largest[k]);
            assert!(worst[k] < 0.01 * largest[k], "{period} s, {k}: off by {:e} of {:e}", worst[k], largest[k]);
        }
    }
}

/// Heave of the hull, y of the load, roll of the hull.
fn readings_of(simulation: &mut Simulation) -> [f64; 3] {
    let mut row = Vec::new();
    simulation.write_row(&mut row);
    let of = |variable: &str, entry: usize| {
        let channel = simulation.channels().iter().find(|channel| channel.variable == variable).expect("a channel");
        row[channel.offset + entry]
    };
    [of("position", 2), of("position", 3 * 2 + 1), of("roll", 0)]
}

fn readings(scenario: &Scenario) -> [f64; 3] {
    readings_of(&mut Simulation::new(scenario.setup().expect("it builds")))
}

/// Puts a simulation at rest on the state that the wave makes at time 0.
fn begin_on(simulation: &mut Simulation, found: &WaveResponse, amplitude: f64) {
    let now: Vec<f64> = found.of_states.iter().map(|[re, _]| amplitude * re).collect();
    let n = found.coordinates.len();
    let names = simulation.model().coordinate_names();
    let (mut xi, mut v) = (vec![0.0; names.len()], vec![0.0; names.len()]);
    for (k, name) in found.coordinates.iter().enumerate() {
        let i = names.iter().position(|other| other == name).expect("a coordinate");
        (xi[i], v[i]) = (now[k], now[n + k]);
    }
    let mut s = simulation.state().s.clone();
    // Beside what they are at rest.
    s[ledger::COUNT..].iter_mut().zip(&now[2 * n..]).for_each(|(s, now)| *s += now);
    let q = simulation.moved(&simulation.state().q, &xi);
    simulation.set_state(&q, &v, Some(&s)).expect("a state");
}

/// Waves of unit amplitude from the mirrored side move an even barge as in a mirror.
#[test]
fn a_head_sea_moves_a_symmetric_barge_in_its_plane_and_both_sides_are_mirror_images() {
    let even = scenario(&[(MAST, json!([2.0, 0.0, 7.0]))]);
    let found = response(&even, &[core::f64::consts::PI, 1.0, -1.0], &[0.5, 1.0, 1.7]);
    let odd = [place(&found, "hull", 1), angle(&found, "hull", 0), angle(&found, "hull", 2), place(&found, "load", 1)];
    let even = [place(&found, "hull", 0), place(&found, "hull", 2), angle(&found, "hull", 1)];
    for frequency in 0..3 {
        for row in odd {
            let [re, im] = h(&found, row, 0, frequency);
            assert!(libm::hypot(re, im) < 1e-9, "{row}: {re:e} {im:e}");
            let ([a, b], [c, d]) = (h(&found, row, 1, frequency), h(&found, row, 2, frequency));
            assert!((a + c).abs() + (b + d).abs() < 1e-9 && libm::hypot(a, b) > 1e-6, "{row}");
        }
        for row in even {
            let ([a, b], [c, d]) = (h(&found, row, 1, frequency), h(&found, row, 2, frequency));
            assert!((a - c).abs() + (b - d).abs() < 1e-9, "{row}");
        }
    }
}

/// Ship, waves and all turned by an angle: motions along the ship, heave, angles stay.
#[test]
fn the_response_turns_with_the_heading() {
    let heading = 0.7;
    let turned = scenario(&[("bodies.hull.joint.floating.initial.orientation_rad", json!([0.0, 0.0, heading]))]);
    let ahead = response(&scenario(&[]), &[2.2], &[0.9]);
    let found = response(&turned, &[2.2 + heading], &[0.9]);
    for row in [place(&found, "hull", 2), angle(&found, "hull", 0), angle(&found, "hull", 1), angle(&found, "hull", 2)]
    {
        let ([a, b], [c, d]) = (h(&ahead, row, 0, 0), h(&found, row, 0, 0));
        assert!((a - c).abs() + (b - d).abs() < 1e-7 * libm::hypot(a, b), "{row}: {a} {b}, {c} {d}");
    }
    let (sin, cos) = libm::sincos(heading);
    let along = |response: &WaveResponse, part: usize, [x, y]: [f64; 2]| {
        let of = |axis: usize| h(response, place(response, "load", axis), 0, 0)[part];
        x * of(0) + y * of(1)
    };
    for part in [0, 1] {
        assert!((along(&ahead, part, [1.0, 0.0]) - along(&found, part, [cos, sin])).abs() < 1e-7);
        assert!((along(&ahead, part, [0.0, 1.0]) - along(&found, part, [-sin, cos])).abs() < 1e-7);
    }
}

/// The phase is about the hull's own place, wherever in the world it is.
#[test]
fn the_response_does_not_depend_on_the_hulls_position() {
    let moved = scenario(&[("bodies.hull.joint.floating.initial.position_m", json!([300.0, -40.0, 0.0]))]);
    let (here, there) = (response(&scenario(&[]), &[1.1], &[0.9]), response(&moved, &[1.1], &[0.9]));
    assert!((there.reference_m[0] - here.reference_m[0] - 300.0).abs() < 1e-9);
    for row in 0..here.real.len() {
        assert!((here.real[row] - there.real[row]).abs() < 1e-8, "{row}");
        assert!((here.imaginary[row] - there.imaginary[row]).abs() < 1e-8, "{row}");
    }
}

#[test]
fn a_model_without_a_response_is_an_error() {
    let ask = |scenario: &Scenario, direction: f64, frequencies_rad_s: Vec<f64>| {
        let simulation = Simulation::new(scenario.setup().expect("it builds"));
        scenario.wave_response(&simulation, &WaveGrid { directions_rad: vec![direction], frequencies_rad_s })
    };
    let barge = scenario(&[]);
    let error = ask(&barge, 0.0, vec![1.0, 9.0]).expect_err("not covered");
    assert_eq!(
        error.to_string(),
        "frequencies_rad_s: found 9, allowed: 0.1000 to 4.0000 rad/s, which the database covers"
    );
    assert!(matches!(ask(&barge, f64::NAN, vec![1.0]), Err(ResponseError::Wave { quantity: "directions_rad", .. })));
    let deaf = scenario(&[("forces.water.hydrodynamics.excitation", json!(false))]);
    assert_eq!(ask(&deaf, 0.0, vec![1.0]), Err(ResponseError::NoHull));
    assert_eq!(ask(&barge, 0.0, Vec::new()).expect("the database's own").frequencies_rad_s.len(), 4 * 39 + 1);
}
