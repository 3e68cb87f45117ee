//! Loops that are released and engaged during a run, against closed forms and conservation laws.

use crate::common;

use common::{INTEGRATORS, simulation, values};
use kingpost::Simulation;
use kingpost::scenario::read;

/// Free fall, m/s^2.
const GRAVITY: f64 = 9.80665;

/// A bar of 600 kg and 4 m, hinged at its end to the world about y by a loop, which begins to fall from the horizontal.
fn trapdoor(settings: &str, rest: &str) -> String {
    format!(
        "version: 1
title: A bar that leaves its hinge
simulation: {{{settings}}}
bodies:
  bar:
    mass_kg: 600
    inertia: {{tensor: {{moments_kg_m2: [10, 800, 800]}}}}
    joint: {{floating: {{initial: {{position_m: [2, 0, 0]}}}}}}
loops:
  hinge:
    first: {{body: world}}
    second: {{body: bar, position_m: [-2, 0, 0]}}
    constraints: [x, y, z, roll, yaw]
    connection: {{}}
forces:
  gravity: {{gravity: {{acceleration_m_s2: {GRAVITY}}}}}
{rest}"
    )
}

const LETS_GO: &str = "operation:
  steps:
    - {name: falls, until: {after_s: 0.5}}
    - {name: lets go, set: [{input: hinge, to: 1}]}
";

/// Events of an element, each with its time.
fn told(found: &Simulation, element: &str) -> Vec<(f64, String)> {
    let own = found.events().iter().filter(|event| event.element == element);
    own.map(|event| (event.time_s, event.code.to_string())).collect()
}

#[test]
fn a_bar_that_leaves_its_hinge_keeps_its_velocities_and_falls() {
    let mut found = simulation(&trapdoor("step_s: 0.005, duration_s: 2", LETS_GO));
    found.step(100).expect("it swings");
    let (q, v) = (found.state().q.clone(), found.state().v.clone());
    // The moment of inertia about the hinge is 800 + 600 * 2^2; the energy is that of the fall of the centre.
    let rate = v[4];
    assert!((0.5 * 3200.0 * rate * rate + 600.0 * GRAVITY * q[2]).abs() < 1e-3, "{q:?} {v:?}");
    assert!((values(&mut found, "connection_engaged")[0] - 1.0).abs() < f64::EPSILON);
    found.step(200).expect("it flies");
    assert_eq!(told(&found, "hinge"), [(0.5, "released".to_owned())]);
    // Free flight for 1 s: the velocity of the centre is in body axes.
    let now = found.state();
    assert!((now.v[4] - rate).abs() < 1e-12);
    let centre = |q: &[f64]| [q[0], q[2]];
    let [x, z] = centre(&q);
    let turned = (-z).atan2(x);
    let speed = 2.0 * rate.abs();
    let [vx, vz] = [-speed * turned.sin(), -speed * turned.cos()];
    let [x_after, z_after] = centre(&now.q);
    assert!((x_after - (x + vx)).abs() < 1e-9 && (z_after - (z + vz - 0.5 * GRAVITY)).abs() < 1e-9);
    assert!(values(&mut found, "energy_error")[0].abs() < 1e-4);
    assert_eq!(values(&mut found, "connection_reaction"), [0.0; 6]);
    assert_eq!(values(&mut found, "energy_dissipated"), [0.0]);
}

#[test]
fn the_reaction_of_a_connection_is_that_of_a_loop_by_both_forms_of_the_equations() {
    let loops = trapdoor("step_s: 0.005, duration_s: 2", "").replace("    connection: {}\n", "");
    let mut closed = simulation(&loops);
    closed.step(100).expect("it swings");
    let expected = values(&mut closed, "loop_reaction");
    for form in ["recursive", "moving_frame"] {
        let mut found = simulation(&trapdoor(&format!("step_s: 0.005, duration_s: 2, form: {form}"), ""));
        found.step(100).expect("it swings");
        for (a, b) in values(&mut found, "connection_reaction").iter().zip(&expected) {
            // Weights of 6 kN; the two solvers differ by rounding.
            assert!((a - b).abs() < 1e-7, "{form}: {a} {b}");
        }
        for (a, b) in found.state().q.iter().zip(&closed.state().q) {
            assert!((a - b).abs() < 1e-12, "{form}: {a} {b}");
        }
    }
}

