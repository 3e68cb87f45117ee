//! Forecasts of the heave, and steps of an operation that wait for a lull: the motion is a sum of sines, which is known for all times.

use crate::common;

use common::values;
use kingpost::elements::compensation::{Dynamics, FilterBank, PeriodBand};
use kingpost::scenario::read;
use kingpost::simulation::Simulation;
use serde_json::{Value, json};
use std::f64::consts::TAU;
use std::fmt::Write as _;

/// Amplitude (m), period (s) and phase (rad) of a sine.
type Sine = [f64; 3];
/// A swell that beats: two sines, whose sum nearly vanishes every 49.5 s.
const BEATS: [Sine; 2] = [[0.5, 9.0, 0.0], [0.5, 11.0, 0.0]];
/// A swell of six sines between 8 and 13 s.
const SWELL: [Sine; 6] =
    [[0.2, 8.3, 0.4], [0.35, 9.1, 2.1], [0.5, 9.8, 4.4], [0.45, 10.6, 1.2], [0.3, 11.5, 5.6], [0.2, 12.4, 3.3]];
const RAMP_S: f64 = 20.0;
const PERIOD_S: f64 = 0.25;

/// Returns decks on each other, each with a sine, and a forecast by an exact unit on the last.
fn decks(sines: &[Sine], rest: &str) -> String {
    let mut bodies = String::new();
    for (k, [amplitude, period, phase]) in sines.iter().enumerate() {
        let parent = if k == 0 { "world".to_owned() } else { format!("deck_{}", k - 1) };
        writeln!(
            bodies,
            "  deck_{k}: {{parent: {parent}, mass_kg: 1, shape: {{point: {{}}}}, joint: {{prismatic: {{axis: [0, 0, 1], mode: \
             {{oscillation: {{amplitude_m: {amplitude}, period_s: {period}, phase_rad: {phase}, ramp_s: {RAMP_S}}}}}}}}}}}"
        )
        .expect("a string takes every text");
    }
    let last = sines.len() - 1;
    format!(
        "version: 1
title: Decks that heave
simulation: {{step_s: 0.05, duration_s: 400, record_every_s: {PERIOD_S}}}
bodies:
{bodies}  cart: {{mass_kg: 1, shape: {{point: {{}}}}, joint: {{prismatic: {{name: slide, axis: [1, 0, 0]}}}}}}
drives:
  push: {{linear_motor: {{joint: slide, force_N: 1, history: lever}}}}
sensors:
  mru: {{motion_reference_unit: {{body: deck_{last}, period_s: 0.05, delay_samples: 2}}}}
controllers:
  lull: {{heave_forecast: {{body: deck_{last}, sensor: mru, period_s: {PERIOD_S}, shortest_period_s: 8, longest_period_s: 13}}}}
{rest}"
    )
}

fn built(text: &str, changes: &[(&str, Value)]) -> Result<Simulation, String> {
    let changes: Vec<(String, Value)> =
        changes.iter().map(|(path, value)| ((*path).to_owned(), value.clone())).collect();
    let scenario = read(text, "decks.yaml", &changes).map_err(|error| error.to_string())?;
    scenario.simulation().map_err(|error| error.to_string())
}

/// Returns the heave at a time after the ramp, m.
fn heave(sines: &[Sine], time_s: f64) -> f64 {
    sines.iter().map(|[amplitude, period_s, phase]| amplitude * (TAU * time_s / period_s + phase).sin()).sum()
}

/// Returns the largest heave from a time to the horizon, m.
fn largest(sines: &[Sine], from_s: f64, horizon_s: f64) -> f64 {
    let steps = (horizon_s / 0.05) as usize;
    (0..=steps).map(|k| heave(sines, from_s + 0.05 * k as f64).abs()).fold(0.0, f64::max)
}

/// Values of a run at each sample of the forecast once it is ready.
struct Foreseen {
    time_s: Vec<f64>,
    heave: Vec<f64>,
    bound: Vec<f64>,
    /// At the end of the run, m.
    error: f64,
}

fn foreseen(sines: &[Sine], changes: &[(&str, Value)]) -> Foreseen {
    let mut simulation = built(&decks(sines, ""), changes).unwrap_or_else(|error| panic!("{error}"));
    let mut found = Foreseen { time_s: Vec::new(), heave: Vec::new(), bound: Vec::new(), error: 0.0 };
    while simulation.time_s() < 400.0 {
        simulation.step(5).unwrap();
        if values(&mut simulation, "forecast_ready")[0] == 1.0 {
            found.time_s.push(simulation.time_s());
            found.heave.push(values(&mut simulation, "predicted_heave")[0]);
            found.bound.push(values(&mut simulation, "predicted_heave_bound")[0]);
            found.error = values(&mut simulation, "predicted_heave_error")[0];
        }
    }
    found
}

