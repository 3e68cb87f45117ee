//! Loads that hang, swing and stop on ropes, against closed forms.

use crate::common;

use common::{simulation, values};
use kingpost::analysis::Linearizer;

/// Free fall, m/s^2.
const GRAVITY: f64 = 9.80665;
/// Mass of the load, kg.
const MASS: f64 = 2000.0;

/// A load of 2 t, free, on a rope that a drum in the world pays out through a ring at the origin; `winch` is the mode of
/// the drum, `start` the load's initial motion.
fn hanging(length_m: f64, axial_stiffness: f64, winch: &str, start: &str, settings: &str, more: &str) -> String {
    format!(
        "version: 1
title: A load on a rope
simulation: {{{settings}}}
bodies:
  load:
    mass_kg: {MASS}
    shape: {{sphere: {{radius_m: 0.5}}}}
    joint: {{floating: {{initial: {{{start}}}}}}}
  drum:
    mass_kg: 100
    shape: {{cylinder: {{radius_m: 0.5, length_m: 1, axis: y}}}}
    joint: {{revolute: {{name: winch, position_m: [-5, 0, 0], axis: [0, 1, 0]{winch}}}}}
forces:
  gravity: {{gravity: {{acceleration_m_s2: {GRAVITY}}}}}
  fall:
    rope:
      path:
        - drum: {{joint: winch, radius_m: 0.5}}
        - point: {{body: world}}
        - point: {{body: load}}
      unstretched_length_m: {}
      axial_stiffness_N: {axial_stiffness:e}
{more}",
        length_m + lead()
    )
}

/// Rope from the drum to the ring: it leaves the drum of 0.5 m where the line from the ring, 5 m away, touches it.
fn lead() -> f64 {
    (25.0_f64 - 0.25).sqrt()
}

/// Returns the time of the first upward zero crossing of the load's x, by the cubic through two steps.
fn first_crossing(text: &str) -> f64 {
    let mut swinging = simulation(text);
    let mut before = swinging.state().clone();
    let step_s = swinging.settings().step_s;
    for _ in 0..200_000 {
        swinging.step(1).expect("a swing");
        let now = swinging.state();
        if before.q[0] > 0.0 && now.q[0] <= 0.0 {
            let [x0, x1, v0, v1] = [before.q[0], now.q[0], before.v[0], now.v[0]];
            let at = |s: f64| {
                let (a, b) = (1.0 - s, s);
                x0 * a * a * (1.0 + 2.0 * b) + x1 * b * b * (1.0 + 2.0 * a) + step_s * a * b * (v0 * a - v1 * b)
            };
            let (mut low, mut high) = (0.0, 1.0);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if at(middle) > 0.0 { low = middle } else { high = middle }
            }
            return swinging.time_s() - step_s * (1.0 - low);
        }
        before = now.clone();
    }
    panic!("it never crosses");
}

#[test]
fn a_load_on_a_rope_of_5_to_100_m_swings_with_the_period_of_a_pendulum() {
    for length in [5.0, 20.0, 100.0] {
        // Stretched by its weight, EA = 1e9 N, it hangs lower by 2e-5 of all that is paid out.
        let hangs = length + (length + lead()) * MASS * GRAVITY / 1e9;
        let (sin, cos) = 1e-3_f64.sin_cos();
        let start = format!("position_m: [{}, 0, {}]", hangs * sin, -hangs * cos);
        let text = hanging(length, 1e9, ", mode: held", &start, "step_s: 0.002, duration_s: 100", "");
        let quarter = first_crossing(&text);
        let exact = std::f64::consts::FRAC_PI_2 * (hangs / GRAVITY).sqrt();
        // The amplitude of 1e-3 rad adds 6e-8.
        assert!((quarter / exact - 1.0).abs() < 1e-5, "{length} m: {quarter} s, {exact} s");
    }
}

