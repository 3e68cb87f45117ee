//! Parts: files mounted into a scenario, with their names, positions and mistakes.

use crate::common::gallery_files;
use crate::common::hoist_part;

use gallery_files::{files, names, read, scenario, text};
use hoist_part::{HOIST, SHIP, error, json_of, place, texts, with_hoist};
use kingpost::scenario::{Files, Scenario, file_names, read_with};
use kingpost::simulation::Simulation;
use serde_json::{Value, json};
use std::collections::BTreeMap;

#[test]
fn every_name_of_a_part_gets_its_prefix() {
    let whole = json_of(&with_hoist(SHIP, &[]).unwrap_or_else(|error| panic!("{error}")));
    let names = |section: &str| whole[section].as_object().unwrap().keys().cloned().collect::<Vec<_>>();
    assert_eq!(names("bodies"), ["ship", "crane_trolley", "crane_block"]);
    assert_eq!(names("loops"), ["crane_stay"]);
    assert_eq!(names("forces"), ["crane_line"]);
    assert_eq!(names("drives"), ["crane_winch", "crane_grip"]);
    let at = |path: &str| whole.pointer(path).cloned().unwrap_or_default();
    assert_eq!(at("/bodies/crane_trolley/parent"), "ship");
    assert_eq!(at("/bodies/crane_block/parent"), "crane_trolley");
    assert_eq!(at("/bodies/crane_trolley/joint/prismatic/name"), "crane_rail");
    assert_eq!(at("/drives/crane_winch/linear_servo/joint"), "crane_rail");
    assert_eq!(at("/drives/crane_grip/brake/joint"), "crane_block.first");
    assert_eq!(at("/loops/crane_stay/first/body"), "ship");
    assert_eq!(at("/loops/crane_stay/second/body"), "crane_block");
    assert_eq!(at("/forces/crane_line/spring_line/second/body"), "ship");
    assert_eq!(at("/parameters/0/name"), "crane_load_t");
    assert_eq!(at("/parameters/0/label"), "crane: Load");
    assert_eq!(at("/parameters/0/writes/0"), "bodies.crane_block.mass_t");
    assert!(whole.get("parts").is_none());
}

#[test]
fn without_a_prefix_the_names_of_a_part_do_not_change() {
    let ship = SHIP.replace("part: hoist.yaml", "part: hoist.yaml, prefix: \"\"");
    let whole = with_hoist(&ship, &[("load_t", json!(3))]).unwrap();
    assert_eq!(whole.bodies["block"].mass_kg.get(), 3000.0);
    assert_eq!(json_of(&whole)["drives"]["winch"]["linear_servo"]["joint"], "rail");
}

/// Source: p + R x, and rotations about one axis add up. Roll of 90 degrees turns y to z and z to -y.
#[test]
fn entries_of_a_part_on_the_world_move_to_its_mounting() {
    let numbers = |ship: &str, path: &str| -> Vec<f64> {
        let whole = json_of(&with_hoist(ship, &[]).unwrap());
        whole.pointer(path).and_then(Value::as_array).unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
    };
    let near = |found: Vec<f64>, expected: [f64; 3]| {
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-14), "{found:?}, not {expected:?}");
    };
    let rail = "/bodies/crane_trolley/joint/prismatic";
    assert_eq!(numbers(SHIP, &format!("{rail}/position_m")), [4.5, 0.0, 3.5]);
    assert_eq!(numbers(SHIP, "/forces/crane_line/spring_line/second/position_m"), [4.0, 0.0, 10.5]);
    let turned = SHIP.replace("on: ship,", "on: ship, orientation_deg: [0, 0, 90],");
    near(numbers(&turned, &format!("{rail}/position_m")), [4.0, 0.5, 3.5]);
    near(numbers(&turned, &format!("{rail}/orientation_rad")), [0.0, 0.0, 100_f64.to_radians()]);
    near(numbers(&turned, "/loops/crane_stay/first/position_m"), [2.0, 1.0, 4.5]);
    near(numbers(&turned, "/loops/crane_stay/first/orientation_rad"), [0.0, 0.0, 110_f64.to_radians()]);
    let rolled = SHIP.replace("on: ship,", "on: ship, orientation_deg: [90, 0, 0],");
    near(numbers(&rolled, "/loops/crane_stay/first/position_m"), [5.0, -3.0, 3.5]);
}

