//! JSON Schema of the scenario, for editors and for the generated types of other languages.

use schemars::generate::SchemaSettings;
use schemars::transform::{Transform, transform_subschemas};
use schemars::{Schema, schema_for};
use serde_json::{Map, Value, json};

use super::describe::Description;
use super::schema::Scenario;
use super::study::Study;
use super::units::aliases_of;
use crate::dynamics::moving_frame::Equations;
use crate::elements::{DrawnLine, Input, Warning};
use crate::results::Channel;

/// Returns the JSON Schema of a scenario, unit aliases included: each is a property in addition to its SI
/// name, marked `x-alias-of`.
pub fn json_schema() -> Value {
    let mut schema = schema_for!(Scenario);
    UnitAliases.transform(&mut schema);
    schema.to_value()
}

/// Returns the JSON Schema of a study.
pub fn study_schema() -> Value {
    schema_for!(Study).to_value()
}

/// Types of a scenario and of its results that the engine publishes to other languages.
#[derive(schemars::JsonSchema)]
#[expect(dead_code, reason = "only its schema is used")]
struct Published {
    model: Description,
    channels: Vec<Channel>,
    lines: Vec<DrawnLine>,
    inputs: Vec<Input>,
    warnings: Vec<Warning>,
}

/// Returns the JSON Schema of the types that describe a scenario and its run: model, channels, lines to draw,
/// inputs and warnings.
pub fn published_schema() -> Value {
    published::<Published>()
}

/// Returns the JSON Schema of the equations of the moving frame method.
pub fn equations_schema() -> Value {
    published::<Equations>()
}

/// Returns the JSON Schema of a type that the engine writes.
pub(crate) fn published<T: schemars::JsonSchema>() -> Value {
    let settings = SchemaSettings::draft2020_12().for_serialize();
    settings.into_generator().into_root_schema_for::<T>().to_value()
}

struct UnitAliases;

impl Transform for UnitAliases {
    fn transform(&mut self, schema: &mut Schema) {
        transform_subschemas(self, schema);
        let Some(object) = schema.as_object_mut() else { return };
        let Some(Value::Object(properties)) = object.get_mut("properties") else { return };
        let mut written = Vec::new();
        let mut with_aliases = Map::new();
        for (name, property) in std::mem::take(properties) {
            let aliases: Vec<String> = aliases_of(&name).collect();
            let copies: Vec<Value> = aliases.iter().map(|_| aliased(&property, &name)).collect();
            with_aliases.insert(name.clone(), property);
            with_aliases.extend(aliases.iter().cloned().zip(copies));
            if !aliases.is_empty() {
                written.push((name, aliases));
            }
        }
        *properties = with_aliases;
        exclude_both(object, &written);
    }
}

fn aliased(property: &Value, name: &str) -> Value {
    let mut copy = property.clone();
    if let Some(object) = copy.as_object_mut() {
        object.remove("default");
        object.insert("description".to_owned(), json!(format!("The same as `{name}`, in the unit of this name.")));
        object.insert("x-alias-of".to_owned(), json!(name));
    }
    copy
}

/// Adds the rule that at most one of an SI name and its aliases is given; exactly one if the field is
/// required.
fn exclude_both(object: &mut Map<String, Value>, written: &[(String, Vec<String>)]) {
    let mut rules = Vec::new();
    for (name, aliases) in written {
        let required = object.get_mut("required").and_then(Value::as_array_mut);
        let is_required = required.is_some_and(|required| {
            let before = required.len();
            required.retain(|entry| entry != name);
            required.len() < before
        });
        let names: Vec<&String> = core::iter::once(name).chain(aliases).collect();
        if is_required {
            let each: Vec<Value> = names.iter().map(|name| json!({"required": [name]})).collect();
            rules.push(json!({"oneOf": each}));
        } else {
            let pairs = names
                .iter()
                .enumerate()
                .flat_map(|(k, first)| names[k + 1..].iter().map(move |second| [first, second]));
            rules.extend(pairs.map(|pair| json!({"not": {"required": pair}})));
        }
    }
    if object.get("required").and_then(Value::as_array).is_some_and(Vec::is_empty) {
        object.shift_remove("required");
    }
    if !rules.is_empty() {
        object.insert("allOf".to_owned(), Value::Array(rules));
    }
}
