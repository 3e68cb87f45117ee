//! Cylinders that compensate heave by a sheave in the hoist rope: passive by gas, active, and both, against closed forms.

use crate::common;
use crate::heave_compensation::{carried, rest};

use common::values;
use kingpost::Simulation;
use kingpost::scenario::read;
use serde_json::{Value, json};
use std::f64::consts::TAU;

/// A heavy deck on a spring, which heaves with an amplitude of 0.1 m, and a load of 100 kg on a rope that runs over a sheave
/// on a carriage of 50 kg: over it the rope is laid back on itself, so the load rises by twice the carriage's way. The gas
/// carries the load: F = 2 m g.
const DECK: &str = "
version: 1
title: A cylinder in the hoist rope
simulation: {step_s: 0.005, duration_s: 300, record_every_s: 0.1}
bodies:
  deck:
    mass_kg: 1.0e7
    shape: {box: {length_m: 4, width_m: 2, height_m: 1}}
    joint: {prismatic: {axis: [0, 0, 1], initial_extension_m: 0.1, spring: {stiffness_N_per_m: 6.168502750680849e6, rest_m: 15.897942169058107}}}
  carriage:
    parent: deck
    mass_kg: 50
    shape: {box: {length_m: 0.5, width_m: 0.5, height_m: 0.5}}
    joint:
      prismatic:
        name: slide
        axis: [-1, 0, 0]
        position_m: [-4, 0, 1.3]
        damping_N_s_m: 200
        limits: {lower_m: -2, upper_m: 2, stiffness_N_per_m: 1.0e5}
        gas_spring: {piston_area_m2: 0.01, gas_volume_m3: 0.1, pressure_Pa: 297458.0}
  load:
    mass_kg: 100
    shape: {sphere: {radius_m: 0.5}}
    joint: {prismatic: {axis: [0, 0, 1], position_m: [2, 0, 0], initial_extension_m: -18.9}}
forces:
  gravity: {gravity: {}}
  hoist:
    rope:
      path:
        - point: {body: deck, position_m: [0, 0, 1.6]}
        - sheave: {body: carriage, position_m: [0, 0, 0], radius_m: 0.3, axis: [0, -1, 0]}
        - point: {body: deck, position_m: [2, 0, 1.0]}
        - point: {body: load, position_m: [0, 0, 0]}
      axial_stiffness_N: 1.0e6
      unstretched_length_m: 30.912163
      damping_time_s: 0.02
";

/// A drive of the carriage, so stiff that it follows its reference, and its controller.
const ACTIVE: &str = "
drives:
  cylinder:
    linear_controlled_drive: {joint: slide, set_point: {speed: {}}, speed_limit_m_s: 20, acceleration_limit_m_s2: 200, force_limit_N: 50000, stiffness_N_per_m: 5.0e5, damping_N_s_per_m: 5000, response_time_s: 0.1}
controllers:
  keep: {heave_compensation: {rope: hoist, drive: cylinder, period_s: 0.05, position_gain_per_s: 0}}
";
const GRAVITY: f64 = 9.80665;
const LOAD: f64 = 100.0;
const CARRIAGE: f64 = 50.0;
const AMPLITUDE: f64 = 0.1;
const DECK_S: f64 = 8.0;

fn opened(text: &str, changes: &[(&str, Value)]) -> Result<Simulation, String> {
    let changes: Vec<(String, Value)> =
        changes.iter().map(|(path, value)| ((*path).to_owned(), value.clone())).collect();
    let scenario = read(text, "deck.yaml", &changes).map_err(|error| error.to_string())?;
    scenario.simulation().map_err(|error| error.to_string())
}

fn active() -> String {
    [DECK, ACTIVE].concat()
}

/// Amplitudes at a period, over 4 periods after the first 160 s, of variables of one column.
fn amplitudes<const N: usize>(
    simulation: &mut Simulation,
    period_s: f64,
    read: impl Fn(&mut Simulation) -> [f64; N],
) -> [f64; N] {
    simulation.step(32_000).unwrap();
    let steps = (4.0 * period_s / 0.005).round() as usize;
    let mut sums = [[0.0; 2]; N];
    for k in 0..steps {
        let (sine, cosine) = (TAU * 4.0 * k as f64 / steps as f64).sin_cos();
        for (sum, value) in sums.iter_mut().zip(read(simulation)) {
            *sum = [sum[0] + value * cosine, sum[1] + value * sine];
        }
        simulation.step(1).unwrap();
    }
    sums.map(|[cosine, sine]| 2.0 * cosine.hypot(sine) / steps as f64)
}

fn heights(simulation: &mut Simulation) -> [f64; 2] {
    let q = &simulation.state().q;
    [q[0], q[2]]
}

