//! Errors that sensors add to the true values, and the heave filter.

use crate::common;

use common::{values, with_changes};
use kingpost::batch;
use kingpost::scenario::{Files, read};
use kingpost::simulation::Simulation;
use serde_json::{Value, json};
use std::f64::consts::TAU;

/// A buoy that heaves with 1 m, 8 s on a spring, and a block at rest on a rope and a joint that does not move.
const TEXT: &str = "
version: 1
title: Sensors
simulation: {step_s: 0.01, duration_s: 4, record_every_s: 0.05}
bodies:
  buoy:
    mass_kg: 1000
    shape: {box: {length_m: 1, width_m: 1, height_m: 1}}
    joint: {prismatic: {name: heave, axis: [0, 0, 1], initial_extension_m: 1, spring: {stiffness_N_per_m: 616.8502750680849, rest_m: 15.897942169058107}}}
  block:
    mass_kg: 50
    shape: {box: {length_m: 1, width_m: 1, height_m: 1}}
    joint: {prismatic: {axis: [0, 0, 1], position_m: [5, 0, 0], damping_N_s_m: 100}}
  arm:
    mass_kg: 10
    shape: {box: {length_m: 1, width_m: 1, height_m: 1}}
    joint: {revolute: {name: turn, axis: [0, 0, 1], position_m: [9, 0, 0], initial_angle_rad: 0.3, mode: held}}
forces:
  gravity: {gravity: {}}
  sling: {rope: {path: [{point: {body: world, position_m: [5, 0, 4]}}, {point: {body: block}}], axial_stiffness_N: 1.0e6, unstretched_length_m: 3.998039631232518}}
sensors:
  mru: {motion_reference_unit: {body: buoy, period_s: 0.05}}
  cell: {load_cell: {rope: sling, period_s: 0.01}}
  encoder: {encoder: {joint: turn, period_s: 0.01}}
  reach: {linear_encoder: {joint: heave, period_s: 0.05}}
  gnss: {satellite_receiver: {body: buoy, position_m: [1, 2, 3], period_s: 0.05, delay_samples: 4}}
";

fn changed(changes: &[(&str, Value)]) -> Simulation {
    with_changes(TEXT, changes).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn sensors_without_errors_are_exact_at_their_samples() {
    let mut simulation = changed(&[]);
    simulation.step(100).unwrap();
    let near = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-6, "{found}, not {expected}");
    near(values(&mut simulation, "measured_angle")[0], 0.3);
    near(values(&mut simulation, "measured_extension")[0], (TAU / 8.0).cos());
    // Four samples of 0.05 s late.
    let place = values(&mut simulation, "measured_position");
    near(place[0], 1.0);
    near(place[1], 2.0);
    near(place[2], 3.0 + (TAU * 0.8 / 8.0).cos());
    // The rope is as long as the weight of the block needs.
    near(values(&mut simulation, "measured_tension")[0] / (50.0 * 9.80665), 1.0);
}

/// Mean and standard deviation of a signal, of independent samples.
fn moments(simulation: &mut Simulation, variable: &str, steps: usize) -> [f64; 2] {
    let (mut sum, mut squares) = (0.0, 0.0);
    for _ in 0..steps {
        simulation.step(1).unwrap();
        let value = values(simulation, variable)[0];
        sum += value;
        squares += value * value;
    }
    let mean = sum / steps as f64;
    [mean, (squares / steps as f64 - mean * mean).sqrt()]
}

/// Checks mean and deviation: with N samples the standard error of the mean is sigma / sqrt(N) and that of
/// the deviation sigma / sqrt(2 N); the limit is four of these, N = 5000.
#[test]
fn noise_and_bias_have_the_given_size() {
    let mut simulation = changed(&[
        ("sensors.encoder.encoder.errors", json!({"noise_rad": 0.01, "bias_rad": 0.05})),
        ("sensors.cell.load_cell.errors", json!({"noise_N": 7, "bias_N": -20})),
    ]);
    let [mean, deviation] = moments(&mut simulation, "measured_angle", 5000);
    assert!((mean - 0.35).abs() < 4.0 * 0.01 / 5000_f64.sqrt(), "{mean}");
    assert!((deviation - 0.01).abs() < 4.0 * 0.01 / 10_000_f64.sqrt(), "{deviation}");
    let [mean, deviation] = moments(&mut simulation, "measured_tension", 5000);
    assert!((mean - 50.0 * 9.80665 + 20.0).abs() < 4.0 * 7.0 / 5000_f64.sqrt(), "{mean}");
    assert!((deviation - 7.0).abs() < 4.0 * 7.0 / 10_000_f64.sqrt(), "{deviation}");
}

