//! Mechanisms with closed loops: against closed forms and statics, for ten minutes, and at positions where
//! they cannot continue.

use crate::common;

use common::closed_forms::FourBar;
use common::{simulation, tied_ships, values};
use kingpost::scenario::read;
use kingpost::simulation::RunError;

const GRAVITY: f64 = 9.80665;

/// A crank-rocker in the x-z plane; angles from x towards z.
const LINKS: FourBar = FourBar { ground_m: 3.5, crank_m: 1.0, coupler_m: 3.0, rocker_m: 2.5 };

/// A four-bar linkage, cut open between coupler and rocker.
fn four_bar(crank: &str, constraints: &str, rest: &str) -> String {
    let FourBar { ground_m, crank_m, coupler_m, rocker_m } = LINKS;
    format!(
        "
version: 1
title: Four-bar linkage
simulation: {{step_s: 0.005, duration_s: 600, record_every_s: 1}}
bodies:
  crank:
    mass_kg: 1
    shape: {{box: {{length_m: {crank_m}, width_m: 0.1, height_m: 0.1}}}}
    joint: {{revolute: {{axis: [0, -1, 0], child_position_m: [-0.5, 0, 0], {crank}}}}}
  coupler:
    parent: crank
    mass_kg: 2
    shape: {{box: {{length_m: {coupler_m}, width_m: 0.1, height_m: 0.1}}}}
    joint: {{revolute: {{axis: [0, -1, 0], position_m: [0.5, 0, 0], child_position_m: [-1.5, 0, 0], initial_angle_rad: -0.4}}}}
  rocker:
    mass_kg: 3
    shape: {{box: {{length_m: {rocker_m}, width_m: 0.1, height_m: 0.1}}}}
    joint: {{revolute: {{axis: [0, -1, 0], position_m: [{ground_m}, 0, 0], child_position_m: [-1.25, 0, 0], initial_angle_rad: 1.8}}}}
loops:
  pin:
    first: {{body: coupler, position_m: [1.5, 0, 0]}}
    second: {{body: rocker, position_m: [1.25, 0, 0]}}
    constraints: [{constraints}]
    start_gap_m: 0.5
{rest}
"
    )
}

/// Returns the difference of two angles, without whole turns.
fn apart(a: f64, b: f64) -> f64 {
    let difference = a - b;
    difference.sin().atan2(difference.cos()).abs()
}

#[test]
fn a_four_bar_with_a_crank_at_constant_rate_follows_freudensteins_equation() {
    let crank = "initial_angle_rad: 1, mode: {prescribed: {rate_rad_s: 2}}";
    let gravity = "forces: {gravity: {gravity: {}}}";
    for form in ["recursive", "moving_frame"] {
        let mut simulation =
            simulation(&four_bar(crank, "x, z", gravity).replace("{step_s", &format!("{{form: {form}, step_s")));
        for step in 0..200 {
            let (q, v) = (simulation.state().q.clone(), simulation.state().v.clone());
            let ([coupler, rocker], rates) = LINKS.follow(q[0]);
            assert!(apart(q[0] + q[1], coupler) < 1e-11 && apart(q[2], rocker) < 1e-11, "{step}: {q:?}");
            let expected = [2.0, 2.0 * rates[0] - 2.0, 2.0 * rates[1]];
            assert!(v.iter().zip(expected).all(|(v, e)| (v - e).abs() < 1e-10), "{step}: {v:?} {expected:?}");
            simulation.step(5).unwrap();
        }
        // What the prescribed crank takes and gives is work: the ledger closes to the order of RK4.
        let (error, work) = (values(&mut simulation, "energy_error")[0], values(&mut simulation, "work_by_drives")[0]);
        assert!(error.abs() < 1e-6 && work.abs() > 1.0, "{form}: {error:e} J of {work} J");
    }
}

