//! Slack tanks in scenarios: metacentric height, heel, righting arms, energy, derivatives, invalid input.

use crate::common;

use common::barge::{BEAM, DENSITY, DEPTH, GRAVITY, LENGTH, files, scenario};
use common::{assert_linearised, simulation, values};
use kingpost::Simulation;
use kingpost::batch::{self, Variant};
use kingpost::hydrostatics::HullAfloat;
use kingpost::scenario::{Files, read, read_with};
use serde_json::{Value, json};

const MAST: &str = "bodies.mast.joint.prismatic.position_m";
const HYDROSTATICS: &str = "forces.water.hydrodynamics.hydrostatics";
/// Mass of hull, mast and load, kg, and the moment of the mast and the load for each metre that they go to port,
/// kg m/m.
const MASS: f64 = 410e3;
const MOVED: f64 = 30e3;
/// Length, breadth, height of the tank, m, and its liquid, kg/m^3.
const TANK: [f64; 3] = [8.0, 9.0, 3.0];
const OIL: f64 = 900.0;

fn tank(filling: f64, more: Value) -> Value {
    let [length, breadth, height] = TANK;
    let mut tank = json!({"body": "hull", "position_m": [-3.0, 0.0, 2.0], "length_m": length, "breadth_m": breadth,
                          "height_m": height, "filling": filling, "density_kg_m3": OIL});
    more.as_object().expect("fields").iter().for_each(|(name, value)| tank[name] = value.clone());
    json!({ "slack_tank": tank })
}

fn barge_with<'a>(tank: Value, more: &[(&'a str, Value)]) -> Vec<(&'a str, Value)> {
    let given = [(MAST, json!([0.0, 0.0, 7.0])), (HYDROSTATICS, json!("mesh")), ("forces.tank", tank)];
    given.into_iter().chain(more.iter().cloned()).collect()
}

fn afloat(overrides: &[(&str, Value)]) -> HullAfloat {
    let mut report = scenario(overrides).hydrostatic_report().expect("it floats");
    report.hulls.remove(0)
}

fn near(found: f64, expected: f64, allowed: f64) {
    assert!((found - expected).abs() <= allowed, "{found}, expected {expected} within {allowed:e}");
}

/// `rho l b^3 / (12 M)` across and `rho b l^3 / (12 M)` along.
fn corrections(density: f64) -> [f64; 2] {
    let [length, breadth, _] = TANK;
    [length * breadth.powi(3), breadth * length.powi(3)].map(|moment| density * moment / (12.0 * MASS))
}

/// GM falls by `rho i / M`, for any position and filling of the tank (Barrass & Derrett, *Ship Stability for
/// Masters and Mates*, ch. on free surface). Settling leaves 1e-9 of each.
#[test]
fn a_free_surface_reduces_the_metacentric_height_by_its_second_moment_over_the_displacement() {
    let without = afloat(&barge_with(tank(0.5, json!({"enabled": false})), &[]));
    assert!(without.free_surfaces.is_empty());
    for (filling, more, density) in [
        (0.5, json!({}), OIL),
        (0.2, json!({"position_m": [4.0, 1.0, 3.0]}), OIL),
        (0.5, json!({"density_kg_m3": null}), DENSITY),
    ] {
        let hull = afloat(&barge_with(tank(filling, more), &[]));
        let surface = &hull.free_surfaces[0];
        assert_eq!((hull.free_surfaces.len(), surface.force.as_str(), surface.body.as_str()), (1, "tank", "hull"));
        near(surface.liquid_kg, density * TANK.iter().product::<f64>() * filling, 1e-6);
        for (k, off) in corrections(density).into_iter().enumerate() {
            near(surface.correction_m[k], off, 1e-8);
            near(without.metacentric_height_m[k] - hull.metacentric_height_m[k], off, 1e-8);
            near(hull.fluid_keel_to_gravity_m[k] - without.fluid_keel_to_gravity_m[k], off, 1e-8);
            near(hull.solid_metacentric_height_m[k], without.solid_metacentric_height_m[k], 1e-8);
        }
        near(hull.keel_to_gravity_m, without.keel_to_gravity_m, 1e-8);
    }
}

