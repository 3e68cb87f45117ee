//! Loaded hulls at rest and heeled: closed forms, invariants, and hulls without an equilibrium.

use crate::common::hulls;

use core::f64::consts::{FRAC_PI_2, PI};
use hulls::{barge, box_barge, close, near, ship, sphere};
use kingpost::sea::hull::{FloatingEquilibrium, HullMesh, Loading, RightingArm, StabilityError, WettedHull};
use kingpost::spatial::Vector3;

const WATER: f64 = 1025.0;

fn loading(displaced_volume: f64, centre_of_gravity: [f64; 3]) -> Loading {
    Loading { mass: WATER * displaced_volume, centre_of_gravity: Vector3(centre_of_gravity), water_density: WATER }
}

fn arms(mesh: &HullMesh, loading: &Loading, heels: &[f64]) -> Vec<f64> {
    RightingArm::curve(mesh, loading, heels).unwrap().iter().map(|point| point.arm).collect()
}

#[test]
fn a_box_floats_at_the_draught_and_with_the_metacentres_of_its_closed_forms() {
    // Drawn from its keel, so that the origin is at depth.
    let mesh = barge(20.0, 10.0, 4.0, 0.0, 3);
    let equilibrium = FloatingEquilibrium::find(&mesh, &loading(300.0, [0.0, 0.0, 2.5])).unwrap();
    near(equilibrium.draught, 1.5, 1e-13);
    near(equilibrium.position.height, -1.5, 1e-13);
    near(equilibrium.heel.abs() + equilibrium.trim.abs(), 0.0, 1e-13);
    near(equilibrium.keel_to_buoyancy, 0.75, 1e-13);
    let [across, along] = equilibrium.metacentric_radius;
    close(across, 10.0 * 10.0 / (12.0 * 1.5), 1e-13);
    close(along, 20.0 * 20.0 / (12.0 * 1.5), 1e-13);
    let [across, along] = equilibrium.metacentric_height;
    close(across, 0.75 + 100.0 / 18.0 - 2.5, 1e-13);
    close(along, 0.75 + 400.0 / 18.0 - 2.5, 1e-13);
}

/// Wall-sided: `(GM + BM/2 tan^2) tan = d` for a weight at the distance d off the middle, in both directions.
#[test]
fn a_box_heels_to_the_side_and_trims_to_the_end_where_its_weight_is() {
    let (mesh, [gm, bm]) = (box_barge(2), [1.0 + 25.0 / 6.0 - 2.0, 25.0 / 6.0]);
    let off = |angle: f64, [gm, bm]: [f64; 2]| (gm + 0.5 * bm * libm::tan(angle) * libm::tan(angle)) * libm::tan(angle);
    let heel = 0.21;
    let to_starboard = FloatingEquilibrium::find(&mesh, &loading(400.0, [0.0, -off(heel, [gm, bm]), 0.0])).unwrap();
    near(to_starboard.heel, heel, 1e-12);
    near(to_starboard.trim, 0.0, 1e-12);
    let (trim, [gm, bm]) = (0.13, [1.0 + 50.0 / 3.0 - 2.0, 50.0 / 3.0]);
    let by_the_bow = FloatingEquilibrium::find(&mesh, &loading(400.0, [off(trim, [gm, bm]), 0.0, 0.0])).unwrap();
    near(by_the_bow.trim, trim, 1e-12);
    near(by_the_bow.heel, 0.0, 1e-12);
    near(by_the_bow.draught, 2.0 * libm::cos(trim) + 10.0 * libm::sin(trim), 1e-12);
}

/// With GM below 0 a wall-sided hull lolls to `tan^2 = -2 GM / BM`; held by symmetry it stays.
#[test]
fn a_top_heavy_box_has_an_angle_of_loll() {
    let (mesh, bm) = (box_barge(2), 25.0 / 6.0);
    let gm = -0.25;
    let height = -2.0 + 1.0 + bm - gm;
    let upright = FloatingEquilibrium::find(&mesh, &loading(400.0, [0.0, 0.0, height])).unwrap();
    near(upright.metacentric_height[0], gm, 1e-12);
    near(upright.heel, 0.0, 1e-9);
    let lolled = FloatingEquilibrium::find(&mesh, &loading(400.0, [0.0, -1e-9, height])).unwrap();
    near(lolled.heel, libm::atan(libm::sqrt(-2.0 * gm / bm)), 1e-8);
    assert!(lolled.metacentric_height[0] > 0.0);
}

