//! Floating position of the barge with its crane: closed forms of a box, hanging loads, warnings.

use crate::common;

use common::barge::{BEAM, DENSITY, DEPTH, LENGTH, TEXT, files, scenario};
use kingpost::Simulation;
use kingpost::hydrostatics::{HullAfloat, HydrostaticReport, RightingArmPoint, Side};
use kingpost::scenario::{Files, read_with};
use serde_json::{Value, json};

const MAST: &str = "bodies.mast.joint.prismatic.position_m";
const ORIENTATION: &str = "bodies.hull.joint.floating.initial.orientation_rad";
const HYDROSTATICS: &str = "forces.water.hydrodynamics.hydrostatics";
/// Masses of hull, mast and load, kg, and heights of their centres over the keel, m.
const WEIGHTS: [(f64, f64); 3] = [(380e3, 2.0), (20e3, 7.0), (10e3, 7.5)];
/// Distance of the load below its joint, m.
const PENDANT: f64 = 1.5;

fn report(overrides: &[(&str, Value)]) -> HydrostaticReport {
    let upright = [(MAST, json!([0.0, 0.0, 7.0]))];
    let overrides: Vec<_> = upright.into_iter().chain(overrides.iter().cloned()).collect();
    scenario(&overrides).hydrostatic_report().expect("it floats")
}

fn afloat(overrides: &[(&str, Value)]) -> HullAfloat {
    let report = report(overrides);
    assert_eq!(report.warnings, Vec::<String>::new());
    report.hulls.into_iter().next().expect("a hull")
}

fn near(found: f64, expected: f64, allowed: f64) {
    assert!((found - expected).abs() <= allowed, "{found}, expected {expected} within {allowed:e}");
}

fn total() -> f64 {
    WEIGHTS.iter().map(|(mass, _)| mass).sum()
}

/// KG of a box's weights, m.
fn keel_to_gravity() -> f64 {
    WEIGHTS.iter().map(|(mass, height)| mass * height).sum::<f64>() / total()
}

/// `T = M / (rho L B)`, `KB = T / 2`, `BM = B^2 / (12 T)` and `L^2 / (12 T)` (Barrass & Derrett, *Ship
/// Stability for Masters and Mates*, ch. 12); settling leaves 1e-10 m/s^2, that is 1e-10 of a metre.
#[test]
fn a_box_barge_floats_with_the_metacentres_of_its_closed_forms() {
    for hydrostatics in ["linear", "mesh"] {
        let hull = afloat(&[(HYDROSTATICS, json!(hydrostatics))]);
        let draught = total() / (DENSITY * LENGTH * BEAM);
        near(hull.mass_kg, total(), 1e-6);
        near(hull.displacement_kg, total(), 1e-4);
        near(hull.displacement_m3, total() / DENSITY, 1e-7);
        near(hull.draught_m, draught, 1e-9);
        near(hull.heel_rad, 0.0, 1e-12);
        near(hull.trim_rad, 0.0, 1e-12);
        near(hull.keel_to_buoyancy_m, 0.5 * draught, 1e-9);
        let radii = [BEAM, LENGTH].map(|size| size * size / (12.0 * draught));
        for (k, radius) in radii.into_iter().enumerate() {
            near(hull.metacentric_radius_m[k], radius, 1e-8);
            near(hull.keel_to_metacentre_m[k], 0.5 * draught + radius, 1e-8);
            near(hull.solid_metacentric_height_m[k], 0.5 * draught + radius - keel_to_gravity(), 1e-8);
        }
        near(hull.keel_to_gravity_m, keel_to_gravity(), 1e-12);
    }
}

