//! Loads that slide, hold and roll on decks, against closed forms and a rigid crate.

use crate::common;

use super::contacts::{G, energy_error, times};
use common::{simulation, values};
use kingpost::simulation::Simulation;

/// A crate of 2 t on feet 0.5 m below its centre, on a plane at 20 degrees; gravity at rest is g.
fn slope(settings: &str, friction: &str, motion: &str) -> String {
    let (sin, cos) = 20.0_f64.to_radians().sin_cos();
    let rest = 2000.0 * G * cos / 4e7;
    let off = 0.5 - rest;
    format!(
        "version: 1
title: A crate on a tilted deck
simulation: {{{settings}}}
bodies:
  crate:
    mass_t: 2
    shape: {{box: {{length_m: 2, width_m: 1.5, height_m: 1}}}}
    joint: {{floating: {{initial: {{orientation_deg: [0, 20, 0], position_m: [{}, 0, {}]{motion}}}}}}}
forces:
  gravity: {{gravity: {{}}}}
  deck:
    contact:
      load: {{body: crate, shape: {{box: {{length_m: 2, width_m: 1.5, height_m: 1}}}}}}
      surface: {{body: world, orientation_deg: [0, 20, 0], shape: {{plane: {{}}}}}}
      stiffness_kN_per_m: 10000
      friction_coefficient: {friction}
",
        off * sin,
        off * cos
    )
}

/// Distance of the crate down the slope, m.
fn down(run: &Simulation) -> f64 {
    let (sin, cos) = 20.0_f64.to_radians().sin_cos();
    let q = &run.state().q;
    q[0] * cos - q[2] * sin
}

/// x = v t + g (sin - mu cos) t^2 / 2; before it slides, the bristles deflect by mu N / k, 0.1 mm.
#[test]
fn a_block_slides_down_a_slope_by_coulombs_law() {
    let (sin, cos) = 20.0_f64.to_radians().sin_cos();
    let motion = format!(", velocity_m_s: [{}, 0, {}]", cos, -sin);
    let mut sliding = simulation(&slope("integrator: rk4, step_s: 0.001, duration_s: 60", "0.25", &motion));
    sliding.step(3000).expect("it slides");
    let exact = 3.0 + 0.5 * G * (sin - 0.25 * cos) * 9.0;
    assert!((down(&sliding) / exact - 1.0).abs() < 2e-4, "{} {exact}", down(&sliding));
    let heat = values(&mut sliding, "energy_dissipated")[0];
    let rubbed = 0.25 * 2000.0 * G * cos * exact;
    assert!((heat / rubbed - 1.0).abs() < 5e-4, "{heat} {rubbed}");
    assert!(energy_error(&mut sliding, heat) < 1e-9);
}

/// mu = 0.4 is more than tan 20 degrees = 0.364. The crate rests on springs of 4 k, with a penetration of m g
/// cos / 4 k and a displacement of m g sin / 4 k, 0.17 mm, down the slope; in an hour it moves only by
/// rounding.
#[test]
fn a_block_below_the_angle_of_friction_holds_for_an_hour() {
    let settings = "integrator: rk4, step_s: 0.01, duration_s: 4000, begin_at_equilibrium: true";
    let mut resting = simulation(&slope(settings, "0.4", ""));
    let (sin, cos) = 20.0_f64.to_radians().sin_cos();
    let depth = values(&mut resting, "contact_penetration")[0];
    // The lower corners carry more, by the friction's moment mu h.
    assert!(depth > 2000.0 * G * cos / 4e7 && depth < 2.0 * 2000.0 * G * cos / 4e7, "{depth}");
    let before = down(&resting);
    assert!((before - 2000.0 * G * sin / 4e7).abs() < 2e-4, "{before}");
    resting.step(360_000).expect("it rests");
    assert!((down(&resting) - before).abs() < 1e-9, "{:e}", down(&resting) - before);
    assert!(times(&resting, "slides").is_empty());
}

