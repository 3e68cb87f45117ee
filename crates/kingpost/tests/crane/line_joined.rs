//! Lines with mass that are fastened to lines: statics, motion, energy and derivatives through their joints.

use crate::common::{simulation, values};
use crate::line_dynamics::{error, frequencies_of};
use kingpost::analysis::gradient;
use kingpost::batch;
use kingpost::scenario::{Files, read};
use kingpost::simulation::Simulation;
use nalgebra::{Matrix3, Vector3};
use serde_json::json;

const G: f64 = 9.80665;

/// Value of a line in the results.
fn of_line(run: &mut Simulation, variable: &str, line: &str) -> f64 {
    let at = run.channels().iter().find(|channel| channel.variable == variable).expect("a channel");
    let place = at.labels[0].iter().position(|label| label == line).expect("a line with results");
    values(run, variable)[place]
}

/// The last drawn point of a line, from its second end on, world, m.
fn from_second_end<const N: usize>(run: &mut Simulation, line: &str) -> [Vector3<f64>; N] {
    let drawn = run.lines();
    let before: usize = drawn.iter().take_while(|drawn| drawn.name != line).map(|drawn| drawn.points).sum();
    let count = drawn.iter().find(|drawn| drawn.name == line).expect("a drawn line").points;
    let points = run.line_points();
    core::array::from_fn(|k| {
        let first = 3 * (before + count - 1 - k);
        Vector3::new(points[first], points[first + 1], points[first + 2])
    })
}

/// A section of a line.
pub fn section(length: f64, elements: usize, more: &str) -> String {
    format!(
        "        - {{unstretched_length_m: {length}, elements: {elements}, mass_kg_per_m: 30, axial_stiffness_N: 1.0e8, {more}}}\n"
    )
}

/// A line whose ends are given.
fn line(name: &str, ends: &str, sections: &str, more: &str) -> String {
    format!("  {name}:\n    line:\n{ends}{more}      sections:\n{sections}")
}

/// A top that moves to and fro at the origin, and these lines.
fn moved_top(integrator: &str, more: &str, lines: &str) -> String {
    format!(
        "version: 1
title: Lines below a moving top
simulation: {{step_s: 0.02, duration_s: 4, record_every_s: 0.1, integrator: {integrator}}}
{more}bodies:
  top:
    mass_kg: 10000
    shape: {{point: {{}}}}
    joint: {{prismatic: {{axis: [0.6, 0, 0.8], mode: {{oscillation: {{amplitude_m: 1, period_s: 3, ramp_s: 3}}}}}}}}
forces:
  gravity: {{gravity: {{}}}}
{lines}"
    )
}

const DRY: &str = "diameter_m: 1.0e-6";
/// Fields of a section in water.
pub const WET: &str = "diameter_m: 0.08, drag_along: 0.02, damping_time_s: 0.02";
const TOP: &str = "      first: {body: top}\n";
const ANCHOR: [f64; 3] = [80.0, 3.0, -60.0];

/// A line of two sections from the top to an anchor, with a clump weight between them: one line, or two that are joined there.
fn cut(integrator: &str, sea: &str, of: &str, is_cut: bool) -> String {
    let upper = section(50.0, 10, &format!("{of}, clump_weight: {{mass_kg: 500}}"));
    let lower = section(60.0, 7, of);
    let seabed = if sea.is_empty() { "" } else { "      seabed: {friction: 0.5}\n" };
    let anchor = format!("{{body: world, position_m: {ANCHOR:?}}}");
    let lines = if is_cut {
        line("upper", &format!("{TOP}      second_free: true\n"), &upper, seabed)
            + &line(
                "lower",
                &format!("      first: {anchor}\n      second_on: {{line: upper, section: 0}}\n"),
                &lower,
                seabed,
            )
    } else {
        line("upper", &format!("{TOP}      second: {anchor}\n"), &(upper + &lower), seabed)
    };
    moved_top(integrator, sea, &lines)
}

