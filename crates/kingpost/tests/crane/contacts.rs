//! Contact against closed forms and conservation laws.

use crate::common;

use common::{simulation, values};
use kingpost::simulation::Simulation;

/// Free fall, m/s^2.
pub(super) const G: f64 = 9.80665;

/// A ball of 1 t and 0.5 m over the ground, at the integrator's own settings.
fn ball(settings: &str, motion: &str, contact: &str) -> String {
    format!(
        "version: 1
title: A ball
simulation: {{{settings}}}
bodies:
  ball: {{mass_kg: 1000, shape: {{sphere: {{radius_m: 0.5}}}}, joint: {{floating: {{initial: {{{motion}}}}}}}}}
forces:
  gravity: {{gravity: {{}}}}
  ground:
    contact:
      load: {{body: ball, shape: {{sphere: {{radius_m: 0.5}}}}}}
      surface: {{body: world, shape: {{plane: {{}}}}}}
{contact}
"
    )
}

const FINE: &str = "integrator: rk4, step_s: 0.0002, duration_s: 60";

fn lines(contact: &[&str]) -> String {
    contact.iter().map(|line| format!("      {line}\n")).collect()
}

/// Returns the times of an event.
pub(super) fn times(run: &Simulation, what: &str) -> Vec<f64> {
    run.events().iter().filter(|event| event.what == what).map(|event| event.time_s).collect()
}

/// Returns the ratio of the ledger's error to an energy.
pub(super) fn energy_error(run: &mut Simulation, scale: f64) -> f64 {
    values(run, "energy_error")[0].abs() / scale
}

/// A ball that falls from a height h touches with sqrt(2 g h), then with its speed of rebound.
#[test]
fn the_impact_speed_is_that_of_the_latest_touch_with_its_derivative() {
    let contact = lines(&["stiffness_N_per_m: 1e7", "restitution: 0.5", "friction_coefficient: 0"]);
    let text = ball(FINE, "position_m: [0, 0, 2.5]", &contact);
    let mut falling = simulation(&text);
    assert_eq!(values(&mut falling, "contact_impact_speed"), [0.0]);
    while times(&falling, "leaves").is_empty() {
        falling.step(10).expect("it falls");
    }
    let impact = (2.0 * G * 2.0).sqrt();
    // The event is located to 1e-9 of the step.
    assert!((values(&mut falling, "contact_impact_speed")[0] - impact).abs() < 1e-9);
    let rebound = falling.state().v[2];
    while times(&falling, "touches").len() < 2 {
        falling.step(10).expect("it falls again");
    }
    // Steps between the event and the reading change the speed of rebound by g times 2 ms.
    assert!((values(&mut falling, "contact_impact_speed")[0] - rebound).abs() < 0.03, "{rebound}");
    assert!((values(&mut falling, "contact_largest_impact_speed")[0] - impact).abs() < 1e-9);
    let short = text.replace("duration_s: 60", "duration_s: 0.7").replace("step_s: 0.0002", "step_s: 0.002");
    let scenario = kingpost::scenario::read(&short, "ball.yaml", &[]).expect("it reads");
    let height = "bodies.ball.joint.floating.initial.position_m.2";
    let found = kingpost::analysis::gradient(&scenario, &[height], |_| true).expect("a number");
    let place =
        found.channels.iter().find(|channel| channel.variable == "contact_impact_speed").expect("a column").offset;
    let derivative = found.derivatives[0][found.derivatives[0].len() - found.columns + place];
    // d sqrt(2 g h) / dh; that of the time of an event has the error of a step.
    assert!((derivative - G / impact).abs() < 2e-3, "{derivative} {}", G / impact);
}

