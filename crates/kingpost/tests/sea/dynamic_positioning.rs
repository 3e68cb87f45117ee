//! Dynamic positioning of ships against closed forms.

use crate::common;

use common::barge::{self, station};
use common::{simulation, values};
use core::f64::consts::{PI, TAU};
use kingpost::analysis::{Linearizer, gradient};
use kingpost::batch;
use kingpost::integrate::{Stage, System};
use kingpost::plant::Plant;
use kingpost::scenario::{read, read_with};
use kingpost::simulation::Simulation;
use nalgebra::{DMatrix, DVector};
use serde_json::json;

const MASS: f64 = 1e6;
const INERTIA: f64 = 4e8;

/// Two tunnels and two main propellers in the plane of the centre of mass, of 10 MN each.
const STRONG: &str = "bow: {tunnel: {position_m: [30, 0, 0], max_thrust_kN: 1e4, time_constant_s: 2}}, \
                      stern: {tunnel: {position_m: [-25, 0, 0], max_thrust_kN: 1e4, time_constant_s: 2}}, \
                      port: {main_propeller: {position_m: [-35, 4, 0], max_thrust_kN: 1e4, max_astern_thrust_kN: 1e4, \
                      time_constant_s: 2}}, \
                      starboard: {main_propeller: {position_m: [-35, -4, 0], max_thrust_kN: 1e4, \
                      max_astern_thrust_kN: 1e4, time_constant_s: 2}}";

/// Gains for 100 s and 0.7, and for 80 s and 0.9 in yaw.
const GAINS: &str = "natural_periods: {integral: false, surge: {mass_t: 1000, period_s: 100, damping_ratio: 0.7}, \
                     sway: {mass_t: 1000, period_s: 100, damping_ratio: 0.7}, \
                     yaw: {inertia_kg_m2: 4e8, period_s: 80, damping_ratio: 0.9}}";

/// A ship of 1000 t without gravity and water.
fn ship(initial: &str, positioning: &str, more: &str) -> String {
    format!(
        "version: 1\ntitle: A ship on dynamic positioning\nsimulation: {{step_s: 0.1, duration_s: 100}}\nbodies:\n  \
         ship:\n    mass_t: 1000\n    inertia: {{tensor: {{moments_kg_m2: [2e7, 4e8, 4e8]}}}}\n    \
         joint: {{floating: {{initial: {{{initial}}}}}}}\nforces:\n  dp: {{dynamic_positioning: {{body: ship, \
         {positioning}}}}}\n{more}"
    )
}

fn positioning(gains: &str, thrusters: &str, more: &str) -> String {
    format!("gains: {{{gains}}}, thrusters: {{{thrusters}}}{more}")
}

/// exp(A t) by its series, A t halved until it is small.
fn exponential(a: &DMatrix<f64>, t: f64) -> DMatrix<f64> {
    let (n, halvings) = (a.nrows(), 20);
    let a = a * (t / f64::from(1 << halvings));
    let mut sum = DMatrix::identity(n, n);
    let mut term = sum.clone();
    for k in 1..20 {
        term = &term * &a / f64::from(k);
        sum += &term;
    }
    (0..halvings).fold(sum, |power, _| &power * &power)
}

/// x, v, thrust of a mass m under T' = (-k x - c v - T) / tau.
fn third_order(m: f64, [k, c]: [f64; 2], tau: f64) -> DMatrix<f64> {
    DMatrix::from_row_slice(3, 3, &[0.0, 1.0, 0.0, 0.0, 0.0, 1.0 / m, -k / tau, -c / tau, -1.0 / tau])
}

fn gains(m: f64, period: f64, damping: f64) -> [f64; 2] {
    let omega = TAU / period;
    [m * omega * omega, 2.0 * damping * omega * m]
}

