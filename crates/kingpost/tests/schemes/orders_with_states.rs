//! The implicit schemes keep their order where elements have continuous states: the memory of the water,
//! positioning with its filters and thrusters, cylinders, and a ship with its crane in waves.

use crate::common::gallery_files;

use kingpost::Simulation;
use serde_json::{Value, json};

const IMPLICIT: [&str; 3] = ["newmark", "generalized_alpha", "implicit_midpoint"];

/// Positions, velocities and the elements' states at the end of a run of the gallery.
fn end(name: &str, set: &[(&str, Value)], scheme: &str, step_s: f64, end_s: f64) -> [Vec<f64>; 3] {
    let of_scheme = [("simulation.integrator", json!(scheme)), ("simulation.step_s", json!(step_s))];
    let set: Vec<(&str, Value)> = set.iter().cloned().chain(of_scheme).collect();
    let mut simulation = Simulation::new(gallery_files::scenario(name, &set).setup().unwrap());
    simulation.step((end_s / step_s).round() as usize).unwrap_or_else(|error| panic!("{name}, {scheme}: {error}"));
    let (state, layout) = (simulation.state(), simulation.layout());
    [state.q.clone(), state.v.clone(), state.s[layout.ledger..].to_vec()]
}

/// The largest difference, over the largest entry.
fn distance(a: &[f64], b: &[f64]) -> f64 {
    let size = b.iter().fold(0.0_f64, |most, b| most.max(b.abs()));
    a.iter().zip(b).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs())) / size
}

/// Asserts order 2 within 0.1 of the three schemes from halving a step; the reference is RK4 at an eighth of the smaller
/// step, whose own error, of order 4, is far below.
fn assert_order_two(name: &str, set: &[(&str, Value)], step_s: f64, end_s: f64) {
    let exact = end(name, set, "rk4", step_s / 16.0, end_s);
    for scheme in IMPLICIT {
        let [coarse, fine] = [step_s, step_s / 2.0].map(|step_s| end(name, set, scheme, step_s, end_s));
        for (i, what) in ["q", "v", "s"].into_iter().enumerate() {
            if exact[i].is_empty() {
                continue;
            }
            let (coarse, fine) = (distance(&coarse[i], &exact[i]), distance(&fine[i], &exact[i]));
            let order = (coarse / fine).log2();
            assert!((order - 2.0).abs() < 0.1, "{name}, {scheme}, {what}: order {order} from {coarse:e} and {fine:e}");
        }
    }
}

#[test]
fn with_the_memory_of_the_water() {
    assert_order_two("sphere_decay", &[], 0.05, 4.0);
}

#[test]
fn of_a_ship_with_a_crane_in_waves() {
    assert_order_two("offshore_vessel", &[], 0.05, 8.0);
}

#[test]
fn with_dynamic_positioning() {
    assert_order_two("offshore_vessel_on_dp", &[], 0.05, 8.0);
}

#[test]
fn with_cylinders() {
    // The booms alone: where a servo leaves its torque limit inside a step, every scheme loses its order.
    assert_order_two("knuckle_boom_crane", &[("slew_to_deg", json!(0)), ("telescope_m", json!(0.0))], 0.002, 0.4);
}
