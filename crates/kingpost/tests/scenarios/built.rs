//! A scenario that is built once: its simulations and analyses are bitwise identical to those of a scenario
//! that is built again.

use crate::common::gallery_files::{files, scenario, text};
use kingpost::analysis::{Linearizer, gradient};
use kingpost::scenario::BuiltScenario;
use serde_json::{Value, json};

fn built(name: &str, set: &[(&str, Value)]) -> BuiltScenario {
    let set: Vec<_> = set.iter().map(|(name, value)| ((*name).to_owned(), value.clone())).collect();
    BuiltScenario::read(&text(name), "test.yaml", &set, &files()).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn bits(rows: &[f64]) -> Vec<u64> {
    rows.iter().map(|x| x.to_bits()).collect()
}

const SHORT: (&str, f64) = ("simulation.duration_s", 0.3);
const CASES: [(&str, &str); 4] =
    [("paper", "rk4"), ("paper", "generalized_alpha"), ("barge", "rk4"), ("lowering_by_winch", "dormand_prince")];

#[test]
fn simulations_of_a_reused_setup_equal_those_of_a_new_setup() {
    for (name, integrator) in CASES {
        let set = [(SHORT.0, json!(SHORT.1)), ("simulation.integrator", json!(integrator))];
        let built = built(name, &set);
        let mut first = built.simulation().expect("it builds");
        first.step(20).expect("it steps");
        let mut second = built.simulation().expect("it builds");
        let mut anew = scenario(name, &set).simulation().expect("it builds");
        assert_eq!(second.snapshot(), anew.snapshot(), "{name}");
        let (rows, expected) = (second.run(|_| true).rows, anew.run(|_| true).rows);
        assert_eq!(bits(&rows), bits(&expected), "{name}, {integrator}");
        first.restore(&built.simulation().expect("it builds").snapshot()).expect("of the same scenario");
        assert_eq!(bits(&first.run(|_| true).rows), bits(&expected), "{name}, {integrator}");
    }
}

#[test]
fn descriptions_and_analyses_of_a_reused_setup_equal_those_of_a_new_setup() {
    let (built, anew) = (built("barge", &[("waves", json!(true))]), scenario("barge", &[("waves", json!(true))]));
    let mut moving = built.simulation().expect("it builds");
    moving.step(30).expect("it steps");
    let json = |described| serde_json::to_string(described).expect("it is written");
    assert_eq!(json(built.describe()), json(&anew.describe().expect("it builds")));
    assert_eq!(built.hydrostatic_report(), anew.hydrostatic_report());
    assert_eq!(built.hydrostatic_report_at(&moving), anew.hydrostatic_report_at(&moving));
    let expected = Linearizer::new(&anew).expect("it builds").at(&moving);
    for _ in 0..2 {
        assert_eq!(Linearizer::of_built(&built).expect("it builds").at(&moving), expected);
    }
}

#[test]
fn a_gradient_of_a_reused_setup_equals_that_of_a_new_setup() {
    let set = [(SHORT.0, json!(SHORT.1))];
    let names = ["crane_x_m", "bodies.ship.mass_kg"];
    let found = built("paper", &set).gradient(&names, |_| true).expect("it has derivatives");
    let expected = gradient(&scenario("paper", &set), &names, |_| true).expect("it has derivatives");
    assert_eq!(found.rows, expected.rows);
    assert_eq!(found.derivatives, expected.derivatives);
}

#[test]
fn a_parameter_set_in_one_simulation_does_not_change_another() {
    let set = [(SHORT.0, json!(SHORT.1)), ("waves", json!(true))];
    let built = built("barge", &set);
    let (mut one, mut other) = (built.simulation().expect("it builds"), built.simulation().expect("it builds"));
    let changed = built.set_parameter(&mut one, "significant_height_m", &json!(0.5)).expect("it is live");
    assert_ne!(changed.scenario(), built.scenario());
    assert_eq!(built.scenario(), &scenario("barge", &set));
    assert!(other.restore(&one.snapshot()).is_err(), "a snapshot of the changed scenario");
    let mut anew = built.scenario().simulation().expect("it builds");
    assert_eq!(bits(&other.run(|_| true).rows), bits(&anew.run(|_| true).rows));
    one.reset();
    let mut reset = changed.simulation().expect("it builds");
    assert_eq!(bits(&one.run(|_| true).rows), bits(&reset.run(|_| true).rows));
}

#[test]
fn a_scenario_that_does_not_build_is_refused_with_its_place() {
    let wrong = text("paper").replace("parent: ship", "parent: boat");
    let found = BuiltScenario::read(&wrong, "test.yaml", &[], &files()).expect_err("no such body");
    let expected = kingpost::scenario::read_with(&wrong, "test.yaml", &[], &files()).expect_err("no such body");
    assert_eq!(found, expected);
    assert!(found.line.is_some(), "{found}");
}
