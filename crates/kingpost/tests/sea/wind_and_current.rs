//! Loads of wind and current by coefficients, against closed forms.

use crate::common;

use common::{assert_linearised, barge, simulation, values};
use core::f64::consts::{FRAC_PI_2, PI, TAU};
use kingpost::elements::flow::DirectionTable;
use kingpost::scalar::{Dual, LANES, Lanes, Scalar};
use kingpost::scenario::{read, read_with};

/// A ship of 1000 t; C_x = -cos, C_y = sin of the direction, C_n = 0.1 sin 2 theta.
fn ship(initial: &str, more: &str) -> String {
    format!(
        "version: 1\ntitle: A ship in wind and current\nsimulation: {{step_s: 0.05, duration_s: 100}}\nbodies:\n  \
         ship:\n    mass_t: 1000\n    inertia: {{tensor: {{moments_kg_m2: [2e7, 4e8, 4e8]}}}}\n    \
         joint: {{floating: {{initial: {{{initial}}}}}}}\n{more}"
    )
}

fn coefficients() -> String {
    let degrees: Vec<f64> = (0..=36).map(|k| 5.0 * f64::from(k)).collect();
    let column = |f: &dyn Fn(f64) -> f64| {
        let numbers: Vec<String> = degrees.iter().map(|degrees| format!("{:.17}", f(degrees.to_radians()))).collect();
        numbers.join(", ")
    };
    format!(
        "coefficients: {{symmetric: true, directions_deg: {degrees:?}, surge: [{}], sway: [{}], yaw: [{}], \
         frontal_area_m2: 200, lateral_area_m2: 900, length_m: 80}}",
        column(&libm::cos),
        column(&libm::sin),
        column(&|theta| 0.1 * libm::sin(2.0 * theta))
    )
}

fn wind(more: &str) -> String {
    format!("wind: {{speed_m_s: 15, direction_deg: 150{more}}}\n")
}

fn wind_load(more: &str) -> String {
    format!("forces: {{breeze: {{wind_load: {{body: ship{more}, {}}}}}}}", coefficients())
}

/// rho/2 V^2 A C at the angle that the wind is seen under, at a point off the centre of mass, by a ship under way.
#[test]
fn the_load_is_that_of_the_relative_velocity() {
    let more = wind(", profile: uniform") + &wind_load(", position_m: [5, 0, 8]");
    let motion = "velocity_m_s: [3, -1, 0], orientation_deg: [0, 0, 30], angular_velocity_rad_s: [0, 0, 0.1]";
    let mut simulation = simulation(&ship(motion, &more));
    let ([vx, vy], (sin, cos)) = ([3.0, -1.0], libm::sincos(PI / 6.0));
    let (wx, wy) = (15.0 * libm::cos(5.0 * PI / 6.0) - vx, 15.0 * libm::sin(5.0 * PI / 6.0) - vy);
    let (along, aside) = (cos * wx + sin * wy, -sin * wx + cos * wy - 0.5);
    let (square, theta) = (along * along + aside * aside, libm::atan2(aside, along));
    let pressure = 0.5 * 1.225 * square;
    let force = [pressure * 200.0 * libm::cos(theta), pressure * 900.0 * libm::sin(theta)];
    let moment = pressure * 900.0 * 80.0 * 0.1 * libm::sin(2.0 * theta);
    let found = values(&mut simulation, "flow_force");
    // Pieces of 5 degrees: an error of h^4 / 384, and of the slope, h^3 / 6 at most.
    let near = |a: f64, b: f64, size: f64| assert!((a - b).abs() < 5e-5 * size, "{a} {b}");
    near(found[0], force[0], pressure * 200.0);
    near(found[1], force[1], pressure * 900.0);
    near(found[5], moment, pressure * 7200.0 * 2.0);
    assert_eq!((found[2], found[3], found[4]), (0.0, 0.0, 0.0));
    let acceleration = simulation.acceleration(None).unwrap();
    near(acceleration[3] * 2e7, -8.0 * found[1], 1.0);
    near(acceleration[5] * 4e8, found[5] + 5.0 * found[1], 1.0);
    let channel = simulation.channels().iter().find(|channel| channel.variable == "flow_force").unwrap();
    assert_eq!(channel.labels[0], ["breeze"]);
}

