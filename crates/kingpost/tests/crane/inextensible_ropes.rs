//! Ropes that do not stretch, against closed forms, conservation laws, the bordered equations and very stiff ropes.

use super::ropes::{crane_in_space, ledger};
use crate::common;

use common::{INTEGRATORS, simulation, values};
use kingpost::simulation::RunError;

/// Free fall, m/s^2.
const GRAVITY: f64 = 9.80665;

/// The rope of the crane in free space, without its stiffness.
fn without_stretch(text: &str) -> String {
    text.replace("      axial_stiffness_N: 4e5\n      series_stiffness_N_per_m: 6e5\n", "")
}

/// A ball of 1 t that swings on a rope of a length from the origin, in the plane of x and z, without turning.
fn swinging_ball(rope: &str, start: &str, settings: &str) -> String {
    format!(
        "version: 1
title: A ball on a rope
simulation: {{{settings}}}
bodies:
  ball:
    mass_kg: 1000
    shape: {{point: {{}}}}
    joint: {{planar: {{normal: [0, -1, 0], x_axis: [1, 0, 0], {start}, rotation: {{mode: held}}}}}}
forces:
  gravity: {{gravity: {{acceleration_m_s2: {GRAVITY}}}}}
  rope: {{rope: {{path: [{{point: {{body: world}}}}, {{point: {{body: ball}}}}], {rope}}}}}
"
    )
}

/// A load and a counterweight on one rope over a sheave in the world.
fn atwood(masses: [f64; 2], more: &str) -> String {
    let body = |name: &str, x: f64, mass: f64| {
        format!(
            "  {name}: {{mass_kg: {mass}, shape: {{point: {{}}}}, joint: {{prismatic: {{name: {name}_z, position_m: [{x}, 0, 0], axis: [0, 0, 1]}}}}}}\n"
        )
    };
    format!(
        "version: 1
title: Two loads on one rope
simulation: {{step_s: 0.01, duration_s: 2}}
bodies:
{}{}forces:
  gravity: {{gravity: {{acceleration_m_s2: {GRAVITY}}}}}
  rope:
    rope:
      path:
        - point: {{body: load}}
        - sheave: {{body: world, position_m: [0, 0, 10], radius_m: 1, axis: [0, 1, 0]}}
        - point: {{body: counterweight}}
{more}",
        body("load", -1.0, masses[0]),
        body("counterweight", 1.0, masses[1]),
    )
}

#[test]
fn two_loads_on_one_rope_accelerate_by_the_difference_of_their_weights() {
    let [heavy, light] = [300.0, 200.0];
    let mut falling = simulation(&atwood([heavy, light], ""));
    falling.step(100).unwrap();
    let acceleration = (heavy - light) * GRAVITY / (heavy + light);
    let [down, up] = [falling.state().q[0], falling.state().q[1]];
    assert!((down + 0.5 * acceleration).abs() < 1e-12 && (up - 0.5 * acceleration).abs() < 1e-12, "{down} {up}");
    let tension = 2.0 * heavy * light * GRAVITY / (heavy + light);
    assert!((values(&mut falling, "rope_tension")[0] / tension - 1.0).abs() < 1e-13);
    assert!(values(&mut falling, "energy_error")[0].abs() < 1e-9);
}

#[test]
fn a_load_that_unwinds_a_drum_falls_by_the_drums_inertia() {
    // m a = m g - T and I a / R = T R, I = M R^2 / 2 of a solid drum.
    let text = format!(
        "version: 1
title: A load on a drum
simulation: {{step_s: 0.01, duration_s: 2}}
bodies:
  drum:
    mass_kg: 600
    shape: {{cylinder: {{radius_m: 0.5, length_m: 1, axis: y}}}}
    joint: {{revolute: {{name: winch, position_m: [-0.5, 0, 20], axis: [0, 1, 0]}}}}
  load: {{mass_kg: 1000, shape: {{point: {{}}}}, joint: {{prismatic: {{name: lift, axis: [0, 0, 1]}}}}}}
forces:
  gravity: {{gravity: {{acceleration_m_s2: {GRAVITY}}}}}
  hoist: {{rope: {{path: [{{drum: {{joint: winch, radius_m: 0.5}}}}, {{point: {{body: load}}}}]}}}}
"
    );
    let mut falling = simulation(&text);
    falling.step(100).unwrap();
    let acceleration = 1000.0 * GRAVITY / (1000.0 + 300.0);
    let lift = falling.state().q[1];
    assert!((lift + 0.5 * acceleration).abs() < 1e-12, "{lift}");
    let tension = 1000.0 * (GRAVITY - acceleration);
    assert!((values(&mut falling, "rope_tension")[0] / tension - 1.0).abs() < 1e-12);
    assert!((values(&mut falling, "rope_length")[0] - 20.0 - 0.5 * acceleration).abs() < 1e-12);
}

