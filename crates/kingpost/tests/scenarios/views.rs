//! Descriptions for views: camera and plots of a scenario, tanks, wind and current, axes of joints.

use crate::common::{gallery_files, paper_text};

use kingpost::scenario::describe::Description;
use kingpost::scenario::read;
use paper_text::PAPER;
use serde_json::{Value, json};

/// Returns the paper's scenario without its view.
fn without_view() -> &'static str {
    PAPER.split_once("\nview:").map_or(PAPER, |(rest, _)| rest)
}

fn with_view(view: &str) -> String {
    format!("{}\nview: {view}\n", without_view())
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
    assert_eq!(resolved(without_view()).get("view"), None);
}

#[test]
fn rejects_views_that_show_nothing() {
    for (view, expected) in [
        ("{camera: mast}", "view.camera: found "),
        ("{camera: {place: {eye_m: [1, 2, 3], target_m: [1, 2, 3]}}}", "view.camera.place.target_m: found "),
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

#[test]
fn a_plot_of_a_column_that_a_value_removes_is_left_out_with_a_warning() {
    let text = with_view("{plots: [[load.position.x, ship.position.x], [load.position.z]]}");
    let with_load = |load: bool| {
        let scenario = read(&text, "paper.yaml", &[("load".to_owned(), json!(load))]).expect("it reads");
        scenario.describe().unwrap_or_else(|error| panic!("{error}"))
    };
    let of_view = |found: &Description| found.warnings.iter().filter(|one| one.contains("view.plots")).count();
    let (there, gone) = (with_load(true), with_load(false));
    assert_eq!((there.view.plots.len(), of_view(&there)), (2, 0));
    assert_eq!((gone.view.plots.as_slice(), of_view(&gone)), (&[vec!["ship.position.x".to_owned()]][..], 2));
    let warned = |words: &str| gone.warnings.iter().any(|one| one.contains(words));
    assert!(warned("view.plots.1.0: found load.position.z, allowed: ") && warned("the plot leaves it out"));
}

fn gallery(name: &str) -> Description {
    gallery_files::scenario(name, &[]).describe().unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn a_tank_is_described_by_its_rooms_and_the_columns_of_their_levels() {
    let [tank] = &gallery("roll_reduction_tank").tanks[..] else { panic!("one tank") };
    assert_eq!((&*tank.name, &*tank.body, tank.rooms.len()), ("tank", "hull", 3));
    // The middle of the duct is at 2 m above the keel amidships, and the hull's centre of mass at (-2.55, 0, 6.5) m.
    let port = &tank.rooms[0];
    let expected = [2.55 - 2.5, 7.5 - 1.25, 2.0 - 6.5 - 0.35];
    for (found, expected) in port.low_m.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-12, "{found}, expected {expected}");
    }
    assert_eq!(port.level_column.as_deref(), Some("tank.level_port"));
    assert!((port.level_m - 3.35).abs() < 1e-12, "3 m above the middle of the duct of 0.7 m");
    assert!((port.level_m - port.level_zero_m - 3.0).abs() < 1e-12, "the column begins at the middle of the duct");
    assert_eq!(tank.rooms[2].level_column, None, "the duct is full");
}

#[test]
fn wind_and_current_are_described_by_their_velocities() {
    let described = gallery("offshore_vessel_on_dp");
    let [x, y] = described.wind.expect("wind").velocity_m_s;
    assert!(
        (x + 12.0 * 0.75_f64.sqrt()).abs() < 1e-9 && (y - 6.0).abs() < 1e-9,
        "12 m/s towards 150 degrees: {x}, {y}"
    );
    assert_eq!(described.sea.expect("a sea").current_m_s, [-0.5, 0.2]);
    assert!(gallery("offshore_vessel").wind.is_none());
}

#[test]
fn a_joint_with_one_axis_of_rotation_is_described_by_it() {
    let described = gallery("roll_reduction_gyros");
    let axis_of = |name: &str| described.joints.iter().find(|joint| joint.name == name).expect("a joint").axis;
    assert_eq!(axis_of("precession_port"), Some([0.0, 1.0, 0.0]));
    assert_eq!(axis_of("spin_starboard"), Some([0.0, 0.0, -1.0]));
    assert_eq!(axis_of("hull"), None);
}
