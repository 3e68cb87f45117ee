//! Invalid scenarios: each gives one clear error with its place.

use crate::common::paper_text;

use kingpost::scenario::read;
use paper_text::{PAPER, changed, error_of, place_of};

/// Reads the paper's scenario with one text replaced and checks the whole error, its place counted in the new text.
#[track_caller]
fn refuses(old: &str, new: &str, at: &str, error: &str) {
    let text = changed(old, new);
    let (line, column) = place_of(&text, at);
    assert_eq!(error_of(&text), format!("paper.yaml:{line}:{column}: {error}"));
}

const MASS: &str = "mass_kg: 10000";
const SHAPE: &str = "shape: {box: {length_m: 20, width_m: 10, height_m: 5}}";
const TOP: &str = "top: {position_m: [0, 0, 3.5]}";

#[test]
fn a_wrong_type_is_refused() {
    let allowed = "allowed: a number greater than 0";
    refuses(MASS, "mass_kg: heavy", "heavy", &format!("bodies.ship.mass_kg: found the text \"heavy\", {allowed}"));
    refuses(MASS, "mass_kg: [1, 2]", "[1, 2]", &format!("bodies.ship.mass_kg: found [1, 2], {allowed}"));
    refuses(MASS, "mass_kg: true", "true\n    colour", &format!("bodies.ship.mass_kg: found true, {allowed}"));
    refuses(
        "hold_translation: true",
        "hold_translation: 1",
        "1}}\n\n  # Turns",
        "bodies.ship.joint.floating.hold_translation: found 1, allowed: true or false",
    );
}

#[test]
fn a_field_without_a_value_is_refused() {
    let text = changed(MASS, "mass_kg:");
    assert!(error_of(&text).ends_with("bodies.ship.mass_kg: found nothing, allowed: a number greater than 0"));
}

#[test]
fn a_missing_field_is_named_with_what_it_should_hold() {
    refuses(
        MASS,
        "# no mass",
        "colour: \"#3d5a80\"",
        "bodies.ship.mass_kg: found nothing, allowed: a number greater than 0",
    );
}

#[test]
fn an_unknown_field_is_refused_at_its_name_and_the_nearest_one_suggested() {
    let fields = "one of enabled, parent, mass_kg, colour, shape, inertia, flexible, centre_of_mass_m, joint, points";
    let error = format!("bodies.ship.mas_kg: found an unknown field, allowed: {fields}; did you mean mass_kg?");
    refuses(MASS, "mas_kg: 10000", "mas_kg", &error);
    let text = "{\"version\": 1, \"title\": \"x\", \"bodies\": {}, \"\": 2}";
    assert!(error_of(text).contains("found an unknown field"));
}

#[test]
fn a_misspelt_unit_alias_gets_the_nearest_one() {
    let fields = "one of enabled, parent, mass_kg, colour, shape, inertia, flexible, centre_of_mass_m, joint, points";
    let error = format!("bodies.ship.mas_t: found an unknown field, allowed: {fields}; did you mean mass_t?");
    refuses(MASS, "mas_t: 10", "mas_t", &error);
    let fields = "one of enabled, joint, torque_N_m, history, pulse, list";
    let error = format!(
        "drives.motor_1.motor.torque_kNm: found an unknown field, allowed: {fields}; did you mean torque_kN_m?"
    );
    refuses("torque_N_m: 100000", "torque_kNm: 100", "torque_kNm", &error);
}

#[test]
fn a_stiffness_per_degree_is_not_taken_for_an_angle() {
    let servo =
        "servo: {joint: slew, target_rad: 0, stiffness_N_m_per_deg: 1, damping_N_m_s_per_rad: 1, torque_limit_N_m: 1}";
    let text = changed("motor_2:\n    motor:", &format!("held: {{{servo}}}\n  motor_2:\n    motor:"));
    let error = error_of(&text);
    assert!(error.contains("drives.held.servo.stiffness_N_m_per_deg: found an unknown field"), "{error}");
}