#[test]
fn the_height_of_the_liquid_is_that_of_its_share_of_the_tank() {
    let hull = afloat(&barge_with(tank(0.4, json!({})), &[]));
    near(hull.free_surfaces[0].keel_to_liquid_m, 2.0 - 1.5 + 0.2 * 3.0, 1e-9);
}

/// Tank and barge wall-sided: `(GM + (BM - i) tan^2 / 2) tan = d`, GM less the free surface's i = rho I / M, d the
/// moment over the weight. Nothing meets an edge before 18 degrees.
fn heel(shift: f64, free_surface: f64) -> f64 {
    let draught = MASS / (DENSITY * LENGTH * BEAM);
    let bm = BEAM * BEAM / (12.0 * draught);
    let keel_to_gravity = (380e3 * 2.0 + 20e3 * 7.0 + 10e3 * 9.0) / MASS;
    let gm = 0.5 * draught + bm - keel_to_gravity - free_surface;
    let mut tan = 0.0;
    for _ in 0..50 {
        let excess = (gm + 0.5 * (bm - free_surface) * tan * tan) * tan - MOVED * shift / MASS;
        tan -= excess / (gm + 1.5 * (bm - free_surface) * tan * tan);
    }
    libm::atan(tan)
}

#[test]
fn the_heel_of_a_ship_with_a_slack_tank_by_a_load_moved_athwartships_is_the_static_heel() {
    let shift = 2.0;
    let begin = [("shift_m", json!(shift)), ("simulation.begin_at_equilibrium", Value::Bool(true))];
    for (enabled, free_surface) in [(true, corrections(OIL)[0]), (false, 0.0)] {
        let built = scenario(&barge_with(tank(0.5, json!({"enabled": enabled})), &begin));
        let roll = values(&mut Simulation::new(built.setup().expect("it builds")), "roll")[0];
        // Mast to port: the starboard side comes up. The trim of the rounding is none.
        let expected = heel(shift, free_surface);
        assert!((-roll / expected - 1.0).abs() < 1e-8, "{roll} {expected}");
        assert!(libm::tan(expected) < 1.5 / 4.5 && libm::tan(expected) < (DEPTH - 2.0) / (0.5 * BEAM));
    }
    assert!(heel(shift, corrections(OIL)[0]) > 1.2 * heel(shift, 0.0));
}

/// `GZ = sin (GM + (BM - i) tan^2 / 2)` until the tank's surface meets its top, at tan = 3 / 9.
#[test]
fn the_righting_arms_include_level_liquid_at_each_heel() {
    let hull = afloat(&barge_with(tank(0.5, json!({})), &[]));
    let [gm, bm, off] = [hull.metacentric_height_m[0], hull.metacentric_radius_m[0], corrections(OIL)[0]];
    let points = hull.righting_arm.expect("a mesh").points;
    for point in points.iter().filter(|point| libm::tan(point.heel_rad) < 1.0 / 3.0) {
        let tan = libm::tan(point.heel_rad);
        near(point.arm_m, libm::sin(point.heel_rad) * (gm + 0.5 * (bm - off) * tan * tan), 1e-8);
    }
    // Beyond, the liquid has less room to go than between walls.
    let last = points.last().expect("60 degrees");
    let solid = afloat(&barge_with(tank(0.5, json!({"enabled": false})), &[])).righting_arm.expect("a mesh");
    let difference = solid.points.last().expect("60 degrees").arm_m - last.arm_m;
    assert!(difference > 0.0 && difference < libm::sin(last.heel_rad) * (off + 0.5 * off * 3.0), "{difference}");
}

