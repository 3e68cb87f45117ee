//! Warnings of the engine in a run: rods that represent ropes, and hulls outside the range of linear theory.

use kingpost::elements::hull::LinearLimits;
use kingpost::elements::{MeanHeading, Watcher, significant};
use kingpost::scenario;
use kingpost::simulation::{Run, Simulation, Warning};
use serde_json::{Value, json};

/// Weight of 100 kg, N.
const WEIGHT_N: f64 = 980.665;

fn run(scenario: Value) -> Run {
    run_by(json!({"step_s": 0.002, "duration_s": 3, "record_every_s": 0.01}), scenario)
}

fn run_by(simulation: Value, mut scenario: Value) -> Run {
    scenario["version"] = json!(1);
    scenario["title"] = json!("warned of");
    scenario["simulation"] = simulation;
    scenario["forces"]["weight"] = json!({"gravity": {"acceleration_m_s2": 9.80665}});
    let scenario = scenario::read(&scenario.to_string(), "warned.json", &[]).expect("it reads");
    Simulation::new(scenario.setup().expect("it builds")).run(|_| true)
}

/// A load of 100 kg, 2 m below its pendant's joint, let go from rest at an angle.
fn pendant(angle_rad: f64, spring: Option<Value>) -> Run {
    let mut first = json!({"initial_angle_rad": angle_rad});
    if let Some(spring) = spring {
        first["spring"] = spring;
    }
    let joint = json!({"name": "pendant", "first_axis": [1, 0, 0], "second_axis": [0, 1, 0],
        "child_position_m": [0, 0, 2], "first": first});
    run(json!({"bodies": {
        "post": {"mass_kg": 1, "shape": {"point": {}}, "joint": {"fixed": {"position_m": [0, 0, 10]}}},
        "load": {"parent": "post", "mass_kg": 100, "shape": {"sphere": {"radius_m": 0.1}}, "joint": {"universal": joint}},
    }}))
}

fn pushed_n(warning: &Warning) -> f64 {
    let words = warning.text.split("pushes with ").nth(1).expect("it pushes");
    words.split(' ').next().and_then(|word| word.parse().ok()).expect("a number")
}

/// Released from rest, the rod first carries m g cos(angle), except for the share of the sphere's inertia,
/// which is zero at the angle itself: beyond 90 degrees it pushes.
#[test]
fn a_pendant_that_goes_over_the_top_gives_a_warning() {
    let angle = f64::to_radians(122.0);
    let warnings = pendant(angle, None).warnings;
    let [push, over] = warnings.as_slice() else { panic!("{warnings:?}") };
    assert_eq!((push.name.as_str(), over.name.as_str()), ("pendant", "pendant"));
    // Five digits are written.
    assert!((pushed_n(push) / (-WEIGHT_N * angle.cos()) - 1.0).abs() < 1e-4, "{}", push.text);
    assert!(push.time_s == 0.0 && over.time_s == 0.0);
    assert!(
        over.text.contains("load swings to 122.0 deg from the hanging position, beyond 90 deg first at 0 s"),
        "{over:?}"
    );
}

#[test]
fn a_hanging_pendant_and_one_on_a_spring_give_no_warning() {
    assert!(pendant(f64::to_radians(60.0), None).warnings.is_empty());
    let spring = json!({"stiffness_N_m_per_rad": 1.0, "rest_rad": 0.0});
    assert!(pendant(f64::to_radians(122.0), Some(spring)).warnings.is_empty());
}

/// A load of 100 kg whose eye, 0.5 m over its centre, is tied to the world 10 m up by a rod of 3 m; the rod's axes turn with
/// its first attachment.
fn rod(height_m: f64, orientation_rad: [f64; 3]) -> Run {
    run(json!({
        "bodies": {"load": {"mass_kg": 100, "centre_of_mass_m": [0, 0, -0.5],
            "inertia": {"radii_of_gyration": {"radii_m": [0.2, 0.2, 0.2]}},
            "joint": {"floating": {"initial": {"position_m": [0, 0, height_m]}}}}},
        "loops": {"rope": {"first": {"body": "world", "position_m": [0, 0, 10], "orientation_rad": orientation_rad},
            "second": {"body": "load"}, "constraints": [{"distance": {"length_m": 3}}]}},
    }))
}

/// The rod carries the weight: from above it pulls, from below it pushes, for any directions of its axes.
#[test]
fn a_massless_rod_in_compression_gives_a_warning() {
    for orientation in [[0.0; 3], [0.7, -0.4, 1.2]] {
        assert!(rod(6.5, orientation).warnings.is_empty());
        let warnings = rod(12.5, orientation).warnings;
        let [push] = warnings.as_slice() else { panic!("{warnings:?}") };
        assert!(push.text.starts_with("the rod pushes with "), "{}", push.text);
        assert!((pushed_n(push) / WEIGHT_N - 1.0).abs() < 1e-4, "{}", push.text);
        assert_eq!(push.name, "rope");
    }
}

/// A box of 12 m by 6 m whose deck is 3 m over its centre of mass, of 2 m draught.
fn limits() -> LinearLimits {
    let corners = [-6.0, 6.0].into_iter().flat_map(|x| [-3.0, 3.0].map(|y| (x, y)));
    let points: Vec<[f64; 3]> = corners.flat_map(|(x, y)| [[x, y, -2.0], [x, y, 3.0]]).collect();
    LinearLimits::new("hull", 2.0, &points)
}