#[test]
fn a_drive_in_a_joint_that_is_held_or_prescribed_is_refused() {
    let allowed = "allowed: a joint whose mode is free, for an enabled drive";
    let error = format!("drives.motor_1.motor.joint: found slew, which is held, {allowed}");
    refuses("        name: slew\n", "        name: slew\n        mode: held\n", "slew\n      torque", &error);
    let prescribed = "        name: slew\n        mode: {prescribed: {rate_rad_s: 1}}\n";
    let error = format!("drives.motor_1.motor.joint: found slew, which is prescribed, {allowed}");
    refuses("        name: slew\n", prescribed, "slew\n      torque", &error);
    // One that is off waits until the joint is free.
    let held = changed("        name: luff\n", "        name: luff\n        mode: held\n");
    assert!(read(&held, "paper.yaml", &[]).is_ok());
}

#[test]
fn a_second_drive_that_follows_a_set_point_in_a_joint_is_refused() {
    let servo = |name: &str, rest: &str| {
        format!(
            "  {name}: {{servo: {{joint: slew, target_rad: 0, stiffness_N_m_per_rad: 1, damping_N_m_s_per_rad: 1, \
             torque_limit_N_m: 1{rest}}}}}\n"
        )
    };
    let drives = |rest: &str| changed("drives:\n", &format!("drives:\n{}{rest}", servo("first", "")));
    let controlled = "  other: {controlled_drive: {set_point: {torque: {torque_N_m: 1}}, speed_limit_rad_s: 1, \
                      acceleration_limit_rad_s2: 1, torque_limit_N_m: 1, stiffness_N_m_per_rad: 1, damping_N_m_s_per_rad: 1, \
                      joint: slew}}\n";
    for (second, name, kind) in
        [(servo("second", ""), "second", "servo"), (controlled.to_owned(), "other", "controlled_drive")]
    {
        let found = error_of(&drives(&second));
        let expected = format!(
            "drives.{name}.{kind}.joint: found slew, which both first and {name} drive, allowed: one enabled drive with a set-point for each joint; motors and brakes may be added"
        );
        assert!(found.ends_with(&expected) && found.starts_with("paper.yaml:"), "{found}");
    }
    // The slewing joint already has a motor; a disabled drive does not count.
    let brake = "  brake: {brake: {joint: slew, torque_N_m: 100, smoothing_rad_s: 0.01}}\n";
    for accepted in [servo("second", ", enabled: false"), brake.to_owned()] {
        assert!(read(&drives(&accepted), "paper.yaml", &[]).is_ok(), "{accepted}");
    }
}

#[test]
fn a_negative_mass_is_refused() {
    refuses(MASS, "mass_kg: -5", "-5\n    colour", "bodies.ship.mass_kg: found -5, allowed: a number greater than 0");
}

#[test]
fn a_value_in_another_unit_is_refused_as_it_was_written() {
    refuses(MASS, "mass_t: -5", "-5\n    colour", "bodies.ship.mass_t: found -5, allowed: a number greater than 0");
    refuses(
        MASS,
        "mass_t: x",
        "x\n    colour",
        "bodies.ship.mass_t: found the text \"x\", allowed: a number greater than 0",
    );
    assert!(error_of(&changed(MASS, "mass_t: 1e308")).contains("bodies.ship.mass_t: found 1e+308"));
}

#[test]
fn a_quantity_in_two_units_is_refused() {
    refuses(
        MASS,
        "mass_t: 5\n    mass_kg: 6",
        "6\n",
        "bodies.ship.mass_kg: found both mass_t and mass_kg, allowed: one of the two",
    );
}

#[test]
fn a_step_of_zero_is_refused() {
    refuses("step_s: 0.001", "step_s: 0", "0   ", "simulation.step_s: found 0, allowed: a number greater than 0");
}

#[test]
fn a_number_that_is_not_finite_is_refused() {
    refuses(MASS, "mass_kg: .nan", ".nan", "bodies.ship.mass_kg: found nan, allowed: a finite number");
    refuses(MASS, "mass_kg: 1e400", "1e400", "bodies.ship.mass_kg: found inf, allowed: a finite number");
    refuses(
        TOP,
        "top: {position_m: [0, -.inf, 0]}",
        "-.inf",
        "bodies.tower.points.top.position_m.1: found -inf, allowed: a finite number",
    );
    assert!(
        error_of(&changed(MASS, "mass_kg: NaN")).contains("found the text \"NaN\", allowed: a number greater than 0")
    );
}