#[test]
fn a_crane_in_free_space_conserves_energy_and_momentum_while_its_rope_is_taut() {
    let (error, events) = ledger(&without_stretch(&crane_in_space("")), 140);
    // Its load comes towards the crane at first: the rope is slack, comes taut once and stays so.
    assert_eq!(events.iter().filter(|event| *event == "comes taut").count(), 1, "{events:?}");
    assert!(error < 1e-9, "{error:e}");
}

#[test]
fn recursion_and_bordered_matrices_give_the_same_motion() {
    // All that turns shares in J' q': the drum's carrier, the boom's sheave, the load's.
    let text =
        without_stretch(&crane_in_space("")).replace("integrator: dormand_prince, step_s: 0.01", "step_s: 0.002");
    let run = |form: &str| {
        let mut moving = simulation(&text.replace("simulation:\n  {", &format!("simulation:\n  {{form: {form}, ")));
        moving.step(500).unwrap();
        assert!(moving.events().iter().any(|event| event.what == "comes taut"));
        (values(&mut moving, "rope_tension")[0], moving.state().q.clone())
    };
    let ((tension, q), (by_matrices, other)) = (run("recursive"), run("moving_frame"));
    assert!(tension > 100.0 && (tension / by_matrices - 1.0).abs() < 1e-9, "{tension} {by_matrices}");
    assert!(q.iter().zip(&other).all(|(a, b)| (a - b).abs() < 1e-9), "{q:?} {other:?}");
}

#[test]
fn a_pendulum_on_an_inextensible_rope_keeps_its_length_and_energy_by_every_scheme() {
    for scheme in INTEGRATORS {
        // Of the first order the implicit ones of two.
        let step_s = if scheme.ends_with("euler") { 1e-4 } else { 2e-3 };
        let settings = format!("integrator: {scheme}, step_s: {step_s}, duration_s: 1");
        let text = swinging_ball(
            "unstretched_length_m: 5",
            "x: {initial_extension_m: 3}, y: {initial_extension_m: -4}",
            &settings,
        );
        let mut ball = simulation(&text);
        ball.step((1.0 / step_s) as usize).unwrap_or_else(|error| panic!("{scheme}: {error}"));
        let [x, z] = [ball.state().q[0], ball.state().q[1]];
        assert!((x.hypot(z) - 5.0).abs() < 1e-11, "{scheme}: {}", x.hypot(z));
        let error = values(&mut ball, "energy_error")[0] / (1000.0 * GRAVITY);
        let allowed = if scheme.ends_with("euler") { 5e-3 } else { 1e-4 };
        assert!(error.abs() < allowed, "{scheme}: {error:e}");
    }
}

#[test]
fn every_time_that_an_elastic_rope_comes_taut_is_a_snap() {
    let text = swinging_ball(
        "unstretched_length_m: 5, axial_stiffness_kN: 500, damping_time_s: 0",
        "x: {initial_extension_m: 0}, y: {initial_extension_m: -4, initial_speed_m_s: 0}",
        "step_s: 0.001, duration_s: 5",
    );
    let mut ball = simulation(&text);
    ball.step(5000).expect("it bounces");
    let taut = ball.events().iter().filter(|event| event.what == "comes taut").count();
    assert!(taut > 2 && values(&mut ball, "rope_snaps") == [taut as f64], "{taut}");
    ball.reset();
    assert_eq!(values(&mut ball, "rope_snaps"), [0.0]);
}

