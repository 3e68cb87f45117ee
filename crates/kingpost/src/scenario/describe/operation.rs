//! Steps of an operation, and stages of a task: what each moves, and what ends it.

use crate::elements::operation::assembly::{NAME, TASK, place_of};
use crate::elements::operation::{Move, OperationStep};
use crate::elements::{AnyElement, Input, Layout, Operation};
use crate::model::Model;
use crate::scenario::schema::{self, Scenario};
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

/// The task for whoever moves the levers.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct TaskDescription {
    /// The task in one sentence.
    pub text: String,
    /// Its stages.
    pub stages: Vec<StageDescription>,
    /// The mark at the place to reach; absent if there is none.
    pub mark: Option<MarkDescription>,
}

/// A stage of the task.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct StageDescription {
    /// Its name.
    pub name: String,
    /// The condition that ends it, as text.
    pub until: String,
}

/// A circle on a level surface.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct MarkDescription {
    /// Index of its body; absent for the world.
    pub body: Option<usize>,
    /// Its centre relative to the body's centre of mass, along the body's axes, or in the world, m.
    pub position_m: [f64; 3],
    /// Its radius, m.
    pub radius_m: f64,
}

/// Describes the task among the elements of a setup; `None` without one.
pub(super) fn task(scenario: &Scenario, model: &Model, elements: &[AnyElement]) -> Option<TaskDescription> {
    let given = scenario.task.as_ref()?;
    let timeline = Operation::among(elements).find(|operation| operation.name == TASK)?;
    let stage = |step: &OperationStep| StageDescription { name: step.name.clone(), until: step.until.in_words() };
    let mark = |mark: &schema::Mark| {
        let place = place_of(scenario, model, mark).ok()?;
        let (body, position_m) = (place.body, place.in_body.position.0);
        Some(MarkDescription { body, position_m, radius_m: mark.radius_m.get() })
    };
    let stages = timeline.steps.iter().map(stage).collect();
    Some(TaskDescription { text: given.text.clone(), stages, mark: given.mark.as_ref().and_then(mark) })
}

/// Describes the steps of the operation among the elements of a setup.
pub(super) fn steps(elements: &[AnyElement]) -> Vec<StepDescription> {
    let inputs = Layout::new(elements, 0).inputs;
    Operation::among(elements)
        .filter(|operation| operation.name == NAME)
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