/// A crane that falls with the ship below it, mounted with a rotation, moves like one that was written with
/// the rotation.
#[test]
fn a_rotated_mounting_equals_a_crane_written_with_the_rotation() {
    let end = |scenario: &Scenario| {
        let mut simulation = Simulation::new(scenario.setup().unwrap());
        simulation.step(500).unwrap();
        simulation.poses()
    };
    let ship = |joint: &str| {
        format!(
            "version: 1\ntitle: x\nforces: {{gravity: {{gravity: {{}}}}}}\nbodies:\n  ship: {{mass_t: 50, shape: {{sphere: {{radius_m: 2}}}}, \
             joint: {{floating: {{initial: {{angular_velocity_rad_s: [0.3, 0.1, 0.2]}}}}}}}}\n{joint}"
        )
    };
    let arm =
        "mass_t: 5, shape: {sphere: {radius_m: 1}}, joint: {revolute: {axis: [1, 0, 0], child_position_m: [0, 0, 2]";
    let part = format!("version: 1\ntitle: x\nbodies: {{arm: {{{arm}}}}}}}}}\n");
    let mounted =
        ship("parts: {crane: {part: arm.yaml, on: ship, position_m: [3, 1, 2], orientation_deg: [0, 90, 0]}}\n");
    let mounted = read_with(&mounted, "x.yaml", &[], &texts(&[("arm.yaml", &part)])).unwrap();
    let written = ship(&format!(
        "  crane_arm: {{parent: ship, {arm}, position_m: [3, 1, 2], orientation_deg: [0, 90, 0]}}}}}}\n"
    ));
    let written = read_with(&written, "x.yaml", &[], &Files::default()).unwrap();
    assert_eq!(end(&mounted), end(&written));
}

#[test]
fn a_mounting_sets_parameters_and_fields_of_its_part_and_the_other_parameters_remain() {
    let ship = SHIP.replace("on: ship", "on: ship, parameters: {load_t: 5, drives.grip.brake.torque_kN_m: 3}");
    let whole = with_hoist(&ship, &[("crane_reach_m", json!(7))]).unwrap();
    assert_eq!(whole.bodies["crane_block"].mass_kg.get(), 5000.0);
    let json = json_of(&whole);
    assert_eq!(json["drives"]["crane_grip"]["brake"]["torque_N_m"], 3000.0);
    assert_eq!(json["drives"]["crane_winch"]["linear_servo"]["target_m"], 7.0);
    let names: Vec<&str> = whole.parameters().iter().map(|parameter| parameter.name.as_str()).collect();
    assert_eq!(names, ["crane_reach_m"]);
    // A field that is set is not overwritten by the default of a parameter that is passed up.
    let by_path = SHIP.replace("on: ship", "on: ship, parameters: {bodies.block.mass_t: 8}");
    let whole = with_hoist(&by_path, &[]).unwrap();
    assert_eq!(whole.bodies["crane_block"].mass_kg.get(), 8000.0);
    assert_eq!(whole.parameters().len(), 2);
}

#[test]
fn a_mounting_is_set_from_outside_like_any_field() {
    let set = [
        ("parts.crane.position_m.0", json!(-5)),
        ("parts.crane.parameters.load_t", json!(4)),
        ("parts.crane.parameters.bodies.trolley.mass_t", json!(6)),
        ("bodies.crane_trolley.points.eye.position_m.2", json!(-3)),
    ];
    let whole = with_hoist(SHIP, &set).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(whole.bodies["crane_trolley"].joint.place().position_m, [-4.5, 0.0, 3.5]);
    assert_eq!(whole.bodies["crane_block"].mass_kg.get(), 4000.0);
    assert_eq!(whole.bodies["crane_trolley"].mass_kg.get(), 6000.0);
    let files = files();
    let swap = [
        ("parts.crane.part".to_owned(), json!("dual_draglink_crane")),
        ("parts.crane.parameters".to_owned(), json!({})),
        ("simulation.begin_at_equilibrium".to_owned(), json!(false)),
    ];
    let swapped = read_with(&text("vessel_knuckle_boom"), "x.yaml", &swap, &files);
    assert!(swapped.unwrap_or_else(|error| panic!("{error}")).bodies.contains_key("crane_drag_link_port"));
}

/// The position of a part is a parameter like any other, if everything in the part is at its origin.
#[test]
fn a_parameter_moves_a_crane_on_the_deck() {
    let place =
        |set: &[(&str, Value)]| scenario("vessel_knuckle_boom", set).bodies["crane_pedestal"].joint.place().position_m;
    assert_eq!(place(&[]), [-15.0, 5.0, 8.0]);
    assert_eq!(place(&[("crane_x_m", json!(-30)), ("crane_y_m", json!(0))]), [-30.0, 0.0, 8.0]);
    let taken = read(&text("vessel_knuckle_boom"), &[("parts.crane.position_m.0", json!(3))]).unwrap_err();
    assert_eq!(
        taken.to_string(),
        "--set parts.crane.position_m.0: found 3, allowed: the name of a parameter, to set it"
    );
    let ship = SHIP.to_owned() + "parameters: [{name: x_m, writes: [parts.crane.position_m.0]}]\n";
    let own = error(&ship, HOIST, &[]);
    assert!(
        own.contains(
            "parameters.0.writes.0: found the position of a part in which forces.crane_line has a position of its own"
        ),
        "{own}"
    );
}

