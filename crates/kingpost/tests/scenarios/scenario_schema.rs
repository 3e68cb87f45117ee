//! The JSON Schema in the repository equals that of the types.
#![cfg(feature = "schema")]

use kingpost::scenario::json_schema::{equations_schema, json_schema, published_schema, study_schema};
use kingpost::scenario::{UNIT_ALIASES, read};
use serde_json::Value;

const WRITTEN: &str = include_str!("../../../../schema/scenario.schema.json");
const WRITTEN_OF_STUDIES: &str = include_str!("../../../../schema/study.schema.json");
const WRITTEN_OF_MODELS: &str = include_str!("../../../../schema/model.schema.json");
const WRITTEN_OF_HYDROSTATICS: &str = include_str!("../../../../schema/hydrostatics.schema.json");
const WRITTEN_OF_EQUATIONS: &str = include_str!("../../../../schema/equations.schema.json");

#[test]
fn the_written_schema_is_that_of_the_types() {
    let text = serde_json::to_string_pretty(&json_schema()).unwrap() + "\n";
    assert!(
        text == WRITTEN,
        "schema/scenario.schema.json has drifted; run: cargo run -p kingpost --features schema --example write_schema"
    );
}

#[test]
fn the_written_schema_of_studies_is_that_of_the_types() {
    let text = serde_json::to_string_pretty(&study_schema()).unwrap() + "\n";
    assert!(
        text == WRITTEN_OF_STUDIES,
        "schema/study.schema.json has drifted; run: cargo run -p kingpost --features schema --example write_schema"
    );
}

#[test]
fn the_written_schema_of_models_is_that_of_the_types() {
    let text = serde_json::to_string_pretty(&published_schema()).unwrap() + "\n";
    assert!(
        text == WRITTEN_OF_MODELS,
        "schema/model.schema.json has drifted; run: cargo run -p kingpost --features schema --example write_schema"
    );
}

#[test]
fn the_written_schema_of_hydrostatics_is_that_of_the_types() {
    let text = serde_json::to_string_pretty(&kingpost::hydrostatics::json_schema()).unwrap() + "\n";
    assert!(
        text == WRITTEN_OF_HYDROSTATICS,
        "schema/hydrostatics.schema.json has drifted; run: cargo run -p kingpost --features schema --example write_schema"
    );
}

#[test]
fn the_written_schema_of_equations_is_that_of_the_types() {
    let text = serde_json::to_string_pretty(&equations_schema()).unwrap() + "\n";
    assert!(
        text == WRITTEN_OF_EQUATIONS,
        "schema/equations.schema.json has drifted; run: cargo run -p kingpost --features schema --example write_schema"
    );
}

/// Returns every property of a schema, with its name. A kind without fields is described by the kind itself.
fn properties(schema: &Value, into: &mut Vec<(String, Value)>) {
    match schema {
        Value::Array(entries) => entries.iter().for_each(|entry| properties(entry, into)),
        Value::Object(fields) => {
            if let Some(Value::Object(named)) = fields.get("properties") {
                let of_kind = fields.get("description").filter(|_| named.len() == 1);
                into.extend(named.iter().map(|(name, property)| {
                    let mut property = property.clone();
                    if let (Some(description), Value::Object(fields)) = (of_kind, &mut property) {
                        fields.entry("description").or_insert_with(|| description.clone());
                    }
                    (name.clone(), property)
                }));
            }
            fields.values().for_each(|field| properties(field, into));
        }
        _ => {}
    }
}

#[test]
fn every_field_is_described() {
    let mut all = Vec::new();
    properties(&json_schema(), &mut all);
    assert!(all.len() > 80);
    for (name, property) in all {
        let is_kind = property.get("$ref").is_some() || property.get("type") == Some(&Value::from("object"));
        assert!(is_kind || property.get("description").is_some(), "{name} is not described");
    }
}

#[test]
fn every_unit_alias_is_next_to_its_si_name() {
    let mut all = Vec::new();
    properties(&json_schema(), &mut all);
    let names: Vec<&str> = all.iter().map(|(name, _)| name.as_str()).collect();
    for alias in UNIT_ALIASES {
        assert!(names.iter().any(|name| name.ends_with(alias.ending)), "no field with {}", alias.ending);
    }
    for (name, property) in &all {
        if let Some(si) = property.get("x-alias-of").and_then(Value::as_str) {
            assert!(names.contains(&si), "{name} is an alias of {si}");
        }
    }
}

#[test]
fn a_field_of_the_schema_is_a_field_of_the_reader() {
    let error = read("version: 1\ntitle: x\nbodies: {}\nx: 1", "x.yaml", &[]).unwrap_err();
    let schema = json_schema();
    for name in schema["properties"].as_object().unwrap().keys() {
        assert!(error.allowed.contains(name.as_str()), "{name}");
    }
}