/// A hanging load acts at its suspension point: KG rises by m l / M (Barrass & Derrett, ch. 6).
#[test]
fn a_hanging_load_raises_the_centre_of_gravity_by_its_moment_over_the_mass() {
    let hull = afloat(&[]);
    let rise = 10e3 * PENDANT / total();
    assert_eq!(hull.hanging.len(), 1);
    let load = &hull.hanging[0];
    assert_eq!((load.joint.as_str(), load.body.as_str(), load.mass_kg), ("load", "load", 10e3));
    near(load.length_m, PENDANT, 1e-9);
    for k in [0, 1] {
        near(load.free_share[k], 1.0, 1e-12);
        near(hull.fluid_keel_to_gravity_m[k] - hull.keel_to_gravity_m, rise, 1e-9);
        near(hull.solid_metacentric_height_m[k] - hull.metacentric_height_m[k], rise, 1e-9);
    }
}

/// A joint with one held axis lets the load swing only about the other axis.
#[test]
fn a_load_that_swings_about_one_axis_reduces_gm_about_that_axis() {
    let held = |axis: &str| (format!("bodies.load.joint.universal.{axis}.mode"), json!("held"));
    for (axis, swings) in [("first", [0.0, 1.0]), ("second", [1.0, 0.0])] {
        let (name, mode) = held(axis);
        let hull = afloat(&[(&name, mode)]);
        let rise = 10e3 * PENDANT / total();
        for k in [0, 1] {
            near(hull.fluid_keel_to_gravity_m[k] - hull.keel_to_gravity_m, swings[k] * rise, 1e-9);
        }
    }
    let ((first, mode), (second, _)) = (held("first"), held("second"));
    let hull = afloat(&[(&first, mode.clone()), (&second, mode)]);
    assert!(hull.hanging.is_empty());
    assert_eq!(hull.metacentric_height_m, hull.solid_metacentric_height_m);
}

/// `GZ = sin(phi) (GM + BM tan^2(phi) / 2)` until the bottom or the deck meets the water, here at 21.8
/// degrees (Barrass & Derrett, ch. on wall-sided ships), with the fluid GM.
#[test]
fn the_righting_arm_follows_the_wall_sided_formula_until_the_bilge_comes_out() {
    let hull = afloat(&[]);
    let [gm, bm] = [hull.metacentric_height_m[0], hull.metacentric_radius_m[0]];
    let wall_sided = libm::atan(2.0 * hull.draught_m.min(DEPTH - hull.draught_m) / BEAM);
    near(wall_sided.to_degrees(), 21.8, 0.05);
    let inside = |point: &RightingArmPoint| point.heel_rad < wall_sided;
    let (inside, outside): (Vec<RightingArmPoint>, Vec<_>) =
        hull.righting_arm.expect("a mesh").points.into_iter().partition(inside);
    assert!(inside.len() == 5 && outside.len() == 8, "0, 5, ... 20 degrees and on to 60");
    for point in inside {
        let (sin, tan) = (libm::sin(point.heel_rad), libm::tan(point.heel_rad));
        near(point.arm_m, sin * (gm + 0.5 * bm * tan * tan), 1e-8);
        near(point.trim_rad, 0.0, 1e-9);
    }
    for point in outside {
        let (sin, tan) = (libm::sin(point.heel_rad), libm::tan(point.heel_rad));
        assert!(point.arm_m < sin * (gm + 0.5 * bm * tan * tan), "a box that lost its sides rights itself less");
    }
}

