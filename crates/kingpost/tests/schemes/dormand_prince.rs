//! Dormand-Prince: errors follow the tolerances, dense output has its order, edges end steps, and changes
//! from outside are detected.

use crate::common;

use common::paper;
use kingpost::Simulation;
use kingpost::simulation::RunError;
use serde_json::{Value, json};

const TEXT: &str = include_str!("../../../../scenarios/paper.yaml");

/// Both motors, crane at the centre, no load.
fn centred(more: &[(&'static str, Value)]) -> Simulation {
    let mut all = vec![
        ("crane_x_m", json!(0.0)),
        ("crane_y_m", json!(0.0)),
        ("motor_2", json!(true)),
        ("simulation.integrator", json!("dormand_prince")),
    ];
    all.extend(more.iter().cloned());
    paper(&all)
}

fn with_tolerance(tolerance: f64, step_s: f64) -> Simulation {
    centred(&[
        ("simulation.dormand_prince.absolute_tolerance", json!(tolerance)),
        ("simulation.dormand_prince.relative_tolerance", json!(tolerance)),
        ("simulation.dormand_prince.largest_step_s", json!(1.0)),
        ("simulation.step_s", json!(step_s)),
    ])
}

/// Positions after a time, by RK4 with steps that leave rounding only.
fn truth(time_s: f64) -> Vec<f64> {
    let mut simulation = centred(&[("simulation.integrator", json!("rk4")), ("simulation.step_s", json!(0.0001))]);
    simulation.step((time_s / 0.0001).round() as usize).unwrap();
    simulation.state().q.clone()
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |m, (a, b)| m.max((a - b).abs()))
}

#[test]
fn errors_follow_the_tolerance() {
    // A step's error of order five is held by an estimate of order four, so that the error at the
    // end goes with a power of the tolerance near one (Hairer, Norsett & Wanner 1993, section II.4);
    // single runs scatter about it, as their last steps fall.
    let end = truth(1.0);
    let error = |tolerance: f64| {
        let mut simulation = with_tolerance(tolerance, 0.1);
        simulation.step(10).unwrap();
        (distance(&simulation.state().q, &end), simulation.evaluations())
    };
    let tolerances = [1e-4, 1e-6, 1e-8, 1e-10];
    let found = tolerances.map(error);
    let power = (found[0].0 / found[3].0).log10() / 6.0;
    assert!((0.8..1.2).contains(&power), "power {power}: {found:?}");
    assert!(found.is_sorted_by(|a, b| a.0 > b.0 && a.1 < b.1), "smaller tolerances cost more: {found:?}");
    assert!(found.iter().zip(tolerances).all(|(found, tolerance)| found.0 < 3.0 * tolerance), "{found:?}");
}

#[test]
fn inner_steps_reach_beyond_the_output_states() {
    let cost = |step_s: f64| {
        let mut simulation = with_tolerance(1e-6, step_s);
        simulation.step((1.0 / step_s).round() as usize).unwrap();
        simulation.evaluations()
    };
    let (often, seldom) = (cost(0.001), cost(0.1));
    // A thousand states cost no more than ten, but for the search for the first step.
    assert!(often < 2 * seldom && often < 500, "{often} {seldom}");
}

/// Largest error of the positions within half a second, at two hundred times, most between the inner steps.
fn dense_error(inner_step_s: f64) -> f64 {
    let step_s = 0.0025;
    let mut reference =
        centred(&[("simulation.integrator", json!("rk4")), ("simulation.step_s", json!(step_s / 10.0))]);
    let mut simulation = centred(&[
        ("simulation.dormand_prince.absolute_tolerance", json!(1.0)),
        ("simulation.dormand_prince.relative_tolerance", json!(1.0)),
        ("simulation.dormand_prince.largest_step_s", json!(inner_step_s)),
        ("simulation.step_s", json!(step_s)),
    ]);
    let mut largest = 0.0_f64;
    for _ in 0..200 {
        reference.step(10).unwrap();
        simulation.step(1).unwrap();
        largest = largest.max(distance(&simulation.state().q, &reference.state().q));
    }
    largest
}

#[test]
fn dense_output_of_order_four_errs_with_the_fifth_power_of_the_inner_step() {
    let (coarse, fine) = (dense_error(0.04), dense_error(0.02));
    let order = (coarse / fine).log2();
    assert!((order - 5.0).abs() < 0.5, "order {order}: {coarse:e} {fine:e}");
}

#[test]
fn edges_of_the_torque_end_inner_steps() {
    // With ramps of 0.25 s a step across an edge would err by its square; here the tolerance holds.
    let run = |integrator: &str, step_s: f64| {
        let mut simulation = paper(&[
            ("torque_history", json!("pulse")),
            ("simulation.integrator", json!(integrator)),
            ("simulation.step_s", json!(step_s)),
            ("simulation.dormand_prince", json!({"absolute_tolerance": 1e-10, "relative_tolerance": 1e-10})),
        ]);
        simulation.step((2.1 / step_s).round() as usize).unwrap();
        simulation.state().q.clone()
    };
    let error = distance(&run("dormand_prince", 0.07), &run("rk4", 0.0005));
    assert!(error < 3e-9, "{error:e}");
}

#[test]
fn a_lever_moved_between_two_steps_acts_from_the_next_on() {
    let run = |integrator: &str, step_s: f64| {
        let mut simulation = paper(&[
            ("drives.motor_1.motor.history", json!("lever")),
            ("simulation.integrator", json!(integrator)),
            ("simulation.step_s", json!(step_s)),
            ("simulation.dormand_prince", json!({"absolute_tolerance": 1e-10, "relative_tolerance": 1e-10})),
        ]);
        for lever in [1.0, -0.5, 0.25] {
            simulation.set_input("motor_1", lever).unwrap();
            simulation.step((0.1 / step_s).round() as usize).unwrap();
        }
        simulation.state().q.clone()
    };
    let error = distance(&run("dormand_prince", 0.02), &run("rk4", 0.0005));
    assert!(error < 1e-9, "{error:e}");
}

#[test]
fn the_scheme_continues_from_a_state_that_is_set() {
    let mut simulation = with_tolerance(1e-8, 0.01);
    simulation.step(7).unwrap();
    let (q, v) = (simulation.state().q.clone(), simulation.state().v.clone());
    simulation.step(3).unwrap();
    simulation.set_state(&q, &v, None).unwrap();
    let mut other = with_tolerance(1e-8, 0.01);
    other.set_state(&q, &v, None).unwrap();
    simulation.step(5).unwrap();
    other.step(5).unwrap();
    // Without a torque history nothing depends on the time itself, but the end of a step does.
    assert!(distance(&simulation.state().q, &other.state().q) < 1e-12);
}

#[test]
fn tolerances_below_rounding_end_the_run_and_rows_are_kept() {
    let mut simulation = with_tolerance(1e-30, 0.01);
    let run = simulation.run(|_| true);
    let Err(RunError::Step(error)) = run.status else { panic!("{:?}", run.status) };
    assert!(error.to_string().contains("step size collapsed"), "{error}");
    assert_eq!(run.rows.len(), run.columns);
}

#[test]
fn the_state_is_returned_at_the_requested_time() {
    // Steps of any size meet the same motion: the inner steps do not follow the outer ones.
    let end = |step_s: f64| {
        let mut simulation = with_tolerance(1e-9, step_s);
        simulation.step((0.6 / step_s).round() as usize).unwrap();
        simulation.state().q.clone()
    };
    let exact = truth(0.6);
    for step_s in [0.001, 0.01, 0.06, 0.3] {
        let error = distance(&end(step_s), &exact);
        assert!(error < 1e-8, "{step_s}: {error:e}");
    }
}

#[test]
fn steps_held_to_less_than_a_thousandth_of_the_step_are_refused() {
    let of = |largest_s: f64| {
        let values = [
            ("simulation.integrator", json!("dormand_prince")),
            ("simulation.dormand_prince.largest_step_s", json!(largest_s)),
            ("simulation.step_s", json!(0.01)),
        ]
        .map(|(name, value)| (name.to_owned(), value));
        kingpost::scenario::read(TEXT, "paper.yaml", &values).and_then(|scenario| scenario.setup().map(drop))
    };
    let error = of(1e-12).expect_err("a step would take 10^10 of them").to_string();
    assert!(error.contains("allowed: at least 1e-5 s, a thousandth of simulation.step_s"), "{error}");
    assert!(of(1e-5).is_ok());
}