#[test]
fn two_sines_in_the_band_are_foreseen_by_the_response_of_the_filters() {
    let horizon_s = 10.0;
    let found = foreseen(&BEATS, &[("controllers.lull.heave_forecast.horizon_s", json!(horizon_s))]);
    // Ready after 2 longest periods, the horizon and 4 longest periods.
    assert_eq!(found.time_s[0], 2.0 * 13.0 + horizon_s + 4.0 * 13.0);
    // Of each sine the forecast at a lead misses |F / D - 1|, at every lead, with the unit's age of 0.1 s in D.
    let band = PeriodBand {
        shortest_period_s: 8.0,
        longest_period_s: 13.0,
        noise_share: 0.03,
        sampling_period_s: PERIOD_S,
        peak_period_s: None,
    };
    let bank = FilterBank::new(band);
    let misses = |lead_s: f64, period_s: f64| {
        let height = Dynamics { high_pass: None, delay: 0.1 + lead_s, lag: 0.0 };
        let weights = bank.position_weights(|frequency| height.position(frequency));
        let frequency = TAU / period_s;
        let response = bank.response(frequency);
        let [real, imaginary] =
            weights.iter().zip(response).fold([0.0; 2], |[re, im], (w, [a, b])| [re + w * a, im + w * b]);
        let [a, b] = height.position(frequency);
        (real - a).hypot(imaginary - b) / a.hypot(b)
    };
    let most =
        (0..=40).map(|k| BEATS.iter().map(|[size, period_s, _]| size * misses(0.25 * f64::from(k), *period_s)).sum());
    let most: f64 = most.fold(0.0, f64::max);
    assert!(most < 0.2, "the band is foreseen within a fifth of 1 m: {most}");
    // A peak between two leads is missed by up to 2 % of it; what is left of the start decays by e^-2 every 16 s.
    let slack = 0.02 + 0.02;
    for (time_s, heave) in found.time_s.iter().zip(&found.heave) {
        let exact = largest(&BEATS, *time_s, horizon_s);
        assert!((heave - exact).abs() < most + slack, "{time_s} s: {heave}, not {exact}, within {most}");
    }
}

#[test]
fn the_bound_covers_a_swell_of_many_sines_and_the_error_is_that_found() {
    for (horizon_s, periods_s) in [(10.0, [8.0, 13.0]), (20.0, [8.0, 13.0]), (20.0, [4.0, 16.0])] {
        let of = |field: &str| format!("controllers.lull.heave_forecast.{field}");
        let changes = [
            (of("horizon_s"), json!(horizon_s)),
            (of("shortest_period_s"), json!(periods_s[0])),
            (of("longest_period_s"), json!(periods_s[1])),
        ];
        let changes: Vec<(&str, Value)> = changes.iter().map(|(path, value)| (path.as_str(), value.clone())).collect();
        let found = foreseen(&SWELL, &changes);
        let pairs = found.time_s.iter().zip(&found.bound);
        let covered = pairs.filter(|(time_s, bound)| largest(&SWELL, **time_s, horizon_s) <= **bound).count();
        // Two standard deviations hold for 95 % of single heaves; the largest of a horizon is a few of them: 90 %.
        let share = covered as f64 / found.time_s.len() as f64;
        assert!(share > 0.9, "{share} for {horizon_s} s and {periods_s:?}");
        // Beyond what the past tells, the error is the standard deviation of the heave: it does not exceed it by more than the
        // spread of a mean over 300 s, 30 periods, 1 / sqrt(2 30) = 13 %.
        let deviation = SWELL.iter().map(|[size, ..]| size * size / 2.0).sum::<f64>().sqrt();
        assert!(found.error < 1.13 * deviation, "{} of {deviation}", found.error);
    }
}

