//! Ropes that are released, or part as they become taut, and lines of constant tension.

use crate::common;

use common::{simulation, values};
use kingpost::scenario::read;

/// Free fall, m/s^2.
const GRAVITY: f64 = 9.80665;

/// A load of 2 t that hangs at rest on a rope of 400 kN/m from a bar of 6 t, which a spring carries.
fn hoist(rest: &str) -> String {
    format!(
        "version: 1
title: A load on a hook
simulation: {{step_s: 0.001, duration_s: 1, begin_at_equilibrium: true}}
bodies:
  bar:
    mass_kg: 6000
    shape: {{point: {{}}}}
    joint: {{prismatic: {{name: spring, axis: [0, 0, 1], spring: {{stiffness_N_per_m: 2e6}}}}}}
  load:
    mass_kg: 2000
    shape: {{sphere: {{radius_m: 0.5}}}}
    joint: {{floating: {{initial: {{position_m: [0, 0, -10]}}}}}}
forces:
  gravity: {{gravity: {{acceleration_m_s2: {GRAVITY}}}}}
  hook:
    rope:
      path: [{{point: {{body: bar}}}}, {{point: {{body: load}}}}]
      unstretched_length_m: 10
      axial_stiffness_N: 4e6
      can_be_released: true
{rest}"
    )
}

const RELEASED: &str = "operation:
  steps:
    - {name: hold, until: {after_s: 0.25}}
    - {name: release, set: [{input: hook, to: 1}]}
";

#[test]
fn a_released_load_falls_and_its_support_springs_up_by_the_weight() {
    let mut found = simulation(&hoist(RELEASED));
    assert!((values(&mut found, "rope_tension")[0] - 2000.0 * GRAVITY).abs() < 1e-4);
    let height = |found: &mut kingpost::Simulation| values(found, "position")[5];
    let start = height(&mut found);
    found.step(1000).expect("it falls");
    assert!(found.events().iter().any(|event| (event.time_s, event.what.as_ref()) == (0.25, "is released")));
    let fallen = 0.75_f64;
    assert!((start - height(&mut found) - 0.5 * GRAVITY * fallen * fallen).abs() < 1e-6);
    assert_eq!(values(&mut found, "rope_tension"), [0.0]);
    // x'' = -w^2 (x - x0) with x0 above the start by m g / k.
    let (stiffness, omega) = (2e6, (2e6 / 6000.0_f64).sqrt());
    let up = 2000.0 * GRAVITY / stiffness * (1.0 - (omega * fallen).cos());
    let at_rest = -8000.0 * GRAVITY / stiffness;
    assert!((values(&mut found, "joint_position")[0] - at_rest - up).abs() < 1e-6);
    // The strain energy of the rope, T^2 / (2 k), became heat.
    let strain = (2000.0 * GRAVITY).powi(2) / (2.0 * 4e5);
    assert!((values(&mut found, "energy_dissipated")[0] / strain - 1.0).abs() < 1e-6);
    assert!(values(&mut found, "energy_error")[0].abs() < 1e-6 * strain);
}

#[test]
fn a_load_released_by_a_user_stays_released() {
    let mut found = simulation(&hoist(""));
    found.step(100).expect("it hangs");
    found.set_input("hook", 1.0).expect("it is a lever");
    found.step(100).expect("it falls");
    found.set_input("hook", 0.0).expect("it is a lever");
    found.step(100).expect("it falls");
    assert_eq!(values(&mut found, "rope_tension"), [0.0]);
    let told: Vec<(f64, &str)> = found.events().iter().map(|event| (event.time_s, event.what.as_ref())).collect();
    assert_eq!(told, [(0.1, "is released")]);
    assert!(found.warnings().is_empty());
    // After a reset it hangs again.
    found.reset();
    found.step(300).expect("it hangs");
    assert!((values(&mut found, "rope_tension")[0] - 2000.0 * GRAVITY).abs() < 1e-3);
}