/// `GZ = sin(heel) (GM + BM/2 tan^2(heel))` until deck and bilge meet the water at `tan = 0.4`
/// (Barrass & Derrett, *Ship Stability for Masters and Mates*, ch. on wall-sided ships).
#[test]
fn the_righting_arm_of_a_box_follows_the_wall_sided_formula_to_21_8_degrees() {
    let (mesh, bm) = (box_barge(3), 25.0 / 6.0);
    let heels: Vec<f64> = (-21..=21).map(|k| libm::atan(0.4) * f64::from(k) / 21.0).collect();
    let loading = loading(400.0, [0.0, 0.0, 0.5]);
    for (&heel, arm) in heels.iter().zip(arms(&mesh, &loading, &heels)) {
        let tan = libm::tan(heel);
        near(arm, libm::sin(heel) * (1.0 + bm - 2.5 + 0.5 * bm * tan * tan), 1e-12);
    }
}

/// The box's section cut by a water line at this depth under its middle: area and first moments,
/// as sums over strips of the section. Exact but where the outline bends within a strip.
fn section(heel: f64, rise: f64, strips: usize) -> [f64; 3] {
    let (sin, cos) = libm::sincos(heel);
    let width = 10.0 / strips as f64;
    (0..strips).fold([0.0; 3], |[area, across, up], k| {
        let y = -5.0 + (k as f64 + 0.5) * width;
        // Heights are z0 + y sin + z cos; the section reaches from z = -2 to 2.
        let top = (-(rise + y * sin) / cos).clamp(-2.0, 2.0);
        let wet = (top + 2.0) * width;
        [area + wet, across + wet * y, up + wet * 0.5 * (top - 2.0)]
    })
}

#[test]
fn beyond_21_8_degrees_the_righting_arm_of_a_box_agrees_with_an_integration_of_its_section() {
    let heels = [0.5, 0.8, 1.1, 1.4];
    let loading = loading(400.0, [0.0, 0.3, 0.5]);
    let curve = RightingArm::curve(&box_barge(2), &loading, &heels).unwrap();
    let strips = 20_000;
    for point in curve {
        let [area, across, up] = section(point.heel, point.position.height, strips);
        // Midpoints err by the width of a strip squared, once for every bend.
        close(area, 20.0, 1e-6);
        let (sin, cos) = libm::sincos(point.heel);
        near(point.arm, (0.3 - across / area) * cos + (up / area - 0.5) * sin, 1e-6);
        near(point.trim, 0.0, 1e-12);
    }
    // On its side it is a box of 4 m beam at 5 m draught.
    let on_its_side = arms(&box_barge(2), &loading, &[FRAC_PI_2, PI]);
    near(on_its_side[0], -0.5, 1e-12);
    near(on_its_side[1], -0.3, 1e-12);
}

#[test]
fn a_heeled_ship_keeps_its_displacement_and_is_free_to_trim() {
    let mesh = ship(30.0, 9.0, 6.0, 6);
    let loading = loading(0.45 * mesh.volume(), [-2.0, 0.0, 2.6]);
    let heels: Vec<f64> = (0..=14).map(|k| 0.1 * f64::from(k)).collect();
    let curve = RightingArm::curve(&mesh, &loading, &heels).unwrap();
    let mut wetted = WettedHull::new(&mesh);
    for point in &curve {
        let buoyancy = wetted.buoyancy(&mesh, &point.position);
        close(buoyancy.volume, 0.45 * mesh.volume(), 1e-13);
        let n = point.position.vertical;
        near(libm::atan2(n[1], n[2]), point.heel, 1e-13);
        near(libm::asin(-n[0]), point.trim, 1e-13);
        // The couple of weight and buoyancy is about the ship's horizontal axis alone.
        let couple = (buoyancy.centre() - loading.centre_of_gravity).cross(n);
        let ahead = (Vector3::new(1.0, 0.0, 0.0) - n * n[0]).direction();
        near(couple.dot(n.cross(ahead)), 0.0, 1e-11);
        near(couple.dot(ahead), -point.arm, 1e-13);
    }
    let trims = (curve[0].trim, curve[14].trim);
    assert!((trims.0 - trims.1).abs() > 0.02, "its bow is finer: it trims as it heels, {trims:?}");
}