/// `theta = (A J1(u) + B Y1(u)) / u` with `u = 2 sqrt(g l) / v` where l grows by v (Lecornu 1895; Watson, *Theory of
/// Bessel Functions*, 1922, sec. 4.3).
#[test]
fn a_pendulum_lengthened_by_a_winch_swings_by_bessel_functions() {
    let (length, speed, angle) = (10.0, 0.5, 1e-4);
    let winch = format!(", mode: {{prescribed: {{rate_rad_s: {}}}}}", speed / 0.5);
    let weight = MASS * GRAVITY;
    let stiffness = 4e10;
    let hangs = length + (length + lead()) * weight / stiffness;
    let start =
        format!("position_m: [{}, 0, {}], velocity_m_s: [{}, 0, {}]", hangs * angle, -hangs, speed * angle, -speed);
    let text = hanging(length, stiffness, &winch, &start, "step_s: 0.0005, duration_s: 10", "");
    let mut swinging = simulation(&text);
    let u = |time_s: f64| 2.0 * (GRAVITY * (hangs + speed * time_s)).sqrt() / speed;
    let basis = |u: f64| [libm::j1(u) / u, libm::y1(u) / u];
    // d/du (Z1 / u) = -Z2 / u: the angle starts at rest.
    let slopes = |u: f64| [-libm::jn(2, u) / u, -libm::yn(2, u) / u];
    let ([f, g], [df, dg]) = (basis(u(0.0)), slopes(u(0.0)));
    let determinant = f * dg - g * df;
    let (a, b) = (angle * dg / determinant, -angle * df / determinant);
    for _ in 0..10 {
        swinging.step(2000).expect("a swing");
        let [x, z] = [swinging.state().q[0], swinging.state().q[2]];
        let [f, g] = basis(u(swinging.time_s()));
        let found = x.atan2(-z);
        assert!(
            (found - (a * f + b * g)).abs() < 1e-6 * angle,
            "{}: {found:e}, {:e}",
            swinging.time_s(),
            a * f + b * g
        );
    }
}

/// Energy: `k e^2 / 2 - W e = m v^2 / 2` from rest length, and about the static stretch.
#[test]
fn the_peak_tension_at_a_sudden_stop_follows_from_energy_with_rope_and_crane_stiffness_in_series() {
    let (length, speed) = (20.0, 0.8);
    let weight = MASS * GRAVITY;
    let compliance = (length + lead()) / 5e6 + 1.0 / 4e5;
    let stiffness = 1.0 / compliance;
    let peak = |below: f64| {
        let start = format!("position_m: [0, 0, {}], velocity_m_s: [0, 0, {}]", -length - below, -speed);
        let text = hanging(
            length,
            5e6,
            ", mode: held",
            &start,
            "step_s: 0.001, duration_s: 2",
            "      series_stiffness_N_per_m: 4e5\n",
        );
        let mut stopping = simulation(&text);
        (0..2000).fold(0.0_f64, |most, _| {
            stopping.step(1).expect("a stop");
            most.max(values(&mut stopping, "rope_tension")[0])
        })
    };
    let taut = peak(weight * compliance) / weight;
    assert!((taut / (1.0 + speed / GRAVITY * (stiffness / MASS).sqrt()) - 1.0).abs() < 1e-4, "{taut}");
    let slack = peak(0.0);
    let exact = weight + (weight * weight + stiffness * MASS * speed * speed).sqrt();
    assert!((slack / exact - 1.0).abs() < 1e-4, "{slack} {exact}");
}

/// A pontoon that rolls on a spring, c, about an axis that is held or free to sway, and a load on a rope from a mast of height h.
/// With the small angles phi of the pontoon and theta of the rope against the vertical, and the load's y = s - h phi + l theta at
/// the sway s,
///
/// ```text
/// 2 T = M s'^2 + I phi'^2 + m y'^2,    2 U = (c - W h) phi^2 + W l theta^2
/// ```
///
/// A free sway keeps M s' + m y' = 0: then y' - s' moves the reduced mass m M / (m + M) where a held one moves m.
#[test]
fn a_rolling_pontoon_and_its_hanging_load_have_the_modes_of_the_coupled_pendulum_with_sway_held_and_free() {
    let (inertia, spring, height, length, mass, pontoon) = (4e6, 6e6, 15.0, 12.0, 5000.0, 20_000.0);
    let weight = mass * GRAVITY;
    let stretched = length * (1.0 + weight / 1e12);
    for (sway, moved) in [("fixed: {}", mass), ("prismatic: {axis: [0, 1, 0]}", mass * pontoon / (mass + pontoon))] {
        let text = format!(
            "version: 1
title: A pontoon that rolls
simulation: {{step_s: 0.01, duration_s: 1}}
bodies:
  raft:
    mass_kg: {}
    shape: {{point: {{}}}}
    joint: {{{sway}}}
  pontoon:
    parent: raft
    mass_kg: 1000
    inertia: {{tensor: {{moments_kg_m2: [{inertia}, 3e6, 3e6]}}}}
    joint: {{revolute: {{name: roll, axis: [1, 0, 0], spring: {{stiffness_N_m_per_rad: {spring}}}}}}}
  load:
    mass_kg: {mass}
    inertia: {{tensor: {{moments_kg_m2: [1000, 1000, 1000]}}}}
    joint: {{floating: {{initial: {{position_m: [0, 0, {}]}}}}}}
forces:
  gravity: {{gravity: {{acceleration_m_s2: {GRAVITY}}}}}
  fall:
    rope:
      path: [{{point: {{body: pontoon, position_m: [0, 0, {height}]}}}}, {{point: {{body: load}}}}]
      unstretched_length_m: {length}
      axial_stiffness_N: 1e12
",
            pontoon - 1000.0,
            height - stretched
        );
        let scenario = kingpost::scenario::read(&text, "pontoon.yaml", &[]).expect("it reads");
        let simulation = scenario.simulation().expect("it builds");
        let linear = Linearizer::new(&scenario).expect("it builds").at(&simulation);
        let (m11, m12, m22) =
            (inertia + moved * height * height, -moved * height * stretched, moved * stretched * stretched);
        let (k1, k2) = (spring - weight * height, weight * stretched);
        let (a, b, c) = (m11 * m22 - m12 * m12, -(k1 * m22 + k2 * m11), k1 * k2);
        let root = (b * b - 4.0 * a * c).sqrt();
        let exact = [(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)].map(f64::sqrt);
        let found: Vec<f64> = linear.a.complex_eigenvalues().iter().map(|value| value.im).collect();
        for exact in exact {
            let nearest = found.iter().map(|w| (w / exact - 1.0).abs()).fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-6, "{sway}: {exact} rad/s among {found:?}");
        }
    }
}

