//! Floating bodies whose place at the start is that of their drawing frame.

use kingpost::scenario::{Files, Scenario, read, read_with};
use serde_json::{Value, json};

/// A hull drawn from the keel, with its centre of mass one metre forward and two up, turned by 90 degrees.
fn hull(initial: &str) -> String {
    format!(
        "{{version: 1, title: A hull, bodies: {{hull: {{mass_t: 10, centre_of_mass_m: [1, 0, 2], shape: {{sphere: {{radius_m: 1}}}}, \
         joint: {{floating: {{initial: {{{initial}, orientation_deg: [0, 0, 90]}}}}}}}}}}}}"
    )
}

fn positions(scenario: &Scenario) -> [[f64; 3]; 2] {
    let described = scenario.describe().expect("it builds");
    let place = described.bodies[0].at_start.expect("it is drawn from the keel");
    [place.centre_of_mass_m, place.drawing_frame_m]
}

fn near(found: [f64; 3], expected: [f64; 3]) {
    assert!(
        found.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-12),
        "{found:?}, {expected:?}"
    );
}

#[test]
fn a_body_placed_by_its_drawing_frame_stays_there_when_its_centre_of_mass_changes() {
    let text = hull("drawing_frame_m: [10, 0, -3]");
    let given = |centre: Value| {
        read(&text, "hull.yaml", &[("bodies.hull.centre_of_mass_m".to_owned(), centre)]).expect("it reads")
    };
    // Body x points to world y.
    let [centre, origin] = positions(&given(json!([1, 0, 2])));
    near(centre, [10.0, 1.0, -1.0]);
    near(origin, [10.0, 0.0, -3.0]);
    let [centre, origin] = positions(&given(json!([0, 0.5, 3])));
    near(centre, [9.5, 0.0, 0.0]);
    near(origin, [10.0, 0.0, -3.0]);
}

#[test]
fn the_description_says_where_the_drawing_frame_of_a_body_placed_by_its_centre_is() {
    let [centre, origin] = positions(&read(&hull("position_m: [10, 0, 0]"), "hull.yaml", &[]).expect("it reads"));
    near(centre, [10.0, 0.0, 0.0]);
    near(origin, [10.0, -1.0, -2.0]);
}

#[test]
fn both_positions_are_refused() {
    let error = read(&hull("position_m: [10, 0, 0], drawing_frame_m: [1, 0, 0]"), "hull.yaml", &[]).expect_err("both");
    assert_eq!(error.field, "bodies.hull.joint.floating.initial.position_m");
    assert_eq!((error.found.as_str(), error.allowed.as_str()), ("[10, 0, 0]", "none beside drawing_frame_m"));
}

/// A part mounted 5 m aft and turned by 90 degrees moves the drawing frame.
#[test]
fn a_part_moves_the_drawing_frame_with_its_mounting() {
    let part = ("gallery:parts/own.yaml".to_owned(), hull("drawing_frame_m: [10, 0, -3]"));
    let text = "{version: 1, title: x, parts: {own: {part: own, prefix: '', position_m: [-5, 0, 0], orientation_deg: [0, 0, 90]}}}";
    let scenario = read_with(text, "x.yaml", &[], &Files::new([part])).unwrap_or_else(|error| panic!("{error}"));
    let [centre, origin] = positions(&scenario);
    near(origin, [-5.0, 10.0, -3.0]);
    near(centre, [-6.0, 10.0, -1.0]);
}
