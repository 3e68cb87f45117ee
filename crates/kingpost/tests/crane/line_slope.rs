//! Lines on a sloping seabed: a catenary that leaves it, a chain that slides down, friction.

use kingpost::elements::{LineGround, LinePart, LineSection};
use kingpost::scenario::read;
use kingpost::simulation::Simulation;
use kingpost::spatial::Vector3;

const G: f64 = 9.80665;
/// 20 degrees.
const SLOPE: f64 = 0.349_065_850_398_865_9;

/// A chain of 100 kg/m without water.
const CHAIN: LineSection = LineSection {
    mass_per_length: 100.0,
    diameter: 1e-9,
    axial_stiffness: 1e8,
    damping_time: 0.0,
    bending_stiffness: 0.0,
    added_mass: [1.0, 0.0],
    drag: [1.2, 0.0],
};

/// Way from the lower to the upper end of a chain, of which `lies` m lie on a slope without friction and `hangs` m hang, with
/// this tension at the lower end; and the tension at the upper end. On the slope the tension grows by w sin(slope) per length;
/// the rest is an elastic catenary that leaves along the slope (Irvine, *Cable Structures*, 1981, sec. 2.4).
fn on_slope(lies: f64, hangs: f64, lower_n: f64) -> ([f64; 2], f64) {
    let (weight, stiffness) = (CHAIN.mass_per_length * G, CHAIN.axial_stiffness);
    let leaves = lower_n + weight * SLOPE.sin() * lies;
    let stretched = lies * (1.0 + (lower_n + leaves) / (2.0 * stiffness));
    let [h, v] = [leaves * SLOPE.cos(), leaves * SLOPE.sin()];
    let top = v + weight * hangs;
    let across = h / weight * ((top / h).asinh() - (v / h).asinh()) + h * hangs / stiffness;
    let up = (h.hypot(top) - h.hypot(v)) / weight + (v + top) * hangs / (2.0 * stiffness);
    ([stretched * SLOPE.cos() + across, stretched * SLOPE.sin() + up], h.hypot(top))
}

#[test]
fn a_line_on_a_slope_leaves_it_as_a_catenary() {
    let errors = [20, 80].map(|elements| {
        let ([across, up], upper_n) = on_slope(150.0, 100.0, 4e4);
        let (sin, cos) = SLOPE.sin_cos();
        // Falls along -x; the chain sinks by w cos(slope) / k, 1e-5 of the depth.
        let ground = LineGround { normal: Vector3::new(-sin, 0.0, cos), ..LineGround::level(200.0, 1e6) };
        let part = LinePart { unstretched_length: 250.0, section: CHAIN, elements };
        let ends = [[across, 0.0, up - 200.0], [0.0, 0.0, -200.0]];
        let [first, last, grounded] = crate::line_statics::at_rest(ends, &[part], Some(ground));
        assert!(
            (grounded - 150.0).abs() < 250.0 / elements as f64,
            "{grounded} {first} {upper_n} {last} {across} {up}"
        );
        (first / upper_n - 1.0).abs().max((last / 4e4 - 1.0).abs())
    });
    // The touchdown lies somewhere in an element: a second-order error of its length over that of the hanging part.
    assert!(errors[0] < 2e-2 && errors[1] < 2e-3, "{errors:?}");
}

/// A carriage of 500 kg on rails on a slope of 20 degrees, which falls towards x, with these fields of its joint, and 1,000 kg of
/// chain behind it.
fn carriage(friction: f64, slope_deg: f64, joint: &str) -> String {
    format!(
        "version: 1
title: A chain on a slope
simulation: {{step_s: 0.01, duration_s: 5, record_every_s: 0.1}}
bodies:
  carriage:
    mass_kg: 500
    shape: {{point: {{}}}}
    joint: {{prismatic: {{position_m: [0, 0, -50], axis: [-{cos}, 0, {up}], {joint}}}}}
forces:
  gravity: {{gravity: {{}}}}
  chain:
    line:
      first: {{body: carriage}}
      second_free: true
      seabed: {{friction: {friction}, depth_m: 50, slope_deg: {slope_deg}, stiffness_N_per_m3: 1.0e12}}
      sections: [{{unstretched_length_m: 10, elements: 4, mass_kg_per_m: 100, diameter_m: 1.0e-6, axial_stiffness_N: 1.0e8}}]
",
        cos = SLOPE.cos(),
        up = SLOPE.sin()
    )
}

/// Pulls the chain up with 0.5 m/s.
const PULLS: &str = "mode: {prescribed: {speed_m_s: 0.5, history: list, list: {time_s: [0, 2, 5], share: [0, 1, 1]}}}";

#[test]
fn a_chain_is_pulled_up_a_slope_against_its_weight_and_friction() {
    for friction in [0.0, 0.3, 1.0] {
        let setup =
            read(&carriage(friction, 20.0, PULLS), "chain.yaml", &[]).expect("it reads").setup().expect("it builds");
        let mut run = Simulation::new(setup);
        run.step(500).expect("it does not diverge");
        let tension = crate::common::values(&mut run, "line_tension")[0];
        // w (sin(slope) L + friction cos(slope) L), with the length on the ground: the node at the carriage is not.
        let lies = 1000.0 * (1.0 - 1.0 / 24.0);
        let expected = G * (1000.0 * SLOPE.sin() + friction * lies * SLOPE.cos());
        // At 0.5 m/s friction is less than its limit by 1/2 (0.01 / 0.5)^2; the ramp's last swings are as large.
        assert!((tension / expected - 1.0).abs() < 1e-3, "{friction} {tension} {expected}");
    }
}

#[test]
fn a_carriage_ahead_of_a_slack_chain_slides_at_its_terminal_speed() {
    let setup = read(&carriage(0.3, 20.0, "damping_N_s_m: 5000"), "chain.yaml", &[])
        .expect("it reads")
        .setup()
        .expect("it builds");
    let mut run = Simulation::new(setup);
    run.step(1000).expect("it does not diverge");
    let speeds: Vec<f64> = (0..200)
        .map(|_| {
            run.step(1).expect("it does not diverge");
            run.state().v[0]
        })
        .collect();
    let mean = speeds.iter().sum::<f64>() / 200.0;
    // c v = (m + M) g sin(slope) - friction M g cos(slope), with the length on the ground: the node at the carriage is not.
    let lies = 1000.0 * (1.0 - 1.0 / 24.0);
    let expected = -G * (1500.0 * SLOPE.sin() - 0.3 * lies * SLOPE.cos()) / 5000.0;
    // At 0.48 m/s friction is less than its limit by 1/2 (0.01 / 0.48)^2.
    assert!((mean / expected - 1.0).abs() < 0.01, "{mean} {expected}");
}

#[test]
fn rejects_a_seabed_that_is_a_wall() {
    let refused = read(&carriage(0.3, 70.0, PULLS), "chain.yaml", &[]).expect_err("too steep");
    assert_eq!(refused.field, "forces.chain.line.seabed.slope_rad");
    assert!(refused.to_string().contains("60 degrees"), "{refused}");
}