/// Tensions at top and anchor after a number of steps.
fn tensions_of_cut(text: &str, steps: usize) -> [f64; 2] {
    let mut run = simulation(text);
    run.step(steps).expect("it does not diverge");
    let top = of_line(&mut run, "line_tension", "upper");
    let is_cut = text.contains("second_on");
    let (variable, line) = if is_cut { ("line_tension", "lower") } else { ("line_end_tension", "upper") };
    [top, of_line(&mut run, variable, line)]
}

#[test]
fn a_line_cut_in_two_rests_and_moves_as_the_whole_line() {
    let exact = "dormand_prince, dormand_prince: {absolute_tolerance: 1.0e-9, relative_tolerance: 1.0e-9, largest_step_s: 0.02}";
    // At rest, in the implicit steps, and by the exact rates.
    for (integrator, steps) in [("rk4", 0), ("rk4", 150), (exact, 25)] {
        let [whole, parts] = [false, true].map(|is_cut| tensions_of_cut(&cut(integrator, "", DRY, is_cut), steps));
        for (whole, part) in whole.iter().zip(&parts) {
            // The iteration of a step ends within a 1e-6th of an element, and its next move is about the square of that.
            assert!((part / whole - 1.0).abs() < 1e-8, "{integrator} {steps}: {part} {whole}");
        }
    }
}

#[test]
fn a_line_cut_in_two_in_the_sea_moves_as_the_whole_line() {
    // Tangents at the joint are those of each line, at a node those between its neighbours: they differ with the second order.
    let sea = "sea: {depth_m: 60, current_m_s: [0.5, 0.1]}\n";
    for (steps, allowed) in [(0, 1e-4), (150, 1e-3)] {
        let [whole, parts] = [false, true].map(|is_cut| tensions_of_cut(&cut("rk4", sea, WET, is_cut), steps));
        for (whole, part) in whole.iter().zip(&parts) {
            assert!((part / whole - 1.0).abs() < allowed, "{steps}: {part} {whole}");
        }
    }
}

/// Ends of three taut lines about the origin, and their tensions with a clump weight of 2 t there, N.
const TAUT: [[f64; 3]; 3] = [[-20.0, 0.0, 15.0], [15.0, 12.0, 10.0], [4.0, -22.0, 6.0]];
const CLUMP_KG: f64 = 2000.0;
const EA: f64 = 1e6;

/// Unit vectors to the ends, distances, and the tensions that carry the clump weight.
fn taut() -> ([Vector3<f64>; 3], [f64; 3], Vector3<f64>) {
    let ends = TAUT.map(Vector3::from);
    let directions = ends.map(|end| end.normalize());
    let weight = Vector3::new(0.0, 0.0, CLUMP_KG * G);
    let tensions = Matrix3::from_columns(&directions).lu().solve(&weight).expect("three directions");
    (directions, ends.map(|end| end.norm()), tensions)
}

/// The three lines, so light that the clump weight alone counts: 1e-6 kg/m.
fn star() -> String {
    let (_, distances, tensions) = taut();
    let mut lines = String::new();
    for (k, name) in ["one", "two", "three"].iter().enumerate() {
        let first = format!("      first: {{body: world, position_m: {:?}}}\n", TAUT[k]);
        let second = if k == 0 { "      second_free: true\n" } else { "      second_on: {line: one, section: 0}\n" };
        let clump = if k == 0 { format!("clump_weight: {{mass_kg: {CLUMP_KG}}}, ") } else { String::new() };
        let length = distances[k] / (1.0 + tensions[k] / EA);
        let section = format!(
            "        - {{unstretched_length_m: {length}, elements: 2, mass_kg_per_m: 1.0e-6, diameter_m: 1.0e-6, damping_time_s: 0, {clump}axial_stiffness_N: {EA:?}}}\n"
        );
        lines += &line(name, &(first + second), &section, "");
    }
    moved_top("rk4", "", &lines)
}

