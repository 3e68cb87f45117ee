//! Assignments `name=value` on the command line.

use serde_json::{Number, Value};

use super::error::{Fault, ScenarioError, SourcePlace};
use super::wording;

/// Parses `name=value` into the name and the value. `on`, `true`, `off` and `false` are booleans; numbers,
/// and lists of numbers such as `[1, 2, 3]`, are read as such; any other value is text.
///
/// # Errors
/// No `=`, no name before it, or a number that is not finite.
pub fn parse_assignment(text: &str) -> Result<(String, Value), ScenarioError> {
    let fault = |field: &str, found: String, allowed: &str| {
        Fault::new(&SourcePlace::Set(field.to_owned()), field, found, allowed).in_file("")
    };
    let (name, value) = text.split_once('=').unwrap_or(("", text));
    let (name, value) = (name.trim(), value.trim());
    if name.is_empty() {
        return Err(fault(text, wording::quoted(text), wording::ASSIGNMENT));
    }
    let value = match value {
        "on" | "true" => Value::Bool(true),
        "off" | "false" => Value::Bool(false),
        list if list.starts_with('[') => serde_json::from_str(list).unwrap_or_else(|_| Value::String(list.to_owned())),
        other => match number(other) {
            Some(Value::Null) => return Err(fault(name, other.to_owned(), wording::FINITE)),
            Some(number) => number,
            None => Value::String(other.to_owned()),
        },
    };
    Ok((name.to_owned(), value))
}

/// Returns the number in a text; null if it is not finite.
fn number(text: &str) -> Option<Value> {
    let whole = text.parse::<i64>().map(Value::from).or_else(|_| text.parse::<u64>().map(Value::from));
    let number = || text.parse::<f64>().map(|number| Number::from_f64(number).map_or(Value::Null, Value::Number));
    whole.ok().or_else(|| number().ok())
}
