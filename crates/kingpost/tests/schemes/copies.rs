//! Copies that a controller steps together: a marked state from which all copies continue.

use crate::common;

use common::gallery_files::{files, text};
use kingpost::batch::{Asked, Status, VectorEnsemble};

const COUNT: usize = 6;
const COLUMNS: [&str; 3] = ["load.position.x", "load.position.y", "energy_error"];

/// A crane whose slewing is an input; each copy's load has a different mass if `masses` is true.
fn cranes(masses: bool, threads: usize) -> VectorEnsemble {
    let asked = Asked {
        inputs: vec!["slew_command".to_owned()],
        columns: COLUMNS.map(str::to_owned).to_vec(),
        ..Asked::default()
    };
    let variant = |k: usize| {
        let mass_t = if masses { 8.0 + k as f64 } else { 20.0 };
        vec![("operation.enabled".to_owned(), false.into()), ("bodies.load.mass_t".to_owned(), mass_t.into())]
    };
    let variants = (0..COUNT).map(variant).collect();
    VectorEnsemble::new(&text("slew_without_swing"), "slew_without_swing.yaml", files(), variants, asked, threads)
        .expect("the copies are built")
}

struct Read {
    columns: Vec<f64>,
    status: Vec<Status>,
}

fn advance(copies: &mut VectorEnsemble, steps: usize, inputs: [f64; COUNT]) -> Read {
    let mut read = Read { columns: vec![0.0; COUNT * COLUMNS.len()], status: vec![Status::Failed; COUNT] };
    copies.advance(steps, &inputs, &mut read.columns, &mut read.status).expect("they advance");
    assert!(read.status.iter().all(|status| *status == Status::Running));
    read
}

fn of(read: &Read, copy: usize) -> &[f64] {
    &read.columns[copy * COLUMNS.len()..(copy + 1) * COLUMNS.len()]
}

const APART: [f64; COUNT] = [0.0, 0.01, -0.02, 0.03, 0.04, -0.05];

#[test]
fn copies_continue_bitwise_identically_from_a_marked_copy_on_any_number_of_threads() {
    let mut paths: Vec<Vec<f64>> = Vec::new();
    for threads in [1, 2] {
        let mut copies = cranes(false, threads);
        advance(&mut copies, 200, APART);
        copies.mark(4).unwrap();
        let time = copies.time_s(4);
        let alone = advance(&mut copies, 300, [0.02; COUNT]);
        assert_ne!(of(&alone, 3), of(&alone, 4));
        for _ in 0..2 {
            copies.resume().unwrap();
            assert!((0..COUNT).all(|copy| copies.time_s(copy) == time));
            let together = advance(&mut copies, 300, [0.02; COUNT]);
            for copy in 0..COUNT {
                assert_eq!(of(&together, copy), of(&alone, 4), "copy {copy}");
            }
        }
        paths.push(alone.columns);
    }
    assert_eq!(paths[0], paths[1]);
}

#[test]
fn a_copy_that_continues_from_another_keeps_its_numbers() {
    let mut copies = cranes(true, 1);
    advance(&mut copies, 200, APART);
    copies.mark(0).unwrap();
    copies.resume().unwrap();
    let start = advance(&mut copies, 0, [0.02; COUNT]);
    let later = advance(&mut copies, 300, [0.02; COUNT]);
    for copy in 1..COUNT {
        assert_eq!(of(&start, copy)[..2], of(&start, 0)[..2], "copy {copy} begins where copy 0 is");
        assert_ne!(of(&later, copy)[..2], of(&later, 0)[..2], "copy {copy} has another load");
    }
}

#[test]
fn an_invalid_mark_is_refused_with_the_allowed_ones() {
    let mut copies = cranes(false, 1);
    let found = copies.resume().expect_err("nothing was marked").to_string();
    assert_eq!(found, "mark: found no marked copy, allowed: a copy that has not failed");
    let found = copies.mark(COUNT).expect_err("there is no such copy").to_string();
    assert_eq!(found, "copy: found 6, allowed: at most 5, the last copy");
}