/// A wind from astern: m v' = c (U - v)^2 has v = U (1 - 1 / (1 + c U t / m)); energy is what the wind gives.
#[test]
fn a_following_wind_carries_a_ship_along() {
    let more = wind(", profile: uniform").replace("150", "0") + &wind_load("");
    let mut simulation = simulation(&ship("velocity_m_s: [0, 0, 0]", &more));
    simulation.step(1000).unwrap();
    let c = 0.5 * 1.225 * 200.0;
    let expected = 15.0 * (1.0 - 1.0 / (1.0 + c * 15.0 * 50.0 / 1e6));
    assert!((simulation.state().v[0] - expected).abs() < 1e-10);
    assert!((values(&mut simulation, "work_by_outside")[0] - 0.5e6 * expected * expected).abs() < 1e-4);
    assert!(values(&mut simulation, "energy_error")[0].abs() < 1e-4);
}

/// The force ahead goes with the square of the speed at the height of the load.
#[test]
fn profiles_of_wind_and_current_follow_their_formulas() {
    let surge = |more: &str| values(&mut simulation(&ship("velocity_m_s: [0, 0, 0]", more)), "flow_force")[0];
    let of_wind = |profile: &str| surge(&(wind(profile).replace("150", "0") + &wind_load(", height_m: 25")));
    let uniform = of_wind(", profile: uniform");
    assert!((uniform - 0.5 * 1.225 * 225.0 * 200.0).abs() < 1e-9);
    assert!((of_wind("") / uniform - libm::pow(2.5, 2.0 / 7.0)).abs() < 1e-14);
    let log = of_wind(", profile: {logarithmic: {roughness_m: 0.001}}") / uniform;
    assert!((log - libm::pow(libm::log(25e3) / libm::log(10e3), 2.0)).abs() < 1e-14);
    let of_current = |profile: &str| {
        let load = wind_load(", draught_m: 8").replace("wind_load", "current_load");
        surge(&format!("sea: {{depth_m: 20, current_m_s: [2, 0]{profile}}}\n{load}"))
    };
    let uniform = of_current("");
    assert!((uniform - 0.5 * 1025.0 * 4.0 * 200.0).abs() < 1e-7);
    // The mean of ((h + z) / h)^(2/7) over the draught, by the midpoint rule.
    let n = 10_000;
    let mean: f64 = (0..n).map(|k| libm::pow(1.0 - 8.0 * (f64::from(k) + 0.5) / f64::from(n) / 20.0, 2.0 / 7.0)).sum();
    let share = of_current(", current_profile: {power_law: {}}") / uniform;
    assert!((share - mean / f64::from(n)).abs() < 1e-9, "{share}");
}

/// Returns the coefficients over another scalar.
fn over<S: Scalar>(rows: &[[f64; 3]]) -> Vec<[S; 3]> {
    rows.iter().map(|row| row.map(S::constant)).collect()
}

