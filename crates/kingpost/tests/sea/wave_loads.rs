//! Nonlinear wave loads on hulls, and the kinds of waves: closed forms.

use crate::common;

use common::barge;
use core::f64::consts::{FRAC_PI_2, TAU};
use kingpost::scenario::{Files, Scenario, ScenarioError, read_with};
use kingpost::simulation::Simulation;
use serde_json::{Value, json};

/// A hull at the position at which loads are evaluated: its slow frame does not move.
const TEXT: &str = "
version: 1
title: A hull in waves
simulation: {step_s: 0.05, duration_s: 30, record_every_s: 0.5}
sea: {waves: {}}
bodies:
  hull:
    mass_t: 410
    centre_of_mass_m: [0, 0, 2]
    inertia: {radii_of_gyration: {radii_m: [3.5, 6, 6]}}
    joint: {floating: {}}
forces:
  gravity: {gravity: {}}
  water:
    hydrodynamics: {body: hull, database: hull.hydro.json, origin_m: [0, 0, 2], slow_motion_cutoff_rad_s: 1e-15}
";

const PRESSURE: &str = "forces.water.hydrodynamics.wave_pressure";
const HYDROSTATICS: &str = "forces.water.hydrodynamics.hydrostatics";
const DRIFT: &str = "forces.water.hydrodynamics.wave_drift";

/// The database of the gallery's vessel, from Capytaine.
const VESSEL: &str = include_str!("../../../../scenarios/hydro/offshore_vessel.hydro.json");

/// D of surge, sway and yaw: a formula of frequency and direction, linear in frequency.
fn drift(omega: f64, direction: f64) -> [f64; 3] {
    let strength = 4e3 * omega;
    [
        strength * libm::cos(direction),
        2.0 * strength * libm::sin(direction),
        3.0 * strength * libm::sin(2.0 * direction),
    ]
}

/// The barge's database with mean drift.
fn drifting_barge() -> String {
    let mut database: Value = serde_json::from_str(&barge::database()).expect("it is JSON");
    let numbers = |field: &str| -> Vec<f64> { serde_json::from_value(database[field].clone()).expect("a list") };
    let (omegas, directions) = (numbers("frequencies_rad_s"), numbers("wave_directions_rad"));
    let at = |omega: &f64| directions.iter().map(|direction| drift(*omega, *direction)).collect::<Vec<_>>();
    database["mean_drift"] = json!(omegas.iter().map(at).collect::<Vec<_>>());
    database.to_string()
}

fn read(waves: Value, more: &[(&str, Value)], files: &[(&str, String)]) -> Result<Scenario, ScenarioError> {
    let mut overrides = vec![("sea.waves".to_owned(), waves)];
    overrides.extend(more.iter().map(|(name, value)| ((*name).to_owned(), value.clone())));
    let files = Files::new(files.iter().map(|(name, text)| ((*name).to_owned(), text.clone())));
    read_with(TEXT, "hull.yaml", &overrides, &files)
}

/// Rows of a channel, and the times.
fn run(scenario: &Scenario, variable: &str) -> Vec<(f64, Vec<f64>)> {
    let mut simulation = Simulation::new(scenario.setup().expect("it builds"));
    let channel = simulation.channels().iter().find(|channel| channel.variable == variable).expect("a channel").clone();
    let run = simulation.run(|_| true);
    run.status.expect("it runs");
    run.rows.chunks_exact(run.columns).map(|row| (row[0], row[channel.offset..][..channel.len].to_vec())).collect()
}

fn regular(height_m: f64, period_s: f64, direction_rad: f64, phase_rad: f64) -> Value {
    let wave =
        json!({"height_m": height_m, "period_s": period_s, "direction_rad": direction_rad, "phase_rad": phase_rad});
    json!({"regular": wave})
}

#[test]
fn the_pressure_of_low_waves_on_the_mesh_is_the_linear_force() {
    // The mesh has about 500 triangles whose vertices are on the hull, the data's panels are finer: second order in the
    // size of a triangle, about (4 m)^2 / (pi 40 m), against waves of 100 m and more.
    let files = [("hull.hydro.json", VESSEL.to_owned())];
    let origin = ("forces.water.hydrodynamics.origin_m", json!([0, 0, 0]));
    let place = ("bodies.hull.centre_of_mass_m", json!([0, 0, 0]));
    let short = ("simulation.duration_s", json!(0.05));
    for direction in [0.0, FRAC_PI_2, 2.0] {
        let force = |phase: f64, pressure: bool| {
            let more = [
                origin.clone(),
                place.clone(),
                short.clone(),
                (HYDROSTATICS, json!("mesh")),
                (PRESSURE, json!(pressure)),
                ("forces.hold", json!({"soft_hold": {"body": "hull"}})),
            ];
            let scenario = read(json!({"swell": regular(0.02, 9.0, direction, phase)}), &more, &files);
            let scenario = scenario.unwrap_or_else(|error| panic!("{error}"));
            run(&scenario, "excitation_force")[0].1.clone()
        };
        let parts = |pressure: bool| [force(0.0, pressure), force(-FRAC_PI_2, pressure)];
        let (linear, on_mesh) = (parts(false), parts(true));
        // Beside the heave force; moments at a tenth of the length.
        let heave = libm::hypot(linear[0][2], linear[1][2]);
        for mode in 0..6 {
            let scale = if mode < 3 { heave } else { 8.0 * heave };
            for part in 0..2 {
                let error = (on_mesh[part][mode] - linear[part][mode]).abs() / scale;
                assert!(error < 0.02, "{direction} mode {mode}: {} {}", on_mesh[part][mode], linear[part][mode]);
            }
        }
    }
}