#[test]
fn a_resolution_rounds_to_the_nearest_step() {
    let mut simulation = changed(&[("sensors.reach.linear_encoder.errors", json!({"resolution_m": 0.25}))]);
    for _ in 0..80 {
        simulation.step(5).unwrap();
        let (found, truth) =
            (values(&mut simulation, "measured_extension")[0], values(&mut simulation, "joint_position")[0]);
        assert!((found / 0.25).fract() == 0.0 && (found - truth).abs() < 0.125 + 1e-9, "{found} of {truth}");
    }
}

#[test]
fn the_noise_of_sensors_differs_by_sensor_and_by_seed_and_is_repeatable() {
    let noisy = |seed: u64| {
        let errors = json!({"noise_m": 0.1});
        let mut simulation = changed(&[
            ("simulation.seed", json!(seed)),
            ("sensors.reach.linear_encoder.errors", errors.clone()),
            ("sensors.gnss.satellite_receiver.horizontal_errors", errors),
        ]);
        simulation.step(100).unwrap();
        let place = values(&mut simulation, "measured_position");
        [values(&mut simulation, "measured_extension")[0], place[0], place[1]]
    };
    assert_eq!(noisy(1), noisy(1));
    assert!(noisy(1).iter().zip(noisy(2)).all(|(one, two)| *one != two));
    let [reach, x, y] = noisy(1);
    let truth = (TAU / 8.0).cos();
    assert!(reach - truth != x - 1.0 && x - 1.0 != y - 2.0);
}

/// y / h = s^2 / (s^2 + 2 zeta w s + w^2) at the frequency of the buoy, after eight time constants.
#[test]
fn the_filter_of_heave_has_the_gain_and_the_phase_of_its_formula() {
    for cutoff_s in [5.0, 20.0] {
        let mut simulation = changed(&[(
            "sensors.mru.motion_reference_unit.heave_filter",
            json!({"cutoff_period_s": cutoff_s, "damping_ratio": 0.7}),
        )]);
        let (own, frequency): (f64, f64) = (TAU / cutoff_s, TAU / 8.0);
        let gone_s = 8.0 * (4.0 * cutoff_s / 8.0).ceil();
        simulation.step((100.0 * gone_s) as usize).unwrap();
        let [mut cosine, mut sine] = [0.0; 2];
        for k in 0..160 {
            let angle = TAU * f64::from(k) / 160.0;
            let heave = values(&mut simulation, "measured_heave")[0];
            cosine += heave * angle.cos() / 80.0;
            sine -= heave * angle.sin() / 80.0;
            simulation.step(5).unwrap();
        }
        let below = [own * own - frequency * frequency, 2.0 * 0.7 * own * frequency];
        let gain = frequency * frequency / below[0].hypot(below[1]);
        // -omega^2 over the denominator.
        let phase = std::f64::consts::PI - below[1].atan2(below[0]);
        let (found, lead) = (cosine.hypot(sine), sine.atan2(cosine));
        // e^(-zeta w t) of the start is left, and RK4 errs by (w h)^4.
        let left = 4.0 * (-0.7 * own * gone_s).exp() + 1e-5;
        assert!((found - gain).abs() < left, "{cutoff_s} s: gain {found}, not {gain}");
        assert!((lead - phase).abs() < left, "{cutoff_s} s: phase {lead}, not {phase}");
    }
}

const FILTER: &str = "sensors.mru.motion_reference_unit.heave_filter";
const WITH_RECEIVER: &str = r#"{"cutoff_period_s": 12, "damping_ratio": 0.7, "receiver": "gnss"}"#;

