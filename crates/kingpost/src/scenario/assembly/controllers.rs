//! Controllers, which set inputs of other elements.

use crate::elements::{AnyElement, Layout};
use crate::model::Model;
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::assembly::columns::{self, Column};
use crate::scenario::assembly::{FieldError, wires};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Controller, Scenario, SetsInputs};

/// Adds the controllers after all other elements, each before the one whose command it sets; returns their
/// number.
pub fn add<S: Quantity>(at: Surroundings<'_, S>, elements: &mut Vec<AnyElement<S>>) -> Result<usize, FieldError> {
    let Surroundings { scenario, model, .. } = at;
    let columns = known_columns(model, elements);
    check_targets(scenario, elements)?;
    let first = elements.len();
    let mut open: Vec<(&schema::Name, &Controller<S>)> = scenario.controllers.iter().collect();
    while !open.is_empty() {
        let layout = Layout::new(elements, 0);
        let has = |to: &str| layout.inputs.iter().any(|input| input.name == to);
        let ready = |one: &Controller<S>| one.sets_drives() || one.targets().into_iter().all(|(_, to)| has(to));
        let Some(next) = open.iter().position(|(_, one)| ready(one)) else {
            return Err(unknown_target(scenario, &layout, &open));
        };
        let (name, controller) = open.remove(next);
        let at = Surroundings { elements, columns: &columns, inputs: &layout.inputs, ..at };
        let assembled = controller.assemble(name, at)?;
        elements.splice(first..first, assembled);
    }
    Ok(elements.len() - first)
}

/// Returns the columns of the results and the states of elements.
fn known_columns<S: Quantity>(model: &Model<S>, elements: &[AnyElement<S>]) -> Vec<Column> {
    let mut known = columns::among(model, elements);
    let states = Layout::new(elements, 0).states.into_iter();
    known.extend(states.map(|state| Column { name: state.name, unit: state.unit }));
    known
}

/// Checks that no input is set twice and that the names of commands are unique.
fn check_targets<S: Quantity>(scenario: &Scenario<S>, elements: &[AnyElement<S>]) -> Result<(), FieldError> {
    let inputs = Layout::new(elements, 0).inputs;
    let mut set: Vec<(&str, &str)> = Vec::new();
    for (name, controller) in &scenario.controllers {
        if inputs.iter().any(|input| input.name == **name) {
            let allowed = "a name that no drive or rope with an input has";
            return Err(FieldError::new(format!("controllers.{name}"), "the name of an input", allowed));
        }
        for (field, to) in controller.targets() {
            if let Some((_, other)) = set.iter().find(|(taken, _)| *taken == to) {
                let found = format!("{to}, which {other} sets");
                return Err(FieldError::new(
                    format!("controllers.{name}.{field}"),
                    found,
                    "one controller to each input",
                ));
            }
            set.push((to, name.as_str()));
        }
    }
    Ok(())
}

/// Returns the error for the first target that is not an input.
fn unknown_target<S: Quantity>(
    scenario: &Scenario<S>,
    layout: &Layout,
    open: &[(&schema::Name, &Controller<S>)],
) -> FieldError {
    for (name, controller) in open {
        for (field, to) in controller.targets() {
            let field = format!("controllers.{name}.{field}");
            if layout.inputs.iter().any(|input| input.name == to) {
                continue;
            }
            if open.iter().any(|(other, _)| ***other == *to) {
                let allowed = "an input that does not lead back to it: the last controller sets a drive";
                return FieldError::new(field, to, allowed);
            }
            return wires::no_input(scenario, layout, field, to);
        }
    }
    FieldError::new("controllers", "an input that is missing", "inputs that exist")
}
