//! Ships in waves on a soft hold, and the warnings about ships that nothing holds.

use crate::common;

use super::vessel;
use common::values;
use core::f64::consts::{FRAC_PI_4, PI, TAU};
use kingpost::elements::{SoftHold, of_kind};
use kingpost::scenario::{Scenario, ScenarioError};
use kingpost::sea::database::Database;
use kingpost::simulation::{Run, Simulation, Warning};
use serde_json::{Value, json};

/// The gallery's vessel without its crane: its centre of gravity over the centre of buoyancy of the data.
const TEXT: &str = "
version: 1
title: A vessel in waves
simulation: {step_s: 0.1, duration_s: 120, record_every_s: 0.5}
sea: {waves: {}}
bodies:
  hull:
    mass_kg: 1
    inertia: {radii_of_gyration: {radii_m: [6.8, 20, 20]}}
    joint: {floating: {}}
forces:
  gravity: {gravity: {}}
  water: {hydrodynamics: {body: hull, database: vessel.hydro.json, origin_m: [0, 0, 5.5]}}
";

fn read(more: &[(&str, Value)]) -> Result<Scenario, ScenarioError> {
    vessel::read(TEXT, more)
}

fn simulation(more: &[(&str, Value)]) -> Simulation {
    let scenario = read(more).unwrap_or_else(|error| panic!("{error}"));
    Simulation::new(scenario.setup().unwrap_or_else(|error| panic!("{error}")))
}

fn waves(height_m: f64, direction_rad: f64) -> (&'static str, Value) {
    let swell = json!({"regular": {"height_m": height_m, "period_s": 8.0, "direction_rad": direction_rad}});
    ("sea.waves", json!({"swell": swell}))
}

const DRIFT: (&str, Value) = ("forces.water.hydrodynamics.wave_drift", Value::Bool(true));

fn hold(more: &Value) -> (&'static str, Value) {
    let mut hold = json!({"body": "hull"});
    hold.as_object_mut().expect("fields").extend(more.as_object().expect("fields").clone());
    ("forces.hold", json!({"soft_hold": hold}))
}

/// Weights whose sum is 1.
fn hann(k: usize, steps: usize) -> f64 {
    (1.0 - libm::cos(TAU * k as f64 / steps as f64)) / steps as f64
}

/// In a head sea the offset is D of the database, per amplitude squared, over the stiffness. First-order
/// loads leave a mean of 5 % of D at most (`slow_motion.rs`); the remainder of the swing at the start, damped
/// by 0.7, is below 1e-6.
#[test]
fn the_offset_of_a_ship_in_mean_drift_is_the_drift_over_the_stiffness() {
    let springs = json!({"natural_periods_s": [60, 60, 60], "damping_ratios": [0.7, 0.7, 0.7]});
    let mut ship = simulation(&[waves(2.0, PI), DRIFT, hold(&springs)]);
    let stiffness = of_kind::<f64, SoftHold>(ship.elements()).next().expect("a hold").stiffness;
    ship.step(2_000).expect("it runs");
    let (steps, mut mean) = (1_600, [0.0; 3]);
    for k in 0..steps {
        mean.iter_mut().zip(values(&mut ship, "hold_deviation")).for_each(|(sum, x)| *sum += hann(k, steps) * x);
        ship.step(1).expect("it runs");
    }
    let database = Database::read(vessel::DATABASE).expect("it reads");
    let astern = libm::round(PI / database.wave_directions_rad[1]) as usize;
    let drift = database.mean_drift(TAU / 8.0)[astern][0];
    assert!(drift < -1000.0 && (mean[0] * stiffness[0] / drift - 1.0).abs() < 0.05, "{mean:?} {drift}");
    assert!(mean[1].abs() < 1e-6 && mean[2].abs() < 1e-8, "{mean:?}");
}

fn run(more: &[(&str, Value)]) -> Run {
    simulation(more).run(|_| true)
}

fn of_heading(run: &Run) -> Vec<&Warning> {
    run.warnings.iter().filter(|warning| warning.text.contains("mean heading")).collect()
}

/// Time and mean heading of each row (s, deg) by its integral, `e^(-t/T) psi(0) + Int e^(-(t - s)/T) psi(s) ds / T`, T 100 s.
fn mean_headings(run: &Run, yaw: usize) -> Vec<[f64; 2]> {
    let rows: Vec<[f64; 2]> = run.rows.chunks(run.columns).map(|row| [row[0], row[yaw].to_degrees()]).collect();
    let mean = |&[end_s, _]: &[f64; 2]| {
        let weight = |time_s: f64| libm::exp((time_s - end_s) / 100.0);
        let until = rows.windows(2).filter(|pair| pair[1][0] <= end_s);
        let parts = until.map(|pair| {
            let [[from_s, from], [to_s, to]] = [pair[0], pair[1]];
            0.5 * (to_s - from_s) * (weight(from_s) * from + weight(to_s) * to) / 100.0
        });
        [end_s, weight(0.0) * rows[0][1] + parts.sum::<f64>()]
    };
    rows.iter().map(mean).collect()
}

