//! Mean drift of waves on a moving hull against Aranha's formula, and the report of `check` about a current.

use crate::common;

use common::barge::{self, GRAVITY, LENGTH};
use common::values;
use core::f64::consts::{PI, TAU};
use kingpost::scenario::{Files, Scenario, ScenarioError, read_with};
use kingpost::simulation::Simulation;
use serde_json::{Value, json};

/// D of surge and sway and of yaw, per amplitude squared: of second order in the frequency, whose slope is then exact between
/// the frequencies of the data, and of few harmonics.
fn mean_drift(omega: f64, direction: f64) -> [f64; 3] {
    let square = 4e4 * omega * omega;
    let shape = |m: f64| libm::cos(m * direction);
    [
        square * (shape(1.0) + 0.3 * shape(3.0)),
        square * (1.5 * libm::sin(direction) - 0.2 * libm::sin(2.0 * direction)),
        square * LENGTH * 0.1 * libm::sin(2.0 * direction),
    ]
}

fn files() -> Files {
    let mut database: Value = serde_json::from_str(&barge::database()).expect("it is JSON");
    let numbers = |name: &str| -> Vec<f64> {
        database[name].as_array().expect("a list").iter().filter_map(Value::as_f64).collect()
    };
    let (omegas, directions) = (numbers("frequencies_rad_s"), numbers("wave_directions_rad"));
    let at = |omega: &f64| directions.iter().map(|b| mean_drift(*omega, *b)).collect::<Vec<_>>();
    database["mean_drift"] = json!(omegas.iter().map(at).collect::<Vec<_>>());
    Files::new([("barge.hydro.json".to_owned(), database.to_string())])
}

const WATER: &str = "forces.water.hydrodynamics";
const HEADING_RAD: f64 = 0.3;
const OMEGA: f64 = 1.2;
const DIRECTION_RAD: f64 = 2.5;
const AMPLITUDE_M: f64 = 0.8;

fn read(more: &[(&str, Value)]) -> Result<Scenario, ScenarioError> {
    let initial = "bodies.hull.joint.floating.initial";
    let wave = json!({"height_m": 2.0 * AMPLITUDE_M, "period_s": TAU / OMEGA, "direction_rad": DIRECTION_RAD});
    let mut overrides = vec![
        (format!("{WATER}.wave_drift"), json!(true)),
        (format!("{WATER}.wave_drift_damping"), json!(true)),
        ("sea.waves".to_owned(), json!({"swell": {"regular": wave}})),
        (format!("{initial}.orientation_rad"), json!([0.0, 0.0, HEADING_RAD])),
    ];
    overrides.extend(more.iter().map(|(name, value)| ((*name).to_owned(), value.clone())));
    read_with(barge::TEXT, "barge.yaml", &overrides, &files())
}

/// Mean drift in surge, sway and yaw at the start of a run with a velocity in the world, in a current.
fn drift(velocity: [f64; 2], current: [f64; 2]) -> [f64; 3] {
    let [x, y] = velocity;
    let more =
        [("bodies.hull.joint.floating.initial.velocity_m_s", json!([x, y, 0.0])), ("sea.current_m_s", json!(current))];
    let scenario = read(&more).unwrap_or_else(|error| panic!("{error}"));
    let mut simulation = Simulation::new(scenario.setup().unwrap_or_else(|error| panic!("{error}")));
    let found = values(&mut simulation, "drift_force");
    [found[0], found[1], found[5]]
}