#[test]
fn a_list_of_another_length_is_refused() {
    let allowed = "allowed: a list of 3 numbers";
    for (list, found) in [("[0, 0]", "[0, 0]"), ("[0, 0, 1, 2]", "[0, 0, 1, 2]"), ("[]", "an empty list"), ("3", "3")] {
        let error = error_of(&changed(TOP, &format!("top: {{position_m: {list}}}")));
        assert!(error.ends_with(&format!("bodies.tower.points.top.position_m: found {found}, {allowed}")), "{error}");
    }
    refuses(
        TOP,
        "top: {position_m: [0, x, 1]}",
        "x, 1",
        "bodies.tower.points.top.position_m.1: found the text \"x\", allowed: a number",
    );
}

#[test]
fn a_list_where_fields_have_names_is_refused() {
    let refused = |list: &str, found: &str| {
        let error = format!("bodies.ship.shape.box: found {found}, allowed: named fields");
        refuses(SHAPE, &format!("shape: {{box: {list}}}"), list, &error);
    };
    // Of as many numbers as the box has edges, of fewer, and with something wrong in it.
    refused("[20, 10, 5.5]", "[20, 10, 5.5]");
    refused("[20, 10.5]", "[20, 10.5]");
    refused("[20, 10, wide]", "a list of 3");
}

#[test]
fn a_number_of_many_digits_is_shown_by_its_power_of_ten() {
    refuses(
        "step_s: 0.001",
        "step_s: 1e-300",
        "1e-300",
        "simulation.step_s: found 1e-300, allowed: at least 3e-15 s, for 1e15 steps",
    );
}

#[test]
fn a_value_that_overflows_is_refused_at_the_start_of_the_run() {
    let turned = changed("name: slew\n", "name: slew\n        orientation_rad: [1e200, 0, 0]\n");
    let error = error_of(&turned);
    assert!(error.contains("bodies.tower.joint: found a position that is not finite, allowed: "), "{error}");
    let fast = changed("name: slew\n", "name: slew\n        initial_rate_rad_s: 1e160\n");
    let error = error_of(&fast);
    assert!(error.contains(": found numbers that make ") && error.contains(" at the start"), "{error}");
}

#[test]
fn an_axis_without_a_direction_is_refused() {
    refuses(
        "axis: [0, 0, 1]",
        "axis: [0, 0, 0]",
        "[0, 0, 0]\n        position_m",
        "bodies.tower.joint.revolute.axis: found [0, 0, 0], allowed: three numbers, not all 0",
    );
}

#[test]
fn an_unknown_kind_is_refused_with_the_known_ones() {
    let kinds = "allowed: one of box, cylinder, sphere, point";
    let cases = [
        ("shape: {bx: {length_m: 20}}", "\"bx\""),
        ("shape: {}", "no fields"),
        ("shape: 5", "5"),
        ("shape: {point: {}, sphere: {radius_m: 1}}", "the fields point, sphere"),
    ];
    for (shape, found) in cases {
        let error = error_of(&changed(SHAPE, shape));
        assert!(error.ends_with(&format!("bodies.ship.shape: found {found}, {kinds}")), "{error}");
    }
    let error = error_of(&changed(SHAPE, "shape: box"));
    assert!(
        error.ends_with("bodies.ship.shape: found the text \"box\", allowed: box with its fields, box: {...}"),
        "{error}"
    );
    refuses(
        "integrator: rk4",
        "integrator: rk5",
        "rk5",
        "simulation.integrator: found the text \"rk5\", allowed: one of forward_euler, midpoint_euler, \
         semi_implicit_euler, rk4, dormand_prince, newmark, generalized_alpha, implicit_midpoint; did you mean rk4?",
    );
}

#[test]
fn a_kind_without_fields_takes_none() {
    let error = error_of(&changed("name: luff", "name: luff\n        mode: {held: {}}"));
    assert!(error.contains("bodies.arm.joint.revolute.mode: found"), "{error}");
    assert!(error.ends_with("allowed: the word held, without fields"), "{error}");
}

