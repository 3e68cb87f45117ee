//! Controllers, which stand before inputs.

use crate::elements::compensation::assembly as compensation;
use crate::elements::compensation::assembly::in_axes as compensation_in_axes;
use crate::elements::drive_function::assembly as drive_function;
use crate::elements::policy::assembly as policy;
use crate::elements::{AnyElement, Input, Layout};
use crate::model::Model;
use crate::scenario::assembly::columns::{self, Column};
use crate::scenario::assembly::controller_reader::ControllerReader;
use crate::scenario::assembly::{FieldError, sensors};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Controller, Scenario};

/// Adds the controllers after all other elements, each before the one whose command it sets; returns how many.
pub fn add<S: Quantity>(
    scenario: &Scenario<S>,
    model: &Model<S>,
    elements: &mut Vec<AnyElement<S>>,
) -> Result<usize, FieldError> {
    let reader = ControllerReader { scenario, model, known: known_columns(model, elements) };
    check_targets(scenario, elements)?;
    let first = elements.len();
    let mut open: Vec<(&schema::Name, &Controller<S>)> = scenario.controllers.iter().collect();
    while !open.is_empty() {
        let layout = Layout::new(elements, 0);
        let has = |to: &str| layout.inputs.iter().any(|input| input.name == to);
        // The drives of a compensation are no commands of another controller.
        let ready = |one: &Controller<S>| one.is_compensation() || one.targets().into_iter().all(|(_, to)| has(to));
        let Some(next) = open.iter().position(|(_, one)| ready(one)) else {
            return Err(reader.unknown_target(&layout, &open));
        };
        let (name, controller) = open.remove(next);
        if let Some(element) = reader.element(name, controller, (elements.as_slice(), &layout))? {
            elements.insert(first, element);
        }
    }
    Ok(elements.len() - first)
}

/// The columns of the results and the states of elements.
fn known_columns<S: Quantity>(model: &Model<S>, elements: &[AnyElement<S>]) -> Vec<Column> {
    let mut known = columns::among(model, elements);
    let states = Layout::new(elements, 0).states.into_iter();
    known.extend(states.map(|state| Column { name: state.name, unit: state.unit }));
    known
}

/// Checks that no input is set twice and that the commands have names of their own.
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

impl<S: Quantity> ControllerReader<'_, S> {
    fn element(
        &self,
        name: &str,
        controller: &Controller<S>,
        (elements, layout): (&[AnyElement<S>], &Layout),
    ) -> Result<Option<AnyElement<S>>, FieldError> {
        let input = |to: &str| layout.inputs.iter().find(|input| input.name == to).cloned();
        let only = |to: &str| input(to).ok_or_else(|| self.unknown_target(layout, &[]));
        Ok(Some(match controller {
            Controller::InputShaper(given) => Box::new(self.shaper(name, given, only(&given.to)?)?),
            Controller::DriveFunction(given) => {
                Box::new(drive_function::drive_function(name, given, only(&given.to)?, self.step_s())?)
            }
            Controller::StateFeedback(given) => {
                let inputs: Vec<Input> = given.steers.iter().filter_map(|steer| input(&steer.to)).collect();
                Box::new(self.feedback(name, given, &inputs)?)
            }
            Controller::Policy(given) => {
                let inputs: Vec<Input> = given.steers.iter().filter_map(|steer| input(&steer.to)).collect();
                Box::new(self.policy(name, given, &inputs)?)
            }
            Controller::Selector(given) => {
                let inputs = given.steers.iter().filter_map(|target| input(&target.to)).collect();
                Box::new(policy::selector(name, given, inputs)?)
            }
            Controller::HeaveCompensation(given) => {
                return compensation::heave((self.scenario, self.model), name, given, elements);
            }
            Controller::ThreeAxisCompensation(given) => {
                return compensation_in_axes::three_axis((self.scenario, self.model), name, given, elements);
            }
            Controller::PlatformCompensation(given) => {
                return compensation_in_axes::platform((self.scenario, self.model), name, given, elements);
            }
        }))
    }

    /// An error for the first target that is no input.
    pub(crate) fn unknown_target(&self, layout: &Layout, open: &[(&schema::Name, &Controller<S>)]) -> FieldError {
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
                return sensors::no_input(self.scenario, layout, field, to);
            }
        }
        FieldError::new("controllers", "an input that is missing", "inputs that exist")
    }
}