/// The deck's spring for a period.
fn of_period(period_s: f64) -> [(&'static str, Value); 2] {
    let square = TAU * TAU / (period_s * period_s);
    [
        ("bodies.deck.joint.prismatic.spring.stiffness_N_per_m", json!(1.0e7 * square)),
        ("bodies.deck.joint.prismatic.spring.rest_m", json!(GRAVITY / square)),
    ]
}

/// n p A^2 / V.
fn gas_stiffness() -> f64 {
    1.4 * 297_458.0 * 1e-4 / 0.1
}

/// With the deck's height z, the carriage's way x and the stretch s of the rope, whose stiffness is k_r and damping time t,
/// the load's height is z_l = z + 2 x - s, where m z_l'' = k_r (s + t s') and m_c x'' + c x' + k x = -2 m z_l''. So the load
/// keeps of the deck's motion D / (D (1 - m w^2 / (k_r (1 + i w t))) - 4 m w^2) with D = k + i w c - m_c w^2.
#[test]
fn the_residual_of_passive_compensation_by_gas_is_that_of_its_transfer_function() {
    let (damping, stiffness, of_rope) = (200.0, gas_stiffness(), 1e6 / 30.912163);
    for period_s in [5.0, DECK_S, 12.0] {
        let mut simulation = opened(DECK, &of_period(period_s)).unwrap();
        let [deck, load] = amplitudes(&mut simulation, period_s, heights);
        let w = TAU / period_s;
        let (real, imaginary) = (stiffness - CARRIAGE * w * w, w * damping);
        let (late, stretched) = (0.02 * w, LOAD * w * w / of_rope);
        let [left, lags] = [1.0 - stretched / (1.0 + late * late), stretched * late / (1.0 + late * late)];
        let rest = (real * left - imaginary * lags - 4.0 * LOAD * w * w).hypot(real * lags + imaginary * left);
        let expected = real.hypot(imaginary) / rest;
        // The gas is not linear: at x A / V = 1 % its stiffness changes by 2 %, of which the first harmonic sees the square.
        assert!((load / deck / expected - 1.0).abs() < 1e-3, "{period_s} s: {}, not {expected}", load / deck);
        let error = values(&mut simulation, "energy_error")[0];
        assert!(error.abs() < 1e-5 * 0.5e7 * (w * AMPLITUDE).powi(2), "{period_s} s: {error} J");
    }
}

#[test]
fn a_cylinder_compensator_has_the_residual_of_a_winch_and_its_gas_carries_the_weight() {
    let without_gas = [("bodies.carriage.joint.prismatic.gas_spring", Value::Null)];
    for period_s in [5.0, DECK_S] {
        let w = TAU / period_s;
        let expected = rest(carried(w, 0.0));
        for (gas, stiffness) in [(true, gas_stiffness()), (false, 0.0)] {
            let changes = [of_period(period_s).to_vec(), if gas { vec![] } else { without_gas.to_vec() }].concat();
            let mut simulation = opened(&active(), &changes).unwrap();
            let [deck, load, residual, force] = amplitudes(&mut simulation, period_s, |simulation| {
                let [deck, load] = heights(simulation);
                let [residual, force] =
                    ["compensation_residual", "drive_force"].map(|variable| values(simulation, variable)[0]);
                [deck, load, residual, force]
            });
            // The formula is that of the drum's tests. Here the drive gives way by its force over its stiffness.
            let gives_way = 2.0 * force / 5.0e5 / deck;
            let off = (residual / deck - expected).abs();
            assert!(off < 5e-4 + gives_way, "{period_s} s, gas {gas}: {}, not {expected}", residual / deck);
            assert!((load - residual).abs() < 2e-3 * deck, "{period_s} s, gas {gas}: {load} m, not {residual} m");
            // Where the load stays, x = -z / 2 and the drive moves gas and carriage: (k + i w c - m_c w^2) x; the load's
            // own motion, `expected` of z, adds 2 m w^2 to it.
            let own = (stiffness - CARRIAGE * w * w).hypot(200.0 * w) * 0.5 * deck;
            let of_load = 2.0 * LOAD * w * w * expected * deck;
            assert!(
                (force - own).abs() < 1.05 * of_load + 0.01 * own,
                "{period_s} s, gas {gas}: {force} N, not {own} N"
            );
            let mean = values(&mut simulation, "drive_force")[0];
            let carries = if gas { 0.0 } else { 2.0 * LOAD * GRAVITY };
            assert!((mean.abs() - carries).abs() < 2.0 * (force + of_load) + 1.0, "{mean} N, not {carries} N");
        }
    }
}

/// Checks that the rope let out is the change of the path, also where the parts are not parallel to the carriage's way.
#[test]
fn inclined_parts_of_a_rope_are_compensated_by_their_length() {
    let slanted = [
        ("forces.hoist.rope.path.2.point.position_m", json!([2, 0, 3.0])),
        ("forces.hoist.rope.path.0.point.position_m", json!([-1, 0, 2.6])),
        ("controllers.keep.heave_compensation.position_gain_per_s", json!(0.5)),
        ("bodies.deck.joint.prismatic.initial_extension_m", json!(1)),
        ("bodies.load.joint.prismatic.initial_extension_m", json!(-18)),
        ("forces.hoist.rope.unstretched_length_m", Value::Null),
    ];
    let mut simulation = opened(&active(), &slanted).unwrap();
    let [deck, load, residual] = amplitudes(&mut simulation, DECK_S, |simulation| {
        let [deck, load] = heights(simulation);
        [deck, load, values(simulation, "compensation_residual")[0]]
    });
    assert!((load - residual).abs() < 2e-3 * deck, "{load} m, not {residual} m");
    assert!(residual < 0.12 * deck, "{residual} m of {deck} m");
}

#[test]
fn a_drive_without_a_sheave_between_drum_and_tip_is_refused_with_its_joint() {
    let allowed = "allowed: the drive of the drum of hoist, or of a joint between drum and tip that moves its sheaves";
    let joint = |name: &str| [("drives.cylinder.linear_controlled_drive.joint", json!(name))];
    let error = opened(&active(), &joint("load")).expect_err("the load's joint");
    assert!(error.contains(&format!("found cylinder, which drives load, {allowed}")), "{error}");
    // The deck moves all places up to the tip.
    let error = opened(&active(), &joint("deck")).expect_err("the deck's joint");
    assert!(error.contains(&format!("found cylinder, which drives deck, {allowed}")), "{error}");
}
