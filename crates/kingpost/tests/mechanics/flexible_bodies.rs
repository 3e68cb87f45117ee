//! Flexible bodies against the beams of Euler, Bernoulli and Timoshenko.

use crate::common;

use common::closed_forms::Cantilever;
use common::{simulation, values};
use kingpost::analysis::Linearizer;
use kingpost::scenario::read;
use kingpost::simulation::Simulation;
use nalgebra::{DMatrix, DVector};

/// Small enough for deflections to be proportional to loads, m/s^2.
const GRAVITY: f64 = 1e-4;
const LENGTH: f64 = 20.0;
const MASS: f64 = 500.0;
const E: f64 = 2.0e11;
const SECOND_MOMENT: f64 = 1e-5;

fn slender() -> Cantilever {
    Cantilever {
        length_m: LENGTH,
        bending_stiffness: E * SECOND_MOMENT,
        shear_stiffness: f64::INFINITY,
        mass_per_length: MASS / LENGTH,
    }
}

/// A slender bar that does not shear: its second moments are small beside the square of its area.
const SLENDER: &str = "{general: {area_m2: 0.01, second_moments_m4: [1.0e-5, 2.0e-5], torsion_constant_m4: 1.0e-5}}";

/// A beam clamped to the world at its start, in a weak gravity, with additional parts.
fn clamped(segments: u32, section: &str, more: &str) -> String {
    format!(
        "version: 1
title: a cantilever
bodies:
  beam:
    mass_kg: {MASS}
    flexible: {{segments: {segments}, youngs_modulus_Pa: {E:e}, length_m: {LENGTH}, section: {section}}}
    joint: {{fixed: {{child_position_m: [-10, 0, 0]}}}}
    points: {{tip: {{position_m: [10, 0, 0]}}}}
{more}
forces: {{gravity: {{gravity: {{acceleration_m_s2: {GRAVITY:e}}}}}}}
"
    )
}

/// A weight at a place of the beam, m from its start.
fn weight(place: f64, mass: f64) -> String {
    let x = place - LENGTH / 2.0;
    format!(
        "  load: {{parent: beam, mass_kg: {mass}, shape: {{point: {{}}}}, joint: {{fixed: {{position_m: [{x}, 0, 0]}}}}}}"
    )
}

/// The accelerations of the straight beam, and what each coordinate and each rate adds to them.
fn linear(text: &str) -> (Simulation, DVector<f64>, DMatrix<f64>, DMatrix<f64>) {
    let scenario = read(text, "test.yaml", &[]).expect("the scenario reads");
    let simulation = Simulation::new(scenario.setup().expect("the scenario builds"));
    let linear = Linearizer::new(&scenario).expect("it linearises").at(&simulation);
    let n = simulation.coordinates().len();
    let by_rate = linear.a.view((n, n), (n, n)).into_owned();
    (simulation, linear.accelerations(), linear.stiffness(), by_rate)
}

/// Returns the height of the tip with the beam at rest: all accelerations are zero.
fn tip_at_rest(text: &str) -> f64 {
    let (mut simulation, acceleration, by_position, _) = linear(text);
    let rest = by_position.lu().solve(&-acceleration).expect("a beam has a stiffness");
    let still = vec![0.0; rest.len()];
    simulation.set_state(rest.as_slice(), &still, None).expect("a motion of the beam");
    let tip = values(&mut simulation, "point_position");
    tip[2]
}

/// Angular frequencies of bending about y, rising.
fn frequencies(segments: u32) -> Vec<f64> {
    let (simulation, _, by_position, _) = linear(&clamped(segments, SLENDER, ""));
    let names = simulation.coordinates();
    let planar = |name: &String| name.ends_with("shear_z") || name.ends_with("bending_y");
    let places: Vec<usize> = (0..names.len()).filter(|&i| planar(&names[i])).collect();
    let block = DMatrix::from_fn(places.len(), places.len(), |i, j| -by_position[(places[i], places[j])]);
    let mut found: Vec<f64> = block.complex_eigenvalues().iter().map(|value| value.re.sqrt()).collect();
    found.sort_by(f64::total_cmp);
    found
}

