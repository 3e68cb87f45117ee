//! Currents that vary with depth, the velocity that a load uses, and damping relative to the water or the
//! earth.

use crate::common;

use common::{assert_linearised, simulation, values};
use core::f64::consts::PI;
use kingpost::scenario::read;

const TABLE: &str = "table: {depths_m: [0, 5, 20], speeds_m_s: [1.2, 0.8, 0.2], directions_deg: [0, 0, 0]}";

/// A ship of 1000 t on which a current presses along it by rho/2 V |V| 100 m^2, and across by four times that.
fn ship(sea: &str, load: &str) -> String {
    format!(
        "version: 1\ntitle: A ship in a current\nsimulation: {{step_s: 0.05, duration_s: 100}}\nsea: {{{sea}}}\nbodies:\n  \
         ship:\n    mass_t: 1000\n    inertia: {{tensor: {{moments_kg_m2: [2e7, 4e8, 4e8]}}}}\n    \
         joint: {{floating: {{}}}}\nforces: {{tide: {{current_load: {{body: ship{load}, coefficients: {{symmetric: false, \
         directions_deg: [0, 90, 180, 270], surge: [1, 0, -1, 0], sway: [0, 1, 0, -1], yaw: [0, 0, 0, 0], \
         frontal_area_m2: 100, lateral_area_m2: 400, length_m: 80}}}}}}}}\n"
    )
}

fn profile(table: &str) -> String {
    format!("depth_m: 50, current_profile: {{{table}}}")
}

fn speed(sea: &str, load: &str) -> f64 {
    values(&mut simulation(&ship(sea, load)), "flow_speed")[0]
}

/// The table's own numbers between its rows, and their means by quadrature of 10,000 points, of order 1e-9 here.
#[test]
fn the_speed_of_a_table_is_that_at_a_depth_or_a_mean_over_the_draught() {
    let at = |depth: f64| if depth < 5.0 { 1.2 - 0.08 * depth } else { (0.8 - 0.04 * (depth - 5.0)).max(0.2) };
    for depth in [0.0, 2.0, 5.0, 11.0, 20.0, 35.0] {
        let found = speed(&profile(TABLE), &format!(", speed: {{at_depth: {{depth_m: {depth}}}}}"));
        assert!((found - at(depth)).abs() < 1e-14, "{depth} m: {found}");
    }
    for draught in [3.0, 8.0, 30.0] {
        let mean = |of: &dyn Fn(f64) -> f64| -> f64 {
            (0..10_000).map(|k| of(draught * (f64::from(k) + 0.5) / 10_000.0)).sum::<f64>() / 10_000.0
        };
        let (plain, square) = (mean(&at), mean(&|depth| at(depth).powi(2)).sqrt());
        let found = |kind: &str| speed(&profile(TABLE), &format!(", draught_m: {draught}{kind}"));
        assert!((found(", speed: mean") - plain).abs() < 1e-7, "{draught} m");
        assert!((found("") - square).abs() < 1e-7, "{draught} m");
        assert_eq!(found(""), found(", speed: mean_square"));
    }
}

/// The power law's means: U h / T (1 - (1 - T / h)^(n + 1)) / (n + 1); at a depth U (1 - d / h)^n.
#[test]
fn the_speed_of_a_power_law_is_that_at_a_depth_or_a_mean_over_the_draught() {
    let sea = "depth_m: 20, current_m_s: [2, 0], current_profile: {power_law: {exponent: 0.2}}";
    let mean = 2.0 * 20.0 / 8.0 * (1.0 - libm::pow(0.6, 1.2)) / 1.2;
    assert!((speed(sea, ", draught_m: 8, speed: mean") - mean).abs() < 1e-14);
    assert!((speed(sea, ", speed: {at_depth: {depth_m: 8}}") - 2.0 * libm::pow(0.6, 0.2)).abs() < 1e-14);
    assert_eq!(speed(sea, ", speed: {at_depth: {depth_m: 20}}"), 0.0);
}

/// Drag is V |V|: for a current that reverses with depth, that of the difference of both halves.
#[test]
fn a_current_that_reverses_with_depth_acts_with_the_difference() {
    let table =
        "table: {depths_m: [0, 10, 10.001, 20], speeds_m_s: [1, 1, 0.5, 0.5], directions_deg: [0, 0, 180, 180]}";
    let found = values(&mut simulation(&ship(&profile(table), ", draught_m: 20")), "flow_force")[0];
    assert!((found / (0.5 * 1025.0 * 100.0 * (1.0 - 0.25) / 2.0) - 1.0).abs() < 1e-3, "{found}");
    let none = "table: {depths_m: [0, 20], speeds_m_s: [1, 1], directions_deg: [0, 180]}";
    assert!(values(&mut simulation(&ship(&profile(none), ", draught_m: 20")), "flow_force")[0].abs() < 1e-9);
    // Half a turn of the components' mean: at 45 degrees by the square of 1 / sqrt(2).
    let across = "table: {depths_m: [0, 20], speeds_m_s: [1, 1], directions_deg: [0, 90]}";
    let found = speed(&profile(across), ", speed: {at_depth: {depth_m: 10}}");
    assert!((found - libm::cos(PI / 4.0)).abs() < 1e-14);
}

