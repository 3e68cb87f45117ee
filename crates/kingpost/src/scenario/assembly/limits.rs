//! Limits against which the results of a run are checked.

use super::super::schema::{self, Scenario};
use super::FieldError;
use super::columns;
use crate::scenario::leaf::Quantity;
use crate::scenario::wording::one_of_with_hint;
use crate::simulation::{Limit, Setup};

/// Returns the enabled limits.
pub fn of<S: Quantity>(scenario: &Scenario<S>, setup: &Setup<S>) -> Result<Vec<Limit>, FieldError> {
    let known = columns::of(setup);
    let one = |(name, given): (&schema::Name, &schema::Limit)| {
        let field = |rest: &str| format!("limits.{name}.{rest}");
        let column = columns::find(&known, &field("column"), &given.column)?;
        let factor = columns::factor(&field("unit"), given.unit.as_deref(), column.unit)?;
        let bounds = bounds(name, given)?;
        let unit = (given.unit.clone().unwrap_or_else(|| column.unit.to_owned()), factor);
        let (name, column) = (name.to_string(), given.column.to_string());
        let (from_s, until_s) = (given.from_s.get(), given.until_s.map_or(f64::INFINITY, |until| until.get()));
        if until_s <= from_s {
            return Err(FieldError::new(field("until_s"), until_s, format!("more than from_s, {from_s} s")));
        }
        let steps = steps(scenario, &given.steps, &field)?;
        let percentile = given.percentile.map_or(100.0, |percentile| percentile.get());
        if percentile > 100.0 {
            return Err(FieldError::new(field("percentile"), percentile, "above 0 and at most 100"));
        }
        Ok(Limit { name, column, unit, bounds, from_s, until_s, steps, percentile })
    };
    scenario.limits.iter().filter(|(_, limit)| limit.enabled).map(one).collect()
}

/// Returns the numbers of the steps of the operation with these names, from 1.
fn steps<S: Quantity>(
    scenario: &Scenario<S>,
    names: &[String],
    field: &dyn Fn(&str) -> String,
) -> Result<Vec<f64>, FieldError> {
    let known = scenario.operation.as_ref().map_or(&[][..], |operation| &operation.steps);
    let mut numbers = Vec::new();
    for (k, name) in names.iter().enumerate() {
        let before = numbers.len();
        numbers.extend(known.iter().zip(1_u32..).filter(|(step, _)| step.name == *name).map(|(_, n)| f64::from(n)));
        // A last step that waits for nothing has ended as it begins: the rest of the run belongs to it.
        let holds = known.last().is_some_and(|last| last.name == *name && last.set.is_empty() && last.until.is_none());
        numbers.extend(holds.then_some(known.len() as f64 + 1.0));
        if numbers.len() == before {
            let known: Vec<&str> = known.iter().map(|step| step.name.as_str()).collect();
            let none = || "a scenario with an operation, which has steps".to_owned();
            let allowed = if known.is_empty() { none() } else { one_of_with_hint(&known, name) };
            return Err(FieldError::new(field(&format!("steps.{k}")), name, allowed));
        }
    }
    Ok(numbers)
}

/// Returns the lower and the upper bound.
fn bounds(name: &str, given: &schema::Limit) -> Result<[Option<f64>; 2], FieldError> {
    let schema::Limit { at_least, at_most, within, .. } = given;
    let field = format!("limits.{name}");
    match (at_least, at_most, within) {
        (None, None, None) => Err(FieldError::new(field, "no bound", "at_most, at_least, both, or within")),
        (None, None, Some(within)) => Ok([Some(-within.get()), Some(within.get())]),
        (_, _, Some(_)) => Err(FieldError::new(field, "within together with at_most or at_least", "one or the other")),
        (Some(least), Some(most), None) if least > most => {
            let allowed = format!("not more than at_most, {most}");
            Err(FieldError::new(format!("{field}.at_least"), least, allowed))
        }
        (least, most, None) => Ok([*least, *most]),
    }
}
