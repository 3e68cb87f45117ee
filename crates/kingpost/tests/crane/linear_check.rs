//! The linear check: which feedback makes a mode grow, with integrals, sensors and their delays.

use super::controllers::{MASS, STIFFNESS, oscillator};
use crate::common;

use common::simulation;

/// `m x'' + c x' + k x = -F K_I (integral of x)` is stable for `F K_I < c k / m` (Routh). The sum counts the present sample, half a
/// period early, and its value is held, half a period late.
#[test]
fn the_linear_check_includes_the_integral() {
    let (zeta, force) = (0.05, 10.0);
    let damping = 2.0 * zeta * libm::sqrt(STIFFNESS * MASS);
    let largest = damping * STIFFNESS / MASS / force;
    for (share, grows) in [(0.95, false), (1.05, true)] {
        let text = format!(
            "controllers: {{hold: {{state_feedback: {{reads: [{{column: slide.joint_position}}], steers: [{{to: push, gains: [0], integral_gains: [{}]}}]}}}}}}\n",
            share * largest
        );
        let mut found = simulation(&oscillator(zeta, 0.001, 1.0, &text));
        let mode = found.growing_with_feedback();
        assert_eq!(mode.is_some(), grows, "{share}: {mode:?}");
        assert!(mode.is_none_or(|mode| mode.coordinate == "slide" && mode.because_of == ["hold"]));
    }
}

/// Feedback through sensors grows like feedback of the measured values themselves.
#[test]
fn the_linear_check_includes_feedback_through_sensors() {
    let growing = |column: &str, gain: f64| {
        let text = format!(
            "controllers: {{hold: {{state_feedback: {{reads: [{{column: {column}}}], steers: [{{to: push, gains: [{gain}]}}]}}}}}}
sensors:
  encoder: {{linear_encoder: {{joint: slide, period_s: 0.001, errors: {{bias_m: 0.1}}}}}}
  unit: {{motion_reference_unit: {{body: cage, period_s: 0.001, horizontal_motion: true}}}}
  inertial: {{inertial_unit: {{body: cage, period_s: 0.001}}}}
  antenna: {{satellite_receiver: {{body: cage, period_s: 0.001}}}}
"
        );
        simulation(&oscillator(0.05, 0.001, 1.0, &text)).growing_with_feedback()
    };
    let (velocity, position) = (growing("slide.joint_velocity", -0.5), growing("slide.joint_position", -30.0));
    assert!(velocity.is_some() && position.is_some(), "{velocity:?}, {position:?}");
    for (column, gain, exact) in [
        ("encoder.measured_extension", -30.0, &position),
        ("antenna.measured_position.x", -30.0, &position),
        ("unit.measured_x", -30.0, &position),
        ("unit.measured_x_velocity", -0.5, &velocity),
        ("inertial.measured_x_velocity", -0.5, &velocity),
    ] {
        let (found, exact) = (growing(column, gain).expect(column), exact.as_ref().expect("it grows"));
        assert!((found.growth_time_s / exact.growth_time_s - 1.0).abs() < 1e-5, "{column}: {found:?}");
        assert_eq!(found.because_of, ["hold"]);
    }
}

/// `m x'' + c x' + k x = -F K x(t - age)` grows where the delay turns stiffness into negative damping: with `w` near `w0`, at
/// `F K sin(w age) > c w`, w^2 = w0^2 + F K cos(w age) / m. A sample held for T is T / 2 older on average.
#[test]
fn the_linear_check_includes_the_delay_of_a_sensor() {
    let (zeta, force, step) = (0.05, 10.0, 0.001);
    let w0 = libm::sqrt(STIFFNESS / MASS);
    let damping = 2.0 * zeta * w0 * MASS;
    let growing = |gain: f64, period_s: f64, delay_samples: usize, feedback_s: f64| {
        let text = format!(
            "controllers: {{hold: {{state_feedback: {{reads: [{{column: encoder.measured_extension}}], steers: [{{to: push, gains: [{gain}]}}], period_s: {feedback_s}}}}}}}
sensors: {{encoder: {{linear_encoder: {{joint: slide, period_s: {period_s}, delay_samples: {delay_samples}}}}}}}
"
        );
        simulation(&oscillator(zeta, step, 1.0, &text)).growing_with_feedback()
    };
    for (period_s, delay_samples, feedback_s) in [(0.005, 4, 0.005), (0.02, 1, 0.001), (0.001, 20, 0.02)] {
        // The held output of the law is half its period old.
        let hold = if period_s > feedback_s { 0.5 * (period_s - feedback_s) } else { 0.0 };
        let age = period_s * delay_samples as f64 + hold + 0.5 * feedback_s;
        let mut w = w0;
        for _ in 0..50 {
            let stiffer = damping * w / libm::tan(w * age);
            w = libm::sqrt((STIFFNESS + stiffer) / MASS);
        }
        let limit = damping * w / libm::sin(w * age) / force;
        for (share, grows) in [(0.97, false), (1.03, true)] {
            let mode = growing(share * limit, period_s, delay_samples, feedback_s);
            assert_eq!(
                mode.is_some(),
                grows,
                "{period_s}, {delay_samples}, {feedback_s}: {share} of {limit}, {mode:?}"
            );
        }
    }
}