/// The mast off the middle makes the list `W GZ = moment cos(phi)`: wall-sided, `(GM + BM tan^2(phi) / 2) tan(phi) = d`
/// with GM of the ship upright and d the moment over the weight (Barrass & Derrett, ch. on list).
#[test]
fn the_righting_arms_are_those_of_the_side_that_the_ship_lists_to() {
    // So high that the box does not right itself on its side.
    let high = (MAST, json!([0.0, 0.0, 12.0]));
    let upright = afloat(core::slice::from_ref(&high));
    let [gm, bm] = [upright.metacentric_height_m[0], upright.metacentric_radius_m[0]];
    let curve = |shift: f64| {
        let overrides = [high.clone(), ("shift_m", json!(shift)), (HYDROSTATICS, json!("mesh"))];
        let hull = report(&overrides).hulls.remove(0);
        (hull.heel_rad, hull.righting_arm.expect("a mesh"))
    };
    let shift = 3.0;
    let ((to_port, port), (to_starboard, starboard)) = (curve(shift), curve(-shift));
    assert!(to_port < -0.01 && to_starboard > 0.01, "{to_port} {to_starboard}");
    assert_eq!((port.side, starboard.side), (Side::Port, Side::Starboard));
    let d = 30e3 * shift / total();
    for point in port.points.iter().take(5) {
        let (sin, cos) = libm::sincos(point.heel_rad);
        let tan = sin / cos;
        near(point.arm_m, sin * (gm + 0.5 * bm * tan * tan) - d * cos, 1e-8);
    }
    // Mirror images: settling leaves 1e-10 of each.
    for (a, b) in port.points.iter().zip(&starboard.points) {
        near(a.arm_m, b.arm_m, 1e-8);
    }
    let largest = [&port, &starboard].map(|curve| curve.largest.expect("it rights itself"));
    near(largest[0].arm_m, largest[1].arm_m, 1e-8);
    near(port.equilibrium_rad.expect("it rests"), -to_port, 1e-8);
    let (fluid, vanishing) = (libm::tan(-to_port), starboard.vanishing_rad.expect("within 90 deg"));
    near((gm + 0.5 * bm * fluid * fluid) * fluid, d, 1e-8);
    near(vanishing, port.vanishing_rad.expect("within 90 deg"), 1e-8);
    for point in &starboard.points {
        let rights = point.heel_rad > -to_port && point.heel_rad < vanishing;
        assert_eq!(point.arm_m > 0.0, rights, "{point:?} {vanishing}");
    }
    let top = starboard.points.iter().map(|point| point.arm_m).fold(0.0, f64::max);
    assert!(largest[1].arm_m >= top && largest[1].arm_m < top + 0.05, "{top} {largest:?}");
    let small = upright.righting_arm.expect("a mesh").largest.expect("stable").arm_m;
    assert!(largest[0].arm_m < small, "a list takes of the arm: {largest:?} {small}");
}

/// The GM of the report agrees with the heel by a small moment: `W GM phi = moment`, with the load free to
/// swing.
#[test]
fn a_small_moment_heels_by_the_fluid_metacentric_height() {
    let gm = afloat(&[]).metacentric_height_m[0];
    let shift = 0.01;
    let heel = afloat(&[("shift_m", json!(shift))]).heel_rad;
    // Mast to port: the starboard side comes up. Terms of third order are 1e-7 of it.
    near(heel, -30e3 * shift / (total() * gm), 1e-6 * heel.abs());
}

#[test]
fn the_report_is_for_the_present_position_of_the_crane() {
    let built = scenario(&[(MAST, json!([0.0, 0.0, 7.0]))]);
    let mut simulation = Simulation::new(built.setup().expect("it builds"));
    let names = simulation.model().coordinate_names();
    let mast = names.iter().position(|name| name == "mast").expect("a coordinate");
    let (mut q, v) = (simulation.state().q.clone(), simulation.state().v.clone());
    q[mast + 1] = 0.5;
    simulation.set_state(&q, &v, None).expect("a state");
    let moved = built.hydrostatic_report_at(&simulation).expect("it floats");
    let shifted = report(&[("shift_m", json!(0.5))]);
    near(moved.hulls[0].heel_rad, shifted.hulls[0].heel_rad, 1e-9);
    assert_eq!(simulation.state().q, q, "the simulation stays where it is");
}

