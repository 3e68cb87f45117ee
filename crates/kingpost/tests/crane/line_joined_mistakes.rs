//! Mistakes in lines that are fastened to lines are refused at their fields.

use crate::line_joined::{FIXED, WET, bridle, section};
use kingpost::scenario::read;

/// The message of the error of a bridle after a replacement in its text.
fn refusal(from: &str, to: &str) -> String {
    let text = bridle(
        FIXED,
        "rk4",
        "  hawser: {spring_line: {first: {body: ship}, second: {body: world, position_m: [0, 90, 0]}, \
         unstretched_length_m: 100, axial_stiffness_N: 1.0e6}}\n",
    );
    assert!(text.contains(from), "{from}");
    let text = text.replacen(from, to, 1);
    let refused = read(&text, "bridle.yaml", &[]).and_then(|read| read.setup().map(|_| ()));
    refused.expect_err("it is refused").to_string()
}

#[test]
fn rejects_a_joint_on_a_line_that_cannot_have_it() {
    let on = "second_on: {line: chain, section: 0}";
    for (from, to, expected) in [
        (
            on,
            "second_on: {line: cable, section: 0}",
            "forces.port.line.second_on.line: found cable, allowed: one of chain, starboard",
        ),
        (
            on,
            "second_on: {line: hawser, section: 0}",
            "forces.port.line.second_on.line: found hawser, allowed: one of chain, starboard",
        ),
        (
            on,
            "second_on: {line: port, section: 0}",
            "forces.port.line.second_on.line: found port, allowed: one of chain, starboard",
        ),
        (
            on,
            "second_on: {line: chain, section: 1}",
            "forces.port.line.second_on.section: found 1, allowed: 0, the section of chain",
        ),
        (
            on,
            "second_on: {line: starboard, section: 0}",
            "forces.port.line.second_on.section: found 0, allowed: a line of two sections: its last section ends at a body or another line",
        ),
        (
            "first: {body: world, position_m: [250, 0, -60]}",
            "enabled: false\n      first: {body: world, position_m: [250, 0, -60]}",
            "forces.port.line.second_on.line: found chain, which is disabled, allowed: a line that is enabled",
        ),
        (
            "second_free: true",
            "second_on: {line: port, section: 0}",
            "forces.port.line.second_on.section: found 0, allowed: a line of two sections",
        ),
    ] {
        let found = refusal(from, to);
        assert!(found.contains(expected), "{found}");
    }
}

#[test]
fn rejects_lines_in_a_circle() {
    // Legs of two sections, each on the first section of the next line.
    let mut text = bridle(FIXED, "rk4", "");
    let leg = section(40.0, 6, WET);
    text = text.replace(&leg, &format!("{leg}{leg}"));
    text = text.replacen("second_on: {line: chain", "second_on: {line: starboard", 1);
    text = text.replacen("second_on: {line: chain", "second_on: {line: port", 1);
    let refused = read(&text, "bridle.yaml", &[]).and_then(|read| read.setup().map(|_| ()));
    let message = refused.expect_err("it is refused").to_string();
    assert!(
        message.contains("forces.port.line.second_on.line: found a circle of lines: port, starboard, port"),
        "{message}"
    );
}

#[test]
fn rejects_ends_that_exclude_each_other() {
    let on = "second_on: {line: chain, section: 0}";
    let stiff = section(40.0, 6, &format!("{WET}, bending_stiffness_N_m2: 1000"));
    for (from, to, expected) in [
        (
            on.to_owned(),
            format!("second_free: true\n      {on}"),
            "forces.port.line.first: found first and second_free and second_on",
        ),
        (
            on.to_owned(),
            format!("second: {{body: world}}\n      {on}"),
            "forces.port.line.first: found first and second and second_on",
        ),
        (
            "first: {body: ship, position_m: [10, 5, 0]}\n".to_owned(),
            "\n".to_owned(),
            "forces.port.line.first: found second_on",
        ),
        (
            section(40.0, 6, WET),
            format!("{stiff}      second_direction: [0, 0, 1]\n"),
            "forces.port.line.second_direction: found a direction, allowed: none on another line: it turns freely there",
        ),
        (
            section(40.0, 6, WET),
            section(40.0, 6, &format!("{WET}, clump_weight: {{mass_kg: 10}}")),
            "forces.port.line.sections.0.clump_weight: found a clump weight, allowed: none at the end of the last section: give it \
             to the section of the line to which it is fastened",
        ),
    ] {
        let found = refusal(&from, &to);
        assert!(found.contains(expected), "{found}");
    }
}