/// Surge, sway and yaw of a free ship are the linear system of its mass, its gains and the thrusters' time constant; with
/// fast thrusters the oscillator of the given period and damping.
#[test]
fn a_free_ship_returns_with_its_period_and_damping() {
    let target = ", target: {x_m: 100, y_m: 50, heading_deg: 30}";
    let (sin, cos) = libm::sincos(PI / 6.0);
    let sway_first =
        format!("position_m: [{}, {}, 0], orientation_deg: [0, 0, 30]", 100.0 - 3.0 * sin, 50.0 + 3.0 * cos);
    let yaw_first = "position_m: [100, 50, 0], orientation_deg: [0, 0, 35]".to_owned();
    let cases = [(sway_first, MASS, [100.0, 0.7], 3.0, 1), (yaw_first, INERTIA, [80.0, 0.9], 5_f64.to_radians(), 2)];
    for (initial, inertia, [period, damping], from, axis) in cases {
        let mut ship = simulation(&ship(&initial, &positioning(GAINS, STRONG, target), ""));
        let [k, c] = gains(inertia, period, damping);
        let system = third_order(inertia, [k, c], 2.0);
        let begin = DVector::from_vec(vec![from, 0.0, -k * from]);
        for seconds in [0, 10, 40] {
            let expected = exponential(&system, ship.time_s() + f64::from(seconds)) * &begin;
            ship.step(10 * seconds as usize).unwrap();
            let (error, force) = (values(&mut ship, "station_error"), values(&mut ship, "station_force"));
            // RK4 at a twentieth of the fastest time constant: (h / tau)^4 / 120 of what is left of a mode.
            assert!((error[axis] + expected[0]).abs() < 1e-7 * from, "{} {}", error[axis], expected[0]);
            assert!((force[axis] - expected[2]).abs() < 1e-6 * k * from);
        }
    }
    let quick = STRONG.replace("time_constant_s: 2", "time_constant_s: 1e-3");
    let initial = "position_m: [3, 0, 0]";
    let text = ship(initial, &positioning(GAINS, &quick, ""), "").replace("step_s: 0.1", "step_s: 0.001");
    let mut ship = simulation(&text);
    ship.step(20_000).unwrap();
    let (omega, zeta) = (TAU / 100.0, 0.7);
    let damped = omega * libm::sqrt(1.0 - zeta * zeta);
    let (sin, cos) = libm::sincos(damped * 20.0);
    let expected = 3.0 * libm::exp(-zeta * omega * 20.0) * (cos + zeta * omega / damped * sin);
    // What the thrusters lag: of the order of omega tau.
    assert!((ship.state().q[0] - expected).abs() < 3.0 * omega * 1e-3);
}

/// With equal gains in surge and sway a ship moves straight to its target, however it rotates meanwhile, and
/// it rotates by the smaller angle across pi.
#[test]
fn a_ship_moves_straight_to_its_target_and_turns_by_the_smaller_angle() {
    let quick = STRONG.replace("time_constant_s: 2", "time_constant_s: 0.01");
    let initial = "position_m: [4, -3, 0], orientation_deg: [0, 0, -170]";
    let dp = positioning(GAINS, &quick, ", target: {heading_deg: 170}");
    let mut ship = simulation(&ship(initial, &dp, "").replace("step_s: 0.1", "step_s: 0.01"));
    assert!((values(&mut ship, "station_error")[2] + 20_f64.to_radians()).abs() < 1e-12);
    for _ in 0..10 {
        ship.step(500).unwrap();
        let q = &ship.state().q;
        // The lag of the thrusters turns the force by tau times the yaw rate.
        assert!((3.0 * q[0] + 4.0 * q[1]).abs() < 5.0 * 5.0 * 0.01 * 0.03, "{q:?}");
        assert!(values(&mut ship, "station_error")[2].abs() < 20.1_f64.to_radians());
    }
}

