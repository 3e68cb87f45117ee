//! Compensation in several axes: closed forms of the residual of a sinusoidal motion, limits, singular
//! positions.

use crate::common;

use common::values;
use kingpost::scenario::read;
use kingpost::simulation::Simulation;
use serde_json::{Value, json};
use std::f64::consts::TAU;

/// A heavy deck on a spring sways obliquely with an amplitude of 0.2 m, 8 s; it carries a crane with a load. The drives are so
/// stiff that the joints follow their references, which follow their set-points with a lag of 0.1 s.
const DECK: &str = "
version: 1
title: A deck that sways
simulation: {step_s: 0.01, duration_s: 60, record_every_s: 0.05}
bodies:
  deck:
    mass_kg: 1.0e9
    shape: {box: {length_m: 4, width_m: 2, height_m: 1}}
    joint: {prismatic: {axis: [0.6, 0.8, 0], initial_extension_m: 0.2, spring: {stiffness_N_per_m: 6.168502750680849e8}}}
  pedestal:
    parent: deck
    mass_kg: 100
    shape: {cylinder: {radius_m: 0.5, length_m: 2, axis: z}}
    joint: {revolute: {name: slew, axis: [0, 0, 1], position_m: [0, 0, 0.5], child_position_m: [0, 0, -1]}}
  boom:
    parent: pedestal
    mass_kg: 100
    shape: {box: {length_m: 10, width_m: 0.5, height_m: 0.5}}
    joint: {revolute: {name: luff, axis: [0, -1, 0], position_m: [0, 0, 1], child_position_m: [-5, 0, 0], initial_angle_deg: 50}}
  drum:
    parent: boom
    mass_kg: 10
    shape: {cylinder: {radius_m: 0.2, length_m: 1, axis: y}}
    joint: {revolute: {name: winch, axis: [0, 1, 0], position_m: [-4, 0, 0.5], rotor_inertia_kg_m2: 100, gear_ratio: 1}}
  load:
    mass_kg: 100
    shape: {sphere: {radius_m: 0.5}}
    joint: {floating: {initial: {position_m: [6.5, 0.16, 2]}}}
forces:
  gravity: {gravity: {}}
  hoist:
    rope:
      path: [{drum: {joint: winch, radius_m: 0.2}}, {point: {body: boom, position_m: [5, 0, 0]}}, {point: {body: load, position_m: [0, 0, 0]}}]
      axial_stiffness_N: 1.0e6
      damping_time_s: 0.05
drives:
  winching:
    controlled_drive: {joint: winch, set_point: {speed: {}}, speed_limit_rad_s: 20, acceleration_limit_rad_s2: 200, torque_limit_N_m: 50000, stiffness_N_m_per_rad: 1.0e6, damping_N_m_s_per_rad: 10000, response_time_s: 0.1}
  slewing:
    controlled_drive: {joint: slew, set_point: {speed: {}}, speed_limit_rad_s: 1, acceleration_limit_rad_s2: 20, torque_limit_N_m: 1.0e6, stiffness_N_m_per_rad: 1.0e6, damping_N_m_s_per_rad: 50000, response_time_s: 0.1}
  luffing:
    controlled_drive: {joint: luff, set_point: {speed: {}}, speed_limit_rad_s: 1, acceleration_limit_rad_s2: 20, torque_limit_N_m: 1.0e6, stiffness_N_m_per_rad: 3.0e6, damping_N_m_s_per_rad: 2.0e5, response_time_s: 0.1}
sensors:
  mru: {motion_reference_unit: {body: deck, position_m: [0, 0, 0], period_s: 0.05, delay_samples: 2, horizontal_motion: true}}
  blind: {motion_reference_unit: {body: deck, position_m: [0, 0, 0], period_s: 0.05}}
controllers:
  keep: {three_axis_compensation: {rope: hoist, drive: winching, joints: [{drive: slewing}, {drive: luffing}], period_s: 0.05, position_gain_per_s: 0}}