#[test]
fn an_equilibrium_outside_the_database_gives_a_warning_with_the_limits() {
    let heavy = report(&[("mass", json!(50e3))]).warnings;
    assert_eq!(heavy.len(), 1, "{heavy:?}");
    assert_eq!(
        heavy[0],
        "hull: draught 2.1951 m, the database's is 2.0000 m, 9.8 % apart: linear hydrodynamics hold near the database's draught, upright (warned of beyond 5 %)"
    );
    let off = report(&[("shift_m", json!(4.0))]).warnings;
    assert!(off.len() == 1 && off[0].starts_with("hull: heel ") && off[0].ends_with("beyond 3 deg)"), "{off:?}");
    assert!(off[0].contains(" deg to port: linear"), "{off:?}");
    // Of the mesh alone nothing is linear.
    let mesh_alone = ["added_mass", "radiation", "excitation"]
        .map(|name| (format!("forces.water.hydrodynamics.{name}"), Value::Bool(false)));
    let mut overrides: Vec<(&str, Value)> = vec![("mass", json!(50e3)), (HYDROSTATICS, json!("mesh"))];
    overrides.extend(mesh_alone.iter().map(|(name, value)| (name.as_str(), value.clone())));
    assert_eq!(report(&overrides).warnings, Vec::<String>::new());
}

#[test]
fn a_hull_on_the_water_or_capsized_gives_a_warning() {
    let light = report(&[("bodies.hull.mass_kg", json!(20e3)), (HYDROSTATICS, json!("mesh"))]).warnings;
    assert!(light.iter().any(|words| words.contains("its bottom comes out of the water at about")), "{light:?}");
    let high = report(&[(MAST, json!([0.0, 0.0, 60.0]))]);
    let gm = high.hulls[0].metacentric_height_m[0];
    assert!(gm < 0.0 && high.warnings.iter().any(|words| words.ends_with("it is not stable")), "{gm} {high:?}");
    assert!(high.warnings.iter().any(|words| words.starts_with("the equilibrium is not stable: ")), "{high:?}");
    let over = report(&[(ORIENTATION, json!([3.0, 0.0, 0.0]))]);
    assert!(over.warnings.iter().any(|words| words.contains("deg there: it has capsized")), "{over:?}");
}

#[test]
fn a_run_does_not_begin_with_a_hull_that_has_capsized() {
    let begin = [("simulation.begin_at_equilibrium", json!(true)), (ORIENTATION, json!([3.0, 0.0, 0.0]))];
    let begin = begin.map(|(name, value)| (name.to_owned(), value));
    let error = read_with(TEXT, "barge.yaml", &begin, &files()).expect_err("it lies upside down").to_string();
    assert!(error.contains("simulation.begin_at_equilibrium") && error.contains("it has capsized"), "{error}");
}

#[test]
fn a_hull_that_cannot_float_is_an_error_and_a_missing_equilibrium_is_a_warning() {
    let sinks = [("bodies.hull.mass_kg".to_owned(), json!(1.2e6))];
    let error = read_with(TEXT, "barge.yaml", &sinks, &files()).expect_err("it sinks").to_string();
    assert!(
        error.contains("forces.water.hydrodynamics: found a hull that cannot float: 1230.000 t displace"),
        "{error}"
    );
    let dry = scenario(&[(HYDROSTATICS, json!("none"))]).hydrostatic_report().expect("no error");
    assert!(dry.hulls.is_empty() && dry.warnings[0].starts_with("no hydrostatics"), "{dry:?}");
}