/// A current that pulls with c U - c v: position, velocity, thrust and integral are a linear system, which comes to rest
/// at the target; its slowest root is that of the integral time.
#[test]
fn the_integral_takes_a_constant_load_in_its_time() {
    let (c, u, integral_time) = (2e4, 1.5, 150.0);
    let with_integral = GAINS
        .replace("integral: false, ", "")
        .replace("period_s: 100, damping_ratio: 0.7", "period_s: 100, damping_ratio: 0.7, integral_time_s: 150");
    let water = "  water: {viscous_damping: {body: ship, linear_N_s_m: [2e4, 2e4, 0]}}\nsea: {current_m_s: [0, 1.5]}\n";
    let mut ship = simulation(&ship("", &positioning(&with_integral, STRONG, ""), water));
    let [k, d] = gains(MASS, 100.0, 0.7);
    let ki = k / integral_time;
    #[rustfmt::skip]
    let system = DMatrix::from_row_slice(5, 5, &[
        0.0, 1.0, 0.0, 0.0, 0.0,
        0.0, -c / MASS, 1.0 / MASS, 0.0, c * u / MASS,
        -k / 2.0, -d / 2.0, -0.5, 0.5, 0.0,
        -ki, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0,
    ]);
    let begin = DVector::from_vec(vec![0.0, 0.0, 0.0, 0.0, 1.0]);
    let mut seen = Vec::new();
    for k in 1..=6 {
        ship.step(2000).unwrap();
        let expected = exponential(&system, 200.0 * f64::from(k)) * &begin;
        let found = values(&mut ship, "station_error")[1];
        assert!((found + expected[0]).abs() < 1e-8, "{found} {}", expected[0]);
        seen.push(found.abs());
    }
    assert!(seen[5] < 5e-3 * seen[0]);
    // K_p + K_d s + m s^2 + K_i / s = 0: s = -K_i / K_p (1 + (K_d + c) K_i / K_p^2 + ...), the next term its square twice.
    let second = (d + c) * ki / (k * k);
    let slowest = ki / k * (1.0 + second);
    let found = libm::log(seen[3] / seen[5]) / 400.0;
    assert!((found / slowest - 1.0).abs() < 2.5 * second * second, "{found} {slowest} {second}");
    assert!((values(&mut ship, "station_force")[1] + c * u).abs() < 0.01 * c * u);
    // All that moves is in the ledger.
    assert!(values(&mut ship, "energy_error")[0].abs() < 1e-3);
    assert!(values(&mut ship, "linear_momentum_error")[0].abs() < 1e-3);
}

const WEAK: &str = "bow: {tunnel: {position_m: [30, 0, 0], max_thrust_kN: 50, time_constant_s: 2}}, \
                    stern: {azimuth: {position_m: [-30, 0, 0], max_thrust_kN: 120, time_constant_s: 2}}";

/// Far from its target a ship gets the full thrust of its thrusters in the direction of the target, and no
/// thruster exceeds its limit.
#[test]
fn beyond_its_limits_the_thrust_keeps_its_direction_at_the_largest_magnitude() {
    let initial = "position_m: [300, 400, 0]";
    let mut ship = simulation(&ship(initial, &positioning(GAINS, WEAK, ""), ""));
    let (command, force) = (values(&mut ship, "station_command"), values(&mut ship, "station_force"));
    assert!((command[0] / command[1] - 0.75).abs() < 1e-12 && command[2].abs() < 1e-6);
    // Half of the sway is the tunnel's: it has 50 kN.
    assert!((force[1] + 1e5).abs() < 1e-6 && (force[0] + 7.5e4).abs() < 1e-6);
    assert!((values(&mut ship, "thruster_thrust")[0] + 5e4).abs() < 1e-6);
    assert_eq!(
        ship.channels().iter().find(|c| c.variable == "thruster_thrust").unwrap().labels[0],
        ["dp.bow", "dp.stern"]
    );
    for _ in 0..50 {
        ship.step(100).unwrap();
        assert!(values(&mut ship, "thruster_utilisation").iter().all(|share| *share <= 1.0 + 1e-12));
    }
    assert!(values(&mut ship, "station_error").iter().all(|error| error.abs() < 0.5));
}

/// Checks that thrust below the centre of mass heels the ship: the moment is force times lever.
#[test]
fn thrust_acts_where_the_thruster_is() {
    let low = WEAK.replace("0, 0]", "0, -6]");
    let mut ship = simulation(&ship("position_m: [0, 2, 0]", &positioning(GAINS, &low, ", position_m: [5, 0, 1]"), ""));
    let force = values(&mut ship, "station_force");
    let a = ship.acceleration(None).unwrap();
    assert!((a[1] * MASS - force[1]).abs() < 1e-6 && force[1] < -1e3);
    assert!((a[3] * 2e7 - 6.0 * force[1]).abs() < 1e-5);
    assert!((a[5] * INERTIA - (force[2] + 5.0 * force[1])).abs() < 1e-4);
}

