//! Every scenario of the gallery reads, runs to its end, and its energy and momentum balance.

use crate::common::gallery_files;

use kingpost::Simulation;
use kingpost::scenario::Scenario;

fn gallery() -> Vec<(String, Scenario)> {
    let read = |name: String| (name.clone(), gallery_files::scenario(&name, &[]));
    gallery_files::names("").into_iter().map(read).collect()
}

#[test]
fn every_scenario_has_a_title_and_a_description() {
    for (name, scenario) in gallery() {
        assert!(!scenario.title.is_empty() && scenario.title.len() <= 60, "{name}: a title of one short line");
        assert!(scenario.description.len() >= 80, "{name}: a description that says what to look at");
        for parameter in &scenario.parameters {
            assert!(!parameter.label.is_empty(), "{name}: a label for {}", parameter.name);
        }
    }
}

#[test]
fn every_scenario_names_its_camera_and_one_to_three_plots() {
    for (name, scenario) in gallery() {
        let view = scenario.view.unwrap_or_else(|| panic!("{name}: a view"));
        assert!(view.camera.is_some(), "{name}: a camera");
        assert!((1..=3).contains(&view.plots.len()), "{name}: one to three plots");
    }
}

/// One of each kind of machine: held and free, at sea, in contact, over closed loops.
const BY_DEFAULT: [&str; 5] = ["paper", "barge", "lift_off_from_barge", "knuckle_boom_crane", "gyro_wave_energy"];

#[test]
fn scenarios_of_each_kind_run_to_their_end_and_their_ledgers_close() {
    let read = |name| (name, gallery_files::scenario(name, &[]));
    BY_DEFAULT.map(read).iter().for_each(|(name, scenario)| assert_runs_to_its_end(name, scenario));
}

#[test]
#[ignore = "thorough"]
fn every_scenario_runs_to_its_end_and_its_ledger_closes() {
    gallery().iter().for_each(|(name, scenario)| assert_runs_to_its_end(name, scenario));
}

/// Checks the steps that the gallery uses: errors are below 1e-4 of the energy in play. Momentum is compared
/// with energy over the fastest rate: in a closed system its sum can be 0 while all its parts are large.
#[track_caller]
fn assert_runs_to_its_end(name: &str, scenario: &Scenario) {
    let mut simulation = Simulation::new(scenario.setup().unwrap());
    let run = simulation.run(|_| true);
    assert_eq!(run.status, Ok(()), "{name}");
    let largest = |variable: &str| {
        let channel = simulation.channels().iter().find(|channel| channel.variable == variable).unwrap();
        let values = run.rows.chunks(run.columns).flat_map(|row| &row[channel.offset..][..channel.len]);
        values.fold(0.0_f64, |most, value| most.max(value.abs()))
    };
    let (energy, momentum) = (largest("energy_error"), largest("momentum_error"));
    let in_play = largest("kinetic_energy");
    assert!(energy < 1e-4 * in_play, "{name}: {energy:e} J of {in_play:e} J");
    let turning = in_play / largest("angular_velocity");
    assert!(momentum < 1e-4 * turning, "{name}: {momentum:e} N m s of {turning:e} N m s");
}
