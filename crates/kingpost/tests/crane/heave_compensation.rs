//! Active heave compensation: closed forms of the residual of a sinusoidal motion, with and without
//! prediction, and limits.

use crate::common;

use common::values;
use kingpost::batch;
use kingpost::elements::compensation::{Dynamics, FilterBank, PeriodBand};
use kingpost::scenario::{Files, read};
use kingpost::simulation::Simulation;
use serde_json::{Value, json};
use std::f64::consts::TAU;

/// A heavy deck on a spring, which heaves with an amplitude of 1 m, 8 s, and a load on a rope from its winch. The drive
/// is so stiff that the drum follows its reference; the reference follows its set-point with a lag of 0.1 s.
const DECK: &str = "
version: 1
title: A deck that heaves
simulation: {step_s: 0.01, duration_s: 60, record_every_s: 0.05}
bodies:
  deck:
    mass_kg: 1.0e9
    shape: {box: {length_m: 4, width_m: 2, height_m: 1}}
    joint: {prismatic: {axis: [0, 0, 1], initial_extension_m: 1, spring: {stiffness_N_per_m: 6.168502750680849e8, rest_m: 15.897942169058107}}}
  drum:
    parent: deck
    mass_kg: 10
    shape: {cylinder: {radius_m: 0.5, length_m: 1, axis: y}}
    joint: {revolute: {name: winch, axis: [0, 1, 0], position_m: [-2, 0, 1], rotor_inertia_kg_m2: 100, gear_ratio: 1}}
  load:
    mass_kg: 100
    shape: {sphere: {radius_m: 0.5}}
    joint: {prismatic: {axis: [0, 0, 1], position_m: [2, 0, 0], initial_extension_m: -19}}
forces:
  gravity: {gravity: {}}
  hoist:
    rope:
      path: [{drum: {joint: winch, radius_m: 0.5}}, {point: {body: deck, position_m: [2, 0, 1]}}, {point: {body: load, position_m: [0, 0, 0]}}]
      axial_stiffness_N: 1.0e6
      damping_time_s: 0.05
drives:
  drive:
    controlled_drive: {joint: winch, set_point: {speed: {}}, speed_limit_rad_s: 20, acceleration_limit_rad_s2: 200, torque_limit_N_m: 50000, stiffness_N_m_per_rad: 1.0e6, damping_N_m_s_per_rad: 10000, response_time_s: 0.1}
sensors:
  mru: {motion_reference_unit: {body: deck, position_m: [0, 0, 0], period_s: 0.05, delay_samples: 2}}
controllers:
  keep: {heave_compensation: {rope: hoist, drive: drive, period_s: 0.05, position_gain_per_s: 0}}
";

const CONTROLLER: &str = "controllers.keep.heave_compensation";
/// Natural period of the deck, s.
const DECK_S: f64 = 8.0;

fn changed(changes: &[(&str, Value)]) -> Simulation {
    let changes: Vec<(String, Value)> =
        changes.iter().map(|(path, value)| (path.replace("KEEP", CONTROLLER), value.clone())).collect();
    let scenario = read(DECK, "deck.yaml", &changes).unwrap_or_else(|error| panic!("{error}"));
    scenario.simulation().unwrap_or_else(|error| panic!("{error}"))
}

fn error(changes: &[(&str, Value)]) -> String {
    let changes: Vec<(String, Value)> =
        changes.iter().map(|(path, value)| (path.replace("KEEP", CONTROLLER), value.clone())).collect();
    match read(DECK, "deck.yaml", &changes) {
        Ok(scenario) => scenario.simulation().map(drop).expect_err("a mistake").to_string(),
        Err(error) => error.to_string(),
    }
}

