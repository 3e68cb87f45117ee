//! Drag and lines that hold a ship in position.

use crate::common;

use common::{moored, simulation, values};
use kingpost::elements::lines::{Catenary, Span};
use kingpost::scenario::read;
use kingpost::spatial::Vector3;

/// A body of 2 t (2000 kg), 500 kg m^2 about each axis, floating freely.
fn afloat(initial: &str, more: &str) -> String {
    format!(
        "version: 1\ntitle: A body and a line\nsimulation: {{step_s: 0.005, duration_s: 100}}\nbodies:\n  \
         ship:\n    mass_kg: 2000\n    inertia: {{tensor: {{moments_kg_m2: [500, 500, 500]}}}}\n    \
         joint: {{floating: {{initial: {{{initial}}}}}}}\n{more}"
    )
}

/// `m v' = -c |v| v` has the solution `v = v0 / (1 + c |v0| t / m)`.
#[test]
fn a_rate_with_quadratic_damping_decays_as_one_over_time() {
    let exact = |start: f64, c: f64, mass: f64, time_s: f64| start / (1.0 + c * start.abs() * time_s / mass);
    let drag =
        "forces: {drag: {quadratic_damping: {body: ship, linear_N_s2_m2: [0, 300, 0], angular_N_m_s2: [400, 0, 0]}}}";
    let mut moving = simulation(&afloat("velocity_m_s: [0, -3, 0]", drag));
    let mut rolling = simulation(&afloat("angular_velocity_rad_s: [0.8, 0, 0]", drag));
    for seconds in 1..=4 {
        moving.step(200).unwrap();
        rolling.step(200).unwrap();
        let time_s = f64::from(seconds);
        assert!((moving.state().v[1] - exact(-3.0, 300.0, 2000.0, time_s)).abs() < 1e-9);
        assert!((rolling.state().v[3] - exact(0.8, 400.0, 500.0, time_s)).abs() < 1e-9);
    }
    for simulation in [&mut moving, &mut rolling] {
        assert!(values(simulation, "energy_error")[0].abs() < 1e-6);
        assert!(values(simulation, "energy_dissipated")[0] > 80.0);
    }
}

/// `m u' = -(b - i g) u` for u = v_x + i v_y: the symmetric part of the matrix damps, the skew part rotates.
#[test]
fn a_full_matrix_of_damping_couples_the_rates() {
    let row = |x: f64, y: f64| format!("[{x}, {y}, 0, 0, 0, 0]");
    let still = ["[0, 0, 0, 0, 0, 0]"; 4].join(", ");
    let matrix = |xy: f64, yx: f64| format!("matrix: [{}, {}, {still}]", row(300.0, xy), row(yx, 300.0));
    let drag = |matrix: String| format!("forces: {{drag: {{viscous_damping: {{body: ship, {matrix}}}}}}}");
    let mut turning = simulation(&afloat("velocity_m_s: [2, 0, 0]", &drag(matrix(800.0, -800.0))));
    turning.step(400).unwrap();
    let (size, angle) = (2.0 * libm::exp(-0.3), 0.8_f64);
    assert!((turning.state().v[0] - size * libm::cos(angle)).abs() < 1e-10);
    assert!((turning.state().v[1] - size * libm::sin(angle)).abs() < 1e-10);
    assert!((values(&mut turning, "energy_dissipated")[0] - 1000.0 * (4.0 - size * size)).abs() < 1e-7);
    let gains = afloat("velocity_m_s: [2, 0, 0]", &drag(matrix(301.0, 301.0)));
    let error = read(&gains, "test.yaml", &[]).unwrap_err().to_string();
    assert!(error.contains("forces.drag.viscous_damping.matrix") && error.contains("-3.333e-3"), "{error}");
}

/// `v = u (1 - exp(-c t / m))` along a stream u, and `M = y F` turns the body about its centre.
#[test]
fn linear_damping_at_a_point_is_relative_to_the_stream() {
    let sea =
        "sea: {current_m_s: [1.5, 0]}\nforces: {drag: {viscous_damping: {body: ship, linear_N_s_m: [300, 0, 0]}}}";
    let mut drifting = simulation(&afloat("velocity_m_s: [0, 0, 0]", sea));
    drifting.step(400).unwrap();
    assert!((drifting.state().v[0] - 1.5 * (1.0 - libm::exp(-0.3))).abs() < 1e-11);
    assert!(values(&mut drifting, "energy_error")[0].abs() < 1e-8);
    let aside = sea.replace("linear_N_s_m", "position_m: [0, 2, -1], linear_N_s_m");
    let mut turning = simulation(&afloat("velocity_m_s: [0, 0, 0]", &aside));
    let acceleration = turning.acceleration(None).unwrap();
    for (found, expected) in acceleration.iter().zip([450.0 / 2000.0, 0.0, 0.0, 0.0, -450.0 / 500.0, -900.0 / 500.0]) {
        assert!((found - expected).abs() < 1e-14);
    }
}

