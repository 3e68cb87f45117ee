//! Assembly of a learned policy.

use crate::elements::{AnyElement, Input, Policy, PolicyLayer, PolicyRead, PolicySteer};
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::assembly::columns::Column;
use crate::scenario::assembly::finite::{all_finite, finite};
use crate::scenario::assembly::{FieldError, columns};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema;

/// Largest number of weights and biases of a policy: every sample uses all of them.
const MOST_NUMBERS: usize = 100_000;

impl<S: Quantity> Assemble<S> for schema::Policy<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        let lead = format!("controllers.{name}.policy");
        let lists = [("reads", self.reads.len()), ("steers", self.steers.len()), ("layers", self.layers.len())];
        if let Some((list, _)) = lists.iter().find(|(_, count)| *count == 0) {
            return Err(FieldError::new(format!("{lead}.{list}"), "none", "at least one"));
        }
        let each = self.reads.iter().enumerate();
        let reads =
            each.map(|(k, read)| seen(&format!("{lead}.reads.{k}"), read, at.columns)).collect::<Result<_, _>>()?;
        let inputs: Vec<Input> = self.steers.iter().filter_map(|steer| at.input(&steer.to)).collect();
        let several = inputs.len() > 1;
        let each = inputs.iter().zip(&self.steers).enumerate();
        let steers = each.map(|(k, (to, steer))| {
            let command = if several { format!("{name}.{}", to.name) } else { name.to_owned() };
            steered(&format!("{lead}.steers.{k}"), command, steer, to)
        });
        let steers = steers.collect::<Result<_, _>>()?;
        let layers = layers(&lead, self)?;
        let period_s = at.period_s(&format!("{lead}.period_s"), self.period_s)?;
        Ok(vec![Box::new(Policy { name: name.to_owned(), reads, steers, layers, period_s, acts: self.enabled })])
    }
}

fn seen<S: Quantity>(
    field: &str,
    given: &schema::PolicyRead<S>,
    known: &[Column],
) -> Result<PolicyRead<S>, FieldError> {
    let first = columns::find(known, &format!("{field}.column"), &given.column)?;
    let mut columns = vec![given.column.to_string()];
    for (k, also) in given.also.iter().enumerate() {
        let field = format!("{field}.also.{k}.column");
        let column = columns::find(known, &field, &also.column)?;
        if column.unit != first.unit {
            let found = format!("{}, in {}", column.name, column.unit);
            return Err(FieldError::new(field, found, format!("a column in {}, as {}", first.unit, first.name)));
        }
        columns.push(also.column.to_string());
    }
    finite(&format!("{field}.reference"), given.reference)?;
    Ok(PolicyRead { columns, reference: given.reference, scale: given.scale.get() })
}

fn steered<S: Quantity>(
    field: &str,
    command: String,
    given: &schema::PolicySteer<S>,
    to: &Input,
) -> Result<PolicySteer<S>, FieldError> {
    let Input { lower, upper, .. } = *to;
    for (end, bound) in [("lower", given.lower), ("upper", given.upper)] {
        if let Some(found) = bound.and_then(|bound| bound.outside(|bound| (lower..=upper).contains(&bound))) {
            return Err(FieldError::new(format!("{field}.{end}"), found, format!("{lower} to {upper} {}", to.unit)));
        }
    }
    let bounds = [given.lower.unwrap_or(S::constant(lower)), given.upper.unwrap_or(S::constant(upper))];
    if let Some(found) = (bounds[1] - bounds[0]).outside(|range| range >= 0.0) {
        let found = format!("a range of {found} {}", to.unit);
        return Err(FieldError::new(format!("{field}.lower"), found, "not more than upper"));
    }
    Ok(PolicySteer { to: to.clone(), command, bounds })
}

/// Returns the layers, and checks that the size of each fits the layer before.
fn layers<S: Quantity>(lead: &str, given: &schema::Policy<S>) -> Result<Vec<PolicyLayer<S>>, FieldError> {
    let (mut inputs, mut numbers, mut layers) = (given.reads.len(), 0, Vec::new());
    for (k, layer) in given.layers.iter().enumerate() {
        let field = format!("{lead}.layers.{k}");
        let outputs = if k + 1 == given.layers.len() { given.steers.len() } else { layer.biases.len().max(1) };
        for (list, count) in [("weights", layer.weights.len()), ("biases", layer.biases.len())] {
            if count != outputs {
                let allowed = format!("{outputs}, one for each output");
                return Err(FieldError::new(format!("{field}.{list}"), format!("{count} entries"), allowed));
            }
        }
        for (row, weights) in layer.weights.iter().enumerate() {
            if weights.len() != inputs {
                let allowed = format!("{inputs}, one for each input of the layer");
                let found = format!("{} numbers", weights.len());
                return Err(FieldError::new(format!("{field}.weights.{row}"), found, allowed));
            }
            all_finite(&format!("{field}.weights.{row}"), weights)?;
        }
        all_finite(&format!("{field}.biases"), &layer.biases)?;
        numbers += outputs * (inputs + 1);
        inputs = outputs;
        layers.push(PolicyLayer { weights: layer.weights.clone(), biases: layer.biases.clone() });
    }
    if numbers > MOST_NUMBERS {
        let found = format!("{numbers} numbers");
        return Err(FieldError::new(format!("{lead}.layers"), found, format!("at most {MOST_NUMBERS} numbers")));
    }
    Ok(layers)
}