#[test]
fn the_deflection_by_a_weight_at_the_tip_or_in_the_middle_of_a_segment_is_exact() {
    // The compliance about the middle of a piece is exact; rounding and the cube of the deflection
    // (1e-7 of the length, squared) are left. A weight at a: w(l) = F a^2 (3 l - a) / 6 E I.
    let exact = slender();
    for segments in [4, 8, 16] {
        let own = tip_at_rest(&clamped(segments, SLENDER, ""));
        for place in [LENGTH, LENGTH / 2.0] {
            let found = tip_at_rest(&clamped(segments, SLENDER, &weight(place, 300.0))) - own;
            let force = 300.0 * GRAVITY;
            let expected = force * place * place * (3.0 * LENGTH - place) / (6.0 * exact.bending_stiffness);
            assert!((-found / expected - 1.0).abs() < 1e-6, "{segments} segments, at {place} m: {found}, {expected}");
            if place == LENGTH {
                assert!((expected / exact.deflection_by_tip_force(force) - 1.0).abs() < 1e-12);
            }
        }
    }
}

#[test]
fn the_deflection_by_self_weight_is_that_of_euler_and_bernoulli() {
    let expected = slender().deflection_by_distributed_force(MASS / LENGTH * GRAVITY);
    let errors = [8, 16, 32].map(|n| 1.0 + tip_at_rest(&clamped(n, SLENDER, "")) / expected);
    assert!(errors[1].abs() < 0.005, "{errors:?}");
    // Weight is put at the middle of each segment: second order.
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((order - 2.0).abs() < 0.05, "order {order}: {errors:?}");
    }
}

#[test]
fn the_shear_deflection_of_a_short_tube_is_that_of_timoshenko() {
    // A round tube with the wall of a bar, 20 m long and 6 m across: shear adds a twentieth.
    let section = "{circular_tube: {outer_diameter_m: 6, wall_m: 0.1}}";
    let (outer, inner): (f64, f64) = (3.0, 2.9);
    let area = core::f64::consts::PI * (outer.powi(2) - inner.powi(2));
    let second_moment = core::f64::consts::PI / 4.0 * (outer.powi(4) - inner.powi(4));
    let shear_modulus = E / 2.6;
    // Cowper 1966: k of a thin round tube is 2 (1 + nu) / (4 + 3 nu), to a thousandth of this wall.
    let shear = |k: f64| Cantilever {
        bending_stiffness: E * second_moment,
        shear_stiffness: k * shear_modulus * area,
        ..slender()
    };
    let expected = shear(2.0 * 1.3 / 4.9).deflection_by_tip_force(300.0 * GRAVITY);
    let without = shear(f64::INFINITY).deflection_by_tip_force(300.0 * GRAVITY);
    assert!(expected > 1.05 * without);
    let own = tip_at_rest(&clamped(8, section, ""));
    let found = own - tip_at_rest(&clamped(8, section, &weight(LENGTH, 300.0)));
    assert!((found / expected - 1.0).abs() < 1e-4, "{found}, {expected}");
}

#[test]
fn the_first_frequencies_of_a_beam_are_those_of_euler_and_bernoulli() {
    let exact = [1, 2, 3].map(|mode| slender().frequency(mode));
    let errors = [8, 16, 32].map(|n| {
        let found = frequencies(n);
        [0, 1, 2].map(|i| found[i] / exact[i] - 1.0)
    });
    let at_16 = errors[1];
    assert!(at_16[0].abs() < 0.01 && at_16[1].abs() < 0.01, "{at_16:?}");
    // Rigid segments have too much inertia against turning, by the square of their length.
    for pair in errors.windows(2) {
        let order = (pair[0][2] / pair[1][2]).log2();
        assert!((order - 2.0).abs() < 0.1, "the third converges with order {order}: {errors:?}");
    }
}

