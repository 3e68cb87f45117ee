//! Gangways against hand calculations, their warnings and mistakes.

use crate::common;

use common::{simulation, values, with_changes};
use kingpost::scenario::read;
use serde_json::json;

/// A landing point that circles at 0.3 rad/s at 5 m radius and 2 m height, and a carriage with the pedestal that moves along x at
/// 0.5 m/s from x = -8 m, turned by 0.5 rad about the vertical. The gangway points at slew 0 along the carriage's own x.
const TEXT: &str = "
version: 1
title: A gangway
simulation: {step_s: 0.05, duration_s: 8, record_every_s: 0.05}
bodies:
  tower:
    mass_kg: 100
    shape: {sphere: {radius_m: 1}}
    joint: {revolute: {axis: [0, 0, 1], mode: {prescribed: {rate_rad_s: 0.3}}}}
  carriage:
    mass_kg: 100
    shape: {sphere: {radius_m: 1}}
    joint: {prismatic: {axis: [1, 0, 0], position_m: [-8, 0, -1], mode: {prescribed: {speed_m_s: 0.5}}}}
  turntable:
    parent: carriage
    mass_kg: 100
    shape: {sphere: {radius_m: 1}}
    joint: {fixed: {orientation_rad: [0, 0, 0.5]}}
sensors:
  bridge:
    gangway:
      pedestal: {body: turntable, position_m: [0, 0, 1.5]}
      landing: {body: tower, position_m: [5, 0, 2]}
      heading_rad: -0.4
      length_m: 12
      stroke_limits_m: [-10, 0.5]
      luff_limits_deg: [-12, 30]
      slew_limits_deg: [-30, 20]
";

/// Stroke, luff and slew at a time.
fn exact(time_s: f64) -> [f64; 3] {
    let (sin, cos) = (0.3 * time_s).sin_cos();
    let [x, y, z] = [5.0 * cos + 8.0 - 0.5 * time_s, 5.0 * sin, 2.0 - 0.5];
    let level = x.hypot(y);
    [level.hypot(z) - 12.0, z.atan2(level), y.atan2(x) - 0.1]
}

/// Prescribed motions at constant rates are exact: the remaining error is rounding, and that of the central difference of second
/// order in 1e-4 s.
#[test]
fn stroke_luff_and_slew_follow_both_ends() {
    let mut run = simulation(TEXT);
    for _ in 0..8 {
        run.step(20).expect("it moves");
        let ([stroke, luff, slew], time_s) = (exact(run.time_s()), run.time_s());
        let rate = (exact(time_s + 1e-4)[0] - exact(time_s - 1e-4)[0]) / 2e-4;
        for (variable, exact, tolerance) in [
            ("gangway_stroke", stroke, 1e-12),
            ("gangway_luff", luff, 1e-12),
            ("gangway_slew", slew, 1e-12),
            ("gangway_stroke_rate", rate, 1e-8),
        ] {
            let found = values(&mut run, variable)[0];
            assert!((found - exact).abs() < tolerance, "{variable}: {found}, not {exact}");
        }
    }
}

#[test]
fn warns_of_a_gangway_outside_its_operating_range() {
    let run = simulation(TEXT).run(|_| true);
    let codes: Vec<&str> = run.warnings.iter().map(|warning| warning.code).collect();
    // It begins 1.1 m longer than its length, and at the end it points 79 deg to port.
    assert_eq!(codes, ["gangway_stroke", "gangway_slew"]);
    let [stroke, slew] = [&run.warnings[0], &run.warnings[1]];
    assert_eq!(stroke.text, "its stroke was 1.09 m at 0 s: its operating range ends at 0.5 m");
    let last = exact(8.0)[2].to_degrees();
    assert!((slew.value.expect("a number") - last).abs() < 1e-9 && slew.bound == Some(20.0), "{slew:?}");
}

#[test]
fn refuses_limits_out_of_order_and_a_gangway_to_its_own_body() {
    for (field, value, expected) in [
        (
            "stroke_limits_m",
            json!([2, -2]),
            "stroke_limits_m: found [2, -2], allowed: the smaller limit, then the larger",
        ),
        ("luff_limits_rad", json!([0.1, 0.1]), "luff_limits_rad"),
        ("landing.body", json!("turntable"), "another body than pedestal.body, turntable"),
        ("landing.body", json!("ship"), "one of tower, carriage, turntable, world"),
        ("length_m", json!(0), "length_m"),
    ] {
        let path = format!("sensors.bridge.gangway.{field}");
        let found = with_changes(TEXT, &[(path.as_str(), value)]).err().map(|error| error.to_string());
        assert!(found.as_ref().is_some_and(|found| found.contains(expected)), "{field}: {found:?}");
    }
}

#[test]
fn a_gangway_to_a_disabled_body_is_left_out() {
    let text = TEXT.replace("  tower:\n", "  tower:\n    enabled: false\n");
    let scenario = read(&text, "test.yaml", &[]).expect("it reads");
    let run = scenario.simulation().expect("it builds");
    assert!(run.channels().iter().all(|channel| !channel.variable.starts_with("gangway")));
}