/// Source: the same model, written without parts.
#[test]
fn the_position_of_a_part_has_the_gradient_of_the_joint_at_this_position() {
    let ship = "version: 1\ntitle: x\nsimulation: {duration_s: 0.2, step_s: 0.01}\nforces: {gravity: {gravity: {}}}\nbodies:\n  ship: \
                {mass_t: 50, shape: {sphere: {radius_m: 2}}, joint: {floating: {initial: {angular_velocity_rad_s: [0.3, 0.1, 0.2]}}}}\n";
    let arm =
        "mass_t: 5, shape: {sphere: {radius_m: 1}}, joint: {revolute: {axis: [1, 0, 0], child_position_m: [0, 0, 2]";
    let part = format!("{{version: 1, title: x, bodies: {{arm: {{{arm}}}}}}}}}}}");
    let mounted = format!(
        "{ship}parts: {{crane: {{part: arm.yaml, on: ship, position_m: [3, 1, 2]}}}}\nparameters: [{{name: x_m, writes: [parts.crane.position_m.0]}}]\n"
    );
    let written = format!(
        "{ship}  crane_arm: {{parent: ship, {arm}, position_m: [3, 1, 2]}}}}}}\nparameters: [{{name: x_m, writes: \
         [bodies.crane_arm.joint.revolute.position_m.0]}}]\n"
    );
    let along = |text: &str, files: &Files| {
        let scenario = read_with(text, "x.yaml", &[], files).unwrap_or_else(|error| panic!("{error}"));
        kingpost::analysis::gradient(&scenario, &["x_m"], |_| true).expect("it has a derivative").derivatives
    };
    let found = along(&mounted, &texts(&[("arm.yaml", &part)]));
    assert_eq!(found, along(&written, &Files::default()));
    assert!(found[0].iter().any(|x| *x != 0.0));
}

#[test]
fn parts_can_contain_parts() {
    let hook = "{version: 1, title: A hook, bodies: {hook: {mass_kg: 50, shape: {sphere: {radius_m: 0.1}}, joint: {fixed: {name: pin}}}}}";
    let hoist = HOIST.to_owned() + "parts: {tackle: {part: hooks/hook.yaml, on: block, position_m: [0, 0, -1]}}\n";
    let files = texts(&[("cranes/hoist.yaml", &hoist), ("cranes/hooks/hook.yaml", hook)]);
    let ship = SHIP.replace("hoist.yaml", "cranes/hoist.yaml");
    let whole = read_with(&ship, "ship.yaml", &[], &files).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(whole.bodies["crane_tackle_hook"].parent, "crane_block");
    assert_eq!(whole.bodies["crane_tackle_hook"].joint.name().unwrap(), "crane_tackle_pin");
    let made_of: Vec<(&str, &str)> = whole.parts.iter().map(|(name, part)| (name.as_str(), part.on.as_str())).collect();
    assert_eq!(made_of, [("crane_tackle", "crane_block"), ("crane", "ship")]);
    // A mistake in the inner part has its file and its own names.
    let heavy = hook.replace("mass_kg: 50", "mass_kg: -50");
    let files = texts(&[("cranes/hoist.yaml", &hoist), ("cranes/hooks/hook.yaml", &heavy)]);
    let error = read_with(&ship, "docs/ship.yaml", &[], &files).unwrap_err().to_string();
    let at = place(&heavy, "-50");
    assert_eq!(
        error,
        format!("docs/cranes/hooks/hook.yaml:{at}: bodies.hook.mass_kg: found -50, allowed: a number greater than 0")
    );
}

#[test]
fn files_are_requested_until_there_is_no_new_name() {
    let hull = "{version: 1, title: x, bodies: {hull: {mass_kg: 1, shape: {sphere: {radius_m: 1}}, joint: {floating: {}}}}, \
                forces: {water: {hydrodynamics: {body: hull, database: ../hydro/a.hydro.json}}}}";
    let ship = "{version: 1, title: x, parts: {a: {part: vessel}, b: {part: hulls/b.yaml}}}";
    let asked = |files: &Files| file_names(ship, "/home/anne/ship.yaml", &[], files).unwrap();
    assert_eq!(asked(&Files::default()), ["gallery:parts/vessel.yaml", "hulls/b.yaml"]);
    let texts = texts(&[("gallery:parts/vessel.yaml", hull), ("hulls/b.yaml", hull)]);
    let all = ["gallery:parts/vessel.yaml", "hulls/b.yaml", "gallery:hydro/a.hydro.json", "hydro/a.hydro.json"];
    assert_eq!(asked(&texts), all);
}

