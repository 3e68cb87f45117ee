//! Flat ends and sides of cylinders and cones on boxes, against statics and rigid bodies.

use super::contacts::{G, energy_error};
use crate::common;

use common::{simulation, values};
use kingpost::simulation::Simulation;

/// Stiffness of a contact point, N/m.
const K: f64 = 1e7;
/// Radius of the cylinder, m; its mass is 1 t.
const R: f64 = 0.5;
/// Its height, m.
const H: f64 = 1.2;
/// Radius of the circle on which a standing cylinder has its contact points: the rim has a chamfer of 0.5 %.
const FOOT: f64 = 0.995 * R;

/// A cylinder of 1 t on a joint, over a long box in the world with its top at the origin.
fn over_a_box(joint: &str, body: &str, surface: &str, friction: f64) -> String {
    format!(
        "version: 1
title: A cylinder on a box
simulation: {{integrator: rk4, step_s: 0.0005, duration_s: 60}}
bodies:
  load: {{mass_kg: 1000, shape: {{cylinder: {{radius_m: {R}, length_m: {H}, axis: z}}}}{body}, joint: {joint}}}
forces:
  gravity: {{gravity: {{}}}}
  contact:
    contact:
      load: {{body: load, shape: {{cylinder: {{radius_m: {R}, length_m: {H}, axis: z}}}}}}
      surface: {{body: world, {surface}}}
      stiffness_N_per_m: {K}
      friction_coefficient: {friction}
"
    )
}

const BOX: &str = "position_m: [0, 0, -0.5], shape: {box: {length_m: 20, width_m: 8, height_m: 1}}";

fn floating(initial: &str) -> String {
    format!("{{floating: {{initial: {{{initial}}}}}}}")
}

fn at_rest(text: &str) -> Simulation {
    simulation(&text.replace("duration_s: 60", "duration_s: 60, begin_at_equilibrium: true"))
}

/// W / 8 k deep.
#[test]
fn a_standing_cylinder_carries_its_weight_on_eight_points_of_its_rim() {
    let joint = floating("position_m: [0.3, -0.2, 0.6001]");
    let mut run = at_rest(&over_a_box(&joint, "", BOX, 0.4));
    assert_eq!(values(&mut run, "contact_points"), [8.0]);
    let [force, depth] = ["contact_normal_force", "contact_penetration"].map(|name| values(&mut run, name)[0]);
    assert!((force / (1000.0 * G) - 1.0).abs() < 1e-6, "{force}");
    assert!((depth / (1000.0 * G / (8.0 * K)) - 1.0).abs() < 1e-6, "{depth}");
}

/// The centre of mass is e beside the axis: W (e + t H / 2) = S t at the tilt t. S is that of eight springs, k Sum (r cos)^2 = 4 k
/// r^2, and of the crown: an arc of half angle a has its lowest point where it is r a t^2 sin^2 / 4e-3 deeper, which
/// adds W r a / 4e-3.
#[test]
fn a_standing_cylinder_rights_itself_by_the_stiffness_of_its_rim() {
    let body = ", inertia: {tensor: {moments_kg_m2: [200, 200, 120]}}, centre_of_mass_m: [0.001, 0, 0]";
    let joint = floating("drawing_frame_m: [0, 0, 0.6001]");
    let mut run = at_rest(&over_a_box(&joint, body, BOX, 0.4));
    let tilt = values(&mut run, "contact_tilt")[0];
    let weight = 1000.0 * G;
    let crown = weight * FOOT * std::f64::consts::PI / 8.0 / 4e-3;
    let by_hand = weight * 0.001 / (4.0 * K * FOOT * FOOT + crown - weight * 0.5 * H);
    assert!((tilt / by_hand - 1.0).abs() < 1e-3, "{tilt} {by_hand}");
}

/// A rigid cylinder falls back from a lean below atan(r / h), h = H / 2, and over beyond it.
#[test]
fn a_leaning_cylinder_tips_beyond_the_angle_of_its_rim() {
    let critical = (FOOT / (0.5 * H)).atan();
    for axis in 0..3 {
        // About y, about an axis between two contact points, about x.
        let heading = f64::from(axis) * std::f64::consts::PI / 8.0;
        for (share, falls) in [(0.99, false), (1.01, true)] {
            let lean = share * critical;
            let height = 0.5 * H * lean.cos() + FOOT * lean.sin();
            let joint = floating(&format!("orientation_rad: [0, {lean}, {heading}], position_m: [0, 0, {height}]"));
            let mut run = simulation(&over_a_box(&joint, "", BOX, 0.8));
            run.step(800).expect("it tips");
            let tilt = values(&mut run, "contact_tilt")[0];
            assert_eq!(tilt > lean, falls, "{heading} {share}: {tilt} {lean}");
        }
    }
}