/// The curve goes through its points, closes smoothly, and is mirrored for port; each lane has the bits that it has
/// alone.
#[test]
fn a_table_is_a_smooth_curve_through_its_points() {
    let directions = [0.0, 0.4, 1.0, FRAC_PI_2, 2.2, PI];
    let rows: Vec<[f64; 3]> =
        directions.iter().map(|t| [libm::cos(*t) - 0.2, libm::sin(*t), libm::sin(2.0 * t)]).collect();
    let table = DirectionTable::new(&directions, &rows, true).unwrap();
    let over_dual = DirectionTable::new(&directions, &over::<Dual<1>>(&rows), true).unwrap();
    for (direction, [x, y, yaw]) in directions.iter().zip(&rows) {
        let (starboard, port) = (table.at(*direction), table.at(-direction));
        for (found, expected) in starboard.iter().zip([x, y, yaw]).chain(port.iter().zip([x, &-y, &-yaw])) {
            assert!((found - expected).abs() < 1e-14);
        }
        let slope = |by: f64| over_dual.at(Dual::<1>::variable(direction + by, 0)).map(|c| c.derivative[0]);
        for (ahead, behind) in slope(1e-9).iter().zip(slope(-1e-9)) {
            assert!((ahead - behind).abs() < 1e-6, "at {direction}");
        }
    }
    let angles = [-3.1, -0.2, 0.2, 3.0];
    let over_lanes = DirectionTable::new(&directions, &over::<Lanes>(&rows), true).unwrap();
    let together = over_lanes.at(Lanes::new(angles)).map(Lanes::to_array);
    for lane in 0..LANES {
        assert_eq!(table.at(angles[lane]).map(f64::to_bits), together.map(|column| column[lane].to_bits()));
    }
    // A whole turn, begun anywhere.
    for first in [-PI, -1.0, 0.0, 2.0] {
        let directions: Vec<f64> = (0..12).map(|k| first + TAU * f64::from(k) / 12.0).collect();
        let rows: Vec<[f64; 3]> = directions.iter().map(|t| [libm::cos(*t), libm::sin(*t), 1.0]).collect();
        let table = DirectionTable::new(&directions, &rows, false).unwrap();
        for k in -31..=31 {
            let theta = 0.1 * f64::from(k);
            let [x, y, yaw] = table.at(theta);
            // h^3 / 6 of the slope's error over a piece of h = 30 degrees.
            assert!((x - libm::cos(theta)).abs() < 8e-3 && (y - libm::sin(theta)).abs() < 8e-3 && yaw == 1.0);
        }
    }
}

#[test]
fn wind_and_current_are_linearised_exactly() {
    let sea = "sea: {depth_m: 50, current_m_s: [0.5, -0.8]}\n".to_owned();
    let loads = wind_load(", position_m: [5, 0, 8]").replace("}}}}", "}}");
    let current = format!("tide: {{current_load: {{body: ship, position_m: [-3, 0, -2], {}}}}}}}", coefficients());
    let motion = "velocity_m_s: [3, -1, 0], orientation_deg: [2, 1, 30], angular_velocity_rad_s: [0.01, 0, 0.02]";
    assert!(loads.ends_with("}}"));
    assert_linearised(&ship(motion, &(sea + &wind("") + &loads + "}, " + &current)));
}

/// Without a spring nothing accelerates by where the ship is; with one it rests.
#[test]
fn the_error_of_a_free_ship_in_wind_without_equilibrium_contains_advice() {
    let loads = wind("") + &wind_load("").replace("}}}}", "}}");
    let error = simulation(&ship("position_m: [0, 0, 0]", &(loads.clone() + "}}"))).settle().expect_err("it drifts");
    let words = error.to_string();
    assert!(words.contains("nothing holds ship against horizontal forces: hold it, by soft_hold"), "{words}");
    let line = "line: {spring_line: {first: {body: ship}, second: {body: world, position_m: [-300, 0, 0]}, \
                unstretched_length_m: 100, axial_stiffness_N: 1e6}}";
    let moored = simulation(&ship("position_m: [0, 0, 0]", &(loads + "}, " + line + "}"))).settle();
    assert!(!moored.map_or_else(|error| error.to_string(), |_| String::new()).contains("nothing holds"));
}

/// A load whose coefficient in one row is 0.1.
fn pushed_along(load: &str, column: &str, row: usize) -> String {
    let begin = load.find(&format!("{column}: [")).expect("a column") + column.len() + 3;
    let end = begin + load[begin..].find(']').expect("its end");
    let mut numbers: Vec<&str> = load[begin..end].split(", ").collect();
    numbers[row] = "0.1";
    format!("{}{}{}", &load[..begin], numbers.join(", "), &load[end..])
}

