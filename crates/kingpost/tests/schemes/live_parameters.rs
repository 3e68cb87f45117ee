//! Parameters that change during a run.

use crate::common;

use common::values;
use kingpost::Simulation;
use kingpost::scenario::{ParameterError, Scenario, read};
use kingpost::state::SnapshotError;
use serde_json::{Value, json};

/// A pendulum under a boat that the wind drives.
const BOAT: &str = "
version: 1
title: A boat in the wind
parameters:
  - {name: wind_m_s, unit: m/s, default: 8, range: [0, 30], live: true, writes: [wind.speed_m_s]}
  - {name: bob_t, label: Bob, unit: t, default: 0.1, live: true, writes: [bodies.bob.mass_t]}
  - {name: push, unit: N m, default: 200, live: true, writes: [drives.push.motor.torque_N_m]}
  - {name: pushes, default: true, live: true, writes: [drives.push.motor.enabled]}
  - {name: blows, default: true, live: true, writes: [forces.windage.wind_load.enabled]}
  - {name: weighs, default: true, live: true, writes: [forces.gravity.gravity.enabled]}
  - {name: drags, default: true, live: true, writes: [forces.drag.viscous_damping.enabled]}
  - {name: step_s, default: 0.01, live: true, writes: [simulation.step_s]}
  - {name: air, default: 1.2, writes: [wind.air_density_kg_m3]}
simulation: {duration_s: 4, record_every_s: 0.1}
wind: {speed_m_s: 8, direction_deg: 30}
bodies:
  boat:
    mass_kg: 2000
    shape: {box: {length_m: 6, width_m: 2, height_m: 1}}
    joint: {planar: {normal: [0, 0, 1], x_axis: [1, 0, 0]}}
  bob:
    parent: boat
    mass_kg: 100
    shape: {box: {length_m: 0.5, width_m: 0.5, height_m: 0.5}}
    joint: {revolute: {position_m: [0, 0, 9], child_position_m: [0, 0, 3], axis: [0, 1, 0], initial_angle_rad: 0.4}}
forces:
  gravity: {gravity: {}}
  windage:
    wind_load:
      body: boat
      coefficients: {directions_deg: [0, 90, 180], symmetric: true, surge: [1, 0, -1], sway: [0, 1, 0], yaw: [0, 0, 0],
        frontal_area_m2: 4, lateral_area_m2: 9, length_m: 6}
  drag: {viscous_damping: {body: boat, linear_N_s_m: [900, 1500, 0]}}
drives:
  push: {motor: {joint: bob, torque_N_m: 200}}
";

fn boat(changes: &[(&str, Value)]) -> (Scenario, Simulation) {
    let changes: Vec<(String, Value)> =
        changes.iter().map(|(path, value)| ((*path).to_owned(), value.clone())).collect();
    let scenario = read(BOAT, "boat.yaml", &changes).unwrap_or_else(|error| panic!("{error}"));
    let simulation = scenario.simulation().expect("it builds");
    (scenario, simulation)
}

const INTEGRATORS: [&str; 5] = ["rk4", "dormand_prince", "generalized_alpha", "implicit_midpoint", "midpoint_euler"];

#[test]
fn a_run_continues_like_a_run_of_the_changed_scenario_from_this_state() {
    for integrator in INTEGRATORS {
        let scheme = ("simulation.integrator", json!(integrator));
        let (mut scenario, mut live) = boat(std::slice::from_ref(&scheme));
        live.step(100).unwrap();
        scenario.set_parameter(&mut live, "wind_m_s", &json!(20)).unwrap();
        scenario.set_parameter(&mut live, "push", &json!(-150)).unwrap();
        let (_, mut other) = boat(&[scheme, ("wind_m_s", json!(20)), ("push", json!(-150))]);
        other.step(100).unwrap();
        let here = live.state().clone();
        other.set_state(&here.q, &here.v, Some(&here.s)).unwrap();
        live.step(100).unwrap();
        other.step(100).unwrap();
        assert_eq!(live.state(), other.state(), "{integrator}");
        assert!((live.time_s() - 2.0).abs() < 1e-12);
        // The wind and the motor did change: without it the boat is elsewhere.
        let (_, mut without) = boat(&[("simulation.integrator", json!(integrator))]);
        without.step(200).unwrap();
        assert!((without.state().q[0] - live.state().q[0]).abs() > 0.01, "{integrator}");
    }
}