#[test]
fn a_connection_holds_and_lets_go_by_every_scheme() {
    for scheme in INTEGRATORS {
        let mut found = simulation(&trapdoor(&format!("step_s: 0.001, duration_s: 2, integrator: {scheme}"), LETS_GO));
        found.step(450).expect("it swings");
        let q = &found.state().q;
        assert!((q[0].hypot(q[2]) - 2.0).abs() < 1e-9 && q[1].abs() < 1e-12, "{scheme}: {q:?}");
        found.step(300).expect("it flies");
        assert!(values(&mut found, "connection_distance")[0] > 0.1, "{scheme}");
        let told = told(&found, "hinge");
        assert!(told.len() == 1 && (told[0].0 - 0.5).abs() < 1e-9, "{scheme}: {told:?}");
    }
}

/// A bar of 300 kg that spins at 2 rad/s about its centre, at rest in the world, and a ball of 100 kg beside its end that moves
/// past it at 3 m/s; both are free.
fn catch(constraints: &str, connection: &str) -> String {
    format!(
        "version: 1
title: A ball that is caught
simulation: {{step_s: 0.01, duration_s: 4}}
bodies:
  bar:
    mass_kg: 300
    inertia: {{tensor: {{moments_kg_m2: [5, 100, 100]}}}}
    joint: {{floating: {{initial: {{position_m: [10, 2, 0], angular_velocity_rad_s: [0, 0, 2]}}}}}}
  ball:
    mass_kg: 100
    inertia: {{tensor: {{moments_kg_m2: [4, 4, 4]}}}}
    joint: {{floating: {{initial: {{position_m: [11.5, 2.4, 0.3], velocity_m_s: [0, -3, 0]}}}}}}
loops:
  grip:
    first: {{body: bar, position_m: [1.5, 0, 0]}}
    second: {{body: ball}}
    constraints: {constraints}
    connection: {connection}
operation:
  steps:
    - {{name: free, until: {{after_s: 0.1}}}}
    - {{name: grip, set: [{{input: grip, to: 0}}]}}
"
    )
}

const ALL: &str = "[x, y, z, roll, pitch, yaw]";

/// Linear momentum, and angular momentum about the origin.
fn momenta(found: &mut Simulation) -> Vec<f64> {
    [values(found, "linear_momentum"), values(found, "angular_momentum")].concat()
}

