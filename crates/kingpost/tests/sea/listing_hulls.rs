//! Hulls with a list: hydrodynamics for the upright hull, or for the attitude for which they were computed.

use crate::common;

use common::values;
use core::f64::consts::PI;
use kingpost::Simulation;
use kingpost::analysis::{WaveGrid, WaveResponse};
use kingpost::scenario::{Files, Scenario, read_with};
use serde_json::{Value, json};

/// A box barge of 20 x 10 m on 2 m of draught, its ballast to port: GM 3.2 m, so that 0.25 m list it 4.5 degrees.
const TEXT: &str = "
version: 1
title: A barge that lists
simulation: {step_s: 0.05, duration_s: 60, record_every_s: 0.5, begin_at_equilibrium: true}
bodies:
  hull:
    mass_t: 410
    centre_of_mass_m: [0, 0.25, 2]
    inertia: {radii_of_gyration: {radii_m: [3.5, 6, 6]}}
    joint: {floating: {}}
forces:
  gravity: {gravity: {}}
  water: {hydrodynamics: {body: hull, database: hull.hydro.json, origin_m: [0, 0, 2], hydrostatics: mesh}}
";

const BARGE: &str = include_str!("../../../../scenarios/hydro/barge.hydro.json");

fn scenario(database: &str, more: &[(&str, Value)]) -> Scenario {
    let files = Files::new([("hull.hydro.json".to_owned(), database.to_owned())]);
    let overrides: Vec<_> = more.iter().map(|(name, value)| ((*name).to_owned(), value.clone())).collect();
    read_with(TEXT, "listing.yaml", &overrides, &files).unwrap_or_else(|error| panic!("{error}"))
}

fn simulation(scenario: &Scenario) -> Simulation {
    Simulation::new(scenario.setup().unwrap_or_else(|error| panic!("{error}")))
}

/// Amplitudes of surge, sway, heave (m/m) and roll, pitch, yaw (rad/m) at one direction and frequency.
fn amplitudes(scenario: &Scenario, direction_rad: f64, omega_rad_s: f64) -> [f64; 6] {
    let waves = WaveGrid { directions_rad: vec![direction_rad], frequencies_rad_s: vec![omega_rad_s] };
    let WaveResponse { real, imaginary, places, .. } =
        scenario.wave_response(&simulation(scenario), &waves).unwrap_or_else(|error| panic!("{error}"));
    let row = |k: usize| libm::hypot(real[k], imaginary[k]);
    let angles = 3 * places.len();
    [row(0), row(1), row(2), row(angles), row(angles + 1), row(angles + 2)]
}

/// In a head sea, a box with a list due to a weight is lifted vertically, and not pushed aside: Capytaine's
/// coefficients of a heeled box give a sway below 0.004 m/m. Tilted added mass with level loads would give
/// 0.1 m/m.
#[test]
fn a_barge_that_lists_does_not_sway_in_a_head_sea() {
    let listing = scenario(BARGE, &[]);
    let heel = values(&mut simulation(&listing), "roll")[0].to_degrees();
    assert!((heel + 4.5).abs() < 0.2, "{heel}");
    for omega in [0.3, 0.6, 1.0, 1.5] {
        let [_, sway, heave, ..] = amplitudes(&listing, PI, omega);
        assert!(sway < 0.02 * heave.max(0.1), "{omega}: sway {sway}, heave {heave}");
    }
}