#[test]
fn two_waves_drift_a_hull_by_their_own_means_and_slowly_by_both() {
    // Newman's approximation of two waves, written out.
    let files = [("hull.hydro.json", drifting_barge())];
    let (a, b, direction) = (0.5, 0.75, 2.1);
    let (periods, phases) = ([7.0, 8.5], [0.3, 1.1]);
    let waves = json!({
        "first": regular(2.0 * a, periods[0], direction, phases[0]),
        "second": regular(2.0 * b, periods[1], direction, phases[1]),
    });
    let scenario = read(waves, &[(DRIFT, json!(true))], &files).unwrap_or_else(|error| panic!("{error}"));
    let [first, second] = periods.map(|period| drift(TAU / period, direction));
    for (time, force) in run(&scenario, "drift_force") {
        let [p, q] = [0, 1].map(|k| phases[k] - TAU / periods[k] * time);
        for (k, mode) in [0, 1, 5].into_iter().enumerate() {
            let expected = a * a * first[k] + b * b * second[k] + a * b * (first[k] + second[k]) * libm::cos(p - q);
            // The polynomial in direction goes through 12 points of a formula with two harmonics: to rounding.
            assert!((force[mode] - expected).abs() < 1e-9 * 4e3, "{time} mode {mode}: {} {expected}", force[mode]);
        }
        assert_eq!(force[2..5], [0.0; 3]);
    }
}

#[test]
fn the_waves_of_a_record_are_the_record() {
    // Harmonics of its length below half the sampling frequency: the discrete transform is exact.
    let (count, interval) = (64, 0.5);
    let elevation = |time: f64| {
        let turn = TAU * time / (f64::from(count) * interval);
        0.8 * libm::cos(3.0 * turn - 0.4) + 0.3 * libm::cos(7.0 * turn + 1.0) + 0.1 * libm::sin(9.0 * turn)
    };
    let line = |k: i32| format!("{},{}\n", f64::from(k) * interval, elevation(f64::from(k) * interval));
    let text = format!("time_s,elevation_m\n{}", (0..count).map(line).collect::<String>());
    let waves =
        |file: &str| json!({"measured": {"record": {"file": file, "direction_rad": 1.0, "highest_rad_s": 3.5}}});
    let files = [("hull.hydro.json", barge::database()), ("buoy.csv", text)];
    let scenario = read(waves("buoy.csv"), &[], &files).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(scenario.file_names(), ["buoy.csv", "hull.hydro.json"]);
    for (time, found) in run(&scenario, "wave_elevation") {
        assert!((found[0] - elevation(time)).abs() < 1e-12, "{time}");
    }
    let error = read(waves("lost.csv"), &[], &files).expect_err("no such file").to_string();
    assert!(error.contains("sea.waves.measured.record.file") && error.contains("no file lost.csv"), "{error}");
}

#[test]
fn every_kind_of_sea_has_its_specified_height() {
    // Deterministic amplitudes: the variance of the components is that of the whole spectrum. Over a run the mean square
    // of the elevation scatters, so it is held loosely here; the components are held closely by tests of their own.
    let files = [("hull.hydro.json", VESSEL.to_owned())];
    let longer = [("simulation.duration_s", json!(600)), ("simulation.step_s", json!(0.5))];
    let part = |height: f64, period: f64| json!({"significant_height_m": height, "peak_period_s": period, "shape": 2});
    let kinds = [
        (json!({"torsethaugen": {"significant_height_m": 5, "peak_period_s": 13}}), 5.0),
        (json!({"ochi_hubble": {"swell": part(2.4, 13.0), "wind_sea": part(1.8, 7.0)}}), 3.0),
        (json!({"spectrum": {"rows": [[0.5, 0], [0.7, 2.8125], [0.9, 0]]}}), 3.0),
    ];
    for (waves, height) in kinds {
        let scenario = read(json!({"sea": waves}), &longer, &files).unwrap_or_else(|error| panic!("{error}"));
        let elevations: Vec<f64> = run(&scenario, "wave_elevation").iter().map(|(_, found)| found[0]).collect();
        let mean_square = elevations.iter().map(|z| z * z).sum::<f64>() / elevations.len() as f64;
        let found = 4.0 * libm::sqrt(mean_square);
        assert!((found / height - 1.0).abs() < 0.15, "{waves}: {found} m");
    }
}

#[test]
fn missing_data_of_wave_loads_are_reported_at_the_field() {
    let barge = [("hull.hydro.json", barge::database())];
    let calm = || json!({"swell": regular(1.0, 8.0, 0.0, 0.0)});
    let told = |waves: Value, more: &[(&str, Value)]| {
        let scenario = read(waves, more, &barge);
        let error = scenario.and_then(|scenario| scenario.setup().map(|_| ())).expect_err("it is refused");
        error.to_string()
    };
    let error = told(calm(), &[(DRIFT, json!(true))]);
    assert!(error.contains("wave_drift") && error.contains("without mean drift"), "{error}");
    let error = told(calm(), &[(PRESSURE, json!(true))]);
    assert!(error.contains("wave_pressure") && error.contains("hydrostatics: mesh"), "{error}");
    let error = told(json!({"sea": {"spectrum": {"rows": [[0.5, 1], [0.4, 1]]}}}), &[]);
    assert!(error.contains("sea.waves.sea.spectrum.rows[1][0]"), "{error}");
    let short = json!({"sea": {"torsethaugen": {"significant_height_m": 9, "peak_period_s": 5}}});
    let error = told(short, &[]);
    assert!(error.contains("sea.waves.sea.torsethaugen.peak_period_s"), "{error}");
}