#[test]
fn three_taut_lines_carry_a_clump_weight() {
    let mut run = simulation(&star());
    let (_, _, tensions) = taut();
    for (name, expected) in ["one", "two", "three"].iter().zip(tensions.iter()) {
        for variable in ["line_tension", "line_end_tension"] {
            let found = of_line(&mut run, variable, name);
            // The lines weigh a 1e-8th of the clump weight.
            assert!((found / expected - 1.0).abs() < 1e-7, "{variable} of {name}: {found} {expected}");
        }
    }
    let [joint] = from_second_end(&mut run, "three");
    assert!(joint.norm() < 1e-6, "{joint}");
}

#[test]
fn a_clump_weight_on_three_lines_swings_as_on_three_springs() {
    // K = sum EA / L t t' + T / d (1 - t t') on the mass.
    let (directions, distances, tensions) = taut();
    let stiffness = (0..3).fold(Matrix3::zeros(), |sum, k| {
        let along = directions[k] * directions[k].transpose();
        let length = distances[k] / (1.0 + tensions[k] / EA);
        sum + along * (EA / length) + (Matrix3::identity() - along) * (tensions[k] / distances[k])
    });
    let found = frequencies_of(&star());
    for square in (stiffness / CLUMP_KG).symmetric_eigen().eigenvalues.iter() {
        let off = error(&found, square.sqrt());
        // The lines have a 1e-8th of the mass; eigenvalues of waves in them are 1e4 times as large.
        assert!(off < 1e-6, "{off} at {} rad/s", square.sqrt());
    }
}

/// Two legs from a ship's bow and a chain on the seabed.
pub fn bridle(ship: &str, integrator: &str, more: &str) -> String {
    let on = "      second_on: {line: chain, section: 0}\n      seabed: {friction: 0.3}\n";
    let leg = |name: &str, y: f64| {
        let first = format!("      first: {{body: ship, position_m: [10, {y}, 0]}}\n{on}");
        line(name, &first, &section(40.0, 6, WET), "")
    };
    let ends = "      first: {body: world, position_m: [250, 0, -60]}\n      second_free: true\n";
    let chain = "        - {unstretched_length_m: 216, elements: 18, mass_kg_per_m: 100, axial_stiffness_N: 5.0e8, \
         clump_weight: {mass_kg: 3000}, diameter_m: 0.15, damping_time_s: 0.02}\n";
    format!(
        "version: 1
title: A bridle
simulation: {{step_s: 0.05, duration_s: 2, record_every_s: 0.5, integrator: {integrator}}}
sea: {{depth_m: 60}}
bodies: {{ship: {{mass_kg: 2.0e6, shape: {{box: {{length_m: 20, width_m: 10, height_m: 5}}}}, joint: {ship}}}}}
forces:
  gravity: {{gravity: {{enabled: true}}}}
{}{}{}{more}",
        leg("port", 5.0),
        line("chain", ends, chain, "      seabed: {friction: 0.3}\n"),
        leg("starboard", -5.0)
    )
}

/// A ship that does not move.
pub const FIXED: &str = "{fixed: {}}";

#[test]
fn a_symmetric_bridle_shares_the_tension_of_its_chain() {
    let mut run = simulation(&bridle(FIXED, "rk4", ""));
    let legs = ["port", "starboard"].map(|leg| of_line(&mut run, "line_end_tension", leg));
    // The search ends within a 1e-9th of the length of the lines.
    assert!((legs[0] / legs[1] - 1.0).abs() < 1e-6, "{legs:?}");
    let weight = |kg: f64, volume: f64| (kg - 1025.0 * volume) * G;
    let mut sum = Vector3::new(0.0, 0.0, -weight(3000.0, 0.0));
    for (name, tension) in [("port", legs[0]), ("starboard", legs[1])] {
        sum += away(&mut run, name) * tension;
    }
    let tension = of_line(&mut run, "line_end_tension", "chain");
    sum += away(&mut run, "chain") * tension;
    // Tensions at a joint are extrapolated in the elements, and the drawn points give their directions: both of second order. The
    // ends of the elements there have 0.5 kN of weight together.
    assert!(sum.norm() < 1e-3 * tension, "{sum} {tension}");
    let grounded = of_line(&mut run, "line_grounded_length", "chain");
    assert!(grounded > 20.0 && grounded < 200.0, "{grounded}");
}