#[test]
fn a_tube_twists_by_its_torsion_constant() {
    // The wave of torsion along a clamped round tube: (2 k - 1) pi / 2 sqrt(G / rho) / l.
    let section = "{circular_tube: {outer_diameter_m: 0.5, wall_m: 0.01}}";
    let (simulation, _, by_position, _) = linear(&clamped(16, section, ""));
    let names = simulation.coordinates();
    let places: Vec<usize> = (0..names.len()).filter(|&i| names[i].ends_with("torsion")).collect();
    let block = DMatrix::from_fn(16, 16, |i, j| -by_position[(places[i], places[j])]);
    let lowest = block.complex_eigenvalues().iter().fold(f64::INFINITY, |least, value| least.min(value.re)).sqrt();
    let area = core::f64::consts::PI * (0.25_f64.powi(2) - 0.24_f64.powi(2));
    let density = MASS / LENGTH / area;
    let expected = core::f64::consts::FRAC_PI_2 * (E / 2.6 / density).sqrt() / LENGTH;
    // Springs in the middles of n pieces: (pi / 4 n)^2 / 6 from the sine of half a wave number.
    assert!(
        (lowest / expected - 1.0).abs() < (core::f64::consts::PI / 64.0).powi(2) / 6.0 * 1.1,
        "{lowest}, {expected}"
    );
}

#[test]
fn damping_is_proportional_to_stiffness() {
    let with = |damping: &str| clamped(4, SLENDER, "").replace("section:", &format!("damping: {damping}, section:"));
    let (_, _, by_position, by_rate) = linear(&with("{stiffness_time: {time_s: 0.01}}"));
    assert!((&by_rate - &by_position * 0.01).amax() < 1e-12 * by_position.amax());
    // A ratio of 0.05 at 2 Hz is a time of 2 * 0.05 / (2 pi 2), s.
    let (_, _, by_position, by_rate) = linear(&with("{ratio: {ratio: 0.05, frequency_Hz: 2}}"));
    let time = 0.05 / (2.0 * core::f64::consts::PI);
    assert!((&by_rate - &by_position * time).amax() < 1e-12 * by_position.amax());
    let (_, _, _, undamped) = linear(&clamped(4, SLENDER, ""));
    assert_eq!(undamped.amax(), 0.0);
}

#[test]
fn a_load_on_a_flexible_body_hangs_on_the_segment_at_its_position() {
    let more = "  mast: {parent: beam, mass_kg: 10, shape: {point: {}}, joint: {revolute: {axis: [0, 1, 0], position_m: [2.4, 0, 0.5], child_position_m: [0, 0, -1]}}}";
    let mut simulation = simulation(&clamped(4, SLENDER, more));
    let names: Vec<&str> = simulation.model().bodies.iter().map(|body| body.name.as_str()).collect();
    assert_eq!(names, ["beam", "beam.1", "beam.2", "beam.3", "beam.4", "mast"]);
    // Segment 2 is from 7.5 to 12.5 m of the beam, and 12.4 m lies on it.
    assert_eq!(simulation.model().tree.nodes[5].parent, Some(2));
    let mast = simulation.poses()[5 * 7..][..3].to_vec();
    assert!((mast[0] - 12.4).abs() < 1e-12 && (mast[2] - 1.5).abs() < 1e-12, "{mast:?}");
    assert_eq!(values(&mut simulation, "point_position"), [20.0, 0.0, 0.0]);
}

#[test]
fn both_forms_of_the_equations_agree_on_a_slewing_boom() {
    let text = include_str!("../../../../scenarios/flexible_boom.yaml");
    let run = |form: &str| {
        let overrides =
            [("simulation.form".to_owned(), form.into()), ("bodies.boom.flexible.segments".to_owned(), 3.into())];
        let scenario = read(text, "flexible_boom.yaml", &overrides).expect("the gallery reads");
        let mut simulation = Simulation::new(scenario.setup().expect("the gallery builds"));
        simulation.step(200).expect("a twentieth of a second");
        simulation
    };
    let (recursive, moving_frame) = (run("recursive"), run("moving_frame"));
    // 200 steps of sums whose last digits differ.
    for (a, b) in recursive.state().q.iter().zip(&moving_frame.state().q) {
        assert!((a - b).abs() < 1e-11, "{a}, {b}");
    }
}

