//! A scenario's tree in SI units: unit aliases renamed, their numbers converted.

use indexmap::IndexMap;
use serde_json::{Number, Value};

use super::error::Fault;
use super::tree::{Content, Field, ScenarioNode};
use super::units::si_name;

/// Renames every field of the tree whose name ends in a unit alias, and converts its numbers. A field that
/// contains named fields is not a quantity but a named entry, for example a body `lift_t`, and is not
/// changed.
pub(super) fn to_si(node: &mut ScenarioNode) -> Result<(), Fault> {
    rename(node, &mut Vec::new())
}

fn rename(node: &mut ScenarioNode, path: &mut Vec<String>) -> Result<(), Fault> {
    match &mut node.content {
        Content::Scalar(_) => {}
        Content::List(entries) => {
            for (index, entry) in entries.iter_mut().enumerate() {
                path.push(index.to_string());
                rename(entry, path)?;
                path.pop();
            }
        }
        Content::Fields(fields) => {
            let mut renamed = IndexMap::with_capacity(fields.len());
            for (name, mut field) in std::mem::take(fields) {
                path.push(name.clone());
                rename(&mut field.node, path)?;
                let (name, field) = field_to_si(name, field);
                let place = field.node.place.clone();
                if let Some(other) = renamed.insert(name.clone(), field) {
                    let written = path.last().cloned().unwrap_or_default();
                    let other = other.written.unwrap_or(name);
                    let found = format!("both {other} and {written}");
                    return Err(Fault::new(&place, path.join("."), found, "one of the two"));
                }
                path.pop();
            }
            *fields = renamed;
        }
    }
    Ok(())
}

fn field_to_si(name: String, mut field: Field) -> (String, Field) {
    let is_quantity = !matches!(field.node.content, Content::Fields(_));
    match si_name(&name).filter(|_| is_quantity) {
        Some((si, factor)) => {
            convert(&mut field.node, factor);
            field.written = Some(name);
            (si, field)
        }
        None => (name, field),
    }
}

/// Converts the numbers of a quantity: one, or a list of them. Anything else, such as a number that is too
/// large in SI, is refused when the tree is read.
pub(super) fn convert(node: &mut ScenarioNode, factor: f64) {
    match &mut node.content {
        Content::List(entries) => entries.iter_mut().for_each(|entry| convert(entry, factor)),
        Content::Scalar(value) => {
            if let Some(number) = value.as_f64() {
                let converted = Number::from_f64(number * factor).map_or(Value::Null, Value::Number);
                node.written = Some(std::mem::replace(value, converted));
            }
        }
        Content::Fields(_) => {}
    }
}
