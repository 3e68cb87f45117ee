//! Description of a model by the engine, for programs that draw it or write about it.

use kingpost::elements::LineStyle;
use kingpost::scenario::{self, Scenario};
use kingpost::simulation::Simulation;
use serde_json::{Value, json};

/// Number of points of a drawn line.
const POINTS: usize = 49;
/// Largest distance of the ends of a drawn line from its true ends, m: the last digits.
const ROUNDING_M: f64 = 1e-9;

/// A ship that hangs where it is put, with a load on a rope and lines of all kinds; its drawing frame is on its keel.
fn with_lines(z_m: f64) -> Scenario {
    let text = format!(
        "version: 1
title: lines
simulation: {{step_s: 0.01, duration_s: 1}}
bodies:
  ship:
    mass_t: 1000
    centre_of_mass_m: [1, 0, 3]
    inertia: {{radii_of_gyration: {{radii_m: [5, 15, 15]}}}}
    joint: {{floating: {{initial: {{position_m: [0, 0, {z_m}]}}}}}}
  load:
    parent: ship
    mass_t: 5
    shape: {{sphere: {{radius_m: 1}}}}
    joint: {{spherical: {{name: rope, position_m: [0, 8, 12], child_position_m: [0, 0, 9]}}}}
forces:
  slack: {{catenary_line: {{fairlead: {{body: ship, position_m: [20, 3, 5]}}, anchor_m: [200, 120, -50], \
unstretched_length_m: 235, weight_in_water_N_per_m: 800, axial_stiffness_N: 3.0e+8}}}}
  taut: {{catenary_line: {{fairlead: {{body: ship, position_m: [20, -3, 5]}}, anchor_m: [200, -120, -50], \
unstretched_length_m: 214, weight_in_water_N_per_m: 800, axial_stiffness_N: 3.0e+7}}}}
  hawser: {{spring_line: {{first: {{body: ship, position_m: [-20, 0, 5]}}, second: {{body: world, position_m: [-50, 0, 4]}}, \
unstretched_length_m: 31, axial_stiffness_N: 1.0e+6}}}}
  gone: {{spring_line: {{enabled: false, first: {{body: ship}}, second: {{body: world}}, unstretched_length_m: 31, \
axial_stiffness_N: 1.0e+6}}}}
"
    );
    scenario::read(&text, "lines.yaml", &[]).expect("it reads")
}

