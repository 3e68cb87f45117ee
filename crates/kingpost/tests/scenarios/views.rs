//! Camera and plots that a scenario names for views.

use crate::common::paper_text;

use kingpost::scenario::read;
use paper_text::PAPER;
use serde_json::{Value, json};

fn with_view(view: &str) -> String {
    format!("{PAPER}\nview: {view}\n")
}

fn described(view: &str) -> (String, Vec<Vec<String>>) {
    let scenario = read(&with_view(view), "paper.yaml", &[]).unwrap_or_else(|error| panic!("{error}"));
    let described = scenario.describe().unwrap_or_else(|error| panic!("{error}")).view;
    (described.camera, described.plots)
}

#[test]
fn a_view_is_described_as_figures_take_it() {
    let (camera, plots) = described("{camera: load, plots: [[ship.roll, ship.pitch], [kinetic_energy]]}");
    assert_eq!(camera, "load");
    assert_eq!(plots, [vec!["ship.roll", "ship.pitch"], vec!["kinetic_energy"]]);
    let (camera, plots) = described("{camera: {place: {eye_m: [-28, -45.5, 24], target_m: [0, 0, 3]}}}");
    assert_eq!((camera.as_str(), plots.len()), ("-28 -45.5 24 0 0 3", 0));
    assert_eq!(described("{}").0, "");
}

#[test]
fn a_view_is_kept_in_the_resolved_scenario() {
    let resolved = |text: &str| -> Value {
        let json = read(text, "paper.yaml", &[]).expect("it reads").to_json();
        serde_json::from_str(&json).expect("it is JSON")
    };
    let view = resolved(&with_view("{camera: top, plots: [[ship.roll]]}"))["view"].clone();
    assert_eq!(view, json!({"camera": "top", "plots": [["ship.roll"]]}));
    assert_eq!(resolved(PAPER).get("view"), None);
}

#[test]
fn rejects_views_that_show_nothing() {
    for (view, expected) in [
        ("{camera: mast}", "view.camera: found "),
        ("{camera: {place: {eye_m: [1, 2, 3], target_m: [1, 2, 3]}}}", "view.camera.place.target_m: found "),
        ("{plots: [[ship.rol]]}", "view.plots.0.0: found ship.rol, allowed: "),
        ("{plots: [[]]}", "view.plots.0: found 0 columns, allowed: 1 to 8 columns"),
        (
            "{plots: [[ship.roll, kinetic_energy]]}",
            "view.plots.0.1: found kinetic_energy, in J, allowed: a column in rad",
        ),
        (
            "{plots: [[time], [time], [time], [time], [time], [time], [time]]}",
            "view.plots: found 7, allowed: at most 6 plots",
        ),
    ] {
        let error = match read(&with_view(view), "paper.yaml", &[]) {
            Err(error) => error.to_string(),
            Ok(scenario) => scenario.describe().map(drop).expect_err("it shows nothing").to_string(),
        };
        assert!(error.contains(expected), "{error}\nlacks: {expected}");
    }
}
