//! A load lifted off a barge and landed on it, in waves, and the effect of its weight on the barge.

use crate::common;

use common::barge::{TEXT, files};
use kingpost::scenario::read_with;
use kingpost::simulation::Simulation;
use serde_json::{Value, json};

/// Free fall, m/s^2.
const G: f64 = 9.80665;
/// The crate's mass, kg.
const MASS: f64 = 20e3;

/// The barge, without its pendulum, in a swell of 1 m and 6 s, and a crate of 20 t above its deck, 5 m above
/// the keel; above it, a winch on a fixed drum hauls in or pays out at `rope_m_s`.
fn text(settings: &str, crate_at: [f64; 3], winch: &str) -> String {
    let [x, y, z] = crate_at;
    let (head, _) = TEXT.split_once("  load:\n").expect("the barge's pendulum");
    let head = head
        .replace(
            "simulation: {step_s: 0.02, duration_s: 20, record_every_s: 0.1}",
            &format!("simulation: {{{settings}}}"),
        )
        .replace(
            "  - {name: mass, label: Mass of the load, unit: kg, default: 10000, writes: [bodies.load.mass_kg]}\n",
            "",
        );
    format!(
        "{head}  box:
    mass_t: 20
    shape: {{box: {{length_m: 4, width_m: 3, height_m: 2}}}}
    joint: {{floating: {{initial: {{position_m: [{x}, {y}, {z}]}}}}}}
{}forces:
  gravity: {{gravity: {{}}}}
  water: {{hydrodynamics: {{body: hull, database: barge.hydro.json, origin_m: [0, 0, 2]}}}}
  hold: {{soft_hold: {{body: hull}}}}
  deck:
    contact:
      load: {{body: box, shape: {{box: {{length_m: 4, width_m: 3, height_m: 2}}}}}}
      surface: {{body: hull, position_m: [0, 0, 2.5], shape: {{box: {{length_m: 20, width_m: 10, height_m: 5}}}}}}
      stiffness_kN_per_m: 10000
      friction_coefficient: 0.4
{winch}",
        if winch.is_empty() {
            ""
        } else {
            "  drum:
    mass_t: 2
    shape: {cylinder: {radius_m: 0.5, length_m: 1, axis: y}}
    joint: {revolute: {name: winch, position_m: [-8.5, 0, 30], axis: [0, 1, 0]}}
"
        }
    )
}

/// A winch above the crate that hauls in at a speed, or pays out at a negative one, m/s.
fn winch(hauls: f64) -> String {
    format!(
        "  fall:
    rope:
      path: [{{drum: {{joint: winch, radius_m: 0.5}}}}, {{sheave: {{body: world, position_m: [-5.5, 0, 30], radius_m: 0.5, axis: [0, 1, 0]}}}}, {{point: {{body: box, position_m: [0, 0, 1]}}}}]
      axial_stiffness_N: 2e7
      damping_time_s: 0.02
drives:
  hoist:
    controlled_drive:
      {{joint: winch, set_point: {{speed: {{rate_rad_s: {}}}}}, speed_limit_rad_s: 2, acceleration_limit_rad_s2: 1,
        torque_limit_kN_m: 400, stiffness_kN_m_per_rad: 2000, damping_kN_m_s_per_rad: 60}}
",
        -2.0 * hauls
    )
}

fn built(text: &str, waves: bool) -> Simulation {
    let swell = [("sea.waves.swell.regular.enabled".to_owned(), json!(waves))];
    let scenario = read_with(text, "barge.yaml", &swell, &files()).unwrap_or_else(|error| panic!("{error}"));
    scenario.simulation().unwrap_or_else(|error| panic!("{error}"))
}

fn values(run: &mut Simulation, variable: &str) -> Vec<f64> {
    common::values(run, variable)
}

/// In half a minute of waves the crate neither slides nor creeps on the deck, and the deck carries its weight
/// and the force of its acceleration.
#[test]
fn a_crate_stands_on_a_deck_in_waves_and_does_not_creep() {
    let settings = "integrator: rk4, step_s: 0.01, duration_s: 100, begin_at_equilibrium: true";
    let mut standing = built(&text(settings, [-5.0, 0.0, 4.0], ""), true);
    let place = |run: &Simulation| {
        let (hull, own) = (frame(run, 0), frame(run, 8));
        hull.0.transpose() * (own.1 - hull.1)
    };
    let before = place(&standing);
    standing.step(6000).expect("it stands");
    let moved = place(&standing) - before;
    assert!(moved.norm() < 2e-3, "{moved:?}");
    assert!(!standing.events().iter().any(|event| event.what == "slides"));
    let normal = values(&mut standing, "contact_normal_force")[0];
    assert!((normal / (MASS * G) - 1.0).abs() < 0.2, "{normal}");
}

/// Rotation and position of the floating body whose coordinates start at an entry of q.
fn frame(run: &Simulation, first: usize) -> (nalgebra::Matrix3<f64>, nalgebra::Vector3<f64>) {
    let q = &run.state().q[first..];
    let turn = nalgebra::Quaternion::new(q[3], q[4], q[5], q[6]);
    let rotation = nalgebra::UnitQuaternion::from_quaternion(turn).to_rotation_matrix();
    (rotation.into_inner(), nalgebra::Vector3::new(q[0], q[1], q[2]))
}