/// The integral of a ship that comes from far with thrusters at their limits does not wind up: otherwise the
/// ship would overshoot its target by much more.
#[test]
fn an_integral_does_not_wind_up_while_thrusters_are_at_their_limits() {
    let with_integral = GAINS.replace("integral: false, ", "");
    let past = |more: &str| {
        let mut ship = simulation(&ship("position_m: [-150, 0, 0]", &positioning(&with_integral, WEAK, more), ""));
        let (mut most, mut limited) = (0.0_f64, false);
        for _ in 0..1500 {
            ship.step(10).unwrap();
            let (error, demand) = (values(&mut ship, "station_error"), values(&mut ship, "station_demand"));
            limited |= values(&mut ship, "station_command")[0] < 0.9 * demand[0];
            most = most.max(-error[0]);
        }
        assert!(limited);
        (most, values(&mut ship, "station_error")[0].abs())
    };
    let ((with, rest), (without, _)) = (past(""), past(", anti_windup_time_s: 1e12"));
    assert!(with < 0.35 * without, "{with} m against {without} m");
    assert!(rest < 0.5, "{rest}");
}

const AT_REST: &str = ", begin_at_equilibrium: true";

fn at_sea(text: &str, pairs: &[(&str, serde_json::Value)]) -> Simulation {
    let pairs: Vec<_> = pairs.iter().map(|(name, value)| ((*name).to_owned(), value.clone())).collect();
    read_with(text, "test.yaml", &pairs, &barge::files()).expect("it reads").simulation().expect("it builds")
}

/// At rest a ship is at its target, and its thrusters balance the load of the current; it stays there.
#[test]
fn an_equilibrium_is_on_station_with_the_mean_load_in_the_integrals() {
    let mut ship = at_sea(&station(AT_REST), &[]);
    let error = values(&mut ship, "station_error");
    assert!(error.iter().all(|error| error.abs() < 1e-8), "{error:?}");
    let (sin, cos) = libm::sincos(PI / 9.0);
    let force = values(&mut ship, "station_force");
    // Linear drag of the upright hull, c (u cos + v sin); heel and trim by thrusters below the drag's point are small.
    assert!((force[0] + 1e4 * (0.5 * cos - 0.6 * sin)).abs() < 20.0, "{force:?}");
    assert!((force[1] + 3e4 * (-0.6 * cos - 0.5 * sin)).abs() < 20.0, "{force:?}");
    assert!(ship.acceleration(None).unwrap().iter().all(|a| a.abs() < 1e-9));
    let before = ship.state().q.clone();
    ship.step(5000).unwrap();
    for (now, before) in ship.state().q.iter().zip(&before) {
        assert!((now - before).abs() < 1e-6, "{now} {before}");
    }
}

/// A current load beyond the capacity of the thrusters is reported before the run.
#[test]
fn an_equilibrium_beyond_the_thrusters_is_refused_by_name() {
    let weak = station(AT_REST).replace("max_thrust_kN: 40", "max_thrust_kN: 8");
    let error = read_with(&weak, "test.yaml", &[], &barge::files()).unwrap_err().to_string();
    assert!(
        error.contains(
            "begin_at_equilibrium: found true, and no equilibrium: dp would have to give 1.101 times its capacity"
        ),
        "{error}"
    );
}

#[test]
fn a_ship_holds_its_station_in_current_and_waves() {
    let swell = [("sea.waves.swell.regular.enabled", json!(true))];
    let mut ship = at_sea(&station(""), &swell);
    ship.step(20_000).unwrap();
    let (mut sums, mut thrust, period) = ([0.0; 3], 0.0_f64, 300);
    for _ in 0..4 * period {
        ship.step(1).unwrap();
        let (error, command) = (values(&mut ship, "station_error"), values(&mut ship, "station_command"));
        (0..3).for_each(|k| sums[k] += error[k] / f64::from(4 * period));
        thrust = thrust.max(command[1].abs());
    }
    // Over whole waves; what is left of the approach after 400 s at an integral time of 95 s.
    assert!(sums.iter().all(|mean| mean.abs() < 0.05), "{sums:?}");
    assert!(thrust < 4e4, "the thrusters answer the waves: {thrust} N");
}

