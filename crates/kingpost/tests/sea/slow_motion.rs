//! A drifting hull: which of its loads depend on the flow of water, on its slowly varying position, and on
//! second-order effects.

use crate::common;

use super::vessel;
use common::values;
use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};
use kingpost::elements::hull::Radiation;
use kingpost::scenario::{Scenario, ScenarioError};
use kingpost::sea::database::Database;
use kingpost::simulation::Simulation;
use serde_json::{Value, json};

/// The gallery's vessel without its crane: its centre of gravity over the centre of buoyancy of the data.
const TEXT: &str = "
version: 1
title: A vessel adrift
simulation: {step_s: 0.05, duration_s: 60, record_every_s: 0.5}
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

const CURRENT: &str = "sea.current_m_s";
const VELOCITY: &str = "bodies.hull.joint.floating.initial.velocity_m_s";

fn read(more: &[(&str, Value)]) -> Result<Scenario, ScenarioError> {
    vessel::read(TEXT, more)
}

fn simulation(more: &[(&str, Value)]) -> Simulation {
    let scenario = read(more).unwrap_or_else(|error| panic!("{error}"));
    Simulation::new(scenario.setup().unwrap_or_else(|error| panic!("{error}")))
}

fn regular(period_s: f64, direction_rad: f64) -> (&'static str, Value) {
    (
        "sea.waves",
        json!({"swell": {"regular": {"height_m": 2.0, "period_s": period_s, "direction_rad": direction_rad}}}),
    )
}

/// Springs that hold the vessel in the plane, soft compared with the waves: periods of a minute or two.
fn moored() -> Vec<(&'static str, Value)> {
    let line = |from: [f64; 2], to: [f64; 2]| {
        json!({"spring_line": {
            "first": {"body": "world", "position_m": [from[0], from[1], 0.0]},
            "second": {"body": "hull", "position_m": [to[0], to[1], 5.5]},
            "unstretched_length_m": 90.0, "axial_stiffness_N": 1.8e6,
        }})
    };
    vec![
        ("forces.ahead", line([145.0, 0.0], [40.0, 0.0])),
        ("forces.astern", line([-145.0, 0.0], [-40.0, 0.0])),
        ("forces.to_port", line([0.0, 115.0], [0.0, 9.0])),
        ("forces.to_starboard", line([0.0, -115.0], [0.0, -9.0])),
    ]
}

/// Galilean invariance: relative to the water, a vessel that drifts with the current is at rest in still
/// water, and one with a velocity relative to the current moves like one with that velocity in still water.
#[test]
fn a_ship_drifting_with_the_current_moves_like_one_in_still_water() {
    let (cx, cy) = (1.0, 0.7);
    let mut adrift = simulation(&[(CURRENT, json!([cx, cy])), (VELOCITY, json!([cx, cy, 0.0]))]);
    adrift.step(1200).expect("it runs");
    assert!(adrift.state().v.iter().skip(3).all(|rate| rate.abs() < 1e-9), "{:?}", adrift.state().v);

    let mut in_current = simulation(&[(CURRENT, json!([cx, cy])), (VELOCITY, json!([cx + 0.8, cy + 0.5, 0.3]))]);
    let mut still = simulation(&[(VELOCITY, json!([0.8, 0.5, 0.3]))]);
    in_current.step(1200).expect("it runs");
    still.step(1200).expect("it runs");
    // The axes of the memory turn by a filter that steps, but turn alike.
    let (moved, at_rest) = (&in_current.state().q, &still.state().q);
    let drifted = [cx * 60.0, cy * 60.0, 0.0];
    for k in 0..moved.len() {
        let expected = at_rest[k] + drifted.get(k).copied().unwrap_or(0.0);
        assert!((moved[k] - expected).abs() < 1e-7, "{k}: {} {expected}", moved[k]);
    }
    assert!(still.state().q[3..].iter().any(|q| q.abs() > 0.05), "it turns by Munk's moment: {:?}", still.state().q);
}

