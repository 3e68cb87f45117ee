//! The engine against the closed forms of tops and pendulums: free and heavy, in space and in a plane.
//!
//! RK4 with n steps in a period errs by about (2 pi / n)^4 / 120 a radian: 2000 steps leave less than
//! 1e-9 where a motion has a few harmonics.

use crate::common;

use common::closed_forms::elliptic::{complete_first, complete_third, first, jacobi};
use common::closed_forms::{DoublePendulum, FreeBody, HeavyTop};
use common::simulation;
use core::f64::consts::{FRAC_PI_2, PI};
use kingpost::Simulation;
use kingpost::spatial::{Quaternion, Vector3};

const STEPS: usize = 2000;

#[test]
fn the_elliptic_functions_match_the_tables() {
    // K(1/2) of Abramowitz & Stegun, table 17.1; F(30 degrees) by quadrature; degenerate cases.
    assert!((complete_first(0.5) - 1.854_074_677_301_372).abs() < 1e-14);
    assert!((first(PI / 6.0, 0.5) - 0.535_622_732_805_403_1).abs() < 1e-12);
    assert!((first(FRAC_PI_2, 0.5) - complete_first(0.5)).abs() < 1e-13);
    assert!((complete_third(0.0, 0.5) - complete_first(0.5)).abs() < 1e-14);
    // Pi(n, 0) = pi / (2 sqrt(1 - n)), and Pi(m, m) = E(m) / (1 - m) with E(1/2) = 1.3506438810476755.
    for n in [0.4, -2.0] {
        assert!((complete_third(n, 0.0) - FRAC_PI_2 / (1.0 - n).sqrt()).abs() < 1e-13, "n = {n}");
    }
    assert!((complete_third(0.5, 0.5) - 2.0 * 1.350_643_881_047_675_5).abs() < 1e-12);
    for u in [-3.0, 0.4, 7.0] {
        let [sn, cn, dn] = jacobi(u, 0.7);
        let angle = f64::atan2(sn, cn);
        let turns = ((u - first(angle, 0.7)) / (4.0 * complete_first(0.7))).round();
        assert!((first(angle + turns * 2.0 * PI, 0.7) - u).abs() < 1e-12, "sn and cn of {u}");
        assert!((dn * dn - 1.0 + 0.7 * sn * sn).abs() < 1e-14);
    }
}

/// A body with radii of gyration that give the moments, thrown with these rates.
fn thrown(moments: [f64; 3], rates: [f64; 3], step_s: f64) -> Simulation {
    simulation(&format!(
        "
version: 1
title: A free body
simulation: {{step_s: {step_s:e}}}
bodies:
  racket:
    mass_kg: 1
    inertia: {{tensor: {{moments_kg_m2: {moments:?}}}}}
    joint: {{floating: {{initial: {{angular_velocity_rad_s: {rates:?}}}}}}}
"
    ))
}

/// Twists near each of the axes, on either side: near the intermediate axis the body flips.
const TWISTS: [[f64; 3]; 5] =
    [[0.02, 3.0, 0.01], [0.01, -3.0, 0.02], [3.0, 0.4, -0.3], [-0.5, 0.3, -3.0], [1.0, 1.0, 1.0]];

#[test]
fn a_free_body_rotates_by_jacobis_elliptic_functions() {
    let moments = [1.0, 2.0, 2.5];
    for rates in TWISTS {
        let exact = FreeBody::new(moments, rates);
        let period = exact.period_s();
        let mut body = thrown(moments, rates, period / STEPS as f64);
        for part in 1..=20 {
            body.step(STEPS / 20).unwrap();
            let (found, expected) = (&body.state().v[3..], exact.rates(f64::from(part) * period / 20.0));
            let error = (0..3).fold(0.0_f64, |worst, i| worst.max((found[i] - expected[i]).abs()));
            assert!(error < 1e-8, "{rates:?} after {part} twentieths of a period: {error:e}");
        }
    }
}

#[test]
fn after_a_period_a_free_body_has_turned_about_its_angular_momentum_by_landaus_angle() {
    let moments = [1.0, 2.0, 2.5];
    for rates in TWISTS {
        let exact = FreeBody::new(moments, rates);
        let mut body = thrown(moments, rates, exact.period_s() / STEPS as f64);
        body.step(STEPS).unwrap();
        // It starts with its axes along the world's, so that its momentum in the world is I w.
        let momentum = Vector3(core::array::from_fn(|i| moments[i] * rates[i]));
        let turn = momentum * (exact.turn_in_a_period() / momentum.norm());
        let (found, expected) = (&body.state().q[3..7], Quaternion::exp(turn).0);
        // A quaternion and its negative are the same rotation.
        let apart = |sign: f64| (0..4).fold(0.0_f64, |worst, i| worst.max((found[i] - sign * expected[i]).abs()));
        assert!(apart(1.0).min(apart(-1.0)) < 1e-8, "{rates:?}: {found:?}, {expected:?}");
    }
}

