//! Damaged files and snapshots: none makes the engine panic, and all damage to a snapshot is detected.

use crate::common::paper_text;

use kingpost::Simulation;
use kingpost::scenario::{Files, read_with};
use kingpost::sea::database::Database;
use kingpost::sea::raos::RaoTable;
use kingpost::sea::waves::ElevationTable;
use paper_text::set;
use proptest::prelude::*;
use std::sync::LazyLock;

const SPHERE: &str = include_str!("../../../../scenarios/hydro/sphere.hydro.json");
const RAOS: &str = include_str!("../../../../scenarios/hydro/supply_boat.raos.csv");
/// Largest length of an error.
const LONGEST: usize = 2_000;

/// Snapshots of a run whose integrator has a memory from step to step, and of a run whose integrator has
/// none.
fn run(integrator: &str) -> Simulation {
    let settings = [&format!("simulation.integrator={integrator}") as &str, "simulation.duration_s=1"];
    let mut simulation = set(&settings).simulation().unwrap();
    simulation.step(20).unwrap();
    simulation
}

/// A text with a stretch replaced, or with its end cut off.
fn damaged(text: &'static str) -> impl Strategy<Value = String> {
    let tokens = prop::sample::select(vec![
        "",
        "-",
        "nan",
        "NaN",
        "1e999",
        "-1e308",
        "1e-320",
        "null",
        "[]",
        "{}",
        "[[1]]",
        "\"x\"",
        ",",
        ":",
        "]",
        "}",
        "99999999999999999999",
        "0.0",
        "-0",
        "\u{0}",
        "é",
        "\n",
        "#",
        "true",
        "1e5000000000",
    ]);
    (0..text.len(), 0..30_usize, tokens, prop::bool::weighted(0.2)).prop_map(move |(start, length, token, cut)| {
        let (start, end) = (floor(text, start), floor(text, start + length));
        let end = end.max(start);
        format!("{}{token}{}", &text[..start], if cut { "" } else { &text[end..] })
    })
}

/// Returns the largest index up to this one at which a character starts.
fn floor(text: &str, place: usize) -> usize {
    (0..=place.min(text.len())).rev().find(|&at| text.is_char_boundary(at)).unwrap_or(0)
}

fn check_words(error: &str) {
    assert!(!error.contains('\n') && error.len() > 10 && error.len() < LONGEST, "{error}");
}

#[test]
fn every_flipped_bit_of_a_snapshot_is_detected() {
    for integrator in ["rk4", "dormand_prince"] {
        let mut simulation = run(integrator);
        let (bytes, state) = (simulation.snapshot(), simulation.state().clone());
        for place in (0..8 * bytes.len()).step_by(7) {
            let mut damaged = bytes.clone();
            damaged[place / 8] ^= 1 << (place % 8);
            assert!(simulation.restore(&damaged).is_err(), "{integrator}: bit {place}");
        }
        assert_eq!((&simulation.state().q, &simulation.state().v), (&state.q, &state.v), "{integrator}");
        simulation.restore(&bytes).unwrap();
    }
}

proptest! {
    #[test]
    fn only_the_bytes_of_a_snapshot_restore(
        start in 0..4_000_usize, length in 0..40_usize, new in prop::collection::vec(any::<u8>(), 0..40),
    ) {
        static RUN: LazyLock<(Simulation, Vec<u8>)> = LazyLock::new(|| {
            let simulation = run("rk4");
            let bytes = simulation.snapshot();
            (simulation, bytes)
        });
        let mut simulation = RUN.0.clone();
        let start = start.min(RUN.1.len());
        let mut damaged = RUN.1.clone();
        damaged.splice(start..(start + length).min(RUN.1.len()), new);
        if damaged == RUN.1 {
            simulation.restore(&damaged).unwrap();
        } else {
            check_words(&simulation.restore(&damaged).unwrap_err().to_string());
        }
    }

    #[test]
    fn no_damage_to_a_database_makes_its_reader_panic(text in damaged(SPHERE)) {
        if let Err(error) = Database::read(&text) {
            check_words(&error.to_string());
        }
    }

    #[test]
    fn no_damage_to_a_table_of_raos_makes_its_reader_panic(text in damaged(RAOS)) {
        if let Err(error) = RaoTable::read(&text) {
            check_words(&error.to_string());
        }
    }

    #[test]
    fn no_text_makes_the_readers_of_tables_panic(text in "\\PC{0,200}", rows in "([-0-9.e,]{0,12}\n){0,12}") {
        for text in [text, format!("time_s,elevation_m\n{rows}")] {
            for error in [ElevationTable::read_csv(&text).err().map(|e| e.to_string()), RaoTable::read(&text).err().map(|e| e.to_string())] {
                error.as_deref().into_iter().for_each(check_words);
            }
        }
    }

    #[test]
    fn the_error_of_a_long_text_is_short(letter in "[a-z\\[{é]", count in 1_000..20_000_usize) {
        let long = letter.repeat(count);
        let files = Files::new([("long.csv".to_owned(), long.clone())]);
        for text in [
            format!("version: 1\ntitle: x\nbodies: {{{long}: 1}}"),
            format!("version: 1\ntitle: x\n{long}: 1"),
            "version: 1\ntitle: x\nbodies: {a: {mass_kg: 1, joint: {moved_by_waves: {raos: long.csv}}}}".to_owned(),
        ] {
            if let Err(error) = read_with(&text, "long.yaml", &[], &files) {
                check_words(&error.to_string());
            }
        }
    }
}