/// A level box above a plane that leans by 0.1 rad about x; its shape has a heading of 0.3 rad.
#[test]
fn the_set_down_of_a_load_is_in_axes_of_its_surface() {
    let text = format!(
        "version: 1
title: A box on a slope
simulation: {{{FINE}}}
bodies:
  box: {{mass_kg: 1000, shape: {{box: {{length_m: 2, width_m: 1, height_m: 1}}}}, joint: {{floating: {{}}}}}}
forces:
  slope:
    contact:
      load: {{body: box, orientation_rad: [0, 0, 0.3], shape: {{box: {{length_m: 2, width_m: 1, height_m: 1}}}}}}
      surface: {{body: world, position_m: [1, 2, -3], orientation_rad: [0.1, 0, 0], shape: {{plane: {{}}}}}}
      stiffness_N_per_m: 1e6
      friction_coefficient: 0
"
    );
    let mut found = simulation(&text);
    // Level, 0.3 rad from x about z, over a surface that leans about x.
    let (sine, cosine) = 0.1_f64.sin_cos();
    let place = [-1.0, -2.0 * cosine + 3.0 * sine, 3.0 * cosine + 2.0 * sine];
    for (found, place) in values(&mut found, "contact_position").iter().zip(place) {
        assert!((found - place).abs() < 1e-14, "{found} {place}");
    }
    assert!((values(&mut found, "contact_tilt")[0] - 0.1).abs() < 1e-14);
    let heading = (0.3_f64.sin() * cosine).atan2(0.3_f64.cos());
    assert!((values(&mut found, "contact_heading")[0] - heading).abs() < 1e-14);
}

/// Without gravity, x (1 + e) = ln((1 + x) / (1 - e x)) with x = a v is exact at every speed; at the
/// reference speed e is the given restitution, for any mass and stiffness.
#[test]
fn a_ball_rebounds_by_its_restitution_at_every_speed() {
    for (restitution, speed) in [(0.6, 3.0), (0.6, 1.0), (0.6, 0.1), (0.15, 3.0), (0.9, 3.0), (1.0, 1.0)] {
        let contact = lines(&[
            "stiffness_N_per_m: 1e8",
            &format!("restitution: {restitution}"),
            "restitution_speed_m_s: 3",
            "friction_coefficient: 0",
        ]);
        let settings = "integrator: rk4, step_s: 0.00002, duration_s: 60";
        let text = ball(settings, &format!("position_m: [0, 0, 0.51], velocity_m_s: [0, 0, -{speed}]"), &contact);
        let mut thrown = simulation(&text.replace("gravity: {}", "gravity: {enabled: false}"));
        while times(&thrown, "leaves").is_empty() {
            thrown.step(100).expect("it comes back");
        }
        let found = thrown.state().v[2] / speed;
        let x = kingpost::elements::contact::dissipation(restitution, 3.0) * speed;
        let law = x * (1.0 + found) - ((1.0 + x) / (1.0 - found * x)).ln();
        // Over its derivative by e.
        let off = law / (x + x / (1.0 - found * x)).max(1e-3);
        assert!(off.abs() < 1e-7, "{restitution} at {speed}: {found}");
        assert!(speed < 3.0 || (found - restitution).abs() < 1e-6, "{restitution}: {found}");
        assert!(found >= restitution - 1e-6, "{restitution} at {speed}: {found}");
        assert!((values(&mut thrown, "contact_impulse")[0] / (1000.0 * speed * (1.0 + found)) - 1.0).abs() < 1e-7);
        assert!(energy_error(&mut thrown, 500.0 * speed * speed) < 1e-7);
    }
}

/// Without losses: every bounce takes the same time and reaches the same height. The touch lasts
/// 2 (pi - atan(v omega / g)) / omega, of the oscillator on its spring under its weight.
#[test]
fn a_ball_without_losses_bounces_for_ever() {
    let contact = lines(&["stiffness_N_per_m: 1e6", "restitution: 1", "friction_coefficient: 0"]);
    let mut falling = simulation(&ball(FINE, "position_m: [0, 0, 1.5]", &contact));
    falling.step(100_000).expect("it bounces");
    let (touches, leaves) = (times(&falling, "touches"), times(&falling, "leaves"));
    let (speed, omega) = ((2.0 * G).sqrt(), 1000.0_f64.sqrt());
    let touch = 2.0 * (std::f64::consts::PI - (speed * omega / G).atan()) / omega;
    for (k, (touched, left)) in touches.iter().zip(&leaves).enumerate() {
        let exact = speed / G + k as f64 * (2.0 * speed / G + touch);
        assert!((touched - exact).abs() < 1e-7 && (left - exact - touch).abs() < 1e-7, "{k}: {touched} {exact} {left}");
    }
    assert!(touches.len() > 15, "{touches:?}");
    assert!(energy_error(&mut falling, 1000.0 * G) < 1e-9);
}