/// A solid cylinder rolls down a slope a at 2/3 g sin a, also where the slope is so small that a bump of 0.1 mm on
/// its way would hold it.
#[test]
fn a_lying_cylinder_rolls_evenly_down_a_slope() {
    for degrees in [0.02_f64, 3.0] {
        let (sin, cos) = degrees.to_radians().sin_cos();
        // A depth W cos a / 2 k under the top of the box, whose middle is 0.5 m below it.
        let above = R - 1000.0 * G * cos / (2.0 * K);
        let place = [(-5.0, 0.0, above)].map(|(x, y, z)| [x * cos + z * sin, y, -x * sin + z * cos])[0];
        let joint = floating(&format!("orientation_deg: [90, 0, 0], position_m: {place:?}"));
        let surface = format!(
            "orientation_deg: [0, {degrees}, 0], position_m: [{}, 0, {}], shape: {{box: {{length_m: 20, width_m: 8, height_m: 1}}}}",
            -0.5 * sin,
            -0.5 * cos
        );
        let mut run = simulation(&over_a_box(&joint, "", &surface, 0.4));
        run.step(4000).expect("it rolls");
        let q = &run.state().q;
        let moved = (q[0] - place[0]).hypot(q[2] - place[2]);
        let by_hand = 0.5 * (2.0 / 3.0) * G * sin * 4.0;
        assert!((moved / by_hand - 1.0).abs() < 1e-3, "{degrees}: {moved} {by_hand}");
        assert_eq!(values(&mut run, "contact_points"), [2.0]);
        assert!(energy_error(&mut run, 1000.0 * G * R) < 1e-6, "{}", energy_error(&mut run, 1000.0 * G * R));
    }
}

/// A third of it is beyond the edge: it rests on the edge and on the rim inside.
#[test]
fn a_cylinder_that_lies_over_an_edge_rests_on_it() {
    let joint = floating("orientation_deg: [0, 90, 0], position_m: [9.8, 0, 0.4999]");
    let mut run = at_rest(&over_a_box(&joint, "", BOX, 0.4));
    assert!((values(&mut run, "contact_force")[2] / (1000.0 * G) - 1.0).abs() < 1e-6);
    // The inner rim is 0.6 m from the centre, the edge 0.2 m: they carry a quarter and three quarters of the weight.
    let depth = values(&mut run, "contact_penetration")[0];
    assert!((depth / (0.75 * 1000.0 * G / K) - 1.0).abs() < 0.01, "{depth}");
}

/// Upright with its centre just inside or just beyond the edge of the box.
#[test]
fn a_standing_cylinder_tips_over_the_edge_of_its_box() {
    for (beyond, falls) in [(-0.05, false), (0.05, true)] {
        let joint = floating(&format!("position_m: [{}, 0, 0.5999]", 10.0 + beyond));
        let mut run = simulation(&over_a_box(&joint, "", BOX, 0.5));
        run.step(2000).expect("it stands or tips");
        let tilt = values(&mut run, "contact_tilt")[0];
        assert_eq!(tilt > 0.1, falls, "{beyond}: {tilt}");
    }
}

#[test]
fn a_cylinder_dropped_on_its_rim_comes_to_rest_with_its_energy_accounted_for() {
    let joint = floating("orientation_deg: [25, 35, 10], position_m: [0, 0, 1.2]");
    let mut run = simulation(&over_a_box(&joint, "", BOX, 0.4).replace("step_s: 0.0005", "step_s: 0.0002"));
    run.step(15_000).expect("it falls");
    assert!(energy_error(&mut run, 1000.0 * G) < 1e-4, "{}", energy_error(&mut run, 1000.0 * G));
    assert!((values(&mut run, "contact_force")[2] / (1000.0 * G) - 1.0).abs() < 0.2);
}

/// On its tip, held upright, a cone stands on one point, on its base on eight; on a plane as on a box and on the flat
/// end of a cylinder.
#[test]
fn a_cone_stands_on_its_tip_or_on_its_base() {
    let cone = "shape: {cone: {half_angle_deg: 30, length_m: 1}}";
    let surfaces = [
        "shape: {plane: {}}",
        "position_m: [0, 0, -0.5], shape: {box: {length_m: 4, width_m: 4, height_m: 1}}",
        "position_m: [0, 0, -2], shape: {cylinder: {radius_m: 1, length_m: 4, axis: z}}",
    ];
    for surface in surfaces {
        for (turned, height, points) in [("orientation_deg: [180, 0, 0], ", 0.0, 1.0), ("", 1.0, 8.0)] {
            let joint =
                format!("{{prismatic: {{name: heave, axis: [0, 0, 1], position_m: [0, 0, {}]}}}}", height - 1e-4);
            let text = over_a_box(&joint, "", surface, 0.0);
            let own = format!("load: {{body: load, shape: {{cylinder: {{radius_m: {R}, length_m: {H}, axis: z}}}}}}");
            let text = text.replace(&own, &format!("load: {{body: load, {turned}{cone}}}"));
            let mut run = at_rest(&text);
            assert_eq!(values(&mut run, "contact_points"), [points], "{surface}");
            let depth = values(&mut run, "contact_penetration")[0];
            assert!((depth / (1000.0 * G / (points * K)) - 1.0).abs() < 1e-6, "{surface}: {depth}");
        }
    }
}
