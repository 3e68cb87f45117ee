//! Given data of forces, drives, sensors, controllers and prescribed motions, as text for printing.

use crate::elements::significant;
use crate::scenario::schema::{Joint, Scenario};
use crate::scenario::units::si_ending;
use crate::scenario::writing::ToValue;
use serde::Serialize;
use serde_json::{Map, Value};

/// A force, a drive, a sensor or a controller.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ElementDescription {
    /// Name.
    pub name: String,
    /// Its section in the scenario: `forces`, `drives`, `sensors` or `controllers`.
    pub group: &'static str,
    /// Its kind, in words.
    pub kind: String,
    /// Whether it is enabled.
    pub enabled: bool,
    /// Its given data.
    pub facts: Vec<Fact>,
}

/// A given value, ready to print.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Fact {
    /// Its kind, in words.
    pub label: String,
    /// Its value.
    pub value: String,
    /// SI unit; empty if it has none.
    pub unit: &'static str,
}

/// Number of significant digits.
const DIGITS: usize = 6;
/// Fields of a history; only the field that `history` names is used.
const HISTORIES: [&str; 2] = ["pulse", "list"];

/// Describes the forces, drives, sensors and controllers, in the order of the scenario.
pub fn elements(scenario: &Scenario) -> Vec<ElementDescription> {
    let forces = scenario.forces.iter().filter_map(|(name, force)| described(name.as_str(), "forces", force));
    let drives = scenario.drives.iter().filter_map(|(name, drive)| described(name.as_str(), "drives", drive));
    let sensors = scenario.sensors.iter().filter_map(|(name, sensor)| described(name.as_str(), "sensors", sensor));
    let controllers =
        scenario.controllers.iter().filter_map(|(name, one)| described(name.as_str(), "controllers", one));
    forces.chain(drives).chain(sensors).chain(controllers).collect()
}

/// Describes an entry that is written under its kind, as in a scenario file.
fn described(name: &str, group: &'static str, tagged: &dyn ToValue) -> Option<ElementDescription> {
    let Value::Object(tagged) = tagged.to_value() else { return None };
    let (kind, Value::Object(fields)) = tagged.into_iter().next()? else { return None };
    let enabled = fields.get("enabled").and_then(Value::as_bool).unwrap_or(true);
    let facts = facts(&fields, "");
    Some(ElementDescription { name: name.to_owned(), group, kind: words(&kind), enabled, facts })
}

/// Returns the given data of a joint's prescribed motions; empty if no motion is prescribed.
pub fn prescribed(joint: &Joint) -> Vec<Fact> {
    let Value::Object(tagged) = joint.to_value() else { return Vec::new() };
    let Some(Value::Object(fields)) = tagged.into_iter().next().map(|(_, fields)| fields) else { return Vec::new() };
    let motion = |of: &Map<String, Value>, lead: &str| match of.get("mode").and_then(Value::as_object) {
        Some(mode) => mode.values().filter_map(Value::as_object).flat_map(|given| facts(given, lead)).collect(),
        None => Vec::new(),
    };
    let of_axes = fields.iter().filter_map(|(axis, of)| Some(motion(of.as_object()?, &words(axis))));
    motion(&fields, "").into_iter().chain(of_axes.flatten()).collect()
}

/// Returns the fields of an entry; the label of a nested field starts with the name of the outer field.
fn facts(fields: &Map<String, Value>, lead: &str) -> Vec<Fact> {
    let history = fields.get("history").and_then(Value::as_str);
    let counts = |name: &str| name != "enabled" && (!HISTORIES.contains(&name) || history == Some(name));
    let mut all = Vec::new();
    for (name, value) in fields.iter().filter(|(name, value)| counts(name) && !value.is_null()) {
        let (stem, unit) = si_ending(name)
            .map_or((name.as_str(), ""), |(ending, unit)| (name.strip_suffix(ending).unwrap_or(name), unit));
        let label = led_by(lead, &words(stem));
        match value {
            Value::Object(inner) => all.extend(facts(inner, &label)),
            value => all.push(Fact { label, value: written(value), unit }),
        }
    }
    all
}

/// Returns a label preceded by the name of its outer field; a word that both share is not repeated.
fn led_by(lead: &str, label: &str) -> String {
    if lead == label || lead.ends_with(&format!(" {label}")) {
        return lead.to_owned();
    }
    if lead.is_empty() { label.to_owned() } else { format!("{lead} {label}") }
}

fn words(name: &str) -> String {
    name.replace('_', " ")
}

fn written(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Number(number) => number.as_f64().map_or_else(|| number.to_string(), |x| significant(x, DIGITS)),
        Value::Array(entries) => format!("[{}]", entries.iter().map(written).collect::<Vec<_>>().join(", ")),
        Value::Object(fields) => {
            let each = |fact: Fact| [fact.label, fact.value, fact.unit.to_owned()].join(" ").trim_end().to_owned();
            facts(fields, "").into_iter().map(each).collect::<Vec<_>>().join(", ")
        }
        Value::Bool(_) | Value::Null => value.to_string(),
    }
}