/// A winch lifts the crate off the deck in waves: it leaves the deck, with or without further contacts, and
/// finally hangs. Energy balances, and the deck's impulse does not depend on the step.
#[test]
fn a_crate_is_lifted_off_a_deck_in_waves() {
    let run = |step_s: f64| {
        let settings = format!("integrator: rk4, step_s: {step_s}, duration_s: 100, begin_at_equilibrium: true");
        let mut lifted = built(&text(&settings, [-5.0, 0.0, 4.0], &winch(0.5)), true);
        lifted.step((12.0 / step_s) as usize).expect("it is lifted");
        assert!(lifted.events().iter().filter(|event| event.what == "leaves").count() >= 4);
        assert!(values(&mut lifted, "contact_gap")[0] > 1.0);
        assert_eq!(values(&mut lifted, "contact_normal_force"), [0.0]);
        let work = values(&mut lifted, "work_by_drives")[0];
        let error = values(&mut lifted, "energy_error")[0] / work;
        assert!(error.abs() < 1e-5, "{error:e}");
        values(&mut lifted, "contact_impulse")[0]
    };
    let [coarse, fine] = [run(0.005), run(0.0025)];
    assert!((coarse / fine - 1.0).abs() < 0.01, "{coarse} {fine}");
}

/// A winch sets the crate down on the deck in waves.
#[test]
fn a_crate_is_landed_on_a_deck_in_waves() {
    let run = |step_s: f64| {
        let settings = format!("integrator: rk4, step_s: {step_s}, duration_s: 100, begin_at_equilibrium: true");
        let mut landed = built(&text(&settings, [-5.0, 0.0, 6.5], &winch(-0.5)), true);
        let (mut deepest, mut steps) = (0.0_f64, 0);
        while steps < (12.0 / step_s) as usize {
            landed.step(10).expect("it is set down");
            deepest = deepest.max(values(&mut landed, "contact_penetration")[0]);
            steps += 10;
        }
        assert!(landed.events().iter().any(|event| event.what == "touches"));
        assert!(values(&mut landed, "rope_tension")[0] == 0.0, "its rope is slack");
        let normal = values(&mut landed, "contact_normal_force")[0];
        assert!((normal / (MASS * G) - 1.0).abs() < 0.25, "{normal}");
        // Of the tolerance that is given.
        assert!(deepest < 0.02, "{deepest}");
        let error = values(&mut landed, "energy_error")[0] / (MASS * G);
        assert!(error.abs() < 1e-4, "{error:e}");
        values(&mut landed, "contact_impulse")[0]
    };
    let [coarse, fine] = [run(0.00125), run(0.000625)];
    assert!((coarse / fine - 1.0).abs() < 0.01, "{coarse} {fine}");
}

/// KG of barge, mast and a crate on the deck, from their weights and heights; the barge carries all of them.
#[test]
fn a_crate_on_the_deck_counts_in_the_centre_of_gravity_at_its_position() {
    let settings = "integrator: rk4, step_s: 0.01, duration_s: 100, begin_at_equilibrium: true";
    let mast: Vec<(String, Value)> = vec![("bodies.mast.joint.prismatic.position_m".to_owned(), json!([0, 0, 7]))];
    let standing = text(settings, [0.0, 0.0, 4.0], "");
    // A slack rope changes nothing, and the report says what it would change.
    let path = "[{point: {body: mast, position_m: [0, 0, 9]}}, {point: {body: box}}]";
    let slack =
        format!("forces:\n  whip: {{rope: {{path: {path}, unstretched_length_m: 40, axial_stiffness_N: 1e6}}}}\n");
    for text in [standing.clone(), standing.replacen("forces:\n", &slack, 1)] {
        let scenario = read_with(&text, "barge.yaml", &mast, &files()).unwrap_or_else(|error| panic!("{error}"));
        let report = scenario.hydrostatic_report().expect("it floats");
        let hull = &report.hulls[0];
        let weights = [(380e3, 2.0), (20e3, 7.0), (MASS, 6.0)];
        let mass: f64 = weights.iter().map(|(mass, _)| mass).sum();
        let height = weights.iter().map(|(mass, height)| mass * height).sum::<f64>() / mass;
        assert!((hull.mass_kg - mass).abs() < 1e-6, "{}", hull.mass_kg);
        // It stands 5 mm deep in the deck.
        let sunk = MASS * G / 4e7 * MASS / mass;
        assert!((hull.keel_to_gravity_m - height + sunk).abs() < 1e-6, "{} {height}", hull.keel_to_gravity_m);
        // From the top of the mast, 16 m over the keel, the crate hangs 10 m over its centre.
        let change = -MASS * (16.0 - 6.0 + sunk) / mass;
        let gm = hull.metacentric_height_m[0] + change;
        let told = format!(
            "hull: GM is with box on slack ropes, standing: with box hanging from the highest end of the ropes it changes by \
             {change:.3} m, to {gm:.3} m"
        );
        assert_eq!(report.warnings, if text == standing { Vec::new() } else { vec![told] });
    }
}

/// A crate of 20 t on 40 MN/m bounces with 7 Hz: implicit schemes land it at 10 ms, RK4 below 2.8 / omega = 60 ms. The deck's impulse is
/// that of short steps.
#[test]
fn stiff_contact_runs_at_ten_milliseconds() {
    let impulse = |integrator: &str, step_s: f64| {
        let settings = format!("integrator: {integrator}, step_s: {step_s}, duration_s: 100");
        let text = text(&settings, [-5.0, 0.0, 4.5], "")
            .replace("{floating: {}}", "{floating: {initial: {position_m: [0, 0, 0]}}}");
        let mut landing = built(&text, false);
        landing.step((3.0 / step_s) as usize).unwrap_or_else(|error| panic!("{integrator}: {error}"));
        values(&mut landing, "contact_impulse")[0]
    };
    let exact = impulse("rk4", 0.0005);
    for integrator in ["rk4", "implicit_midpoint", "generalized_alpha", "newmark", "dormand_prince"] {
        let found = impulse(integrator, 0.01);
        assert!((found / exact - 1.0).abs() < 0.01, "{integrator}: {found} {exact}");
    }
}