#[test]
fn an_operation_waits_until_the_beats_nearly_vanish() {
    let below_m = 0.35;
    let steps = format!(
        "operation:
  steps:
    - {{name: wait for a lull, until: {{lull: {{forecast: lull, below_m: {below_m}}}}}, time_out_s: 300}}
    - {{name: push, set: [{{input: push, to: 1}}]}}
"
    );
    let changes = [("controllers.lull.heave_forecast.horizon_s", json!(10))];
    let mut simulation = built(&decks(&BEATS, &steps), &changes).unwrap_or_else(|error| panic!("{error}"));
    simulation.run(|_| true).status.expect("it ends");
    let begun = simulation.events().iter().find(|event| event.what.contains("push")).map(|event| event.time_s);
    let begun = begun.expect("there is a lull");
    // The beats vanish at 24.75 s and every 49.5 s: the first after it is ready, at 88 s, is at 123.75 s. The heave stays below 0.35 m
    // for 10 s around it, |cos| being 0.35 at 0.113 of a beat, 5.6 s, before and after.
    assert!((largest(&BEATS, begun, 10.0) - 0.25).abs() < 0.1, "{begun} s: {}", largest(&BEATS, begun, 10.0));
    assert!((116.0..=123.75).contains(&begun), "{begun} s");
}

#[test]
fn no_lull_is_found_before_the_forecast_is_ready_or_in_a_sea_without_one() {
    let one = [[1.0, 10.0, 0.0]];
    let steps = "operation: {steps: [{name: wait, until: {lull: {forecast: lull, below_m: 0.5}}, time_out_s: 200}]}";
    let mut simulation = built(&decks(&one, steps), &[]).unwrap_or_else(|error| panic!("{error}"));
    let error = simulation.run(|_| true).status.expect_err("it waits in vain").to_string();
    assert!(error.contains("found lull.predicted_heave_bound 1.") && error.contains("allowed: below 0.5 m"), "{error}");
    let mut still = built(&decks(&[[1e-9, 10.0, 0.0]], steps), &[]).unwrap_or_else(|error| panic!("{error}"));
    still.run(|_| true).status.expect("it ends");
    let ended = still.events().iter().find(|event| event.code == "operation_ends").expect("there is a lull").time_s;
    // The operation sees a sample in the step after it.
    let ready = 2.0 * 13.0 + 20.0 + 4.0 * 13.0;
    assert!((ready - PERIOD_S..=ready + 0.05 + 1e-9).contains(&ended), "{ended} s");
}

#[test]
fn a_wide_band_warns_that_little_is_foreseen() {
    let warned = |changes: &[(&str, Value)]| {
        let changes: Vec<(String, Value)> =
            changes.iter().map(|(path, value)| ((*path).to_owned(), value.clone())).collect();
        let scenario = read(&decks(&SWELL, ""), "decks.yaml", &changes).expect("it is read");
        scenario.describe().expect("it is built").warnings.into_iter().find(|text| text.contains("foresees little"))
    };
    let wide = warned(&[
        ("controllers.lull.heave_forecast.shortest_period_s", json!(4)),
        ("controllers.lull.heave_forecast.longest_period_s", json!(16)),
    ]);
    assert!(wide.as_ref().is_some_and(|text| text.contains("20 s ahead its error has 9")), "{wide:?}");
    assert_eq!(warned(&[("controllers.lull.heave_forecast.horizon_s", json!(5))]), None);
}

#[test]
fn mistakes_are_named_with_what_is_allowed() {
    let lull = "controllers.lull.heave_forecast.";
    for (path, value, expected) in [
        ("sensor", json!("gyro"), "found gyro, allowed: mru"),
        ("horizon_s", json!(0.5), "allowed: 1 s to 250 s, 4 to 1000 times period_s"),
        ("shortest_period_s", json!(0.9), "at least four times period_s, 1 s"),
        ("longest_period_s", json!(8), "above shortest_period_s, 8 s"),
        ("peak_period_s", json!(14), "8 to 13 s, the shortest and the longest period"),
        ("body", json!("quay"), "found quay, allowed: one of deck_0, deck_1, cart"),
    ] {
        let error = built(&decks(&BEATS, ""), &[(&format!("{lull}{path}"), value)]).expect_err("a mistake");
        assert!(error.contains(&format!("{lull}{path}")) && error.contains(expected), "{error}");
    }
    let of = |name: &str| {
        format!("operation: {{steps: [{{name: wait, until: {{lull: {{forecast: {name}, below_m: 1}}}}}}]}}")
    };
    let error = built(&decks(&BEATS, &of("lulls")), &[]).expect_err("a mistake");
    assert!(error.contains("operation.steps.0.until.lull.forecast: found lulls, allowed: lull"), "{error}");
    let error = built(&decks(&BEATS, &of("lull")), &[("controllers.lull.heave_forecast.enabled", json!(false))]);
    assert!(error.is_err_and(|error| error.contains("none: the scenario does not have a controller of the kind")));
}