/// At rest the factor is 1 for the weight on each fall; a load whose full weight acts suddenly on the rope
/// swings up to 2.
#[test]
fn the_dynamic_amplification_factor_of_a_rope_is_over_the_weight_in_air_on_each_fall() {
    let text = |length: f64| {
        format!(
            "version: 1
title: A load on two falls
simulation: {{step_s: 0.002, duration_s: 2}}
bodies:
  block:
    mass_kg: 500
    shape: {{point: {{}}}}
    joint: {{prismatic: {{name: lift, position_m: [0, 0, -20], axis: [0, 0, 1]}}}}
  load: {{parent: block, mass_kg: 7500, shape: {{point: {{}}}}, joint: {{fixed: {{}}}}}}
forces:
  gravity: {{gravity: {{acceleration_m_s2: {GRAVITY}}}}}
  fall:
    rope:
      path: [{{point: {{body: world}}}}, {{point: {{body: block, falls: 2}}}}]
      unstretched_length_m: {length}
      axial_stiffness_N: 2e7
      carries: [{{body: block}}, {{body: load}}]
"
        )
    };
    let (tension, length) = (8000.0 * GRAVITY / 2.0, 40.0);
    let mut resting = simulation(&text(length / (1.0 + tension / 2e7)));
    assert!((values(&mut resting, "rope_daf")[0] - 1.0).abs() < 1e-12);
    let mut falling = simulation(&text(length));
    let factors = (0..1000).map(|_| {
        falling.step(1).expect("a fall");
        values(&mut falling, "rope_daf")[0]
    });
    let most = factors.fold(0.0, f64::max);
    // 2 m of fall are 4 m of rope: k is that of the length at the start, and a step misses the peak by (w h)^2 / 8 at most.
    assert!((most - 2.0).abs() < 1e-4, "{most}");
}