#[test]
fn a_name_of_another_form_is_refused() {
    let name = "a name of small letters, digits and _ that starts with a letter";
    let text = changed("  ship:\n", "  Ship One:\n").replace("parent: ship", "parent: Ship One");
    let error = error_of(&text);
    assert!(error.ends_with(&format!("bodies.Ship One: found \"Ship One\", allowed: {name}")), "{error}");
    refuses(
        "name: slew",
        "name: 1st",
        "1st",
        &format!("bodies.tower.joint.revolute.name: found the text \"1st\", allowed: {name}"),
    );
    refuses(
        "colour: \"#3d5a80\"",
        "colour: blue",
        "blue",
        "bodies.ship.colour: found the text \"blue\", allowed: a colour as \"#rrggbb\"",
    );
}

#[test]
fn two_bodies_of_one_name_are_refused_at_the_second() {
    refuses(
        "  tower:\n",
        "  ship:\n",
        "ship:\n    parent",
        "bodies.ship: found ship a second time, allowed: each name once",
    );
}

#[test]
fn a_version_that_is_missing_or_unknown_is_refused_first() {
    let allowed = "allowed: 1 (the version of the file format)";
    refuses("version: 1", "version: 2", "2\ntitle", &format!("version: found 2, {allowed}"));
    refuses("version: 1", "version: one", "one\ntitle", &format!("version: found the text \"one\", {allowed}"));
    refuses("version: 1\n", "", "title:", &format!("version: found nothing, {allowed}"));
}

#[test]
fn an_empty_file_is_refused() {
    for text in ["", "\n\n", "# only a comment\n", "---\n", "~"] {
        let error = error_of(text);
        assert!(error.starts_with("paper.yaml:1:1: found nothing: the file is empty, allowed: "), "{error}");
    }
}

#[test]
fn a_file_of_another_format_is_refused() {
    let cases = [
        ("just a line of text", "1:1: found a text of 19 characters, without named fields"),
        ("time,ship.x\n0.0,1.5\n", "1:1: found a text of 19 characters, without named fields"),
        ("- 1\n- 2\n", "1:1: found [1, 2]"),
        ("PK\u{3}\u{4}\u{0}", "1:1: found unexpected character: \\u{3}"),
        ("[section]\nkey = 1\n", "2:1: found text that is not YAML"),
        ("<html>\n<body>", "1:1: found a text"),
        ("root:x:0:0:root\nbin:x:1:1:bin\n", "1:1: found a text of 29 characters"),
    ];
    for (text, start) in cases {
        let error = error_of(text);
        assert!(error.starts_with(&format!("paper.yaml:{start}")), "{error}");
        assert!(error.ends_with("allowed: a scenario in YAML or JSON, which begins with version: 1"), "{error}");
    }
}

#[test]
fn text_that_is_not_yaml_is_refused_with_its_place() {
    let cases = [
        (changed("    mass_kg: 10000", "\tmass_kg: 10000"), "found a tab in the indentation, allowed: spaces"),
        (changed("title: Crane", "title: Crane: x"), "found a second \": \" where a value ends, allowed: name: value"),
        (changed("[0, 0, 1]", "[0, 0, 1"), "found"),
        ("{\"version\": 1,".to_owned(), "found a bracket that is not closed"),
        ("version: 'x".to_owned(), "found a quote that is not closed"),
        ("version: 1\n---\nversion: 1\n".to_owned(), "found a second document after ---"),
        ("version: 1\nbodies: *ship".to_owned(), "found an alias (*name) without its anchor"),
        ("version: 1\n~: 2".to_owned(), "found a field whose name is not a text"),
    ];
    for (text, found) in cases {
        let error = read(&text, "paper.yaml", &[]).unwrap_err();
        assert!(error.line.is_some() && error.column.is_some());
        let error = error.to_string();
        assert!(error.contains(found) && !error.contains('\n'), "{error}");
    }
}