";

const CONTROLLER: &str = "controllers.keep.three_axis_compensation";

/// A deck that rolls by 0.05 rad in 8 s, and a platform on it in a gimbal on a column.
const PLATFORM: &str = "
version: 1
title: A platform on a deck that rolls
simulation: {step_s: 0.01, duration_s: 60, record_every_s: 0.05}
bodies:
  deck:
    mass_kg: 1.0e6
    inertia: {radii_of_gyration: {radii_m: [100, 100, 100]}}
    joint: {revolute: {name: roll, axis: [1, 0, 0], initial_angle_rad: 0.05, spring: {stiffness_N_m_per_rad: 6.168502750680849e9}}}
  column:
    parent: deck
    mass_kg: 100
    shape: {box: {length_m: 1, width_m: 1, height_m: 1}}
    joint: {prismatic: {name: rise, axis: [0, 0, 1], position_m: [0, 3, 2]}}
  ring:
    parent: column
    mass_kg: 1000
    shape: {box: {length_m: 1, width_m: 1, height_m: 0.2}}
    joint: {revolute: {name: tilt_x, axis: [1, 0, 0]}}
  platform:
    parent: ring
    mass_kg: 10000
    shape: {box: {length_m: 2, width_m: 2, height_m: 0.2}}
    joint: {revolute: {name: tilt_y, axis: [0, 1, 0]}}
forces:
  gravity: {gravity: {}}
drives:
  rising: {linear_controlled_drive: {joint: rise, set_point: {speed: {}}, speed_limit_m_s: 1, acceleration_limit_m_s2: 20, force_limit_N: 1.0e6, stiffness_N_per_m: 1.0e7, damping_N_s_per_m: 5.0e5, response_time_s: 0.1}}
  about_x: {controlled_drive: {joint: tilt_x, set_point: {speed: {}}, speed_limit_rad_s: 1, acceleration_limit_rad_s2: 20, torque_limit_N_m: 1.0e6, stiffness_N_m_per_rad: 3.0e6, damping_N_m_s_per_rad: 1.5e5, response_time_s: 0.1}}
  about_y: {controlled_drive: {joint: tilt_y, set_point: {speed: {}}, speed_limit_rad_s: 1, acceleration_limit_rad_s2: 20, torque_limit_N_m: 1.0e6, stiffness_N_m_per_rad: 3.0e6, damping_N_m_s_per_rad: 1.5e5, response_time_s: 0.1}}
sensors:
  mru: {motion_reference_unit: {body: deck, position_m: [0, 0, 0], period_s: 0.05, delay_samples: 2}}
controllers:
  keep: {platform_compensation: {body: platform, joints: [{drive: rising}, {drive: about_x}, {drive: about_y}], period_s: 0.05, position_gain_per_s: 0}}
";

fn built(text: &str, changes: &[(&str, Value)]) -> Result<Simulation, String> {
    let lead = if text == DECK { CONTROLLER } else { "controllers.keep.platform_compensation" };
    let changes: Vec<(String, Value)> =
        changes.iter().map(|(path, value)| (path.replace("KEEP", lead), value.clone())).collect();
    let scenario = read(text, "deck.yaml", &changes).map_err(|error| error.to_string())?;
    scenario.simulation().map_err(|error| error.to_string())
}

fn changed(text: &str, changes: &[(&str, Value)]) -> Simulation {
    built(text, changes).unwrap_or_else(|error| panic!("{error}"))
}

const PERIOD_S: f64 = 8.0;
const STEPS: usize = 800;