/// In the frame of the water the body is slowed as above; the ledger contains the current's work.
#[test]
fn a_current_carries_a_body_along() {
    let drag =
        "sea: {current_m_s: [1.5, 0]}\nforces: {drag: {quadratic_damping: {body: ship, linear_N_s2_m2: [300, 0, 0]}}}";
    let mut drifting = simulation(&afloat("velocity_m_s: [0, 0, 0]", drag));
    drifting.step(1000).unwrap();
    let left = 1.5 / (1.0 + 300.0 * 1.5 * 5.0 / 2000.0);
    assert!((drifting.state().v[0] - (1.5 - left)).abs() < 1e-9);
    let kinetic = 0.5 * 2000.0 * (1.5 - left) * (1.5 - left);
    let heat = 0.5 * 2000.0 * (1.5 * 1.5 - left * left);
    assert!((values(&mut drifting, "kinetic_energy")[0] - kinetic).abs() < 1e-5);
    assert!((values(&mut drifting, "energy_dissipated")[0] - heat).abs() < 1e-5);
    assert!((values(&mut drifting, "work_by_outside")[0] - heat - kinetic).abs() < 1e-5);
}

/// Drag at a point ahead of the centre of mass turns the body: `M = x F`.
#[test]
fn drag_acts_at_its_point() {
    let drag = "forces: {drag: {quadratic_damping: {body: ship, position_m: [2, 0, 0], linear_N_s2_m2: [0, 300, 0]}}}";
    let mut ship = simulation(&afloat("velocity_m_s: [0, 2, 0]", drag));
    let acceleration = ship.acceleration(None).unwrap();
    for (found, expected) in acceleration.iter().zip([0.0, -1200.0 / 2000.0, 0.0, 0.0, 0.0, -2400.0 / 500.0]) {
        assert!((found - expected).abs() < 1e-14);
    }
}

const HAWSER: &str = "forces: {hawser: {spring_line: {first: {body: ship, position_m: [1, 0, 0]}, \
                      second: {body: world, position_m: [11, 0, 0]}, unstretched_length_m: 8, axial_stiffness_kN: 16}}}";

/// A stretch of 2 m at 2 kN/m pulls 2 t to and fro with the frequency `sqrt(k/m) = 1 rad/s`; after a
/// quarter of a period it is slack, with the speed 2 m/s, and stays so.
#[test]
fn a_spring_line_pulls_and_never_pushes() {
    let mut ship = simulation(&afloat("velocity_m_s: [0, 0, 0]", HAWSER));
    assert!((values(&mut ship, "line_tension")[0] - 4000.0).abs() < 1e-9);
    assert!((values(&mut ship, "potential_energy")[0] - 4000.0).abs() < 1e-9);
    ship.step(200).unwrap();
    assert!((ship.state().q[0] - 2.0 * (1.0 - libm::cos(1.0))).abs() < 1e-10);
    assert!((values(&mut ship, "line_tension")[0] - 4000.0 * libm::cos(1.0)).abs() < 1e-6);
    ship.step(200).unwrap();
    assert_eq!(values(&mut ship, "line_tension")[0], 0.0);
    // The step over the slack's begin errs by its length times the jump in the stiffness.
    assert!((ship.state().v[0] - 2.0).abs() < 1e-4);
}

/// A swinging body on an elastic rope conserves its energy; both ends have the same tension.
#[test]
fn a_line_between_two_bodies_keeps_energy_and_momentum() {
    let tied = "  barge:\n    mass_kg: 5000\n    shape: {box: {length_m: 4, width_m: 3, height_m: 1}}\n    \
                joint: {floating: {initial: {position_m: [12, 1, 0], velocity_m_s: [0, 1, 0.5]}}}\n\
                forces: {tow: {spring_line: {first: {body: ship, position_m: [1, 0.5, 0]}, \
                second: {body: barge, position_m: [-2, 0, 0.3]}, unstretched_length_m: 8, axial_stiffness_kN: 40}}}";
    let mut pair = simulation(&afloat("angular_velocity_rad_s: [0.1, 0.2, 0.3]", tied));
    let momentum = values(&mut pair, "linear_momentum");
    pair.step(100).unwrap();
    let error = |a: f64, b: f64| (a - b).abs();
    for (now, then) in values(&mut pair, "linear_momentum").iter().zip(&momentum) {
        assert!(error(*now, *then) < 1e-8);
    }
    let size = Vector3::from_slice(&values(&mut pair, "angular_momentum")).norm();
    let errors = ["momentum_error", "energy_error"].map(|error| values(&mut pair, error)[0].abs());
    assert!(errors[0] < 1e-12 * size && errors[1] < 1e-5, "{errors:?} of {size}");
}