/// Largest error of the measured heave, m, and of its rate, m/s, after 60 s.
fn off_the_truth(simulation: &mut Simulation) -> [f64; 2] {
    simulation.step(6000).unwrap();
    let mut most = [0.0_f64; 2];
    for _ in 0..160 {
        simulation.step(5).unwrap();
        let truth = [values(simulation, "joint_position")[0] - 1.0, values(simulation, "joint_velocity")[0]];
        let found = ["measured_heave", "measured_heave_rate"].map(|signal| values(simulation, signal)[0]);
        most = [0, 1].map(|k| most[k].max((found[k] - truth[k]).abs()));
    }
    most
}

/// The filter alone takes more than a third of 1 m away. With the receiver, whose positions are up to a + T = 0.25 s old, what is
/// left is their curvature over that time, (w (a + T))^2 / 2, as far as the complement of the filter passes it: below 1.1.
#[test]
fn a_satellite_receiver_restores_the_heave_that_the_filter_removes() {
    let [alone, _] = off_the_truth(&mut changed(&[(FILTER, json!({"cutoff_period_s": 12}))]));
    assert!(alone > 0.35, "{alone} m");
    let with: Value = serde_json::from_str(WITH_RECEIVER).unwrap();
    let [heave, rate] = off_the_truth(&mut changed(&[(FILTER, with)]));
    let w = TAU / 8.0;
    let allowed = 1.1 * (w * 0.25_f64).powi(2) / 2.0;
    assert!(heave < allowed, "{heave} m, allowed {allowed}");
    assert!(rate < w * allowed, "{rate} m/s, allowed {}", w * allowed);
}

/// White noise of 0.02 m at 20 Hz passes the complement of the filter in its noise bandwidth, w (zeta + 1 / (4 zeta)) rad/s, as
/// 0.02 m sqrt(2 B T) < 3 mm: five of these. An offset of a receiver is no heave.
#[test]
fn noise_and_offset_of_a_receiver_hardly_reach_the_heave() {
    let with: Value = serde_json::from_str(WITH_RECEIVER).unwrap();
    let errors = json!({"noise_m": 0.02, "bias_m": 40});
    let exact = off_the_truth(&mut changed(&[(FILTER, with.clone())]));
    let noisy = off_the_truth(&mut changed(&[
        (FILTER, with),
        ("sensors.gnss.satellite_receiver.vertical_errors", errors.clone()),
    ]));
    // The first position sets the zero, with its noise.
    let first = 4.0 * 0.02;
    assert!(noisy[0] < exact[0] + 5.0 * 0.003 + first, "{noisy:?}, exact {exact:?}");
    assert!(noisy[1] < exact[1] + 0.05, "{noisy:?}, exact {exact:?}");
}

#[test]
fn a_unit_continues_its_heave_estimate_while_its_receiver_has_no_signal() {
    let with: Value = serde_json::from_str(WITH_RECEIVER).unwrap();
    let drop_outs = json!({"mean_interval_s": 10, "mean_duration_s": 10});
    let mut simulation = changed(&[(FILTER, with), ("sensors.gnss.satellite_receiver.drop_outs", drop_outs)]);
    let [heave, _] = off_the_truth(&mut simulation);
    let out = simulation.events().iter().filter(|event| event.what == "drops out").count();
    assert!(out > 1, "{out}");
    // It has kept the motion that it knew, and its error of 1 to 2 %, for the outage.
    assert!(heave < 0.1, "{heave} m");
}

/// A sensor is out for the share D / (D + M) of the time; 20 000 samples hold some 300 drop-outs, so that the share is known
/// to some 8 %.
#[test]
fn a_sensor_that_drops_out_holds_its_last_value_and_reports_it() {
    let mut simulation = changed(&[(
        "sensors.encoder.encoder",
        json!({"joint": "turn", "period_s": 0.01, "errors": {"noise_rad": 0.01}, "drop_outs": {"mean_interval_s": 0.5, "mean_duration_s": 0.1}}),
    )]);
    let (mut out, mut last) = (0.0, f64::NAN);
    for _ in 0..20_000 {
        simulation.step(1).unwrap();
        let (status, angle) =
            (values(&mut simulation, "sensor_status")[0], values(&mut simulation, "measured_angle")[0]);
        assert_eq!(status == 0.0, angle == last);
        out += 1.0 - status;
        last = angle;
    }
    let share = out / 20_000.0;
    assert!((share / (0.1 / 0.6) - 1.0).abs() < 0.25, "{share}");
    let begun = simulation.events().iter().filter(|event| event.what == "drops out").count();
    let ended = simulation.events().iter().filter(|event| event.what == "delivers again").count();
    assert!(begun > 200 && begun - ended <= 1, "{begun}, {ended}");
}

