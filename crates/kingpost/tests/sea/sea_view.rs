//! View of the sea: the hull's position and the surface around it.

use crate::common;

use common::barge::{BEAM, DRAUGHT, LENGTH, scenario};
use kingpost::elements::hull::SlowFilter;
use kingpost::ledger;
use kingpost::simulation::Simulation;
use serde_json::json;

const SWELL: &str = "sea.waves.swell.regular.enabled";
/// Height of the hull's centre of mass above its keel, m.
const CENTRE_ABOVE_KEEL: f64 = 2.0;

#[test]
fn a_hull_is_described_from_its_centre_of_mass() {
    let described = scenario(&[(SWELL, json!(true))]).describe().expect("it builds");
    let sea = described.sea.expect("a sea");
    assert_eq!((sea.density_kg_m3, sea.depth_m, sea.wave_components), (1025.0, None, 1));
    let [hull] = described.hulls.as_slice() else { panic!("one hull") };
    assert_eq!((hull.name.as_str(), hull.body.as_str()), ("water", "hull"));
    assert_eq!((hull.draught_m, hull.length_m, hull.beam_m), (DRAUGHT, LENGTH, BEAM));
    assert_eq!(hull.origin_m, [0.0, 0.0, DRAUGHT - CENTRE_ABOVE_KEEL]);
    let mesh = hull.mesh.as_ref().expect("a mesh");
    let lowest = mesh.vertices_m.iter().map(|vertex| vertex[2]).fold(f64::INFINITY, f64::min);
    assert_eq!(lowest, -CENTRE_ABOVE_KEEL, "the keel");
    assert!(mesh.triangles.iter().flatten().all(|&i| i < mesh.vertices_m.len()));
    let calm = scenario(&[]).describe().expect("it builds").sea.expect("a sea");
    assert_eq!(calm.wave_components, 0);
}

/// The drawn surface is the one that acts on the hull: at the hull's mean position it equals the channel.
#[test]
fn the_surface_is_the_wave_that_the_hull_feels() {
    let mut simulation = Simulation::new(scenario(&[(SWELL, json!(true))]).setup().expect("it builds"));
    for _ in 0..20 {
        simulation.step(25).expect("it runs");
        // The filter's states are the first of the only element that has any.
        let [x, y] = SlowFilter::read(&simulation.state().s[ledger::COUNT..]).frame().position;
        let mut row = Vec::new();
        simulation.write_row(&mut row);
        let channel = simulation.channels().iter().find(|channel| channel.variable == "wave_elevation");
        let felt = row[channel.expect("a channel").offset];
        let [drawn] = simulation.surface(&[x], &[y])[..] else { panic!("one crossing") };
        assert!((drawn - felt).abs() < 1e-12, "{drawn} {felt}");
    }
    let calm = Simulation::new(scenario(&[]).setup().expect("it builds"));
    assert_eq!(calm.surface(&[0.0, 1.0], &[2.0]), [0.0, 0.0]);
}

/// The position at which loads are evaluated is a state like any other: halving the step of RK4 changes the
/// end of a run in waves by its order. The ramp of the waves is smooth to its second derivative, and ends
/// before.
#[test]
fn loads_of_the_sea_have_the_order_of_the_scheme() {
    let end = |step_s: f64| {
        let overrides = [(SWELL, json!(true)), ("simulation.step_s", json!(step_s)), ("sea.ramp_s", json!(0.0))];
        let mut simulation = Simulation::new(scenario(&overrides).setup().expect("it builds"));
        simulation.step((4.0 / step_s).round() as usize).expect("it runs");
        simulation.state().q.clone()
    };
    let truth = end(0.003_125);
    let [coarse, fine] = [0.1, 0.05]
        .map(|step_s| end(step_s).iter().zip(&truth).map(|(found, truth)| (found - truth).abs()).fold(0.0, f64::max));
    let order = (coarse / fine).log2();
    assert!((order - 4.0).abs() < 0.5, "order {order}: {coarse:e}, {fine:e}");
}
