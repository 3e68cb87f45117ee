//! Ropes over sheaves and on drums, against closed forms and conservation laws.

use crate::common;

use common::{simulation, values};

/// A ship, a boom that luffs on a spring, a drum and a load in free space, all turning: the rope goes from the drum over the
/// boom's tip and the load's sheave, which turns the other way and is out of the plane, back to the boom. Short steps: where an
/// event is located, the scheme's dense output is of order 4 only.
pub fn crane_in_space(rope: &str) -> String {
    format!(
        "version: 1
title: A crane in free space
simulation:
  {{integrator: dormand_prince, step_s: 0.01, duration_s: 20,
    dormand_prince: {{absolute_tolerance: 1e-12, relative_tolerance: 1e-12, largest_step_s: 0.002}}}}
bodies:
  ship:
    mass_kg: 5000
    inertia: {{tensor: {{moments_kg_m2: [4000, 9000, 9000]}}}}
    joint: {{floating: {{initial: {{angular_velocity_rad_s: [0.2, 0.1, -0.3]}}}}}}
  drum:
    parent: ship
    mass_kg: 60
    inertia: {{tensor: {{moments_kg_m2: [2, 4, 2]}}}}
    joint: {{revolute: {{name: winch, position_m: [-2, 0.1, 1], axis: [0, 1, 0], initial_rate_rad_s: 2}}}}
  boom:
    parent: ship
    mass_kg: 300
    centre_of_mass_m: [3, 0, 0]
    inertia: {{tensor: {{moments_kg_m2: [40, 900, 900]}}}}
    joint:
      revolute:
        {{name: luff, position_m: [0, 0, 1], axis: [0, -1, 0], initial_angle_rad: 0.6,
          spring: {{stiffness_N_m_per_rad: 90000, rest_rad: 0.7}}}}
  load:
    mass_kg: 400
    inertia: {{tensor: {{moments_kg_m2: [600, 700, 800]}}}}
    joint: {{floating: {{initial: {{position_m: [5.2, 0.7, 1.1], velocity_m_s: [0.3, -0.4, -3]}}}}}}
forces:
  hoist:
    rope:
      path:
        - drum: {{joint: winch, radius_m: 0.3}}
        - sheave: {{body: boom, position_m: [6, 0, 0.2], radius_m: 0.25, axis: [0, 1, 0.1]{rope}}}
        - sheave: {{body: load, position_m: [0, 0, 0.5], radius_m: 0.2, axis: [0.2, -1, 0]{rope}}}
        - point: {{body: boom, position_m: [6.1, 0.2, 0]}}
      axial_stiffness_N: 4e5
      series_stiffness_N_per_m: 6e5
drives: {{winch: {{motor: {{joint: winch, torque_N_m: -300}}}}}}
"
    )
}

/// The ledger's errors over the energy, and the events.
pub fn ledger(text: &str, steps: usize) -> (f64, Vec<String>) {
    let mut moving = simulation(text);
    moving.step(steps).expect("a motion");
    let scale = values(&mut moving, "kinetic_energy")[0];
    let errors = ["energy_error", "momentum_error", "linear_momentum_error"].map(|name| values(&mut moving, name)[0]);
    let worst = errors.iter().fold(0.0_f64, |worst, error| worst.max(error.abs()));
    (worst / scale, moving.events().iter().map(|event| event.what.to_string()).collect())
}

#[test]
fn a_rope_paid_out_by_a_drum_through_slack_and_taut_conserves_energy_and_momentum() {
    let (error, events) = ledger(&crane_in_space(""), 140);
    let happened = |what: &str| events.iter().any(|event| event == what);
    assert!(happened("goes slack") && happened("comes taut"), "{events:?}");
    assert!(error < 1e-9, "{error:e}");
}

#[test]
fn the_energy_loss_by_friction_and_damping_is_all_heat() {
    let rubbing = crane_in_space(", efficiency_hoisting: 0.95, efficiency_lowering: 0.9");
    let rubbing = rubbing.replace("axial_stiffness_N", "damping_time_s: 0.02\n      axial_stiffness_N");
    let (error, _) = ledger(&rubbing, 130);
    assert!(error < 1e-8, "{error:e}");
    let mut moving = simulation(&rubbing);
    let mut heat = 0.0;
    for _ in 0..130 {
        moving.step(1).unwrap();
        let now = values(&mut moving, "energy_dissipated")[0];
        assert!(now >= heat - 1e-9, "{now} after {heat}");
        heat = now;
    }
    assert!(heat > 100.0, "{heat}");
}

