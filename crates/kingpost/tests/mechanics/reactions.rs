//! Reactions that joints carry, against statics.

use crate::common;

use common::{EVERY_JOINT, EVERY_MASS, EVERY_MOMENTS, every_joint, simulation, values};
use kingpost::Simulation;
use kingpost::spatial::{Matrix3, Quaternion, Vector3, exp};

const GRAVITY: f64 = 9.80665;

/// A pedestal on the world, a level boom held on it, a load lashed to the boom's tip.
fn at_rest() -> Vec<[f64; 6]> {
    let text = "
version: 1
title: Statics
bodies:
  pedestal: {mass_kg: 1000, shape: {box: {length_m: 1, width_m: 1, height_m: 2}}, joint: {fixed: {child_position_m: [0, 0, -1]}}}
  boom:
    parent: pedestal
    mass_kg: 100
    shape: {box: {length_m: 4, width_m: 1, height_m: 1}}
    joint: {revolute: {axis: [0, 1, 0], position_m: [0, 0, 1], child_position_m: [-2, 0, 0], mode: held}}
  load: {parent: boom, mass_kg: 50, shape: {point: {}}, joint: {fixed: {position_m: [2, 0, 0]}}}
forces: {gravity: {gravity: {}}}
";
    let mut simulation = simulation(text);
    values(&mut simulation, "joint_reaction").chunks(6).map(|c| c.try_into().unwrap()).collect()
}

fn assert_close(found: [f64; 6], expected: [f64; 6]) {
    assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9 * GRAVITY * 1e3), "{found:?} {expected:?}");
}

#[test]
fn a_lashed_load_hangs_on_its_lashing() {
    assert_close(at_rest()[2], [0.0, 0.0, 50.0 * GRAVITY, 0.0, 0.0, 0.0]);
}

#[test]
fn a_held_boom_has_its_cantilever_moment_at_the_hinge() {
    // Weights at 2 m and 4 m pull the tip down, a positive moment about y; the hinge carries the
    // opposite.
    let moment = -(100.0 * 2.0 + 50.0 * 4.0) * GRAVITY;
    assert_close(at_rest()[1], [0.0, 0.0, 150.0 * GRAVITY, 0.0, moment, 0.0]);
}

#[test]
fn a_pedestal_transmits_all_loads_to_the_world() {
    let moment = -(100.0 * 2.0 + 50.0 * 4.0) * GRAVITY;
    assert_close(at_rest()[0], [0.0, 0.0, 1150.0 * GRAVITY, 0.0, moment, 0.0]);
}

#[test]
fn a_motor_and_its_friction_are_the_force_along_the_joint() {
    let text = "
version: 1
title: A motor against friction
bodies:
  drum:
    mass_kg: 10
    shape: {cylinder: {radius_m: 1, length_m: 1}}
    joint: {revolute: {axis: [0, 0, 1], damping_N_m_s: 4, initial_rate_rad_s: 3}}
drives: {motor: {motor: {joint: drum, torque_N_m: 20}}}
";
    let force = values(&mut simulation(text), "joint_force");
    assert!((force[0] - (20.0 - 4.0 * 3.0)).abs() < 1e-12, "{force:?}");
}

fn vectors(simulation: &mut Simulation, variable: &str) -> Vec<Vector3> {
    values(simulation, variable).chunks(3).map(Vector3::from_slice).collect()
}

fn rotations(simulation: &mut Simulation) -> Vec<Matrix3> {
    values(simulation, "orientation").chunks(4).map(|q| Quaternion::from_slice(q).to_matrix()).collect()
}

/// Angular momentum of each body about its centre, world.
fn angular_momenta(simulation: &mut Simulation) -> Vec<Vector3> {
    let (rotations, rates) = (rotations(simulation), vectors(simulation, "angular_velocity"));
    rotations.iter().zip(rates).map(|(r, rate)| *r * (Matrix3(EVERY_MOMENTS) * rate)).collect()
}

#[test]
fn reactions_and_weight_account_for_the_motion_of_every_body_on_every_joint() {
    let mut simulation = simulation(&every_joint());
    simulation.step(2000).unwrap();
    let before = angular_momenta(&mut simulation);
    simulation.step(1).unwrap();
    let (positions, accelerations) = (vectors(&mut simulation, "position"), vectors(&mut simulation, "acceleration"));
    let (rotations, reactions) = (rotations(&mut simulation), vectors(&mut simulation, "joint_reaction"));
    simulation.step(1).unwrap();
    let after = angular_momenta(&mut simulation);
    let weight = Vector3::new(0.0, 0.0, -EVERY_MASS * GRAVITY);
    for body in 0..EVERY_JOINT.len() {
        let (mut force, mut moment) = (weight, Vector3::zero());
        for (joint, (parent, place)) in EVERY_JOINT.iter().enumerate() {
            let sign = if joint == body { 1.0 } else { -1.0 };
            if joint == body || *parent == Some(body) {
                let r = rotations[joint];
                let (f, m) = (r * reactions[2 * joint] * sign, r * reactions[2 * joint + 1] * sign);
                let lever = positions[joint] + r * Vector3(*place) - positions[body];
                force += f;
                moment += m + lever.cross(f);
            }
        }
        assert!((force - accelerations[body] * EVERY_MASS).norm() < 1e-10, "body {body}: {force:?}");
        // Central differences: |L'''| h^2 / 6, with rates of some rad/s.
        let rate = (after[body] - before[body]) * (0.5 / 1e-4);
        assert!((moment - rate).norm() < 1e-6, "body {body}: {moment:?} {rate:?}");
    }
}

#[test]
fn the_joint_load_along_a_joints_axes_is_the_force_in_these_axes() {
    let mut simulation = simulation(&every_joint());
    simulation.step(2000).unwrap();
    let reactions = vectors(&mut simulation, "joint_reaction");
    let (force, moment) = (|joint: usize| reactions[2 * joint], |joint: usize| reactions[2 * joint + 1]);
    let (q, v) = (values(&mut simulation, "joint_position"), values(&mut simulation, "joint_velocity"));
    let names = simulation.channels().iter().find(|c| c.variable == "joint_position").unwrap().labels[0].clone();
    let at = |name: &str| names.iter().position(|n| n == name).unwrap();
    let close =
        |found: f64, expected: f64, what: &str| assert!((found - expected).abs() < 1e-10, "{what}: {found} {expected}");

    close(force(0).norm() + moment(0).norm(), 0.0, "floating");
    close(moment(1)[2], 0.0, "cylindrical, about its axis");
    close(force(1)[2], -900.0 * q[at("b1.translation")], "cylindrical, along its axis");
    // The first axis in the axes of the child: turned back by the second angle, about y.
    let first = exp(Vector3::new(0.0, -q[at("b2.second")], 0.0)) * Vector3::new(1.0, 0.0, 0.0);
    close(moment(2).dot(first), 1.5, "universal, first");
    close(moment(2)[1], 0.0, "universal, second");
    for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
        close(moment(3)[k], -0.3 * v[at(&format!("b3.{axis}"))], "spherical");
    }
    close(force(4)[0].hypot(force(4)[1]), 0.0, "planar, in the plane");
    let rate = v[at("b4.rotation")];
    close(moment(4)[2], -0.4 * rate / rate.hypot(0.01), "planar, about the normal");
    let rate = v[at("b5")];
    let along = (moment(5)[1] + moment(5)[2]) / 2.0_f64.sqrt();
    close(along, -0.5 * rate / rate.hypot(0.01), "revolute");
    let carried = values(&mut simulation, "joint_force")[at("b6")];
    close(force(6)[0], carried, "prismatic");
}