/// Checks that a run after a snapshot, and each run in a batch of several, is bitwise identical.
#[test]
fn snapshots_and_batches_are_bitwise_identical() {
    let mut ship = at_sea(&station(""), &[]);
    ship.step(700).unwrap();
    let bytes = ship.snapshot();
    ship.step(300).unwrap();
    let mut other = at_sea(&station(""), &[]);
    other.restore(&bytes).unwrap();
    other.step(300).unwrap();
    let bits = |simulation: &Simulation| simulation.state().s.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
    assert_eq!(bits(&ship), bits(&other));
    let short = station(AT_REST).replace("duration_s: 20", "duration_s: 2");
    let gain = "forces.dp.dynamic_positioning.target.x_m";
    let variants: Vec<batch::Variant> =
        (0..5).map(|k| [(gain.to_owned(), json!(4 + k))].into_iter().collect()).collect();
    let found = batch::run(&short, "test.yaml", &barge::files(), &variants, 2, |_| true).unwrap();
    for (k, run) in found.runs.iter().enumerate() {
        let alone = at_sea(&short, &[(gain, json!(4 + k))]).run(|_| true);
        assert!(run.rows.iter().zip(&alone.rows).all(|(a, b)| a.to_bits() == b.to_bits()), "{k}");
        assert_eq!(run.rows.len(), alone.rows.len());
    }
}

/// A by dual numbers and by central differences of all rates, those of integrals, filter and thrusters too; with thrusters
/// within their limits and at them.
#[test]
fn positioning_is_linearised_exactly() {
    for weak in [false, true] {
        let text =
            station("").replace("max_thrust_kN: 40", if weak { "max_thrust_kN: 2" } else { "max_thrust_kN: 90" });
        let scenario = read_with(&text, "test.yaml", &[], &barge::files()).unwrap();
        let mut ship = scenario.simulation().unwrap();
        ship.step(300).unwrap();
        let most = values(&mut ship, "thruster_utilisation").into_iter().fold(0.0, f64::max);
        assert_eq!(most > 0.999, weak, "{most}");
        let linear = Linearizer::new(&scenario).unwrap().at(&ship);
        let setup = scenario.setup().unwrap();
        let mut plant = Plant::new(setup.model, setup.world, setup.elements);
        let (at, n) = (ship.stage(), ship.state().v.len());
        let free = plant.model.free_coordinates();
        let extras = plant.layout().states.len();
        assert_eq!(linear.states.len(), 2 * free.len() + extras);
        assert_eq!(linear.accelerations().len(), free.len());
        let ledger = at.s.len() - extras;
        let mut rates = |column: usize, by: f64| {
            let (mut xi, mut v, mut s) = (vec![0.0; n], at.v.to_vec(), at.s.to_vec());
            match column {
                k if k < free.len() => xi[free[k]] += by,
                k if k < 2 * free.len() => v[free[k - free.len()]] += by,
                k => s[ledger + k - 2 * free.len()] += by,
            }
            let mut q = at.q.to_vec();
            plant.retract(at.q, &xi, &mut q);
            let (mut v_dot, mut s_dot) = (vec![0.0; n], vec![0.0; s.len()]);
            plant.rates(Stage { q: &q, v: &v, s: &s, ..at }, &mut v_dot, &mut s_dot);
            free.iter().map(|i| v_dot[*i]).chain(s_dot[ledger..].iter().copied()).collect::<Vec<_>>()
        };
        for column in 0..linear.states.len() {
            // Forces are of 1e4 N; motions, and the hull's place on average, of 1 m or rad.
            let is_motion = column < 2 * free.len() || linear.states[column].contains(".slow.");
            let h = if is_motion { 1e-5 } else { 10.0 };
            let (ahead, behind) = (rates(column, h), rates(column, -h));
            for row in 0..ahead.len() {
                let difference = (ahead[row] - behind[row]) / (2.0 * h);
                let exact = linear.a[(free.len() + row, column)];
                let scale = linear.a.row(free.len() + row).amax().max(1e-9);
                assert!((exact - difference).abs() < 1e-7 * scale, "{row} {column}: {exact} {difference}");
            }
        }
    }
}