/// A pipe that rolls without sliding: x = g sin t^2 / 3, with the inertia of a full cylinder.
#[test]
fn a_pipe_rolls_down_a_slope() {
    let (sin, cos) = 10.0_f64.to_radians().sin_cos();
    let off = 0.4 - 500.0 * G * cos / 2e8;
    let text = format!(
        "version: 1
title: A pipe
simulation: {{integrator: rk4, step_s: 0.0005, duration_s: 60}}
bodies:
  pipe:
    mass_kg: 500
    shape: {{cylinder: {{radius_m: 0.4, length_m: 3, axis: y}}}}
    joint: {{floating: {{initial: {{position_m: [{}, 0, {}]}}}}}}
forces:
  gravity: {{gravity: {{}}}}
  deck:
    contact:
      load: {{body: pipe, shape: {{cylinder: {{radius_m: 0.4, length_m: 3, axis: y}}}}}}
      surface: {{body: world, shape: {{plane: {{normal: [{sin}, 0, {cos}]}}}}}}
      stiffness_kN_per_m: 100000
      friction_coefficient: 0.5
",
        off * sin,
        off * cos
    );
    let mut rolling = simulation(&text);
    rolling.step(4000).expect("it rolls");
    let q = &rolling.state().q;
    let (down, exact) = (q[0] * cos - q[2] * sin, G * sin * 4.0 / 3.0);
    assert!((down / exact - 1.0).abs() < 1e-3, "{down} {exact}");
    assert!((rolling.state().v[4] * 0.4 / (G * sin * 2.0 * 2.0 / 3.0) - 1.0).abs() < 1e-3);
    assert!(energy_error(&mut rolling, 500.0 * G * exact * sin) < 1e-9);
}

/// A pipe stands on its end, and one that leans beyond its rim falls over.
#[test]
fn a_pipe_on_end_stands_or_falls() {
    let stands = |lean_deg: f64| {
        let text = format!(
            "version: 1
title: A pipe
simulation: {{integrator: rk4, step_s: 0.001, duration_s: 60}}
bodies:
  pipe:
    mass_kg: 500
    shape: {{cylinder: {{radius_m: 0.4, length_m: 3}}}}
    joint: {{floating: {{initial: {{position_m: [0, 0, {}], orientation_deg: [0, {lean_deg}, 0]}}}}}}
forces:
  gravity: {{gravity: {{}}}}
  deck:
    contact:
      load: {{body: pipe, shape: {{cylinder: {{radius_m: 0.4, length_m: 3}}}}}}
      surface: {{body: world, shape: {{plane: {{}}}}}}
      stiffness_kN_per_m: 20000
      friction_coefficient: 0.8
",
            1.5 * lean_deg.to_radians().cos() + 0.4 * lean_deg.to_radians().sin()
        );
        let mut leaning = simulation(&text);
        leaning.step(6000).expect("it moves");
        leaning.state().q[2]
    };
    // Its centre is over the rim at atan(0.4 / 1.5) = 14.9 degrees.
    assert!((stands(13.0) - 1.5).abs() < 0.05);
    assert!((stands(17.0) - 0.4).abs() < 0.1);
}

/// Rates of position, yaw and their rates of a rigid crate of 2 t that slides on three feet: the loads by
/// statics with friction 0.5 m below the centre, on each foot mu N against its slip.
fn on_three_feet([_, _, yaw, u, v, spin]: [f64; 6]) -> [f64; 6] {
    let (sin, cos) = yaw.sin_cos();
    let feet = [[1.0, 0.75], [1.0, -0.75], [-1.0, 0.0]].map(|[x, y]| [x * cos - y * sin, x * sin + y * cos]);
    let ways = feet.map(|[x, y]| {
        let [along, across] = [u - spin * y, v + spin * x];
        let speed = along.hypot(across).max(1e-12);
        [-0.3 * along / speed, -0.3 * across / speed]
    });
    let column = |k: usize| nalgebra::Vector3::new(1.0, feet[k][1] + 0.5 * ways[k][1], -0.5 * ways[k][0] - feet[k][0]);
    let statics = nalgebra::Matrix3::from_columns(&[0, 1, 2].map(column));
    let loads = statics.try_inverse().expect("three feet") * nalgebra::Vector3::new(2000.0 * G, 0.0, 0.0);
    let sum = |of: &dyn Fn(usize) -> f64| (0..3).map(|k| of(k) * loads[k]).sum::<f64>();
    let turn = sum(&|k| feet[k][0] * ways[k][1] - feet[k][1] * ways[k][0]);
    [u, v, spin, sum(&|k| ways[k][0]) / 2000.0, sum(&|k| ways[k][1]) / 2000.0, turn / 1041.6666666666667]
}

