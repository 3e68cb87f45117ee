//! The timelines of an operation and of a task.

use crate::elements::Operation;
use crate::elements::operation::{Bound, ColumnRange, Condition, Move, OperationStep};
use crate::elements::{Input, Layout};
use crate::model::{Attachment, Model};
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::attachments::attachment;
use crate::scenario::assembly::columns::{self, Column};
use crate::scenario::assembly::wires;
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Scenario};
use crate::scenario::wording::one_of_with_hint;
use crate::simulation::Setup;

/// Names of the operation and of the task in the table of events.
pub(crate) const NAME: &str = "operation";
pub(crate) const TASK: &str = "task";

/// Adds the operation and the task, if they are enabled, before the controllers, because an operation may set their
/// commands. The controllers are the last `controllers` of all elements.
pub fn add<S: Quantity>(scenario: &Scenario<S>, setup: &mut Setup<S>, controllers: usize) -> Result<(), FieldError> {
    if let Some(given) = scenario.operation.as_ref().filter(|operation| operation.enabled) {
        check_ends(&given.steps)?;
        insert(setup, controllers, (NAME, "operation.steps", "step"), &given.steps)?;
    }
    if let Some(given) = scenario.task.as_ref().filter(|task| task.enabled) {
        if let Some(mark) = &given.mark {
            place_of(scenario, &setup.model, mark)?;
        }
        let steps: Vec<_> = given.stages.iter().map(step_of).collect();
        insert(setup, controllers, (TASK, "task.stages", "stage"), &steps)?;
    }
    Ok(())
}

/// Adds a timeline; `field` is the path of its steps, and `one` the word for one of them.
fn insert<S: Quantity>(
    setup: &mut Setup<S>,
    controllers: usize,
    (name, field, one): (&str, &str, &str),
    given: &[schema::OperationStep<S>],
) -> Result<(), FieldError> {
    if given.is_empty() {
        return Err(FieldError::new(field, "none", format!("at least one {one}")));
    }
    let mut layout = Layout::new(&setup.elements, 0);
    layout.connect(&setup.wires);
    let held: Vec<&str> = setup.model.loops.iter().map(|closed| closed.name.as_str()).collect();
    let (known, inputs, columns) = (columns::of(setup), Vec::new(), Vec::new());
    let mut reader = Reader { layout: &layout, held, known, inputs, columns };
    let steps = given.iter().enumerate().map(|(i, step)| reader.step(&format!("{field}.{i}"), step));
    let steps = steps.collect::<Result<_, _>>()?;
    let Reader { inputs, columns, .. } = reader;
    let step_s = setup.settings.step_s;
    let operation = Operation { name: name.to_owned(), steps, inputs, columns, step_s };
    setup.elements.insert(setup.elements.len() - controllers, Box::new(operation));
    Ok(())
}

/// Returns a stage as a step without moves.
fn step_of<S>(stage: &schema::TaskStage) -> schema::OperationStep<S> {
    let schema::TaskStage { name, until } = stage.clone();
    schema::OperationStep { name, set: Vec::new(), until: Some(until), time_out_s: None }
}

/// Returns the place of a mark, relative to the centre of mass of its body.
pub(crate) fn place_of<S: Quantity>(
    scenario: &Scenario<S>,
    model: &Model<S>,
    mark: &schema::Mark<S>,
) -> Result<Attachment<S>, FieldError> {
    let pin = schema::Pin { body: mark.body.clone(), position_m: mark.position_m };
    attachment(scenario, model, "task.mark.position_m", &pin)
}

/// Checks that every step has moves or a condition; only the last step needs neither.
fn check_ends<S>(steps: &[schema::OperationStep<S>]) -> Result<(), FieldError> {
    for (i, step) in steps.iter().enumerate().filter(|(_, step)| step.until.is_none()) {
        let field = format!("operation.steps.{i}");
        let wait = "until, as until: {after_s: 30} to wait";
        if step.time_out_s.is_some() {
            return Err(FieldError::new(format!("{field}.time_out_s"), "a time-out without until", wait));
        }
        if step.set.is_empty() && i + 1 < steps.len() {
            return Err(FieldError::new(field, "neither set nor until", format!("set, or {wait}")));
        }
    }
    Ok(())
}

/// Inputs and columns named by the steps, collected during reading.
struct Reader<'a> {
    layout: &'a Layout,
    /// Loops that cannot be released.
    held: Vec<&'a str>,
    known: Vec<Column>,
    inputs: Vec<String>,
    columns: Vec<String>,
}

