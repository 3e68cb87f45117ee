//! Steps of an operation: what each moves, and what ends it.

use crate::elements::operation::{Move, OperationStep};
use crate::elements::{AnyElement, Input, Layout, Operation};
use serde::Serialize;

/// A step of the operation.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct StepDescription {
    /// Its name.
    pub name: String,
    /// Its moves.
    pub moves: Vec<MoveDescription>,
    /// The condition that ends it, as text.
    pub until: String,
    /// Largest duration, s; absent if there is none.
    pub time_out_s: Option<f64>,
}

/// The move of an input.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct MoveDescription {
    /// Name of the input, mostly the name of its drive.
    pub input: String,
    /// The new value.
    pub to: f64,
    /// Unit of the value.
    pub unit: String,
    /// When it begins, s after the start of the step.
    pub at_s: f64,
    /// Its duration, s; 0 for a jump.
    pub in_s: f64,
}

/// Describes the steps of the operation among the elements of a setup.
pub(super) fn steps(elements: &[AnyElement]) -> Vec<StepDescription> {
    let inputs = Layout::new(elements, 0).inputs;
    Operation::among(elements)
        .flat_map(|operation| operation.steps.iter().map(|step| describe(step, operation, &inputs)))
        .collect()
}

fn describe(step: &OperationStep, operation: &Operation, inputs: &[Input]) -> StepDescription {
    let moves = step.moves.iter().flat_map(|(input, moves)| {
        let name = &operation.inputs[*input];
        let unit = inputs.iter().find(|input| input.name == *name).map_or("1", |input| input.unit);
        moves.iter().map(move |Move { at_s, in_s, to }| MoveDescription {
            input: name.clone(),
            to: *to,
            unit: unit.to_owned(),
            at_s: *at_s,
            in_s: *in_s,
        })
    });
    StepDescription {
        name: step.name.clone(),
        moves: moves.collect(),
        until: step.until.in_words(),
        time_out_s: step.time_out_s,
    }
}