/// Rows of roll (deg), pitch (deg) and height of the centre (m), a second apart.
fn warned(rows: &[[f64; 3]]) -> Vec<Warning> {
    let mut limits = limits();
    for (second, [roll, pitch, z]) in rows.iter().enumerate() {
        limits.see(second as f64, &[roll.to_radians(), pitch.to_radians(), *z]);
    }
    limits.warnings()
}

#[test]
fn a_linear_hull_with_excessive_heel_or_trim_gives_a_warning() {
    let found = warned(&[[0.0, 0.0, 5.0], [-21.0, 5.0, 5.0], [3.0, 25.0, 5.0]]);
    let [heel, trim] = found.as_slice() else { panic!("{found:?}") };
    assert!(heel.text.starts_with("it heeled to -21.00 deg, at 1 s") && heel.time_s == 1.0, "{}", heel.text);
    assert!(trim.text.starts_with("it trimmed to 25.00 deg, at 2 s") && trim.name == "hull", "{}", trim.text);
    assert!(warned(&[[0.0, 0.0, 5.0], [19.0, -19.0, 5.5]]).is_empty());
}

/// If the hull sinks by 4 m upright, the deck, 3 m above the centre of mass, is 0.5 m under water when the
/// centre is at -3.5 m.
#[test]
fn a_linear_hull_whose_deck_submerges_gives_a_warning() {
    let found = warned(&[[0.0, 0.0, 0.5], [0.0, 0.0, -1.0], [0.0, 0.0, -3.5], [0.0, 0.0, -3.2]]);
    let [sank, deck] = found.as_slice() else { panic!("{found:?}") };
    assert!(sank.text.starts_with("it sank by 4.00 m, at 2 s"), "{}", sank.text);
    assert!(deck.text.contains("deck went 0.50 m under still water, first at 2 s"), "{}", deck.text);
}

/// At a heel of 30 degrees the deck's edge is 3 sin 30 below and 3 cos 30 above the centre of mass.
#[test]
fn the_deck_edge_submerges_on_the_lower_side() {
    let lowest = 3.0 * (f64::to_radians(30.0).cos() - f64::to_radians(30.0).sin());
    let under =
        |centre: f64| warned(&[[0.0, 0.0, centre], [30.0, 0.0, centre]]).iter().any(|w| w.text.contains("deck"));
    assert!(!under(1e-9 - lowest) && under(-1e-9 - lowest));
}

/// Yaw (deg) every second.
fn headed(yaw_deg: impl Fn(f64) -> f64) -> Vec<Warning> {
    let mut heading = MeanHeading::new("hull");
    // As in results, between half a turn to either side.
    let within = |deg: f64| deg - 360.0 * libm::floor((deg + 180.0) / 360.0);
    (0..1800).map(f64::from).for_each(|second| heading.see(second, &[within(yaw_deg(second)).to_radians()]));
    heading.warnings()
}

#[test]
fn a_mean_heading_counts_from_its_start_and_through_full_turns() {
    assert!(headed(|_| 175.0).is_empty());
    // To 175 + 0.5 * 1800 degrees, 100 s behind.
    let found = headed(|time_s| 175.0 + 0.5 * time_s);
    let [turned] = found.as_slice() else { panic!("{found:?}") };
    let begin = "its mean heading turned by 849.75 deg until 1799 s, beyond 5 deg first at 48 s";
    assert!(turned.text.starts_with(begin) && turned.time_s == 48.0 && turned.name == "hull", "{turned:?}");
}

/// Yaw of 20 degrees with waves of 15 s changes the mean by 0.5 degrees, for any duration.
#[test]
fn yaw_at_wave_frequency_does_not_change_the_mean_heading() {
    let wave = |time_s: f64| 20.0 * libm::sin(core::f64::consts::TAU * time_s / 15.0);
    assert!(headed(|time_s| 178.0 + wave(time_s)).is_empty());
    assert_eq!(headed(|time_s| 178.0 + wave(time_s) - 0.01 * time_s).len(), 1);
}

/// A mass of 2 kg on a spring of 200 N/m, drawn out by 3 m: a circular frequency of 10 rad/s, 900 J.
fn oscillator(integrator: &str, step_s: f64) -> Vec<Warning> {
    let joint = json!({"prismatic": {"name": "slide", "axis": [1, 0, 0], "initial_extension_m": 3.0,
        "spring": {"stiffness_N_per_m": 200.0, "rest_m": 0.0}}});
    let simulation = json!({"step_s": step_s, "duration_s": 0.5, "record_every_s": step_s, "integrator": integrator});
    run_by(simulation, json!({"bodies": {"mass": {"mass_kg": 2, "shape": {"point": {}}, "joint": joint}}})).warnings
}

/// Euler's forward step multiplies the energy of an oscillator by 1 + (omega h)^2: by 1.01^50 after 50 steps of 10 ms.
#[test]
fn a_run_whose_scheme_adds_energy_gives_a_warning_and_one_that_conserves_it_does_not() {
    let warnings = oscillator("forward_euler", 0.01);
    let [warning] = warnings.as_slice() else { panic!("{warnings:?}") };
    assert_eq!((warning.name.as_str(), warning.time_s), ("energy", 0.5));
    let gained_kj = significant(0.9 * (1.01_f64.powi(50) - 1.0), 3);
    assert!(warning.text.starts_with(&format!("is off its balance by {gained_kj} kJ, ")), "{warning:?}");
    // Newmark's average acceleration keeps it, RK4 loses (omega h)^6 / 72 a step.
    assert_eq!(oscillator("newmark", 0.01), []);
    assert_eq!(oscillator("rk4", 0.01), []);
}
