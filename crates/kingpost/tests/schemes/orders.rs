//! Every scheme has its order: on joint angles, on the ship's rotation matrix and on energy.

use crate::common;

use common::paper;
use kingpost::Simulation;
use kingpost::spatial::Quaternion;
use serde_json::json;

const END_S: f64 = 0.4;

/// Both motors, crane at the centre, no load; the work is integrated by the same scheme.
fn run(integrator: &str, step_s: f64) -> Simulation {
    let mut simulation = paper(&[
        ("crane_x_m", json!(0.0)),
        ("crane_y_m", json!(0.0)),
        ("motor_2", json!(true)),
        ("simulation.integrator", json!(integrator)),
        ("simulation.step_s", json!(step_s)),
    ]);
    simulation.step((END_S / step_s).round() as usize).unwrap();
    simulation
}

/// Joint angles, the ship's rotation matrix, and the energy error, each as a list.
fn quantities(simulation: &mut Simulation) -> [Vec<f64>; 3] {
    let q = simulation.state().q.clone();
    let rotation = Quaternion::from_slice(&q[3..7]).to_matrix();
    let mut row = Vec::new();
    simulation.write_row(&mut row);
    let channel = simulation.channels().iter().find(|c| c.variable == "energy_error").unwrap();
    [q[7..].to_vec(), rotation.0.concat(), vec![row[channel.offset]]]
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |m, (a, b)| m.max((a - b).abs()))
}

/// Orders from halving the step, by quantity. The energy error needs no reference: it is zero.
fn measured_orders(integrator: &str, step_s: f64) -> [f64; 3] {
    let mut reference = quantities(&mut run("rk4", 0.000_125));
    reference[2] = vec![0.0];
    let [coarse, fine] = [step_s, step_s / 2.0].map(|step| quantities(&mut run(integrator, step)));
    core::array::from_fn(|i| (distance(&coarse[i], &reference[i]) / distance(&fine[i], &reference[i])).log2())
}

#[test]
fn runge_kutta_of_munthe_kaas_has_order_four() {
    for (order, what) in measured_orders("rk4", 0.01).into_iter().zip(["angles", "rotation", "energy"]) {
        assert!((order - 4.0).abs() < 0.25, "{what}: order {order}");
    }
}

#[test]
fn forward_euler_has_order_one() {
    for (order, what) in measured_orders("forward_euler", 0.001).into_iter().zip(["angles", "rotation", "energy"]) {
        assert!((order - 1.0).abs() < 0.1, "{what}: order {order}");
    }
}

#[test]
fn midpoint_rate_euler_has_order_one() {
    for (order, what) in measured_orders("midpoint_euler", 0.001).into_iter().zip(["angles", "rotation", "energy"]) {
        assert!((order - 1.0).abs() < 0.1, "{what}: order {order}");
    }
}

#[test]
fn semi_implicit_euler_has_order_one() {
    for (order, what) in measured_orders("semi_implicit_euler", 0.001).into_iter().zip(["angles", "rotation", "energy"])
    {
        assert!((order - 1.0).abs() < 0.1, "{what}: order {order}");
    }
}

#[test]
fn the_implicit_schemes_have_order_two() {
    for integrator in ["newmark", "generalized_alpha", "implicit_midpoint"] {
        for (order, what) in measured_orders(integrator, 0.005).into_iter().zip(["angles", "rotation", "energy"]) {
            assert!((order - 2.0).abs() < 0.1, "{integrator}, {what}: order {order}");
        }
    }
}

#[test]
fn midpoint_rate_changes_the_rotation_update_and_nothing_else() {
    // Without gravity the accelerations do not depend on the ship's rotation, so the rates of both
    // Euler forms are the same numbers; the rotation update alone differs.
    let (start, middle) = (run("forward_euler", 0.001), run("midpoint_euler", 0.001));
    assert_eq!(start.state().v, middle.state().v);
    assert_eq!(start.state().q[7..], middle.state().q[7..]);
    assert_ne!(start.state().q[3..7], middle.state().q[3..7]);
}

#[test]
fn energy_of_forward_euler_drifts_as_measured_by_others() {
    // K / work - 1 over 0.5 s, both motors, no load: +0.25 % at 1 ms and +2.4 % at 10 ms; RK4 at
    // 10 ms about 7e-7 (independent codes, two digits each).
    for (integrator, step_s, expected, digits) in
        [("forward_euler", 0.001, 0.0025, 1e-4), ("forward_euler", 0.01, 0.024, 1e-3), ("rk4", 0.01, 7e-7, 5e-7)]
    {
        let mut simulation = run(integrator, step_s);
        simulation.step((0.1 / step_s).round() as usize).unwrap();
        let mut row = Vec::new();
        simulation.write_row(&mut row);
        let value = |name: &str| row[simulation.channels().iter().find(|c| c.variable == name).unwrap().offset];
        let excess = value("kinetic_energy") / value("work_done") - 1.0;
        assert!((excess.abs() - expected).abs() < digits, "{integrator} at {step_s} s: {excess:e}");
    }
}

#[test]
fn runge_kutta_keeps_its_order_on_every_kind_of_joint() {
    // Without the dry friction, whose smoothing is too sharp for these steps.
    let text = common::every_joint().replace("friction: {torque_N_m: 0.5}, ", "");
    let at = |step_s: f64| {
        let mut simulation = common::simulation(&text.replace("step_s: 0.0001", &format!("step_s: {step_s}")));
        simulation.step((0.4 / step_s).round() as usize).unwrap();
        (simulation.state().q.clone(), common::values(&mut simulation, "energy_error"))
    };
    let reference = at(0.000_5).0;
    let (coarse, fine) = (at(0.02), at(0.01));
    for (what, ratio) in [
        ("positions", distance(&coarse.0, &reference) / distance(&fine.0, &reference)),
        ("energy", coarse.1[0] / fine.1[0]),
    ] {
        let order = ratio.log2();
        assert!((order - 4.0).abs() < 0.5, "{what}: order {order}");
    }
}

#[test]
fn torque_edges_off_the_step_grid_do_not_reduce_the_order() {
    // The pulse's edges at 0.25, 0.75, ... s fall inside steps of 0.04 s; they end steps all the same.
    let at = |step_s: f64| {
        let mut simulation = paper(&[("torque_history", json!("pulse")), ("simulation.step_s", json!(step_s))]);
        simulation.step((0.96 / step_s).round() as usize).unwrap();
        simulation.state().q[7..].to_vec()
    };
    let reference = at(0.0005);
    let (coarse, fine) = (distance(&at(0.04), &reference), distance(&at(0.02), &reference));
    let order = (coarse / fine).log2();
    assert!(order > 3.5, "order {order}: {coarse:e}, {fine:e}");
}