/// D(V) = (1 - 4 (w / g) V.e) D(w - k Vg.e, b + 2 (w / g) (V x e)) with V through the water and Vg over ground (Aranha, J. Fluid
/// Mech. 272, 1994, p. 147), whole; the moment of yaw as at rest.
fn aranha(velocity: [f64; 2], current: [f64; 2]) -> [f64; 3] {
    let (sin, cos) = libm::sincos(DIRECTION_RAD);
    let through = [velocity[0] - current[0], velocity[1] - current[1]];
    let (along, aside) = (through[0] * cos + through[1] * sin, through[0] * sin - through[1] * cos);
    let over_ground = velocity[0] * cos + velocity[1] * sin;
    let by_gravity = OMEGA / GRAVITY;
    let omega = OMEGA - OMEGA * by_gravity * over_ground;
    let [surge, sway, _] = mean_drift(omega, DIRECTION_RAD - HEADING_RAD + 2.0 * by_gravity * aside);
    let [.., yaw] = mean_drift(OMEGA, DIRECTION_RAD - HEADING_RAD);
    let factor = 1.0 - 4.0 * by_gravity * along;
    [factor * surge, factor * sway, yaw].map(|drift| AMPLITUDE_M * AMPLITUDE_M * drift)
}

/// The engine uses the first order: the difference of two velocities is compared with that of the formula;
/// the remaining terms of third order are (w V / g)^2 of it at 1 cm/s.
#[test]
fn the_drift_changes_with_the_velocity_by_aranhas_formula() {
    let at_rest = drift([0.0; 2], [0.0; 2]);
    for (found, expected) in at_rest.iter().zip(aranha([0.0; 2], [0.0; 2])) {
        assert!((found / expected - 1.0).abs() < 1e-6, "{found} {expected}");
    }
    let size = at_rest[0].hypot(at_rest[1]);
    for direction in [0.0, 1.0, 2.5, 4.0] {
        let v = |size: f64| [size * libm::cos(direction), size * libm::sin(direction)];
        for (of_ship, of_water) in [(1.0, 0.0), (0.0, 1.0), (1.0, -0.5)] {
            let both =
                |of: &dyn Fn([f64; 2], [f64; 2]) -> [f64; 3], size: f64| of(v(of_ship * size), v(of_water * size));
            let (ahead, astern) = (both(&drift, 0.01), both(&drift, -0.01));
            let (there, back) = (both(&aranha, 0.01), both(&aranha, -0.01));
            for mode in 0..2 {
                let (found, expected) = ((ahead[mode] - astern[mode]) / 0.02, (there[mode] - back[mode]) / 0.02);
                assert!((found - expected).abs() < 1e-5 * size, "{direction} {mode}: {found} {expected}, of {size}");
            }
            assert!((ahead[2] - at_rest[2]).abs() < 1e-6 * at_rest[2].abs());
        }
    }
}

/// A ship that moves against the waves has more drift, one that moves with them less: slow surge is damped,
/// and a current along the waves adds to the drift.
#[test]
fn slow_motions_are_damped_and_a_current_with_the_waves_adds_to_the_drift() {
    let (sin, cos) = libm::sincos(DIRECTION_RAD);
    let along = |[x, y, _]: [f64; 3]| {
        let (s, c) = libm::sincos(HEADING_RAD);
        cos * (c * x - s * y) + sin * (s * x + c * y)
    };
    let none = [0.0; 2];
    let (still, against) = (along(drift(none, none)), along(drift([-0.5 * cos, -0.5 * sin], none)));
    let (with, in_current) = (along(drift([0.5 * cos, 0.5 * sin], none)), along(drift(none, [0.5 * cos, 0.5 * sin])));
    assert!(with < still && still < against && still < in_current, "{with} {still} {against} {in_current}");
}