/// Derivatives of the rest at the start, and of the run from there, with respect to the current.
#[test]
fn equilibria_have_their_derivatives() {
    let short = station(AT_REST).replace("duration_s: 20", "duration_s: 1");
    let names = ["sea.current_m_s.1", "forces.dp.dynamic_positioning.target.heading_rad"];
    let scenario = read_with(&short, "test.yaml", &[], &barge::files()).unwrap();
    let exact = gradient(&scenario, &names, |_| true).unwrap();
    let numbers = [-0.6, PI / 9.0];
    for (k, name) in names.iter().enumerate() {
        let h = 1e-4;
        let run = |by: f64| at_sea(&short, &[(name, json!(numbers[k] + by))]).run(|_| true);
        let (ahead, behind) = (run(h), run(-h));
        let first = at_sea(&short, &[]);
        for variable in ["position", "station_force", "station_demand", "thruster_thrust"] {
            let channel = first.channels().iter().find(|channel| channel.variable == variable).unwrap();
            for row in [0, exact.rows.len() / exact.columns - 1] {
                let entries = || (0..channel.len).map(|i| row * ahead.columns + channel.offset + i);
                let difference = |i: usize| (ahead.rows[i] - behind.rows[i]) / (2.0 * h);
                let scale = entries().map(|i| difference(i).abs()).fold(0.0, f64::max);
                for i in entries() {
                    let found = exact.derivatives[k][i];
                    // The rounding of the equilibria, 1e-8 m or rad and 100 K_p times that, over h.
                    assert!(
                        (found - difference(i)).abs() < 2e-4 * scale,
                        "{variable} {row}: {found} {}",
                        difference(i)
                    );
                }
            }
        }
    }
}

#[test]
fn a_positioning_that_cannot_hold_a_ship_is_refused() {
    let refused = |gains: &str, thrusters: &str, more: &str, message: &str| {
        let text = ship("", &positioning(gains, thrusters, more), "");
        let error = read(&text, "test.yaml", &[]).and_then(|s| s.setup().map(drop)).unwrap_err().to_string();
        assert!(error.contains(message), "{error}");
    };
    let field = "forces.dp.dynamic_positioning";
    refused(GAINS, "", "", &format!("{field}.thrusters: found no enabled thruster"));
    let off = WEAK.replace("{position_m", "{enabled: false, position_m");
    refused(GAINS, &off, "", &format!("{field}.thrusters: found no enabled thruster"));
    let one = "stern: {azimuth: {position_m: [-30, 0, 0], max_thrust_kN: 120, time_constant_s: 2}}";
    refused(GAINS, one, "", "thrusters that give surge, sway and yaw, but not independently");
    let tunnels = &STRONG[..STRONG.find("port").unwrap()];
    refused(GAINS, tunnels, "", "thrusters that give no force along the ship");
    let centred = one.replace("-30", "0");
    refused(GAINS, &centred, "", "thrusters that give no yaw moment");
    refused(
        GAINS,
        &WEAK.replace("kN: 50", "kN: -50"),
        "",
        "bow.tunnel.max_thrust_kN: found -50, allowed: a number greater",
    );
    refused(GAINS, &WEAK.replace("s: 2}", "s: 0}"), "", "bow.tunnel.time_constant_s: found 0");
    refused(GAINS, &WEAK.replace("[30", "[.nan"), "", "bow.tunnel.position_m.0: found");
    refused(GAINS, WEAK, ", target: {x_m: .inf}", "target.x_m: found");
    let winding = GAINS.replace("integral: false, ", "").replace("ratio: 0.9", "ratio: 0.9, integral_time_s: 7");
    refused(
        &winding,
        WEAK,
        "",
        &format!("{field}.gains.natural_periods.yaw.integral_time_s: found 7, allowed: more than"),
    );
    refused(GAINS, WEAK, ", wave_filter: {notch_periods_s: [8, 0]}", "wave_filter.notch_periods_s.1: found 0");
    let tiny = ", wave_filter: {notch_periods_s: [1.0e-100]}";
    refused(GAINS, WEAK, tiny, "wave_filter.notch_periods_s.0: found 1e-100, allowed: a number from 0.1 to 1000");
    // A low pass of 40 s delays at 100 s by more than the damping has to spare; one of 10 s does not.
    let filter = ", wave_filter: {notch_periods_s: [8], cutoff_period_s: 40}";
    refused(
        GAINS,
        WEAK,
        filter,
        &format!("{field}.gains.natural_periods.surge.period_s: found 100 s, with which the delays"),
    );
    read(&ship("", &positioning(GAINS, WEAK, &filter.replace("40", "10")), ""), "test.yaml", &[]).unwrap();
    let text = ship("", &positioning(GAINS, WEAK, ""), "").replace("body: ship", "body: shipp");
    let error = read(&text, "test.yaml", &[]).unwrap_err().to_string();
    assert!(error.contains("dynamic_positioning.body: found shipp, allowed: one of ship"), "{error}");
}