/// Checks the response of a listing barge against a run: the sway of the run does not exceed that of the
/// response.
#[test]
fn a_run_of_a_barge_that_lists_has_its_response() {
    let waves = json!({"swell": {"regular": {"height_m": 0.02, "period_s": 6.0, "direction_rad": 2.5}}});
    let listing = scenario(BARGE, &[("sea", json!({"waves": waves, "ramp_s": 60}))]);
    let expected = amplitudes(&listing, 2.5, core::f64::consts::TAU / 6.0);
    let mut run = simulation(&listing);
    let place = |run: &mut Simulation| {
        let at = values(run, "position");
        [at[0], at[1], at[2], values(run, "roll")[0], values(run, "pitch")[0], values(run, "yaw")[0]]
    };
    run.step(3_600).expect("it runs");
    // A Fourier sum over ten periods, less the mean.
    let (steps, omega) = (1_200, core::f64::consts::TAU / 6.0);
    let rows: Vec<[f64; 6]> = (0..steps)
        .map(|_| {
            run.step(1).expect("it runs");
            place(&mut run)
        })
        .collect();
    for (k, expected) in expected.iter().enumerate().filter(|(k, _)| *k < 5) {
        let mut sums = [0.0; 2];
        for (i, row) in rows.iter().enumerate() {
            let (sin, cos) = libm::sincos(omega * 0.05 * i as f64);
            sums[0] += (row[k] - rows[0][k]) * cos;
            sums[1] += (row[k] - rows[0][k]) * sin;
        }
        let found = 2.0 / steps as f64 * libm::hypot(sums[0], sums[1]) / 0.01;
        assert!((found - expected).abs() < 0.01 * expected + 1e-3, "{k}: {found} {expected}");
    }
}

/// Where a hull lies in the attitude that its coefficients were computed in, they act as those of an upright hull that lies
/// even: on a body whose inertia is the same about all axes across its length, a turn about that makes no difference.
#[test]
fn coefficients_of_an_attitude_are_those_of_the_hull_at_this_attitude() {
    let sea = json!({"waves": {"swell": {"regular": {"height_m": 1.0, "period_s": 5.0, "direction_rad": 2.0}}}});
    let roll: f64 = 0.1;
    let more = [
        ("sea", sea),
        ("simulation.begin_at_equilibrium", json!(false)),
        ("bodies.hull.centre_of_mass_m", json!([0, 0, 2])),
        ("forces.water.hydrodynamics.hydrostatics", json!("none")),
    ];
    let heeled = {
        let mut database: Value = serde_json::from_str(BARGE).expect("it is JSON");
        database["hull"]["attitude"] = json!({"roll_rad": roll, "pitch_rad": 0.0, "height_m": 0.0});
        database.to_string()
    };
    let listing = json!({"position_m": [0, 0, 0], "orientation_rad": [roll, 0, 0]});
    let initial = ("bodies.hull.joint.floating.initial", listing);
    let [mut even, mut heeled] =
        [simulation(&scenario(BARGE, &more)), simulation(&scenario(&heeled, &[more.as_slice(), &[initial]].concat()))];
    for _ in 0..100 {
        for run in [&mut even, &mut heeled] {
            run.step(1).expect("it runs");
        }
        let [at_even, at_heeled] =
            [&mut even, &mut heeled].map(|run| (values(run, "position"), values(run, "roll")[0]));
        for k in 0..3 {
            assert!((at_even.0[k] - at_heeled.0[k]).abs() < 1e-9, "{k}: {at_even:?} {at_heeled:?}");
        }
        assert!((at_even.1 + roll - at_heeled.1).abs() < 1e-9, "{at_even:?} {at_heeled:?}");
    }
    assert!(values(&mut even, "roll")[0].abs() > 1e-3 && values(&mut even, "position")[1].abs() > 1e-2);
}

#[test]
fn an_invalid_attitude_is_refused() {
    let mut database: Value = serde_json::from_str(BARGE).expect("it is JSON");
    database["hull"]["attitude"] = json!({"roll_rad": 0.0, "pitch_rad": 2.0, "height_m": 0.0});
    let files = Files::new([("hull.hydro.json".to_owned(), database.to_string())]);
    let error = read_with(TEXT, "listing.yaml", &[], &files).expect_err("it is refused").to_string();
    assert!(error.contains("hull.attitude.pitch_rad") && error.contains("quarter of a turn"), "{error}");
}