/// Checks that a steady current exerts no force on the springs from the start: potential flow has no drag.
#[test]
fn a_run_that_begins_at_equilibrium_in_a_current_stays_there() {
    let mut more = moored();
    more.push((CURRENT, json!([0.3, 1.5])));
    more.push(("simulation.begin_at_equilibrium", json!(true)));
    let mut ship = simulation(&more);
    let start = ship.state().q.clone();
    ship.step(1200).expect("it runs");
    for (now, start) in ship.state().q.iter().zip(&start) {
        assert!((now - start).abs() < 1e-6, "{now} {start}");
    }
}

/// Munk's moment -(A22 - A11) u v turns a ship that moves obliquely, with the added mass of slow motions; a table of current
/// coefficients has it in its own yaw moment (Faltinsen 1990, ch. 6), so that beside one, even of zeros, there is none.
#[test]
fn munks_moment_occurs_once_with_the_added_mass_at_zero_frequency() {
    let obliquely = (VELOCITY, json!([0.8, 0.5, 0.0]));
    let database = Database::read(vessel::DATABASE).expect("it reads");
    let remembered = Radiation::new(database.radiation.as_ref().expect("it has a memory")).added_mass();
    let a = |k: usize| database.added_mass_infinite[k][k] + remembered[k][k];
    let table = json!({
        "directions_deg": [0, 90, 180], "symmetric": true, "surge": [0, 0, 0], "sway": [0, 0, 0], "yaw": [0, 0, 0],
        "frontal_area_m2": 100, "lateral_area_m2": 440, "length_m": 80,
    });
    let tide = json!({"current_load": {"body": "hull", "position_m": [0, 0, 5.5], "coefficients": table}});
    let mut free = simulation(core::slice::from_ref(&obliquely));
    let mut by_table = simulation(&[obliquely, ("forces.tide", tide)]);
    let difference = by_table.moving_frame().f_star - free.moving_frame().f_star;
    let moment = -(a(1) - a(0)) * 0.8 * 0.5;
    assert!(moment.abs() > 1e5 && (difference[5] + moment).abs() < 1e-9 * moment.abs(), "{difference} {moment}");
    assert!((0..5).all(|k| difference[k].abs() < 1e-6));
}

/// The limit of the fit at frequency zero goes on from the data: A is even in the frequency, so that its parabola through the
/// three lowest ends there. The fit may miss A by its own error, 2 % of the peak.
#[test]
fn the_memory_takes_up_the_added_mass_of_slow_motions() {
    let database = Database::read(vessel::DATABASE).expect("it reads");
    let remembered = Radiation::new(database.radiation.as_ref().expect("it has a memory")).added_mass();
    for k in [0, 1, 5] {
        let at = |i: usize| (database.frequencies_rad_s[i].powi(2), database.added_mass[i][k][k]);
        let ((x0, y0), (x1, y1), (x2, y2)) = (at(0), at(1), at(2));
        let limit = y0 * x1 * x2 / ((x0 - x1) * (x0 - x2))
            + y1 * x0 * x2 / ((x1 - x0) * (x1 - x2))
            + y2 * x0 * x1 / ((x2 - x0) * (x2 - x1));
        let peak = database.added_mass.iter().map(|a| a[k][k]).fold(0.0, f64::max);
        let found = database.added_mass_infinite[k][k] + remembered[k][k];
        assert!((found - limit).abs() < 0.02 * peak, "mode {k}: {found}, {limit} by the data");
    }
}

/// Returns X2's amplitude per metre and D of surge, sway and yaw at a direction of the database's grid.
fn data(period_s: f64, direction_rad: f64) -> (f64, [f64; 3]) {
    let database = Database::read(vessel::DATABASE).expect("it reads");
    let at = libm::round(direction_rad / database.wave_directions_rad[1]) as usize;
    let omega = TAU / period_s;
    let x = database.excitation(omega, true)[at];
    let size = |mode: usize| libm::hypot(x[mode][0], x[mode][1]);
    (size(0).max(size(1)), database.mean_drift(omega)[at])
}