/// The direction of a line away from its second end.
fn away(run: &mut Simulation, line: &str) -> Vector3<f64> {
    let [a, b, c] = from_second_end(run, line);
    ((b - a) * 4.0 - (c - a)).normalize()
}

const FLOATING: &str = "{floating: {hold_rotation: true, initial: {velocity_m_s: [-0.5, 0.3, 0]}}}";

/// Buoyancy of the ship, which carries the ship and the lines.
const AFLOAT: &str = "  tow: {spring_line: {first: {body: ship}, second: {body: world, position_m: [0, 0, 200]}, \
     unstretched_length_m: 150, axial_stiffness_N: 5.9e7}}\n";

#[test]
fn energy_closes_while_a_ship_moves_on_a_bridle() {
    let error = |steps: usize, integrator: &str| {
        let mut run = simulation(&bridle(FLOATING, integrator, AFLOAT));
        run.step(steps).expect("it does not diverge");
        let [error, scale] = ["energy_error", "energy_scale"].map(|name| values(&mut run, name)[0]);
        error.abs() / scale
    };
    // The implicit rule has discrete gradients: what is left is the work of Kutta's scheme on the ship.
    let coupled = error(80, "rk4");
    assert!(coupled < 1e-6, "{coupled}");
    let exact = "dormand_prince, dormand_prince: {absolute_tolerance: 1.0e-9, relative_tolerance: 1.0e-9, largest_step_s: 0.05}";
    let exact = error(8, exact);
    assert!(exact < 1e-7, "{exact}");
}

#[test]
fn a_tension_beyond_a_joint_has_the_derivative_of_its_differences() {
    let text = bridle(FLOATING, "rk4", AFLOAT);
    let name = "forces.chain.line.sections.0.unstretched_length_m";
    let scenario = read(&text, "bridle.yaml", &[]).expect("it reads");
    let found = gradient(&scenario, &[name], |_| true).expect("it has a derivative");
    let at = |length: f64| {
        let scenario = read(&text, "bridle.yaml", &[(name.to_owned(), json!(length))]).expect("it reads");
        let rows = Simulation::new(scenario.setup().expect("it builds")).run(|_| true).rows;
        rows[rows.len() - found.columns..].to_vec()
    };
    let (h, run) = (1e-3, Simulation::new(scenario.setup().expect("it builds")));
    let differences: Vec<f64> = at(216.0 + h).iter().zip(&at(216.0 - h)).map(|(a, b)| (a - b) / (2.0 * h)).collect();
    let derivatives = &found.derivatives[0][found.derivatives[0].len() - found.columns..];
    for channel in run.channels().iter().filter(|channel| channel.variable == "line_tension") {
        for k in channel.offset..channel.offset + channel.len {
            let (difference, derivative) = (differences[k], derivatives[k]);
            assert!(difference.abs() > 1e2, "{k}: no effect on a tension");
            // A step of 1 mm: second order in it, and the rounding of 1e5 N within the iteration's tolerance over it.
            assert!((difference - derivative).abs() < 1e-4 * derivative.abs(), "{k}: {difference} {derivative}");
        }
    }
}

#[test]
fn bridles_in_lanes_have_the_rows_of_single_runs() {
    let text = bridle(FLOATING, "rk4", AFLOAT);
    let variant = |length: f64| vec![("forces.port.line.sections.0.unstretched_length_m".to_owned(), json!(length))];
    let variants = [40.0, 40.5, 41.0, 39.5, 40.0].map(variant);
    let batch = batch::run(&text, "bridle.yaml", &Files::default(), &variants, 1, |_| true).expect("they run");
    for (run, variant) in batch.runs.iter().zip(&variants) {
        let alone = read(&text, "bridle.yaml", variant).and_then(|read| read.simulation());
        assert_eq!(run.rows, alone.expect("it builds").run(|_| true).rows);
    }
}