/// One Runge-Kutta step.
fn step(at: [f64; 6], by_s: f64) -> [f64; 6] {
    let moved = |rate: [f64; 6], by: f64| core::array::from_fn(|i| at[i] + by * rate[i]);
    let first = on_three_feet(at);
    let second = on_three_feet(moved(first, 0.5 * by_s));
    let third = on_three_feet(moved(second, 0.5 * by_s));
    let fourth = on_three_feet(moved(third, by_s));
    core::array::from_fn(|i| at[i] + by_s / 6.0 * (first[i] + 2.0 * (second[i] + third[i]) + fourth[i]))
}

/// Path and rotation are those of the rigid crate, except for its springs. MuJoCo agrees within 0.2 % of the
/// distance and 1 % of the rotation; sideways, where the crate moves 0.15 m, it differs by 4 cm from the
/// rigid crate's path.
#[test]
fn a_crate_on_three_feet_slides_and_spins_to_rest_as_a_rigid_one() {
    let peer: serde_json::Value =
        serde_json::from_str(include_str!("../../../../python/tests/peers/sliding_crate.json")).expect("JSON");
    let text = format!(
        "version: 1
title: A crate slides and spins to rest
simulation: {{integrator: rk4, step_s: 0.0005, duration_s: 60}}
bodies:
  crate:
    mass_t: 2
    inertia: {{tensor: {{moments_kg_m2: [541.6666666666666, 833.3333333333334, 1041.6666666666667]}}}}
    joint:
      floating:
        {{initial: {{position_m: [0, 0, {}], velocity_m_s: [3, 0, 0], angular_velocity_rad_s: [0, 0, 2.5]}}}}
forces:
  gravity: {{gravity: {{}}}}
  deck:
    contact:
      load: {{body: crate, shape: {{points: {{positions_m: [[1, 0.75, -0.5], [1, -0.75, -0.5], [-1, 0, -0.5]]}}}}}}
      surface: {{body: world, shape: {{plane: {{}}}}}}
      stiffness_kN_per_m: 100000
      restitution: 0.1
      restitution_speed_m_s: 0.1
      friction_coefficient: 0.3
",
        0.5 - 2000.0 * G / 3e8
    );
    let mut sliding = simulation(&text);
    let mut rigid = [0.0, 0.0, 0.0, 3.0, 0.0, 2.5];
    for row in peer["rows"].as_array().expect("rows").iter().skip(1) {
        sliding.step(200).expect("it slides");
        if row[0].as_f64().expect("a time") < 1.15 {
            (0..1000).for_each(|_| rigid = step(rigid, 1e-4));
        }
        let q = &sliding.state().q;
        let found = [q[0], q[1], 2.0 * q[6].atan2(q[3])];
        let of_peer = [1, 2, 3].map(|k| row[k].as_f64().expect("a number"));
        for (k, allowed) in [0.004, 0.04, 0.011].into_iter().enumerate() {
            assert!((found[k] - of_peer[k]).abs() < allowed, "{row}: {found:?}");
        }
        if row[0].as_f64().expect("a time") < 1.15 {
            assert!((0..3).all(|k| (found[k] - rigid[k]).abs() < 1e-4), "{row}: {found:?} {rigid:?}");
        }
    }
}