#[test]
fn a_racket_flips_with_the_period_of_the_elliptic_integral() {
    // Measured without knowing the period: from one rise of the intermediate rate through 0 to the
    // next, each between two steps by the cubic through rates and accelerations, of order 4 as the scheme.
    let (moments, rates) = ([1.0, 2.0, 2.5], [0.02, 3.0, 0.01]);
    let mut body = thrown(moments, rates, 0.005);
    let mut rises = Vec::new();
    let mut before = (0.0, 3.0, 0.0);
    while rises.len() < 2 {
        body.step(1).unwrap();
        let [wx, wy, wz] = core::array::from_fn(|i| body.state().v[3 + i]);
        let now = (body.time_s(), wy, (moments[2] - moments[0]) / moments[1] * wz * wx);
        if before.1 < 0.0 && now.1 >= 0.0 {
            rises.push(zero_between(before, now));
        }
        before = now;
    }
    let (found, expected) = (rises[1] - rises[0], FreeBody::new(moments, rates).period_s());
    assert!((found / expected - 1.0).abs() < 1e-6, "{found} s, {expected} s");
}

/// Where the cubic through two values and slopes, each (time, value, slope), is 0.
fn zero_between(from: (f64, f64, f64), to: (f64, f64, f64)) -> f64 {
    let h = to.0 - from.0;
    let value = |s: f64| {
        let (a, b) = (1.0 - s, s);
        a * a * (1.0 + 2.0 * b) * from.1 + a * a * b * h * from.2 + b * b * (1.0 + 2.0 * a) * to.1
            - b * b * a * h * to.2
    };
    let (mut lower, mut upper) = (0.0, 1.0);
    for _ in 0..50 {
        let s = (lower + upper) / 2.0;
        if (value(s) > 0.0) == (value(0.0) > 0.0) { lower = s } else { upper = s }
    }
    from.0 + lower * h
}

/// Joint on which a top stands or a pendulum hangs.
#[derive(Clone, Copy, Debug)]
enum Mount {
    /// Euler's hinges: about the vertical, about the level, of a top also about its own axis. The point
    /// masses between them lie on the fixed point and carry nothing.
    Hinges,
    /// A spherical joint.
    Ball,
}

const MOUNTS: [Mount; 2] = [Mount::Hinges, Mount::Ball];

/// The angle about the vertical, within a turn of a ball, and that from the upward vertical.
fn leaning(found: &Simulation, mount: Mount) -> [f64; 2] {
    let q = &found.state().q;
    match mount {
        Mount::Hinges => [q[0], q[1]],
        Mount::Ball => {
            let [x, y, z] = Quaternion([q[0], q[1], q[2], q[3]]).to_matrix().column(2).0;
            [y.atan2(x), x.hypot(y).atan2(z)]
        }
    }
}

impl Mount {
    /// Returns the difference of two angles about the vertical; hinges count turns, a ball does not.
    fn apart(self, a: f64, b: f64) -> f64 {
        let difference = a - b;
        match self {
            Mount::Hinges => difference.abs(),
            Mount::Ball => difference.sin().atan2(difference.cos()).abs(),
        }
    }
}

struct Top {
    across: f64,
    along: f64,
    mass: f64,
    length: f64,
}

impl Top {
    const EXAMPLE: Self = Self { across: 0.9, along: 0.4, mass: 2.0, length: 0.5 };

    fn moments(&self) -> [f64; 2] {
        [self.across, self.along]
    }

    fn start(&self, mount: Mount, [theta, phi_rate, spin]: [f64; 3], step_s: f64) -> Simulation {
        let Self { across, along, mass, length } = *self;
        let about_centre = across - mass * length * length;
        let body = format!(
            "mass_kg: {mass}, inertia: {{tensor: {{moments_kg_m2: [{about_centre}, {about_centre}, {along}]}}}}"
        );
        let below = format!("child_position_m: [0, 0, -{length}]");
        let own_rate = spin - phi_rate * theta.cos();
        let bodies = match mount {
            Mount::Hinges => format!(
                "
  turned: {{mass_kg: 1, shape: {{point: {{}}}}, joint: {{revolute: {{axis: [0, 0, 1], initial_rate_rad_s: {phi_rate:e}}}}}}}
  leaned:
    parent: turned
    mass_kg: 1
    shape: {{point: {{}}}}
    joint: {{revolute: {{axis: [0, 1, 0], initial_angle_rad: {theta:e}}}}}
  top: {{parent: leaned, {body}, joint: {{revolute: {{axis: [0, 0, 1], {below}, initial_rate_rad_s: {own_rate:e}}}}}}}"
            ),
            Mount::Ball => format!("\n  top: {{{body}, joint: {{spherical: {{{below}, {}}}}}}}", ball(theta, phi_rate, spin)),
        };
        under_gravity(&bodies, step_s)
    }
}

