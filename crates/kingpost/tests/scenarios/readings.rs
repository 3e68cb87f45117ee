//! Columns that are read without the rest of the row.

use crate::common::gallery_files::{names, scenario};

/// Checks that an operation reads at every step the value in the row of results, for every column of every
/// scenario.
#[test]
fn a_column_read_separately_has_the_value_in_the_row() {
    for name in names("") {
        let mut simulation = scenario(&name, &[]).simulation().expect("the gallery builds");
        simulation.step(3).expect("three steps");
        let mut row = Vec::new();
        simulation.write_row(&mut row);
        let columns: Vec<String> = simulation.channels().iter().flat_map(|channel| channel.columns.clone()).collect();
        let mut read = Vec::new();
        for (column, value) in columns.iter().zip(&row) {
            let mut readings = simulation.readings(core::slice::from_ref(column));
            simulation.read(&mut readings, &mut read);
            assert_eq!(read.as_slice(), [*value], "{name}: {column}");
        }
        // Several at once, of the motion and of an element, last first.
        let backwards: Vec<String> = columns.iter().rev().step_by(7).cloned().collect();
        let mut readings = simulation.readings(&backwards);
        simulation.read(&mut readings, &mut read);
        let of_row: Vec<f64> = row.iter().rev().step_by(7).copied().collect();
        assert_eq!(read, of_row, "{name}");
    }
}

#[test]
fn two_adjacent_hulls_give_a_warning_with_their_gap() {
    let mut simulation = scenario("lift_off_from_barge", &[]).simulation().expect("the gallery builds");
    simulation.write_row(&mut Vec::new());
    let warnings = simulation.warnings();
    let gap = warnings.iter().find(|warning| warning.text.starts_with("comes as near as 5.3 m to "));
    assert!(gap.is_some(), "{warnings:?}");
}