#[test]
fn forces_and_drives_without_columns_are_switched_during_a_run() {
    let switches = ["pushes", "weighs", "drags"];
    for integrator in INTEGRATORS {
        for switch in switches {
            let scheme = ("simulation.integrator", json!(integrator));
            let (mut scenario, mut live) = boat(std::slice::from_ref(&scheme));
            live.step(100).unwrap();
            scenario.set_parameter(&mut live, switch, &json!(false)).unwrap();
            let (_, mut other) = boat(&[scheme.clone(), (switch, json!(false))]);
            other.step(100).unwrap();
            let here = live.state().clone();
            other.set_state(&here.q, &here.v, Some(&here.s)).unwrap();
            live.step(50).unwrap();
            other.step(50).unwrap();
            assert_eq!(live.state(), other.state(), "{switch}, {integrator}");
            // Switched on again, the run differs from one that went on with it.
            scenario.set_parameter(&mut live, switch, &json!(true)).unwrap();
            live.step(50).unwrap();
            let (_, mut steady) = boat(&[scheme]);
            steady.step(200).unwrap();
            let moved = (steady.state().q[0] - live.state().q[0]).abs();
            assert!(moved > 1e-3, "{switch}, {integrator}: {moved} m");
            if integrator == "rk4" {
                let worst =
                    values(&mut live, "energy_error").iter().fold(0.0_f64, |worst, error| worst.max(error.abs()));
                // RK4 at 10 ms, a swing of 3.5 s and 6 kJ: h^4 of it.
                assert!(worst < 1e-2, "{switch}: {worst} J");
            }
        }
    }
}

#[test]
fn a_run_continues_with_another_integrator() {
    for (first, second) in INTEGRATORS.iter().zip(INTEGRATORS.iter().cycle().skip(1)) {
        let (mut scenario, mut live) = boat(&[("simulation.integrator", json!(first))]);
        live.step(100).unwrap();
        let before = live.state().clone();
        scenario.set_parameter(&mut live, "simulation.integrator", &json!(second)).unwrap();
        let now = live.state();
        assert_eq!((&now.q, &now.v, &now.s, now.steps), (&before.q, &before.v, &before.s, before.steps));
        let (_, mut other) = boat(&[("simulation.integrator", json!(second))]);
        other.step(100).unwrap();
        other.set_state(&before.q, &before.v, Some(&before.s)).unwrap();
        live.step(100).unwrap();
        other.step(100).unwrap();
        assert_eq!(live.state(), other.state(), "{first}, then {second}");
    }
    let (mut scenario, mut live) = boat(&[]);
    let refused = scenario.set_parameter(&mut live, "simulation.integrator", &json!("leapfrog")).unwrap_err();
    assert!(refused.to_string().contains("found the text \"leapfrog\", allowed: one of forward_euler"), "{refused}");
}

#[test]
fn a_change_of_mass_enters_its_energy_and_momentum_in_the_ledger() {
    let (mut scenario, mut simulation) = boat(&[("simulation.step_s", json!(0.002))]);
    simulation.step(400).unwrap();
    let energy = |simulation: &mut Simulation| {
        values(simulation, "kinetic_energy")[0] + values(simulation, "potential_energy")[0]
    };
    let outside = |simulation: &mut Simulation| values(simulation, "work_by_outside")[0];
    let (before, work) = (energy(&mut simulation), outside(&mut simulation));
    scenario.set_parameter(&mut simulation, "bob_t", &json!(0.25)).unwrap();
    let (after, booked) = (energy(&mut simulation), outside(&mut simulation) - work);
    // The bob hangs 6 m above the origin: 150 kg more are some 9 kJ, by the outside.
    assert!(after - before > 8000.0 && (booked - (after - before)).abs() < 1e-9 * after, "{booked} J of {after} J");
    simulation.step(400).unwrap();
    // RK4 at 2 ms: the remaining error is the rounding of 1e4 J, and h^4 of a swing of 3 s.
    for variable in ["energy_error", "linear_momentum_error", "momentum_error"] {
        let worst = values(&mut simulation, variable).iter().fold(0.0_f64, |worst, error| worst.max(error.abs()));
        assert!(worst < 1e-6, "{variable}: {worst}");
    }
}