/// Where a body on a spherical joint starts, with its axis at theta, and its rates in its own axes.
fn ball(theta: f64, phi_rate: f64, spin: f64) -> String {
    let across = -phi_rate * theta.sin();
    format!("initial_orientation_rad: [0, {theta:e}, 0], initial_angular_velocity_rad_s: [{across:e}, 0, {spin:e}]")
}

fn under_gravity(bodies: &str, step_s: f64) -> Simulation {
    simulation(&format!(
        "
version: 1
title: A top or a pendulum
simulation: {{step_s: {step_s:e}}}
bodies:{bodies}
forces: {{gravity: {{gravity: {{}}}}}}
"
    ))
}

#[test]
fn a_heavy_top_nods_and_precesses_by_elliptic_integrals() {
    let top = Top::EXAMPLE;
    // Cusps (released from rest), waves, loops.
    for [theta, phi_rate, spin] in [[0.6, 0.0, 12.0], [0.6, 1.5, 12.0], [0.9, -1.0, 12.0], [1.8, 0.5, 9.0]] {
        let exact = HeavyTop::new(top.moments(), top.mass * top.length, theta, phi_rate, spin);
        let (period, precession) = (exact.nutation_period_s(), exact.precession_in_a_nutation());
        for mount in MOUNTS {
            let mut found = top.start(mount, [theta, phi_rate, spin], period / STEPS as f64);
            found.step(STEPS).unwrap();
            let [phi, nod] = leaning(&found, mount);
            assert!((nod - theta).abs() < 1e-8, "{mount:?}, theta {theta}: {nod}");
            assert!(mount.apart(phi, precession) < 1e-8, "{mount:?}, {theta}, {phi_rate}: phi {phi}, {precession}");
        }
    }
}

#[test]
fn a_heavy_top_precesses_regularly_at_either_rate() {
    let (top, theta, spin) = (Top::EXAMPLE, 0.7, 15.0);
    for phi_rate in HeavyTop::regular_precession(top.moments(), top.mass * top.length, theta, spin) {
        for mount in MOUNTS {
            let mut found = top.start(mount, [theta, phi_rate, spin], 0.0005);
            found.step(2000).unwrap();
            let [phi, nod] = leaning(&found, mount);
            let near = (nod - theta).abs() < 1e-9 && mount.apart(phi, phi_rate) < 1e-9;
            assert!(near, "{mount:?}, {phi_rate}: {nod}, {phi}");
        }
    }
}

/// On hinges a point mass on a rod. On a ball a body that does not spin, which swings as a point mass
/// does on a rod of length (moment about the ball) / (mass times the distance of its centre).
fn spherical_pendulum(mount: Mount, length: f64, [theta, phi_rate]: [f64; 2], step_s: f64) -> Simulation {
    let bodies = match mount {
        Mount::Hinges => format!(
            "
  turned: {{mass_kg: 1, shape: {{point: {{}}}}, joint: {{revolute: {{axis: [0, 0, 1], initial_rate_rad_s: {phi_rate:e}}}}}}}
  bob:
    parent: turned
    mass_kg: 3
    shape: {{point: {{}}}}
    joint: {{revolute: {{axis: [0, 1, 0], child_position_m: [0, 0, -{length}], initial_angle_rad: {theta:e}}}}}"
        ),
        Mount::Ball => {
            let (mass, centre) = (3.0, 0.9 * length);
            let moment = mass * centre * (length - centre);
            format!(
                "
  bob:
    mass_kg: {mass}
    inertia: {{tensor: {{moments_kg_m2: [{moment}, {moment}, {moment}]}}}}
    joint: {{spherical: {{child_position_m: [0, 0, -{centre}], {}}}}}",
                ball(theta, phi_rate, 0.0)
            )
        }
    };
    under_gravity(&bodies, step_s)
}

#[test]
fn a_spherical_pendulum_rises_falls_and_advances_by_elliptic_integrals() {
    let length = 1.3;
    for [theta, phi_rate] in [[2.0, 1.2], [2.6, 5.0], [1.2, 2.0]] {
        let exact = HeavyTop::spherical_pendulum(length, theta, phi_rate);
        let period = exact.nutation_period_s();
        for mount in MOUNTS {
            let mut found = spherical_pendulum(mount, length, [theta, phi_rate], period / STEPS as f64);
            found.step(STEPS / 2).unwrap();
            let [lowest, highest] = exact.limits();
            let across = if (theta.cos() - lowest).abs() < 1e-9 { highest } else { lowest };
            let height = leaning(&found, mount)[1].cos();
            assert!((height - across).abs() < 1e-8, "{mount:?}, half way: {height}, {across}");
            found.step(STEPS / 4).unwrap();
            let since_lowest = if across == lowest { 0.25 } else { 0.75 } * period;
            let height = leaning(&found, mount)[1].cos();
            assert!((height - exact.height(since_lowest)).abs() < 1e-8, "{mount:?}, three quarters: {height}");
            found.step(STEPS / 4).unwrap();
            let [phi, nod] = leaning(&found, mount);
            assert!((nod - theta).abs() < 1e-8, "{mount:?}, theta {theta}: {nod}");
            let advance = exact.precession_in_a_nutation();
            assert!(mount.apart(phi, advance) < 1e-8, "{mount:?}, {theta}, {phi_rate}: phi {phi}, {advance}");
        }
    }
}