/// A crate starts to slide when the deck becomes slippery during a run: from then on x = g (sin - mu cos) t^2
/// / 2.
#[test]
fn a_block_at_rest_slides_when_its_friction_is_reduced_during_a_run() {
    let settings = "integrator: rk4, step_s: 0.001, duration_s: 60";
    let knob =
        "parameters:\n  - {name: mu, live: true, default: 0.4, writes: [forces.deck.contact.friction_coefficient]}\n";
    let text = slope(settings, "0.4", "").replacen("simulation:", &format!("{knob}simulation:"), 1);
    let mut scenario = kingpost::scenario::read(&text, "deck.yaml", &[]).expect("it reads");
    let mut moving = scenario.simulation().expect("it stands");
    moving.step(200).expect("it stands");
    let start = down(&moving);
    scenario.set_parameter(&mut moving, "mu", &serde_json::json!(0.1)).expect("it is live");
    moving.step(2000).expect("it slides");
    let (sin, cos) = 20.0_f64.to_radians().sin_cos();
    let exact = 0.5 * G * (sin - 0.1 * cos) * 4.0;
    let slid = down(&moving) - start;
    assert!((slid / exact - 1.0).abs() < 1e-3, "{slid} {exact}");
}

/// The equilibrium is the same over dual numbers: rows of a gradient are those of the run.
#[test]
fn a_gradient_from_an_equilibrium_on_friction_has_the_rows_of_the_run() {
    let settings = "integrator: rk4, step_s: 0.001, duration_s: 0.2, record_every_s: 0.1, begin_at_equilibrium: true";
    let text = slope(settings, "0.4", "");
    let scenario = kingpost::scenario::read(&text, "deck.yaml", &[]).expect("it reads");
    let found = kingpost::analysis::gradient(&scenario, &["bodies.crate.mass_kg"], |_| true).expect("a number");
    let run = simulation(&text).run(|_| true);
    let worst = found.rows.iter().zip(&run.rows).map(|(one, other)| (one - other).abs() / (1.0 + other.abs()));
    let worst = worst.fold(0.0, f64::max);
    assert!(worst < 1e-6, "{worst:e}");
}

/// Four corners touch in one step. A run over dual numbers has the events of a run, and velocities whose derivatives
/// are those of central differences, but for what a step of the scheme leaves at an event.
#[test]
fn a_block_that_lands_on_its_corners_has_derivatives() {
    let settings = "integrator: rk4, step_s: 0.0005, duration_s: 1, record_every_s: 1";
    let text = slope(settings, "0.4", ", velocity_m_s: [0.3, 0.1, -1]")
        .replace("initial: {orientation_deg: [0, 20, 0]", "initial: {orientation_deg: [0.01, 20.01, 0]")
        .replace("surface: {body: world,", "surface: {body: world, position_m: [0, 0, -0.01],");
    let read = |mass: f64| {
        let given = [("bodies.crate.mass_kg".to_owned(), mass.into())];
        kingpost::scenario::read(&text, "deck.yaml", &given).expect("it reads")
    };
    let land = |mass: f64| {
        let mut run = read(mass).simulation().expect("it builds");
        run.step(30).expect("it lands");
        run
    };
    let (mass, by) = (2000.0, 0.1);
    let mut found = Simulation::recursive(read(mass).setup_along(&["bodies.crate.mass_kg"]).expect("a number"));
    found.step(30).expect("it lands");
    let (plain, less, more) = (land(mass), land(mass - by), land(mass + by));
    assert_eq!(times(&plain, "touches").len(), 4);
    let what = |events: &[kingpost::simulation::EventRecord]| {
        events.iter().map(|event| event.what.clone()).collect::<Vec<_>>()
    };
    assert_eq!(what(found.events()), what(plain.events()));
    let difference = |i: usize| (more.state().v[i] - less.state().v[i]) / (2.0 * by);
    let largest = (0..6).map(|i| difference(i).abs()).fold(0.0, f64::max);
    for (i, rate) in found.state().v.iter().enumerate() {
        let (exact, difference) = (rate.derivative[0], difference(i));
        assert!((exact - difference).abs() < 1e-4 * largest, "{i}: {exact:e} {difference:e}");
    }
}

