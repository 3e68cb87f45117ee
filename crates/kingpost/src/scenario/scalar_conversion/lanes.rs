//! Several scenarios with the same structure as one.

use serde_json::Value;

use super::super::build::assemble;
use super::super::error::FieldError;
use super::super::schema::Scenario;
use super::untyped;
use crate::scalar::{LANES, Lanes};
use crate::simulation::Setup;

/// The setup of up to [`LANES`] scenarios with the same structure, in lanes; the last one fills the remaining lanes.
/// `alone` are their separate setups.
///
/// # Errors
/// A number that must be the same in all of them.
pub(crate) fn side_by_side(scenarios: &[&Scenario], alone: &[&Setup]) -> Result<Setup<Lanes>, FieldError> {
    let first = scenarios[0];
    let written: Vec<Value> = scenarios.iter().map(|scenario| scenario.written()).collect();
    let lane = |k: usize| k.min(written.len() - 1);
    let setups: [&Setup; LANES] = core::array::from_fn(|k| alone[lane(k)]);
    let all = merged(core::array::from_fn(|k| &written[lane(k)]))
        .ok_or_else(|| FieldError::new("", "another structure", "the same"))?;
    let scenario = first.over::<Lanes>(&all).map_err(|error| untyped(&error))?;
    assemble(&scenario, &setups)
}

/// One tree from several: numbers that differ become lists. `None` if anything else differs.
fn merged(values: [&Value; LANES]) -> Option<Value> {
    let same_number = |a: &Value, b: &Value| a == b && a.as_f64().map(f64::to_bits) == b.as_f64().map(f64::to_bits);
    match values[0] {
        first @ Value::Number(_) if values.iter().all(|value| same_number(value, first)) => Some(first.clone()),
        Value::Number(_) => values.into_iter().map(|value| value.is_number().then(|| value.clone())).collect(),
        Value::Array(entries) => {
            let lists: Vec<&Vec<Value>> = values.into_iter().filter_map(Value::as_array).collect();
            let alike = lists.len() == LANES && lists.iter().all(|list| list.len() == entries.len());
            let entry = |i: usize| merged(core::array::from_fn(|k| &lists[k][i]));
            alike.then(|| (0..entries.len()).map(entry).collect())?
        }
        Value::Object(fields) => {
            let alike = values.iter().all(|value| value.as_object().is_some_and(|other| other.len() == fields.len()));
            let field = |name: &String| {
                let found: Vec<&Value> = values.into_iter().filter_map(|value| value.get(name)).collect();
                Some((name.clone(), merged(found.try_into().ok()?)?))
            };
            alike.then(|| fields.keys().map(field).collect::<Option<_>>().map(Value::Object))?
        }
        first => values.iter().all(|value| *value == first).then(|| first.clone()),
    }
}