/// A crate on corners, over a floor; without gravity it would keep its spin.
fn dropped(settings: &str, motion: &str, more: &str) -> String {
    format!(
        "version: 1
title: A crate is dropped
simulation: {{{settings}}}
bodies:
  crate:
    mass_t: 2
    shape: {{box: {{length_m: 2, width_m: 1.5, height_m: 1}}}}
    joint: {{floating: {{initial: {{{motion}}}}}}}
forces:
  gravity: {{gravity: {{}}}}
  deck:
    contact:
      load: {{body: crate, shape: {{box: {{length_m: 2, width_m: 1.5, height_m: 1}}}}}}
      surface: {{body: world, position_m: [0, 0, -0.5], shape: {{box: {{length_m: 8, width_m: 8, height_m: 1}}}}}}
      stiffness_kN_per_m: 5000
      friction_coefficient: 0.4
{more}"
    )
}

/// The ledger closes to the scheme's order, four: with half the step a sixteenth of the error remains, down
/// to rounding.
#[test]
fn the_ledger_of_an_impact_closes_to_the_order_of_the_scheme() {
    let error = |step_s: f64| {
        let settings = format!("integrator: rk4, step_s: {step_s}, duration_s: 60");
        let mut falling = simulation(&dropped(&settings, "position_m: [0, 0, 1]", ""));
        falling.step((0.5 / step_s).round() as usize).expect("it falls");
        energy_error(&mut falling, 1000.0 * G)
    };
    let [coarse, middle, fine] = [0.0002, 0.0001, 0.000025].map(error);
    assert!((coarse / middle / 16.0 - 1.0).abs() < 0.1, "{coarse:e} {middle:e}");
    assert!(fine < 1e-9, "{fine:e}");
}

/// Kinetic, potential and elastic energy together.
#[test]
fn a_crate_dropped_flat_or_on_a_corner_never_gains_energy() {
    let settings = "integrator: rk4, step_s: 0.0001, duration_s: 60";
    for motion in [
        "position_m: [0, 0, 1]",
        "position_m: [0, 0, 1.6], orientation_deg: [25, 35, 10]",
        "position_m: [0, 0, 1.4], orientation_deg: [10, 20, 0], velocity_m_s: [2, -1, 0], angular_velocity_rad_s: [0, 1, 3]",
    ] {
        let mut falling = simulation(&dropped(settings, motion, ""));
        let mut energy = f64::MAX;
        let first = values(&mut falling, "kinetic_energy")[0] + values(&mut falling, "potential_energy")[0];
        for _ in 0..1500 {
            falling.step(20).expect("it falls");
            let now = values(&mut falling, "kinetic_energy")[0] + values(&mut falling, "potential_energy")[0];
            assert!(now <= energy + 1e-6 * first, "{motion}: {now} after {energy}");
            energy = now;
        }
        assert!(values(&mut falling, "contact_points")[0] == 4.0, "{motion}: it lies");
        assert!(energy_error(&mut falling, first) < 1e-6, "{motion}: {:e}", energy_error(&mut falling, first));
    }
}

/// Half the step, and half again: the impulse of a drop on a corner that slides and tips to its rest.
#[test]
fn half_the_step_changes_the_impulse_by_less_than_one_percent() {
    let motion = "position_m: [0, 0, 1.3], orientation_deg: [15, 20, 10], velocity_m_s: [1, 0, 0]";
    let impulse = |integrator: &str, step_s: f64| {
        let mut falling =
            simulation(&dropped(&format!("integrator: {integrator}, step_s: {step_s}, duration_s: 60"), motion, ""));
        falling.step((0.5 / step_s) as usize).expect("it falls");
        values(&mut falling, "contact_impulse")[0]
    };
    for (integrator, step_s) in [("rk4", 0.002), ("implicit_midpoint", 0.002), ("generalized_alpha", 0.002)] {
        let [coarse, fine] = [impulse(integrator, step_s), impulse(integrator, 0.5 * step_s)];
        assert!((coarse / fine - 1.0).abs() < 0.01, "{integrator}: {coarse} {fine}");
    }
}

/// m g / 4 k on four corners, on a deck with edges and beside another crate.
#[test]
fn a_load_at_rest_penetrates_by_its_weight_over_the_stiffness() {
    let settings = "integrator: rk4, step_s: 0.001, duration_s: 60, begin_at_equilibrium: true";
    let mut resting = simulation(&dropped(settings, "position_m: [0, 0, 0.501]", ""));
    let depth = 2000.0 * G / 2e7;
    assert!((values(&mut resting, "contact_penetration")[0] / depth - 1.0).abs() < 1e-6);
    assert!((values(&mut resting, "contact_normal_force")[0] / (2000.0 * G) - 1.0).abs() < 1e-6);
    assert_eq!(values(&mut resting, "contact_points"), [4.0]);
}