/// The filter of the slow place lets |H| = 6 (w / omega)^5 of the waves' motion through, which as the phase of the loads
/// makes a mean force of at most k |H| X a / 2 of a place that moves by the waves' height, and as much of the heading.
fn let_through(period_s: f64, direction_rad: f64) -> f64 {
    let omega = TAU / period_s;
    let (size, _) = data(period_s, direction_rad);
    omega * omega / 9.80665 * 6.0 * libm::pow(0.075 / omega, 5.0) * size
}

#[test]
fn first_order_loads_leave_no_mean_force() {
    for (period_s, direction_rad) in [(8.0, FRAC_PI_4), (10.0, FRAC_PI_4), (8.0, FRAC_PI_2), (8.0, PI)] {
        let mut more = moored();
        more.push(regular(period_s, direction_rad));
        // Slow motions die out before the mean is taken.
        let damping = json!({"body": "hull", "linear_N_s_m": [1e5, 1e5, 0], "angular_N_m_s": [1.6e7, 0, 5e7]});
        more.push(("forces.damping", json!({"viscous_damping": damping})));
        let mut ship = simulation(&more);
        ship.step(40_000).expect("it runs");
        let steps = 20_000;
        let mut mean = [0.0; 6];
        for k in 0..steps {
            // Periods need not be whole.
            mean.iter_mut().zip(values(&mut ship, "excitation_force")).for_each(|(sum, x)| *sum += hann(k, steps) * x);
            ship.step(1).expect("it runs");
        }
        let (_, drift) = data(period_s, direction_rad);
        let bound = let_through(period_s, direction_rad);
        assert!(mean[0].abs() < bound && mean[1].abs() < bound, "{period_s} {direction_rad}: {mean:?} {bound}");
        if period_s == 8.0 {
            let drift = libm::hypot(drift[0], drift[1]);
            assert!(libm::hypot(mean[0], mean[1]) < 0.05 * drift, "{direction_rad}: {mean:?} {drift}");
        }
    }
}

/// Accelerations of a free ship's place (m/s^2) and yaw (rad/s^2) on average: second differences of means under Hann's
/// window, in which the waves' own motion has no part.
fn drifting(period_s: f64, direction_rad: f64, drift: bool) -> [f64; 3] {
    let wave_drift = ("forces.water.hydrodynamics.wave_drift", json!(drift));
    // Waves that began at once would push it into a steady drift.
    let mut ship = simulation(&[regular(period_s, direction_rad), ("sea.ramp_s", json!(100)), wave_drift]);
    ship.step(4_000).expect("it runs");
    let steps = 1_600;
    let mut means = [[0.0; 3]; 3];
    for mean in &mut means {
        for k in 0..steps {
            let q = &ship.state().q;
            let place = [q[0], q[1], 2.0 * libm::atan2(q[6], q[3])];
            mean.iter_mut().zip(place).for_each(|(sum, x)| *sum += hann(k, steps) * x);
            ship.step(1).expect("it runs");
        }
    }
    core::array::from_fn(|k| (means[2][k] - 2.0 * means[1][k] + means[0][k]) / 6400.0)
}

/// Weights whose sum is 1.
fn hann(k: usize, steps: usize) -> f64 {
    (1.0 - libm::cos(TAU * k as f64 / steps as f64)) / steps as f64
}