/// Stiffness of the deck's spring for a period, and its rest position, at which the weight leaves the deck at
/// 0.
fn of_period(period_s: f64) -> [(&'static str, Value); 2] {
    let square = TAU * TAU / (period_s * period_s);
    [
        ("bodies.deck.joint.prismatic.spring.stiffness_N_per_m", json!(1.0e9 * square)),
        ("bodies.deck.joint.prismatic.spring.rest_m", json!(9.80665 / square)),
    ]
}

/// Returns the amplitude of the residual at the period, by sums over two periods after the first 120 s; the
/// drift between the periods, which remains from the start in the slow states of the prediction, is
/// subtracted.
fn left(simulation: &mut Simulation, period_s: f64) -> f64 {
    simulation.step(12_000).unwrap();
    let steps = (100.0 * period_s) as usize;
    let residuals: Vec<f64> = (0..2 * steps)
        .map(|_| {
            let residual = values(simulation, "compensation_residual")[0];
            simulation.step(1).unwrap();
            residual
        })
        .collect();
    let drift = (residuals[steps..].iter().sum::<f64>() - residuals[..steps].iter().sum::<f64>()) / steps as f64;
    let [mut cosine, mut sine] = [0.0; 2];
    for (k, residual) in residuals.iter().enumerate() {
        let share = k as f64 / steps as f64;
        let (angle, residual) = (TAU * share, residual - drift * share);
        cosine += residual * angle.cos() / steps as f64;
        sine += residual * angle.sin() / steps as f64;
    }
    cosine.hypot(sine)
}

/// e^(-i w (tau + T_s/2)) sin(w T_s/2) / (w T_s/2) / (1 + i w T): the transfer function from a velocity to
/// the drum.
pub fn carried(frequency: f64, delay_s: f64) -> [f64; 2] {
    let (half, lag) = (frequency * 0.025, frequency * 0.1);
    let size = half.sin() / half / (1.0 + lag * lag).sqrt();
    let angle = -(frequency * delay_s + half + lag.atan());
    [size * angle.cos(), size * angle.sin()]
}

/// |1 - H|.
pub fn rest([real, imaginary]: [f64; 2]) -> f64 {
    (1.0 - real).hypot(imaginary)
}

/// Beside the formula, the drum lags by J w^2 / k < 2e-4, and the pull of the rope turns it by m g R / k = 5e-4 rad, a hundredth
/// of which varies.
const OF_THE_DRIVE: f64 = 5e-4;

#[test]
fn the_residual_of_a_sinusoid_without_prediction_agrees_with_the_formula() {
    for period_s in [5.0, DECK_S, 12.0] {
        for delay_s in [0.0, 0.1] {
            let mut changes = of_period(period_s).to_vec();
            if delay_s > 0.0 {
                changes.push(("KEEP.sensor", json!("mru")));
            }
            let found = left(&mut changed(&changes), period_s);
            let expected = rest(carried(TAU / period_s, delay_s));
            assert!((found - expected).abs() < OF_THE_DRIVE, "{period_s} s, {delay_s} s: {found}, not {expected}");
        }
    }
}

fn band() -> PeriodBand {
    PeriodBand {
        shortest_period_s: 4.0,
        longest_period_s: 16.0,
        noise_share: 0.03,
        sampling_period_s: 0.05,
        peak_period_s: None,
    }
}

/// Returns the frequency response of a filter.
fn response(bank: &FilterBank, weights: &[f64], frequency: f64) -> [f64; 2] {
    let states = bank.response(frequency);
    weights.iter().zip(states).fold([0.0; 2], |[a, b], (weight, [c, d])| [a + weight * c, b + weight * d])
}

fn product([a, b]: [f64; 2], [c, d]: [f64; 2]) -> [f64; 2] {
    [a * c - b * d, a * d + b * c]
}

#[test]
fn the_residual_with_prediction_agrees_with_the_response_of_its_filter() {
    let bank = FilterBank::new(band());
    let weights =
        bank.velocity_weights(|frequency| Dynamics { high_pass: None, delay: 0.125, lag: 0.1 }.velocity(frequency));
    for period_s in [5.0, DECK_S, 12.0] {
        let changes =
            [of_period(period_s).to_vec(), vec![("KEEP.sensor", json!("mru")), ("KEEP.prediction", json!({}))]]
                .concat();
        let found = left(&mut changed(&changes), period_s);
        let frequency = TAU / period_s;
        let expected = rest(product(response(&bank, &weights, frequency), carried(frequency, 0.1)));
        assert!((found - expected).abs() < OF_THE_DRIVE, "{period_s} s: {found}, not {expected}");
        assert!(found < 0.015, "{period_s} s: {found}");
    }
}

/// The heave filter leads by atan2(2 zeta w omega, omega^2 - w^2) = 28.6 degrees at 8 s and a cut-off of 20
/// s: as a residual at least 2 sin(14.3 deg). The prediction cancels this lead.
#[test]
fn the_prediction_cancels_the_phase_of_the_sensors_filter() {
    let filter = ("sensors.mru.motion_reference_unit.heave_filter", json!({"cutoff_period_s": 20}));
    let raw = left(&mut changed(&[("KEEP.sensor", json!("mru")), filter.clone()]), DECK_S);
    let predicted =
        left(&mut changed(&[("KEEP.sensor", json!("mru")), ("KEEP.prediction", json!({})), filter]), DECK_S);
    assert!(raw > 0.4, "{raw}");
    assert!(predicted < 0.025, "{predicted}");
}

/// With a receiver the filter removes nothing, so no correction is needed: the residual equals that without
/// the filter.
#[test]
fn with_a_receiver_the_heave_filter_has_no_phase_to_cancel() {
    let receiver = json!({"satellite_receiver": {"body": "deck", "position_m": [1, 0, 9], "period_s": 0.1}});
    let changes = [
        ("sensors.gnss", receiver),
        ("sensors.mru.motion_reference_unit.heave_filter", json!({"cutoff_period_s": 20, "receiver": "gnss"})),
        ("KEEP.sensor", json!("mru")),
        ("KEEP.prediction", json!({})),
    ];
    let without = left(&mut changed(&changes[2..]), DECK_S);
    let found = left(&mut changed(&changes), DECK_S);
    // Of the curvature over the 0.1 s to the next position: (w T)^2 / 6 on average.
    assert!((found - without).abs() < 1.1e-3, "{found}, not {without}");
}

#[test]
fn a_receiver_without_effect_is_refused() {
    let receiver = |body: &str| json!({"satellite_receiver": {"body": body, "period_s": 0.1}});
    let filter = ("sensors.mru.motion_reference_unit.heave_filter", json!({"cutoff_period_s": 20, "receiver": "gnss"}));
    let field = "sensors.mru.motion_reference_unit.heave_filter.receiver";
    let none = error(std::slice::from_ref(&filter));
    assert!(none.contains(&format!("{field}: found gnss, allowed: none")), "{none}");
    let elsewhere = error(&[("sensors.gnss", receiver("load")), filter.clone()]);
    let expected = format!("{field}: found gnss, which is on load, allowed: a satellite receiver on deck");
    assert!(elsewhere.contains(&expected), "{elsewhere}");
    let off =
        error(&[("sensors.gnss", receiver("deck")), ("sensors.gnss.satellite_receiver.enabled", json!(false)), filter]);
    assert!(off.contains("a satellite receiver that is enabled"), "{off}");
}

/// The weights are those of least squares: in the band of 4 to 16 s the error of the filter stays below 1.5 %, and below 3.5 %
/// where it undoes a high-pass filter of 20 s. A constant gives nothing.
#[test]
fn a_filter_is_near_the_target_response_in_its_band_with_and_without_a_high_pass() {
    let bank = FilterBank::new(band());
    for (high_pass, allowed) in [(None, 0.015), (Some([TAU / 20.0, 0.7]), 0.035)] {
        let wanted = Dynamics { high_pass, delay: 0.125, lag: 0.1 };
        let weights = bank.velocity_weights(|frequency| wanted.velocity(frequency));
        for period_s in [4.2, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 12.0, 14.0] {
            let frequency = TAU / period_s;
            let [c, d] = wanted.velocity(frequency);
            let [a, b] = response(&bank, &weights, frequency);
            let off = (a - c).hypot(b - d) / c.hypot(d);
            assert!(off < allowed, "{high_pass:?}, {period_s} s: {off}");
        }
        let [constant, _] = response(&bank, &weights, 0.0);
        assert!(constant.abs() < 1e-2, "{constant}");
    }
}

/// White noise of variance 1 leaves the filter with the sum of squares of its impulse response; 40 000 samples estimate
/// it to some 2 %, because the output is correlated over seconds.
#[test]
fn white_noise_through_the_filter_has_the_variance_of_its_impulse_response() {
    let bank = FilterBank::new(band());
    let weights =
        bank.velocity_weights(|frequency| Dynamics { high_pass: None, delay: 0.125, lag: 0.1 }.velocity(frequency));
    let mut states = vec![0.0; FilterBank::STATES];
    let expected: f64 = (0..6000)
        .map(|k| {
            bank.take(&mut states, if k == 0 { 1.0 } else { 0.0 });
            FilterBank::read(&weights, &states).powi(2)
        })
        .sum();
    let noise = kingpost::elements::sensing::SensorNoise::new(3, "mru");
    states.fill(0.0);
    let found = (0..40_000)
        .map(|k| {
            bank.take(&mut states, noise.normal(0, k));
            FilterBank::read(&weights, &states).powi(2)
        })
        .sum::<f64>()
        / 40_000.0;
    assert!((found / expected - 1.0).abs() < 0.06, "{found}, not {expected}");
    assert!(expected < 4.0, "{expected}");
}

#[test]
fn the_position_gain_returns_the_load_to_its_height_and_without_compensation_it_heaves() {
    let mut on = changed(&[("KEEP.position_gain_per_s", json!(0.5))]);
    let mut off = changed(&[("KEEP.begins_on", json!(false))]);
    on.step(1000).unwrap();
    off.step(1000).unwrap();
    let largest = |simulation: &mut Simulation| {
        (0..800).fold(0.0_f64, |largest, _| {
            simulation.step(1).unwrap();
            largest.max(values(simulation, "compensation_residual")[0].abs())
        })
    };
    // Of the deck's 1 m: the formula's share, with a lag of 0.125 s at 8 s; off, it begins at the top and goes 2 m down.
    assert!(largest(&mut on) < 0.11);
    assert!((largest(&mut off) - 2.0).abs() < 1e-3);
    assert!(values(&mut off, "compensation_speed") == [0.0]);
}

#[test]
fn the_speeds_of_an_operator_and_of_compensation_add_up() {
    let mut keeps = changed(&[("KEEP.position_gain_per_s", json!(0.5)), ("KEEP.prediction", json!({}))]);
    let mut lowers = changed(&[("KEEP.position_gain_per_s", json!(0.5)), ("KEEP.prediction", json!({}))]);
    lowers.set_input("keep.lowering_speed", 0.2).unwrap();
    keeps.step(6000).unwrap();
    lowers.step(6000).unwrap();
    let height = |simulation: &mut Simulation| values(simulation, "joint_position")[2];
    // 60 s at 0.2 m/s; what the drive lags by at the start is caught up. The rope stretches by its load over EA.
    let (lowered, expected) = (height(&mut keeps) - height(&mut lowers), 12.0 * (1.0 + 100.0 * 9.80665 / 1.0e6));
    assert!((lowered - expected).abs() < 1e-3, "{lowered} m, not {expected} m");
    // By its own response to this period, and by the step of a tick: 0.05 s times 0.2 m/s.
    let residual = values(&mut lowers, "compensation_residual")[0];
    assert!(residual.abs() < 0.04, "{residual} m");
}

/// A winch that is too slow: the shortfall is not made up after the operator has stopped, and the load
/// returns to its height.
#[test]
fn the_integral_does_not_wind_up_at_the_limit_of_the_drive() {
    let slow = ("drives.drive.controlled_drive.speed_limit_rad_s", json!(1.2));
    let mut simulation = changed(&[slow, ("KEEP.position_gain_per_s", json!(0.5))]);
    simulation.set_input("keep.lowering_speed", 0.3).unwrap();
    simulation.step(1500).unwrap();
    let speeds: Vec<f64> = (0..1500)
        .map(|_| {
            simulation.step(1).unwrap();
            let rate = values(&mut simulation, "joint_velocity")[1];
            assert!(rate.abs() < 1.2 * 1.001, "{rate} rad/s");
            rate
        })
        .collect();
    assert!(speeds.iter().any(|rate| *rate > 1.19));
    assert!(values(&mut simulation, "compensation_utilisation")[0].is_finite());
    simulation.set_input("keep.lowering_speed", 0.0).unwrap();
    simulation.step(1600).unwrap();
    // Without wind-up the load is as far from its height as a slow winch leaves it: less than the motion itself.
    let far = (0..800).fold(0.0_f64, |far, _| {
        simulation.step(1).unwrap();
        far.max(values(&mut simulation, "compensation_residual")[0].abs())
    });
    assert!(far < 1.0, "{far} m");
}

#[test]
fn compensation_continues_after_a_sensor_drops_out_and_reports_it() {
    let out = ("sensors.mru.motion_reference_unit.drop_outs", json!({"mean_interval_s": 5, "mean_duration_s": 0.5}));
    for prediction in [json!(null), json!({})] {
        let mut simulation = changed(&[
            ("KEEP.sensor", json!("mru")),
            ("KEEP.prediction", prediction),
            ("KEEP.position_gain_per_s", json!(0.5)),
            out.clone(),
        ]);
        let residuals: Vec<f64> = (0..5900)
            .map(|_| {
                simulation.step(1).unwrap();
                values(&mut simulation, "compensation_residual")[0]
            })
            .collect();
        // The deck's motion has the variance 0.5 m2; the first 20 s, in which the prediction settles, do not count.
        let settled = &residuals[2000..];
        let mean = settled.iter().sum::<f64>() / settled.len() as f64;
        let variance = settled.iter().map(|residual| (residual - mean).powi(2)).sum::<f64>() / settled.len() as f64;
        assert!(variance < 0.05, "{variance} m2");
        let said: Vec<String> =
            simulation.events().iter().map(|event| format!("{} {}", event.element, event.what)).collect();
        for words in [
            "mru drops out",
            "mru delivers again",
            "keep continues without its sensor, which has dropped out",
            "keep uses its sensor again",
        ] {
            assert!(said.iter().any(|said| said == words), "{words}: {said:?}");
        }
    }
}

#[test]
fn runs_side_by_side_have_the_rows_that_they_have_alone() {
    let variant = |gain: f64| -> batch::Variant {
        let noise = json!({"noise_m_s": 0.02 * gain});
        vec![
            (format!("{CONTROLLER}.position_gain_per_s"), json!(gain)),
            (format!("{CONTROLLER}.sensor"), json!("mru")),
            (format!("{CONTROLLER}.prediction"), json!({})),
            ("sensors.mru.motion_reference_unit.heave_rate_errors".to_owned(), noise),
            ("simulation.duration_s".to_owned(), json!(3)),
        ]
    };
    let variants: Vec<_> = [0.1, 0.5, 1.0, 0.3].map(variant).to_vec();
    let [one, two] = [1, 2].map(|threads| {
        batch::run(DECK, "deck.yaml", &Files::default(), &variants, threads, |_| true).expect("they run")
    });
    for ((run, variant), other) in one.runs.iter().zip(&variants).zip(&two.runs) {
        let alone =
            read(DECK, "deck.yaml", variant).and_then(|deck| deck.simulation()).expect("it builds").run(|_| true);
        assert!(run.rows == alone.rows && other.rows == alone.rows);
    }
    assert!(one.runs[0].rows != one.runs[1].rows);
}

#[test]
fn a_mistake_is_told_with_its_place() {
    let cases: [(&[(&str, Value)], &str); 11] = [
        (&[("KEEP.rope", json!("hoistt"))], "keep.heave_compensation.rope: found hoistt, allowed: hoist"),
        (&[("KEEP.drive", json!("drove"))], "keep.heave_compensation.drive: found drove, allowed: drive"),
        (&[("KEEP.sensor", json!("gyro"))], "keep.heave_compensation.sensor: found gyro, allowed: mru"),
        (
            &[("drives.drive.controlled_drive.set_point", json!({"position": {}}))],
            "keep.heave_compensation.drive: found drive, whose set-point is a position, allowed: a drive with set_point: {speed: {}}",
        ),
        (
            &[("KEEP.period_s", json!(0.001))],
            "keep.heave_compensation.period_s: found 0.001, allowed: at least simulation.step_s, 0.01 s",
        ),
        (
            &[("KEEP.position_gain_per_s", json!(-1))],
            "position_gain_per_s: found -1, allowed: a number not less than 0",
        ),
        (&[("KEEP.feed_forward", json!(1.5))], "feed_forward: found 1.5, allowed: a number from 0 to 1"),
        (
            &[("KEEP.prediction", json!({"shortest_period_s": 0.1}))],
            "prediction.shortest_period_s: found 0.1, allowed: at least four times period_s, 0.2 s",
        ),
        (
            &[("KEEP.prediction", json!({"longest_period_s": 3}))],
            "prediction.longest_period_s: found 3, allowed: above shortest_period_s, 4 s",
        ),
        (
            &[(
                "controllers.again",
                json!({"heave_compensation": {"rope": "hoist", "drive": "drive", "period_s": 0.1}}),
            )],
            "controllers.again.heave_compensation.drive: found drive, which keep sets, allowed: one controller to each input",
        ),
        (
            &[("operation", json!({"steps": [{"name": "lower", "set": [{"input": "drive", "to": 1}]}]}))],
            "operation.steps.0.set.0.input: found drive, allowed: an input that no controller sets, such as the command of keep",
        ),
    ];
    for (changes, expected) in cases {
        let found = error(changes);
        assert!(found.contains(expected), "{found}\nlacks: {expected}");
    }
}
