//! Parameters, overrides and unit aliases.

use crate::common::paper_text;

use kingpost::scenario::schema::{Drive, Force, History, Joint, ParameterKind, ParameterValue, Scenario};
use kingpost::scenario::{parse_assignment, read};
use paper_text::{PAPER, changed, error_of, place_of, set, try_set};
use serde_json::{Value, json};

fn value_of(scenario: &Scenario, name: &str) -> ParameterValue {
    let values = scenario.parameter_values();
    let value = values.into_iter().find(|(parameter, _)| parameter.name == name);
    value.and_then(|(_, value)| value).unwrap_or_else(|| panic!("no value of {name}"))
}

fn slew_position(scenario: &Scenario) -> [f64; 3] {
    match &scenario.bodies["tower"].joint {
        Joint::Revolute(joint) => joint.position_m,
        other => panic!("{other:?}"),
    }
}

fn history(scenario: &Scenario, drive: &str) -> History {
    match &scenario.drives[drive] {
        Drive::Motor(motor) => motor.history,
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_papers_parameters_have_the_defaults_of_its_table() {
    let scenario = set(&[]);
    let expected = [
        ("motor_1", ParameterValue::Boolean(true)),
        ("motor_2", ParameterValue::Boolean(false)),
        ("damping", ParameterValue::Boolean(false)),
        ("load", ParameterValue::Boolean(false)),
        ("hold_centre", ParameterValue::Boolean(true)),
        ("gravity", ParameterValue::Boolean(false)),
        ("crane_x_m", ParameterValue::Number(-10.0)),
        ("crane_y_m", ParameterValue::Number(-5.0)),
        ("crane_z_m", ParameterValue::Number(0.0)),
        ("torque_history", ParameterValue::Text("constant".to_owned())),
    ];
    let names: Vec<&str> = scenario.parameters().iter().map(|parameter| parameter.name.as_str()).collect();
    assert_eq!(names, expected.clone().map(|(name, _)| name));
    for (name, value) in expected {
        assert_eq!(value_of(&scenario, name), value, "{name}");
    }
}

#[test]
fn a_default_replaces_the_value_in_the_file() {
    let scenario = try_set(&changed("position_m: [-10, -5, 0]", "position_m: [1, 2, 0]"), &[]);
    assert_eq!(slew_position(&scenario.unwrap()), [-10.0, -5.0, 0.0]);
}

/// A mass of 3 t in the file, with a parameter in t, whose default is another one.
#[test]
fn a_default_that_replaces_another_value_of_the_file_gives_a_warning_with_both() {
    let warnings = |default: f64, mass: &str, overrides: &[(String, Value)]| {
        let text = format!(
            "{{version: 1, title: x, parameters: [{{name: load, unit: t, default: {default}, writes: [bodies.mass.mass_t]}}], \
             bodies: {{mass: {{{mass}, shape: {{point: {{}}}}, joint: {{prismatic: {{axis: [1, 0, 0]}}}}}}}}}}"
        );
        read(&text, "mass.yaml", overrides).expect("it reads").describe().expect("it builds").warnings
    };
    for mass in ["mass_kg: 3000", "mass_t: 3"] {
        assert_eq!(
            warnings(5.0, mass, &[]),
            [
                "parameters.load: its default, 5 t, replaces bodies.mass.mass_t: 3, which the same file gives: write the value that \
              holds in one of the two places"
            ]
        );
        assert_eq!(warnings(3.0, mass, &[]), Vec::<String>::new());
        for name in ["load", "bodies.mass.mass_t"] {
            assert_eq!(warnings(5.0, mass, &[(name.to_owned(), json!(4))]), Vec::<String>::new());
        }
    }
}

#[test]
fn a_parameter_sets_every_field_that_it_writes() {
    let scenario = set(&["torque_history=pulse", "crane_x_m=0", "crane_y_m=2.5", "load=on"]);
    assert_eq!([history(&scenario, "motor_1"), history(&scenario, "motor_2")], [History::Pulse; 2]);
    assert_eq!(slew_position(&scenario), [0.0, 2.5, 0.0]);
    assert!(scenario.bodies["load"].enabled);
    assert_eq!(value_of(&scenario, "torque_history").kind(), ParameterKind::Choice);
}

#[test]
fn booleans_are_set_by_on_off_true_and_false() {
    for (text, expected) in [("on", true), ("true", true), ("off", false), ("false", false)] {
        assert_eq!(value_of(&set(&[&format!("motor_2={text}")]), "motor_2"), ParameterValue::Boolean(expected));
    }
    let scenario = read(PAPER, "paper.yaml", &[("motor_2".to_owned(), json!("on"))]).unwrap();
    assert_eq!(value_of(&scenario, "motor_2"), ParameterValue::Boolean(true));
}

#[test]
fn a_plain_path_is_set_whatever_the_parameters_say_and_later_overrides_win() {
    let path = "drives.motor_2.motor.history=lever";
    assert_eq!(history(&set(&["torque_history=pulse", path]), "motor_2"), History::Lever);
    assert_eq!(history(&set(&[path, "torque_history=pulse"]), "motor_2"), History::Pulse);
    assert_eq!(*set(&["simulation.step_s=0.002"]).simulation.step_s, 0.002);
    assert_eq!(set(&["title=Another"]).title, "Another");
}

#[test]
fn a_path_can_lead_to_a_field_that_the_file_omits() {
    let scenario =
        set(&["bodies.ship.joint.floating.initial.orientation_rad.1=0.5", "bodies.arm.centre_of_mass_m=[1, 0, 0]"]);
    let Joint::Floating(joint) = &scenario.bodies["ship"].joint else { panic!("the ship floats") };
    assert_eq!(joint.initial.orientation_rad, [0.0, 0.5, 0.0]);
    assert_eq!(scenario.bodies["arm"].centre_of_mass_m, [1.0, 0.0, 0.0]);
    assert_eq!(set(&["simulation.seed=18446744073709551615"]).simulation.seed, u64::MAX);
    assert_eq!(set(&["bodies.load.colour=#010203"]).bodies["load"].colour.as_ref().unwrap().as_str(), "#010203");
}

#[test]
fn unit_aliases_are_read_in_the_file_and_in_paths() {
    let text = changed("mass_kg: 10000", "mass_t: 10").replace("torque_N_m: 100000", "torque_kN_m: 100");
    assert_eq!(try_set(&text, &[]).unwrap(), set(&[]));
    let scenario = set(&[
        "bodies.ship.mass_t=20",
        "bodies.ship.joint.floating.initial.orientation_deg.2=180",
        "forces.damping.viscous_damping.angular_kN_m_s=[0, 1, 2]",
        "bodies.arm.joint.revolute.initial_angle_deg=-90",
    ]);
    assert_eq!(*scenario.bodies["ship"].mass_kg, 20_000.0);
    let Joint::Floating(joint) = &scenario.bodies["ship"].joint else { panic!("the ship floats") };
    assert_eq!(joint.initial.orientation_rad, [0.0, 0.0, std::f64::consts::PI]);
    let Joint::Revolute(joint) = &scenario.bodies["arm"].joint else { panic!("the arm luffs") };
    assert_eq!(joint.initial_angle_rad, -std::f64::consts::FRAC_PI_2);
    let Force::ViscousDamping(damping) = &scenario.forces["damping"] else { panic!("it damps") };
    assert_eq!(damping.angular_n_m_s.map(|moment| *moment), [0.0, 1000.0, 2000.0]);
}

#[test]
fn a_body_whose_name_ends_like_a_unit_is_not_renamed() {
    let text = PAPER.replace("bodies.load", "bodies.load_t").replace("  load:\n", "  load_t:\n");
    assert!(try_set(&text, &["load=on"]).unwrap().bodies["load_t"].enabled);
}

#[test]
fn a_parameter_may_write_in_another_unit() {
    let parameter = "parameters:\n  - {name: luff_deg, range: [-80, 80], default: 45, writes: [bodies.arm.joint.revolute.initial_angle_deg]}";
    let text = changed("parameters:", parameter);
    let scenario = try_set(&text, &["luff_deg=60"]).unwrap();
    let Joint::Revolute(joint) = &scenario.bodies["arm"].joint else { panic!("the arm luffs") };
    assert_eq!(joint.initial_angle_rad, 60.0 * (std::f64::consts::PI / 180.0));
    let ParameterValue::Number(degrees) = value_of(&scenario, "luff_deg") else { panic!("a number") };
    assert!((degrees - 60.0).abs() < 1e-12);
    assert_eq!(read(&scenario.to_json(), "again.json", &[]).unwrap(), scenario);
    let place = try_set(&text.replace("default: 45", "default: 450"), &[]).unwrap_err();
    assert!(place.ends_with("parameters.0.default: found 450, allowed: a number from -80 to 80"), "{place}");
}

#[test]
fn the_error_of_an_invalid_override_contains_the_allowed_values() {
    let cases = [
        ("motor_1=5", "--set motor_1: found 5, allowed: true or false"),
        ("motor_1=yes", "--set motor_1: found the text \"yes\", allowed: true or false"),
        ("crane_x_m=50", "--set crane_x_m: found 50, allowed: a number from -10 to 10"),
        ("crane_x_m=on", "--set crane_x_m: found true, allowed: a number from -10 to 10"),
        ("torque_history=ramp", "--set torque_history: found the text \"ramp\", allowed: constant or pulse"),
        ("bodies.ship.mass_kg=-5", "--set bodies.ship.mass_kg: found -5, allowed: a number greater than 0"),
        ("bodies.ship.mass_t=-5", "--set bodies.ship.mass_t: found -5, allowed: a number greater than 0"),
        ("simulation.step_s=0", "--set simulation.step_s: found 0, allowed: a number greater than 0"),
        (
            "bodies.shp.mass_kg=5",
            "--set bodies.shp.mass_kg: found no field \"shp\" in bodies, allowed: one of arm, load, ship, tower; did you mean ship?",
        ),
        (
            "bodies.tower.shape.box.length_m=5",
            "--set bodies.tower.shape.box.length_m: found no field \"box\" in bodies.tower.shape, allowed: cylinder",
        ),
        ("bodies.tower=5", "--set bodies.tower: found 5, allowed: named fields"),
        (
            "parameters.0.name=x",
            "--set parameters.0.name: found the text \"x\", allowed: the name of a parameter, to set it",
        ),
        ("version=2", "--set version: found 2, allowed: 1 (the version of the file format)"),
        ("drives.motor_2.motor.joint=sleu", "--set drives.motor_2.motor.joint: found sleu, allowed: one of slew, luff"),
    ];
    for (assignment, error) in cases {
        assert_eq!(try_set(PAPER, &[assignment]).unwrap_err(), error);
    }
    let unknown = try_set(PAPER, &["motor_3=on"]).unwrap_err();
    assert!(
        unknown.starts_with(
            "--set motor_3: found an unknown name, allowed: a dotted path of a field, or one of motor_1, "
        )
    );
    for (name, path) in [("duration_s", "simulation.duration_s"), ("duration", "simulation.duration_s")] {
        let unknown = try_set(PAPER, &[&format!("{name}=5")]).unwrap_err();
        assert!(unknown.ends_with(&format!("; did you mean {path}?")), "{unknown}");
    }
    let unknown = try_set(PAPER, &["bodies.ship.mas_kg=5"]).unwrap_err();
    assert!(unknown.starts_with("--set bodies.ship.mas_kg: found an unknown field"), "{unknown}");
}

#[test]
fn a_path_through_a_list_or_a_single_value_is_checked() {
    let list = try_set(PAPER, &["bodies.tower.points.top.position_m.3=1"]).unwrap_err();
    assert!(
        list.ends_with("found no entry \"3\" in bodies.tower.points.top.position_m, allowed: an entry from 0 to 2"),
        "{list}"
    );
    let value = try_set(PAPER, &["bodies.ship.mass_kg.x=1"]).unwrap_err();
    assert!(value.contains("has no fields inside"), "{value}");
    for path in [".", "..", "bodies.", "bodies..mass_kg", ".title"] {
        assert!(read(PAPER, "paper.yaml", &[(path.to_owned(), json!(1))]).is_err(), "{path}");
    }
}

#[test]
fn a_quantity_in_two_units_is_refused_in_an_override_too() {
    let joint = json!({"revolute": {"axis": [0, 0, 1], "initial_angle_rad": 1, "initial_angle_deg": 2}});
    let error = read(PAPER, "paper.yaml", &[("bodies.arm.joint".to_owned(), joint)]).unwrap_err();
    assert_eq!(error.field, "bodies.arm.joint.revolute.initial_angle_deg");
}

#[test]
fn an_override_may_be_any_json_and_never_panics() {
    let values =
        [Value::Null, json!([]), json!({}), json!({"a": [1]}), json!("x"), json!(1e300), json!(-1), json!(true)];
    let names = [
        "",
        "motor_1",
        "crane_x_m",
        "torque_history",
        "bodies",
        "bodies.ship",
        "bodies.ship.shape",
        "simulation",
        "title",
        "version",
        "parameters",
    ];
    for name in names {
        for value in &values {
            let _ = read(PAPER, "paper.yaml", &[(name.to_owned(), value.clone())]);
        }
    }
}

/// The error of the paper's scenario with one parameter in front of the others.
#[track_caller]
fn refuses_parameter(parameter: &str, at: &str, error: &str) {
    let text = changed("parameters:\n", &format!("parameters:\n  - {{{parameter}}}\n"));
    let (line, column) = place_of(&text, at);
    assert_eq!(error_of(&text), format!("paper.yaml:{line}:{column}: {error}"));
}

#[test]
fn a_parameter_with_the_name_of_a_field_at_the_top_is_refused() {
    let whole: Value = serde_json::from_str(&set(&[]).to_json()).unwrap();
    // The last three are of scenarios that have them.
    for name in whole.as_object().unwrap().keys().map(String::as_str).chain(["loops", "sea", "wind"]) {
        let parameter = format!("name: {name}, default: true, writes: [bodies.load.enabled]");
        let allowed = "a name that no field at the top of the file has";
        let error = format!("parameters.0.name: found {name}, a field of the scenario, allowed: {allowed}");
        refuses_parameter(&parameter, &format!("{name}, default: true"), &error);
    }
}

/// Views show a value in the parameter's unit: another one than the path's would be wrong by the factor between them.
#[test]
fn refuses_a_parameter_in_another_unit_than_its_path() {
    refuses_parameter(
        "name: a, unit: t, writes: [bodies.load.mass_kg]",
        "t, writes",
        "parameters.0.unit: found t, allowed: kg, the unit of bodies.load.mass_kg",
    );
    refuses_parameter(
        "name: a, unit: rad, writes: [bodies.ship.joint.floating.initial.orientation_deg.0]",
        "rad, writes",
        "parameters.0.unit: found rad, allowed: deg, the unit of bodies.ship.joint.floating.initial.orientation_deg.0",
    );
    let same = "name: a, unit: t, writes: [bodies.load.mass_t]";
    let text = changed("parameters:\n", &format!("parameters:\n  - {{{same}}}\n"));
    assert!(read(&text, "paper.yaml", &[]).is_ok());
}

#[test]
fn a_parameter_that_writes_a_path_that_cannot_exist_is_refused() {
    refuses_parameter(
        "name: a, default: true, writes: [bodies.lod.enabled]",
        "bodies.lod",
        "parameters.0.writes.0: found no field \"lod\" in bodies, allowed: one of arm, load, ship, tower; did you mean load?",
    );
    refuses_parameter(
        "name: a, default: true, writes: [bodies.load.enabled, bodies.load.joint.floating.hold_rotation]",
        "bodies.load.joint",
        "parameters.0.writes.1: found no field \"floating\" in bodies.load.joint, allowed: fixed",
    );
    refuses_parameter(
        "name: a, default: true, writes: [parameters.1.default]",
        "parameters.1",
        "parameters.0.writes.0: found \"parameters.1.default\", allowed: paths of fields, as bodies.ship.mass_kg",
    );
    refuses_parameter(
        "name: a, default: true, writes: []",
        "[]",
        "parameters.0.writes: found an empty list, allowed: paths of fields, as bodies.ship.mass_kg",
    );
    let text = changed("parameters:\n", "parameters:\n  - {name: a, default: true, writes: [bodies.load.enable]}\n");
    let (line, column) = place_of(&text, "bodies.load.enable]");
    let error = error_of(&text);
    assert!(
        error.starts_with(&format!("paper.yaml:{line}:{column}: bodies.load.enable: found an unknown field")),
        "{error}"
    );
}

#[test]
fn a_parameter_whose_definition_is_not_sound_is_refused() {
    let writes = "writes: [bodies.ship.mass_kg]";
    let cases = [
        (
            format!("name: motor_1, default: 5, {writes}"),
            "parameters.1.name: found motor_1 a second time, allowed: each name once",
        ),
        (
            format!("name: a, default: 5, range: [9, 1], {writes}"),
            "parameters.0.range: found 9, 1, allowed: two numbers, the smaller first",
        ),
        (
            format!("name: a, default: 5, choices: [x], {writes}"),
            "parameters.0.choices: found choices, allowed: no choices: the value is not a text",
        ),
        (
            format!("name: a, default: x, {writes}"),
            "parameters.0.choices: found nothing, allowed: a list of the texts allowed",
        ),
        (
            format!("name: a, default: x, choices: [], {writes}"),
            "parameters.0.choices: found an empty list, allowed: a list of the texts allowed",
        ),
        (
            format!("name: a, default: x, choices: [y], {writes}"),
            "parameters.0.default: found the text \"x\", allowed: y",
        ),
        (
            format!("name: a, default: true, range: [0, 1], {writes}"),
            "parameters.0.range: found a range, allowed: no range: the value is not a number",
        ),
        (
            format!("name: a, default: 7, range: [1, 5], {writes}"),
            "parameters.0.default: found 7, allowed: a number from 1 to 5",
        ),
        (
            format!("name: a, default: [1], {writes}"),
            "parameters.0.default: found [1], allowed: true or false, a number, or a text",
        ),
        (
            "name: a, writes: [bodies.ship.joint]".to_owned(),
            "parameters.0.default: found nothing, allowed: a default, or one value at bodies.ship.joint",
        ),
        (
            "name: a, default: true, writes: [bodies.ship.mass_kg]".to_owned(),
            "bodies.ship.mass_kg: found true, allowed: a number greater than 0",
        ),
    ];
    for (parameter, error) in cases {
        let text = changed("parameters:\n", &format!("parameters:\n  - {{{parameter}}}\n"));
        let found = read(&text, "paper.yaml", &[]).unwrap_err();
        assert!(found.line.is_some());
        assert!(found.to_string().ends_with(error), "{found}\n{error}");
    }
}

#[test]
fn an_assignment_is_a_name_and_a_boolean_a_number_a_list_or_a_text() {
    let cases = [
        ("a=on", json!(true)),
        ("a=false", json!(false)),
        ("a=5", json!(5)),
        ("a = -2.5e3 ", json!(-2500.0)),
        ("a=[1, 2, 3]", json!([1, 2, 3])),
        ("a=pulse", json!("pulse")),
        ("a=x=y", json!("x=y")),
        ("a=", json!("")),
    ];
    for (text, value) in cases {
        assert_eq!(parse_assignment(text).unwrap(), ("a".to_owned(), value), "{text}");
    }
    let error = |text| parse_assignment(text).unwrap_err().to_string();
    assert_eq!(error("motor_1"), "--set motor_1: found \"motor_1\", allowed: name=value");
    assert_eq!(error("=3"), "--set =3: found \"=3\", allowed: name=value");
    assert_eq!(error("a=nan"), "--set a: found nan, allowed: a finite number");
    assert_eq!(error("a=inf"), "--set a: found inf, allowed: a finite number");
}
