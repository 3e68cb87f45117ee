//! Drives that follow set-points within limits of speed, acceleration, jerk, torque and power.

use crate::common;

use common::{simulation, values};

/// Free fall, m/s^2.
const GRAVITY: f64 = 9.80665;

/// A lift of 1 t on a vertical slide, and its drive.
fn lift(set_point: &str, limits: &str) -> String {
    format!(
        "version: 1
title: A lift
simulation: {{step_s: 0.01, duration_s: 60}}
bodies:
  cage:
    mass_kg: 1000
    shape: {{point: {{}}}}
    joint: {{prismatic: {{name: lift, axis: [0, 0, 1]}}}}
forces: {{gravity: {{gravity: {{acceleration_m_s2: {GRAVITY}}}}}}}
drives:
  hoist:
    linear_controlled_drive:
      {{joint: lift, set_point: {{{set_point}}}, speed_limit_m_s: 2, acceleration_limit_m_s2: 0.5, {limits},
        stiffness_N_per_m: 4e6, damping_N_s_per_m: 1.6e5}}
"
    )
}

const STRONG: &str = "force_limit_kN: 50";

/// Returns position and velocity: m, m/s.
fn state(text: &str, time_s: f64) -> [f64; 2] {
    let mut moving = simulation(text);
    moving.step((time_s / 0.01).round() as usize).expect("it moves");
    [moving.state().q[0], moving.state().v[0]]
}

#[test]
fn a_speed_is_reached_at_the_limit_of_acceleration_and_held() {
    let text = lift("speed: {speed_m_s: 1.5}", STRONG);
    // Until the way to the speed wanted takes less than the response time of 0.1 s the speed is a t; the rest is an exponential.
    assert!((state(&text, 2.0)[1] - 1.0).abs() < 1e-3);
    let [place, speed] = state(&text, 10.0);
    assert!((speed - 1.5).abs() < 1e-9, "{speed}");
    // The reference has gone v t - v^2 / (2 a) - a T^2 / 2; what it carries hangs lower by m g / k.
    let exact = 1.5 * 10.0 - 1.5 * 1.5 / (2.0 * 0.5) - 0.5 * 0.5 * 0.01 - 1000.0 * GRAVITY / 4e6;
    assert!((place - exact).abs() < 1e-5, "{place} {exact}");
    // Beyond its limit a speed is that limit.
    assert!((state(&lift("speed: {speed_m_s: 7}", STRONG), 20.0)[1] - 2.0).abs() < 1e-9);
}

#[test]
fn a_position_is_reached_without_overshoot_and_within_the_limits() {
    for (limits, jerk) in [(STRONG.to_owned(), None), (format!("{STRONG}, jerk_limit_m_s3: 0.8"), Some(0.8))] {
        for way in [8.0, 0.05, -3.0_f64] {
            let mut moving = simulation(&lift(&format!("position: {{extension_m: {way}}}"), &limits));
            let mut before = [0.0, 0.0];
            for _ in 0..3000 {
                moving.step(1).expect("it moves");
                let reference = &moving.state().s[moving.state().s.len() - if jerk.is_some() { 3 } else { 2 }..];
                let [speed, acceleration] = [reference[1], (reference[1] - before[0]) / 0.01];
                assert!(speed.abs() <= 2.0 + 1e-9 && acceleration.abs() <= 0.5 + 1e-9, "{speed} {acceleration}");
                if let Some(jerk) = jerk {
                    assert!((acceleration - before[1]).abs() <= jerk * 0.01 + 1e-9);
                }
                assert!(reference[0] * way.signum() <= way.abs() * (1.0 + 1e-3), "{} of {way}", reference[0]);
                before = [speed, acceleration];
            }
            let place = moving.state().q[0] + 1000.0 * GRAVITY / 4e6;
            assert!((place - way).abs() < 1e-4, "{place} of {way}");
        }
    }
}

