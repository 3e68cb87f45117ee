//! Motions and drive forces that start, hold and stop as the scenario specifies: closed forms. A rate that is
//! piecewise linear in time is integrated exactly by RK4, whose steps end where the pieces do, so that the
//! remaining error is rounding.

use crate::common;
use crate::common::gallery_files;

use common::{simulation, values};
use kingpost::Simulation;
use kingpost::scenario::read;
use std::f64::consts::FRAC_PI_2;

/// Rounding of some thousand steps.
const ROUNDING: f64 = 1e-11;

/// A turntable on the world and a slide on it, with these modes; steps do not fall on the edges.
fn turntable(slew: &str, hoist: &str) -> String {
    format!(
        "
version: 1
title: Turntable
simulation: {{step_s: 0.07, duration_s: 60}}
bodies:
  table: {{mass_kg: 5, shape: {{sphere: {{radius_m: 1}}}}, joint: {{revolute: {{name: slew, axis: [0, 0, 1], {slew}}}}}}}
  hook:
    parent: table
    mass_kg: 2
    shape: {{point: {{}}}}
    joint: {{prismatic: {{name: hoist, axis: [0, 0, 1], position_m: [2, 0, 0], {hoist}}}}}
"
    )
}

fn position_at(simulation: &mut Simulation, time_s: f64) -> Vec<f64> {
    let steps = ((time_s - simulation.time_s()) / simulation.settings().step_s).round();
    simulation.step(steps as usize).expect("it moves as it is told");
    values(simulation, "joint_position")
}

fn near(found: f64, expected: f64) {
    assert!((found - expected).abs() < ROUNDING, "{found}, expected {expected}");
}

#[test]
fn a_slew_by_an_angle_starts_at_its_time_and_ends_at_the_angle() {
    let slew = "initial_angle_deg: 180, mode: {travel: {angle_deg: -90, start_s: 3.3, duration_s: 20.1, ramp_s: 4.7}}";
    let hoist = "mode: {travel: {length_m: 13, duration_s: 30, ramp_s: 15}}";
    for integrator in ["rk4", "dormand_prince", "implicit_midpoint"] {
        let text = turntable(slew, hoist).replace("{step_s", &format!("{{integrator: {integrator}, step_s"));
        let mut simulation = simulation(&text);
        let before = position_at(&mut simulation, 3.29);
        near(before[0], 2.0 * FRAC_PI_2);
        // Half of the way at half of the time, by symmetry; a triangle of speeds has gone t^2 L / T^2 2.
        let middle = position_at(&mut simulation, 13.37);
        let rate = -FRAC_PI_2 / (20.1 - 4.7);
        let now = simulation.time_s();
        near(middle[0], 1.5 * FRAC_PI_2 + rate * (now - 13.35));
        near(middle[1], 2.0 * 13.0 * (now / 30.0).powi(2));
        for time_s in [30.1, 60.2] {
            let end = position_at(&mut simulation, time_s);
            near(end[0], FRAC_PI_2);
            near(end[1], 13.0);
            assert!(simulation.state().v.iter().all(|rate| *rate == 0.0), "{integrator}: {:?}", simulation.state().v);
        }
    }
}

#[test]
fn a_pulse_without_a_reverse_stops_after_its_distance() {
    let slew = "mode: {prescribed: {rate_deg_s: -3, history: pulse, pulse: {start_s: 2.5, rise_s: 5, hold_s: 25}}}";
    let hoist = "mode: {prescribed: {speed_m_s: 0.5, history: pulse, pulse: {rise_s: 2, hold_s: 24, reverse_s: 0}}}";
    let mut simulation = simulation(&turntable(slew, hoist));
    for time_s in [39.9, 56.0] {
        let end = position_at(&mut simulation, time_s);
        near(end[0], -FRAC_PI_2);
        near(end[1], 13.0);
    }
    assert_eq!(simulation.state().v, [0.0, 0.0]);
}

#[test]
fn the_motion_by_a_list_of_times_and_rates_is_its_area() {
    let slew = "mode: {prescribed: {rate_deg_s: 2, history: list,
      list: {time_s: [5, 8, 20, 23, 30, 31, 40], share: [0, 1, 1, 0, 0, -0.5, 0]}}}";
    // The motion starts at once at full speed, and continues at a tenth of it.
    let hoist = "mode: {prescribed: {speed_m_s: 0.5, history: list, list: {time_s: [0, 10, 12], share: [1, 1, 0.1]}}}";
    let mut simulation = simulation(&turntable(slew, hoist));
    assert_eq!(simulation.state().v, [0.0, 0.5]);
    let resting = position_at(&mut simulation, 27.3);
    near(resting[0], (2.0_f64 * 15.0).to_radians());
    let end = position_at(&mut simulation, 56.0);
    near(end[0], (2.0 * (15.0 - 0.25 * 10.0_f64)).to_radians());
    near(end[1], 0.5 * (10.0 + 1.1 + 0.1 * (simulation.time_s() - 12.0)));
}

