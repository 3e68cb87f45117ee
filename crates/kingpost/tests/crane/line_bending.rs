//! Lines with bending stiffness: a beam's modes, the elastica, and the moments of clamped ends.

use crate::line_dynamics::frequencies_of;
use kingpost::integrate::Tolerances;
use kingpost::scenario::read;
use kingpost::simulation::{SchemeName, Setup, Simulation};

const EI: f64 = 2e4;
const LENGTH: f64 = 10.0;
const MASS_PER_LENGTH: f64 = 20.0;

/// A thin rod from the origin towards a point, clamped at its first end along x; its other end is fixed, or clamped too.
fn rod(elements: usize, [x, z]: [f64; 2], second: &str, axial_stiffness: f64) -> String {
    format!(
        "version: 1
title: A rod
simulation: {{step_s: 0.01, duration_s: 1, record_every_s: 0.1}}
bodies: {{point: {{mass_kg: 1, shape: {{point: {{}}}}, joint: {{fixed: {{}}}}}}}}
forces:
  rod:
    line:
      first: {{body: world}}
      first_direction: [3, 0, 0]
      second: {{body: point, position_m: [{x}, 0, {z}]}}
{second}      sections:
        - {{unstretched_length_m: {LENGTH}, elements: {elements}, mass_kg_per_m: {MASS_PER_LENGTH}, diameter_m: 1.0e-6, \
           axial_stiffness_N: {axial_stiffness}, damping_time_s: 0, bending_stiffness_N_m2: {EI}}}
"
    )
}

fn plain(text: &str) -> Setup {
    read(text, "rod.yaml", &[]).expect("it reads").setup().expect("it builds")
}

/// Asserts that the errors of the first three bending frequencies have second order. Each occurs in two planes.
fn bends_with_frequencies(second: &str, roots: [f64; 3]) {
    let errors = [10, 20].map(|elements| {
        let found = frequencies_of(&rod(elements, [LENGTH, 0.0], second, 1e9));
        let unit = (EI / MASS_PER_LENGTH).sqrt() / (LENGTH * LENGTH);
        [0, 1, 2].map(|mode| (found[2 * mode] / (roots[mode] * roots[mode] * unit) - 1.0).abs())
    });
    for (mode, (coarse, fine)) in errors[0].iter().zip(&errors[1]).enumerate() {
        // (beta l)^2 / 12 of second differences over 40 intervals l, and at most as much again by each clamp.
        let second_order = 3.0 * (roots[mode] / 40.0).powi(2) / 12.0;
        assert!(*fine < second_order && (3.4..4.6).contains(&(coarse / fine)), "mode {}: {coarse} {fine}", mode + 1);
    }
}

#[test]
fn frequencies_of_a_beam_with_two_clamped_ends_converge_with_second_order() {
    // cos b cosh b = 1 (Blevins, Formulas for Natural Frequency and Mode Shape, 1979, table 8-1).
    bends_with_frequencies("      second_direction: [1, 0, 0]\n", [4.730_040_74, 7.853_204_62, 10.995_607_8]);
}

#[test]
fn frequencies_of_a_beam_with_one_clamped_end_converge_with_second_order() {
    // tan b = tanh b, the other end pinned (Blevins, table 8-1).
    bends_with_frequencies("", [3.926_602_31, 7.068_582_75, 10.210_176_1]);
}

/// Returns the tip of an inextensible cantilever under a transverse force at its tip, and the slope there, by shooting on
/// EI theta'' = -P cos theta (Bisshopp & Drucker, Quarterly of Applied Mathematics 3, 1945).
fn elastica(force: f64) -> [f64; 3] {
    let steps = 4000;
    let h = LENGTH / f64::from(steps);
    let shoot = |bent: f64| {
        let rate = |[theta, curvature, ..]: [f64; 4]| [curvature, -force / EI * theta.cos(), theta.cos(), theta.sin()];
        let add = |a: [f64; 4], b: [f64; 4], by: f64| [0, 1, 2, 3].map(|k| a[k] + by * b[k]);
        (0..steps).fold([0.0, bent, 0.0, 0.0], |at, _| {
            let k1 = rate(at);
            let k2 = rate(add(at, k1, 0.5 * h));
            let k3 = rate(add(at, k2, 0.5 * h));
            let k4 = rate(add(at, k3, h));
            add(add(add(add(at, k1, h / 6.0), k2, h / 3.0), k3, h / 3.0), k4, h / 6.0)
        })
    };
    let [mut low, mut high] = [0.0, force * LENGTH / EI];
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        *(if shoot(middle)[1] < 0.0 { &mut low } else { &mut high }) = middle;
    }
    let [slope, _, x, z] = shoot(0.5 * (low + high));
    [x, z, slope]
}

