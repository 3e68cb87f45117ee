//! Mistakes in parts and in their mountings are reported with their place.

use crate::common::hoist_part;

use hoist_part::{HOIST, SHIP, error, place};
use serde_json::{Value, json};

#[test]
fn the_error_of_a_mistake_in_a_part_contains_the_parts_file_and_names() {
    let refuses = |old: &str, new: &str, at: &str, says: &str| {
        assert!(HOIST.contains(old), "no {old:?}");
        let hoist = HOIST.replacen(old, new, 1);
        let expected = format!("ships/hoist.yaml:{}: {says}", place(&hoist, at));
        let found = error(SHIP, &hoist, &[]);
        assert!(found.starts_with(&expected), "{found}\nis not\n{expected}");
    };
    let broken = error(SHIP, &HOIST.replace("title: A hoist", "title: ["), &[]);
    assert!(broken.starts_with("ships/hoist.yaml:") && broken.contains(": found "), "{broken}");
    // Types, unknown fields and units are found in the part; what does not fit, in the whole.
    refuses("mass_t: 1\n", "mass_t: -1\n", "-1\n", "bodies.trolley.mass_t: found -1, allowed: a number greater than 0");
    refuses("mass_t: 1\n", "mas_t: 1\n", "mas_t", "bodies.trolley.mas_t: found an unknown field");
    refuses("joint: rail", "joint: rial", "rial", "drives.winch.linear_servo.joint: found crane_rial, allowed: ");
    refuses("parent: trolley", "parent: troley", "troley", "bodies.block.parent: found crane_troley, allowed: one of ");
    refuses(
        "first_axis: [1, 0, 0]",
        "first_axis: [1, 1, 0]",
        "[0, 1, 0]",
        "bodies.block.joint.universal.second_axis: found a direction 45",
    );
    refuses(
        "writes: [bodies.block.mass_t]",
        "writes: [bodies.blok.mass_t]",
        "bodies.blok",
        "parameters.0.writes.0: found no field \"blok\"",
    );
    refuses("default: 2,", "default: 99,", "99", "parameters.0.default: found 99, allowed: a number from 1 to 9");
    refuses("version: 1", "version: 2", "2", "version: found 2");
    refuses("loops:", "sea: {}\nloops:", "sea:", "sea: found sea, allowed: a field that a part may have");
    refuses(
        "  line:",
        "  weight: {gravity: {}}\n  line:",
        "gravity:",
        "forces.weight.gravity: found gravity, allowed: a field that a part may have",
    );
}

#[test]
fn the_error_of_a_mistake_in_a_mounting_has_its_place_in_the_including_file() {
    let refuses = |old: &str, new: &str, at: &str, says: &str| {
        assert!(SHIP.contains(old), "no {old:?}");
        let ship = SHIP.replacen(old, new, 1);
        let expected = format!("ships/ship.yaml:{}: {says}", place(&ship, at));
        let found = error(&ship, HOIST, &[]);
        assert!(found.starts_with(&expected), "{found}\nis not\n{expected}");
    };
    refuses(
        "hoist.yaml",
        "hoits.yaml",
        "hoits",
        "parts.crane.part: found no file hoits.yaml, allowed: a part of the gallery",
    );
    refuses("hoist.yaml", "hoist", "hoist", "parts.crane.part: found no file gallery:parts/hoist.yaml, allowed: ");
    refuses(
        "hoist.yaml",
        "./ship.yaml",
        "./ship",
        "parts.crane.part: found ship.yaml -> ship.yaml, allowed: a chain of parts that ends",
    );
    refuses(
        "on: ship",
        "on: shp",
        "shp",
        "parts.crane.on: found shp, allowed: one of ship, crane_trolley, crane_block, world; did you mean ship?",
    );
    refuses("crane:", "Crane:", "Crane", "parts.Crane: found \"Crane\", allowed: a name of small letters");
    refuses(
        "on: ship",
        "prefix: Big, on: ship",
        "Big",
        "parts.crane.prefix: found \"Big\", allowed: a name of small letters",
    );
    refuses(
        "position_m: [4, 0, 1.5]",
        "position_m: [4, 0]",
        "[4, 0]",
        "parts.crane.position_m: found [4, 0], allowed: a list of 3 numbers",
    );
    refuses(
        "position_m",
        "postion_m",
        "postion_m",
        "parts.crane.postion_m: found an unknown field, allowed: one of part, ",
    );
    refuses(
        "bodies:\n",
        "bodies:\n  crane_block: {mass_kg: 1, shape: {point: {}}, joint: {fixed: {}}}\n",
        "crane: {",
        "parts.crane: found bodies.crane_block a second time",
    );
    refuses(
        "on: ship",
        "on: ship, parameters: {lod_t: 73}",
        "73}",
        "parts.crane.parameters.lod_t: found an unknown name, allowed: a dotted path of a field, or load_t or reach_m; did you mean load_t?",
    );
    refuses(
        "on: ship",
        "on: ship, parameters: {load_t: 99}",
        "99",
        "parts.crane.parameters.load_t: found 99, allowed: a number from 1 to 9",
    );
    refuses(
        "on: ship",
        "on: ship, parameters: {bodies.block.mass_t: -9}",
        "-9",
        "parts.crane.parameters.bodies.block.mass_t: found -9, allowed: a number greater than 0",
    );
    refuses(
        "title: A ship",
        "title: A ship\nparameters: [{name: x, writes: [parts.crane.part]}]",
        "parts.crane.part",
        "parameters.0.writes.0: found \"parts.crane.part\", allowed: position_m or orientation_rad of a part",
    );
    refuses(
        "parts:",
        "parameters: [{name: crane_load_t, default: 3, writes: [bodies.ship.mass_t]}]\nparts:",
        "crane: {",
        "parts.crane: found the parameter crane_load_t a second time",
    );
}

#[test]
fn the_error_of_a_mistake_set_from_outside_names_the_setting() {
    let refuses = |name: &str, value: Value, says: &str| {
        let found = error(SHIP, HOIST, &[(name, value)]);
        assert!(found.starts_with(says), "{found}");
    };
    refuses("crane_load_t", json!(-3), "--set crane_load_t: found -3, allowed: a number from 1 to 9");
    refuses(
        "bodies.crane_block.mass_t",
        json!(-3),
        "--set bodies.crane_block.mass_t: found -3, allowed: a number greater than 0",
    );
    refuses(
        "parts.crane.parameters.load_t",
        json!(-3),
        "--set parts.crane.parameters.load_t: found -3, allowed: a number from 1 to 9",
    );
    refuses("parts.crane.on", json!("boat"), "--set parts.crane.on: found boat, allowed: one of ship, ");
    refuses("parts.davit.on", json!("ship"), "--set parts.davit.on: found no field \"davit\" in parts, allowed: crane");
    refuses(
        "parts.davit.parameters.load_t",
        json!(3),
        "--set parts.davit.parameters.load_t: found \"davit\", allowed: crane",
    );
    refuses(
        "parts.crane.position_m.0",
        json!("x"),
        "--set parts.crane.position_m.0: found the text \"x\", allowed: a number",
    );
}
