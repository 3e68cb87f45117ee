//! Purpose of each integrator: stability on stiff oscillations, numerical damping, invariants.

use crate::common;

use common::{INTEGRATORS, paper, values};
use kingpost::Simulation;
use kingpost::analysis::Linearizer;
use kingpost::integrate::{Jacobian, System};
use kingpost::plant::Plant;
use kingpost::simulation::{RunError, Setup};
use kingpost::spatial::{Quaternion, Vector3};
use serde_json::json;

/// 1 kg on a spring of stiffness omega^2, from rest at 1 m; the spring is a servo without limits.
fn oscillator(settings: &str, omega: f64, step_s: f64) -> Simulation {
    let stiffness = omega * omega;
    common::simulation(&format!(
        "
version: 1
title: A mass on a spring
simulation: {{{settings}, step_s: {step_s:e}, duration_s: 1e6, record_every_s: 1e5, rate_limit: 1e300}}
bodies:
  mass:
    mass_kg: 1
    shape: {{sphere: {{radius_m: 0.1}}}}
    joint: {{prismatic: {{axis: [1, 0, 0], initial_extension_m: 1}}}}
drives:
  spring: {{linear_servo: {{joint: mass, target_m: 0, stiffness_N_per_m: {stiffness:e}, damping_N_s_per_m: 0, force_limit_N: 1e300}}}}
"
    ))
}

/// Energy of the oscillator over that at the start.
fn energy(simulation: &Simulation, omega: f64) -> f64 {
    let (x, v) = (simulation.state().q[0], simulation.state().v[0]);
    x * x + v * v / (omega * omega)
}

#[test]
fn implicit_schemes_keep_the_energy_of_an_oscillation_at_any_step() {
    // The average acceleration method and the midpoint rule keep quadratic invariants of a linear
    // system (Hughes 1987, section 9.1): only rounding is left, some units a step, and with long
    // steps v is the small difference of large accelerations, so that rounding counts by h omega.
    for settings in ["integrator: newmark", "integrator: implicit_midpoint"] {
        for h_omega in [0.1, 1.0, 10.0, 1e3, 1e6] {
            let omega = 40.0;
            let mut simulation = oscillator(settings, omega, h_omega / omega);
            simulation.step(1000).unwrap();
            let error = (energy(&simulation, omega) - 1.0).abs();
            assert!(error < 1e-12 * (1.0 + h_omega), "{settings} at {h_omega}: {error:e}");
        }
    }
}

#[test]
fn explicit_schemes_lose_an_oscillation_that_is_too_fast_for_the_step() {
    // Limits of h omega on the imaginary axis: none for Euler, 2 for semi-implicit Euler, 2 sqrt 2
    // for RK4 (Hairer & Wanner 1996, section IV.2).
    let omega = 40.0;
    let grows = |integrator: &str, h_omega: f64| {
        let mut simulation = oscillator(&format!("integrator: {integrator}"), omega, h_omega / omega);
        simulation.step(400).is_err() || energy(&simulation, omega) > 10.0
    };
    for (integrator, limit) in [("semi_implicit_euler", 2.0), ("rk4", 8.0_f64.sqrt())] {
        assert!(!grows(integrator, 0.98 * limit) && grows(integrator, 1.02 * limit), "{integrator}");
    }
    assert!(grows("forward_euler", 0.1) && grows("midpoint_euler", 0.1));
}

