//! The fields that contain names and files, by the JSON Schema of the types, are those that the mounting of
//! parts changes.
#![cfg(feature = "schema")]

use kingpost::scenario::json_schema::json_schema;
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

/// A text without a form is either one for people, or its type states that it names a file or a column: a
/// part changes these.
#[test]
fn a_text_of_no_form_is_known() {
    let known = BTreeSet::from([
        // For people, and what belongs to the sea of the whole.
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
        "Task.text",
        "TaskStage.name",
        // Files.
        "Hydrodynamics.database",
        "MovedByWaves.raos",
        // Columns.
        "FeedbackRead.column",
        "PolicyRead.column",
        "AlsoRead.column",
        "ColumnRange.column",
        "ColumnRange.above_column",
        "ColumnRange.below_column",
        "Limit.column",
    ]);
    let texts: BTreeSet<String> = properties(&json_schema())
        .into_iter()
        .filter(|(_, _, property)| is_text(property, false))
        .map(|(of, field, _)| format!("{of}.{field}"))
        .filter(|path| !path.starts_with("Parameter.default"))
        .collect();
    let unknown: Vec<&String> = texts.iter().filter(|path| !known.contains(path.as_str())).collect();
    assert!(unknown.is_empty() && texts.len() == known.len(), "{unknown:?} of {texts:?}");
}

#[test]
fn every_field_with_a_place_in_the_world_is_moved_with_a_part() {
    // Moved by the mounting, or of the sea and wind, which are the whole's; or directions that no part has of its own.
    let known = BTreeSet::from([
        "InitialMotion.position_m",
        "InitialMotion.drawing_frame_m",
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