/// The points of each line by its name.
fn drawn(simulation: &mut Simulation) -> Vec<(String, Vec<[f64; 3]>)> {
    let points = simulation.line_points();
    let mut from = 0;
    let of = |line: kingpost::elements::DrawnLine| {
        let own = points[3 * from..3 * (from + line.points)].chunks(3).map(|point| [point[0], point[1], point[2]]);
        from += line.points;
        (line.name, own.collect())
    };
    simulation.lines().into_iter().map(of).collect()
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

fn length(points: &[[f64; 3]]) -> f64 {
    points.windows(2).map(|pair| distance(pair[0], pair[1])).sum()
}

/// Source: the geometry of the scenario.
#[test]
fn every_rope_is_drawn_from_end_to_end() {
    for z_m in [0.0, 3.0, -10.0] {
        let mut simulation = with_lines(z_m).simulation().expect("it builds");
        assert!(simulation.lines().iter().all(|line| line.style == LineStyle::Line));
        let drawn = drawn(&mut simulation);
        let names: Vec<&str> = drawn.iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(names, ["rope", "slack", "taut", "hawser"]);
        // The centre of mass stands 3 m over the keel that the drawing frame is on, 1 m forward of it.
        let at = |x: f64, y: f64, z: f64| [x - 1.0, y, z_m + z - 3.0];
        let ends = [
            (at(0.0, 8.0, 12.0), at(0.0, 8.0, 3.0)),
            (at(20.0, 3.0, 5.0), [200.0, 120.0, -50.0]),
            (at(20.0, -3.0, 5.0), [200.0, -120.0, -50.0]),
            (at(-20.0, 0.0, 5.0), [-50.0, 0.0, 4.0]),
        ];
        for ((name, points), (first, second)) in drawn.iter().zip(ends) {
            assert!(distance(points[0], first) < ROUNDING_M, "{name}: {:?} {first:?}", points[0]);
            assert!(distance(points[points.len() - 1], second) < ROUNDING_M, "{name}");
        }
    }
}

/// Source: the line's length; the chords of 48 arcs fall short of it by their square, a ten-thousandth here.
#[test]
fn a_drawn_mooring_line_has_its_length_except_for_stretch_and_stays_above_the_seabed() {
    for z_m in [0.0, 3.0, -10.0] {
        let mut simulation = with_lines(z_m).simulation().expect("it builds");
        let mut row = Vec::new();
        simulation.write_row(&mut row);
        let tension_of = |line: usize| {
            let channel = simulation.channels().iter().find(|channel| channel.variable == "line_tension");
            row[channel.expect("there are lines").offset + line]
        };
        let [slack, taut] = [tension_of(0), tension_of(1)];
        let drawn = drawn(&mut simulation);
        for (place, unstretched_m, tension_n, stiffness_n) in [(1, 235.0, slack, 3e8), (2, 214.0, taut, 3e7)] {
            let (name, points) = &drawn[place];
            assert_eq!(points.len(), POINTS);
            let (found, longest) = (length(points), unstretched_m * (1.0 + tension_n / stiffness_n));
            assert!(found > unstretched_m * (1.0 - 1e-4) && found < longest + ROUNDING_M, "{name}: {found}");
            assert!(points.iter().all(|point| point[2] > -50.0 - ROUNDING_M), "{name}");
        }
    }
}

/// Source: of a parabola over the chord c the length is `c (1 + e - 9/10 e^2 + ...)` where its sag makes e of the first order.
#[test]
fn the_slack_of_a_hawser_is_a_sag_and_a_taut_one_is_straight() {
    let mut simulation = with_lines(0.0).simulation().expect("it builds");
    let (_, points) = &drawn(&mut simulation)[3];
    let chord = distance(points[0], points[POINTS - 1]);
    let second_order = chord * (31.0 / chord - 1.0).powi(2);
    assert!((length(points) - 31.0).abs() < second_order && second_order < 0.2, "{}", length(points));
    assert!(points[POINTS / 2][2] < 2.0);
    let mut away = with_lines(0.0).simulation().expect("it builds");
    let mut q = away.state().q.clone();
    q[0] += 4.0;
    away.set_state(&q, &away.state().v.clone(), None).expect("a motion");
    let (_, points) = &drawn(&mut away)[3];
    assert!((length(points) - distance(points[0], points[POINTS - 1])).abs() < ROUNDING_M);
}

fn read(bodies: Value, forces: Value) -> Scenario {
    let text = json!({"version": 1, "title": "described", "simulation": {"step_s": 0.01, "duration_s": 1},
        "bodies": bodies, "forces": forces});
    scenario::read(&text.to_string(), "described.json", &[]).expect("it reads")
}

/// Source: closed forms of homogeneous solids: m (b^2 + c^2) / 12, m r^2 / 2, m (3 r^2 + l^2) / 12, 2/5 m r^2.
#[test]
fn the_inertia_of_solids_is_described() {
    let floating = json!({"floating": {}});
    let body = |shape: Value| json!({"mass_kg": 12, "shape": shape, "joint": floating});
    let described = read(
        json!({
            "box": body(json!({"box": {"length_m": 20, "width_m": 10, "height_m": 5}})),
            "roller": body(json!({"cylinder": {"radius_m": 2, "length_m": 3, "axis": "x"}})),
            "ball": body(json!({"sphere": {"radius_m": 2}})),
        }),
        json!({}),
    )
    .describe()
    .expect("it builds");
    let expected = [[125.0, 425.0, 500.0], [24.0, 21.0, 21.0], [19.2, 19.2, 19.2]];
    for (body, moments) in described.bodies.iter().zip(expected) {
        for (row, moment) in moments.into_iter().enumerate() {
            for column in 0..3 {
                let wanted = if row == column { moment } else { 0.0 };
                assert!((body.inertia_kg_m2[row][column] - wanted).abs() < 1e-12 * 500.0, "{}", body.name);
            }
        }
        assert!(body.floats, "{}", body.name);
    }
}

/// Source: a body that is connected to the world does not fall.
#[test]
fn a_body_without_support_gives_a_warning() {
    let solid = |joint: Value| json!({"mass_kg": 12, "shape": {"sphere": {"radius_m": 1}}, "joint": joint});
    let rope = |first: &str, second: &str| {
        let end = |body: &str| json!({"body": body, "position_m": [0, 0, 0]});
        json!({"spring_line": {"first": end(first), "second": end(second), "unstretched_length_m": 1.0,
            "axial_stiffness_N": 1e4}})
    };
    let free = || solid(json!({"floating": {"initial": {"position_m": [0, 0, 5]}}}));
    let bodies = || json!({"hung": free(), "lost": free(), "paired": free(), "held": solid(json!({"floating": {"hold_translation": true}}))});
    let forces = |gravity: bool| json!({"weight": {"gravity": {"enabled": gravity}}, "one": rope("world", "hung"), "two": rope("lost", "paired")});
    let of = |gravity: bool| read(bodies(), forces(gravity)).describe().expect("it builds");
    let falls = |name: &str| format!("gravity acts and nothing carries {name}: it falls");
    assert_eq!(of(true).warnings, [falls("lost"), falls("paired")]);
    assert!((of(true).gravity_m_s2 - 9.80665).abs() < 0.2);
    assert!(of(false).warnings.is_empty() && of(false).gravity_m_s2 == 0.0);
}

/// A bar has to know what to measure a column by: the bounds are in the limit's unit, a row is in SI.
#[test]
fn limits_are_described_with_their_units() {
    let text = "version: 1
title: limits
simulation: {step_s: 0.01, duration_s: 1}
bodies:
  ship: {mass_t: 1000, shape: {box: {length_m: 60, width_m: 15, height_m: 8}}, joint: {floating: {}}}
limits:
  lean: {column: ship.roll, within: 5, unit: deg, from_s: 2}
  high: {column: ship.position.z, at_least: -1}
  off: {column: ship.position.z, at_most: 0, enabled: false}
";
    let found = scenario::read(text, "limits.yaml", &[]).expect("it reads").describe().expect("it builds").limits;
    let names: Vec<&str> = found.iter().map(|limit| limit.name.as_str()).collect();
    assert_eq!(names, ["lean", "high"]);
    assert_eq!((found[0].at_least, found[0].at_most, found[0].from_s), (Some(-5.0), Some(5.0), 2.0));
    assert!((found[0].unit_si - 1f64.to_radians()).abs() < 1e-15);
    assert_eq!(
        (found[1].at_least, found[1].at_most, found[1].unit.as_str(), found[1].unit_si),
        (Some(-1.0), None, "m", 1.0)
    );
}