/// Four falls carry a quarter each; friction at each of two sheaves reduces the tension that the drum must
/// hold.
#[test]
fn falls_share_the_weight_and_sheave_friction_reduces_the_lead_tension() {
    let text = format!(
        "version: 1
title: A hoist
simulation: {{integrator: implicit_midpoint, step_s: 0.05, duration_s: 60}}
bodies:
  block:
    mass_kg: 8000
    shape: {{point: {{}}}}
    joint: {{prismatic: {{name: lift, position_m: [0, 0, -20], axis: [0, 0, 1], damping_N_s_m: 20000}}}}
  drum:
    mass_kg: 100
    shape: {{cylinder: {{radius_m: 0.5, length_m: 1, axis: y}}}}
    joint: {{revolute: {{name: winch, position_m: [-30, 0, 0], axis: [0, 1, 0], mode: {{prescribed: {{rate_rad_s: -1}}}}}}}}
forces:
  gravity: {{gravity: {{acceleration_m_s2: {GRAVITY}}}}}
  fall:
    rope:
      path:
        - drum: {{joint: winch, radius_m: 0.5}}
        - sheave: {{body: world, position_m: [-1, 0, 1.5], radius_m: 0.2, axis: [0, 1, 0], efficiency_hoisting: 0.96}}
        - sheave: {{body: world, position_m: [0, 0, 1], radius_m: 0.2, axis: [0, 1, 0], efficiency_hoisting: 0.96}}
        - point: {{body: world}}
        - point: {{body: block, falls: 4}}
      axial_stiffness_N: 2e7
      damping_time_s: 0.02
"
    );
    let mut hoisting = simulation(&text);
    hoisting.step(400).expect("a hoist");
    let speed = hoisting.state().v[0];
    assert!((speed - 0.5 / 4.0).abs() < 1e-3, "{speed} m/s");
    let tension = values(&mut hoisting, "rope_tension")[0];
    let expected = (8000.0 * GRAVITY + 20000.0 * speed) / 4.0;
    assert!((tension / expected - 1.0).abs() < 1e-3, "{tension} {expected}");
    let lead = values(&mut hoisting, "rope_first_tension")[0];
    // At 0.5 m/s the smoothing of 0.01 m/s leaves 2e-4 of the friction out.
    assert!((lead / (tension / 0.96 / 0.96) - 1.0).abs() < 1e-4, "{lead}");
}

/// `T R / eta` hauls in, `T R eta` holds while the drum pays out; the loss is heat.
#[test]
fn a_winch_with_friction_takes_more_torque_to_haul_in_than_to_pay_out() {
    for (rate, expected) in [(-1.0, 1.0 / 0.9), (1.0, 0.85)] {
        let text = format!(
            "version: 1
title: A winch with friction
simulation: {{step_s: 0.01, duration_s: 20, integrator: implicit_midpoint}}
bodies:
  block:
    mass_kg: 2000
    shape: {{point: {{}}}}
    joint: {{prismatic: {{name: lift, position_m: [0, 0, -20], axis: [0, 0, 1], damping_N_s_m: 20000}}}}
  drum:
    mass_kg: 100
    shape: {{cylinder: {{radius_m: 0.5, length_m: 1, axis: y}}}}
    joint: {{revolute: {{name: winch, position_m: [-0.5, 0, 0], axis: [0, 1, 0], mode: {{prescribed: {{rate_rad_s: {rate}}}}}}}}}
forces:
  gravity: {{gravity: {{acceleration_m_s2: {GRAVITY}}}}}
  fall:
    rope:
      path:
        - drum: {{joint: winch, radius_m: 0.5, efficiency_hoisting: 0.9, efficiency_lowering: 0.85}}
        - point: {{body: block}}
      axial_stiffness_N: 2e9
      damping_time_s: 0.02
"
        );
        let mut turning = simulation(&text);
        turning.step(1000).expect("it turns");
        let before = values(&mut turning, "work_by_drives")[0];
        turning.step(100).expect("it turns");
        let tension = values(&mut turning, "rope_tension")[0];
        // The work of a second in which the drum turns by 1 rad.
        let torque = (values(&mut turning, "work_by_drives")[0] - before).abs();
        // The smoothing over 0.01 m/s leaves 2e-4 of the friction out at 0.5 m/s; strain on the drum adds T / (2 EA), 6e-6.
        assert!((torque / (0.5 * tension) / expected - 1.0).abs() < 1e-4, "{rate}: {torque} {tension}");
        let scale = values(&mut turning, "energy_scale")[0];
        assert!(values(&mut turning, "energy_error")[0].abs() < 1e-6 * scale);
    }
}

#[test]
fn a_rope_parts_at_its_breaking_load_and_its_energy_is_lost() {
    let start = "position_m: [0, 0, -20], velocity_m_s: [0, 0, -2]";
    let text =
        hanging(20.0, 5e6, ", mode: held", start, "step_s: 0.001, duration_s: 2", "      breaking_load_N: 60000\n");
    let mut parting = simulation(&text);
    parting.step(1000).expect("a fall");
    let parts = parting.events().iter().find(|event| event.what == "parts").expect("it parts");
    assert_eq!(parts.element, "fall");
    assert_eq!(values(&mut parting, "rope_tension"), [0.0]);
    assert!((parting.acceleration(None).unwrap()[2] + GRAVITY).abs() < 1e-12);
    // V = F^2 / (2 k) at the breaking load.
    let lost = 60000.0 * 60000.0 * 0.5 * (20.0 + lead()) / 5e6;
    assert!((values(&mut parting, "energy_dissipated")[0] / lost - 1.0).abs() < 1e-6);
    assert!(values(&mut parting, "energy_error")[0].abs() < 1e-9 * lost);
}

