//! Exact derivatives: the linearised system against differences and closed forms, equilibria, and
//! gradients of whole runs against runs with moved parameters.

use crate::common;
use crate::common::gallery_files;

use common::{assert_linearised, every_joint, everything};
use kingpost::analysis::{Linearizer, gradient};
use kingpost::scenario::{Scenario, read};
use kingpost::simulation::{Instability, NoEquilibrium, Simulation};
use serde_json::{Value, json};

fn scenario(text: &str) -> Scenario {
    read(text, "test.yaml", &[]).expect("the scenario reads")
}

fn simulation(scenario: &Scenario) -> Simulation {
    Simulation::new(scenario.setup().expect("the scenario builds"))
}

/// A rod of length 2 m that hangs on a hinge, or stands on it upside down.
fn pendulum(angle_rad: f64) -> String {
    format!(
        "version: 1
title: a pendulum
bodies:
  rod:
    mass_kg: 3
    inertia: {{tensor: {{moments_kg_m2: [1, 1, 0]}}}}
    joint:
      revolute: {{name: swing, axis: [0, 1, 0], child_position_m: [0, 0, 1], initial_angle_rad: {angle_rad}, damping_N_m_s: 0.4}}
forces:
  gravity: {{gravity: {{}}}}
"
    )
}

#[test]
fn the_linearised_system_agrees_with_central_differences() {
    assert_linearised(&everything("recursive"));
}

#[test]
fn the_linearised_system_agrees_with_central_differences_for_every_kind_of_joint() {
    assert_linearised(&every_joint());
}

/// A = [0 1; -m g l / J  -c / J] with J = 1 + m l^2 about the hinge.
#[test]
fn a_pendulum_has_its_textbook_a_matrix() {
    let scenario = scenario(&pendulum(0.0));
    let linear = Linearizer::new(&scenario).expect("it builds").at(&simulation(&scenario));
    assert_eq!(linear.states, ["swing", "swing.rate"]);
    let expected = [[0.0, 1.0], [-3.0 * 9.80665 / 4.0, -0.1]];
    for (i, row) in expected.iter().enumerate() {
        for (j, entry) in row.iter().enumerate() {
            assert!((linear.a[(i, j)] - entry).abs() < 1e-14);
        }
    }
}

/// B of a lever is its full torque by the inertia that it turns.
#[test]
fn a_lever_is_an_input_of_the_linearised_system() {
    let scenario = scenario(&format!(
        "{}drives:\n  hand: {{motor: {{joint: swing, torque_N_m: 8, history: lever}}}}\n",
        pendulum(0.3)
    ));
    let linear = Linearizer::new(&scenario).expect("it builds").at(&simulation(&scenario));
    assert_eq!(linear.inputs, ["hand"]);
    assert!((linear.b[(1, 0)] - 8.0 / 4.0).abs() < 1e-14 && linear.b[(0, 0)] == 0.0);
}

/// Upside down the rod is at rest, and falls with `e^(t / T)`, T = sqrt(J / m g l), to the accuracy of A by
/// differences; hanging it stays.
#[test]
fn an_unstable_equilibrium_is_reported_with_its_growth_rate() {
    let settled = |angle: f64| simulation(&scenario(&pendulum(angle))).settle().expect("it rests").instability;
    assert_eq!(settled(0.0), None);
    let Some(Instability::Growth { coordinate, time_s }) = settled(core::f64::consts::PI) else { panic!("it is not") };
    assert!(
        coordinate == "swing" && (time_s - libm::sqrt(4.0 / (3.0 * 9.80665))).abs() < 1e-8,
        "{coordinate} {time_s}"
    );
    let upside_down = pendulum(core::f64::consts::PI) + "simulation: {begin_at_equilibrium: true}\n";
    let error = read(&upside_down, "test.yaml", &[]).expect_err("it would fall").to_string();
    assert!(
        error.contains(
            "an equilibrium that is not stable: a displacement of swing grows by a factor of e every 0.369 s"
        ),
        "{error}"
    );
}

