//! Runs of a batch are bitwise identical to single runs of each variant.

use crate::common;
use crate::common::gallery_files;

use common::paper_setup;
use kingpost::batch::{self, BatchError, Variant};
use kingpost::scenario::Files;
use kingpost::simulation::{Run, Simulation};
use serde_json::{Value, json};

const TEXT: &str = include_str!("../../../../scenarios/paper.yaml");

fn variant(pairs: &[(&str, Value)]) -> Variant {
    let short = [("simulation.duration_s", json!(0.3)), ("simulation.step_s", json!(0.002))];
    short.iter().chain(pairs).map(|(name, value)| ((*name).to_owned(), value.clone())).collect()
}

fn alone(variant: &Variant) -> Run {
    let pairs: Vec<(&str, Value)> = variant.iter().map(|(name, value)| (name.as_str(), value.clone())).collect();
    Simulation::new(paper_setup(&pairs)).run(|_| true)
}

/// Numbers and switches, so that some runs are in full lanes, some in partly filled ones, and some alone.
fn variants() -> Vec<Variant> {
    let mut all: Vec<Variant> = (0..10).map(|k| variant(&[("crane_x_m", json!(-9.3 + k as f64))])).collect();
    all.extend((0..3).map(|k| variant(&[("load", json!(true)), ("bodies.load.mass_kg", json!(500 + 100 * k))])));
    all.push(variant(&[("torque_history", json!("pulse")), ("hold_centre", json!(false))]));
    all.push(variant(&[("simulation.step_s", json!(0.003)), ("gravity", json!(true))]));
    all.push(variant(&[("simulation.integrator", json!("midpoint_euler"))]));
    all.push(variant(&[("simulation.integrator", json!("midpoint_euler")), ("crane_y_m", json!(3))]));
    all.push(variant(&[("simulation.form", json!("moving_frame"))]));
    all
}

fn bits(run: &Run) -> Vec<u64> {
    run.rows.iter().map(|x| x.to_bits()).collect()
}

#[test]
fn every_run_is_bitwise_identical_to_a_single_run_for_any_number_of_threads() {
    let variants = variants();
    let expected: Vec<Vec<u64>> = variants.iter().map(|variant| bits(&alone(variant))).collect();
    for threads in [1, 2, 5] {
        let batch = batch::run(TEXT, "paper.yaml", &Files::default(), &variants[..13], threads, |_| true);
        let with_load = matches!(batch, Err(BatchError::Channels { run: 10 }));
        assert!(with_load, "a body more has other channels");
        let same_bodies: Vec<usize> = (0..variants.len()).filter(|run| !(10..13).contains(run)).collect();
        for group in [same_bodies, (10..13).collect()] {
            let chosen: Vec<Variant> = group.iter().map(|&run| variants[run].clone()).collect();
            let batch = batch::run(TEXT, "paper.yaml", &Files::default(), &chosen, threads, |_| true)
                .expect("the variants build");
            for (run, &original) in batch.runs.iter().zip(&group) {
                assert!(bits(run) == expected[original], "variant {original} with {threads} threads");
                assert!(run.status.is_ok());
            }
        }
    }
}

#[test]
fn a_run_that_diverges_is_marked_and_the_others_go_on() {
    let limit = |limit: f64| variant(&[("simulation.rate_limit", json!(limit)), ("simulation.duration_s", json!(0.8))]);
    let torque = |torque: f64| {
        let mut variant = limit(9.0);
        variant.push(("drives.motor_1.motor.torque_N_m".to_owned(), json!(torque)));
        variant
    };
    let variants = [torque(50_000.0), torque(100_000.0), torque(60_000.0), torque(20_000.0)];
    let batch = batch::run(TEXT, "paper.yaml", &Files::default(), &variants, 1, |_| true).expect("the variants build");
    let diverged: Vec<bool> = batch.runs.iter().map(|run| run.status.is_err()).collect();
    assert_eq!(diverged, [false, true, false, false]);
    for (run, variant) in batch.runs.iter().zip(&variants) {
        let alone = alone(variant);
        assert_eq!((bits(run), &run.status), (bits(&alone), &alone.status));
    }
    assert!(
        batch.runs[1].rows.len() < batch.runs[0].rows.len() && batch.runs[1].rows.len() > 10 * batch.runs[1].columns
    );
}