/// A cart of 4 kg under a force that begins late, jumps, and stops: m v = integral of F dt.
#[test]
fn a_motor_follows_its_list_with_jumps() {
    let text = "
version: 1
title: Cart
simulation: {step_s: 0.07, duration_s: 20}
bodies:
  cart: {mass_kg: 4, shape: {point: {}}, joint: {prismatic: {axis: [1, 0, 0]}}}
drives:
  push:
    linear_motor: {joint: cart, force_N: 10, history: list, list: {time_s: [1.5, 3, 3, 5, 5], share: [1, 1, -0.25, 0.75, 0]}}
";
    let mut simulation = simulation(text);
    let _ = position_at(&mut simulation, 1.4);
    assert_eq!(simulation.state().v, [0.0]);
    let _ = position_at(&mut simulation, 19.6);
    near(simulation.state().v[0], 10.0 * (1.5 + 2.0 * 0.25) / 4.0);
}

fn error_of(slew: &str) -> String {
    read(&turntable(slew, "mode: held"), "test.yaml", &[]).map(drop).expect_err("this should be refused").to_string()
}

#[test]
fn invalid_motions_of_joints_are_refused() {
    let list =
        |points: &str| error_of(&format!("mode: {{prescribed: {{rate_deg_s: 2, history: list, list: {points}}}}}"));
    let cases = [
        (
            list("{time_s: [5, 8], share: [1, 0]}"),
            "list.share.0: found 1, allowed: 0 where the motion begins after time 0",
        ),
        (
            list("{time_s: [0, 8, 8], share: [0, 1, 0]}"),
            "list.time_s.2: found 8, allowed: more than 8, the time before",
        ),
        (list("{time_s: [5, 4], share: [0, 1]}"), "list.time_s.1: found 4, allowed: 5 or more, the time before"),
        (list("{time_s: [5, 6], share: [0]}"), "list.share: found 1 shares, allowed: 2, one for each time"),
        (list("{time_s: [], share: []}"), "list.time_s: found an empty list, allowed: one time or more"),
        (
            error_of("mode: {travel: {angle_deg: 90, duration_s: 10, ramp_s: 6}}"),
            "mode.travel.ramp_s: found 6, allowed: at most 5, half of duration_s",
        ),
        (
            error_of("mode: {prescribed: {rate_deg_s: 2, history: pulse, pulse: {rise_s: 0, hold_s: 1}}}"),
            "pulse.rise_s: found 0, allowed: a number greater than 0",
        ),
        (
            error_of("mode: {prescribed: {rate_deg_s: 2, history: list}}"),
            "list: found nothing, allowed: time_s and share",
        ),
        (
            error_of("mode: {prescribed: {rate_deg_s: 2, history: lever}}"),
            "found lever, allowed: constant, pulse or list",
        ),
    ];
    for (error, expected) in cases {
        assert!(error.contains(expected), "{error}\n{expected}");
    }
}

/// The distance of a travel, and of a list with a share, is linear in these numbers: derivatives are exact.
#[test]
fn distances_and_shares_have_derivatives_and_times_do_not() {
    let slew = "mode: {travel: {angle_rad: 1.2, duration_s: 8, ramp_s: 2}}";
    let hoist = "mode: {prescribed: {speed_m_s: 0.5, history: list, list: {time_s: [1, 3, 7], share: [0, 1, 0]}}}";
    let scenario = read(&turntable(slew, hoist), "test.yaml", &[]).expect("it reads");
    let names = [
        "bodies.table.joint.revolute.mode.travel.angle_rad",
        "bodies.hook.joint.prismatic.mode.prescribed.list.share.1",
    ];
    let mut simulation = Simulation::recursive(scenario.setup_along(&names).expect("they have derivatives"));
    simulation.step(150).expect("it moves");
    let expected = [[1.0, 0.0], [0.0, 0.5 * 3.0]];
    for (found, expected) in simulation.state().q.iter().zip(expected) {
        (0..2).for_each(|k| near(found.derivative[k], expected[k]));
    }
    for name in [
        "bodies.table.joint.revolute.mode.travel.duration_s",
        "bodies.hook.joint.prismatic.mode.prescribed.list.time_s.1",
    ] {
        let error = scenario.setup_along(&[name]).map(drop).expect_err("a time is structure").to_string();
        assert!(error.contains(name), "{error}");
    }
}

/// Checks the texts of the gallery about their cranes: to port is 90 degrees, and the others turn by the area of their
/// pulse.
#[test]
fn the_cranes_of_the_gallery_stop_at_the_positions_in_their_descriptions() {
    let cases = [
        ("barge.yaml", FRAC_PI_2, 32.0),
        ("offshore_vessel.yaml", FRAC_PI_2, 66.0),
        ("offshore_vessel_on_dp.yaml", FRAC_PI_2, 66.0),
        ("flexible_boom.yaml", -0.6 + 0.25 * 4.0, 4.5),
        ("paper_true_draught.yaml", 0.05 * 24.0, 28.0),
    ];
    for (name, expected, end_s) in cases {
        let scenario = gallery_files::scenario(name.trim_end_matches(".yaml"), &[]);
        let mut simulation = scenario.simulation().expect("the gallery builds");
        let slew = simulation.model().coordinate("slew").expect("a slewing crane");
        let (_, position) = simulation.model().axis_coordinate(slew).expect("an axis");
        simulation.step((end_s / simulation.settings().step_s).round() as usize + 10).expect("it slews");
        let (found, rate) = (simulation.state().q[position], simulation.state().v[slew]);
        assert!((found - expected).abs() < 1e-9 && rate == 0.0, "{name}: {found}, expected {expected}; {rate}");
    }
}