#[test]
fn a_pendulum_settles_downwards_from_anywhere_but_the_top() {
    for angle in [0.01, 1.0, core::f64::consts::FRAC_PI_2, 3.0, -2.5] {
        let scenario = scenario(&pendulum(angle));
        let mut simulation = simulation(&scenario);
        let found = simulation.settle().expect("a pendulum rests");
        assert!(simulation.state().q[0].abs() < 1e-10, "from {angle}: {found:?}");
        assert!(found.iterations < 60, "from {angle}: {found:?}");
    }
}

/// A plank on two equal rods, out of the vertical, cut open at one of its ends.
const SWING: &str = "
version: 1
title: a swing
bodies:
  left:
    mass_kg: 2
    inertia: {tensor: {moments_kg_m2: [0.375, 0.375, 0]}}
    joint: {revolute: {axis: [0, 1, 0], child_position_m: [0, 0, 0.75], initial_angle_rad: 1.2}}
  plank:
    parent: left
    mass_kg: 10
    shape: {box: {length_m: 3, width_m: 0.3, height_m: 0.1}}
    joint: {revolute: {axis: [0, 1, 0], position_m: [0, 0, -0.75], child_position_m: [-1.5, 0, 0], initial_angle_rad: -1.2}}
  right:
    mass_kg: 2
    inertia: {tensor: {moments_kg_m2: [0.375, 0.375, 0]}}
    joint: {revolute: {axis: [0, 1, 0], position_m: [3, 0, 0], child_position_m: [0, 0, 0.75], initial_angle_rad: 1.2}}
loops:
  pin: {first: {body: plank, position_m: [1.5, 0, 0]}, second: {body: right, position_m: [0, 0, -0.75]}, constraints: [x, z]}
forces:
  gravity: {gravity: {}}
";

/// The plank hangs straight, with its loop closed. A maps (1, -1, 1), the only motion that the loop allows,
/// to itself times -(m + M) g L / (2 m L^2 / 3 + M L^2).
#[test]
fn a_closed_loop_settles_closed_and_a_keeps_to_its_tangents() {
    let scenario = scenario(SWING);
    let mut simulation = simulation(&scenario);
    let found = simulation.settle().expect("a swing rests");
    assert!(simulation.state().q.iter().all(|q| q.abs() < 1e-9), "{found:?}: {:?}", simulation.state().q);
    let j = simulation.moving_frame().j;
    let motion = nalgebra::DVector::from_column_slice(&[1.0, -1.0, 1.0]);
    assert!((&j * &motion).amax() < 1e-9);
    let linear = Linearizer::new(&scenario).expect("it builds").at(&simulation);
    let square = 12.0 * 9.80665 / ((4.0 / 3.0 + 10.0) * 1.5);
    assert!((linear.stiffness() * &motion + &motion * square).amax() < 1e-8 * square);
}

/// A level boom of 4 m and 100 kg, held from below by a cylinder between pins 5 m apart.
const CYLINDER: &str = "
version: 1
title: a boom on a cylinder
bodies:
  boom: {mass_kg: 100, shape: {box: {length_m: 4, width_m: 0.5, height_m: 0.5}}, joint: {revolute: {axis: [0, -1, 0], child_position_m: [-2, 0, 0]}}}
drives:
  luffing:
    cylinder:
      first: {body: world, position_m: [0, 0, -3]}
      second: {body: boom, position_m: [2, 0, 0]}
      shortest_m: 4.5
      longest_m: 5.6
      stiffness_N_per_m: 200000
      damping_N_s_per_m: 8000
      push_limit_N: 3000
      pull_limit_N: 3000
      speed_limit_m_s: 0.1
      target: lever
forces: {gravity: {gravity: {}}}
";

/// Shear of short segments is far stiffer than the bending of the whole boom. The boom comes to rest as if it
/// did not slew.
#[test]
fn stiff_parts_do_not_prevent_soft_parts_from_settling() {
    let text = include_str!("../../../../scenarios/flexible_boom.yaml");
    let held = [("bodies.post.joint.revolute.mode".to_owned(), json!("held"))];
    let scenario = read(text, "flexible_boom.yaml", &held).expect("the gallery reads");
    let mut simulation = simulation(&scenario);
    let found = simulation.settle().expect("a boom rests");
    assert!(found.iterations < 60, "{found:?}");
    let accelerations = simulation.acceleration(None).expect("no forces beside its own");
    assert!(accelerations.iter().all(|a| a.abs() < 1e-9), "{accelerations:?}");
}

