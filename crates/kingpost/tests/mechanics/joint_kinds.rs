//! Every kind of joint in a scenario: against motions with known closed forms, against other joints with
//! equal motion, and errors for each mistake.

use crate::common;

use common::{simulation, values};
use kingpost::scenario::read;

const GRAVITY: f64 = 9.80665;
const BODY: &str =
    "mass_kg: 3, inertia: {tensor: {moments_kg_m2: [0.4, 0.6, 0.9], products_kg_m2: [0.05, -0.1, 0.02]}}";

/// A body on a joint, with gravity and other elements.
fn one_body(joint: &str, more: &str) -> String {
    format!("version: 1\ntitle: One body\nbodies: {{body: {{{BODY}, joint: {joint}}}}}\n{more}\n")
}

const WEIGHT: &str = "forces: {weight: {gravity: {}}}";

fn angular_velocity(text: &str, steps: usize) -> Vec<f64> {
    let mut simulation = simulation(text);
    simulation.step(steps).unwrap();
    values(&mut simulation, "angular_velocity")
}

fn assert_equal(a: &[f64], b: &[f64], tolerance: f64) {
    assert_eq!(a.len(), b.len());
    assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < tolerance), "{a:?}\n{b:?}");
}

#[test]
fn a_ball_joint_at_the_centre_of_mass_turns_as_a_free_body_does() {
    // The Dzhanibekov motion: both integrate the same rotation, to rounding.
    let ball = one_body(
        "{spherical: {initial_orientation_deg: [10, 20, 30], initial_angular_velocity_rad_s: [0.1, 7, 0.2]}}",
        WEIGHT,
    );
    let held = one_body(
        "{floating: {hold_translation: true, initial: {orientation_deg: [10, 20, 30], angular_velocity_rad_s: [0.1, 7, 0.2]}}}",
        WEIGHT,
    );
    assert_equal(&angular_velocity(&ball, 3000), &angular_velocity(&held, 3000), 1e-9);
}

#[test]
fn a_held_ball_joint_is_a_fixed_joint() {
    let chain = |joint: &str| {
        format!(
            "version: 1\ntitle: Chain\nbodies:\n  arm: {{{BODY}, joint: {{revolute: {{axis: [0, 1, 0], child_position_m: [-1, 0, 0.2]}}}}}}\n  \
             tip: {{parent: arm, {BODY}, joint: {joint}}}\n{WEIGHT}\n"
        )
    };
    let ball = chain(
        "{spherical: {held: true, position_m: [1, 0, 0], child_position_m: [-0.5, 0, 0.3], initial_orientation_rad: [0.4, 0.3, 0.2]}}",
    );
    let fixed =
        chain("{fixed: {position_m: [1, 0, 0], child_position_m: [-0.5, 0, 0.3], orientation_rad: [0.4, 0.3, 0.2]}}");
    assert_equal(&angular_velocity(&ball, 1000), &angular_velocity(&fixed, 1000), 1e-11);
    let reaction = |text: &str| values(&mut simulation(text), "joint_reaction");
    assert_equal(&reaction(&ball), &reaction(&fixed), 1e-10);
}

#[test]
fn a_universal_joint_equals_two_hinges_with_a_nearly_massless_body_between_them() {
    let rest = "position_m: [0, 0, 1]";
    let whole = one_body(
        &format!(
            "{{universal: {{first_axis: [1, 0, 0], second_axis: [0, 1, 0], {rest}, child_position_m: [0.1, 0.2, 0.7], \
                  first: {{initial_angle_rad: 0.5, initial_rate_rad_s: 1}}, second: {{initial_angle_rad: -0.4, damping_N_m_s: 0.3}}}}}}"
        ),
        WEIGHT,
    );
    let two = format!(
        "version: 1\ntitle: Two hinges\nbodies:\n  cross: {{mass_kg: 1e-9, inertia: {{tensor: {{moments_kg_m2: [1e-9, 1e-9, 1e-9]}}}}, \
         joint: {{revolute: {{axis: [1, 0, 0], {rest}, initial_angle_rad: 0.5, initial_rate_rad_s: 1}}}}}}\n  \
         body: {{parent: cross, {BODY}, joint: {{revolute: {{axis: [0, 1, 0], child_position_m: [0.1, 0.2, 0.7], \
         initial_angle_rad: -0.4, damping_N_m_s: 0.3}}}}}}\n{WEIGHT}\n"
    );
    let (mut whole, mut two) = (simulation(&whole), simulation(&two));
    for _ in 0..10 {
        whole.step(100).unwrap();
        two.step(100).unwrap();
        assert_equal(&whole.state().q, &two.state().q, 1e-7);
    }
}

