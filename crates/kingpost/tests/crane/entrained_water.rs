//! Water inside lifted objects, against Torricelli's times and hand calculations of weights.

use crate::common;

use common::splash::{BOX, DENSITY, GRAVITY, lowered};
use common::{simulation, values};
use kingpost::scenario::read;
use kingpost::simulation::Simulation;

/// Inside of a box of 4 by 3 by 2 m, of which steel takes 6 m3: 12 m3 over 2 m of height, a section of 6 m2.
const SECTION: f64 = 6.0;
/// C_d A_h over that section.
const FALL: f64 = 0.6 * 0.5 / SECTION;

fn perforated(joint: &str, filling: &str, simulation: &str) -> String {
    let inside = format!(
        "entrained_water: {{volume_m3: 12, height_m: 2, hole_area_m2: 0.5, discharge_coefficient: 0.6{filling}}}"
    );
    lowered(joint, "", &format!("shape: {BOX}, displaced_volume_m3: 6, {inside}"), simulation)
}

/// At a height of its centre over the still water.
fn held(height: f64, filling: &str) -> Simulation {
    let joint = format!("axis: [0, 0, 1], position_m: [0, 0, {height}], mode: held");
    simulation(&perforated(&joint, filling, "step_s: 0.05, duration_s: 60"))
}

/// sqrt(h) falls by C_d A_h / A sqrt(g / 2) t (White, *Fluid Mechanics*, on draining tanks). What the law differs by
/// where the levels are within a millimetre is (1 mm / h)^2 / 4 of the rate: of 0.4 m, 2e-6.
#[test]
fn a_full_load_in_the_air_drains_in_torricellis_time() {
    let mut load = held(5.0, ", initial_filling: 1");
    let by = FALL * (GRAVITY / 2.0).sqrt();
    for _ in 0..7 {
        load.step(10).unwrap();
        let exact = (2.0_f64.sqrt() - by * load.time_s()).powi(2);
        assert!(exact > 0.3, "{exact}");
        let found = values(&mut load, "entrained_water")[0] / (DENSITY * SECTION);
        assert!((found - exact).abs() < 1e-5, "{found} m, not {exact} m");
        let weight = values(&mut load, "entrained_weight")[0];
        assert!((weight - DENSITY * GRAVITY * SECTION * found).abs() < 1e-6 * weight, "{weight}");
    }
    // All of it after 2 A / (C_d A_h) sqrt(H / (2 g)), but for what is as high as the millimetre within a factor.
    let time_s = 2.0_f64.sqrt() / by;
    load.step(((time_s - load.time_s()) / 0.05).ceil() as usize).unwrap();
    let left = values(&mut load, "entrained_water")[0] / (DENSITY * SECTION);
    assert!(left.abs() < 5e-3, "{left} m after {time_s} s");
}

/// With its floor 1.2 m under water it fills to there as it would drain.
#[test]
fn an_empty_load_in_the_water_fills_to_the_level_of_the_sea() {
    let mut load = held(-0.2, ", initial_filling: 0");
    let by = FALL * (GRAVITY / 2.0).sqrt();
    for _ in 0..4 {
        load.step(10).unwrap();
        let head = (1.2_f64.sqrt() - by * load.time_s()).powi(2);
        assert!(head > 0.2, "{head}");
        let found = values(&mut load, "entrained_water")[0] / (DENSITY * SECTION);
        assert!((found - (1.2 - head)).abs() < 1e-5, "{found} m, not {} m", 1.2 - head);
    }
    load.step(1100).unwrap();
    let found = values(&mut load, "entrained_water")[0] / (DENSITY * SECTION);
    assert!((found - 1.2).abs() < 1e-9, "{found} m");
}

#[test]
fn the_hook_load_is_the_weight_less_buoyancy_with_the_water_inside() {
    // Of a share of the box that is under water; water inside, m3, beyond what the sea outside would fill.
    for (height, filling, under, beyond) in [
        (5.0, 1.0, 0.0, 12.0),   // lifted out full
        (5.0, 0.25, 0.0, 3.0),   // drained by three quarters
        (-3.0, 1.0, 1.0, 0.0),   // full, under water
        (-3.0, 0.0, 1.0, -12.0), // empty there: it lifts
        (0.0, 1.0, 0.5, 6.0),    // half out, full
        (0.0, 0.5, 0.5, 0.0),    // as high as the sea
    ] {
        let mut load = held(height, &format!(", initial_filling: {filling}"));
        let exact = DENSITY * GRAVITY * (6.0 * under - beyond);
        let found = values(&mut load, "submerged_force")[2];
        assert!((found - exact).abs() < 1e-8 * DENSITY * GRAVITY * 12.0, "{found} N, not {exact} N at {height} m");
        let carried = values(&mut load, "joint_force")[0];
        let weight = 20000.0 * GRAVITY - exact;
        assert!((carried - weight).abs() < 1e-9 * weight.abs(), "{carried} N, not {weight} N");
    }
    // Without a filling the water is as high inside as outside.
    for height in [5.0, 0.3, -0.7, -4.0] {
        assert!(values(&mut held(height, ""), "entrained_weight")[0].abs() < 1e-9);
    }
}