/// Checks that the reported drift acts: without added mass and radiation the centre of a free hull
/// accelerates by the force over its mass.
#[test]
fn the_drift_of_a_moving_hull_acts_on_it() {
    let velocity = json!([0.4, -0.3, 0.0]);
    let with = |damping: bool| {
        let more = [
            ("bodies.hull.joint.floating.initial.velocity_m_s", velocity.clone()),
            ("forces.water.hydrodynamics.wave_drift_damping", json!(damping)),
            ("forces.water.hydrodynamics.added_mass", json!(false)),
            ("forces.water.hydrodynamics.radiation", json!(false)),
        ];
        let scenario = read(&more).unwrap_or_else(|error| panic!("{error}"));
        let mut moving = Simulation::new(scenario.setup().unwrap_or_else(|error| panic!("{error}")));
        let drift = values(&mut moving, "drift_force");
        let (sin, cos) = libm::sincos(HEADING_RAD);
        let in_world = [cos * drift[0] - sin * drift[1], sin * drift[0] + cos * drift[1]];
        let momentum = moving.acceleration(None).expect("accelerations");
        ([momentum[0], momentum[1]], in_world)
    };
    let ((moved, force), (plain, without)) = (with(true), with(false));
    for axis in 0..2 {
        let (force, acceleration) = (force[axis] - without[axis], moved[axis] - plain[axis]);
        assert!(force.abs() > 100.0 && force * acceleration > 0.0, "{force} {acceleration}");
    }
    // The hull carries what stands on it: both directions by the same mass, to what the crane's joints give way.
    let masses = [0, 1].map(|axis| (force[axis] - without[axis]) / (moved[axis] - plain[axis]));
    assert!(masses.iter().all(|mass| (3.9e5..4.3e5).contains(mass)), "{masses:?} kg");
}

#[test]
fn drift_damping_without_mean_drift_is_refused() {
    let error = read(&[(&format!("{WATER}.wave_drift"), json!(false))]).and_then(|scenario| scenario.setup().map(drop));
    let words = error.expect_err("it is refused").to_string();
    assert!(words.contains("wave_drift_damping: found true, without wave_drift"), "{words}");
}

fn warnings(more: &[(&str, Value)]) -> Vec<String> {
    let scenario = read(more).unwrap_or_else(|error| panic!("{error}"));
    let found = scenario.hydrostatic_report().unwrap_or_else(|error| panic!("{error}")).warnings;
    found.into_iter().filter(|words| words.contains("current")).collect()
}

/// 2 U w cos / g of the lengths, 4 (w / g) U cos of the drift and the effect of the changed direction: the
/// magnitudes of the formulas.
#[test]
fn the_check_reports_the_change_of_wave_length_and_drift_by_a_current() {
    let current = 0.6;
    let with_waves = json!([current * libm::cos(DIRECTION_RAD), current * libm::sin(DIRECTION_RAD)]);
    assert!(warnings(&[]).is_empty());
    let found = warnings(&[("sea.current_m_s", with_waves.clone())]);
    let [length] = found.as_slice() else { panic!("{found:?}") };
    let percent = 100.0 * 2.0 * current * OMEGA / GRAVITY;
    assert!(
        length.contains("a current of 0.60 m/s would make them") && length.contains(&format!("{percent:.1} % longer"))
    );

    let undamped = (format!("{WATER}.wave_drift_damping"), json!(false));
    let found = warnings(&[("sea.current_m_s", with_waves), (&undamped.0, undamped.1.clone())]);
    let [_, drift_words] = found.as_slice() else { panic!("{found:?}") };
    let (still, moved) = (drift([0.0; 2], [0.0; 2]), {
        let (x, y) = (current * libm::cos(DIRECTION_RAD), current * libm::sin(DIRECTION_RAD));
        drift([0.0; 2], [x, y])
    });
    for of in [still, moved] {
        let force = format!("surge {:.1} kN, sway {:.1} kN", of[0] / 1000.0, of[1] / 1000.0);
        assert!(drift_words.contains(&force), "{drift_words}: {force}");
    }
    let percent = 100.0 * 4.0 * current * OMEGA / GRAVITY;
    assert!(drift_words.contains(&format!("by {percent:.0} %: wave_drift_damping")), "{drift_words}: {percent}");

    let aside = json!([current * libm::cos(DIRECTION_RAD + PI / 2.0), current * libm::sin(DIRECTION_RAD + PI / 2.0)]);
    let found = warnings(&[("sea.current_m_s", aside)]);
    assert!(found.is_empty(), "{found:?}");
}