#[test]
fn a_drive_that_is_too_weak_is_overhauled_at_full_utilisation() {
    let mut weak = simulation(&lift("speed: {speed_m_s: 1}", "force_limit_kN: 8"));
    weak.step(100).expect("it falls");
    let before = weak.state().v[0];
    weak.step(200).expect("it falls");
    let faster = (8000.0 / 1000.0 - GRAVITY) * 2.0;
    assert!((weak.state().v[0] - before - faster).abs() < 1e-9, "{}", weak.state().v[0]);
    assert_eq!(values(&mut weak, "drive_effort_utilisation"), [1.0]);
    // In the step in which the limit is reached the power bends from one that grows by c g v; v is 5 cm/s there at most.
    let (bend, step_s) = (1.6e5 * GRAVITY * 0.05, 0.01);
    let error = values(&mut weak, "energy_error")[0];
    assert!(error.abs() < bend * step_s * step_s, "{error:e}");
}

#[test]
fn power_bounds_the_speed_of_a_hoist_and_not_its_braking() {
    let limits = "force_limit_kN: 50, power_limit_kW: 9.80665";
    let mut hoisting = simulation(&lift("speed: {speed_m_s: 2}", limits));
    hoisting.step(3000).expect("it rises");
    // P = m g v.
    assert!((hoisting.state().v[0] - 1.0).abs() < 1e-6, "{}", hoisting.state().v[0]);
    assert!((values(&mut hoisting, "drive_power_utilisation")[0] - 1.0).abs() < 1e-9);
    let mut lowering = simulation(&lift("speed: {speed_m_s: -2}", limits));
    lowering.step(3000).expect("it sinks");
    assert!((lowering.state().v[0] + 2.0).abs() < 1e-9);
}

/// `F = 2 (W + m a)` for a winch that hoists its load on two falls: the drum turns 2 v / r.
#[test]
fn a_winch_hoists_a_load_on_two_falls_at_the_commanded_speed() {
    let text = format!(
        "version: 1
title: A winch
simulation: {{step_s: 0.002, duration_s: 60}}
bodies:
  load:
    mass_kg: 4000
    shape: {{sphere: {{radius_m: 0.6}}}}
    joint: {{floating: {{initial: {{position_m: [0, 0, -20]}}}}}}
  drum:
    mass_kg: 200
    shape: {{cylinder: {{radius_m: 0.5, length_m: 1, axis: y}}}}
    joint: {{revolute: {{name: winch, position_m: [-4, 0, 0], axis: [0, 1, 0]}}}}
forces:
  gravity: {{gravity: {{acceleration_m_s2: {GRAVITY}}}}}
  fall:
    rope:
      path:
        - drum: {{joint: winch, radius_m: 0.5}}
        - point: {{body: world}}
        - point: {{body: load, falls: 2}}
      axial_stiffness_N: 2e7
      damping_time_s: 0.02
drives:
  hoist:
    controlled_drive:
      {{joint: winch, set_point: {{speed: {{rate_rad_s: -1}}}}, speed_limit_rad_s: 2, acceleration_limit_rad_s2: 0.5,
        torque_limit_kN_m: 40, power_limit_kW: 60, stiffness_kN_m_per_rad: 2000, damping_kN_m_s_per_rad: 15}}
"
    );
    let mut hoisting = simulation(&text);
    hoisting.step(10_000).expect("it hoists");
    // The rope comes in stretched by T / EA.
    let exact = 0.25 * (1.0 + 2000.0 * GRAVITY / 2e7);
    assert!((hoisting.state().v[2] - exact).abs() < 1e-6, "{}", hoisting.state().v[2]);
    assert!((values(&mut hoisting, "rope_tension")[0] / (2000.0 * GRAVITY) - 1.0).abs() < 1e-3);
    assert!((values(&mut hoisting, "drive_torque")[0] / (-1000.0 * GRAVITY) - 1.0).abs() < 2e-3);
    assert!((values(&mut hoisting, "rope_pay_out_rate")[0] + 0.5).abs() < 1e-3);
    let scale = values(&mut hoisting, "work_by_drives")[0];
    assert!(values(&mut hoisting, "energy_error")[0].abs() < 1e-9 * scale);
}