/// Righting arms are the slope of the energy at constant displacement, `z0 + n.c - H/V`, the trim
/// at its minimum. Central differences over h err by h^2.
#[test]
fn the_righting_arm_is_the_slope_of_the_energy() {
    let (mesh, h) = (ship(30.0, 9.0, 6.0, 4), 1e-4);
    let loading = loading(0.5 * mesh.volume(), [-1.0, 0.2, 2.2]);
    let mut wetted = WettedHull::new(&mesh);
    for heel in [-0.6, 0.05, 0.4, 0.9, 1.3] {
        let curve = RightingArm::curve(&mesh, &loading, &[heel - h, heel, heel + h]).unwrap();
        let energy = [0, 2].map(|k| {
            let position = curve[k].position;
            let buoyancy = wetted.buoyancy(&mesh, &position);
            let raised = position.vertical.dot(loading.centre_of_gravity);
            position.height + raised - buoyancy.height_moment / buoyancy.volume
        });
        near((energy[1] - energy[0]) / (2.0 * h), curve[1].arm * libm::cos(curve[1].trim), 1e-6);
    }
}

#[test]
fn a_ship_floats_where_its_righting_arm_is_zero_and_its_slope_is_the_metacentric_height() {
    let mesh = ship(30.0, 9.0, 6.0, 5);
    let loading = loading(0.4 * mesh.volume(), [-1.5, 0.0, 2.4]);
    let equilibrium = FloatingEquilibrium::find(&mesh, &loading).unwrap();
    near(equilibrium.heel, 0.0, 1e-12);
    let h = 1e-4;
    let arms = arms(&mesh, &loading, &[-h, 0.0, h]);
    near(arms[1], 0.0, 1e-12);
    near((arms[2] - arms[0]) / (2.0 * h), equilibrium.metacentric_height[0] * libm::cos(equilibrium.trim), 1e-6);
    let off = Loading { centre_of_gravity: Vector3::new(-1.5, -0.4, 2.4), ..loading };
    let heeled = FloatingEquilibrium::find(&mesh, &off).unwrap();
    assert!(heeled.heel > 0.05, "a weight to starboard heels to starboard");
    let there = RightingArm::curve(&mesh, &off, &[heeled.heel]).unwrap()[0];
    near(there.arm, 0.0, 1e-12);
    near(there.trim, heeled.trim, 1e-12);
}

/// A ball balances in every position; one of flat triangles, whose sides differ slightly, rolls to the
/// position of least energy.
#[test]
fn a_ball_of_triangles_rolls_until_it_rests() {
    let equilibrium = FloatingEquilibrium::find(&sphere(5.0, 4), &loading(200.0, [0.0; 3])).unwrap();
    let [across, along] = equilibrium.metacentric_height;
    assert!(across > 0.0 && along > 0.0 && across + along < 0.1, "{across} {along}");
    let centre = equilibrium.buoyancy.centre();
    near(centre.cross(equilibrium.position.vertical).norm(), 0.0, 1e-12);
}

#[test]
fn the_error_of_a_hull_that_cannot_float_contains_the_excess() {
    let mesh = box_barge(1);
    let error = FloatingEquilibrium::find(&mesh, &loading(900.0, [0.0; 3])).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the hull cannot float: 922.500 t displace 900.000 m3 of water, allowed: less than the 800.000 m3 of the whole hull"
    );
    assert!(matches!(
        RightingArm::curve(&mesh, &loading(800.001, [0.0; 3]), &[0.1]),
        Err(StabilityError::CannotFloat { .. })
    ));
    // Just afloat, with a hand of freeboard.
    let low = FloatingEquilibrium::find(&mesh, &loading(799.9999, [0.0, 0.0, -0.5])).unwrap();
    near(low.draught, 4.0 - 5e-7, 1e-12);
}

#[test]
fn an_invalid_loading_is_an_error() {
    let mesh = box_barge(1);
    let good = loading(400.0, [0.0; 3]);
    let cases = [
        Loading { mass: 0.0, ..good },
        Loading { mass: f64::NAN, ..good },
        Loading { water_density: -1.0, ..good },
        Loading { centre_of_gravity: Vector3::new(0.0, f64::INFINITY, 0.0), ..good },
    ];
    for case in cases {
        let error = FloatingEquilibrium::find(&mesh, &case).unwrap_err();
        assert!(matches!(error, StabilityError::Loading { .. }), "{error}");
    }
    let error = RightingArm::curve(&mesh, &good, &[f64::NAN]).unwrap_err();
    assert_eq!(error.to_string(), "the heel is NaN, allowed: a finite number");
}