#[test]
fn a_load_of_a_table_is_linearised_exactly() {
    let table = "table: {depths_m: [0, 5, 20], speeds_m_s: [1.2, 0.8, 0.2], directions_deg: [10, 40, 100]}";
    assert_linearised(&ship(&profile(table), ", draught_m: 8, position_m: [3, 1, -2]"));
}

#[test]
fn invalid_profiles_are_refused() {
    let refused = |sea: &str, load: &str, message: &str| {
        let error = read(&ship(sea, load), "test.yaml", &[]).expect_err("it is refused").to_string();
        assert!(error.contains(message), "{error}");
    };
    let draught = ", draught_m: 8";
    let table = "sea.current_profile.table";
    refused(&profile(&TABLE.replace("[0, 5, 20]", "[0, 5]")), draught, &format!("{table}.speeds_m_s: found 3 numbers"));
    refused(&profile(&TABLE.replace("[0, 5, 20]", "[1, 5, 20]")), draught, &format!("{table}.depths_m.0: found 1"));
    refused(&profile(&TABLE.replace("[0, 5, 20]", "[0, 5, 5]")), draught, &format!("{table}.depths_m.2: found 5"));
    refused(
        &profile(&TABLE.replace("[0, 5, 20]", "[0, 5, 60]")),
        draught,
        "found 60, allowed: at most sea.depth_m, 50",
    );
    refused(&(profile(TABLE) + ", current_m_s: [1, 0]"), draught, "sea.current_m_s: found [1, 0], allowed: nothing");
    refused(&profile(TABLE), "", "current_load.draught_m: found nothing");
    refused(&profile(TABLE), ", draught_m: 60", "current_load.draught_m: found 60");
    let deep = ", speed: {at_depth: {depth_m: 51}}";
    refused(&profile(TABLE), deep, "current_load.speed.at_depth.depth_m: found 51, allowed: at most sea.depth_m, 50");
}

/// A ship whose damping is relative to the earth stays in a current; a ship whose damping is relative to the
/// water is carried along by v = U (1 - e^(-c t / m)) or, quadratic, U (1 - 1 / (1 + c U t / m)).
#[test]
fn damping_is_relative_to_the_water_or_to_the_earth() {
    let after_50_s = |damping: &str, start: &str| {
        let text = format!(
            "version: 1\ntitle: Damped\nsimulation: {{step_s: 0.05, duration_s: 100}}\nsea: {{current_m_s: [0.6, 0]}}\n\
             bodies: {{ship: {{mass_t: 1000, inertia: {{tensor: {{moments_kg_m2: [2e7, 4e8, 4e8]}}}}, \
             joint: {{floating: {{{start}}}}}}}}}\nforces: {{drag: {{{damping}}}}}\n"
        );
        let mut simulation = simulation(&text);
        simulation.step(1000).expect("it runs");
        let error = values(&mut simulation, "energy_error")[0];
        assert!(error.abs() < 1e-4, "{damping}: {error}");
        let of = |variable: &str, simulation: &mut _| values(simulation, variable)[0];
        (simulation.state().v[0], of("work_by_outside", &mut simulation))
    };
    let linear = |to: &str| format!("viscous_damping: {{body: ship, linear_N_s_m: [1e4, 1e4, 0]{to}}}");
    let quadratic = |to: &str| format!("quadratic_damping: {{body: ship, linear_N_s2_m2: [1e4, 1e4, 0]{to}}}");
    let (rate, flow) = (1e4 / 1e6, 0.6);
    let with_water = flow * (1.0 - libm::exp(-rate * 50.0));
    for to in ["", ", relative_to: water"] {
        assert!((after_50_s(&linear(to), "").0 - with_water).abs() < 1e-10);
        assert!((after_50_s(&quadratic(to), "").0 - flow * (1.0 - 1.0 / (1.0 + rate * flow * 50.0))).abs() < 1e-9);
    }
    let earth = ", relative_to: earth";
    assert_eq!(after_50_s(&linear(earth), ""), (0.0, 0.0));
    assert_eq!(after_50_s(&quadratic(earth), ""), (0.0, 0.0));
    let moving = "initial: {velocity_m_s: [0.5, 0, 0]}";
    let (v, work) = after_50_s(&linear(earth), moving);
    assert!((v - 0.5 * libm::exp(-rate * 50.0)).abs() < 1e-10 && work == 0.0, "{v} {work}");
    let (v, work) = after_50_s(&quadratic(earth), moving);
    assert!((v - 0.5 / (1.0 + rate * 0.5 * 50.0)).abs() < 1e-9 && work == 0.0, "{v} {work}");
}
