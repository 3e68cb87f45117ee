//! Change of the waves during a run: forecasts from a state of the run.

use super::vessel;
use kingpost::simulation::{InputError, Simulation};
use serde_json::{Value, json};

const TEXT: &str = "
version: 1
title: A vessel in waves
simulation: {step_s: 0.1, duration_s: 60, record_every_s: 0.5}
sea: {waves: {swell: {regular: {height_m: 2, period_s: 8, direction_deg: 180}}, sea: {jonswap: {significant_height_m: 2, peak_period_s: 7, gamma: 2, direction_deg: 150, realisation: {components: 30}}}}}
bodies:
  hull:
    mass_t: 5000
    inertia: {radii_of_gyration: {radii_m: [6, 20, 20]}}
    joint: {floating: {}}
forces:
  gravity: {gravity: {}}
  hold: {soft_hold: {body: hull}}
  water: {hydrodynamics: {body: hull, database: vessel.hydro.json, origin_m: [0, 0, 5.5]}}
";

fn simulation(more: &[(&str, Value)]) -> Simulation {
    Simulation::new(vessel::read(TEXT, more).expect("it reads").setup().expect("it builds"))
}

fn row(simulation: &mut Simulation) -> Vec<f64> {
    let mut row = Vec::new();
    simulation.write_row(&mut row);
    row
}

fn amplitudes_and_phases(simulation: &Simulation) -> (Vec<f64>, Vec<f64>) {
    simulation.waves().iter().map(|wave| (wave.amplitude_m, wave.phase_rad)).unzip()
}

#[test]
fn back_in_its_sea_a_run_continues_bitwise_identically() {
    let mut run = simulation(&[]);
    run.step(200).unwrap();
    let snapshot = run.snapshot();
    let (amplitudes, phases) = amplitudes_and_phases(&run);
    run.step(100).unwrap();
    let expected = row(&mut run);

    run.restore(&snapshot).unwrap();
    let turned: Vec<f64> = phases.iter().map(|phase| phase + 1.0).collect();
    run.set_waves(&amplitudes, &turned).unwrap();
    run.step(100).unwrap();
    assert_ne!(row(&mut run), expected);

    run.restore(&snapshot).unwrap();
    run.set_waves(&amplitudes, &phases).unwrap();
    run.step(100).unwrap();
    assert_eq!(row(&mut run), expected);
}

/// The check includes the time of the change, at which the force in the previous sea has already been
/// evaluated.
#[test]
fn waves_set_during_a_run_act_like_those_of_a_scenario() {
    let waves = "sea.waves.swell.regular";
    let (height, phase) = (format!("{waves}.height_m"), format!("{waves}.phase_rad"));
    let mut expected = simulation(&[(&height, json!(3.0)), (&phase, json!(0.7))]);
    let mut found = simulation(&[]);
    row(&mut found);
    let (mut amplitudes, mut phases) = amplitudes_and_phases(&found);
    (amplitudes[0], phases[0]) = (1.5, 0.7);
    found.set_waves(&amplitudes, &phases).unwrap();
    for _ in 0..5 {
        assert_eq!(row(&mut found), row(&mut expected));
        assert_eq!(found.surface(&[1.0, 2.0], &[3.0]), expected.surface(&[1.0, 2.0], &[3.0]));
        let [real, _] = found.wave_phasors([1.0, 3.0], found.time_s());
        assert!((real.iter().sum::<f64>() - found.surface(&[1.0], &[3.0])[0]).abs() < 1e-12);
        found.step(40).unwrap();
        expected.step(40).unwrap();
    }
}

#[test]
fn exact_derivatives_of_an_implicit_scheme_are_those_of_the_sea_that_is_set() {
    let implicit = ("simulation.integrator", json!("implicit_midpoint"));
    let phase = ("sea.waves.swell.regular.phase_rad", json!(0.7));
    let simulation = |more: &[(&str, Value)]| vessel::read(TEXT, more).unwrap().simulation().unwrap();
    let mut expected = simulation(&[implicit.clone(), phase]);
    let mut found = simulation(&[implicit]);
    let (amplitudes, mut phases) = amplitudes_and_phases(&found);
    phases[0] = 0.7;
    found.set_waves(&amplitudes, &phases).unwrap();
    found.step(50).unwrap();
    expected.step(50).unwrap();
    assert_eq!(row(&mut found), row(&mut expected));
    assert_eq!(found.evaluations(), expected.evaluations());
}

#[test]
fn waves_that_are_not_one_finite_number_each_are_refused() {
    let mut run = simulation(&[]);
    let (amplitudes, mut phases) = amplitudes_and_phases(&run);
    let short = run.set_waves(&amplitudes[1..], &phases);
    assert!(matches!(short, Err(InputError::Length { name: "amplitudes_m", found: 30, allowed: 31 })), "{short:?}");
    phases[3] = f64::NAN;
    let lost = run.set_waves(&amplitudes, &phases);
    assert!(matches!(lost, Err(InputError::Entry { name: "phases_rad", index: 3, .. })), "{lost:?}");
}
