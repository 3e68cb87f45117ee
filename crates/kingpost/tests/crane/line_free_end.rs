//! Lines with a free end: a hanging chain's modes, rest on the seabed and in a current, energy.

use crate::line_dynamics::{error, frequencies_of};
use kingpost::scenario::read;
use kingpost::simulation::{Setup, Simulation};

const G: f64 = 9.80665;

/// A chain of 10 kg/m below a body at the origin, with a free end; a section has these fields besides its own.
fn chain(length: f64, elements: usize, joint: &str, section: &str, more: &str) -> String {
    format!(
        "version: 1
title: A chain with a free end
simulation: {{step_s: 0.02, duration_s: 10, record_every_s: 0.1}}
{more}
bodies: {{top: {{mass_kg: 100, shape: {{point: {{}}}}, joint: {joint}}}}}
forces:
  gravity: {{gravity: {{}}}}
  chain:
    line:
      first: {{body: top}}
      second_free: true
      {section}
      sections:
        - unstretched_length_m: {length}
          elements: {elements}
          mass_kg_per_m: 10
          axial_stiffness_N: 1.0e8
"
    )
}

fn setup(text: &str) -> Setup {
    read(text, "chain.yaml", &[]).expect("it reads").setup().expect("it builds")
}

fn value(run: &mut Simulation, name: &str) -> f64 {
    crate::common::values(run, name)[0]
}

/// Without water: a diameter of a micrometre.
const DRY: &str = "          diameter_m: 1.0e-6\n";

#[test]
fn a_hanging_chain_swings_with_the_frequencies_of_bessel() {
    // omega = j_0k / 2 sqrt(g / L) with the zeros of J_0 (Lamb, Hydrodynamics, 1932, sec. 193).
    let errors = [8, 16].map(|elements| {
        let text = chain(20.0, elements, "{fixed: {}}", "", "") + DRY;
        let found = frequencies_of(&text);
        [2.404_825_557_7, 5.520_078_110_3, 8.653_727_912_9]
            .map(|zero| error(&found, 0.5 * zero * (G / 20.0_f64).sqrt()))
    });
    for (mode, (coarse, fine)) in errors[0].iter().zip(&errors[1]).enumerate() {
        // The tension vanishes at the end, where half waves are short: between second and fourth order. The stretch of the chain
        // is a 1e-5th.
        assert!(*fine < 2e-3 && (*fine < 2e-5 || coarse / fine > 3.4), "mode {}: {coarse} {fine}", mode + 1);
    }
}

#[test]
fn the_top_carries_the_chain_and_its_sinker() {
    let clump = "          clump_weight: {mass_kg: 50}\n";
    let mut run = Simulation::new(setup(&(chain(20.0, 6, "{fixed: {}}", "", "") + DRY + clump)));
    assert!((value(&mut run, "line_tension") / (250.0 * G) - 1.0).abs() < 1e-9);
    assert!(value(&mut run, "line_end_tension").abs() < f64::MIN_POSITIVE);
}

#[test]
fn a_longer_chain_lies_on_the_seabed() {
    // The stiffness is that over the diameter: 20 kN/m^2, so that it sinks 5 mm.
    let section = "seabed: {friction: 0.5, depth_m: 20, stiffness_N_per_m3: 2.0e10}";
    let mut run = Simulation::new(setup(&(chain(50.0, 50, "{fixed: {}}", section, "") + DRY)));
    // 20 m hang, up to the node before the bottom and with its bend.
    let now = |run: &mut Simulation| [value(run, "line_tension") / (200.0 * G), value(run, "line_grounded_length")];
    let holds = |[tension, grounded]: [f64; 2]| (tension - 1.0).abs() < 0.06 && (grounded - 30.0).abs() < 1.0;
    let rest = now(&mut run);
    run.step(500).expect("it does not diverge");
    let later = now(&mut run);
    assert!(holds(rest) && holds(later), "{rest:?} {later:?}");
}

#[test]
fn a_chain_in_a_current_hangs_at_the_critical_angle() {
    // w cos a = R sin^2 a, and T = w L sin a at the top without drag along the chain (Pode, DTMB report 687, 1951).
    let more = "sea: {depth_m: 1000, density_kg_m3: 1025, current_m_s: [0.8, 0]}";
    let wet = "          diameter_m: 0.05\n          drag_across: 1.2\n";
    let joint = "{fixed: {position_m: [0, 0, -1]}}";
    let mut run = Simulation::new(setup(&(chain(100.0, 8, joint, "", more) + wet)));
    let weight = (10.0 - 1025.0 * core::f64::consts::FRAC_PI_4 * 0.05 * 0.05) * G;
    let ratio = weight / (0.5 * 1025.0 * 1.2 * 0.05 * 0.64);
    // cos^2 a + (w / R) cos a = 1.
    let cosine = 0.5 * (-ratio + (ratio * ratio + 4.0_f64).sqrt());
    let expected = weight * 100.0 * (1.0 - cosine * cosine).sqrt();
    // Straight, so that elements make no error; the stretch is a 1e-5th.
    assert!((value(&mut run, "line_tension") / expected - 1.0).abs() < 1e-4, "{expected}");
}

#[test]
fn energy_closes_while_a_chain_follows_its_top() {
    let joint = "{prismatic: {axis: [1, 0, 0], mode: {oscillation: {amplitude_m: 1, period_s: 3, ramp_s: 3}}}}";
    let wet = "          diameter_m: 0.05\n          drag_along: 0.02\n";
    let error = |step_s: f64| {
        let mut setup = setup(&(chain(20.0, 6, joint, "", "sea: {depth_m: 1000}") + wet));
        setup.settings.step_s = step_s;
        let mut run = Simulation::new(setup);
        run.step((9.0 / step_s).round() as usize).expect("it does not diverge");
        value(&mut run, "energy_error").abs() / value(&mut run, "energy_scale")
    };
    let errors = [0.02, 0.01].map(error);
    assert!(errors[1] < 1e-4 && errors[0] / errors[1] > 3.4, "{errors:?}");
}

#[test]
fn rejects_a_second_end_that_is_also_free() {
    let text = chain(20.0, 6, "{fixed: {}}", "second: {body: world}", "") + DRY;
    let refused = read(&text, "chain.yaml", &[]).and_then(|read| read.setup().map(|_| ()));
    assert!(refused.expect_err("it is refused").to_string().contains("second_free"));
}