/// `T + T^2 / (2 EA) = tau / R`, for any speed at which the rope is pulled out or returns: a winch of
/// constant tension.
#[test]
fn a_winch_with_constant_torque_holds_the_tension_of_its_rope_while_the_other_end_moves() {
    for speed in [0.5, -0.5] {
        let text = format!(
            "version: 1
title: A winch of constant tension
simulation: {{step_s: 0.005, duration_s: 20}}
bodies:
  boat:
    mass_kg: 4000
    shape: {{point: {{}}}}
    joint:
      prismatic:
        {{name: drift, axis: [1, 0, 0], position_m: [20, 0, 0],
          mode: {{prescribed: {{speed_m_s: {speed}, history: pulse, pulse: {{rise_s: 2, hold_s: 12}}}}}}}}
  drum:
    mass_kg: 200
    shape: {{cylinder: {{radius_m: 0.5, length_m: 1, axis: y}}}}
    joint: {{revolute: {{name: winch, position_m: [0, 0, -0.5], axis: [0, 1, 0]}}}}
forces:
  line:
    rope:
      path: [{{drum: {{joint: winch, radius_m: 0.5}}}}, {{point: {{body: boat}}}}]
      unstretched_length_m: 19.99
      axial_stiffness_N: 2e6
      damping_time_s: 0.02
drives:
  tension:
    controlled_drive:
      {{joint: winch, set_point: {{torque: {{torque_N_m: -500}}}}, speed_limit_rad_s: 4, acceleration_limit_rad_s2: 4,
        torque_limit_N_m: 2000, stiffness_kN_m_per_rad: 100, damping_kN_m_s_per_rad: 2}}
"
        );
        let mut moving = simulation(&text);
        moving.step(1600).expect("it pays out and hauls in");
        let tension = values(&mut moving, "rope_tension")[0];
        let held = tension + tension * tension / (2.0 * 2e6);
        // The rope's damper, k tau e' = 0.4 N, pulls without strain: T 0.4 / EA is in no energy.
        assert!((held - 1000.0).abs() < 1e-3, "{speed} m/s: {held} N");
        let strained = 1.0 + tension / 2e6;
        assert!((values(&mut moving, "rope_pay_out_rate")[0] * strained - speed).abs() < 1e-6);
    }
}

/// At rest a drive holds its joint at the position in the scenario, and a run starts with the force that this
/// needs.
#[test]
fn a_run_from_equilibrium_starts_with_the_drive_force_that_holds_the_load() {
    let begins = |set_point: &str| {
        let text = lift(set_point, STRONG);
        text.replace("duration_s: 60", "duration_s: 60, begin_at_equilibrium: true")
            .replace("4e6, damping", "1e5, damping")
    };
    for set_point in ["speed: {}", "position: {extension_m: 0}"] {
        let mut held = simulation(&begins(set_point));
        assert!((values(&mut held, "drive_force")[0] - 1000.0 * GRAVITY).abs() < 1e-6);
        held.step(500).expect("it holds");
        assert!(held.state().q[0].abs() < 1e-9 && held.state().v[0].abs() < 1e-9, "{set_point}");
    }
    let mut moved = simulation(&begins("position: {extension_m: 3}"));
    moved.step(2000).expect("it moves");
    assert!((moved.state().q[0] - 3.0).abs() < 1e-6, "{}", moved.state().q[0]);
    let text = begins("speed: {}");
    let weak = text.replace("force_limit_kN: 50", "force_limit_kN: 9");
    let error =
        kingpost::scenario::read(&weak, "lift.yaml", &[]).and_then(|read| read.setup()).unwrap_err().to_string();
    assert!(error.contains("hoist"), "{error}");
}