impl Reader<'_> {
    fn step<S: Quantity>(
        &mut self,
        field: &str,
        step: &schema::OperationStep<S>,
    ) -> Result<OperationStep<S>, FieldError> {
        if step.name.trim().is_empty() {
            return Err(FieldError::new(format!("{field}.name"), &step.name, "a text that describes the step"));
        }
        let mut moves: Vec<(usize, Vec<Move<S>>)> = Vec::new();
        let mut last_s: f64 = 0.0;
        for (k, given) in step.set.iter().enumerate() {
            let field = format!("{field}.set.{k}");
            let (input, one) = self.one_move(&field, given)?;
            last_s = last_s.max(one.at_s + one.in_s);
            match moves.iter_mut().find(|(known, _)| *known == input) {
                Some((_, moves)) => {
                    check_order(&field, moves, &one)?;
                    moves.push(one);
                }
                None => moves.push((input, vec![one])),
            }
        }
        let until = match &step.until {
            Some(until) => self.condition(&format!("{field}.until"), until, &mut 0)?,
            None => Condition::After(last_s),
        };
        let time_out_s = step.time_out_s.map(|time| time.get());
        if let Some(found) = time_out_s.filter(|time_out_s| *time_out_s < until.least_s()) {
            let allowed = format!("at least {} s, the least duration of its condition", until.least_s());
            return Err(FieldError::new(format!("{field}.time_out_s"), found, allowed));
        }
        Ok(OperationStep { name: step.name.clone(), moves, until, time_out_s })
    }

    fn one_move<S: Quantity>(
        &mut self,
        field: &str,
        given: &schema::InputMove<S>,
    ) -> Result<(usize, Move<S>), FieldError> {
        let names = || self.layout.inputs.iter().map(|input| input.name.as_str()).collect::<Vec<_>>();
        let Some(place) = self.layout.inputs.iter().position(|input| *input.name == *given.input) else {
            if self.held.contains(&given.input.as_ref()) {
                let allowed = "an input: a loop has one with connection: {}, which releases it";
                return Err(FieldError::new(format!("{field}.input"), &given.input, allowed));
            }
            let names = names();
            let none = || {
                "an input: enabled drives, ropes and loops with connection have one, and motors with history: lever"
                    .to_owned()
            };
            let allowed = if names.is_empty() { none() } else { one_of_with_hint(&names, &given.input) };
            return Err(FieldError::new(format!("{field}.input"), &given.input, allowed));
        };
        let Input { name, unit, lower, upper, signal, .. } = &self.layout.inputs[place];
        if let Some(signal) = signal {
            let allowed = format!("an input that no wire sets: it takes {signal}");
            return Err(FieldError::new(format!("{field}.input"), name, allowed));
        }
        if let Some(controller) = self.layout.set_by(place) {
            let allowed = format!("an input that no controller sets, such as the command of {controller}");
            return Err(FieldError::new(format!("{field}.input"), name, allowed));
        }
        let factor = columns::factor(&format!("{field}.unit"), given.unit.as_deref(), unit)?;
        let to = given.to * S::constant(factor);
        if let Some(found) = to.outside(|to| (*lower..=*upper).contains(&to)) {
            let shown = given.unit.as_deref().unwrap_or(unit);
            let shown = if shown == "1" { String::new() } else { format!(" {shown}") };
            let allowed = format!("{} to {}{shown}", lower / factor, upper / factor);
            return Err(FieldError::new(format!("{field}.to"), found / factor, allowed));
        }
        let one = Move { at_s: given.at_s.get(), in_s: given.in_s.get(), to };
        let known = self.inputs.iter().position(|known| known == name);
        let input = known.unwrap_or_else(|| {
            self.inputs.push(name.clone());
            self.inputs.len() - 1
        });
        Ok((input, one))
    }

    /// Reads a condition; `kept` numbers of the step are taken, and more after it.
    fn condition(&mut self, field: &str, given: &schema::Condition, kept: &mut usize) -> Result<Condition, FieldError> {
        let place = *kept;
        let mut several = |kind: &str, given: &[schema::Condition]| {
            if given.is_empty() {
                return Err(FieldError::new(format!("{field}.{kind}"), "none", "at least one condition"));
            }
            let each = given.iter().enumerate();
            each.map(|(k, one)| self.condition(&format!("{field}.{kind}.{k}"), one, kept))
                .collect::<Result<Vec<_>, _>>()
        };
        Ok(match given {
            schema::Condition::AfterS(time) => Condition::After(time.get()),
            schema::Condition::All(all) => Condition::All(several("all", all)?),
            schema::Condition::Any(any) => Condition::Any(several("any", any)?),
            schema::Condition::Value(range) => Condition::Column(self.range(&format!("{field}.value"), range)?),
            schema::Condition::Holds(given) => {
                *kept += 1;
                let part = self.condition(&format!("{field}.holds.condition"), &given.condition, kept)?;
                Condition::Holds(given.for_s.get(), place, Box::new(part))
            }
            schema::Condition::Count(given) => {
                if given.times == 0 {
                    return Err(FieldError::new(format!("{field}.count.times"), 0, "1 or more"));
                }
                *kept += 2;
                let part = self.condition(&format!("{field}.count.condition"), &given.condition, kept)?;
                Condition::Count(given.times, place, Box::new(part))
            }
            schema::Condition::Lull(lull) => {
                let [ready, bound] = self.forecast(&format!("{field}.lull.forecast"), &lull.forecast)?;
                let below_m = Some(Bound::Number(lull.below_m.get()));
                let range = |(column, place), above, below, unit: &str| {
                    Condition::Column(ColumnRange { column, place, above, below, unit: (unit.to_owned(), 1.0) })
                };
                Condition::All(vec![
                    range(ready, Some(Bound::Number(0.0)), None, "1"),
                    range(bound, None, below_m, "m"),
                ])
            }
        })
    }

    /// Returns two columns of a forecast: whether it is ready, and its bound.
    fn forecast(&mut self, field: &str, name: &str) -> Result<[(String, usize); 2], FieldError> {
        let columns = ["forecast_ready", "predicted_heave_bound"].map(|variable| format!("{name}.{variable}"));
        if !self.known.iter().any(|known| known.name == columns[1]) {
            let forecasts: Vec<&str> =
                self.known.iter().filter_map(|known| known.name.strip_suffix(".predicted_heave_bound")).collect();
            let allowed = wires::allowed(&forecasts, name, "a controller of the kind heave_forecast that is enabled");
            return Err(FieldError::new(field, name, allowed));
        }
        Ok(columns.map(|column| {
            let place = self.place(&column);
            (column, place)
        }))
    }

    /// Returns the index of a column among those that the operation reads.
    fn place(&mut self, name: &str) -> usize {
        self.columns.iter().position(|known| known == name).unwrap_or_else(|| {
            self.columns.push(name.to_owned());
            self.columns.len() - 1
        })
    }

    /// Returns a bound, from a number or another column with this unit.
    fn bound(
        &mut self,
        [field, side]: [&str; 2],
        (number, other): (Option<f64>, Option<&str>),
        column: &Column,
    ) -> Result<Option<Bound>, FieldError> {
        let named = || format!("{field}.{side}_column");
        match (number, other) {
            (None, None) => Ok(None),
            (Some(number), None) => Ok(Some(Bound::Number(number))),
            (Some(_), Some(_)) => Err(FieldError::new(named(), format!("with {side}"), "one of the two")),
            (None, Some(name)) => {
                let found = columns::find(&self.known, &named(), name)?;
                if found.unit != column.unit {
                    let allowed = format!("a column in {}", column.unit);
                    return Err(FieldError::new(named(), format!("{name}, in {}", found.unit), allowed));
                }
                Ok(Some(Bound::Column(name.to_owned(), self.place(name))))
            }
        }
    }

    fn range(&mut self, field: &str, given: &schema::ColumnRange) -> Result<ColumnRange, FieldError> {
        let column = columns::find(&self.known, &format!("{field}.column"), &given.column)?.clone();
        let factor = columns::factor(&format!("{field}.unit"), given.unit.as_deref(), column.unit)?;
        let others = [&given.above_column, &given.below_column].map(|other| other.as_ref().map(|name| &**name));
        let above = self.bound([field, "above"], (given.above, others[0]), &column)?;
        let below = self.bound([field, "below"], (given.below, others[1]), &column)?;
        match (&above, &below) {
            (None, None) => {
                let allowed = "above or below, above_column or below_column, or one of each";
                return Err(FieldError::new(field, "no bound", allowed));
            }
            (Some(Bound::Number(above)), Some(Bound::Number(below))) if above >= below => {
                return Err(FieldError::new(format!("{field}.above"), above, format!("less than below, {below}")));
            }
            _ => {}
        }
        let place = self.place(&given.column);
        let unit = (given.unit.clone().unwrap_or_else(|| column.unit.to_owned()), factor);
        Ok(ColumnRange { column: given.column.to_string(), place, above, below, unit })
    }
}

/// Checks that a move begins after the end of the previous move of the same input.
fn check_order<S>(field: &str, before: &[Move<S>], one: &Move<S>) -> Result<(), FieldError> {
    let Some(last) = before.last() else { return Ok(()) };
    let ends_s = last.at_s + last.in_s;
    if one.at_s >= ends_s {
        return Ok(());
    }
    let allowed = format!("at least {ends_s}, the end of the previous move of the same input");
    Err(FieldError::new(format!("{field}.at_s"), one.at_s, allowed))
}
