//! The paper's scenario, and functions of the scenario tests that use it.

use kingpost::scenario::{Scenario, parse_assignment, read};

/// The paper's scenario.
pub const PAPER: &str = include_str!("../../../../scenarios/paper.yaml");

/// Returns the paper's scenario with the first of these texts replaced.
#[track_caller]
pub fn changed(old: &str, new: &str) -> String {
    assert!(PAPER.contains(old), "no {old:?} in the paper's scenario");
    PAPER.replacen(old, new, 1)
}

/// Returns the error of a text, as users see it.
#[track_caller]
pub fn error_of(text: &str) -> String {
    read(text, "paper.yaml", &[]).map(drop).expect_err("this should be refused").to_string()
}

/// Returns line and column of the first occurrence of this text.
#[track_caller]
pub fn place_of(text: &str, at: &str) -> (usize, usize) {
    let before = &text[..text.find(at).unwrap_or_else(|| panic!("no {at:?} in the text"))];
    let line_start = before.rfind('\n').map_or(0, |end| end + 1);
    (before.matches('\n').count() + 1, before[line_start..].chars().count() + 1)
}

/// The paper's scenario with these assignments.
#[track_caller]
pub fn set(assignments: &[&str]) -> Scenario {
    try_set(PAPER, assignments).unwrap_or_else(|error| panic!("{error}"))
}

/// Returns a scenario with these assignments, or the error as users see it.
pub fn try_set(text: &str, assignments: &[&str]) -> Result<Scenario, String> {
    let parse = |text: &&str| parse_assignment(text).map_err(|error| error.to_string());
    let overrides: Vec<_> = assignments.iter().map(parse).collect::<Result<_, _>>()?;
    read(text, "paper.yaml", &overrides).map_err(|error| error.to_string())
}