#[test]
fn a_loop_stays_closed_and_keeps_its_energy_for_ten_minutes() {
    let mut simulation = simulation(&four_bar("initial_angle_rad: 1", "x, z", "forces: {gravity: {gravity: {}}}"));
    let run = simulation.run(|_| true);
    assert_eq!(run.status, Ok(()));
    let largest = |variable: &str| {
        let channel = simulation.channels().iter().find(|channel| channel.variable == variable).unwrap();
        let rows = run.rows.chunks(run.columns).flat_map(|row| &row[channel.offset..][..channel.len]);
        rows.fold(0.0_f64, |most, value| most.max(value.abs()))
    };
    assert!(largest("loop_error") < 1e-11, "{:e} m", largest("loop_error"));
    // RK4 loses (omega h)^5 / 120 a radian, with rates of up to 12 rad/s over some 3000 rad.
    let (error, energy) = (largest("energy_error"), largest("kinetic_energy"));
    assert!(error < 1e-3 * energy, "{error:e} J of {energy} J");
}

#[test]
fn every_integrator_keeps_a_loop_closed() {
    let text = four_bar("initial_angle_rad: 1", "x, z", "forces: {gravity: {gravity: {}}}");
    // Energy after ten seconds: about rates of 10 rad/s times the step, to the power of the order.
    let schemes = [
        ("forward_euler", 0.0002, 2.0),
        ("midpoint_euler", 0.0002, 2.0),
        ("semi_implicit_euler", 0.0002, 2.0),
        ("rk4", 0.005, 1e-3),
        ("dormand_prince", 0.005, 1e-3),
        ("newmark", 0.002, 0.1),
        ("generalized_alpha", 0.002, 0.1),
        ("implicit_midpoint", 0.002, 0.1),
    ];
    for (scheme, step_s, allowed) in schemes {
        let settings = format!("{{integrator: {scheme}, step_s: {step_s}, duration_s: 10, record_every_s: 0.5}}");
        let text = text.replace("{step_s: 0.005, duration_s: 600, record_every_s: 1}", &settings);
        let mut simulation = simulation(&text);
        let run = simulation.run(|_| true);
        assert_eq!(run.status, Ok(()), "{scheme}");
        let gap = values(&mut simulation, "loop_error").iter().fold(0.0_f64, |most, gap| most.max(gap.abs()));
        let error = values(&mut simulation, "energy_error")[0].abs() / 70.0;
        assert!(gap < 1e-11 && error < allowed, "{scheme}: {gap:e} m, {error:e} of the energy");
    }
}

#[test]
fn a_state_from_outside_must_have_its_loops_closed() {
    let mut simulation = simulation(&four_bar("initial_angle_rad: 1", "x, z", ""));
    let (q, v) = (simulation.state().q.clone(), simulation.state().v.clone());
    simulation.set_state(&q, &v, None).unwrap();
    let error = simulation.set_state(&[q[0] + 0.01, q[1], q[2]], &v, None).unwrap_err().to_string();
    assert!(error.starts_with("q: found constraint pin.") && error.ends_with("less than 1e-6"), "{error}");
    assert_eq!(simulation.state().q, q);
}

#[test]
fn a_mass_on_a_rod_swings_as_on_a_hinge() {
    let text = "
version: 1
title: Two pendulums
simulation: {step_s: 0.002}
bodies:
  hinged: {mass_kg: 2, shape: {point: {}}, joint: {revolute: {axis: [0, 1, 0], child_position_m: [0, 0, 1.5], initial_angle_rad: 1.2}}}
  tied:
    mass_kg: 2
    shape: {sphere: {radius_m: 0.1}}
    joint: {floating: {initial: {position_m: [-1.398058628950340, 5, -0.5435366317150097]}}}
loops:
  rod: {first: {body: world, position_m: [0, 5, 0]}, second: {body: tied}, constraints: [distance: {length_m: 1.5}]}
forces: {gravity: {gravity: {}}}
";
    let mut simulation = simulation(text);
    for _ in 0..5 {
        simulation.step(200).unwrap();
        let position = values(&mut simulation, "position");
        let (hinged, tied) = (&position[..3], &position[3..]);
        assert!((hinged[0] - tied[0]).abs() + (hinged[2] - tied[2]).abs() < 1e-9, "{position:?}");
        // The rod carries the weight along it and the centripetal force: m g cos + m l angle'^2.
        let (q, v) = (simulation.state().q[0], simulation.state().v[0]);
        let force: f64 = values(&mut simulation, "loop_reaction")[..3].iter().map(|f| f * f).sum::<f64>().sqrt();
        assert!((force - 2.0 * (GRAVITY * q.cos() + 1.5 * v * v)).abs() < 1e-7, "{force}");
    }
    // What the world carries through the rod is in both momentum balances.
    assert!(values(&mut simulation, "momentum_error")[0] < 1e-7);
    assert!(values(&mut simulation, "linear_momentum_error")[0] < 1e-8);
}