#[test]
fn a_rope_has_exact_derivatives() {
    let text = crane_in_space(", efficiency_hoisting: 0.95, efficiency_lowering: 0.9");
    common::assert_linearised(&text.replace("integrator: dormand_prince, step_s: 0.01", "step_s: 0.001"));
}

/// A load of 1 t on a rope over two fixed sheaves, which comes from below; the path is that of a belt. The load is 40 m below or
/// above the second sheave, level with where it stands off by the radius.
fn belt(second: &str, height: f64) -> f64 {
    let text = format!(
        "version: 1
title: A belt
bodies:
  load: {{mass_kg: 1000, shape: {{point: {{}}}}, joint: {{prismatic: {{name: lift, position_m: [20, 0, {height}], axis: [0, 0, 1]}}}}}}
forces:
  rope:
    rope:
      path:
        - point: {{body: world, position_m: [0, 0, 0]}}
        - sheave: {{body: world, position_m: [0, 0, 10], radius_m: 1, axis: [0, 1, 0]}}
        - sheave: {{body: world, position_m: [20, 0, 10], radius_m: 2, axis: [0, {second}, 0]}}
        - point: {{body: load}}
      axial_stiffness_N: 1e6
"
    );
    values(&mut simulation(&text), "rope_length")[0]
}

#[test]
fn the_path_over_sheaves_is_as_long_as_a_belt() {
    // From the end of a line that touches a circle: sqrt(d^2 - R^2), with the angle asin(R / d) to the line of centres.
    let tangent = |distance: f64, radius: f64| {
        let lean = (radius / distance).asin();
        ((distance * distance - radius * radius).sqrt(), lean)
    };
    let quarter = std::f64::consts::FRAC_PI_2;
    let ((first, lean_first), (last, lean_last)) = (tangent(10.0, 1.0), tangent(40.0, 2.0));
    for (second, height, radii) in [("1", -30.0, 1.0), ("-1", 50.0, 3.0)] {
        let middle = (400.0_f64 - radii * radii).sqrt();
        // Both turn by a right angle and what the legs lean, the same way round or each its own: sheaves that turn the same
        // way lean by the difference of the radii, those that turn against each other by the sum.
        let lean = (radii / 20.0_f64).asin() * if height < 0.0 { -1.0 } else { 1.0 };
        let at_first = quarter + lean_first + lean;
        let at_second = quarter + lean_last + lean.abs();
        let exact = first + middle + last + at_first + 2.0 * at_second;
        let found = belt(second, height);
        assert!((found - exact).abs() < 1e-12, "{second}: {found} {exact}");
    }
}

#[test]
fn an_event_does_not_change_unrelated_states() {
    // A load falls until its rope comes taut, 0.04 s before the cart of a pendulum ceases to speed up: when that is has no
    // influence on the pendulum, whose acceleration is another from there on.
    let text = "version: 1
title: A load that falls and a pendulum that does not know of it
simulation: {step_s: 0.1, duration_s: 1, record_every_s: 1}
bodies:
  load:
    mass_kg: 10
    shape: {sphere: {radius_m: 0.2}}
    joint: {floating: {initial: {position_m: [0, 0, -3.9624]}}}
  cart:
    mass_kg: 5
    shape: {point: {}}
    joint: {prismatic: {name: slide, axis: [1, 0, 0], mode: {prescribed: {speed_m_s: 2, history: pulse, pulse: {rise_s: 0.5, hold_s: 9}}}}}
  pendulum:
    parent: cart
    mass_kg: 1
    shape: {sphere: {radius_m: 0.1}}
    joint: {revolute: {name: swing, axis: [0, 1, 0], child_position_m: [0, 0, 1]}}
forces:
  gravity: {gravity: {}}
  rope: {rope: {path: [{point: {body: world}}, {point: {body: load}}], unstretched_length_m: 5, axial_stiffness_N: 5000}}
";
    let scenario = kingpost::scenario::read(text, "falls.yaml", &[]).expect("it reads");
    let moving = simulation(text);
    let found = kingpost::analysis::gradient(&scenario, &["bodies.load.joint.floating.initial.position_m.2"], |_| true);
    let found = found.expect("a number");
    let offset = |name: &str| moving.channels().iter().find(|one| one.variable == name).expect("a channel").offset;
    let last = found.derivatives[0].len() - found.columns;
    // Coordinates: the slide, then the swing.
    let of_swing = |name: &str| found.derivatives[0][last + offset(name) + 1];
    assert_eq!([of_swing("joint_position"), of_swing("joint_velocity")], [0.0; 2]);
    assert!(found.derivatives[0][last + offset("position") + 2].abs() > 0.1, "the load's own");
}