#[test]
fn two_bodies_that_lock_move_on_as_one_with_their_momenta() {
    let mut found = simulation(&catch(ALL, "{begins_released: true, engages: where_it_is}"));
    let before = momenta(&mut found);
    let energy = values(&mut found, "kinetic_energy")[0];
    found.step(10).expect("it is free");
    let position = values(&mut found, "position");
    found.step(1).expect("it is one");
    assert_eq!(told(&found, "grip"), [(0.1, "engages".to_owned())]);
    let after = momenta(&mut found);
    for (a, b) in after.iter().zip(&before) {
        // A step of rk4: 0.02 rad to the fifth power, of 3,000 N m s.
        assert!((a - b).abs() < 1e-7, "{after:?} {before:?}");
    }
    // As one body: mass 400 kg at the speed of its centre, and its tensor about that with the momentum about it.
    let way: Vec<f64> = (0..3).map(|k| position[3 + k] - position[k]).collect();
    let reduced = 300.0 * 100.0 / 400.0;
    let squared = way.iter().map(|x| x * x).sum::<f64>();
    // At 0.1 s the bar has turned by 0.2 rad.
    let (sine, cosine) = 0.2_f64.sin_cos();
    let bar = [
        [5.0 * cosine * cosine + 100.0 * sine * sine, (5.0 - 100.0) * sine * cosine, 0.0],
        [(5.0 - 100.0) * sine * cosine, 5.0 * sine * sine + 100.0 * cosine * cosine, 0.0],
        [0.0, 0.0, 100.0],
    ];
    let tensor = nalgebra::Matrix3::from_fn(|i, j| {
        let of_ball = if i == j { 4.0 + reduced * squared } else { 0.0 };
        bar[i][j] + of_ball - reduced * way[i] * way[j]
    });
    let centre: Vec<f64> = (0..3).map(|k| position[k] + way[k] * 0.25).collect();
    let [px, py, pz] = [before[0], before[1], before[2]];
    let about = nalgebra::Vector3::new(
        before[3] - (centre[1] * pz - centre[2] * py),
        before[4] - (centre[2] * px - centre[0] * pz),
        before[5] - (centre[0] * py - centre[1] * px),
    );
    let omega = tensor.try_inverse().expect("a body") * about;
    let left = 0.5 * about.dot(&omega) + 0.5 * (px * px + py * py + pz * pz) / 400.0;
    assert!((values(&mut found, "kinetic_energy")[0] / left - 1.0).abs() < 1e-9);
    assert!((values(&mut found, "energy_dissipated")[0] - (energy - left)).abs() < 1e-9 * energy);
    assert!(values(&mut found, "energy_error")[0].abs() < 1e-9 * energy);
    // The impulse on the ball is the change of its momentum.
    let velocity_of_ball: Vec<f64> = {
        let turning = omega.cross(&nalgebra::Vector3::new(way[0] * 0.75, way[1] * 0.75, way[2] * 0.75));
        (0..3).map(|k| before[k] / 400.0 + turning[k]).collect()
    };
    let impulse = values(&mut found, "connection_impulse");
    // In axes of the bar as it engaged.
    let changed = [velocity_of_ball[0] * 100.0, (velocity_of_ball[1] + 3.0) * 100.0, velocity_of_ball[2] * 100.0];
    let expected = [cosine * changed[0] + sine * changed[1], -sine * changed[0] + cosine * changed[1], changed[2]];
    for k in 0..3 {
        assert!((impulse[k] - expected[k]).abs() < 1e-9 * 400.0, "{impulse:?} {expected:?}");
    }
}

#[test]
fn a_hook_connects_when_its_eye_comes_within_the_tolerance() {
    let text = catch("[x, y, z]", "{begins_released: true, engages: {within: {distance_m: 0.05, angle_rad: 0.1}}}")
        .replace("angular_velocity_rad_s: [0, 0, 2]", "angular_velocity_rad_s: [0, 0, 0]")
        .replace("11.5, 2.4, 0.3", "11.5, 3.5, 0.03");
    let mut found = simulation(&text);
    found.step(100).expect("it is caught");
    // 0.03 m aside: within 0.05 m when 0.04 m ahead; 1.5 m at 3 m/s.
    let told = told(&found, "grip");
    assert_eq!((told[0].0, told[0].1.as_str()), (0.1, "out_of_tolerance"));
    assert!((told[1].0 - (1.5 - 0.04) / 3.0).abs() < 1e-9 && told[1].1 == "engages" && told.len() == 2, "{told:?}");
    assert!((values(&mut found, "connection_distance")[0] - 0.05).abs() < 1e-9);
    // A point mass of 1 / (1 / m + r^2 / I) moves at the end of the bar.
    let at_end = 1.0 / (1.0 / 300.0 + 1.5 * 1.5 / 100.0);
    let expected = 3.0 / (1.0 / at_end + 1.0 / 100.0);
    // The ball is held off its centre, 0.04 and 0.03 m: it turns, and the impulse is smaller by its share.
    let impulse = values(&mut found, "connection_impulse")[1];
    assert!((impulse / expected - 1.0).abs() < 0.02 && impulse > 0.0, "{impulse} {expected}");
}