#[test]
fn a_floating_part_is_mounted_on_the_world() {
    let on_a_body = text("two_ships").replace("part: barge_hull,", "part: barge_hull, on: vessel_hull,");
    let found = read(&on_a_body, &[]).unwrap_err().to_string();
    assert!(
        found.contains("parts.barge.on: found vessel_hull, and bodies.barge_ship in the part, allowed: world"),
        "{found}"
    );
}

/// Each crane of the gallery on each hull: it settles by its own weight only, so the whole is that of both.
#[test]
fn every_crane_of_the_gallery_can_be_mounted_on_every_hull() {
    let hulls = BTreeMap::from([("offshore_hull", "hull"), ("barge_hull", "ship"), ("crane_barge_hull", "hull")]);
    // Rigging moves freely: it stands on the world.
    let rigging = ["four_leg_sling", "spreader_bar"];
    let is_crane = |name: &String| !hulls.contains_key(name.as_str()) && !rigging.contains(&name.as_str());
    let cranes = names("parts").into_iter().filter(is_crane);
    let cranes: Vec<String> = cranes.collect();
    assert!(cranes.len() >= 4);
    for crane in &cranes {
        let mut moved = Vec::new();
        for (hull, body) in &hulls {
            let text = format!(
                "version: 1\ntitle: x\nsimulation: {{step_s: 0.002, duration_s: 0.2}}\nsea: {{}}\nforces: {{gravity: {{gravity: {{}}}}}}\n\
                 parts:\n  a: {{part: {hull}}}\n  b: {{part: {crane}, on: a_{body}, position_m: [-2, 1, 8], orientation_deg: [0, 0, 30]}}\n"
            );
            let whole = read(&text, &[]).unwrap_or_else(|error| panic!("{crane} on {hull}: {error}"));
            let mut simulation = Simulation::new(whole.setup().unwrap());
            assert_eq!(simulation.run(|_| true).status, Ok(()), "{crane} on {hull}");
            let crane = whole.bodies.iter().filter(|(name, _)| name.starts_with("b_"));
            moved.push(crane.map(|(name, body)| (name.clone(), body.mass_kg)).collect::<Vec<_>>());
        }
        assert!(!moved[0].is_empty() && moved[0] == moved[1], "{crane}");
    }
}

#[test]
fn every_part_of_the_gallery_has_a_title_and_a_description() {
    for name in names("parts") {
        let part = read(&text(&format!("parts/{name}")), &[]);
        let part = match part {
            Ok(part) => part,
            // A part's files lie beside it, here the gallery's folder is asked.
            Err(error) => {
                assert!(error.field.ends_with("database"), "{name}: {error}");
                continue;
            }
        };
        assert!(!part.title.is_empty() && part.title.len() <= 60 && part.description.len() >= 60, "{name}");
        assert!(part.parameters.iter().all(|parameter| !parameter.label.is_empty()), "{name}");
    }
}

/// Checks that the text to which a scenario with parts resolves reads back without them.
#[test]
fn a_resolved_scenario_needs_no_parts() {
    for name in ["knuckle_boom_crane", "dual_draglink_crane"] {
        let resolved = scenario(name, &[("load_t", json!(4))]).to_json();
        let again = kingpost::scenario::read(&resolved, "resolved.json", &[]).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(again.to_json(), resolved);
        assert!(again.parts.is_empty());
    }
}

#[test]
fn parts_that_multiply_without_end_are_refused() {
    let files: Vec<(String, String)> = (0..10)
        .map(|level| {
            let parts: Vec<String> = (0..10).map(|k| format!("p{k}: {{part: level{}.yaml}}", level + 1)).collect();
            (format!("level{level}.yaml"), format!("{{version: 1, title: x, parts: {{{}}}}}", parts.join(", ")))
        })
        .collect();
    let files: Vec<(&str, &str)> = files.iter().map(|(name, text)| (name.as_str(), text.as_str())).collect();
    let leaf = [("level10.yaml", "{version: 1, title: x, bodies: {}}")];
    let all = texts(&[&files[..], &leaf].concat());
    let error = read_with("{version: 1, title: x, parts: {p: {part: level0.yaml}}}", "x.yaml", &[], &all).unwrap_err();
    assert!(error.to_string().contains("found more than 16 nested parts, or 256 in total"), "{error}");
}
