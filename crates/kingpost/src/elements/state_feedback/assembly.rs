//! Assembly of a state feedback: its columns, inputs, gains and limits.

use crate::elements::{AnyElement, FeedbackRead, FeedbackSteer, Input, StateFeedback};
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::assembly::columns::Column;
use crate::scenario::assembly::finite::{all_finite, finite};
use crate::scenario::assembly::{FieldError, columns};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema;
use crate::scenario::wording::one_of_with_hint;

impl<S: Quantity> Assemble<S> for schema::StateFeedback<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        let lead = format!("controllers.{name}.state_feedback");
        for (list, count) in [("reads", self.reads.len()), ("steers", self.steers.len())] {
            if count == 0 {
                return Err(FieldError::new(format!("{lead}.{list}"), "none", "at least one"));
            }
        }
        let inputs: Vec<Input> = self.steers.iter().filter_map(|steer| at.input(&steer.to)).collect();
        let each = inputs.iter().zip(&self.steers).enumerate();
        let steers = each.map(|(k, (to, steer))| steered(&format!("{lead}.steers.{k}"), name, self, steer, to));
        let steers: Vec<FeedbackSteer<S>> = steers.collect::<Result<_, _>>()?;
        let each = self.reads.iter().enumerate();
        let reads = each.map(|(k, given)| read(&format!("{lead}.reads.{k}"), given, &inputs, at.columns));
        let reads = reads.collect::<Result<_, _>>()?;
        let period_s = at.period_s(&format!("{lead}.period_s"), self.period_s)?;
        Ok(vec![Box::new(StateFeedback { name: name.to_owned(), reads, steers, period_s, acts: self.enabled })])
    }
}

fn read<S: Quantity>(
    field: &str,
    given: &schema::FeedbackRead<S>,
    inputs: &[Input],
    known: &[Column],
) -> Result<FeedbackRead<S>, FieldError> {
    let column = columns::find(known, &format!("{field}.column"), &given.column)?;
    let follows = match &given.follows {
        None => None,
        Some(follows) => {
            let Some(place) = inputs.iter().position(|input| input.name == **follows) else {
                let names: Vec<&str> = inputs.iter().map(|input| input.name.as_str()).collect();
                let allowed = one_of_with_hint(&names, follows);
                return Err(FieldError::new(format!("{field}.follows"), follows, allowed));
            };
            if inputs[place].unit != column.unit {
                let found = format!("{follows}, in {}", inputs[place].unit);
                let allowed = format!("an input in {}, as {}", column.unit, column.name);
                return Err(FieldError::new(format!("{field}.follows"), found, allowed));
            }
            Some(place)
        }
    };
    finite(&format!("{field}.reference"), given.reference)?;
    Ok(FeedbackRead { column: given.column.to_string(), reference: given.reference, follows })
}

/// Returns an input that a feedback sets, with its row of gains and its limits.
fn steered<S: Quantity>(
    field: &str,
    name: &str,
    feedback: &schema::StateFeedback<S>,
    given: &schema::FeedbackSteer<S>,
    to: &Input,
) -> Result<FeedbackSteer<S>, FieldError> {
    check_gains(&format!("{field}.gains"), &given.gains, feedback.reads.len())?;
    if !given.integral_gains.is_empty() {
        check_gains(&format!("{field}.integral_gains"), &given.integral_gains, feedback.reads.len())?;
    }
    let Input { lower, upper, .. } = *to;
    for (end, limit) in [("lower", given.lower), ("upper", given.upper)] {
        if let Some(found) = limit.and_then(|limit| limit.outside(|limit| (lower..=upper).contains(&limit))) {
            return Err(FieldError::new(format!("{field}.{end}"), found, format!("{lower} to {upper} {}", to.unit)));
        }
    }
    let limits = [given.lower.unwrap_or(S::constant(lower)), given.upper.unwrap_or(S::constant(upper))];
    if let Some(found) = (limits[1] - limits[0]).outside(|range| range >= 0.0) {
        let found = format!("a range of {found} {}", to.unit);
        return Err(FieldError::new(format!("{field}.lower"), found, "not more than upper"));
    }
    let several = feedback.steers.len() > 1;
    let command = if several { format!("{name}.{}", to.name) } else { name.to_owned() };
    let (gains, integral_gains) = (given.gains.clone(), given.integral_gains.clone());
    Ok(FeedbackSteer { to: to.clone(), command, gains, integral_gains, limits })
}

/// Checks a row of gains: one finite gain for each column.
fn check_gains<S: Quantity>(field: &str, gains: &[S], columns: usize) -> Result<(), FieldError> {
    if gains.len() != columns {
        let allowed = format!("{columns}, one for each column in reads");
        return Err(FieldError::new(field, format!("{} gains", gains.len()), allowed));
    }
    all_finite(field, gains)
}