/// Amplitudes of the components of an output at the period, after the first 40 s, by sums over two periods; the drift from
/// one to the next is taken off.
fn left(simulation: &mut Simulation, output: &str) -> [f64; 3] {
    simulation.step(4000).unwrap();
    let rows: Vec<Vec<f64>> = (0..2 * STEPS)
        .map(|_| {
            let row = values(simulation, output)[..3].to_vec();
            simulation.step(1).unwrap();
            row
        })
        .collect();
    [0, 1, 2].map(|axis| {
        let sum = |rows: &[Vec<f64>]| rows.iter().map(|row| row[axis]).sum::<f64>();
        let drift = (sum(&rows[STEPS..]) - sum(&rows[..STEPS])) / STEPS as f64;
        let [mut cosine, mut sine] = [0.0; 2];
        for (k, row) in rows.iter().enumerate() {
            let share = k as f64 / STEPS as f64;
            let (angle, value) = (TAU * share, row[axis] - drift * share);
            cosine += value * angle.cos() / STEPS as f64;
            sine += value * angle.sin() / STEPS as f64;
        }
        cosine.hypot(sine)
    })
}

/// |1 - H| of a velocity that is measured this much later, held for 0.05 s, and followed with a lag of 0.1 s.
fn rest(delay_s: f64) -> f64 {
    let frequency = TAU / PERIOD_S;
    let (half, lag) = (frequency * 0.025, frequency * 0.1);
    let size = half.sin() / half / (1.0 + lag * lag).sqrt();
    let angle = -(frequency * delay_s + half + lag.atan());
    (1.0 - size * angle.cos()).hypot(size * angle.sin())
}

/// Share of the motion that the crane's changing geometry adds within a period, of second order in 0.2 m over 7.5 m of
/// reach.
const OF_THE_GEOMETRY: f64 = 5e-3;

#[test]
fn the_residual_of_a_sway_in_each_axis_agrees_with_the_formula() {
    for (sensor, delay_s) in [(json!(null), 0.0), (json!("mru"), 0.1)] {
        let [x, y, z] = left(&mut changed(DECK, &[("KEEP.sensor", sensor)]), "compensation_offset");
        let (x, y, expected) = (x / 0.12, y / 0.16, rest(delay_s));
        assert!((x - expected).abs() < OF_THE_GEOMETRY, "x: {x}, not {expected}");
        assert!((y - expected).abs() < OF_THE_GEOMETRY, "y: {y}, not {expected}");
        // The winch takes up what luffing does to the height: it is commanded together with it, and lags alike.
        assert!(z < 0.2 * OF_THE_GEOMETRY, "z: {z} m");
    }
}

#[test]
fn with_prediction_the_residual_of_a_sway_is_less_than_one_percent() {
    for sensor in [json!(null), json!("mru")] {
        let changes =
            [("KEEP.sensor", sensor), ("KEEP.prediction", json!({})), ("KEEP.position_gain_per_s", json!(0.3))];
        let [x, y, z] = left(&mut changed(DECK, &changes), "compensation_offset");
        let share = (x * x + y * y + z * z).sqrt() / 0.2;
        assert!(share < 0.015, "{share}");
    }
}

#[test]
fn an_operator_moves_the_point_along_the_worlds_axes_while_the_deck_sways() {
    let mut simulation = changed(DECK, &[("KEEP.position_gain_per_s", json!(0.5)), ("KEEP.prediction", json!({}))]);
    simulation.step(1000).unwrap();
    for (input, speed) in [("keep.x_speed", -0.05), ("keep.y_speed", 0.04), ("keep.lowering_speed", 0.03)] {
        simulation.set_input(input, speed).unwrap();
    }
    simulation.step(2000).unwrap();
    for input in ["keep.x_speed", "keep.y_speed", "keep.lowering_speed"] {
        simulation.set_input(input, 0.0).unwrap();
    }
    simulation.step(1500).unwrap();
    // The offset is from the point that has moved by 1 m, 0.8 m and 0.6 m.
    let offset = values(&mut simulation, "compensation_offset")[..3].to_vec();
    assert!(offset.iter().all(|off| off.abs() < 0.02), "{offset:?}");
}