#[test]
fn a_rod_bends_as_the_elastica_with_second_order() {
    for share in [1.0, 4.0] {
        let force = share * EI / (LENGTH * LENGTH);
        let [x, z, slope] = elastica(force);
        let errors = [20, 40].map(|elements| {
            // A stretch by a force that is a 5e-6th of EA.
            let mut run = Simulation::new(plain(&rod(elements, [x, -z], "", 2e5 * force)));
            let tension = crate::common::values(&mut run, "line_end_tension")[0];
            (tension - force * slope.sin()) / force
        });
        // Extrapolated, an error of fourth order remains: a sixteenth of the coarse one at most.
        let extrapolated = (4.0 * errors[1] - errors[0]) / 3.0;
        assert!((3.0..5.0).contains(&(errors[0] / errors[1])), "{share}: {errors:?}");
        assert!(extrapolated.abs() < errors[0].abs() / 16.0 + 1e-5, "{share}: {errors:?}");
    }
}

/// A body that flies on a rod which is clamped at both ends, without gravity.
const FLYING: &str = "version: 1
title: A body on a rod
simulation: {step_s: 0.01, duration_s: 2, record_every_s: 0.1}
bodies:
  body:
    mass_kg: 2000
    shape: {box: {length_m: 2, width_m: 1, height_m: 1}}
    joint: {floating: {initial: {position_m: [11, 0, 0], velocity_m_s: [0, 0.5, 1], angular_velocity_rad_s: [0.3, 0.4, 0.2]}}}
forces:
  rod:
    line:
      first: {body: world}
      first_direction: [1, 0, 0]
      second: {body: body, position_m: [-1, 0, 0]}
      second_direction: [1, 0, 0]
      sections:
        - {unstretched_length_m: 10, elements: 5, mass_kg_per_m: 20, diameter_m: 1.0e-6, axial_stiffness_N: 2.0e6, \
           damping_time_s: 0, bending_stiffness_N_m2: 2.0e4}
";

#[test]
fn energy_is_conserved_while_a_body_flies_on_a_clamped_rod() {
    let error = |step_s: f64, scheme: Option<SchemeName>| {
        let mut setup = plain(FLYING);
        setup.settings.step_s = step_s;
        setup.settings.scheme = scheme.unwrap_or(setup.settings.scheme);
        let mut run = Simulation::new(setup);
        run.step((2.0 / step_s).round() as usize).expect("it does not diverge");
        let mut value = |name: &str| crate::common::values(&mut run, name)[0];
        (value("energy_error").abs() + value("line_energy_lost_to_scheme").abs()) / value("energy_scale")
    };
    // By the exact rates the error is that of the scheme's tolerance.
    let exact = Tolerances { absolute: 1e-9, relative: 1e-9, largest_step_s: 0.01 };
    let resolved = error(0.01, Some(SchemeName::DormandPrince(exact)));
    assert!(resolved < 1e-7, "{resolved}");
    let errors = [0.01, 0.005].map(|step_s| error(step_s, None));
    assert!(errors[1] < 1e-4 && errors[0] / errors[1] > 3.4, "{errors:?}");
}

#[test]
fn rejects_clamps_without_stiffness_and_stiffness_over_a_path() {
    let refused = |text: &str| {
        let built = read(text, "rod.yaml", &[]).and_then(|read| read.setup().map(|_| ()));
        built.expect_err("it is refused").to_string()
    };
    let soft = FLYING.replace("bending_stiffness_N_m2: 2.0e4", "bending_stiffness_N_m2: 0");
    assert!(refused(&soft).contains("forces.rod.line.first_direction"), "{}", refused(&soft));
    let path = "path: [{drum: {joint: winch, radius_m: 1}}, {point: {body: body, position_m: [-1, 0, 0]}}]";
    let ends =
        "first: {body: world}\n      first_direction: [1, 0, 0]\n      second: {body: body, position_m: [-1, 0, 0]}
      second_direction: [1, 0, 0]";
    let winch = "bodies:
  drum: {mass_kg: 100, shape: {cylinder: {radius_m: 1, length_m: 1}}, joint: {revolute: {name: winch, axis: [0, 1, 0]}}}";
    let drawn = FLYING.replace(ends, path).replacen("bodies:", winch, 1);
    assert!(refused(&drawn).contains("sections.0.bending_stiffness_N_m2"), "{}", refused(&drawn));
}