#[test]
fn a_lock_stops_a_turning_arm_where_it_is_and_lets_it_go_again() {
    let text = "version: 1
title: A slewing lock
simulation: {step_s: 0.01, duration_s: 4}
bodies:
  arm:
    mass_kg: 100
    inertia: {tensor: {moments_kg_m2: [50, 50, 50]}}
    joint: {revolute: {name: slew, axis: [0, 0, 1], initial_rate_rad_s: 0.8}}
loops:
  lock:
    first: {body: world}
    second: {body: arm}
    constraints: [yaw]
    connection: {begins_released: true, engages: where_it_is}
";
    let mut found = simulation(text);
    found.step(250).expect("it turns");
    assert!((found.state().q[0] - 2.0).abs() < 1e-12);
    found.set_input("lock", 0.0).expect("a lever");
    found.step(100).expect("it rests");
    assert!((found.state().q[0] - 2.0).abs() < 1e-12 && found.state().v[0].abs() < 1e-12);
    let impulse = values(&mut found, "connection_impulse");
    assert!((impulse[5] + 50.0 * 0.8).abs() < 1e-9, "{impulse:?}");
    assert!((values(&mut found, "energy_dissipated")[0] - 0.5 * 50.0 * 0.64).abs() < 1e-9);
    found.set_input("lock", 1.0).expect("a lever");
    let told = told(&found, "lock");
    assert_eq!(told, [(2.5, "engages".to_owned()), (3.5, "released".to_owned())]);
    // A restart from the present state holds it as before.
    found.set_input("lock", 0.0).expect("a lever");
    let copy = found.clone();
    found.step(50).expect("it rests");
    let mut again = copy;
    again.step(50).expect("it rests");
    assert_eq!(found.state(), again.state());
}

#[test]
fn exact_derivatives_pass_through_a_release_and_an_impact() {
    let caught = catch(ALL, "{begins_released: true, engages: where_it_is}").replace("step_s: 0.01", "step_s: 0.005");
    let hinge = trapdoor("step_s: 0.005, duration_s: 1", LETS_GO);
    let cases = [
        (&caught, "bodies.ball.mass_kg", "mass_kg: 100", 100.0, 800),
        (&hinge, "bodies.bar.mass_kg", "mass_kg: 600", 600.0, 200),
        (&hinge, "loops.hinge.second.position_m.0", "second: {body: bar, position_m: [-2", -2.0, 200),
    ];
    for (text, name, from, value, steps) in cases {
        let scenario = read(text, "test.yaml", &[]).expect("it reads");
        let found = kingpost::analysis::gradient(&scenario, &[name], |_| true).expect("derivatives");
        let last = found.derivatives[0].len() - found.columns;
        let end = |by: f64| {
            let digits = format!("{value}");
            let changed = from.strip_suffix(digits.as_str()).expect("the value is last");
            let mut moving = simulation(&text.replace(from, &format!("{changed}{}", value + by)));
            moving.step(steps).expect("a motion");
            let mut row = Vec::new();
            moving.write_row(&mut row);
            row
        };
        let h = 1e-4 * value.abs();
        let (ahead, behind) = (end(h), end(-h));
        for k in 0..found.columns {
            let difference = (ahead[k] - behind[k]) / (2.0 * h);
            let exact = found.derivatives[0][last + k];
            // Differences: h^2 of a third derivative, and rounding of 1e-13 of numbers up to 1e4 over h.
            let allowed = 1e-6 * (1.0 + difference.abs());
            assert!((exact - difference).abs() < allowed, "{name}, column {k}: {exact} {difference}");
        }
    }
}