#[test]
fn a_rope_with_a_looping_ball_goes_slack_where_its_tension_vanishes() {
    // From below with v0^2 = 3.5 g l: T = m v^2 / l + m g cos = 0 where cos = -(v0^2 / (g l) - 2) / 3 = -1/2.
    let speed = (3.5 * GRAVITY * 5.0_f64).sqrt();
    let start = format!(
        "x: {{initial_extension_m: 0, initial_speed_m_s: {speed}}}, y: {{initial_extension_m: -5, initial_speed_m_s: 0}}"
    );
    let text = swinging_ball("", &start, "step_s: 0.001, duration_s: 3");
    let mut ball = simulation(&text);
    while ball.events().is_empty() {
        ball.step(1).unwrap();
    }
    assert_eq!(ball.events()[0].what, "goes slack");
    // It flies on by a parabola from 120 degrees: back to where it was.
    let (cos, sin) = (-0.5, 0.75_f64.sqrt());
    let at_event_v = (GRAVITY * 5.0 * 0.5).sqrt();
    let flown = ball.time_s() - ball.events()[0].time_s;
    let exact =
        [5.0 * sin + at_event_v * cos * flown, -5.0 * cos + at_event_v * sin * flown - 0.5 * GRAVITY * flown * flown];
    let found = &ball.state().q;
    // RK4 at 1 ms.
    assert!((found[0] - exact[0]).abs() < 1e-9 && (found[1] - exact[1]).abs() < 1e-9, "{found:?} {exact:?}");
}

#[test]
fn a_rope_that_becomes_taut_stops_the_motion_along_it_and_its_energy_becomes_heat() {
    // Thrown level at 2 m/s, 3 m below the origin: its rope of 5 m comes taut at 45 degrees or so and the ball swings on.
    let text = swinging_ball(
        "unstretched_length_m: 5",
        "x: {initial_extension_m: 0, initial_speed_m_s: 2}, y: {initial_extension_m: -3, initial_speed_m_s: 0}",
        "step_s: 0.001, duration_s: 3",
    );
    let mut ball = simulation(&text);
    let mut before = ball.state().clone();
    while ball.events().is_empty() {
        before = ball.state().clone();
        ball.step(1).unwrap();
    }
    assert_eq!(ball.events()[0].what, "comes taut");
    // A parabola until then.
    let flown = ball.events()[0].time_s;
    let (x, z, w) = (2.0 * flown, -3.0 - 0.5 * GRAVITY * flown * flown, -GRAVITY * flown);
    assert!((x.hypot(z) - 5.0).abs() < 2e-10, "{}", x.hypot(z));
    let along = (2.0 * x + w * z) / 5.0;
    let heat = 500.0 * along * along;
    assert!((values(&mut ball, "energy_dissipated")[0] / heat - 1.0).abs() < 1e-8, "{heat}");
    assert!(values(&mut ball, "energy_error")[0].abs() < 1e-9 * heat);
    let across = (2.0 * z - w * x) / 5.0;
    let now = ball.state();
    let swung = (now.v[0] * now.q[1] - now.v[1] * now.q[0]) / 5.0;
    let fallen = GRAVITY * x / 5.0 * (ball.time_s() - flown);
    assert!((swung - across - fallen).abs() < 1e-4, "{swung} {across} {fallen} {before:?}");
    // It does not rebound.
    ball.step(500).unwrap();
    assert_eq!(ball.events().len(), 1);
    assert_eq!(values(&mut ball, "rope_snaps"), [1.0]);
    assert!((ball.state().q[0].hypot(ball.state().q[1]) - 5.0).abs() < 1e-11);
}

#[test]
fn the_difference_from_an_inextensible_rope_is_ten_times_smaller_for_ten_times_the_stiffness() {
    // A stiff rope hangs lower by T l / EA and trembles about that by the centripetal force's change: of the order of 1 / EA.
    let end = |rope: &str| {
        let text = swinging_ball(
            rope,
            "x: {initial_extension_m: 3}, y: {initial_extension_m: -4}",
            "step_s: 0.0001, duration_s: 2",
        );
        let mut ball = simulation(&text);
        ball.step(10_000).unwrap();
        [ball.state().q[0], ball.state().q[1]]
    };
    let limit = end("unstretched_length_m: 5");
    let off = |stiffness: &str| {
        let there = end(&format!("unstretched_length_m: 5, axial_stiffness_N: {stiffness}, damping_time_s: 0.002"));
        (there[0] - limit[0]).hypot(there[1] - limit[1])
    };
    let offs = ["1e7", "1e8", "1e9"].map(off);
    // 2 m g l / EA.
    assert!(offs[2] < 2.0 * 1000.0 * GRAVITY * 5.0 / 1e9, "{offs:?}");
    assert!(offs[0] / offs[1] > 8.0 && offs[1] / offs[2] > 8.0, "{offs:?}");
}