/// Mean loads in waves are of second order and all contained in D: without D a free ship neither drifts nor
/// turns.
#[test]
fn without_drift_a_free_ship_in_regular_waves_stays() {
    let database = Database::read(vessel::DATABASE).expect("it reads");
    let mass = 1025.0 * database.hull.volume_m3;
    for (period_s, direction_rad) in [(8.0, FRAC_PI_4), (10.0, FRAC_PI_4), (8.0, PI)] {
        let [x, y, yaw] = drifting(period_s, direction_rad, false);
        let (_, drift) = data(period_s, direction_rad);
        let force = mass * libm::hypot(x, y);
        assert!(force < let_through(period_s, direction_rad), "{period_s} {direction_rad}: {force} N of {drift:?}");
        let moment = (mass * 400.0 + database.added_mass_infinite[5][5]) * yaw.abs();
        assert!(moment < 0.05 * 1e5, "{period_s} {direction_rad}: {moment} N m of {drift:?}");
    }
}

/// By its symmetry a ship is not turned by head or following seas. Oblique ones turn it by D alone, which does not act here: of
/// the order of a thousandth of D is left, which in 40 minutes has turned a ship that nothing holds by some degrees, where D
/// would have turned it round.
#[test]
fn a_bare_hull_in_regular_waves_keeps_its_heading() {
    for (direction_rad, bound_deg) in [(0.0, 1e-9), (0.25 * PI, 3.0), (0.5 * PI, 3.0), (0.75 * PI, 3.0), (PI, 1e-9)] {
        let waves = json!({"swell": {"regular": {"height_m": 1.5, "period_s": 7, "direction_rad": direction_rad}}});
        let mut ship = simulation(&[("sea.waves", waves), ("sea.ramp_s", json!(100))]);
        ship.step(48_000).expect("it runs");
        let yaw = values(&mut ship, "yaw")[0].to_degrees();
        assert!(yaw.abs() < bound_deg, "{direction_rad}: {yaw} deg after 2,400 s");
    }
}

/// A load of 200 t on a pendulum over y = 10 m in a head sea, with equal ballast on the other side: its pull
/// has no mean moment about the ship, and turns the ship no more than a load that is fixed there.
#[test]
fn a_load_that_swings_over_the_side_does_not_turn_a_ship_out_of_a_head_sea() {
    let body = |joint: Value, centre: [f64; 3]| {
        json!({"parent": "hull", "mass_kg": 2e5, "inertia": {"radii_of_gyration": {"radii_m": [0.7, 0.7, 0.7]}},
            "centre_of_mass_m": centre, "joint": joint})
    };
    let ballast = body(json!({"fixed": {"position_m": [0, -10, 5]}}), [0.0, 0.0, 0.0]);
    let turned = |joint: &str| {
        let load = body(json!({joint: {"position_m": [0, 10, 25]}}), [0.0, 0.0, -20.0]);
        let loads =
            [regular(8.0, PI), ("sea.ramp_s", json!(100)), ("bodies.load", load), ("bodies.ballast", ballast.clone())];
        let mut ship = simulation(&loads);
        let mut rolled = 0.0_f64;
        for _ in 0..100 {
            ship.step(100).expect("it runs");
            rolled = rolled.max(values(&mut ship, "roll")[0].abs());
        }
        assert!(rolled < 0.1, "{joint}: it rolls by {rolled} rad");
        values(&mut ship, "yaw")[0].to_degrees()
    };
    let [swinging, fixed] = ["spherical", "fixed"].map(turned);
    assert!(swinging.abs() < 2.0 && fixed.abs() < 0.5, "{swinging} and {fixed} deg after 500 s");
}

/// D accelerates it, its added mass at low frequency with it; it runs ahead of the waves by a Doppler shift of some per cent.
#[test]
fn with_drift_a_free_ship_in_a_head_sea_is_driven_astern_by_it() {
    let database = Database::read(vessel::DATABASE).expect("it reads");
    let mass = 1025.0 * database.hull.volume_m3 + database.added_mass[0][0][0];
    let (_, drift) = data(8.0, PI);
    let [x, ..] = drifting(8.0, PI, true);
    assert!(drift[0] < -1000.0 && (mass * x / drift[0] - 1.0).abs() < 0.06, "{} {}", mass * x, drift[0]);
}