#[test]
fn a_live_parameter_that_changes_the_structure_is_refused_by_its_name() {
    let (mut scenario, mut simulation) = boat(&[]);
    simulation.step(10).unwrap();
    let before = simulation.state().clone();
    let mut refused = |name: &str, value: Value| {
        let error = scenario.set_parameter(&mut simulation, name, &value).expect_err("refused");
        (error.to_string(), error)
    };
    let (text, error) = refused("blows", json!(false));
    assert_eq!(
        text,
        "parameter blows: found false, which changes the structure of the run; allowed: a restart with it"
    );
    assert!(matches!(error, ParameterError::Restart { .. }));
    assert!(matches!(refused("step_s", json!(0.005)).1, ParameterError::Restart { name, .. } if name == "step_s"));
    let (text, _) = refused("air", json!(1.0));
    assert_eq!(
        text,
        "parameter air: takes effect at the start of a run, allowed during a run: wind_m_s, bob_t, push, pushes, blows, \
         weighs, drags, step_s, simulation.integrator"
    );
    let (text, _) = refused("winds", json!(1.0));
    assert!(text.starts_with("parameter winds: no such parameter, allowed: wind_m_s, "), "{text}");
    let (text, _) = refused("wind_m_s", json!(31));
    assert!(text.contains("found 31, allowed: a number from 0 to 30"), "{text}");
    let (text, _) = refused("bob_t", json!(-1));
    assert!(text.contains("mass") && text.contains("-1"), "{text}");
    assert_eq!(*simulation.state(), before);
}

#[test]
fn a_snapshot_is_valid_only_for_the_values_at_its_time() {
    let (mut scenario, mut simulation) = boat(&[]);
    simulation.step(50).unwrap();
    let snapshot = simulation.snapshot();
    simulation.step(50).unwrap();
    let expected = simulation.state().clone();
    scenario.set_parameter(&mut simulation, "wind_m_s", &json!(12)).unwrap();
    assert!(matches!(simulation.restore(&snapshot), Err(SnapshotError::Setup { .. })));
    let of_the_other = simulation.snapshot();
    scenario.set_parameter(&mut simulation, "wind_m_s", &json!(8)).unwrap();
    simulation.restore(&snapshot).unwrap();
    simulation.step(50).unwrap();
    assert_eq!(*simulation.state(), expected);
    let (_, mut other) = boat(&[("wind_m_s", json!(12))]);
    other.restore(&of_the_other).unwrap();
    assert_eq!(other.time_s(), 1.0);
}

#[test]
fn a_reset_returns_to_the_start_with_the_new_value() {
    let (mut scenario, mut simulation) = boat(&[]);
    simulation.step(50).unwrap();
    scenario.set_parameter(&mut simulation, "wind_m_s", &json!(15)).unwrap();
    let what: Vec<_> =
        simulation.events().iter().map(|event| (event.time_s, event.element.as_str(), event.what.as_ref())).collect();
    assert_eq!(what, [(0.5, "wind_m_s", "was set")]);
    simulation.reset();
    assert_eq!(simulation.time_s(), 0.0);
    simulation.step(50).unwrap();
    let (_, mut other) = boat(&[("wind_m_s", json!(15))]);
    other.step(50).unwrap();
    assert_eq!(simulation.state(), other.state());
}

#[test]
fn the_description_marks_the_live_parameters() {
    let (mut scenario, mut simulation) = boat(&[]);
    scenario.set_parameter(&mut simulation, "wind_m_s", &json!(9)).unwrap();
    let described = scenario.describe().expect("it builds").parameters;
    let live: Vec<&str> = described.iter().filter(|one| one.live).map(|one| one.name.as_str()).collect();
    assert_eq!(live, ["wind_m_s", "bob_t", "push", "pushes", "blows", "weighs", "drags", "step_s"]);
    assert_eq!(described[0].value, json!(9.0));
}

#[test]
fn parameters_set_during_a_run_are_recorded_until_a_reset_and_removed_by_a_snapshot() {
    let (mut scenario, mut simulation) = boat(&[]);
    let known = |simulation: &Simulation| {
        simulation.parameters_set().into_iter().map(|set| (set.time_s, set.parameter)).collect::<Vec<_>>()
    };
    simulation.step(10).unwrap();
    assert_eq!(known(&simulation), []);
    let set = |time_s: f64, name: &str| (time_s, name.to_owned());
    for wind in [20, 25] {
        scenario.set_parameter(&mut simulation, "wind_m_s", &json!(wind)).unwrap();
    }
    let snapshot = simulation.snapshot();
    simulation.step(40).unwrap();
    scenario.set_parameter(&mut simulation, "push", &json!(-150)).unwrap();
    scenario.set_parameter(&mut simulation, "push", &json!(200)).unwrap();
    assert_eq!(known(&simulation), [set(0.1, "wind_m_s"), set(0.5, "push")]);
    simulation.restore(&snapshot).unwrap();
    assert_eq!(known(&simulation), [set(0.1, "wind_m_s")]);
    simulation.reset();
    assert_eq!(known(&simulation), []);
}