/// A load of 2 t stands on a stiff table under a hook that moves up at 0.5 m/s; its sling of 2 m is connected
/// while the hook is 1.5 m above it.
fn pick_up(rest: &str) -> String {
    format!(
        "version: 1
title: A load that is hooked on and lifted
simulation: {{step_s: 0.001, duration_s: 6}}
bodies:
  hook:
    mass_kg: 100
    shape: {{point: {{}}}}
    joint: {{prismatic: {{name: hoist, axis: [0, 0, 1], position_m: [0, 0, 3], initial_extension_m: 0,
      mode: {{prescribed: {{speed_m_s: 0.5}}}}}}}}
  load:
    mass_kg: 2000
    shape: {{sphere: {{radius_m: 0.5}}}}
    joint: {{prismatic: {{name: table, axis: [0, 0, 1], position_m: [0, 0, 1.5], spring: {{stiffness_N_per_m: 1e6}}}}}}
forces:
  gravity: {{gravity: {{acceleration_m_s2: {GRAVITY}}}}}
  sling:
    rope:
      path: [{{point: {{body: hook}}}}, {{point: {{body: load}}}}]
      unstretched_length_m: 2
      axial_stiffness_N: 4e6
      can_be_released: true
      begins_released: true
{rest}"
    )
}

fn of_the_sling(found: &kingpost::Simulation) -> Vec<(f64, &str)> {
    let events = found.events().iter().filter(|event| event.element == "sling");
    events.map(|event| (event.time_s, event.what.as_ref())).collect()
}

const HOOKED: &str = "operation:
  steps:
    - {name: lower, until: {after_s: 0.25}}
    - {name: hook on, set: [{input: sling, to: 0}]}
";

/// The table's spring stretches by v t after the sling becomes taut; the sling is k = 2e6 N/m.
#[test]
fn a_rope_is_connected_slack_and_pulls_once_it_is_taut() {
    let mut found = simulation(&pick_up(HOOKED));
    found.step(300).expect("it runs");
    assert_eq!(of_the_sling(&found), [(0.25, "is hooked on")]);
    assert_eq!(values(&mut found, "rope_tension"), [0.0]);
    found.step(4700).expect("it runs");
    let (comes_taut, what) = of_the_sling(&found)[1];
    assert_eq!(what, "comes taut");
    // The load oscillates about m g / k of the table, 0.0196 m below; at rest it would be at 1 s.
    assert!((comes_taut - 1.0).abs() < 0.1, "{comes_taut}");
    let stretch = values(&mut found, "rope_stretch")[0];
    assert!((values(&mut found, "rope_tension")[0] - 2e6 * stretch.max(0.0)).abs() < 1e-3);
    assert!(values(&mut found, "energy_error")[0].abs() < 1e-6 * 2000.0 * GRAVITY);
}

#[test]
fn a_rope_out_of_reach_is_connected_once_it_reaches() {
    // The hook goes down from 3 m above to 1.5 m: in reach of 2 m at 2 s.
    let text = pick_up(HOOKED)
        .replace("initial_extension_m: 0", "initial_extension_m: 1.5")
        .replace("speed_m_s: 0.5", "speed_m_s: -0.5");
    let text = text.replace("joint: {prismatic: {name: table", "joint: {prismatic: {mode: held, name: table");
    let mut found = simulation(&text);
    found.step(1900).expect("it runs");
    assert_eq!(of_the_sling(&found), []);
    found.step(200).expect("it runs");
    let (hooked, what) = of_the_sling(&found)[0];
    assert_eq!(what, "is hooked on");
    assert!((hooked - 2.0).abs() < 1e-9, "{hooked}");
}

#[test]
fn a_parted_rope_cannot_be_connected_again() {
    // The hook rises at 1 m/s: the tension would reach m g + v sqrt(k m) = 83 kN.
    let again = "    - {name: see it part, until: {after_s: 0.5}}
    - {name: release, set: [{input: sling, to: 1}], until: {after_s: 0.25}}
    - {name: hook on again, set: [{input: sling, to: 0}]}
";
    let text = pick_up(
        &format!("{HOOKED}{again}")
            .replace("to: 0}]}\n    - {name: see", "to: 0}], until: {after_s: 0.25}}\n    - {name: see"),
    );
    let text = text.replace("speed_m_s: 0.5", "speed_m_s: 1");
    let mut found =
        simulation(&text.replace("begins_released: true", "begins_released: true\n      breaking_load_N: 5e4"));
    found.step(1500).expect("it parts");
    let told: Vec<&str> = of_the_sling(&found).into_iter().map(|(_, what)| what).collect();
    assert_eq!(told, ["is hooked on", "comes taut", "parts"]);
}