/// Checks that a ship whose line becomes taut at the speed u leaves at about `u (1 - 2/3 a u)` (Hunt &
/// Crossley 1975).
#[test]
fn dissipation_in_a_line_is_heat() {
    let line = HAWSER.replace("axial_stiffness_kN: 16", "axial_stiffness_kN: 16, dissipation_s_per_m: 0.1");
    let mut ship = simulation(&afloat("position_m: [2, 0, 0], velocity_m_s: [-0.5, 0, 0]", &line));
    ship.step(800).unwrap();
    let (left, expected) = (ship.state().v[0], 0.5 * (1.0 - 2.0 / 3.0 * 0.1 * 0.5));
    assert!((left - expected).abs() < 0.1 * (0.5 - expected), "{left} {expected}");
    let lost = 1000.0 * (0.25 - left * left);
    assert!((values(&mut ship, "energy_dissipated")[0] - lost).abs() < 1e-6 * lost.max(1.0) + 1e-4);
}

/// The derivative of the right-hand side along every state, against central differences.
#[test]
fn lines_and_drag_are_linearised_exactly() {
    let both = HAWSER.replace(
        "forces: {",
        "sea: {current_m_s: [0.3, -0.2]}\nforces: {drag: {quadratic_damping: {body: ship, position_m: [0.3, 0, -0.5], \
         linear_N_s2_m2: [100, 300, 200], angular_N_m_s2: [40, 50, 60]}}, ",
    );
    common::assert_linearised(&afloat(
        "orientation_rad: [0.1, 0.2, -0.1], velocity_m_s: [0.4, 0.5, -0.2], angular_velocity_rad_s: [0.1, -0.2, 0.3]",
        &both,
    ));
}

/// Lines that hang, lift off and lie down on the seabed conserve their energy. In a step in which the hawser
/// becomes taut with the speed v, the error is a share of k (v h)^2, 10 J here, of which RK4 leaves a
/// hundredth.
#[test]
fn a_moored_body_conserves_its_energy() {
    let mut simulation = simulation(&moored());
    let mut grounded = Vec::new();
    for _ in 0..30 {
        simulation.step(20).unwrap();
        let lies = values(&mut simulation, "line_grounded_length");
        grounded.push(lies[0]);
        assert!(lies[1] > 20.0 && lies[2] == 0.0, "{lies:?}");
        let size = values(&mut simulation, "kinetic_energy")[0] + values(&mut simulation, "potential_energy")[0].abs();
        let errors =
            ["energy_error", "momentum_error", "linear_momentum_error"].map(|e| values(&mut simulation, e)[0].abs());
        assert!(errors[0] < 0.1 && errors[1] < 1e-11 * size && errors[2] < 1e-11 * size, "{errors:?} of {size}");
    }
    let least = grounded.iter().fold(f64::INFINITY, |least, length| least.min(*length));
    assert!(least > 5.0 && least < grounded[0] - 5.0, "{grounded:?}");
}

/// T at the fairlead and H at an anchor with line on the seabed, by the catenary alone; a spring has one tension.
#[test]
fn the_results_contain_the_tension_of_a_line() {
    let mut simulation = simulation(&moored());
    let [tension, end, grounded] =
        ["line_tension", "line_end_tension", "line_grounded_length"].map(|channel| values(&mut simulation, channel));
    let bow = Catenary { unstretched_length: 93.0, weight: 15.0, axial_stiffness: 8e4, on_seabed: true };
    let force = bow.force(&Span { across: libm::hypot(47.0, 10.0), up: 59.0 });
    assert!((tension[0] - libm::hypot(force.horizontal, force.vertical)).abs() < 1e-9 * tension[0]);
    assert!((grounded[0] - (93.0 - force.vertical / 15.0).max(0.0)).abs() < 1e-9);
    assert_eq!((tension.len(), tension[3], grounded[3]), (4, end[3], 0.0));
    let channel = simulation.channels().iter().find(|channel| channel.variable == "line_tension").unwrap();
    assert_eq!(channel.labels, [["bow", "port", "stern", "hawser"]]);
}

#[test]
fn mooring_lines_are_linearised_exactly() {
    common::assert_linearised(&moored());
}

#[test]
fn invalid_lines_are_refused() {
    let refused = |from: &str, to: &str, message: &str| {
        let text = moored();
        assert!(text.contains(from));
        let error = read(&text.replacen(from, to, 1), "test.yaml", &[]).unwrap_err().to_string();
        assert!(error.contains(message), "{error}");
    };
    refused("fairlead: {body: ship", "fairlead: {body: world", "fairlead.body: found world, allowed: a body");
    refused("fairlead: {body: ship", "fairlead: {body: shp", "fairlead.body: found shp");
    refused(
        "anchor_m: [50, 10, -60]",
        "anchor_m: [50, 10, -50]",
        "bow.catenary_line.anchor_m.2: found -50, allowed: -60",
    );
    refused("position_m: [3, 0, -1]", "position_m: [3, 0, -70]", "starts 10 m below the seabed");
    refused("unstretched_length_m: 93", "unstretched_length_m: 0", "unstretched_length_m");
    refused("second: {body: world", "second: {body: ship", "hawser.spring_line.second.body: found ship");
}