/// Trace, sum of the principal minors and determinant of the matrix that takes `(x, h v, h^2 a)`
/// over a step (Chung & Hulbert 1993, eqs. 9-12), from the definition of the method.
fn invariants(rho: f64, h_omega: f64) -> [f64; 3] {
    let (alpha_m, alpha_f) = ((2.0 * rho - 1.0) / (rho + 1.0), rho / (rho + 1.0));
    let gamma = 0.5 + alpha_f - alpha_m;
    let beta = 0.25 * (gamma + 0.5) * (gamma + 0.5);
    let k = h_omega * h_omega;
    // (1 - alpha_m) a1 + alpha_m a0 + k ((1 - alpha_f) x1 + alpha_f x0) = 0, and Newmark's x1, v1.
    let divisor = (1.0 - alpha_m) + (1.0 - alpha_f) * k * beta;
    let a = [-k / divisor, -(1.0 - alpha_f) * k / divisor, -(alpha_m + (1.0 - alpha_f) * k * (0.5 - beta)) / divisor];
    let x = [1.0 + beta * a[0], 1.0 + beta * a[1], 0.5 - beta + beta * a[2]];
    let v = [gamma * a[0], 1.0 + gamma * a[1], 1.0 - gamma + gamma * a[2]];
    let minor = |p: [f64; 3], q: [f64; 3], i: usize, j: usize| p[i] * q[j] - p[j] * q[i];
    let determinant = x[0] * minor(v, a, 1, 2) - x[1] * minor(v, a, 0, 2) + x[2] * minor(v, a, 0, 1);
    [x[0] + v[1] + a[2], minor(x, v, 0, 1) + minor(x, a, 0, 2) + minor(v, a, 1, 2), determinant]
}

#[test]
fn a_step_of_generalized_alpha_is_that_of_its_amplification_matrix() {
    for rho in [0.0, 0.3, 0.8, 1.0] {
        for h_omega in [0.1, 1.0, 10.0, 1e3] {
            let omega = 40.0;
            let settings = format!("integrator: generalized_alpha, generalized_alpha: {{rho_infinity: {rho}}}");
            let mut simulation = oscillator(&settings, omega, h_omega / omega);
            let mut x = vec![1.0];
            for _ in 0..30 {
                simulation.step(1).unwrap();
                x.push(simulation.state().q[0]);
            }
            let [trace, minors, determinant] = invariants(rho, h_omega);
            for x in x.windows(4) {
                let residual = x[3] - trace * x[2] + minors * x[1] - determinant * x[0];
                // Rounding of the accelerations, h^2 omega^2 times the places, divided by as much.
                assert!(residual.abs() < 1e-12, "rho {rho}, h omega {h_omega}: {residual:e}");
            }
        }
    }
}

#[test]
fn generalized_alpha_reduces_the_fastest_oscillations_by_rho_infinity() {
    // All three roots are -rho there (Chung & Hulbert 1993, eq. 24 and figure 4), so
    // x3 + 3 rho x2 + 3 rho^2 x1 + rho^3 x0 = 0, up to 1 / (h omega)^2.
    for rho in [0.0, 0.5, 0.9, 1.0] {
        let (omega, h_omega) = (1e3, 1e6);
        let settings = format!("integrator: generalized_alpha, generalized_alpha: {{rho_infinity: {rho}}}");
        let mut simulation = oscillator(&settings, omega, h_omega / omega);
        let x: Vec<f64> = (0..4)
            .map(|_| {
                simulation.step(1).unwrap();
                simulation.state().q[0]
            })
            .collect();
        let residual = x[3] + 3.0 * rho * x[2] + 3.0 * rho * rho * x[1] + rho * rho * rho * x[0];
        assert!(residual.abs() < 1e-10, "rho {rho}: {x:?}");
        simulation.step(200).unwrap();
        // 200 steps leave rho^200 times at most a square of the steps.
        let left = simulation.state().q[0].abs();
        assert!(left <= rho.powi(200) * 1e5 + 1e-9, "rho {rho}: {left:e}");
    }
}

#[test]
fn generalized_alpha_without_damping_is_newmark() {
    let run = |settings: &str| {
        let mut simulation = oscillator(settings, 40.0, 0.02);
        simulation.step(100).unwrap();
        simulation.state().q[0]
    };
    let alpha = run("integrator: generalized_alpha, generalized_alpha: {rho_infinity: 1}");
    assert!((alpha - run("integrator: newmark")).abs() < 1e-12);
}

#[test]
fn newmark_with_gamma_above_a_half_damps() {
    let mut simulation = oscillator("integrator: newmark, newmark: {beta: 0.36, gamma: 0.7}", 40.0, 0.1);
    simulation.step(100).unwrap();
    assert!(energy(&simulation, 40.0) < 1e-6);
}

