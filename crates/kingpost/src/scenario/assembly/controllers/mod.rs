//! Controllers, which stand before inputs.

use crate::elements::compensation::assembly as compensation;
use crate::elements::compensation::assembly::in_axes as compensation_in_axes;
use crate::elements::drive_function::assembly as drive_function;
use crate::elements::policy::assembly as policy;
use crate::elements::{AnyElement, FeedbackRead, FeedbackSteer, InputShaper, StateFeedback};
use crate::elements::{Input, Layout, ShaperKind, Swing, shaper_taps};
use crate::model::Model;
use crate::scenario::assembly::columns;
use crate::scenario::assembly::columns::Column;
use crate::scenario::assembly::controller_reader::{ControllerReader, all_finite, finite};
use crate::scenario::assembly::{FieldError, sensors};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema;
use crate::scenario::schema::{Controller, Scenario};
use crate::scenario::wording::one_of_with_hint;

/// Most steps in the period of a shaper: each is a number in a snapshot.
const MOST_STEPS: f64 = 20_000.0;

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

    fn shaper(&self, name: &str, given: &schema::InputShaper<S>, to: Input) -> Result<InputShaper<S>, FieldError> {
        let field = |rest: &str| format!("controllers.{name}.input_shaper.{rest}");
        let step_s = self.step_s();
        let (period, damping_ratio) = (given.period_s.get(), given.damping_ratio.get());
        if let Some(found) = period.outside(|period| 2.0 * step_s < period && period <= MOST_STEPS * step_s) {
            let allowed = format!("more than two steps, {}, to {MOST_STEPS} steps", 2.0 * step_s);
            return Err(FieldError::new(field("period_s"), found, allowed));
        }
        if let Some(found) = damping_ratio.outside(|ratio| ratio < 1.0) {
            return Err(FieldError::new(field("damping_ratio"), found, "a number from 0 to below 1"));
        }
        let kind = match given.shaper {
            schema::ShaperKind::Zv => Some(ShaperKind::Zv),
            schema::ShaperKind::Zvd => Some(ShaperKind::Zvd),
            schema::ShaperKind::Ei => Some(ShaperKind::Ei),
            schema::ShaperKind::None => None,
        };
        let swing = Swing { period, damping_ratio, tolerance: given.tolerance.get() };
        let taps =
            kind.filter(|_| given.enabled).map_or_else(|| vec![(0, S::ONE)], |kind| shaper_taps(kind, swing, step_s));
        Ok(InputShaper { name: name.to_owned(), to, taps })
    }

    fn feedback(
        &self,
        name: &str,
        given: &schema::StateFeedback<S>,
        inputs: &[Input],
    ) -> Result<StateFeedback<S>, FieldError> {
        let lead = format!("controllers.{name}.state_feedback");
        for (list, count) in [("reads", given.reads.len()), ("steers", given.steers.len())] {
            if count == 0 {
                return Err(FieldError::new(format!("{lead}.{list}"), "none", "at least one"));
            }
        }
        let each = inputs.iter().zip(&given.steers).enumerate();
        let steers = each.map(|(k, (to, steer))| steered(&format!("{lead}.steers.{k}"), name, given, steer, to));
        let steers: Vec<FeedbackSteer<S>> = steers.collect::<Result<_, _>>()?;
        let each = given.reads.iter().enumerate();
        let reads = each.map(|(k, read)| self.read(&format!("{lead}.reads.{k}"), read, inputs));
        let reads = reads.collect::<Result<_, _>>()?;
        let period_s = self.period_s(&format!("{lead}.period_s"), given.period_s)?;
        Ok(StateFeedback { name: name.to_owned(), reads, steers, period_s, acts: given.enabled })
    }

    pub(crate) fn read(
        &self,
        field: &str,
        given: &schema::FeedbackRead<S>,
        inputs: &[Input],
    ) -> Result<FeedbackRead<S>, FieldError> {
        let column = columns::find(&self.known, &format!("{field}.column"), &given.column)?;
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
}

/// An input that a feedback sets, with its row of gains and its limits.
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

/// A row of gains: a finite one for each column.
fn check_gains<S: Quantity>(field: &str, gains: &[S], columns: usize) -> Result<(), FieldError> {
    if gains.len() != columns {
        let allowed = format!("{columns}, one for each column in reads");
        return Err(FieldError::new(field, format!("{} gains", gains.len()), allowed));
    }
    all_finite(field, gains)
}