/// The tip carries the weight of a hanging load for any length of the rope.
#[test]
fn a_hanging_load_heels_a_ship_like_a_mass_fixed_at_the_tip() {
    let heel = |load: &str, forces: &str| {
        let text = format!(
            "version: 1
title: A pontoon that heels
simulation: {{step_s: 0.01, duration_s: 1, begin_at_equilibrium: true}}
bodies:
  pontoon:
    mass_kg: 1000
    inertia: {{tensor: {{moments_kg_m2: [4e6, 3e6, 3e6]}}}}
    joint: {{revolute: {{name: roll, axis: [1, 0, 0], spring: {{stiffness_N_m_per_rad: 2e7}}}}}}
  drum:
    parent: pontoon
    mass_kg: 100
    shape: {{cylinder: {{radius_m: 0.5, length_m: 1, axis: x}}}}
    joint: {{revolute: {{name: winch, position_m: [0, -3, 2], axis: [-1, 0, 0], mode: held}}}}
  load:
    mass_kg: 20000
    shape: {{sphere: {{radius_m: 0.8}}}}
    {load}
forces:
  gravity: {{gravity: {{acceleration_m_s2: {GRAVITY}}}}}
{forces}"
        );
        let mut settled = simulation(&text);
        values(&mut settled, "joint_position")[0]
    };
    let fixed = heel("parent: pontoon\n    joint: {fixed: {position_m: [0, 8, 10]}}", "");
    let hanging = heel(
        "joint: {floating: {initial: {position_m: [0, 8, 4]}}}",
        "  fall:
    rope:
      path:
        - drum: {joint: winch, radius_m: 0.5}
        - point: {body: pontoon, position_m: [0, 8, 10]}
        - point: {body: load}
      axial_stiffness_N: 5e7
",
    );
    assert!(fixed.abs() > 0.05, "{fixed}");
    assert!((hanging - fixed).abs() < 1e-6 * fixed.abs(), "{hanging} {fixed}");
}

/// The largest tension in the rope of a load of 50 t under a hook block of 0.5 t that are stopped from 0.5 m/s; rope and sling
/// have 1e8 N/m each.
fn stiff_stop(settings: &str, steps: usize) -> f64 {
    let text = format!(
        "version: 1
title: A stiff rope
simulation: {{{settings}, duration_s: 1}}
bodies:
  block:
    mass_kg: 500
    shape: {{point: {{}}}}
    joint: {{prismatic: {{name: block, axis: [0, 0, 1], position_m: [0, 0, -10], initial_speed_m_s: -0.5}}}}
  load:
    mass_kg: 50000
    shape: {{point: {{}}}}
    joint: {{prismatic: {{name: load, axis: [0, 0, 1], position_m: [0, 0, -20], initial_speed_m_s: -0.5}}}}
forces:
  gravity: {{gravity: {{acceleration_m_s2: {GRAVITY}}}}}
  fall:
    rope: {{path: [{{point: {{body: world}}}}, {{point: {{body: block}}}}], axial_stiffness_N: 1e9, damping_time_s: 0.001}}
  sling:
    rope: {{path: [{{point: {{body: block}}}}, {{point: {{body: load}}}}], axial_stiffness_N: 1e9, damping_time_s: 0.001}}
"
    );
    let mut stopping = simulation(&text);
    (0..steps).fold(0.0_f64, |most, _| {
        stopping.step(1).expect("a stop");
        most.max(values(&mut stopping, "rope_tension")[0])
    })
}

/// The block alone has a period of 10 ms, a step here; the load's is 0.2 s, and its peak falls between two steps: 1 - cos(pi / 20)
/// is 1.2 % of what the tension swings by.
#[test]
fn a_stiff_rope_over_a_light_hook_block_runs_at_10_ms_by_implicit_schemes() {
    let exact = stiff_stop("step_s: 0.00005, integrator: rk4", 20_000);
    for scheme in ["generalized_alpha", "implicit_midpoint", "newmark"] {
        let found = stiff_stop(&format!("step_s: 0.01, integrator: {scheme}"), 100);
        assert!((found / exact - 1.0).abs() < 0.01, "{scheme}: {found} N of {exact} N");
        let finer = stiff_stop(&format!("step_s: 0.005, integrator: {scheme}"), 200);
        assert!((finer / exact - 1.0).abs() < 0.001, "{scheme}: {finer} N of {exact} N");
    }
}