/// A free body with three different moments of inertia, spinning close to the middle one.
fn tumbling(integrator: &str, step_s: f64) -> Simulation {
    let mut simulation = common::simulation(&format!(
        "
version: 1
title: A free body
simulation: {{integrator: {integrator}, step_s: {step_s}, duration_s: 100}}
bodies:
  book:
    mass_kg: 2
    inertia: {{tensor: {{moments_kg_m2: [1, 2, 3]}}}}
    joint: {{floating: {{initial: {{orientation_deg: [10, 20, 30]}}}}}}
"
    ));
    let (q, mut v) = (simulation.state().q.clone(), simulation.state().v.clone());
    v[3..6].copy_from_slice(&[0.01, 3.0, -0.02]);
    simulation.set_state(&q, &v, None).unwrap();
    simulation
}

#[test]
fn the_implicit_midpoint_rule_keeps_energy_and_momentum_of_a_free_body_to_rounding() {
    // Energy is a quadratic invariant of the rates. Each component of the angular momentum in the
    // world is kept as well, for the rotation moves by the Cayley transform. Rounding adds up over
    // the steps: at worst 1e-16 of the size a step.
    let mut simulation = tumbling("implicit_midpoint", 0.05);
    let energy = values(&mut simulation, "kinetic_energy")[0];
    let momentum = values(&mut simulation, "angular_momentum");
    simulation.step(10_000).unwrap();
    let energy_error = (values(&mut simulation, "kinetic_energy")[0] / energy - 1.0).abs();
    assert!(energy_error < 1e-12, "{energy_error:e}");
    let after = values(&mut simulation, "angular_momentum");
    let size = Vector3::from_slice(&momentum).norm();
    for (before, after) in momentum.iter().zip(&after) {
        let error = (before - after).abs() / size;
        assert!(error < 1e-12, "{error:e}");
    }
}

#[test]
fn other_schemes_of_order_two_do_not_conserve_the_angular_momentum_of_a_free_body() {
    for integrator in ["newmark", "generalized_alpha"] {
        let mut simulation = tumbling(integrator, 0.05);
        let momentum = values(&mut simulation, "angular_momentum");
        simulation.step(1000).unwrap();
        let after = values(&mut simulation, "angular_momentum");
        let change = (Vector3::from_slice(&momentum) - Vector3::from_slice(&after)).norm();
        assert!(change > 1e-6, "{integrator}: {change:e}");
    }
}

#[test]
fn quaternions_stay_of_unit_length() {
    for integrator in INTEGRATORS {
        let mut simulation = tumbling(integrator, 0.01);
        simulation.step(1000).unwrap();
        let length = Quaternion::from_slice(&simulation.state().q[3..7]).0.iter().map(|x| x * x).sum::<f64>().sqrt();
        assert!((length - 1.0).abs() < 1e-13, "{integrator}: {length}");
    }
}

#[test]
fn semi_implicit_euler_keeps_the_energy_of_an_oscillation_within_bounds() {
    // It keeps x^2 + v^2 - h x v exactly (omega = 1; Hairer, Lubich & Wanner 2006, I.1.3), so that
    // the energy swings by h omega / 2 at most, while forward Euler's grows by its square a step.
    let (omega, step_s) = (1.0, 0.1);
    let mut simulation = oscillator("integrator: semi_implicit_euler", omega, step_s);
    let invariant = |simulation: &Simulation| {
        let (x, v) = (simulation.state().q[0], simulation.state().v[0]);
        x * x + v * v - step_s * x * v
    };
    simulation.step(100_000).unwrap();
    assert!((invariant(&simulation) - 1.0).abs() < 1e-10);
    assert!((energy(&simulation, omega) - 1.0).abs() <= 0.5 * step_s / (1.0 - 0.5 * step_s));
}