/// Rows are half a second apart, in which the ship turns by a quarter of a degree.
#[test]
fn a_ship_that_turns_in_waves_gives_a_warning_and_a_held_ship_does_not() {
    let rate = ("bodies.hull.joint.floating.initial.angular_velocity_rad_s", json!([0.0, 0.0, f64::to_radians(0.5)]));
    let mut turning = simulation(&[waves(0.2, PI), rate.clone()]);
    let yaw = turning.channels().iter().find(|channel| channel.variable == "yaw").expect("a yaw").offset;
    let free = turning.run(|_| true);
    let means = mean_headings(&free, yaw);
    let beyond_s = means.iter().find(|[_, mean]| *mean > 5.0).expect("it turns")[0];
    let [warning] = of_heading(&free)[..] else { panic!("{:?}", free.warnings) };
    assert!(warning.name == "hull" && (warning.time_s - beyond_s).abs() < 1.0, "{warning:?} {beyond_s}");
    let turned: f64 = warning.text.split(' ').nth(5).and_then(|word| word.parse().ok()).expect("a number");
    let expected = means[means.len() - 1][1];
    assert!(expected > 10.0 && (turned - expected).abs() < 0.15, "{} {expected}", warning.text);
    let what_to_do = "to keep the heading, hold it, by soft_hold, spring_line, catenary_line or dynamic_positioning";
    assert!(warning.text.ends_with(what_to_do), "{}", warning.text);
    let held = run(&[waves(2.0, FRAC_PI_4), hold(&json!({}))]);
    assert!(of_heading(&held).is_empty(), "{:?}", held.warnings);
    let in_still_water = run(&[rate]);
    assert!(of_heading(&in_still_water).is_empty(), "{:?}", in_still_water.warnings);
}

fn under_pressure<'a>(more: &[(&'a str, Value)]) -> Vec<(&'a str, Value)> {
    let of_water = [
        waves(1.0, PI),
        ("forces.water.hydrodynamics.hydrostatics", json!("mesh")),
        ("forces.water.hydrodynamics.wave_pressure", json!(true)),
    ];
    of_water.into_iter().chain(more.iter().cloned()).collect()
}

fn line(first: &str, second: &str) -> Value {
    json!({"spring_line": {
        "first": {"body": first, "position_m": [140.0, 0.0, 0.0]}, "second": {"body": second, "position_m": [40.0, 0.0, 5.5]},
        "unstretched_length_m": 90.0, "axial_stiffness_N": 1.8e6,
    }})
}

#[test]
fn a_free_ship_in_the_waves_pressure_is_refused() {
    let told = |more: &[(&str, Value)]| {
        let error = read(&under_pressure(more)).and_then(|scenario| scenario.setup().map(|_| ())).expect_err("refused");
        (error.field.clone(), error.to_string())
    };
    let boat =
        ("bodies.boat", json!({"mass_kg": 1e5, "shape": {"sphere": {"radius_m": 2}}, "joint": {"floating": {}}}));
    for more in [vec![], vec![("forces.tow", line("boat", "hull")), boat]] {
        let (field, words) = told(&more);
        assert_eq!(field, "forces.water.hydrodynamics.wave_pressure");
        assert!(words.contains("nothing holds hull in surge, sway and yaw"), "{words}");
        assert!(words.contains("allowed: a ship that is held (hold it, by soft_hold, "), "{words}");
    }
}

#[test]
fn a_held_ship_in_the_waves_pressure_is_not_refused() {
    let crane = json!({"parent": "hull", "mass_kg": 1e3, "shape": {"point": {}}, "joint": {"fixed": {}}});
    let boat = json!({"mass_kg": 1e5, "shape": {"sphere": {"radius_m": 2}}, "joint": {"floating": {"hold_translation": true}}});
    let held: [Vec<(&str, Value)>; 5] = [
        vec![hold(&json!({}))],
        vec![("forces.mooring", line("world", "hull"))],
        vec![("bodies.crane", crane), ("forces.mooring", line("world", "crane"))],
        vec![("bodies.boat", boat), ("forces.tow", line("boat", "hull"))],
        vec![("bodies.hull.joint.floating.hold_translation", json!(true))],
    ];
    for more in held {
        read(&under_pressure(&more)).and_then(|scenario| scenario.setup()).unwrap_or_else(|error| panic!("{error}"));
    }
    let free = [("forces.water.hydrodynamics.excitation", json!(false))];
    read(&under_pressure(&free)).expect("no waves act on it");
}