/// Checks that the length set by a lever is kept, and is a state: with the lever r of the force about the hinge the
/// boom's acceleration follows the length wanted by k r / J, and that follows the input by the speed.
#[test]
fn settling_keeps_the_target_length_of_a_cylinder() {
    let scenario = scenario(CYLINDER);
    let mut simulation = simulation(&scenario);
    simulation.set_input("luffing", 0.5).expect("a lever");
    simulation.step(1000).expect("a second of motion");
    simulation.set_input("luffing", 0.0).expect("a lever");
    let wanted = *simulation.state().s.last().expect("the length wanted");
    simulation.settle().expect("it rests on its cylinder");
    assert_eq!(simulation.state().s.last(), Some(&wanted));
    let cos = simulation.state().q[0].cos();
    let length = (25.0 + 24.0 * simulation.state().q[0].sin()).sqrt();
    let lever = 12.0 * cos / length;
    let force = 2e5 * (wanted - length);
    assert!((force * lever - 100.0 * 9.80665 * 2.0 * cos).abs() < 1e-6, "{force} N");
    let linear = Linearizer::new(&scenario).expect("it builds").at(&simulation);
    assert_eq!(linear.states, ["boom", "boom.rate", "luffing.wanted_length"]);
    let inertia = 100.0 * (16.0 + 0.25) / 12.0 + 400.0;
    let expected = 2e5 * lever / inertia;
    assert!((linear.a[(1, 2)] - expected).abs() < 1e-10 * expected, "{}", linear.a[(1, 2)]);
    assert_eq!(linear.b.as_slice(), [0.0, 0.0, 0.1]);
}

#[test]
fn a_falling_body_has_no_equilibrium_and_its_state_is_unchanged() {
    let setup = |gravity: bool| {
        read_paper(&[("hold_centre", json!(false)), ("gravity", json!(gravity)), ("motor_1", json!(false))])
    };
    let (free, falling) = (setup(false), setup(true));
    let mut simulation = simulation(&falling);
    let before = simulation.snapshot();
    let error = simulation.settle().expect_err("it falls");
    assert!(matches!(&error, NoEquilibrium::NotFound { residual, .. } if *residual > 1.0), "{error}");
    assert_eq!(simulation.snapshot(), before);
    // Without gravity every place is one: nothing moves.
    let mut simulation = Simulation::new(free.setup().expect("it builds"));
    assert_eq!(simulation.settle().expect("it rests").iterations, 0);
}

fn read_paper(overrides: &[(&str, Value)]) -> Scenario {
    read_set(include_str!("../../../../scenarios/paper.yaml"), overrides)
}

fn read_set(text: &str, overrides: &[(&str, Value)]) -> Scenario {
    gallery_files::read(text, overrides).expect("the scenario reads")
}

/// Masses, places, torques, damping and an initial angle, more than one evaluation carries.
#[test]
fn gradients_of_a_run_agree_with_central_differences() {
    let base = [
        ("motor_2", json!(true)),
        ("damping", json!(true)),
        ("load", json!(true)),
        ("gravity", json!(true)),
        ("torque_history", json!("pulse")),
        ("hold_centre", json!(false)),
        ("crane_x_m", json!(-8)),
        ("simulation.duration_s", json!(0.4)),
        ("simulation.step_s", json!(0.01)),
        ("simulation.record_every_s", json!(0.1)),
    ];
    let parameters = [
        ("bodies.load.mass_kg", 1000.0),
        ("crane_x_m", -8.0),
        ("drives.motor_1.motor.torque_N_m", 100_000.0),
        ("forces.damping.viscous_damping.angular_N_m_s.2", 25_000.0),
        ("bodies.arm.joint.revolute.initial_angle_deg", 0.0),
    ];
    gradients_agree(include_str!("../../../../scenarios/paper.yaml"), &base, &parameters);
}