/// Drives that are too slow give their maximum; when the deck has stopped, the tip returns without overshoot.
#[test]
fn the_integrals_do_not_wind_up_at_the_limits_of_the_drives() {
    let slow = ("drives.slewing.controlled_drive.speed_limit_rad_s", json!(0.008));
    let mut simulation = changed(DECK, &[slow, ("KEEP.position_gain_per_s", json!(0.5))]);
    let mut most: f64 = 0.0;
    let mut asked: f64 = 0.0;
    for _ in 0..3200 {
        simulation.step(1).unwrap();
        let offset = values(&mut simulation, "compensation_offset")[..3].to_vec();
        most = most.max(offset[0].hypot(offset[1]));
        asked = asked.max(values(&mut simulation, "compensation_utilisation")[0]);
    }
    assert!(asked > 1.0, "{asked}");
    // The deck moves 0.4 m from its first place.
    assert!(most < 0.45, "{most} m");
}

/// With the boom level, luffing moves the tip only up and down: no drive can move it outward, and no such
/// speed is commanded.
#[test]
fn at_a_singular_position_the_speeds_stay_within_their_limits() {
    let level = ("bodies.boom.joint.revolute.initial_angle_deg", json!(0));
    let near = ("bodies.load.joint.floating.initial.position_m", json!([10.12, 0.16, 0]));
    let mut simulation = changed(DECK, &[level, near, ("KEEP.position_gain_per_s", json!(0.5))]);
    for _ in 0..1600 {
        simulation.step(1).unwrap();
        let rates = values(&mut simulation, "joint_velocity");
        assert!(rates.iter().all(|rate| rate.is_finite()));
        assert!(values(&mut simulation, "compensation_utilisation")[0] < 3.0);
    }
    // Sideways the tip still stands.
    let offset = values(&mut simulation, "compensation_offset")[..3].to_vec();
    assert!(offset[1].abs() < 0.1, "{offset:?}");
}

#[test]
fn the_residual_of_a_level_platform_agrees_with_the_formula() {
    for (sensor, delay_s) in [(json!(null), 0.0), (json!("mru"), 0.1)] {
        let found = left(&mut changed(PLATFORM, &[("KEEP.sensor", sensor)]), "platform_offset");
        let expected = rest(delay_s);
        // Sine and angle differ by 0.05^2 / 6; the column leans with the deck, which changes its height in second order.
        let [tilt, pitch, height] = [found[0] / 0.05, found[1], found[2] / 0.15];
        assert!((tilt - expected).abs() < OF_THE_GEOMETRY, "tilt: {tilt}, not {expected}");
        assert!((height - expected).abs() < 2.0 * OF_THE_GEOMETRY, "height: {height}, not {expected}");
        assert!(pitch < 1e-6, "{pitch}");
    }
}