#[test]
fn a_file_that_is_too_deep_or_grows_without_end_is_refused() {
    let row = |name: char, of: char| format!("{name}: &{name} [{}]\n", vec![format!("*{of}"); 10].join(","));
    let bomb: String = "a: &a [x,x,x,x,x,x,x,x,x,x]\n".to_owned()
        + &['b', 'c', 'd', 'e', 'f', 'g'].windows(2).map(|w| row(w[1], w[0])).collect::<String>().replace("*b", "*a");
    let block: String = (0..3000).map(|depth| format!("{}a:\n", " ".repeat(depth))).collect();
    for text in ["[".repeat(5000), "{a: ".repeat(5000), block, bomb] {
        let error = error_of(&text);
        assert!(error.contains("found a file that is too deep or too large"), "{error}");
    }
    assert!(read("a: &a [*a]", "paper.yaml", &[]).is_err());
}

#[test]
fn on_and_yes_are_texts_in_a_file_and_not_booleans() {
    let text = changed("enabled: false\n    parent: arm", "enabled: on\n    parent: arm");
    assert!(error_of(&text).ends_with("bodies.load.enabled: found the text \"on\", allowed: true or false"));
    let y = changed("length_m: 7, axis: x}", "length_m: 7, axis: y}");
    assert!(read(&y, "paper.yaml", &[]).is_ok());
}

#[test]
fn an_error_of_the_whole_model_also_has_its_place() {
    refuses(
        "parent: ship",
        "parent: shp",
        "shp",
        "bodies.tower.parent: found shp, allowed: one of ship, arm, load, world",
    );
    let cycle = error_of(&changed("parent: ship", "parent: arm"));
    let (line, column) = place_of(&changed("parent: ship", "parent: arm"), "arm\n    mass_kg: 500");
    assert!(cycle.starts_with(&format!("paper.yaml:{line}:{column}: bodies.tower.parent: found ")), "{cycle}");
    let text = changed(SHAPE, "inertia: {tensor: {moments_kg_m2: [1, 1, 5]}}");
    let (line, column) = place_of(&text, "[1, 1, 5]");
    let triangle = error_of(&text);
    let start = format!("paper.yaml:{line}:{column}: bodies.ship.inertia.tensor.moments_kg_m2: found ");
    assert!(triangle.starts_with(&start), "{triangle}");
    assert!(triangle.contains("sum of the other two"), "{triangle}");
    refuses("joint: slew", "joint: sleu", "sleu", "drives.motor_1.motor.joint: found sleu, allowed: one of slew, luff");
}

#[test]
fn every_bad_body_of_the_model_is_refused_with_a_place() {
    let cases = [
        ("name: luff", "name: slew", "bodies.arm.joint.revolute.name"),
        (SHAPE, "", "bodies.ship"),
        ("  load:\n", "  world:\n", "bodies.world"),
        ("body: ship", "body: shp", "forces.damping.viscous_damping.body"),
        ("step_s: 0.001", "step_s: 5", "simulation.step_s"),
        ("duration_s: 3", "duration_s: 1e9", "simulation.record_every_s"),
    ];
    for (old, new, field) in cases {
        let text = changed(old, new)
            .replace("default: false, writes: [bodies.load.enabled]", "default: true, writes: [bodies.arm.enabled]");
        let error = read(&text, "paper.yaml", &[]).unwrap_err();
        assert!(error.field.starts_with(field), "{error}");
        assert!(error.line.is_some(), "{error}");
    }
}

#[test]
fn settings_of_integrators_outside_their_range_are_refused() {
    let cases = [
        ("generalized_alpha: {rho_infinity: 1.5}", "rho_infinity: found 1.5, allowed: a number from 0 to 1"),
        ("dormand_prince: {absolute_tolerance: 0}", "absolute_tolerance: found 0, allowed: a number greater than 0"),
        ("dormand_prince: {largest_step_s: -1}", "largest_step_s: found -1, allowed: a number greater than 0"),
        ("newmark: {beta: 0.6}", "beta: found 0.6, allowed: a number from 0 to 0.5"),
        ("newmark: {gamma: 0.4}", "gamma: found 0.4, allowed: a number from 0.5 to 1"),
    ];
    for (settings, message) in cases {
        let (name, _) = settings.split_once(':').unwrap();
        let error = error_of(&changed("integrator: rk4", &format!("integrator: {name}\n  {settings}")));
        assert!(error.ends_with(&format!("simulation.{name}.{message}")), "{error}");
    }
}

#[test]
fn the_scenario_of_the_paper_reads() {
    assert!(read(PAPER, "paper.yaml", &[]).is_ok());
}
