//! Warnings of numbers that are probably in another unit.
//!
//! A number in the wrong unit gives results that look correct. A value that no ship, crane or sea has is
//! reported at its field, with the unit in which it is read.

use crate::scenario::schema::Scenario;
use crate::scenario::wording;
use crate::scenario::writing::ToValue;
use core::f64::consts::TAU;
use serde_json::{Map, Value};

/// The plausible range of a field, and the units with which it is often confused.
struct Plausible {
    /// End of the field's path.
    field: &'static str,
    /// Smallest and largest plausible value, in the field's unit.
    range: [f64; 2],
    /// Reason for the range, and the units with which the field is confused.
    why: &'static str,
}

const TURN: [f64; 2] = [-TAU, TAU];
const IN_DEGREES: &str = "one turn, in radians: is it in degrees?";

/// Every field with a range. Lengths are not listed: they have no general range and are compared with the
/// size of the hull or the body.
const PLAUSIBLE: [Plausible; 10] = [
    Plausible { field: ".orientation_rad", range: TURN, why: IN_DEGREES },
    Plausible { field: ".initial_orientation_rad", range: TURN, why: IN_DEGREES },
    Plausible { field: ".initial_angle_rad", range: TURN, why: IN_DEGREES },
    Plausible { field: ".direction_rad", range: TURN, why: IN_DEGREES },
    Plausible { field: ".heading_rad", range: TURN, why: IN_DEGREES },
    Plausible {
        field: ".significant_height_m",
        range: [0.0, 20.0],
        why: "the highest that was measured is 19 m: is it in cm or feet?",
    },
    Plausible {
        field: "wind.speed_m_s",
        range: [0.0, 80.0],
        why: "more than the mean wind of any storm: is it in km/h or knots?",
    },
    Plausible {
        field: "current.speed_m_s",
        range: [0.0, 12.0],
        why: "more than any tidal stream: is it in cm/s or km/h?",
    },
    Plausible {
        field: "sea.density_kg_m3",
        range: [900.0, 1300.0],
        why: "hot fresh water to the Dead Sea: is it in t/m^3?",
    },
    Plausible { field: ".gravity.gravity_m_s2", range: [-30.0, 30.0], why: "that of Jupiter: is it in feet?" },
];

/// Warns of numbers outside their range, and of radii of gyration larger than their body.
pub fn of(scenario: &Scenario) -> Vec<String> {
    let written = scenario.to_value();
    let mut warnings = Vec::new();
    walk(&written, "", &mut warnings);
    of_gyration(scenario, &written, &mut warnings);
    warnings
}

fn walk(value: &Value, path: &str, warnings: &mut Vec<String>) {
    match value {
        Value::Object(fields) if is_off(fields) => {}
        Value::Object(fields) => {
            fields.iter().for_each(|(name, field)| walk(field, &format!("{path}.{name}"), warnings))
        }
        Value::Array(entries) => entries.iter().for_each(|entry| walk(entry, path, warnings)),
        Value::Number(number) => {
            let Some(value) = number.as_f64() else { return };
            let Some(Plausible { range: [least, most], why, .. }) =
                PLAUSIBLE.iter().find(|one| path.ends_with(one.field))
            else {
                return;
            };
            if !(*least..=*most).contains(&value) {
                let value = wording::with_powers(&value.to_string());
                warnings.push(format!("{}: {value} is outside of {why}", &path[1..]));
            }
        }
        _ => {}
    }
}

fn is_off(fields: &Map<String, Value>) -> bool {
    fields.get("enabled").is_some_and(|enabled| *enabled == Value::Bool(false))
}

/// Warns of a radius of gyration larger than its body: than the hull's length or the size of the shape.
fn of_gyration(scenario: &Scenario, written: &Value, warnings: &mut Vec<String>) {
    let bodies = written.get("bodies").and_then(Value::as_object).into_iter().flatten();
    for (name, body) in bodies.filter(|(_, body)| !body.as_object().is_some_and(is_off)) {
        let radii = body.pointer("/inertia/radii_of_gyration/radii_m").and_then(Value::as_array);
        let Some(radius) = radii.into_iter().flatten().filter_map(Value::as_f64).reduce(f64::max) else { continue };
        let length = hull_length(scenario, written, name).or_else(|| shape_length(body.get("shape")));
        if let Some(length) = length.filter(|length| radius > *length) {
            warnings.push(format!(
                "bodies.{name}.inertia.radii_of_gyration.radii_m: {radius} m, of a body {length:.4} m long: no body has a \
                 radius of gyration larger than itself; is it in mm?"
            ));
        }
    }
}

/// Returns the length of a body's hull by its database, m.
fn hull_length(scenario: &Scenario, written: &Value, body: &str) -> Option<f64> {
    let mut forces = written.get("forces")?.as_object()?.iter();
    forces.find_map(|(name, force)| {
        let of = force.pointer("/hydrodynamics/body")?.as_str()?;
        (of == body).then(|| scenario.database_of(name).map(|database| database.hull.length_m))?
    })
}

/// Returns an upper bound of a shape's size, m: twice the sum of its lengths, some of which are radii.
fn shape_length(shape: Option<&Value>) -> Option<f64> {
    let lengths = shape?.as_object()?.values().find_map(Value::as_object)?;
    let lengths = lengths.iter().filter(|(name, _)| name.ends_with("_m")).filter_map(|(_, value)| value.as_f64());
    Some(2.0 * lengths.sum::<f64>()).filter(|length| *length > 0.0)
}