#[test]
fn a_stay_carries_its_static_force_and_the_hinge_the_remainder() {
    // A level boom of 4 m and 100 kg hangs on a stay from its tip to 3 m above its hinge: moments
    // about the hinge give F sin(a) l = m g l / 2 with sin(a) = 3/5.
    let text = "
version: 1
title: A boom on its stay
bodies:
  boom: {mass_kg: 100, shape: {box: {length_m: 4, width_m: 1, height_m: 1}}, joint: {revolute: {axis: [0, 1, 0], child_position_m: [-2, 0, 0]}}}
loops:
  stay: {first: {body: world, position_m: [0, 0, 3]}, second: {body: boom, position_m: [2, 0, 0]}, constraints: [distance: {length_m: 5}]}
forces: {gravity: {gravity: {}}}
";
    let mut simulation = simulation(text);
    let (weight, force) = (100.0 * GRAVITY, values(&mut simulation, "loop_reaction"));
    let tension = 0.5 * weight / 0.6;
    let expected = [-0.8 * tension, 0.0, 0.6 * tension, 0.0, 0.0, 0.0];
    assert!(force.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9 * weight), "{force:?}");
    let hinge = values(&mut simulation, "joint_reaction");
    let expected = [0.8 * tension, 0.0, 0.5 * weight, 0.0, 0.0, 0.0];
    assert!(hinge.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9 * weight), "{hinge:?}");
}

#[test]
fn two_connected_ships_conserve_their_total_momentum() {
    let mut states = Vec::new();
    for form in ["recursive", "moving_frame"] {
        let mut simulation = simulation(&tied_ships(form));
        let start = [values(&mut simulation, "linear_momentum"), values(&mut simulation, "angular_momentum")];
        simulation.step(500).unwrap();
        let end = [values(&mut simulation, "linear_momentum"), values(&mut simulation, "angular_momentum")];
        // The projections and the reactions are pairs; the scheme alone errs, by its order.
        for (start, end, scale) in [(&start[0], &end[0], 1e3), (&start[1], &end[1], 1e3 * 5e3)] {
            assert!(start.iter().zip(end).all(|(a, b)| (a - b).abs() < 1e-9 * scale), "{start:?} {end:?}");
        }
        assert!(values(&mut simulation, "energy_error")[0].abs() < 1e-6);
        assert!(values(&mut simulation, "loop_error").iter().all(|gap| gap.abs() < 1e-11));
        states.push(simulation.state().clone());
    }
    let both = states[0].v.iter().zip(&states[1].v).chain(states[0].q.iter().zip(&states[1].q));
    assert!(both.into_iter().all(|(a, b)| (a - b).abs() < 1e-9));
}

fn error_of(text: &str) -> String {
    read(text, "test.yaml", &[]).map(drop).expect_err("this should be refused").to_string()
}

#[test]
fn dependent_constraints_are_refused_by_name() {
    let planar = error_of(&four_bar("initial_angle_rad: 1", "x, y, z", ""));
    assert!(planar.contains("loops.pin.constraints.1: found y, which no free coordinate can change"), "{planar}");
    let twice = error_of(&four_bar("initial_angle_rad: 1", "x, z, x", ""));
    assert!(twice.contains("loops.pin.constraints.2: found x, which depends on pin.x"), "{twice}");
    let held = four_bar("initial_angle_rad: 1, mode: held", "x, z, pitch", "");
    let driven = error_of(&held.replace("start_gap_m: 0.5", "start_gap_m: 3"));
    assert!(driven.contains("pitch, which depends on pin.x, pin.z"), "{driven}");
    let none = error_of(&four_bar("initial_angle_rad: 1", "", ""));
    assert!(none.contains("loops.pin.constraints: found an empty list"), "{none}");
}