/// A crate that overhangs a narrow platform on both sides stands on the platform's corners: they press into its bottom.
#[test]
fn a_wide_crate_stands_on_the_corners_of_a_narrow_platform() {
    let settings = "integrator: rk4, step_s: 0.001, duration_s: 60, begin_at_equilibrium: true";
    let text = dropped(settings, "position_m: [0, 0, 0.5]", "")
        .replace("{length_m: 8, width_m: 8", "{length_m: 1, width_m: 1");
    let mut resting = simulation(&text);
    let depth = 2000.0 * G / 2e7;
    assert!((values(&mut resting, "contact_penetration")[0] / depth - 1.0).abs() < 1e-6);
    let force = values(&mut resting, "contact_force");
    assert!((force[2] / (2000.0 * G) - 1.0).abs() < 1e-6, "{force:?}");
}

/// A roller of 0.2 m against a vertical pipe, and a ball on a ball: the distance of the centres is that of the radii less F / k.
#[test]
fn balls_and_pipes_touch_at_the_sum_of_their_radii() {
    let guide = |load: &str, distance: f64| {
        format!(
            "version: 1
title: A guide
simulation: {{integrator: rk4, step_s: 0.001, duration_s: 60, begin_at_equilibrium: true}}
bodies:
  load: {{mass_kg: 1000, shape: {{sphere: {{radius_m: 0.5}}}}, joint: {{prismatic: {{name: lift, axis: [0, 0, 1], position_m: [0, 0, {distance}]}}}}}}
forces:
  gravity: {{gravity: {{}}}}
  guide:
    contact:
      load: {{body: load, shape: {{{load}}}}}
      surface: {{body: world, shape: {{sphere: {{radius_m: 0.2}}}}}}
      stiffness_N_per_m: 1e6
      friction_coefficient: 0
"
        )
    };
    for load in [
        "sphere: {radius_m: 0.5}",
        "cylinder: {radius_m: 0.5, length_m: 4, axis: x}",
        "box: {length_m: 3, width_m: 2, height_m: 1}",
    ] {
        let resting = simulation(&guide(load, 0.7));
        assert!((resting.state().q[0] + 1000.0 * G / 1e6).abs() < 1e-9, "{load}: {}", resting.state().q[0]);
    }
}

/// Accelerations by all positions and rates, of a crate that slides and one that is held: central differences with step h err by h squared
/// and by rounding over h.
#[test]
fn contact_has_exact_derivatives() {
    for velocity in ["[1, 0.5, 0]", "[0.002, 0.001, 0]"] {
        let settings = "integrator: rk4, step_s: 0.001, duration_s: 60";
        let motion = format!("position_m: [0, 0, 0.497], orientation_deg: [0.01, 0.02, 5], velocity_m_s: {velocity}");
        let text = dropped(settings, &motion, "");
        let scenario = kingpost::scenario::read(&text, "test.yaml", &[]).expect("it reads");
        let mut moving = scenario.simulation().expect("it builds");
        moving.step(20).expect("it moves");
        assert_eq!(values(&mut moving, "contact_points"), [4.0]);
        let linear = kingpost::analysis::Linearizer::new(&scenario).expect("it builds").at(&moving);
        let (h, scale) = (1e-7, linear.a.amax());
        let fingerprint = scenario.setup().expect("it builds").fingerprint;
        for k in 0..12 {
            let there = |by: f64| {
                let mut state = moving.state().clone();
                let mut xi = [0.0; 6];
                xi[k % 6] = by;
                if k < 6 {
                    state.q = moving.moved(&state.q, &xi);
                } else {
                    state.v[k - 6] += by;
                }
                let mut there = moving.clone();
                there.restore(&state.snapshot(fingerprint)).expect("a state of its own");
                there.acceleration(None).expect("accelerations")
            };
            let [ahead, behind] = [there(h), there(-h)];
            for row in 0..6 {
                let (difference, exact) = ((ahead[row] - behind[row]) / (2.0 * h), linear.a[(6 + row, k)]);
                assert!(
                    (exact - difference).abs() < 1e-6 * scale,
                    "{velocity}, row {row}, by {k}: {exact} {difference}"
                );
            }
        }
    }
}