#[test]
fn prescribed_joints_keep_their_motion_with_every_integrator() {
    // The pulse of everything.yaml is piecewise linear in the rate: its integral is the sum of
    // trapezes, which schemes of order two and more take exactly.
    let turned = |integrator: &str| {
        let text = common::everything("recursive")
            .replace("simulation: {", &format!("simulation: {{integrator: {integrator}, "));
        let mut simulation = common::simulation(&text);
        let joint = simulation.model().joint("turned").unwrap();
        let node = &simulation.model().tree.nodes[joint];
        let (position, velocity) = (node.positions, node.velocities);
        simulation.step(700).unwrap();
        (simulation.state().q[position], simulation.state().v[velocity])
    };
    let exact = turned("rk4");
    for integrator in INTEGRATORS {
        let found = turned(integrator);
        let tolerance = if integrator.ends_with("euler") { 1e-3 } else { 1e-10 };
        assert!((found.1 - exact.1).abs() < 1e-10, "{integrator}: {found:?} {exact:?}");
        assert!((found.0 - exact.0).abs() < tolerance, "{integrator}: {found:?} {exact:?}");
    }
}

#[test]
fn implicit_schemes_keep_their_derivatives_over_many_steps() {
    // Eight free coordinates: with new derivatives in every step it would take 20 evaluations. How far
    // a step is from the next, and so how long they serve, goes with the step.
    for integrator in ["newmark", "generalized_alpha", "implicit_midpoint"] {
        for (step_s, allowed) in [(0.001, 6), (0.01, 12)] {
            let mut simulation = paper(&[
                ("hold_centre", json!(false)),
                ("motor_2", json!(true)),
                ("simulation.integrator", json!(integrator)),
                ("simulation.step_s", json!(step_s)),
            ]);
            simulation.step(100).unwrap();
            let evaluations = simulation.evaluations();
            assert!(evaluations < 100 * allowed, "{integrator}, {step_s} s: {evaluations}");
        }
    }
}

#[test]
fn a_newton_iteration_that_does_not_converge_is_an_error_and_rows_are_kept() {
    // The paper's motors run the arm away; steps of 0.5 s soon ask for turns of more than a circle.
    for integrator in ["newmark", "generalized_alpha", "implicit_midpoint"] {
        let mut simulation = paper(&[
            ("motor_2", json!(true)),
            ("simulation.integrator", json!(integrator)),
            ("simulation.step_s", json!(0.5)),
            ("simulation.record_every_s", json!(0.5)),
            ("simulation.duration_s", json!(500.0)),
        ]);
        let run = simulation.run(|_| true);
        let Err(RunError::Step(error)) = run.status else { panic!("{integrator}: {:?}", run.status) };
        assert!(error.to_string().contains("did not converge"), "{error}");
        assert!(run.rows.len() >= run.columns && run.rows.iter().all(|x| x.is_finite()));
        let again = simulation.step(1);
        assert_eq!(again, Err(RunError::Step(error)), "the state is the last good one");
    }
}

#[test]
fn derivatives_by_differences_agree_with_dual_numbers() {
    // Forward differences keep half of the digits: 1e-8 of the curvature and of the accelerations.
    let overrides: Vec<(String, serde_json::Value)> = [("motor_2", true), ("gravity", true), ("damping", true)]
        .map(|(name, value)| (name.to_owned(), json!(value)))
        .to_vec();
    let text = include_str!("../../../../scenarios/paper.yaml");
    let scenario = kingpost::scenario::read(text, "paper.yaml", &overrides).unwrap();
    let mut simulation = Simulation::new(scenario.setup().unwrap());
    simulation.step(700).unwrap();
    let mut linearizer = Linearizer::new(&scenario).unwrap();
    let free: Vec<usize> = linearizer.positions().collect();
    let exact = linearizer.at(&simulation).a;
    let Setup { model, world, elements, .. } = scenario.setup().unwrap();
    let mut plant = Plant::new(model, world, elements);
    let (at, n) = (simulation.stage(), simulation.state().v.len());
    let mut found = Jacobian::new(plant.sizes());
    plant.jacobian(at.q, &vec![0.0; n], at, &mut found);
    let k = free.len();
    let largest = exact.rows(k, k).abs().max();
    for (row, &i) in free.iter().enumerate() {
        for (column, &j) in free.iter().enumerate() {
            let by_xi = found.by_xi[j * found.rows + i] - exact[(k + row, column)];
            let by_v = found.by_v[j * found.rows + i] - exact[(k + row, k + column)];
            assert!(by_xi.abs().max(by_v.abs()) < 1e-6 * largest, "{i} by {j}: {by_xi:e} {by_v:e}");
        }
    }
}
