//! The fields that carry names and files are those that parts know, by the JSON Schema of the types.
#![cfg(feature = "schema")]

use kingpost::scenario::json_schema::json_schema;
use kingpost::scenario::{PART_FILES, PART_REFERENCES};
use serde_json::Value;
use std::collections::BTreeSet;

/// Every property of a type of the schema, as `Type.name`, with its schema.
fn properties(schema: &Value) -> Vec<(String, String, Value)> {
    let mut found = Vec::new();
    let types = schema["$defs"].as_object().expect("types");
    for (name, of_type) in types {
        let named = of_type["properties"].as_object().into_iter().flatten();
        found.extend(named.map(|(field, property)| (name.clone(), field.clone(), property.clone())));
    }
    found
}

/// Whether a value of this schema is a text of a form, or of none.
fn is_text(property: &Value, with_form: bool) -> bool {
    let any = property["anyOf"].as_array().into_iter().flatten();
    let kinds = property["type"].as_array().map_or_else(|| vec![property["type"].clone()], Clone::clone);
    let own = kinds.iter().any(|kind| kind == "string")
        && property.get("enum").is_none()
        && property.get("pattern").is_some_and(|form| form.as_str().is_some_and(|form| form.starts_with("^[a-z]")))
            == with_form;
    own || any.into_iter().any(|one| is_text(one, with_form))
}

/// A column of the results is a dotted name that begins with one of the scenario.
fn is_column(field: &str) -> bool {
    field == "column"
}

#[test]
fn every_field_that_names_something_of_the_scenario_is_prefixed_in_a_part() {
    // The name and the mounting of what parts do not prefix below their sections; an operation is the whole's; a point is named
    // beside its body; a branch is the selector's own.
    let elsewhere = BTreeSet::from([
        "Parameter.name",
        "Mounting.on",
        "InputMove.input",
        "OwnPoint.point",
        "Selector.selected",
        "ClearanceFrom.point",
        "AirGap.point",
    ]);
    let names: BTreeSet<String> = properties(&json_schema())
        .into_iter()
        .filter(|(_, field, property)| is_text(property, true) || is_column(field))
        .map(|(of, field, _)| format!("{of}.{field}"))
        .filter(|path| !elsewhere.contains(path.as_str()))
        .collect();
    assert!(names.len() > 20, "{names:?}");
    for path in &names {
        let field = path.split('.').next_back().unwrap_or_default();
        assert!(PART_REFERENCES.contains(&field), "{path} names something that a part would not find");
    }
    for field in PART_REFERENCES {
        assert!(names.iter().any(|path| path.ends_with(&format!(".{field}"))), "no field {field}");
    }
}

#[test]
fn every_field_that_names_a_file_is_looked_for_beside_the_part() {
    // Texts for people, colours, and what belongs to the sea of the whole.
    let others = BTreeSet::from([
        "Parameter.label",
        "Parameter.unit",
        "Mounting.part",
        "Mounting.prefix",
        "ElevationRecord.file",
        "Body.colour",
        "Limit.unit",
        "ColumnRange.unit",
        "InputMove.unit",
        "OperationStep.name",
    ]);
    let texts: BTreeSet<String> = properties(&json_schema())
        .into_iter()
        .filter(|(_, field, property)| is_text(property, false) && !is_column(field))
        .map(|(of, field, _)| format!("{of}.{field}"))
        .filter(|path| !others.contains(path.as_str()) && !path.starts_with("Parameter.default"))
        .collect();
    for path in &texts {
        let field = path.split('.').next_back().unwrap_or_default();
        assert!(PART_FILES.contains(&field), "{path} is a text that a part does not know");
    }
    assert_eq!(texts.len(), PART_FILES.len(), "{texts:?}");
}

#[test]
fn every_field_with_a_place_in_the_world_is_moved_with_a_part() {
    // Moved by the mounting, or of the sea and wind, which are the whole's; or directions that no part has of its own.
    let known = BTreeSet::from([
        "InitialMotion.position_m",
        "InitialMotion.velocity_m_s",
        "MovedByWaves.position_m",
        "MovedByWaves.heading_rad",
        "CatenaryLine.anchor_m",
        "StationTarget.x_m",
        "StationTarget.y_m",
        "StationTarget.heading_rad",
        "Sea.current_m_s",
        "CurrentTable.directions_rad",
        "Wind.direction_rad",
        "ElevationRecord.position_m",
        "RegularWave.phase_rad",
    ]);
    for (of, field, property) in properties(&json_schema()) {
        let says = property["description"].as_str().unwrap_or_default();
        let in_world = says.contains("in the world") || says.contains("the world's");
        let is_number = property.get("type").is_some_and(|kind| kind == "number" || kind == "array");
        let path = format!("{of}.{field}");
        assert!(!in_world || !is_number || known.contains(path.as_str()), "{path}: {says}");
    }
}