#[test]
fn a_connection_that_begins_engaged_rests_at_its_equilibrium() {
    // A beam that hangs from two hinges, of which one is a connection: each carries half of the weight.
    let text = format!(
        "version: 1
title: A beam between two hinges
simulation: {{step_s: 0.01, duration_s: 1, begin_at_equilibrium: true}}
bodies:
  link: {{mass_kg: 10, shape: {{sphere: {{radius_m: 0.1}}}}, centre_of_mass_m: [0, 0, -2],
    joint: {{revolute: {{name: link, axis: [0, 1, 0], position_m: [0, 0, 0], initial_angle_rad: 0.1}}}}}}
  beam:
    mass_kg: 600
    inertia: {{tensor: {{moments_kg_m2: [10, 800, 800]}}}}
    joint: {{floating: {{initial: {{position_m: [2, 0, -2]}}}}}}
loops:
  hinge:
    first: {{body: link, position_m: [0, 0, -2]}}
    second: {{body: beam, position_m: [-2, 0, 0]}}
    constraints: [x, y, z, roll, yaw]
    connection: {{}}
    start_gap_m: 0.5
  end:
    first: {{body: world, position_m: [4, 0, -2]}}
    second: {{body: beam, position_m: [2, 0, 0]}}
    constraints: [z]
forces:
  gravity: {{gravity: {{acceleration_m_s2: {GRAVITY}}}}}
"
    );
    let mut found = simulation(&text);
    let reaction = values(&mut found, "connection_reaction");
    let along = reaction[0].hypot(reaction[2]);
    assert!((along - 300.0 * GRAVITY).abs() < 1e-3, "{reaction:?}");
    found.step(100).expect("it rests");
    assert!(found.state().v.iter().all(|v| v.abs() < 1e-6), "{:?}", found.state().v);
}

#[test]
fn a_connection_whose_constraint_moves_nothing_ends_the_run_with_its_name() {
    for (axis, constraint) in [([1, 2, 3], "x"), ([0, 0, 1], "z"), ([0, 0, 1], "roll")] {
        let text = format!(
            "version: 1
title: A lock that holds nothing
simulation: {{step_s: 0.01, duration_s: 4}}
bodies:
  arm:
    mass_kg: 100
    centre_of_mass_m: [1.3, 0.2, 0.4]
    inertia: {{tensor: {{moments_kg_m2: [50, 50, 50]}}}}
    joint: {{revolute: {{name: slew, axis: {axis:?}, initial_rate_rad_s: 0.8}}}}
loops:
  lock:
    first: {{body: world}}
    second: {{body: arm, position_m: [1, 0.3, 0.7]}}
    constraints: [{constraint}]
    connection: {{begins_released: true, engages: where_it_is}}
"
        );
        let mut found = simulation(&text);
        found.step(50).expect("it turns");
        found.set_input("lock", 0.0).expect("a lever");
        let error = found.step(10).expect_err("nothing to hold").to_string();
        assert!(error.contains(&format!("constraint {constraint} of loop lock")), "{error}");
        // Engaged at the start, it is refused before the run.
        let refused = read(&text.replace("begins_released: true, ", ""), "test.yaml", &[]).expect_err("it is refused");
        assert!(refused.to_string().contains("loops.lock.constraints.0"), "{refused}");
    }
}

#[test]
fn a_state_that_is_set_keeps_a_connection_where_it_engaged() {
    let mut found = simulation(&catch(ALL, "{begins_released: true, engages: where_it_is}"));
    found.step(50).expect("it is one");
    let (q, v) = (found.state().q.clone(), found.state().v.clone());
    found.set_state(&q, &v, None).expect("its own state");
    let energy = values(&mut found, "kinetic_energy")[0];
    found.step(100).expect("it is one");
    // rk4: 0.02 rad to the fifth power in each of 100 steps.
    let left = values(&mut found, "kinetic_energy")[0] / energy - 1.0;
    assert!(left.abs() < 3e-7, "{left}");
    assert!(values(&mut found, "energy_error")[0].abs() < 3e-7 * energy);
}

