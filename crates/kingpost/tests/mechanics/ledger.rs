//! Energy and momentum balance to the order of the scheme.

use crate::common;

use common::{paper, relative_difference, values};
use kingpost::Simulation;
use serde_json::{Value, json};

fn value(simulation: &mut Simulation, variable: &str) -> f64 {
    values(simulation, variable)[0]
}

fn norm(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn centred(more: &[(&'static str, Value)]) -> Vec<(&'static str, Value)> {
    let mut all = vec![("crane_x_m", json!(0.0)), ("crane_y_m", json!(0.0)), ("motor_2", json!(true))];
    all.extend(more.iter().cloned());
    all
}

#[test]
fn paper_row_of_truth() {
    // Ship's centre held, crane at the centre, no load, tower motor alone, no damping, 0.5 s: the
    // digits on which three independent codes agree. Roll, pitch, yaw rate; slew, luff rate; angles.
    let mut simulation = paper(&[("crane_x_m", json!(0.0)), ("crane_y_m", json!(0.0))]);
    simulation.step(500).unwrap();
    let state = simulation.state();
    let found = [&state.v[3..8], &state.q[7..9]].concat();
    let truth = [-0.07719, 0.19709, -0.12348, 6.6699, 0.0338, 1.7159, 0.0632];
    let half_a_digit = [5e-6, 5e-6, 5e-6, 5e-5, 5e-5, 5e-5, 5e-5];
    for ((found, truth), tolerance) in found.iter().zip(truth).zip(half_a_digit) {
        assert!((found - truth).abs() < tolerance, "{found} {truth}");
    }
}

#[test]
fn work_of_the_motors_is_the_kinetic_energy_and_momentum_stays_zero() {
    let error = |step_s: f64| {
        let mut simulation = paper(&centred(&[("simulation.step_s", json!(step_s))]));
        simulation.step((1.0 / step_s).round() as usize).unwrap();
        let energy = value(&mut simulation, "kinetic_energy") / value(&mut simulation, "work_done") - 1.0;
        (energy.abs(), norm(&values(&mut simulation, "angular_momentum")))
    };
    let (energy, momentum) = error(0.001);
    // The crane's own angular momentum is some 1e5 N m s.
    assert!(energy < 1e-8 && momentum < 1e-3, "{energy:e}, {momentum:e}");
    let (coarse, fine) = (error(0.01), error(0.005));
    assert!((coarse.0 / fine.0).log2() > 3.7 && (coarse.1 / fine.1).log2() > 3.7, "{coarse:?} {fine:?}");
}

#[test]
fn a_free_ship_keeps_both_momenta_at_zero() {
    let mut simulation = paper(&[("hold_centre", json!(false)), ("load", json!(true)), ("motor_2", json!(true))]);
    simulation.step(1000).unwrap();
    let scale = value(&mut simulation, "kinetic_energy");
    assert!(scale > 1e4);
    assert!(norm(&values(&mut simulation, "linear_momentum")) < 1e-6);
    assert!(norm(&values(&mut simulation, "angular_momentum")) < 1e-5);
    assert!(value(&mut simulation, "energy_error").abs() < 1e-9 * scale);
}

#[test]
fn without_d_energy_still_closes_and_momentum_does_not() {
    // With the naive variation the term w^T S(w) J w is missing; it does no work, so that the
    // energy does not show it. After 1 s the moment of momentum is off by 28,700 of about 154,000.
    let after_one_second = |form: &str| {
        let mut simulation = paper(&centred(&[("simulation.form", json!(form))]));
        simulation.step(1000).unwrap();
        let energy = value(&mut simulation, "energy_error") / value(&mut simulation, "kinetic_energy");
        (energy.abs(), norm(&values(&mut simulation, "angular_momentum")))
    };
    let (energy, momentum) = after_one_second("moving_frame_without_d");
    assert!(energy < 1e-8, "{energy:e}");
    assert!((momentum - 28_700.0).abs() < 50.0, "{momentum}");
    let (energy, momentum) = after_one_second("moving_frame");
    assert!(energy < 1e-8 && momentum < 1e-3, "{energy:e}, {momentum:e}");
}

#[test]
fn both_forms_make_the_same_run_and_both_ledgers_close() {
    let run = |form: &str| {
        let mut simulation = common::simulation(&common::everything(form));
        simulation.step(1000).unwrap();
        let energy = value(&mut simulation, "kinetic_energy");
        for error in ["energy_error", "momentum_error", "linear_momentum_error"] {
            let error = value(&mut simulation, error).abs();
            assert!(error < 1e-9 * energy, "{form}: {error:e}");
        }
        let state = simulation.state();
        [state.q.clone(), state.v.clone(), state.s.clone()]
    };
    for (recursive, matrices) in run("recursive").iter().zip(&run("moving_frame")) {
        assert!(relative_difference(recursive, matrices) < 1e-10);
    }
}

#[test]
fn momentum_of_a_held_ship_is_about_its_centre_wherever_that_is() {
    let mut simulation = paper(&centred(&[]));
    simulation.step(300).unwrap();
    let (mut q, v) = (simulation.state().q.clone(), simulation.state().v.clone());
    let here = values(&mut simulation, "angular_momentum");
    (q[0], q[1]) = (100.0, -40.0);
    simulation.set_state(&q, &v, None).unwrap();
    let there = values(&mut simulation, "angular_momentum");
    assert!(here.iter().zip(&there).all(|(a, b)| (a - b).abs() < 1e-6));
}

#[test]
fn the_ledger_closes_with_everything_on() {
    // Gravity, damping of the ship, both motors, the centre held: work, heat, potential energy and
    // the moments of weight and damping about the held centre all enter.
    for hold_centre in [true, false] {
        let mut simulation = paper(&[
            ("hold_centre", json!(hold_centre)),
            ("gravity", json!(true)),
            ("damping", json!(true)),
            ("load", json!(true)),
            ("motor_2", json!(true)),
            ("torque_history", json!("pulse")),
        ]);
        simulation.step(1500).unwrap();
        let energy = value(&mut simulation, "kinetic_energy");
        assert!(value(&mut simulation, "energy_dissipated") > 1.0);
        assert!(value(&mut simulation, "energy_error").abs() < 1e-8 * energy);
        let momentum = norm(&values(&mut simulation, "angular_momentum"));
        assert!(value(&mut simulation, "momentum_error") < 1e-8 * momentum);
        let linear = norm(&values(&mut simulation, "linear_momentum"));
        assert!(value(&mut simulation, "linear_momentum_error") < 1e-8 * linear);
    }
}

#[test]
fn heat_of_the_damping_leaves_the_energy_balance() {
    let mut simulation = paper(&centred(&[("damping", json!(true))]));
    simulation.step(1000).unwrap();
    let kinetic = value(&mut simulation, "kinetic_energy");
    let balance = value(&mut simulation, "work_done") - value(&mut simulation, "energy_dissipated");
    assert!((kinetic - balance).abs() < 1e-8 * kinetic);
}