/// Water inside has weight and inertia, so it falls freely with the box. A box without drag in the air:
/// rounding.
#[test]
fn a_full_load_in_the_air_falls_freely() {
    let text =
        perforated("axis: [0, 0, 1], position_m: [0, 0, 50]", ", initial_filling: 1", "step_s: 0.01, duration_s: 2");
    let mut load = simulation(&text);
    load.step(100).unwrap();
    let speed = load.state().v[0];
    assert!((speed + GRAVITY).abs() < 1e-11, "{speed}");
}

/// A load on a spring goes through the surface and fills and drains; what the water does is booked. The law has a kink where the
/// sea passes the floor or the top of the space inside: the error is of second order in the step there, of fourth elsewhere.
#[test]
fn energy_and_momentum_are_conserved_while_a_load_fills_and_drains() {
    let errors = |step: f64| {
        let text = perforated(
            "axis: [0, 0, 1], initial_speed_m_s: 6, spring: {stiffness_N_per_m: 1e5, rest_m: 0.5}",
            ", initial_filling: 0.8",
            &format!("step_s: {step}, duration_s: 4"),
        );
        let mut load = simulation(&text);
        load.run(|_| true).status.expect("it ends");
        assert!(load.events().iter().any(|event| event.what == "leaves the water"), "{:?}", load.events());
        let of = |load: &mut Simulation, name: &str| values(load, name)[0].abs();
        [
            of(&mut load, "energy_error") / of(&mut load, "energy_scale"),
            of(&mut load, "linear_momentum_error") / 20000.0,
        ]
    };
    let [coarse, fine] = [0.01, 0.0025].map(errors);
    assert!(coarse.iter().all(|error| *error < 1e-4), "{coarse:?}");
    for (coarse, fine) in coarse.iter().zip(fine) {
        assert!(fine < coarse / 8.0 || fine < 1e-9, "{fine:e}, and {coarse:e} at four times the step");
    }
}

#[test]
fn a_run_from_equilibrium_floats_with_the_sea_inside() {
    // 6 m3 of steel displace 6.15 t; of 4.1 t two thirds are under water, whatever stands inside.
    let text = perforated("axis: [0, 0, 1]", "", "step_s: 0.01, duration_s: 1, begin_at_equilibrium: true")
        .replace("20000", "4100");
    let mut load = simulation(&text);
    assert!((load.state().q[0] + 2.0 / 6.0).abs() < 1e-9, "{:?}", load.state().q);
    assert!(values(&mut load, "entrained_weight")[0].abs() < 1e-6);
    load.step(100).unwrap();
    assert!(load.state().v[0].abs() < 1e-9, "{:?}", load.state().v);
}

#[test]
fn a_load_that_drains_has_exact_derivatives() {
    common::assert_linearised(&perforated(
        "axis: [0, 0, 1], position_m: [0, 0, 1.5]",
        ", initial_filling: 1",
        "step_s: 0.001, duration_s: 1",
    ));
}

#[test]
fn a_mistake_in_entrained_water_is_reported_at_its_place() {
    let good = perforated("axis: [0, 0, 1]", ", initial_filling: 1", "step_s: 0.05, duration_s: 1");
    for (from, to, expected) in [
        (
            "volume_m3: 12",
            "volume_m3: 19",
            "volume_m3: found 19, allowed: at most the volume of the solid less displaced_volume_m3, 18.000000 m3",
        ),
        ("volume_m3: 12", "volume_m3: 0", "volume_m3: found 0"),
        (
            "height_m: 2, hole",
            "height_m: 2.5, hole",
            "height_m: found 2.5, allowed: at most the height of the solid, 2.000000 m",
        ),
        ("hole_area_m2: 0.5", "hole_area_m2: -1", "hole_area_m2: found -1"),
        ("discharge_coefficient: 0.6", "discharge_coefficient: 1.6", "discharge_coefficient: found 1.6"),
        ("initial_filling: 1", "initial_filling: 1.1", "initial_filling: found 1.1"),
    ] {
        assert!(good.contains(from), "{from}");
        let found = read(&good.replacen(from, to, 1), "load.yaml", &[])
            .and_then(|read| read.setup())
            .expect_err("a mistake")
            .to_string();
        assert!(found.contains(&format!("forces.water.submerged.entrained_water.{expected}")), "{found}\n{expected}");
    }
}