#[test]
fn a_rope_that_starts_released_has_a_length_and_can_be_connected() {
    let error = read(&pick_up("").replace("unstretched_length_m: 2\n", "\n"), "pick_up.yaml", &[])
        .expect_err("no length")
        .to_string();
    assert!(error.contains("forces.sling.rope.unstretched_length_m: found nothing, allowed: a length"), "{error}");
    let error = read(&pick_up("").replace("      can_be_released: true\n", ""), "pick_up.yaml", &[])
        .expect_err("never hooked")
        .to_string();
    assert!(error.contains("forces.sling.rope.begins_released: found true, allowed: false, or"), "{error}");
}

/// After a fall of 1 m at 4.4 m/s a damper of 20 ms makes 2.5e5 * 0.02 * 4.4 = 22 kN at once.
#[test]
fn a_rope_parted_by_its_damper_as_it_becomes_taut_reports_the_cause() {
    let text = format!(
        "version: 1
title: A load that falls into its rope
simulation: {{step_s: 0.001, duration_s: 1}}
bodies:
  load:
    mass_kg: 2000
    shape: {{sphere: {{radius_m: 0.5}}}}
    joint: {{floating: {{initial: {{position_m: [0, 0, -19]}}}}}}
forces:
  gravity: {{gravity: {{acceleration_m_s2: {GRAVITY}}}}}
  fall:
    rope:
      path: [{{point: {{body: world}}}}, {{point: {{body: load}}}}]
      unstretched_length_m: 20
      axial_stiffness_N: 5e6
      breaking_load_N: 15000
      damping_time_s: 0.02
"
    );
    let mut found = simulation(&text);
    found.step(1000).expect("it falls");
    let [taut, parts] = found.events() else { panic!("{:?}", found.events()) };
    assert_eq!((taut.what.as_ref(), parts.what.as_ref()), ("comes taut", "parts"));
    assert!((parts.time_s - (2.0 / GRAVITY).sqrt()).abs() < 1e-9 && taut.time_s == parts.time_s);
    let warnings = found.warnings();
    let [warning] = warnings.as_slice() else { panic!("{warnings:?}") };
    assert_eq!((warning.name.as_str(), warning.time_s), ("fall", parts.time_s));
    assert_eq!(warning.text, "parts: its tension has reached its breaking load");
    assert!((found.acceleration(None).unwrap()[2] + GRAVITY).abs() < 1e-12);
}

/// `a = (m g - u T / R) / (m + I / R^2)` once the brake has lost all but the share u of its torque T.
#[test]
fn a_winch_whose_brake_fails_lets_its_load_run_away() {
    let text = format!(
        "version: 1
title: A winch on its brake
simulation: {{step_s: 0.001, duration_s: 3}}
bodies:
  load:
    mass_kg: 1000
    shape: {{point: {{}}}}
    joint: {{prismatic: {{name: lift, position_m: [0, 0, -20], axis: [0, 0, 1]}}}}
  drum:
    mass_kg: 200
    inertia: {{tensor: {{moments_kg_m2: [20, 25, 20]}}}}
    joint: {{revolute: {{name: winch, position_m: [-0.5, 0, 0], axis: [0, 1, 0]}}}}
forces:
  gravity: {{gravity: {{acceleration_m_s2: {GRAVITY}}}}}
  fall:
    rope:
      path: [{{drum: {{joint: winch, radius_m: 0.5}}}}, {{point: {{body: load}}}}]
      axial_stiffness_N: 1e8
      damping_time_s: 0.02
drives:
  holding: {{brake: {{joint: winch, torque_N_m: 10000, smoothing_rad_s: 0.2, state: lever}}}}
operation:
  steps:
    - {{name: the brake holds, set: [{{input: holding, to: 1}}], until: {{after_s: 2}}}}
    - {{name: the brake fails, set: [{{input: holding, to: 0.2}}]}}
"
    );
    let mut found = simulation(&text);
    found.step(2000).expect("it holds");
    // The brake's friction comes with a slow slip: m g R = T w / sqrt(w^2 + w_s^2).
    let creeps = found.state().v[0];
    let share = 1000.0 * GRAVITY * 0.5 / 10_000.0;
    let slip = 0.2 * share / (1.0 - share * share).sqrt();
    assert!((creeps / (-0.5 * slip) - 1.0).abs() < 1e-3, "{creeps} m/s");
    found.step(500).expect("it runs");
    let runs = found.state().v[0];
    found.step(500).expect("it runs");
    let acceleration = (found.state().v[0] - runs) / 0.5;
    let exact = -(1000.0 * GRAVITY - 0.2 * 10_000.0 / 0.5) / (1000.0 + 25.0 / 0.25);
    // From 5 rad/s on, (w_s / w)^2 / 2 = 8e-4 of the friction is not there.
    assert!((acceleration / exact - 1.0).abs() < 1e-3, "{acceleration} m/s^2, {exact}");
}