#[test]
fn a_snapshot_contains_branches() {
    let mut run = simulation(&bridle(FLOATING, "rk4", AFLOAT));
    run.step(17).expect("it does not diverge");
    let snapshot = run.snapshot();
    run.step(20).expect("it does not diverge");
    let expected = run.state().clone();
    run.reset();
    run.restore(&snapshot).expect("of the same scenario");
    run.step(20).expect("it does not diverge");
    assert_eq!(*run.state(), expected);
}

#[test]
fn slings_below_a_wire_that_is_paid_out_share_its_load() {
    // Three slings to corners of a load: the first is the last section of the wire, from a drum.
    let corner = |k: usize| [[1.0, 0.0], [-0.5, 0.75_f64.sqrt()], [-0.5, -(0.75_f64.sqrt())]][k].map(|x| 3.0 * x);
    let steel = "mass_kg_per_m: 20, diameter_m: 1.0e-6, axial_stiffness_N: 2.0e7, damping_time_s: 0.01";
    let sling = format!("        - {{unstretched_length_m: 5, elements: 2, {steel}}}\n");
    let wire = format!("        - {{unstretched_length_m: 50, elements: 4, {steel}}}\n{sling}");
    let path = format!(
        "      path: [{{drum: {{joint: winch, radius_m: 1}}}}, {{point: {{body: load, position_m: [{}, {}, 0]}}}}]\n",
        corner(0)[0],
        corner(0)[1]
    );
    let legs: String = [1, 2]
        .map(|k| {
            let [x, y] = corner(k);
            let ends = format!(
                "      first: {{body: load, position_m: [{x}, {y}, 0]}}\n      second_on: {{line: wire, section: 0}}\n"
            );
            line(&format!("sling_{k}"), &ends, &sling, "")
        })
        .concat();
    let text = format!(
        "version: 1
title: Slings
simulation: {{step_s: 0.02, duration_s: 10, record_every_s: 0.1}}
bodies:
  winch_drum:
    mass_kg: 100
    shape: {{point: {{}}}}
    joint: {{revolute: {{name: winch, axis: [0, 1, 0], mode: {{prescribed: {{rate_rad_s: 0.5, history: pulse, pulse: {{rise_s: 2, hold_s: 6}}}}}}}}}}
  load:
    mass_kg: 30000
    shape: {{box: {{length_m: 4, width_m: 4, height_m: 2}}}}
    joint: {{floating: {{initial: {{position_m: [0, 0, -54.79]}}}}}}
forces:
  gravity: {{gravity: {{}}}}
{}{legs}",
        line("wire", &path, &wire, "")
    );
    let mut run = simulation(&text);
    run.step(400).expect("it does not diverge");
    let slings = [("line_end_tension", "wire"), ("line_tension", "sling_1"), ("line_tension", "sling_2")]
        .map(|(variable, line)| of_line(&mut run, variable, line));
    let length = of_line(&mut run, "line_length", "wire");
    assert!(length > 55.5, "{length}");
    // They carry alike, and the load with the cosine 0.8 of slings of 5 m over 3 m; it swings by some degrees.
    for tension in slings {
        assert!((tension * 0.8 * 3.0 / (30e3 * G) - 1.0).abs() < 0.1, "{slings:?}");
    }
    let [error, scale] = ["energy_error", "energy_scale"].map(|name| values(&mut run, name)[0]);
    assert!(error.abs() < 1e-6 * scale, "{error} {scale}");
}

#[test]
fn a_disabled_branch_is_left_out() {
    let text = bridle(FIXED, "rk4", "").replacen("first: {body: ship", "enabled: false\n      first: {body: ship", 1);
    let run = simulation(&text);
    let channel = run.channels().iter().find(|channel| channel.variable == "line_tension").expect("lines").clone();
    assert_eq!(channel.labels[0], ["chain", "starboard"]);
}