#[test]
fn invalid_tables_and_winds_are_refused() {
    let refused = |text: &str, message: &str| {
        let error = read(&ship("velocity_m_s: [0, 0, 0]", text), "test.yaml", &[]).unwrap_err().to_string();
        assert!(error.contains(message), "{error}");
    };
    let load = wind_load("");
    let wind = wind("");
    refused(&load, "forces.breeze.wind_load: found a wind load, but no wind");
    refused(
        &(wind.clone() + &load.replace("symmetric: true", "symmetric: false").replace("[0.0, 5.0", "[0.0, -5.0")),
        "directions",
    );
    refused(&(wind.clone() + &load.replace(", 180.0]", ", 181.0]")), "where the hull is symmetric");
    // Of a symmetric hull; the sines of 180 degrees above are rounding.
    for (column, row) in [("sway", 0), ("yaw", 0), ("sway", 36), ("yaw", 36)] {
        let text = pushed_along(&load, column, row);
        let message = format!("{column}.{row}: found 0.1, allowed: 0 in a flow along a symmetric hull");
        refused(&(wind.clone() + &text), &message);
        let whole = text.replace("symmetric: true", "symmetric: false");
        read(&ship("velocity_m_s: [0, 0, 0]", &(wind.clone() + &whole)), "test.yaml", &[])
            .expect("any hull may be pushed aside");
    }
    refused(&(wind.clone() + &load.replace("surge: [", "surge: [0.5, ")), "surge: found 38 numbers, allowed: 37");
    refused(&(wind.replace("}", ", profile: {logarithmic: {roughness_m: 11}}}") + &load), "roughness_m: found 11");
    let current = load.replace("wind_load", "current_load");
    let profile = "sea: {current_m_s: [1, 0], current_profile: {power_law: {}}}\n".to_owned();
    refused(&(profile.clone() + &current), "sea.current_profile");
    refused(&(profile.replace("sea: {", "sea: {depth_m: 20, ") + &current), "current_load.draught_m: found nothing");
}

/// The wind goes to 150 degrees: it comes from -30, which is 60 degrees to starboard of a bow at 30.
#[test]
fn a_ship_measures_the_direction_from_which_the_wind_blows() {
    for (heading_deg, from_deg) in [(30.0, 60.0), (-30.0, 0.0), (-120.0, -90.0), (150.0, 180.0_f64)] {
        let text = barge::TEXT.replace(
            "joint: {floating: {}}",
            &format!("joint: {{floating: {{initial: {{orientation_deg: [0, 0, {heading_deg}]}}}}}}"),
        );
        let afloat = read_with(&(text + &wind("")), "barge.yaml", &[], &barge::files()).expect("it reads");
        let mut afloat = afloat.simulation().expect("it builds");
        let apart = values(&mut afloat, "wind_direction")[0] - from_deg.to_radians();
        assert!(libm::sin(apart).abs() < 1e-12 && libm::cos(apart) > 0.0, "{apart} at {heading_deg}");
        let speed = afloat.channels().iter().find(|channel| channel.variable == "wind_speed").expect("a column");
        assert_eq!(speed.columns, ["hull.wind_speed"]);
    }
}

/// Where nothing floats the world's x is ahead. At the height of a load the gusts are the same ones.
#[test]
fn the_measured_wind_contains_the_gusts() {
    let gusts = ", profile: npd, gusts: {spectrum: npd, components: 40, ramp_s: 0}";
    let text = ship("", &(wind(gusts) + &wind_load(", height_m: 10")));
    let mut found = simulation(&text);
    for _ in 0..5 {
        found.step(20).expect("it blows");
        let (read, acts) = (values(&mut found, "wind_speed")[0], values(&mut found, "flow_speed")[0]);
        assert!((read - acts).abs() < 1e-12 && (read - 15.0).abs() > 1e-6, "{read} {acts}");
        assert_eq!(values(&mut found, "mean_wind_speed"), [15.0]);
        assert!((values(&mut found, "wind_direction")[0] - PI / 6.0).abs() < 1e-12);
    }
}