/// Two ways to one heel: the forces of a ship at rest, and where its curve passes through zero; the tank's surface
/// there meets the top, of another that is turned in the ship the bottom.
#[test]
fn a_ship_rests_where_its_righting_arm_with_tanks_is_zero() {
    let shift = ("shift_m", json!(4.0));
    let turned = json!({"parent": "hull", "mass_t": 40, "shape": {"box": {"length_m": 9, "width_m": 3, "height_m": 3}},
        "joint": {"fixed": {"position_m": [6, 1, 2], "orientation_rad": [0.1, 0, 1.2]}}});
    let in_turned = tank(0.15, json!({"body": "module", "position_m": [0, 0, 0], "breadth_m": 3.0, "length_m": 8.0}));
    let more = [shift, ("bodies.module", turned), ("bodies.hull.mass_t", json!(340)), ("forces.second", in_turned)];
    let hull = afloat(&barge_with(tank(0.8, json!({})), &more));
    assert_eq!(hull.free_surfaces.len(), 2);
    assert!(libm::tan(-hull.heel_rad) > 0.2 * 3.0 / 4.5, "its surface meets the top: {}", hull.heel_rad);
    let found = hull.righting_arm.as_ref().and_then(|curve| curve.equilibrium_rad).expect("it rests");
    near(found, -hull.heel_rad, 1e-8);
}

/// `W GM dphi = w cos(phi) dy`: about a list at which the surface meets the top as about upright. Differences over
/// 1 cm err by its square.
#[test]
fn the_heel_by_a_small_moment_follows_gm_reduced_by_the_present_free_surface() {
    for (filling, shift) in [(0.5, 0.0), (0.8, 4.0)] {
        let at = |shift: f64| afloat(&barge_with(tank(filling, json!({})), &[("shift_m", json!(shift))]));
        let (hull, step) = (at(shift), 0.01);
        let rate = (at(shift + step).heel_rad - at(shift - step).heel_rad) / (2.0 * step);
        let expected = -MOVED * libm::cos(hull.heel_rad) / (MASS * hull.metacentric_height_m[0]);
        assert!((rate / expected - 1.0).abs() < 1e-5, "{rate} {expected}");
    }
}

/// Liquid in a hanging load does not heel with the ship.
#[test]
fn a_tank_on_a_mast_reduces_the_metacentric_height_and_one_in_a_hanging_load_does_not() {
    let on = |body: &str| {
        let small = json!({"body": body, "length_m": 2.0, "breadth_m": 2.0, "height_m": 1.0});
        let hull = afloat(&barge_with(tank(0.5, small), &[]));
        hull.solid_metacentric_height_m[0] - hull.metacentric_height_m[0]
    };
    let hanging = 10e3 * 1.5 / MASS;
    near(on("load"), hanging, 1e-8);
    near(on("mast"), hanging + OIL * 16.0 / (12.0 * MASS), 1e-8);
}

/// A body on a hinge along y, with its centre of mass on the hinge: only the tank exerts a moment.
fn hinged(fields: &str, angle: f64) -> String {
    format!(
        "version: 1\ntitle: A tank on a hinge\nsimulation: {{step_s: 0.01, duration_s: 20}}\nbodies:\n  drum:\n    \
         mass_t: 100\n    inertia: {{tensor: {{moments_kg_m2: [500000, 400000, 600000]}}}}\n    \
         joint: {{revolute: {{axis: [0, 1, 0], initial_angle_rad: {angle}}}}}\nforces:\n  gravity: {{gravity: {{}}}}\n  \
         tank: {{slack_tank: {{body: drum, position_m: [3, 1, 0], length_m: 6, breadth_m: 4, height_m: 2, {fields}}}}}\n"
    )
}