#[test]
fn a_rod_in_a_vertical_sleeve_falls_and_spins_on() {
    let text = one_body(
        "{cylindrical: {axis: [0, 0, 1], rotation: {initial_rate_rad_s: 2}, translation: {initial_speed_m_s: 1}}}",
        WEIGHT,
    );
    let mut simulation = simulation(&text);
    simulation.step(700).unwrap();
    let t = 0.7;
    assert_equal(&simulation.state().q, &[2.0 * t, t - 0.5 * GRAVITY * t * t], 1e-12);
    assert_equal(&values(&mut simulation, "joint_position"), &simulation.state().q.clone(), 1e-15);
    let channel = simulation.channels().iter().find(|c| c.variable == "joint_position").unwrap();
    assert_eq!(channel.labels, [["body.rotation", "body.translation"]]);
    assert_eq!((channel.unit, channel.units.as_slice()), (None, ["rad", "m"].as_slice()));
}

#[test]
fn a_puck_glides_straight_and_spins_steadily_for_any_reference_point() {
    // Drawn by a point of its rim, the centre of mass still goes straight on a level deck.
    let text = one_body(
        "{planar: {normal: [0, 0, 1], x_axis: [0, 1, 0], child_position_m: [0.4, 0.1, 0], x: {initial_speed_m_s: 2}, \
         rotation: {initial_rate_rad_s: 3}}}",
        WEIGHT,
    );
    let mut simulation = simulation(&text);
    let (start, velocity) = (values(&mut simulation, "position"), values(&mut simulation, "velocity"));
    simulation.step(800).unwrap();
    let expected: Vec<f64> = start.iter().zip(&velocity).map(|(x, v)| x + 0.8 * v).collect();
    assert_equal(&values(&mut simulation, "position"), &expected, 1e-10);
    assert_equal(&values(&mut simulation, "angular_velocity"), &[0.0, 0.0, 3.0], 1e-10);
}

#[test]
fn a_drive_may_name_an_axis_of_a_joint_and_a_lever_sets_a_brake() {
    let joint = "{cylindrical: {name: rod, axis: [1, 0, 0], translation: {rotor_inertia_kg_m2: 0.02, gear_ratio_rad_per_m: 10}}}";
    let text = one_body(
        joint,
        "drives: {push: {linear_motor: {joint: rod.translation, force_N: 10}}, \
         grip: {linear_brake: {joint: rod.translation, force_N: 100, state: lever}}, \
         turn: {motor: {joint: rod.rotation, torque_N_m: 0.8}}}",
    );
    let mut simulation = simulation(&text);
    let input = simulation.inputs()[0].clone();
    assert_eq!((input.name.as_str(), input.lower, input.upper, input.value), ("grip", 0.0, 1.0, 1.0));
    simulation.step(500).unwrap();
    // Held, it creeps at the smoothing speed times 0.1 / sqrt(1 - 0.01).
    assert!((simulation.state().v[1] - 0.01 * 0.1 / 0.99_f64.sqrt()).abs() < 1e-9);
    assert!((simulation.state().v[0] - 0.8 / 0.4 * 0.5).abs() < 1e-9);
    simulation.set_input("grip", 0.0).unwrap();
    let before = simulation.state().v[1];
    simulation.step(500).unwrap();
    assert!((simulation.state().v[1] - before - 10.0 / (3.0 + 2.0) * 0.5).abs() < 1e-9);
}

#[test]
fn stops_keep_a_hinge_within_its_limits_and_the_ledger_closes() {
    let text = one_body(
        "{revolute: {axis: [0, 1, 0], child_position_m: [0, 0, 1], initial_angle_deg: 60, friction: {torque_N_m: 0.5}, \
         limits: {lower_deg: -20, upper_deg: 80, stiffness_N_m_per_rad: 1e5, dissipation_s_per_rad: 0.2}}}",
        WEIGHT,
    );
    let mut simulation = simulation(&text);
    let mut lowest = 0.0_f64;
    for _ in 0..4000 {
        simulation.step(1).unwrap();
        lowest = lowest.min(simulation.state().q[0].to_degrees());
    }
    // Depth at the speed of the fall, some 4 rad/s: sqrt(I / k) times the speed.
    assert!((-21.5..-20.0).contains(&lowest), "{lowest}");
    let energy = values(&mut simulation, "energy_dissipated")[0];
    assert!(energy > 1.0);
    assert!(values(&mut simulation, "energy_error")[0].abs() < 1e-3 * energy);
}

/// Returns the error of a body's joint, without its place.
fn refusal(joint: &str, more: &str) -> String {
    let text = one_body(joint, more);
    let error = read(&text, "x.yaml", &[]).and_then(|s| s.setup().map(drop)).expect_err("this should be refused");
    assert!(error.line.is_some(), "{error}");
    format!("{}: found {}, allowed: {}", error.field, error.found, error.allowed)
}

#[test]
fn a_lower_limit_above_the_upper_and_missing_limits_are_refused() {
    assert_eq!(
        refusal("{revolute: {axis: [0, 0, 1], limits: {lower_rad: 1, upper_rad: 1, stiffness_N_m_per_rad: 9}}}", ""),
        "bodies.body.joint.revolute.limits.lower_rad: found 1, allowed: less than upper_rad, 1"
    );
    assert_eq!(
        refusal(
            "{cylindrical: {axis: [0, 0, 1], translation: {limits: {lower_m: 2, upper_m: -1, stiffness_N_per_m: 9}}}}",
            ""
        ),
        "bodies.body.joint.cylindrical.translation.limits.lower_m: found 2, allowed: less than upper_m, -1"
    );
    assert_eq!(
        refusal("{revolute: {axis: [0, 0, 1], limits: {stiffness_N_m_per_rad: 9}}}", ""),
        "bodies.body.joint.revolute.limits: found no limit, allowed: lower_rad, upper_rad, or both"
    );
}