/// A box falls on a rough slope, lands on two corners at a time, and they begin to slide at one time too. Derivatives of the
/// dual numbers and central differences of positions come together as the step falls, by the scheme's fourth order. With the
/// delay of the second corner from the motion after the first one's response, they stayed 6e-5 apart.
#[test]
fn derivatives_through_simultaneous_events_converge_to_central_differences() {
    let gravity = "forces.gravity.gravity.acceleration_m_s2";
    let apart = |step_s: f64| {
        let text = format!(
            "version: 1
title: A box on a rough slope
simulation: {{integrator: rk4, step_s: {step_s}, duration_s: 0.5, record_every_s: 0.5}}
bodies:
  crate:
    mass_kg: 200
    shape: {{box: {{length_m: 1, width_m: 0.8, height_m: 0.6}}}}
    joint: {{floating: {{initial: {{position_m: [0, 0, 1]}}}}}}
forces:
  gravity: {{gravity: {{}}}}
  floor:
    contact:
      load: {{body: crate, shape: {{box: {{length_m: 1, width_m: 0.8, height_m: 0.6}}}}}}
      surface: {{body: world, shape: {{plane: {{normal: [0.2, 0, 1]}}}}}}
      stiffness_N_per_m: 1.0e5
      friction_coefficient: 0.4
"
        );
        let read = |g: f64| {
            let given = [(gravity.to_owned(), g.into())];
            kingpost::scenario::read(&text, "slope.yaml", &given).expect("it reads")
        };
        let run = |g: f64| read(g).simulation().expect("it builds").run(|_| true);
        let at_one_time = |events: &[kingpost::simulation::EventRecord]| {
            events.windows(2).filter(|pair| pair[0].time_s == pair[1].time_s && pair[0].what == pair[1].what).count()
        };
        assert!(at_one_time(&run(G).events) >= 2, "pairs of corners touch and slide");
        let along = kingpost::analysis::gradient(&read(G), &[gravity], |_| true).expect("a number");
        let position = along.channels.iter().find(|channel| channel.variable == "position").expect("a position");
        let last = along.rows.len() - along.columns + position.offset;
        let by = 1e-4;
        let (more, less) = (run(G + by), run(G - by));
        let difference = |k: usize| (more.rows[last + k] - less.rows[last + k]) / (2.0 * by);
        (0..3).map(|k| (along.derivatives[0][last + k] - difference(k)).abs()).fold(0.0, f64::max)
    };
    let (coarse, fine) = (apart(5e-4), apart(2.5e-4));
    assert!(fine < 3e-6 && fine < coarse / 8.0, "{coarse:e} {fine:e}");
}

/// A crate whose feet are exactly on the plane when the run begins, at 1 m/s along it. It settles into the plane by its weight, so
/// friction is mu N from the first instant: at any time mu times the impulse of N is the momentum that is lost.
#[test]
fn a_contact_that_begins_at_depth_zero_while_it_moves_slides() {
    for integrator in ["rk4", "implicit_midpoint"] {
        let text = format!(
            "version: 1
title: A crate that slides from the first instant
simulation: {{integrator: {integrator}, step_s: 0.0005, duration_s: 60}}
bodies:
  crate: {{mass_t: 2, shape: {{box: {{length_m: 2, width_m: 1.5, height_m: 1}}}}, joint: {{floating: {{initial: {{position_m: [0, 0, 0.5], velocity_m_s: [1, 0, 0]}}}}}}}}
forces:
  gravity: {{gravity: {{}}}}
  deck:
    contact:
      load: {{body: crate, shape: {{points: {{positions_m: [[-1, 0, -0.5], [1, 0, -0.5]]}}}}}}
      surface: {{body: world, shape: {{plane: {{}}}}}}
      stiffness_kN_per_m: 10000
      friction_coefficient: 0.3
"
        );
        let mut run = simulation(&text);
        assert_eq!(values(&mut run, "contact_penetration"), [0.0]);
        for _ in 0..300 {
            run.step(1).expect("it slides");
            let [normal, friction] =
                ["contact_normal_force", "contact_friction_force"].map(|name| values(&mut run, name)[0]);
            assert!(friction <= 0.3 * normal * (1.0 + 1e-6), "{integrator}: {friction} {normal}");
        }
        let lost = 2000.0 * (1.0 - run.state().v[0]);
        let by_hand = 0.3 * values(&mut run, "contact_impulse")[0];
        assert!((lost / by_hand - 1.0).abs() < 1e-3, "{integrator}: {lost} {by_hand}");
    }
}
