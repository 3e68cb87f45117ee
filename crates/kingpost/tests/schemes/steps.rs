//! Stepping: bitwise identical runs after a snapshot, no allocation, detection of divergence.

use crate::common;

use common::paper;
use kingpost::batch::{self, Variant};
use kingpost::scenario::Files;
use kingpost::simulation::{InputError, PROGRESS_STEPS, RunError};
use kingpost::state::SnapshotError;
use serde_json::json;
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

thread_local! {
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

/// Counts the allocations of this thread.
struct Counting;

// SAFETY: every call is handed to the system allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let _ = ALLOCATIONS.try_with(|count| count.set(count.get() + 1));
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

#[test]
fn a_step_allocates_nothing() {
    for integrator in common::INTEGRATORS {
        let mut simulation = paper(&[
            ("hold_centre", json!(false)),
            ("load", json!(true)),
            ("gravity", json!(true)),
            ("damping", json!(true)),
            ("motor_2", json!(true)),
            ("torque_history", json!("pulse")),
            ("simulation.integrator", json!(integrator)),
            // Off the grid of the pulse's edges, so that steps are cut too.
            ("simulation.step_s", json!(0.0013)),
        ]);
        let before = ALLOCATIONS.with(Cell::get);
        simulation.step(1000).unwrap();
        assert_eq!(ALLOCATIONS.with(Cell::get), before, "{integrator}");
    }
}

#[test]
fn a_step_allocates_nothing_with_every_joint_force_and_drive() {
    for integrator in common::INTEGRATORS {
        let text = common::everything("recursive").replace("{form: ", &format!("{{integrator: {integrator}, form: "));
        let mut simulation = common::simulation(&text);
        let before = ALLOCATIONS.with(Cell::get);
        simulation.step(500).unwrap();
        assert_eq!(ALLOCATIONS.with(Cell::get), before, "{integrator}");
    }
}

#[test]
fn a_step_allocates_nothing_on_mooring_lines() {
    let mut simulation = common::simulation(&common::moored());
    let before = ALLOCATIONS.with(Cell::get);
    simulation.step(200).unwrap();
    assert_eq!(ALLOCATIONS.with(Cell::get), before);
}

#[test]
fn a_step_allocates_nothing_on_dynamic_positioning_and_with_a_slack_tank() {
    let tank = "  tank: {slack_tank: {body: hull, position_m: [0, 0, 1], length_m: 6, breadth_m: 8, height_m: 2, filling: 0.3}}\n";
    for integrator in common::INTEGRATORS {
        let text = common::barge::station(&format!(", integrator: {integrator}")) + tank;
        let scenario = kingpost::scenario::read_with(&text, "test.yaml", &[], &common::barge::files()).unwrap();
        let mut simulation = scenario.simulation().unwrap();
        let before = ALLOCATIONS.with(Cell::get);
        simulation.step(100).unwrap();
        assert_eq!(ALLOCATIONS.with(Cell::get), before, "{integrator}");
    }
}

#[test]
fn a_step_allocates_nothing_with_every_kind_of_joint() {
    for integrator in common::INTEGRATORS {
        let text = common::every_joint().replace("step_s: 0.0001", &format!("step_s: 0.001, integrator: {integrator}"));
        let mut simulation = common::simulation(&text);
        let before = ALLOCATIONS.with(Cell::get);
        simulation.step(100).unwrap();
        assert_eq!(ALLOCATIONS.with(Cell::get), before, "{integrator}");
    }
}

#[test]
fn a_state_of_a_ball_joint_needs_a_unit_quaternion() {
    let mut simulation = common::simulation(&common::every_joint());
    let (q, v) = (simulation.state().q.clone(), simulation.state().v.clone());
    // Seven entries of the floating hull, two of the cylindrical and two of the universal joint.
    let mut broken = q.clone();
    broken[11] *= 1.1;
    assert!(matches!(simulation.set_state(&broken, &v, None), Err(InputError::Entry { index: 11, .. })));
    let mut nearly = q.clone();
    nearly[11] += 1e-9;
    simulation.set_state(&nearly, &v, None).unwrap();
    let length: f64 = simulation.state().q[11..15].iter().map(|x| x * x).sum();
    assert!((length - 1.0).abs() < 1e-15);
}

#[test]
fn a_step_allocates_nothing_with_a_closed_loop() {
    let mut simulation = common::simulation(&common::tied_ships("recursive"));
    let before = ALLOCATIONS.with(Cell::get);
    simulation.step(1000).unwrap();
    assert_eq!(ALLOCATIONS.with(Cell::get), before);
}

#[test]
fn a_run_from_any_snapshot_is_bitwise_identical() {
    for integrator in common::INTEGRATORS {
        let build = || {
            paper(&[
                ("torque_history", json!("pulse")),
                ("motor_2", json!(true)),
                ("simulation.integrator", json!(integrator)),
            ])
        };
        let mut whole = build();
        for _ in 0..8 {
            whole.step(37).unwrap();
            let mut resumed = build();
            resumed.restore(&whole.snapshot()).unwrap();
            let mut onward = whole.clone();
            onward.step(101).unwrap();
            resumed.step(101).unwrap();
            assert_eq!(onward.snapshot(), resumed.snapshot(), "{integrator}");
        }
    }
}

#[test]
fn reset_gives_the_same_run_again() {
    for integrator in common::INTEGRATORS {
        let mut simulation =
            paper(&[("simulation.integrator", json!(integrator)), ("simulation.duration_s", json!(0.5))]);
        let first = simulation.clone().run(|_| true);
        simulation.step(17).unwrap();
        simulation.reset();
        assert_eq!(simulation.run(|_| true).rows, first.rows, "{integrator}");
    }
}

#[test]
fn a_run_records_at_its_interval_and_at_its_end() {
    let mut simulation = paper(&[("simulation.duration_s", json!(0.095)), ("simulation.step_s", json!(0.002))]);
    let run = simulation.run(|_| true);
    let times: Vec<f64> = run.rows.chunks(run.columns).map(|row| row[0]).collect();
    let expected = [0.0, 0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.07, 0.08, 0.09, 0.096];
    assert_eq!(times.len(), expected.len());
    assert!(times.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{times:?}");
}

#[test]
fn euler_with_a_large_step_diverges_and_keeps_what_it_computed() {
    for corner in [true, false] {
        let mut overrides = vec![
            ("motor_2", json!(true)),
            ("simulation.integrator", json!("forward_euler")),
            ("simulation.step_s", json!(0.05)),
        ];
        if !corner {
            overrides.extend([("crane_x_m", json!(0.0)), ("crane_y_m", json!(0.0))]);
        }
        let mut simulation = paper(&overrides);
        let run = simulation.run(|_| true);
        let Err(RunError::Diverged { time_s, value, limit, .. }) = run.status else { panic!("it must diverge") };
        assert!(time_s > 0.5 && time_s < 3.0 && (value.is_nan() || value.abs() > limit), "{time_s} {value}");
        assert!(run.rows.len() / run.columns > 10);
        assert!(run.rows.iter().all(|x| x.is_finite()));
        // The state is the last good one: the same step fails in the same way again.
        let again = simulation.step(1);
        assert!(matches!(again, Err(RunError::Diverged { time_s: t, .. }) if t == time_s));
    }
}

/// 1 kg that a force pushes along a slide: its speed stays finite, its kinetic energy does not.
const PUSHED: &str = "
version: 1
title: A force beyond all forces
simulation: {step_s: 0.01, duration_s: 1, record_every_s: 0.1, rate_limit: 1e300}
bodies:
  mass:
    mass_kg: 1
    shape: {sphere: {radius_m: 0.1}}
    joint: {prismatic: {name: slide, axis: [1, 0, 0]}}
drives:
  push: {linear_motor: {joint: slide, force_N: 1}}
";

#[test]
fn a_row_that_is_not_finite_ends_the_run_and_is_not_kept() {
    let pushed = PUSHED.replace("force_N: 1}", "force_N: 1e158}");
    let run = common::simulation(&pushed).run(|_| true);
    let Err(RunError::NoNumber { time_s, ref column, value }) = run.status else { panic!("{:?}", run.status) };
    assert!((time_s - 0.1).abs() < 1e-12 && !value.is_finite(), "{time_s} {column} {value}");
    assert_eq!(run.rows.len(), run.columns, "the row of the start");
    assert!(run.rows.iter().all(|x| x.is_finite()));
}

#[test]
fn a_row_that_is_not_finite_ends_only_its_run_among_several() {
    let forces = [json!(1.0), json!(2.0), json!(1e158), json!(3.0)];
    let variant = |force: &serde_json::Value| vec![("drives.push.linear_motor.force_N".to_owned(), force.clone())];
    let variants: Vec<Variant> = forces.iter().map(variant).collect();
    let batch = batch::run(PUSHED, "pushed.yaml", &Files::default(), &variants, 1, |_| true).expect("they build");
    let ended: Vec<bool> = batch.runs.iter().map(|run| run.status.is_err()).collect();
    assert_eq!(ended, [false, false, true, false]);
    let rows: Vec<usize> = batch.runs.iter().map(|run| run.rows.len() / run.columns).collect();
    assert_eq!(rows, [11, 11, 1, 11]);
}

#[test]
fn invalid_states_are_refused_and_change_nothing() {
    let mut simulation = paper(&[]);
    let before = simulation.snapshot();
    let (q, v) = (simulation.state().q.clone(), simulation.state().v.clone());
    let mut broken = q.clone();
    broken[7] = f64::NAN;
    assert!(matches!(simulation.set_state(&broken, &v, None), Err(InputError::Entry { name: "q", index: 7, .. })));
    broken = q.clone();
    broken[3] = 2.0;
    assert!(matches!(simulation.set_state(&broken, &v, None), Err(InputError::Entry { index: 3, .. })));
    assert!(matches!(simulation.set_state(&q, &v[1..], None), Err(InputError::Length { name: "v", .. })));
    let mut pushed = v.clone();
    pushed[0] = 1.0;
    let refused = simulation.set_state(&q, &pushed, None);
    assert!(matches!(refused, Err(InputError::Entry { name: "v", index: 0, .. })), "the centre is held");
    assert!(matches!(simulation.set_input("lever", 0.1), Err(InputError::Unknown { .. })));
    assert_eq!(simulation.snapshot(), before);
}

#[test]
fn a_lever_scales_its_motor_from_the_next_step_on() {
    let mut simulation = paper(&[("drives.motor_1.motor.history", json!("lever"))]);
    simulation.step(10).unwrap();
    assert!(simulation.state().v.iter().all(|rate| *rate == 0.0));
    assert!(matches!(simulation.set_input("motor_1", 1.5), Err(InputError::Range { .. })));
    simulation.set_input("motor_1", 0.5).unwrap();
    simulation.step(10).unwrap();
    let half = simulation.state().v[6];
    simulation.reset();
    simulation.set_input("motor_1", 1.0).unwrap();
    simulation.step(10).unwrap();
    let full = simulation.state().v[6];
    assert!(half > 0.0 && (full / half - 2.0).abs() < 1e-3, "{half} {full}");
}

#[test]
fn rows_between_edges_record_the_torque_at_their_time() {
    // A step of 0.04 s holds the edge at 0.25 s; at 0.24 s the ramp has reached 96 %.
    let mut simulation = paper(&[("torque_history", json!("pulse")), ("simulation.step_s", json!(0.04))]);
    simulation.step(6).unwrap();
    let torque = common::values(&mut simulation, "joint_force")[0];
    assert!((torque - 96_000.0).abs() < 1e-6, "{torque}");
}

#[test]
fn the_next_step_restores_a_prescribed_rate_that_was_changed() {
    let mut simulation = common::simulation(&common::everything("recursive"));
    simulation.step(300).unwrap();
    let mut other = simulation.clone();
    let (q, mut v) = (simulation.state().q.clone(), simulation.state().v.clone());
    let turned = simulation.model().tree.nodes[simulation.model().joint("turned").unwrap()].velocities;
    v[turned] = 7.0;
    other.set_state(&q, &v, None).unwrap();
    simulation.step(10).unwrap();
    other.step(10).unwrap();
    assert!((simulation.state().v[turned] - other.state().v[turned]).abs() < 1e-12);
}

#[test]
fn a_snapshot_of_another_setup_is_refused() {
    let mut simulation = paper(&[]);
    let other = paper(&[("crane_x_m", json!(0.0))]);
    assert!(matches!(simulation.restore(&other.snapshot()), Err(SnapshotError::Setup { .. })));
}

#[test]
fn a_long_run_without_rows_can_be_stopped() {
    let mut simulation = paper(&[
        ("simulation.duration_s", json!(1e6)),
        ("simulation.record_every_s", json!(1e6)),
        ("motor_1", json!(false)),
    ]);
    let run = simulation.run(|_| false);
    assert_eq!((run.rows.len() / run.columns, simulation.state().steps), (1, PROGRESS_STEPS));
}