/// Between walls the moment is `rho g I tan (1 + tan^2 / 2) cos`, I = b l^3 / 12: with n = (-sin, 0, cos),
/// `n x V (c - c0)` of the shift (I tan, 0, I tan^2 / 2). The density is that of the sea where none is given.
#[test]
fn a_tank_on_any_body_turns_it_by_the_moment_of_its_liquid() {
    for angle in [0.2_f64, -0.1, 0.3] {
        let mut moving = simulation(&hinged("filling: 0.5", angle));
        let (sin, cos) = libm::sincos(angle);
        let tan = sin / cos;
        let moment = 1025.0 * GRAVITY * 4.0 * 216.0 / 12.0 * (tan * cos + 0.5 * tan * tan * sin);
        let acceleration = moving.acceleration(None).expect("no forces beside its own")[0];
        assert!((acceleration * 400e3 / moment - 1.0).abs() < 1e-12, "{acceleration}");
    }
}

#[test]
fn a_full_an_empty_and_a_disabled_tank_do_nothing() {
    for fields in ["filling: 0", "filling: 1", "filling: 0.5, enabled: false"] {
        let mut still = simulation(&hinged(fields, 0.3));
        still.step(100).expect("a motion");
        assert_eq!((still.state().q[0], still.state().v[0]), (0.3, 0.0), "{fields}");
    }
}

/// The tank turns over and over, and the surface meets every wall: RK4's error with a step of 10 ms, plus the
/// jump of the third derivative where a surface passes a corner.
#[test]
fn energy_closes_while_a_tank_turns_over() {
    let error = |step_s: f64| {
        let text = hinged("filling: 0.35", 0.01).replace("step_s: 0.01", &format!("step_s: {step_s}"));
        let mut turning = simulation(&text);
        let (mut most, mut error) = (0.0_f64, 0.0_f64);
        for _ in 0..200 {
            turning.step((0.1 / step_s).round() as usize).expect("a motion");
            most = most.max(values(&mut turning, "kinetic_energy")[0]);
            error = error.max(values(&mut turning, "energy_error")[0].abs());
        }
        assert!(most > 1e4, "it moves: {most} J");
        error / most
    };
    let (coarse, fine) = (error(0.02), error(0.01));
    assert!(fine < 1e-6 && coarse / fine > 4.0, "{coarse:e} {fine:e}");
}

/// The barge rolls in calm water without memory of its waves: RK4's order 4 while the surface stays between walls.
#[test]
fn energy_closes_in_a_roll_in_calm_water() {
    let error = |step_s: f64| {
        let more = [
            ("bodies.hull.joint.floating.initial.orientation_rad", json!([0.15, 0.02, 0.4])),
            ("forces.water.hydrodynamics.radiation", json!(false)),
            ("simulation.step_s", json!(step_s)),
        ];
        let mut rolling =
            Simulation::new(scenario(&barge_with(tank(0.5, json!({})), &more)).setup().expect("it builds"));
        let (mut most, mut error, mut heel) = (0.0_f64, 0.0_f64, 0.0_f64);
        for _ in 0..100 {
            rolling.step((0.2 / step_s).round() as usize).expect("a motion");
            most = most.max(values(&mut rolling, "kinetic_energy")[0]);
            error = error.max(values(&mut rolling, "energy_error")[0].abs());
            heel = heel.max(values(&mut rolling, "roll")[0].abs());
        }
        assert!(heel > 0.14, "{heel}");
        error / most
    };
    let (coarse, fine) = (error(0.04), error(0.02));
    assert!(fine < 1e-6 && coarse / fine > 12.0, "{coarse:e} {fine:e}");
}

#[test]
fn the_linearisation_of_a_slack_tank_agrees_with_central_differences() {
    assert_linearised(&hinged("filling: 0.5", 0.2));
    assert_linearised(&hinged("filling: 0.1, density_kg_m3: 850", 0.9));
}