#[test]
fn a_stiff_rope_without_rebound_becomes_taut_like_an_inextensible_one() {
    let start = "x: {initial_extension_m: 0, initial_speed_m_s: 2}, y: {initial_extension_m: -3, initial_speed_m_s: 0}";
    let end = |rope: &str| {
        let mut ball = simulation(&swinging_ball(rope, start, "step_s: 0.0001, duration_s: 2"));
        ball.step(10_000).unwrap();
        (ball.state().q.clone(), values(&mut ball, "kinetic_energy")[0])
    };
    let (limit, energy) = end("unstretched_length_m: 5");
    // Twice the damper that is critical, tau = 2 sqrt(m / k): no rebound.
    let stiffness: f64 = 1e9;
    let damping = 4.0 * (1000.0 * 5.0 / stiffness).sqrt();
    let (stiff, other) =
        end(&format!("unstretched_length_m: 5, axial_stiffness_N: {stiffness:e}, damping_time_s: {damping:e}"));
    // The ball goes on along the rope by v tau as it stops.
    let bound = 8.0 * damping;
    assert!((limit[0] - stiff[0]).hypot(limit[1] - stiff[1]) < bound, "{limit:?} {stiff:?}");
    assert!((energy / other - 1.0).abs() < bound, "{energy} {other}");
}

#[test]
fn a_rope_that_a_winch_lengthens_swings_by_its_length() {
    // Conical: with the rate of a prescribed drum, the length follows to rounding.
    let text = format!(
        "version: 1
title: A winch that pays out
simulation: {{step_s: 0.005, duration_s: 4}}
bodies:
  drum:
    mass_kg: 100
    shape: {{cylinder: {{radius_m: 0.5, length_m: 1, axis: y}}}}
    joint: {{revolute: {{name: winch, position_m: [-5, 0, 0], axis: [0, 1, 0], mode: {{prescribed: {{rate_rad_s: 1}}}}}}}}
  load: {{mass_kg: 1000, shape: {{sphere: {{radius_m: 0.5}}}}, joint: {{floating: {{initial: {{position_m: [1, 0, -10], velocity_m_s: [0, 1, 0]}}}}}}}}
forces:
  gravity: {{gravity: {{acceleration_m_s2: {GRAVITY}}}}}
  hoist: {{rope: {{path: [{{drum: {{joint: winch, radius_m: 0.5}}}}, {{point: {{body: world}}}}, {{point: {{body: load}}}}]}}}}
"
    );
    let mut swinging = simulation(&text);
    swinging.step(600).unwrap();
    let place = &swinging.state().q[1..4];
    let length = place.iter().map(|x| x * x).sum::<f64>().sqrt();
    assert!((length - 101.0_f64.sqrt() - 0.5 * 3.0).abs() < 1e-10, "{length}");
    assert!(values(&mut swinging, "rope_stretch")[0].abs() < 1e-11);
    // Only what RK4 leaves at 5 ms of some 1e5 J.
    let error = values(&mut swinging, "energy_error")[0];
    assert!(error.abs() < 1e-3, "{error}");
}

#[test]
fn loads_hang_at_rest_on_ropes_that_do_not_stretch() {
    // Two legs of 5 m from points 6 m apart, to one ball: T = W / (2 sin b), sin b = 4/5. It begins beside its place, on slack legs.
    let legs = |more: &str| {
        let text = swinging_ball(
            "unstretched_length_m: 5",
            "x: {initial_extension_m: 2.9}, y: {initial_extension_m: -3.5}",
            "step_s: 0.01, duration_s: 1, begin_at_equilibrium: true",
        );
        text.replace("forces:\n", &format!("forces:\n  other: {{rope: {{path: [{{point: {{body: world, position_m: [6, 0, 0]}}}}, {{point: {{body: ball}}}}], {more}}}}}\n"))
    };
    let mut hanging = simulation(&legs("unstretched_length_m: 5"));
    let tension = 1000.0 * GRAVITY / 1.6;
    for _ in 0..2 {
        let tensions = values(&mut hanging, "rope_tension");
        assert!(tensions.iter().all(|found| (found / tension - 1.0).abs() < 1e-9), "{tensions:?} {tension}");
        assert!((hanging.state().q[0] - 3.0).abs() < 1e-9 && (hanging.state().q[1] + 4.0).abs() < 1e-9);
        hanging.step(100).unwrap();
    }
    assert!(hanging.events().is_empty(), "{:?}", hanging.events());
    // A leg of 12 m hangs slack beside the other.
    let mut one = simulation(&legs("unstretched_length_m: 12"));
    assert!((one.state().q[0]).abs() < 1e-9 && (one.state().q[1] + 5.0).abs() < 1e-9, "{:?}", one.state().q);
    assert_eq!(values(&mut one, "rope_tension")[0], 0.0);
}