#[test]
fn an_invalid_variant_is_named_before_any_run_starts() {
    let variants = [variant(&[]), variant(&[("crane_x_m", json!(70))])];
    let error = batch::run(TEXT, "paper.yaml", &Files::default(), &variants, 1, |_| panic!("nothing runs"))
        .expect_err("it is out of range");
    assert!(error.to_string().starts_with("run 1: --set crane_x_m: found 70"), "{error}");
    let none = batch::run(TEXT, "paper.yaml", &Files::default(), &[], 1, |_| true).expect("nothing to do");
    assert!(none.runs.is_empty() && none.channels.is_empty());
}

#[test]
fn a_batch_that_records_more_than_the_limit_does_not_start() {
    let variants = [variant(&[]), variant(&[])];
    let run = |most_bytes| batch::run_within(TEXT, "paper.yaml", &Files::default(), &variants, 1, most_bytes, |_| true);
    let error = run(1000).expect_err("30 rows of some 100 numbers each");
    assert!(matches!(error, BatchError::Memory { runs: 2, found: 2000.., allowed: 1000 }), "{error}");
    assert!(run(1_000_000).is_ok());
    // More models than fit are refused after the first is built, and more rows while the others are.
    let many = vec![variant(&[]); 100_000];
    for (count, most_bytes) in [(many.len(), 1 << 30), (50, 4_000_000)] {
        let refused = batch::run_within(TEXT, "paper.yaml", &Files::default(), &many[..count], 1, most_bytes, |_| true);
        assert!(matches!(refused, Err(BatchError::Memory { runs, found, .. }) if runs == count && found > most_bytes));
    }
}

#[test]
fn a_batch_can_be_stopped() {
    let stopped = batch::run(TEXT, "paper.yaml", &Files::default(), &variants()[..8], 2, |done| done < 4);
    assert!(matches!(stopped, Err(BatchError::Stopped)));
}

#[test]
fn runs_with_closed_loops_and_cylinders_are_bitwise_identical_to_single_runs() {
    // Newton's method closes each lane's loop in its own number of corrections.
    let cranes = [("dual_draglink_crane", "boom_cylinder_m"), ("knuckle_boom_crane", "main_cylinder_m")];
    for (file, cylinder) in cranes {
        let (text, files) = (gallery_files::text(file), gallery_files::files());
        let mut variants: Vec<Variant> = (0..7).map(|k| variant(&[("load_t", json!(3 + k))])).collect();
        variants.push(variant(&[(cylinder, json!(7.1))]));
        let batch = batch::run(&text, file, &files, &variants, 2, |_| true).expect("the variants build");
        for (run, variant) in batch.runs.iter().zip(&variants) {
            let scenario = kingpost::scenario::read_with(&text, file, variant, &files).unwrap();
            let alone = Simulation::new(scenario.setup().unwrap()).run(|_| true);
            assert!(run.status.is_ok() && bits(run) == bits(&alone), "{file}: {variant:?}");
        }
    }
}

/// Both change their form at 0.04, 0.12, 0.20 and 0.24 s: one holds before it reverses, the other does not.
#[test]
fn histories_with_equal_edges_do_not_share_lanes() {
    let with = |history: &str, name: &str, times: Value| {
        variant(&[("drives.motor_1.motor.history", json!(history)), (name, times)])
    };
    let (pulse, list) = ("drives.motor_1.motor.pulse", "drives.motor_1.motor.list");
    let points = json!({"time_s": [0, 0.04, 0.12, 0.2, 0.24], "share": [0, 1, 1, -1, 0]});
    let variants =
        [with("list", list, points), with("pulse", pulse, json!({"rise_s": 0.04, "hold_s": 0.0, "reverse_s": 0.08}))];
    let batch = batch::run(TEXT, "paper.yaml", &Files::default(), &variants, 1, |_| true).expect("the variants build");
    for (run, variant) in batch.runs.iter().zip(&variants) {
        assert!(bits(run) == bits(&alone(variant)));
    }
}