/// A ship that has yawed off its slow heading in a head sea: its pitch moment stays one, where a fifth of it would roll the ship
/// 12 times as much as it pitches, by the 60 times smaller second moment of the water plane. The surge force does push across.
#[test]
fn a_head_sea_does_not_roll_a_ship_as_it_yaws() {
    let mut ship = simulation(&[
        regular(8.0, PI),
        ("forces.water.hydrodynamics.slow_motion_cutoff_rad_s", json!(1e-12)),
        ("bodies.hull.joint.floating.initial.angular_velocity_rad_s", json!([0.0, 0.0, 0.005])),
    ]);
    let mut largest = [0.0_f64; 2];
    for _ in 0..800 {
        ship.step(1).expect("it runs");
        let turns = ["roll", "pitch"].map(|angle| values(&mut ship, angle)[0]);
        largest.iter_mut().zip(turns).for_each(|(most, turn)| *most = most.max(turn.abs()));
    }
    assert!(values(&mut ship, "yaw")[0] > 0.15);
    assert!(largest[1] > 0.02 && largest[0] < 0.1 * largest[1], "{largest:?}");
}

/// Place and attitude less their start, over the wave height, every half second from the ramp's end on.
fn motions_per_height(height_m: f64) -> Vec<[f64; 6]> {
    let jonswap = json!({"significant_height_m": height_m, "peak_period_s": 9, "gamma": 1, "direction_rad": 2.0,
                         "realisation": {"components": 60}});
    let damping = json!({"body": "hull", "angular_N_m_s": [1.6e7, 0, 0]});
    let mut ship = simulation(&[
        ("sea.waves", json!({"sea": {"jonswap": jonswap}})),
        ("sea.ramp_s", json!(60)),
        ("forces.damping", json!({"viscous_damping": damping})),
    ]);
    let place = |ship: &mut Simulation| {
        let position = values(ship, "position");
        let [roll, pitch, yaw] = ["roll", "pitch", "yaw"].map(|angle| values(ship, angle)[0]);
        [position[0], position[1], position[2], roll, pitch, yaw]
    };
    let start = place(&mut ship);
    ship.step(1_200).expect("it runs");
    let mut after = |_| {
        ship.step(10).expect("it runs");
        let now = place(&mut ship);
        core::array::from_fn(|k| (now[k] - start[k]) / height_m)
    };
    (0..600).map(&mut after).collect()
}

/// Checks that motions of second order are small in a sea of 1 m: heave, pitch and roll are those of a sea a hundred
/// times lower, scaled. Roll is resonant, and bodies that pitch and yaw do turn in roll (Euler's equations).
/// Kirchhoff's equations for the whole velocity would make 0.73 of it.
#[test]
fn motions_grow_with_the_waves() {
    let (low, high) = (motions_per_height(0.01), motions_per_height(1.0));
    for (mode, bound) in [(2, 0.005), (3, 0.15), (4, 0.01)] {
        let size = |of: &dyn Fn(usize) -> f64| (0..low.len()).map(|i| of(i) * of(i)).sum::<f64>();
        let share = libm::sqrt(size(&|i| high[i][mode] - low[i][mode]) / size(&|i| low[i][mode]));
        assert!(share < bound, "mode {mode}: {share}");
    }
}

#[test]
fn drift_together_with_wave_pressure_is_refused() {
    let both = [
        regular(8.0, PI),
        ("forces.water.hydrodynamics.hydrostatics", json!("mesh")),
        ("forces.water.hydrodynamics.wave_pressure", json!(true)),
        ("forces.water.hydrodynamics.wave_drift", json!(true)),
    ];
    let error = read(&both).and_then(|scenario| scenario.setup().map(|_| ())).expect_err("it is refused").to_string();
    assert!(error.contains("wave_drift") && error.contains("one of the two"), "{error}");
}