/// The unit is 5 m off the roll axis, its antenna 10 m above and 7 m to the other side. With exact sensors what is left is the
/// curvature of the motion over the age of a position, up to 0.2 s: of the unit's and of the antenna's.
#[test]
fn a_receiver_gives_a_unit_its_slow_motion_through_the_lever_arm_between_them() {
    let unit = |filter: Value| json!({"motion_reference_unit": {"body": "deck", "position_m": [1, 5, 1], "period_s": 0.05, "horizontal_motion": true, "heave_filter": filter}});
    let receiver =
        json!({"satellite_receiver": {"body": "deck", "position_m": [3, -2, 11], "period_s": 0.1, "delay_samples": 1}});
    let mut plain = changed(PLATFORM, &[("sensors.mru", unit(json!(null))), ("sensors.gnss", receiver.clone())]);
    let filter = json!({"cutoff_period_s": 15, "receiver": "gnss"});
    let mut helped = changed(PLATFORM, &[("sensors.mru", unit(filter)), ("sensors.gnss", receiver)]);
    let (mut most, w) = ([0.0_f64; 4], TAU / PERIOD_S);
    plain.step(5000).unwrap();
    helped.step(5000).unwrap();
    for _ in 0..160 {
        for (most, signal) in most.iter_mut().zip(["heave", "y", "heave_rate", "y_velocity"]) {
            let signal = format!("measured_{signal}");
            let [exact, found] = [&mut plain, &mut helped].map(|simulation| values(simulation, &signal)[0]);
            *most = most.max((found - exact).abs());
        }
        plain.step(5).unwrap();
        helped.step(5).unwrap();
    }
    // Amplitudes of the unit: 0.05 rad times 5 m in heave, 1 m in sway; of the antenna 2 m and 11 m.
    let curvature = (w * 0.2).powi(2) / 2.0;
    let allowed = [0.25 + 0.1, 0.05 + 0.55].map(|amplitude| curvature * amplitude);
    assert!(most[0] < allowed[0] && most[1] < allowed[1], "{most:?}, allowed {allowed:?}");
    assert!(most[2] < w * allowed[0] && most[3] < w * allowed[1], "{most:?}, allowed {allowed:?} times {w}");
}

#[test]
fn a_platform_that_begins_tilted_becomes_level() {
    let changes =
        [("KEEP.position_gain_per_s", json!(0.5)), ("KEEP.prediction", json!({})), ("KEEP.sensor", json!("mru"))];
    let tilted = [("bodies.platform.joint.revolute.initial_angle_rad", json!(0.1))];
    let mut simulation = changed(PLATFORM, &[changes.as_slice(), &tilted].concat());
    simulation.step(4000).unwrap();
    let offset = values(&mut simulation, "platform_offset")[..3].to_vec();
    assert!(offset[..2].iter().all(|tilt| tilt.abs() < 2e-3), "{offset:?}");
}

#[test]
fn a_mistake_is_told_with_its_place() {
    let cylinder = json!({"cylinder": {
        "first": {"body": "pedestal", "position_m": [1, 0, 0]}, "second": {"body": "boom", "position_m": [-2, 0, 0]},
        "shortest_m": 0.5, "longest_m": 6, "target": {"length": {"length_m": 4}}, "speed_limit_m_s": 1, "push_limit_kN": 1000,
        "pull_limit_kN": 1000, "stiffness_kN_per_m": 1000, "damping_kN_s_per_m": 100,
    }});
    let cases: [(&[(&str, Value)], &str); 6] = [
        (&[("drives.luffing", cylinder)], "keep.three_axis_compensation.joints.1.drive: found luffing, "),
        (
            &[("KEEP.joints", json!([{"drive": "slewing"}]))],
            "keep.three_axis_compensation.joints: found 1, allowed: at least 2 drives",
        ),
        (
            &[("KEEP.joints.1.drive", json!("lufing"))],
            "keep.three_axis_compensation.joints.1.drive: found lufing, allowed: ",
        ),
        (&[("KEEP.joints.1.drive", json!("winching")), ("KEEP.drive", json!("winching"))], "winching, which keep sets"),
        (
            &[("KEEP.sensor", json!("blind"))],
            "keep.three_axis_compensation.sensor: found blind, which measures no horizontal motion, allowed: a motion reference unit with horizontal_motion: true",
        ),
        (&[("KEEP.rope", json!("rope"))], "keep.three_axis_compensation.rope: found rope, allowed: hoist"),
    ];
    for (changes, expected) in cases {
        let found = built(DECK, changes).map(drop).expect_err("a mistake");
        assert!(found.contains(expected), "{found}\nlacks: {expected}");
    }
}

#[test]
fn rejects_a_platform_that_is_no_body() {
    let found = built(PLATFORM, &[("KEEP.body", json!("plattform"))]).map(drop).expect_err("a mistake");
    assert!(found.contains("keep.platform_compensation.body: found plattform, allowed: one of "), "{found}");
}