/// Sums over the parts: of the hull its given radii, of the mast a box, of the load a ball, each with m d^2.
#[test]
fn a_loading_other_than_that_of_the_drift_gives_a_warning() {
    let kg = keel_to_gravity();
    let [x, y, z] = [3.5, 6.0, 6.0].map(|radius: f64| WEIGHTS[0].0 * radius * radius);
    let (mast, ball) = (WEIGHTS[1].0, WEIGHTS[2].0);
    let up: f64 = WEIGHTS.iter().map(|(mass, height)| mass * (height - kg) * (height - kg)).sum();
    let (wide, high) = (mast * 17.0 / 12.0, mast * 2.0 / 12.0);
    let of_ball = 0.4 * ball * 0.25;
    let radii =
        [x + wide + of_ball + up, y + wide + of_ball + up, z + high + of_ball].map(|moment| (moment / total()).sqrt());
    let warned = |mass_kg: f64, kg: f64, radii: [f64; 3], drifts: bool| {
        let mut data: Value = serde_json::from_str(&common::barge::database()).expect("JSON");
        let none = vec![vec![[0.0; 3]; 12]; 40];
        data["mean_drift"] = json!(none);
        data["mean_drift_loading"] = json!({"mass_kg": mass_kg, "keel_to_gravity_m": kg, "radii_of_gyration_m": radii,
                                            "roll_damping_ratio": 0.05});
        let files = Files::new([("barge.hydro.json".to_owned(), data.to_string())]);
        let pairs = [(MAST, json!([0.0, 0.0, 7.0])), ("forces.water.hydrodynamics.wave_drift", json!(drifts))];
        let pairs = pairs.map(|(name, value)| (name.to_owned(), value));
        let scenario = read_with(common::barge::TEXT, "barge.yaml", &pairs, &files).expect("it is sound");
        let warnings = scenario.hydrostatic_report().expect("it floats").warnings;
        warnings.into_iter().filter(|words| words.contains("another loading")).collect::<Vec<_>>()
    };
    for share in [0.955, 1.0, 1.045] {
        assert_eq!(warned(share * total(), share * kg, radii.map(|radius| share * radius), true), Vec::<String>::new());
    }
    let off = radii.map(|radius| 1.06 * radius);
    let all = warned(0.9 * total(), 1.06 * kg, off, true);
    assert_eq!(all.len(), 5, "{all:?}");
    assert!(all[0].starts_with("hull: mass 410.0000 t, the database's mean drift is for 369.0000 t"), "{all:?}");
    assert_eq!(warned(0.9 * total(), 1.06 * kg, off, false), Vec::<String>::new());
}

/// 12 directions hold 6 harmonics: about half a length of 10 m waves of k = 0.6 / m, 10.5 m and 2.6 s.
#[test]
fn waves_too_short_for_the_directions_of_the_data_give_a_warning() {
    let warned = |period: f64| {
        let swell = "sea.waves.swell.regular";
        let (on, length) = (format!("{swell}.enabled"), format!("{swell}.period_s"));
        let words = report(&[(on.as_str(), json!(true)), (length.as_str(), json!(period))]).warnings;
        words.into_iter().find(|words| words.contains("12 wave directions"))
    };
    let shortest = libm::sqrt(core::f64::consts::TAU * core::f64::consts::TAU / (9.80665 * 0.6));
    assert_eq!(warned(1.01 * shortest), None);
    let short = warned(0.99 * shortest).expect("a warning");
    assert!(short.contains("resolve waves of 10.5 m and longer for its length of 20.0 m: 100.0 % of"), "{short}");
}

/// A tag line keeps the load from swinging; a line that lifts the hull gives a warning.
#[test]
fn a_tag_line_restrains_a_load_and_a_line_that_lifts_the_hull_gives_a_warning() {
    let line = |first: &str, height: f64, stiffness: f64| {
        json!({"spring_line": {
            "first": {"body": first}, "second": {"body": "world", "position_m": [0.0, 0.0, height]},
            "unstretched_length_m": 1.0, "axial_stiffness_N": stiffness,
        }})
    };
    let tagged = report(&[("forces.line", line("load", 20.0, 1.0))]);
    assert!(tagged.hulls[0].hanging.is_empty(), "{tagged:?}");
    let lifted = report(&[("forces.line", line("hull", 20.0, 1e5))]);
    let told = lifted.warnings.iter().any(|words| words.contains("other forces that carry or pull it"));
    assert!(told && lifted.hulls[0].displacement_kg < 0.999 * lifted.hulls[0].mass_kg, "{lifted:?}");
}