#[test]
fn an_impact_on_a_prescribed_motion_books_heat_and_work_of_its_drive() {
    // A trolley of 100 kg at 3 m/s takes a block of 300 kg along: the drive works twice what becomes heat.
    let text = "version: 1
title: A trolley takes a block along
simulation: {step_s: 0.01, duration_s: 1}
bodies:
  trolley:
    mass_kg: 100
    shape: {point: {}}
    joint: {prismatic: {name: trolley, axis: [1, 0, 0], mode: {prescribed: {speed_m_s: 3}}}}
  block: {mass_kg: 300, shape: {point: {}}, joint: {prismatic: {name: block, axis: [1, 0, 0]}}}
loops:
  grip:
    first: {body: trolley}
    second: {body: block}
    constraints: [x]
    connection: {begins_released: true, engages: where_it_is}
";
    let mut found = simulation(text);
    found.step(10).expect("it moves");
    found.set_input("grip", 0.0).expect("a lever");
    assert!((values(&mut found, "connection_impulse")[0] - 900.0).abs() < 1e-9);
    assert!((values(&mut found, "energy_dissipated")[0] - 1350.0).abs() < 1e-9);
    found.step(10).expect("they move");
    assert!(values(&mut found, "energy_error")[0].abs() < 1e-9);
}

#[test]
fn what_cannot_be_released_or_engaged_is_refused_at_its_place() {
    let refused = |text: &str| read(text, "test.yaml", &[]).expect_err("it is refused").to_string();
    let fixed = refused(&trapdoor("step_s: 0.005, duration_s: 2", LETS_GO).replace("    connection: {}\n", ""));
    assert!(fixed.contains("operation.steps.1.set.0.input") && fixed.contains("connection"), "{fixed}");
    let rod = trapdoor("step_s: 0.005, duration_s: 2", "").replace("[x,", "[{distance: {length_m: 2}},");
    let rod = refused(&rod);
    assert!(rod.contains("loops.hinge.constraints.0: found distance, in a loop with connection"), "{rod}");
    let twice = trapdoor("step_s: 0.005, duration_s: 2", "").replace("x, y", "x, x");
    assert!(refused(&twice).contains("loops.hinge.constraints.1"), "{twice}");
    let shared = "  hinge:
    rope: {path: [{point: {body: world}}, {point: {body: bar}}], axial_stiffness_kN: 1000, can_be_released: true}
";
    let shared = refused(&trapdoor("step_s: 0.005, duration_s: 2", shared));
    assert!(shared.contains("loops.hinge: found hinge, the name of another input"), "{shared}");
    let far = refused(&trapdoor("step_s: 0.005, duration_s: 2", "").replace("[-2, 0, 0]", "[-3, 0, 0]"));
    assert!(far.contains("loops.hinge: found a gap at the start of"), "{far}");
}

#[test]
fn a_connection_that_engages_against_its_joints_ends_the_run_with_its_name() {
    let text = "version: 1
title: Two locks of one arm
simulation: {step_s: 0.01, duration_s: 4}
bodies:
  arm: {mass_kg: 100, shape: {sphere: {radius_m: 1}}, joint: {revolute: {name: slew, axis: [0, 0, 1]}}}
loops:
  first: {first: {body: world}, second: {body: arm}, constraints: [yaw]}
  second:
    first: {body: world}
    second: {body: arm}
    constraints: [yaw]
    connection: {begins_released: true, engages: where_it_is}
operation: {steps: [{name: wait, until: {after_s: 1}}, {name: lock, set: [{input: second, to: 0}]}]}
";
    let mut found = simulation(text);
    let error = found.step(400).expect_err("twice locked").to_string();
    assert!(error.contains("constraint yaw of loop second"), "{error}");
}