#[test]
fn the_error_of_an_open_loop_contains_its_gap() {
    // The pin on the coupler stands at (cos 1 + 3 cos 0.6, sin 1 + 3 sin 0.6), the rocker's at
    // (3.5 + 2.5 cos 1.8, 2.5 sin 1.8); their way is told in the coupler's axes.
    let wide = four_bar("initial_angle_rad: 1", "x, z", "");
    let (x, z) = (0.5403023 + 3.0 * 0.8253356 - 3.5 + 2.5 * 0.2272021, 0.8414710 + 3.0 * 0.5646425 - 2.5 * 0.9738476);
    let (along, across) = (-(x * 0.8253356 + z * 0.5646425), -(-x * 0.5646425 + z * 0.8253356));
    let narrow = error_of(&wide.replace("start_gap_m: 0.5", "start_gap_m: 0.01"));
    let expected =
        format!("loops.pin: found a gap at the start of {along:.4} m in x, {across:.4} m in z, allowed: at most 0.01");
    assert!(narrow.contains(&expected), "{narrow}\n{expected}");
    // The rocker's pivot out of reach of crank, coupler and rocker: 1 + 3 + 2.5 m.
    let far = error_of(
        &wide
            .replace("position_m: [3.5, 0, 0]", "position_m: [7, 0, 0]")
            .replace("start_gap_m: 0.5", "start_gap_m: 10"),
    );
    assert!(far.contains("loops.pin: found a loop that stays open by"), "{far}");
}

#[test]
fn a_loop_driven_over_its_dead_centre_is_an_error_that_keeps_the_rows_before() {
    // A slider at constant speed draws a crank of 1 m and a rod of 2 m out straight at x = 3 m.
    let text = "
version: 1
title: Slider and crank
simulation: {step_s: 0.005, duration_s: 5}
bodies:
  crank: {mass_kg: 1, shape: {box: {length_m: 1, width_m: 0.1, height_m: 0.1}}, joint: {revolute: {axis: [0, -1, 0], child_position_m: [-0.5, 0, 0], initial_angle_rad: 1.5707963267948966}}}
  rod:
    parent: crank
    mass_kg: 2
    shape: {box: {length_m: 2, width_m: 0.1, height_m: 0.1}}
    joint: {revolute: {axis: [0, -1, 0], position_m: [0.5, 0, 0], child_position_m: [-1, 0, 0], initial_angle_rad: -2.0943951023931953}}
  slider: {mass_kg: 3, shape: {point: {}}, joint: {prismatic: {axis: [1, 0, 0], initial_extension_m: 1.7320508075688772, mode: {prescribed: {speed_m_s: 0.5}}}}}
loops:
  pin: {first: {body: slider}, second: {body: rod, position_m: [1, 0, 0]}, constraints: [x, z]}
";
    for form in ["recursive", "moving_frame"] {
        let mut simulation = simulation(&text.replace("{step_s", &format!("{{form: {form}, step_s")));
        let run = simulation.run(|_| true);
        match run.status {
            Err(RunError::SingularLoop { time_s, name, .. } | RunError::OpenLoop { time_s, name, .. }) => {
                assert!(name == "pin" && (time_s - (3.0 - 3.0_f64.sqrt()) / 0.5).abs() < 0.02, "{time_s}");
            }
            other => panic!("{other:?}"),
        }
        assert!(run.rows.len() > 200 * run.columns && run.rows.iter().all(|value| value.is_finite()));
    }
}