#[test]
fn noisy_runs_in_lanes_have_the_rows_of_single_runs() {
    let variant = |noise: f64| -> batch::Variant {
        vec![
            ("sensors.encoder.encoder.errors".to_owned(), json!({"noise_rad": noise, "bias_rad": 0.1 * noise})),
            ("sensors.cell.load_cell.errors".to_owned(), json!({"noise_N": 100.0 * noise})),
            ("sensors.gnss.satellite_receiver.vertical_errors".to_owned(), json!({"noise_m": noise})),
            (
                "sensors.mru.motion_reference_unit.heave_filter".to_owned(),
                json!({"cutoff_period_s": 3.0 + noise, "receiver": "gnss"}),
            ),
        ]
    };
    let variants: Vec<_> = [0.0, 0.1, 0.2, 0.3, 0.4, 0.5].map(variant).to_vec();
    for threads in [1, 2] {
        let batch =
            batch::run(TEXT, "sensors.yaml", &Files::default(), &variants, threads, |_| true).expect("they run");
        for (run, variant) in batch.runs.iter().zip(&variants) {
            let alone =
                read(TEXT, "sensors.yaml", variant).and_then(|it| it.simulation()).expect("it builds").run(|_| true);
            assert!(run.rows == alone.rows);
        }
    }
}

#[test]
fn a_snapshot_contains_the_held_value_of_a_noisy_sensor() {
    let drop_outs = json!({"mean_interval_s": 0.3, "mean_duration_s": 0.2});
    let mut simulation = changed(&[
        ("sensors.gnss.satellite_receiver.drop_outs", drop_outs),
        ("sensors.gnss.satellite_receiver.vertical_errors", json!({"noise_m": 0.5})),
        ("sensors.mru.motion_reference_unit.heave_filter", json!({"cutoff_period_s": 5, "receiver": "gnss"})),
    ]);
    simulation.step(137).unwrap();
    let snapshot = simulation.snapshot();
    simulation.step(200).unwrap();
    let expected = simulation.state().clone();
    simulation.reset();
    simulation.restore(&snapshot).unwrap();
    simulation.step(200).unwrap();
    assert_eq!(*simulation.state(), expected);
}

#[test]
fn a_mistake_in_a_sensors_errors_is_reported_with_its_place() {
    let cases = [
        (
            "sensors.cell.load_cell.rope",
            json!("slingg"),
            "sensors.cell.load_cell.rope: found slingg, allowed: one of sling",
        ),
        (
            "sensors.encoder.encoder.joint",
            json!("heave"),
            "sensors.encoder.encoder.joint: found heave, allowed: one of turn",
        ),
        ("sensors.gnss.satellite_receiver.body", json!("boy"), "sensors.gnss.satellite_receiver.body: found boy"),
        (
            "sensors.encoder.encoder.errors",
            json!({"noise_rad": -1}),
            "noise_rad: found -1, allowed: a number not less than 0",
        ),
        (
            "sensors.mru.motion_reference_unit.drop_outs",
            json!({"mean_interval_s": 0.01, "mean_duration_s": 1}),
            "drop_outs.mean_interval_s: found 0.01, allowed: at least period_s, 0.05 s",
        ),
        (
            "sensors.gnss.satellite_receiver.delay_samples",
            json!(1001),
            "delay_samples: found 1001, allowed: a number from 0 to 1000",
        ),
    ];
    for (path, value, expected) in cases {
        let changes = [(path.to_owned(), value)];
        let found = match read(TEXT, "sensors.yaml", &changes) {
            Ok(scenario) => scenario.simulation().map(drop).expect_err("a mistake").to_string(),
            Err(error) => error.to_string(),
        };
        assert!(found.contains(expected), "{found}\nlacks: {expected}");
    }
}