#[test]
fn two_ropes_that_carry_the_same_load_end_the_run_with_the_name_of_one() {
    let text = atwood([300.0, 200.0], "").replace(
        "forces:\n",
        "forces:
  beside: {rope: {path: [{point: {body: load}}, {sheave: {body: world, position_m: [0, 0, 10], radius_m: 1, axis: [0, 1, 0]}}, {point: {body: counterweight}}]}}\n",
    );
    let error = simulation(&text).step(1).expect_err("it is not determined");
    let RunError::UndeterminedRope { name, .. } = &error else { panic!("{error}") };
    assert_eq!(name, "rope");
    assert!(error.to_string().contains("allowed: more than 1e-10, or a rope with axial_stiffness_N"), "{error}");
}

#[test]
fn a_rope_that_is_released_lets_its_ball_fall() {
    let text = swinging_ball(
        "can_be_released: true",
        "x: {initial_extension_m: 0}, y: {initial_extension_m: -5}",
        "step_s: 0.01, duration_s: 1",
    );
    let mut held = simulation(&text);
    held.step(10).unwrap();
    assert_eq!(held.state().q[1], -5.0);
    held.set_input("rope", 1.0).unwrap();
    held.step(100).unwrap();
    assert!((held.state().q[1] + 5.0 + 0.5 * GRAVITY).abs() < 1e-12, "{:?}", held.state().q);
}

#[test]
fn exact_derivatives_of_a_held_motion_are_those_of_its_dual_numbers() {
    let base = swinging_ball(
        "unstretched_length_m: 5",
        "x: {initial_extension_m: 0, initial_speed_m_s: 2}, y: {initial_extension_m: -3, initial_speed_m_s: 0}",
        "step_s: 0.002, duration_s: 1.2, record_every_s: 1.2",
    );
    let scenario = |text: &str| kingpost::scenario::read(text, "ball.yaml", &[]).expect("it reads");
    let names = ["forces.rope.rope.unstretched_length_m", "bodies.ball.joint.planar.x.initial_speed_m_s"];
    let found = kingpost::analysis::gradient(&scenario(&base), &names, |_| true).expect("derivatives");
    let moving = simulation(&base);
    let offset = moving.channels().iter().find(|one| one.variable == "joint_position").expect("a channel").offset;
    for (which, (from, h)) in
        [("unstretched_length_m: 5", 1e-5), ("initial_speed_m_s: 2", 1e-5)].into_iter().enumerate()
    {
        let end = |by: f64| {
            let (words, number) = from.split_at(from.len() - 1);
            let number: f64 = number.parse().unwrap();
            let mut ball = simulation(&base.replace(from, &format!("{words}{}", number + by)));
            ball.step(600).unwrap();
            assert_eq!(ball.events().len(), 1);
            ball.state().q.clone()
        };
        let (ahead, behind) = (end(h), end(-h));
        let last = found.derivatives[which].len() - found.columns;
        for k in 0..2 {
            let difference = (ahead[k] - behind[k]) / (2.0 * h);
            let exact = found.derivatives[which][last + offset + k];
            assert!((exact - difference).abs() < 1e-4, "{which} {k}: {exact} {difference}");
        }
    }
}

#[test]
fn an_invalid_field_of_an_inextensible_rope_is_refused_at_its_place() {
    let refused = |rope: &str| {
        let text = swinging_ball(
            rope,
            "x: {initial_extension_m: 0}, y: {initial_extension_m: -5}",
            "step_s: 0.01, duration_s: 1",
        );
        kingpost::scenario::read(&text, "ball.yaml", &[]).expect_err("it is refused").to_string()
    };
    let short = refused("unstretched_length_m: 4.9");
    assert!(
        short.contains(
            "forces.rope.rope.unstretched_length_m: found 4.9 m, allowed: at least 5 m, the length of its path"
        ),
        "{short}"
    );
    let damped = refused("damping_time_s: 0.01");
    let parts = refused("breaking_load_N: 1e6");
    assert!(
        parts.contains("breaking_load_N: found 1000000, allowed: none for a rope without axial_stiffness_N"),
        "{parts}"
    );
    assert!(damped.contains("damping_time_s: found 0.01, allowed: 0 for a rope without axial_stiffness_N"), "{damped}");
}