/// The error of a clamped beam with one text replaced.
#[track_caller]
fn refuses(old: &str, new: &str, error: &str) {
    let text = clamped(4, "{circular_tube: {outer_diameter_m: 0.5, wall_m: 0.01}}", "");
    assert!(text.contains(old), "no {old:?}");
    let found = read(&text.replacen(old, new, 1), "boom.yaml", &[]).map(drop).expect_err("this should be refused");
    let found = found.to_string();
    assert!(found.ends_with(error) && found.starts_with("boom.yaml:"), "{found}");
}

#[test]
fn an_invalid_beam_is_refused() {
    let segments = "bodies.beam.flexible.segments: found 0, allowed: a whole number from 1 to 64";
    refuses("segments: 4", "segments: 0", segments);
    refuses("segments: 4", "segments: 65", &segments.replace("found 0", "found 65"));
    refuses("segments: 4", "segments: 2.5", "found 2.5, allowed: a whole number not less than 0");
    let length = "bodies.beam.flexible.length_m: found 0, allowed: a number greater than 0";
    refuses("length_m: 20", "length_m: 0", length);
    let none = "bodies.beam.flexible.length_m: found nothing, \
                allowed: a length, or the shape of a box or of a cylinder along x";
    refuses("length_m: 20, ", "", none);
    let stiffness = "bodies.beam.flexible.youngs_modulus_Pa: found -5, allowed: a number greater than 0";
    refuses("youngs_modulus_Pa: 2e11", "youngs_modulus_Pa: -5", stiffness);
    let ratio = "poissons_ratio: found 0.6, allowed: a number greater than -1 and not greater than 0.5";
    refuses("segments: 4", "poissons_ratio: 0.6, segments: 4", ratio);
}

#[test]
fn an_invalid_section_is_refused() {
    let kinds = "found \"square_tube\", allowed: one of circular_tube, rectangular_tube, general";
    refuses("circular_tube:", "square_tube:", kinds);
    let wall = "section.circular_tube.wall_m: found 0.3, allowed: at most half of the outer diameter";
    refuses("wall_m: 0.01", "wall_m: 0.3", wall);
    let wall = "section.rectangular_tube.wall_m: found 0.2, allowed: less than half of width and height";
    let tube = "rectangular_tube: {width_m: 0.4, height_m: 1, wall_m: 0.2}";
    refuses("circular_tube: {outer_diameter_m: 0.5, wall_m: 0.01}", tube, wall);
}

#[test]
fn a_beam_with_unsupported_fields_is_refused() {
    let inertia =
        "bodies.beam.inertia: found an inertia of a flexible body, allowed: none: it follows from section and length";
    refuses("mass_kg: 500", "mass_kg: 500\n    inertia: {radii_of_gyration: {radii_m: [1, 1, 1]}}", inertia);
    let root = "joint.fixed.child_position_m.0: found 10, \
                allowed: -10 to -7.5: the joint of a flexible body is in its first segment";
    refuses("child_position_m: [-10, 0, 0]", "child_position_m: [10, 0, 0]", root);
    let floating =
        "bodies.beam.joint: found floating, allowed: a joint to another body or to the world, for a flexible body";
    refuses("fixed: {child_position_m: [-10, 0, 0]}", "floating: {}", floating);
    let damping = "forces: {damping: {viscous_damping: {body: beam, linear_N_s_m: [1, 1, 1]}}, ";
    refuses("forces: {", damping, "viscous_damping.body: found beam, allowed: a body that is not flexible");
}