/// A crank of 1 m and a rod of 2 m, whose slider a spring and its speed move along x; dead centre is at 3 m.
fn slider_crank(integrator: &str, step_s: f64, slider: &str, rest: &str) -> String {
    // Crank and rod at the angles of a triangle of 1, 2 and 2.99 m.
    let extension = 2.99_f64;
    let crank = ((extension * extension - 3.0) / (2.0 * extension)).acos();
    let rod = -(crank.sin() / 2.0).asin() - crank;
    format!(
        "
version: 1
title: Slider and crank
simulation: {{integrator: {integrator}, step_s: {step_s}, duration_s: 5, dormand_prince: {{largest_step_s: {step_s}}}}}
bodies:
  crank: {{mass_kg: 1, shape: {{box: {{length_m: 1, width_m: 0.1, height_m: 0.1}}}}, joint: {{revolute: {{axis: [0, -1, 0], child_position_m: [-0.5, 0, 0], initial_angle_rad: {crank}}}}}}}
  rod:
    parent: crank
    mass_kg: 2
    shape: {{box: {{length_m: 2, width_m: 0.1, height_m: 0.1}}}}
    joint: {{revolute: {{axis: [0, -1, 0], position_m: [0.5, 0, 0], child_position_m: [-1, 0, 0], initial_angle_rad: {rod}}}}}
  slider: {{mass_kg: 3, shape: {{point: {{}}}}, joint: {{prismatic: {{axis: [1, 0, 0], initial_extension_m: {extension}, {slider}}}}}}}
loops:
  pin: {{first: {{body: slider}}, second: {{body: rod, position_m: [1, 0, 0]}}, constraints: [x, z]}}
{rest}
"
    )
}

/// Everything on which the next step depends is in the state: after a run that ended at a dead centre, a
/// simulation restored in any way is bitwise identical to one that was never there.
#[test]
fn a_dead_centre_has_no_effect_after_the_simulation_is_restored() {
    for integrator in common::INTEGRATORS {
        let text = slider_crank(integrator, 0.005, "mode: {prescribed: {speed_m_s: 0.5}}", "");
        let mut fresh = simulation(&text);
        let start = fresh.state().clone();
        let mut back = fresh.clone();
        let snapshot = back.snapshot();
        assert!(back.step(100).is_err(), "{integrator}: there is a dead centre 0.02 s ahead");
        fresh.step(2).expect("two steps before it");
        type Back = fn(&mut kingpost::Simulation, &kingpost::state::State, &[u8]);
        let ways: [(&str, Back); 3] = [
            ("reset", |simulation, _, _| simulation.reset()),
            ("restore", |simulation, _, snapshot| simulation.restore(snapshot).expect("its own")),
            ("set_state", |simulation, state, _| {
                simulation.reset();
                simulation.set_state(&state.q, &state.v, Some(&state.s)).expect("its own");
            }),
        ];
        for (way, put_back) in ways {
            put_back(&mut back, &start, &snapshot);
            back.step(2).unwrap_or_else(|error| panic!("{integrator}: {way}: {error}"));
            assert_eq!(back.state().q, fresh.state().q, "{integrator}: {way}");
            assert!(back.step(100).is_err());
        }
    }
}

/// Dormand-Prince's inner steps continue across the closing of loops after each step: the number of output
/// states hardly changes the number of evaluations, and the motion is equal within the tolerances.
#[test]
fn ten_times_as_many_output_states_need_few_additional_evaluations() {
    let run = |step_s: f64| {
        let settings = format!(
            "{{integrator: dormand_prince, step_s: {step_s}, duration_s: 2, dormand_prince: {{absolute_tolerance: 1.0e-7, relative_tolerance: 1.0e-7, largest_step_s: 0.1}}}}"
        );
        let text = four_bar("initial_angle_rad: 1", "x, z", "forces: {gravity: {gravity: {}}}");
        let mut simulation =
            simulation(&text.replace("{step_s: 0.005, duration_s: 600, record_every_s: 1}", &settings));
        simulation.step((2.0 / step_s).round() as usize).unwrap();
        let gap = values(&mut simulation, "loop_error").iter().fold(0.0_f64, |most, gap| most.max(gap.abs()));
        assert!(gap < 1e-11, "{gap:e} m");
        (simulation.evaluations(), simulation.state().q.clone())
    };
    let ((few, coarse), (many, fine)) = (run(0.02), run(0.002));
    assert!(many < few + few / 4, "{few} evaluations with 100 states, {many} with 1000");
    // Some hundred steps of 1e-7 each.
    let apart = coarse.iter().zip(&fine).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
    assert!(apart < 1e-5, "{apart:e}");
}