#[test]
fn a_conical_pendulum_keeps_its_cone() {
    let (length, theta) = (1.3, 2.5);
    let rate = HeavyTop::conical_rate(length, theta);
    for mount in MOUNTS {
        let mut found = spherical_pendulum(mount, length, [theta, rate], 2.0 * PI / rate / STEPS as f64);
        found.step(STEPS).unwrap();
        let [phi, nod] = leaning(&found, mount);
        assert!(mount.apart(phi, 2.0 * PI) < 1e-9 && (nod - theta).abs() < 1e-9, "{mount:?}: {phi}, {nod}");
    }
}

/// Angles of the engine are relative; those of the closed form are absolute.
fn double_pendulum(exact: &DoublePendulum, [t1, t2]: [f64; 2], [w1, w2]: [f64; 2], step_s: f64) -> Simulation {
    let ([m1, m2], [l1, l2]) = (exact.masses_kg, exact.lengths_m);
    simulation(&format!(
        "
version: 1
title: A double pendulum
simulation: {{step_s: {step_s:e}}}
bodies:
  upper:
    mass_kg: {m1}
    shape: {{point: {{}}}}
    joint: {{revolute: {{axis: [0, 1, 0], child_position_m: [0, 0, {l1}], initial_angle_rad: {t1:e}, initial_rate_rad_s: {w1:e}}}}}
  lower:
    parent: upper
    mass_kg: {m2}
    shape: {{point: {{}}}}
    joint:
      revolute:
        axis: [0, 1, 0]
        child_position_m: [0, 0, {l2}]
        initial_angle_rad: {:e}
        initial_rate_rad_s: {:e}
forces: {{gravity: {{gravity: {{}}}}}}
",
        t2 - t1,
        w2 - w1
    ))
}

fn absolute(found: &Simulation) -> [[f64; 2]; 2] {
    let (q, v) = (&found.state().q, &found.state().v);
    [[q[0], q[0] + q[1]], [v[0], v[0] + v[1]]]
}

#[test]
fn a_double_pendulum_follows_its_own_equations() {
    let exact = DoublePendulum { masses_kg: [2.0, 1.2], lengths_m: [1.1, 0.8] };
    let (angles, rates) = ([1.3, -0.4], [0.5, 2.0]);
    let mut found = double_pendulum(&exact, angles, rates, 0.001);
    // The first accelerations to rounding; then two seconds, in which neither scheme has lost 1e-8.
    let acceleration = found.acceleration(None).unwrap();
    let [a1, a2] = exact.acceleration(angles, rates);
    assert!((acceleration[0] - a1).abs() < 1e-11 && (acceleration[0] + acceleration[1] - a2).abs() < 1e-11);
    found.step(2000).unwrap();
    let ([angles_found, rates_found], [a, r]) = (absolute(&found), exact.integrate(angles, rates, 2.0, 20_000));
    for i in 0..2 {
        assert!((angles_found[i] - a[i]).abs() < 1e-8 && (rates_found[i] - r[i]).abs() < 1e-7, "rod {i}");
    }
    let (energy, at_start) = (exact.energy(angles_found, rates_found), exact.energy(angles, rates));
    assert!((energy - at_start).abs() < 1e-8, "{energy}, {at_start}");
}

#[test]
fn a_double_pendulum_swings_in_its_small_angle_modes() {
    // A mode of amplitude e returns after its period but for terms in e^3.
    let exact = DoublePendulum { masses_kg: [2.0, 1.2], lengths_m: [1.1, 0.8] };
    let amplitude = 1e-4;
    for (frequency, ratio) in exact.small_angle_modes() {
        let start = [amplitude, ratio * amplitude];
        let mut found = double_pendulum(&exact, start, [0.0; 2], 2.0 * PI / frequency / STEPS as f64);
        found.step(STEPS / 2).unwrap();
        let [angles, _] = absolute(&found);
        let error = (angles[0] + start[0]).abs().max((angles[1] + start[1]).abs());
        assert!(error < 10.0 * (ratio.abs() * amplitude).max(amplitude).powi(3), "{frequency} rad/s: {error:e}");
    }
}