#[test]
fn runs_with_tanks_in_lanes_are_bitwise_identical_to_single_runs() {
    let text = hinged("filling: 0.5", 0.1).replace("duration_s: 20", "duration_s: 2");
    let field = "forces.tank.slack_tank";
    let variant = |filling: f64, length: f64, density: f64| -> Variant {
        let fields = [("filling", filling), ("length_m", length), ("density_kg_m3", density)];
        fields.map(|(name, value)| (format!("{field}.{name}"), json!(value))).to_vec()
    };
    let variants = [(0.0, 6.0, 1000.0), (0.3, 5.0, 900.0), (0.9, 7.0, 1025.0), (1.0, 6.0, 1000.0), (0.5, 4.0, 800.0)];
    let variants = variants.map(|(filling, length, density)| variant(filling, length, density));
    let together = batch::run(&text, "test.yaml", &Files::default(), &variants, 1, |_| true).expect("they build");
    for (run, variant) in together.runs.iter().zip(&variants) {
        let scenario = read(&text, "test.yaml", variant).expect("it reads");
        let alone = scenario.simulation().expect("it builds").run(|_| true);
        let bits = |rows: &[f64]| rows.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        assert!(bits(&run.rows) == bits(&alone.rows), "{variant:?}");
    }
}

fn refused(overrides: &[(&str, Value)]) -> String {
    let overrides: Vec<(String, Value)> =
        barge_with(tank(0.5, json!({})), overrides).into_iter().map(|(name, value)| (name.to_owned(), value)).collect();
    read_with(common::barge::TEXT, "barge.yaml", &overrides, &files()).expect_err("it is refused").to_string()
}

#[test]
fn invalid_tanks_are_refused_at_their_field() {
    let field = |name: &str| format!("forces.tank.slack_tank.{name}");
    for (name, value, words) in [
        ("filling", json!(1.2), "found 1.2, allowed: a number from 0 to 1"),
        ("filling", json!(-0.1), "found -0.1, allowed: a number from 0 to 1"),
        ("length_m", json!(0.0), "found 0, allowed: a number greater than 0"),
        ("height_m", json!(-3.0), "found -3, allowed: a number greater than 0"),
        ("density_kg_m3", json!(0.0), "found 0, allowed: a number greater than 0"),
        ("body", json!("ship"), "found ship, allowed: one of hull, mast, load"),
        ("body", json!("world"), "found world, allowed: one of hull, mast, load"),
        ("breadth", json!(3.0), "found an unknown field"),
    ] {
        let error = refused(&[(&field(name), value)]);
        assert!(error.contains(&field(name)) && error.contains(words), "{error}");
    }
    let missing = hinged("density_kg_m3: 900", 0.1);
    let error = read(&missing, "test.yaml", &[]).expect_err("how full?").to_string();
    assert!(error.contains("forces.tank.slack_tank.filling: found nothing"), "{error}");
}

#[test]
fn a_tank_without_gravity_on_a_body_that_stands_or_heavier_than_its_body_is_refused() {
    let off = refused(&[
        ("forces.gravity.gravity.enabled", json!(false)),
        ("forces.water.hydrodynamics.enabled", json!(false)),
    ]);
    assert!(
        off.ends_with("forces.tank.slack_tank: found a free surface, but no gravity, allowed: gravity that is enabled"),
        "{off}"
    );
    let fixed = hinged("filling: 0.5", 0.0).replace("revolute: {axis: [0, 1, 0], initial_angle_rad: 0}", "fixed: {}");
    let error = read(&fixed, "test.yaml", &[]).expect_err("it stands").to_string();
    assert!(
        error.contains("slack_tank.body: found drum, which is fixed to the world, allowed: a body that moves"),
        "{error}"
    );
    // 216 m3 of 900 kg/m3, half full, twice, on a hull of 380 t; three of them are too much.
    let twice = barge_with(tank(1.0, json!({})), &[("forces.second", tank(0.9, json!({})))]);
    assert_eq!(afloat(&twice).free_surfaces.len(), 1, "a full one has none");
    let heavy = refused(&[("forces.second", tank(1.0, json!({}))), ("forces.third", tank(0.5, json!({})))]);
    assert!(heavy.contains("slack_tank.body: found hull of 380.000 t, with 388.800 t of liquid in its"), "{heavy}");
}
