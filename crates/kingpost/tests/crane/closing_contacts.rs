//! Warnings of contacts that make the step too long once they close.

use kingpost::scenario::read;

/// A cube of 2 m and 10 t, this high over a plane, whose corners have 1 GN/m.
fn warnings(gap_m: f64, step_s: f64, integrator: &str, friction: &str) -> Vec<String> {
    let height = 1.0 + gap_m;
    let text = format!(
        "version: 1
title: A cube over a floor
simulation: {{step_s: {step_s}, duration_s: 1, integrator: {integrator}}}
bodies:
  cube:
    mass_t: 10
    shape: {{box: {{length_m: 2, width_m: 2, height_m: 2}}}}
    joint: {{floating: {{initial: {{position_m: [0, 0, {height}]}}}}}}
forces:
  gravity: {{gravity: {{}}}}
  floor:
    contact:
      load: {{body: cube, shape: {{box: {{length_m: 2, width_m: 2, height_m: 2}}}}}}
      surface: {{body: world, shape: {{plane: {{}}}}}}
      stiffness_N_per_m: 1e9
      friction_coefficient: {friction}
"
    );
    read(&text, "cube.yaml", &[]).expect("it reads").describe().expect("it builds").warnings
}

/// On four corners the cube heaves with `4 k / m` and rocks with `4 k (a / 2)^2 / (m a^2 / 6) = 6 k / m`, the faster motion:
/// 775 rad/s. RK4 is stable up to `2 sqrt 2` over that, 3.65 ms.
#[test]
fn a_contact_that_closes_later_gives_a_warning_with_the_period_of_its_load() {
    let found = warnings(0.5, 0.01, "rk4", "0");
    let [warning] = found.as_slice() else { panic!("{found:?}") };
    let expected = "floor: the step of 0.01 s is too long for rk4 once this contact closes: on 4 points of 1e+06 kN/m the load then \
                    moves with a period down to 0.0081 s, which grows with steps longer than 0.0037 s;";
    assert!(warning.starts_with(expected), "{warning}");
    assert!(warnings(0.5, 0.0037, "rk4", "0").len() == 1 && warnings(0.5, 0.0036, "rk4", "0").is_empty());
}

/// Tangential springs let the cube also rock about a point over its lower face: in units of 4 k / m, with h = a / 2 and the
/// moment of inertia m a^2 / 6, the squares of both frequencies are the roots of `(1 - x)(3 - x) = 3 / 2`. The larger one, 2 +
/// sqrt(5 / 2), gives 1197 rad/s and a step of 2.36 ms.
#[test]
fn friction_at_the_points_counts() {
    assert!(warnings(0.5, 0.0024, "rk4", "0.3").len() == 1 && warnings(0.5, 0.0023, "rk4", "0.3").is_empty());
}

#[test]
fn schemes_that_choose_their_step_or_are_implicit_give_no_warning() {
    for integrator in ["dormand_prince", "implicit_midpoint", "generalized_alpha"] {
        assert_eq!(warnings(0.5, 0.01, integrator, "0"), Vec::<String>::new(), "{integrator}");
    }
}