#[test]
fn a_rope_that_can_be_released_needs_a_unique_name() {
    let drive = "drives: {hook: {linear_motor: {joint: spring, force_N: 1, history: lever}}}\n";
    let error = read(&hoist(drive), "hoist.yaml", &[]).expect_err("two inputs of one name").to_string();
    assert!(error.contains("forces.hook.rope.can_be_released: found true, with an input hook"), "{error}");
}

/// A cart of 500 kg on a slide along x that a tugger line pulls over a sheave, from a winch below it.
fn cart(efficiency: f64, rate: f64) -> String {
    format!(
        "version: 1
title: A tugger line
simulation: {{step_s: 0.001, duration_s: 2}}
bodies:
  cart:
    mass_kg: 500
    shape: {{point: {{}}}}
    joint: {{prismatic: {{name: slide, axis: [1, 0, 0], initial_extension_m: -20, initial_speed_m_s: {rate}}}}}
forces:
  tugger:
    tugger_line:
      path:
        - point: {{body: world, position_m: [0.3, 0, -5]}}
        - sheave: {{body: world, position_m: [0, 0, -0.3], radius_m: 0.3, axis: [0, -1, 0],
            efficiency_hoisting: {efficiency}, efficiency_lowering: {efficiency}}}
        - point: {{body: cart}}
      tension_kN: 3
"
    )
}

#[test]
fn a_tugger_line_pulls_with_its_tension_however_fast_the_load_moves() {
    for rate in [0.0, 3.0, -3.0] {
        let mut found = simulation(&cart(1.0, rate));
        assert_eq!(values(&mut found, "winch_tension"), [3000.0]);
        found.step(1000).expect("it moves");
        // The line runs level: x'' = T / m.
        let exact = [-20.0 + rate + 0.5 * 6.0, rate + 6.0];
        let [place, speed] = [found.state().q[0], found.state().v[0]];
        assert!((place - exact[0]).abs() < 1e-9 && (speed - exact[1]).abs() < 1e-9, "{place} {speed}");
        assert!((values(&mut found, "tugger_pay_out_rate")[0] + speed).abs() < 1e-9);
        assert!(values(&mut found, "energy_error")[0].abs() < 1e-6);
    }
}

#[test]
fn the_winch_carries_the_friction_of_the_sheaves_which_becomes_heat() {
    let mut found = simulation(&cart(0.95, 2.0));
    found.step(1000).expect("it moves");
    let way = found.state().q[0] + 20.0;
    // The winch hauls: it pulls by 1 / 0.95 more than the load feels.
    assert!((values(&mut found, "winch_tension")[0] / (3000.0 / 0.95) - 1.0).abs() < 1e-5);
    let heat = (3000.0 / 0.95 - 3000.0) * way;
    let dissipated = values(&mut found, "energy_dissipated")[0];
    assert!((dissipated / heat - 1.0).abs() < 1e-4, "{dissipated} {heat}");
    assert!(values(&mut found, "energy_error")[0].abs() < 1e-6);
}