/// The barge with its load on a line that stretches by W L0 / EA, a thousandth of its length, to that of the pendant.
fn on_line() -> String {
    let joint = "{universal: {first_axis: [1, 0, 0], second_axis: [0, 1, 0], position_m: [0, 0, 2], child_position_m: [0, 0, 1.5]}}";
    assert!(TEXT.contains(joint));
    TEXT.replace("    parent: mast\n", "").replace(joint, "{floating: {initial: {position_m: [0, 0, 7.5]}}}")
        + &format!(
            "  rope: {{spring_line: {{first: {{body: mast, position_m: [0, 0, 2]}}, second: {{body: load}}, \
             unstretched_length_m: {}, axial_stiffness_N: {}}}}}\n",
            PENDANT / 1.001,
            10e6 * common::barge::GRAVITY
        )
}

/// Compares a load with the same length below the same point, once on its joint and once on a line: GM and
/// the floating mass are equal, and nothing else carries the ship.
#[test]
fn a_load_on_a_line_reduces_the_metacentric_height_like_one_on_a_pendulum() {
    let on_joint = afloat(&[]);
    let text = on_line();
    let pairs = [(MAST.to_owned(), json!([0.0, 0.0, 7.0]))];
    let scenario = read_with(&text, "barge.yaml", &pairs, &files()).unwrap_or_else(|error| panic!("{error}"));
    let report = scenario.hydrostatic_report().expect("it floats");
    assert_eq!(report.warnings, Vec::<String>::new());
    let hull = &report.hulls[0];
    near(hull.mass_kg, on_joint.mass_kg, 1e-6);
    assert_eq!(hull.hanging.len(), 1);
    let load = &hull.hanging[0];
    assert_eq!((load.joint.as_str(), load.body.as_str(), load.mass_kg), ("rope", "load", 10e3));
    near(load.length_m, PENDANT, 1e-8);
    for k in [0, 1] {
        near(hull.metacentric_height_m[k], on_joint.metacentric_height_m[k], 1e-8);
        near(hull.fluid_keel_to_gravity_m[k], on_joint.fluid_keel_to_gravity_m[k], 1e-8);
    }
}

/// A load on a line, with a hull whose displacement is less than the load's mass, does not count as a sinking
/// ship.
#[test]
fn a_load_with_a_hull_that_cannot_float_is_a_warning() {
    let wet = json!({"hydrodynamics": {
        "body": "load", "database": "barge.hydro.json", "hydrostatics": "mesh", "added_mass": false,
        "radiation": false, "excitation": false,
    }});
    let pairs = [("forces.wet".to_owned(), wet), ("mass".to_owned(), json!(1.2e6))];
    let scenario = read_with(&on_line(), "barge.yaml", &pairs, &files()).unwrap_or_else(|error| panic!("{error}"));
    let report = scenario.hydrostatic_report().expect("a scenario that runs is described");
    let told = report.warnings.iter().find(|words| words.contains("does not float by itself"));
    assert!(told.is_some_and(|words| words.starts_with("no hydrostatics of load")), "{report:?}");
}

/// Checks which buoyancy a run uses at rest: with linear hydrostatics the heel is the linear one, and the
/// curve of the mesh has another.
#[test]
fn the_report_states_whether_the_equilibrium_uses_the_mesh() {
    for (hydrostatics, by_mesh) in [("linear", false), ("mesh", true)] {
        let overrides = [(HYDROSTATICS, json!(hydrostatics)), ("shift_m", json!(4.0))];
        let hull = report(&overrides).hulls.remove(0);
        assert_eq!(hull.rests_by_mesh, by_mesh);
        let of_curve = hull.righting_arm.and_then(|curve| curve.equilibrium_rad).expect("it rests");
        let apart = (hull.heel_rad.abs() - of_curve).abs();
        assert_eq!(apart < 1e-7, by_mesh, "{hydrostatics}: {apart}");
    }
}