/// A mass, a pin of the loop, the cylinder's stiffness and an angle from which the loop is closed first:
/// the multipliers, the projection of every step and that of the start are differentiated too.
#[test]
fn gradients_through_a_closed_loop_and_a_cylinder_agree_with_central_differences() {
    let base = [
        ("drives.slewing.servo.enabled", json!(false)), // at its limit its torque has a kink
        ("bodies.column.joint.revolute.initial_rate_rad_s", json!(0.1)),
        ("simulation.duration_s", json!(0.4)),
        ("simulation.step_s", json!(0.005)),
        ("simulation.record_every_s", json!(0.1)),
    ];
    let parameters = [
        ("bodies.boom.mass_kg", 12_000.0),
        ("loops.drag_link_pin.second.position_m.0", -4.5),
        ("drives.luffing.cylinder.stiffness_N_per_m", 2e7),
        ("bodies.boom.joint.revolute.initial_angle_deg", 55.0),
    ];
    gradients_agree(&gallery_files::text("dual_draglink_crane"), &base, &parameters);
}

/// Derivatives of every result of a run along parameters with these values, against central differences
/// of runs.
fn gradients_agree(text: &str, base: &[(&str, Value)], parameters: &[(&str, f64)]) {
    let names: Vec<&str> = parameters.iter().map(|(name, _)| *name).collect();
    let exact = gradient(&read_set(text, base), &names, |_| true).expect("they have derivatives");
    exact.status.clone().expect("it does not diverge");
    for ((name, value), derivatives) in parameters.iter().zip(&exact.derivatives) {
        let h = 1e-4 * value.abs().max(1.0);
        let run = |value: f64| {
            let mut with = base.to_vec();
            with.push((name, json!(value)));
            simulation(&read_set(text, &with)).run(|_| true).rows
        };
        let (ahead, behind) = (run(value + h), run(value - h));
        // The ledger's errors are themselves of the size of rounding.
        for channel in exact.channels.iter().filter(|channel| !channel.variable.ends_with("error")) {
            let at = |rows: &[f64], row: usize, k: usize| rows[row * exact.columns + channel.offset + k];
            let rows = exact.rows.len() / exact.columns;
            let entries = || (0..rows).flat_map(|row| (0..channel.len).map(move |k| (row, k)));
            let difference = |(row, k): (usize, usize)| (at(&ahead, row, k) - at(&behind, row, k)) / (2.0 * h);
            let size = entries().map(|e| difference(e).abs()).fold(0.0, f64::max);
            let value_size = entries().map(|(row, k)| at(&exact.rows, row, k).abs()).fold(0.0, f64::max);
            // The differences' own error: h squared of a third derivative, and rounding over h.
            let rounding = 1e-12 * value_size / h;
            for (row, k) in entries() {
                let error = (at(derivatives, row, k) - difference((row, k))).abs();
                assert!(error <= 1e-5 * size + rounding, "{} by {name}: {error} of {size}", channel.variable);
            }
        }
    }
}

#[test]
fn a_gradient_without_d_or_without_names_is_refused() {
    let naive = read_paper(&[("simulation.form", json!("moving_frame_without_d"))]);
    assert!(gradient(&naive, &["crane_x_m"], |_| true).is_err());
    assert!(gradient(&read_paper(&[]), &[], |_| true).is_err());
}

/// Newton's iteration ends at the same solution for any derivatives, within its tolerance.
#[test]
fn an_implicit_scheme_makes_the_same_steps_with_exact_derivatives_as_with_differences() {
    for integrator in ["newmark", "generalized_alpha", "implicit_midpoint"] {
        let scenario = read_paper(&[
            ("simulation.integrator", json!(integrator)),
            ("simulation.step_s", json!(0.005)),
            ("simulation.duration_s", json!(0.5)),
            ("motor_2", json!(true)),
            ("hold_centre", json!(false)),
        ]);
        let mut by_differences = simulation(&scenario);
        let mut exact = scenario.simulation().expect("it builds");
        let (a, b) = (by_differences.run(|_| true), exact.run(|_| true));
        assert!(a.status.is_ok() && b.status.is_ok(), "{integrator}");
        assert!(common::relative_difference(&a.rows, &b.rows) < 1e-9, "{integrator}");
    }
}