/// A load of 2 t on a rod of 20 m, between two level lines of 1000 m along its swing.
const SWING: &str = "
version: 1
title: Tugger lines that damp a swing
simulation: {step_s: 0.01, duration_s: 60}
bodies:
  load:
    mass_kg: 2000
    shape: {point: {}}
    joint: {revolute: {axis: [0, -1, 0], child_position_m: [0, 0, 20], initial_angle_rad: 0.001}}
forces:
  gravity: {gravity: {acceleration_m_s2: 9.80665}}
  ahead: {tugger_line: {path: [{point: {body: world, position_m: [1000, 0, -20]}}, {point: {body: load}}], tension_N: 5000, damping_N_s_per_m: 150}}
  astern: {tugger_line: {path: [{point: {body: world, position_m: [-1000, 0, -20]}}, {point: {body: load}}], tension_N: 5000, damping_N_s_per_m: 150}}
";

#[test]
fn two_tugger_lines_along_a_swing_damp_it_by_their_damping_over_the_mass() {
    // m x'' + 2 c x' + (m g / l + f) x = 0. The lines' constant tensions cancel along the swing; as the load rises they pull
    // it up and down by T / 1000 m, of second order.
    let (mass, damping): (f64, f64) = (2000.0, 2.0 * 150.0);
    let sigma = damping / (2.0 * mass);
    let w = (GRAVITY / 20.0 - sigma * sigma).sqrt();
    let mut found = simulation(SWING);
    for _ in 0..6 {
        found.step(1000).expect("it swings");
        let t = found.time_s();
        let exact = 1e-3 * (-sigma * t).exp() * ((w * t).cos() + sigma / w * (w * t).sin());
        let angle = found.state().q[0];
        // The angle's own square is 1e-6 of it.
        assert!((angle - exact).abs() < 2e-6 * 1e-3 * t.max(1.0), "{t} s: {angle}, not {exact}");
        assert!(values(&mut found, "energy_error")[0].abs() < 1e-9);
    }
    let lost = values(&mut found, "work_by_drives")[0];
    assert!(lost < -0.9 * 0.5 * mass * GRAVITY * 20.0 * 1e-6, "{lost} J");
}

#[test]
fn the_tension_of_a_tugger_line_is_between_zero_and_its_maximum() {
    for (rate, expected) in [(0.01, 5150.0), (0.2, 7000.0), (-0.5, 0.0)] {
        let text = SWING.replace("damping_N_s_per_m: 150", "damping_N_s_per_m: 15000, largest_tension_N: 7000");
        let text = text.replace("initial_angle_rad: 0.001", &format!("initial_rate_rad_s: {}", rate / 20.0));
        let tensions = values(&mut simulation(&text), "winch_tension");
        // About -y the angle moves the load towards +x: the line astern pays out.
        assert!((tensions[1] - expected).abs() < 1e-6, "{rate} m/s: {tensions:?}");
    }
    let text = SWING.replacen("damping_N_s_per_m: 150", "largest_tension_N: 4000", 1);
    let error =
        read(&text, "swing.yaml", &[]).and_then(|scenario| scenario.setup()).expect_err("too little").to_string();
    let expected = "forces.ahead.tugger_line.largest_tension_N: found 4000, allowed: at least tension_N, 5000 N";
    assert!(error.contains(expected), "{error}");
}

#[test]
fn a_mistake_in_a_tugger_line_is_refused_at_its_place() {
    let cases = [
        (
            "- point: {body: world, position_m: [0.3, 0, -5]}",
            "- drum: {joint: slide, radius_m: 0.3}",
            "path.0: found a drum",
        ),
        ("axis: [0, -1, 0]", "axis: [0, 1, 0]", "path.1.sheave.axis: found a rope that turns by"),
        (
            "position_m: [0.3, 0, -5]",
            "position_m: [0, 0, -0.3]",
            "path.1: found a place 0.0000 m from the place before it",
        ),
        ("tension_kN: 3", "tension_kN: -3", "tension_kN: found -3"),
    ];
    for (from, to, expected) in cases {
        let text = cart(1.0, 0.0);
        assert!(text.contains(from), "{from}");
        let error = read(&text.replacen(from, to, 1), "cart.yaml", &[]).and_then(|scenario| scenario.setup());
        let error = error.expect_err("a mistake").to_string();
        assert!(error.contains(expected), "{error}");
    }
}