#[test]
fn axes_that_are_not_perpendicular_or_zero_are_refused() {
    assert_eq!(
        refusal("{universal: {first_axis: [1, 0, 0], second_axis: [1, 1, 0]}}", ""),
        "bodies.body.joint.universal.second_axis: found a direction 45.0000 degrees from first_axis, \
         allowed: one perpendicular to first_axis"
    );
    assert!(
        refusal("{planar: {normal: [0, 0, 1], x_axis: [0, 0, 2]}}", "").starts_with("bodies.body.joint.planar.x_axis")
    );
    assert_eq!(
        refusal("{universal: {first_axis: [0, 0, 0], second_axis: [1, 1, 0]}}", ""),
        "bodies.body.joint.universal.first_axis: found [0, 0, 0], allowed: three numbers, not all 0"
    );
}

#[test]
fn constants_out_of_range_are_refused() {
    let hinge = |field: &str| refusal(&format!("{{revolute: {{axis: [0, 0, 1], {field}}}}}"), "");
    for (field, allowed) in [
        ("rotor_inertia_kg_m2: -1", "a number not less than 0"),
        ("gear_ratio: 0", "a number greater than 0"),
        ("friction: {torque_N_m: -1}", "a number not less than 0"),
        ("friction: {torque_N_m: 1, smoothing_rad_s: 0}", "a number greater than 0"),
        ("spring: {stiffness_N_m_per_rad: -1}", "a number not less than 0"),
        ("limits: {upper_rad: 1, stiffness_N_m_per_rad: 0}", "a number greater than 0"),
    ] {
        assert!(hinge(field).ends_with(allowed), "{field}");
    }
}

#[test]
fn rates_of_held_coordinates_are_refused() {
    let allowed = "allowed: 0, for a coordinate that is held or prescribed";
    assert_eq!(
        refusal("{planar: {normal: [0, 0, 1], x_axis: [1, 0, 0], y: {mode: held, initial_speed_m_s: 1}}}", ""),
        format!("bodies.body.joint.planar.y.initial_speed_m_s: found 1, {allowed}")
    );
    assert_eq!(
        refusal("{spherical: {held: true, initial_angular_velocity_rad_s: [0, 2, 0]}}", ""),
        format!("bodies.body.joint.spherical.initial_angular_velocity_rad_s: found 2, {allowed}")
    );
    assert_eq!(
        refusal(
            "{universal: {first_axis: [1, 0, 0], second_axis: [0, 1, 0], second: {mode: {prescribed: {rate_rad_s: 1, history: lever}}}}}",
            ""
        ),
        "bodies.body.joint.universal.second.mode.prescribed.history: found lever, \
         allowed: constant, pulse or list, for a prescribed motion"
    );
}

#[test]
fn a_drive_on_an_axis_of_the_other_kind_or_without_an_axis_is_refused() {
    let rod = "{cylindrical: {name: rod, axis: [1, 0, 0]}}";
    for (drive, allowed) in [
        ("motor: {joint: rod.translation, torque_N_m: 1}", "one of rod.rotation"),
        ("linear_brake: {joint: rod, force_N: 1}", "one of rod.translation"),
        ("brake: {joint: rod.pitch, torque_N_m: 1}", "one of rod.rotation"),
        ("motor: {joint: rod.rotation.x, torque_N_m: 1}", "a name of a joint, or of an axis of a joint as joint.axis"),
    ] {
        let error = refusal(rod, &format!("drives: {{d: {{{drive}}}}}"));
        assert!(error.ends_with(&format!("allowed: {allowed}")), "{error}");
    }
}

#[test]
fn a_coordinate_that_moves_no_mass_is_named_unless_it_has_a_rotor() {
    let text = |joint: &str| {
        format!("version: 1\ntitle: x\nbodies: {{bob: {{mass_kg: 1, shape: {{point: {{}}}}, joint: {joint}}}}}\n")
    };
    let error = |joint: &str| read(&text(joint), "x.yaml", &[]).map(drop).expect_err("refused").to_string();
    let found = |coordinate: &str| format!("an inertia along {coordinate} that is zero to 16 digits");
    assert!(error("{spherical: {child_position_m: [0, 0, 1]}}").contains(&found("bob.z")));
    let universal = |second: &str| {
        format!("{{universal: {{first_axis: [1, 0, 0], second_axis: [0, 0, 1], child_position_m: [0, 0, 1]{second}}}}}")
    };
    assert!(error(&universal("")).contains(&found("bob.second")));
    assert!(read(&text(&universal(", second: {rotor_inertia_kg_m2: 0.1}")), "x.yaml", &[]).is_ok());
    assert!(
        read(&text("{planar: {normal: [0, 0, 1], x_axis: [1, 0, 0], rotation: {mode: held}}}"), "x.yaml", &[]).is_ok()
    );
}
