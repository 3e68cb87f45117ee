//! An operation as a timeline: named steps that move levers and set-points, each until its condition holds.

pub(crate) mod assembly;
mod condition;
pub(crate) mod fields;

pub use condition::{Bound, ColumnRange, Condition, Now};

use crate::elements::{AnyElement, Context, Declaration, Element, ElementState, Occurrence, Output, of_kind};
use crate::scalar::Scalar;

/// A timeline. The condition of its current step is checked at the start of each integrator step, so a step of the
/// operation ends at most one integrator step late. During each integrator step, an input that moves gradually has its
/// value at the middle of the step, which makes the motion accurate to second order in the step; a row of results has
/// the value at its time.
#[derive(Clone, Debug)]
pub struct Operation<S = f64> {
    /// Name in the table of events.
    pub name: String,
    /// The steps, in order.
    pub steps: Vec<OperationStep<S>>,
    /// The inputs that it sets.
    pub inputs: Vec<String>,
    /// The columns that its conditions read.
    pub columns: Vec<String>,
    /// Step of the integrator, s.
    pub step_s: f64,
}

/// A step of an operation.
#[derive(Clone, Debug)]
pub struct OperationStep<S = f64> {
    /// Name of the step, which describes it.
    pub name: String,
    /// Moves of each input, with its index among [`Operation::inputs`], in order of time without overlap.
    pub moves: Vec<(usize, Vec<Move<S>>)>,
    /// The condition that ends it.
    pub until: Condition,
    /// The run ends with an error if the step lasts longer, s.
    pub time_out_s: Option<f64>,
}

/// The move of an input to a value.
#[derive(Clone, Copy, Debug)]
pub struct Move<S = f64> {
    /// When it begins, s after the start of the step.
    pub at_s: f64,
    /// Its duration, s; 0 for a jump.
    pub in_s: f64,
    /// The new value, in the input's unit.
    pub to: S,
}

/// Rounding of a time, as a share of an integrator step.
const TIME_SLACK: f64 = 1e-9;
/// The only mode: the current step, from 1; 0 before the first, the number of steps plus 1 after the last.
const STEP: usize = 0;
/// Numbers: start time of the step, s; from [`FROM`] on the value of each input at that time, and then those of the condition
/// of the step.
const BEGAN: usize = 0;
const FROM: usize = 1;

impl<S: Scalar> Operation<S> {
    /// Returns the operation among elements, if there is one.
    pub fn among(elements: &[AnyElement<S>]) -> impl Iterator<Item = &Self> {
        of_kind(elements)
    }
}

impl<S: Scalar> Element<S> for Operation<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let from = self.inputs.iter().map(|input| format!("{input}_at_its_start"));
        let step = Output::number(
            "operation_step",
            "current step of an operation, from 1; 0 before the first, the number of steps plus 1 after the last",
            "operation",
            &self.name,
            &["1"],
        );
        let most = self.steps.iter().map(|step| step.until.numbers()).max().unwrap_or(0);
        let of_condition = (0..most).map(|k| format!("condition_{}", k + 1));
        Declaration {
            numbers: core::iter::once("step_began".to_owned()).chain(from).chain(of_condition).collect(),
            modes: vec!["step".to_owned()],
            outputs: vec![step],
            reads: self.columns.clone(),
            steers: self.inputs.clone(),
            goes_alone: true,
            ..Declaration::default()
        }
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        out.push(S::constant(at.modes[STEP] as f64));
    }

    fn update_controls(
        &mut self,
        at: &Context<'_, S>,
        read: &[S],
        own: &mut ElementState<'_, S>,
        inputs: &mut [S],
    ) -> Result<Vec<Occurrence>, String> {
        let (time_s, columns) = (at.clock.time_s, read.iter().map(|value| value.value()).collect::<Vec<_>>());
        let mut happened = Vec::new();
        if own.modes[STEP] == 0 {
            happened.push(self.go_on(time_s, own, inputs));
        }
        while let Some(step) = self.step(own.modes[STEP]) {
            let elapsed_s = time_s - own.numbers[BEGAN].value();
            for (input, moves) in &step.moves {
                let (from, now) = (own.numbers[FROM + input], inputs[*input]);
                inputs[*input] = self
                    .begun(moves, elapsed_s, from)
                    .map_or(now, |(from, one)| one.value(from, elapsed_s + 0.5 * self.step_s));
            }
            let elapsed_s = elapsed_s + TIME_SLACK * self.step_s;
            let (now, kept) = (Now { elapsed_s, columns: &columns }, &mut own.numbers[FROM + self.inputs.len()..]);
            step.until.observe(now, kept);
            if step.until.holds(now, kept) {
                happened.push(self.go_on(time_s, own, inputs));
                continue;
            }
            match step.time_out_s {
                Some(time_out_s) if elapsed_s >= time_out_s => {
                    let missing = step.until.missing(now, kept);
                    return Err(format!("step {:?} did not end within {time_out_s} s: {missing}", step.name));
                }
                _ => break,
            }
        }
        Ok(happened)
    }

    fn at_end(&self, at: &Context<'_, S>, inputs: &mut [S]) {
        let Some(step) = self.step(at.modes[STEP]) else { return };
        let elapsed_s = at.clock.time_s - at.numbers[BEGAN].value();
        for (input, moves) in &step.moves {
            if let Some((from, one)) = self.begun(moves, elapsed_s, at.numbers[FROM + input]) {
                inputs[*input] = one.value(from, elapsed_s + self.step_s);
            }
        }
    }
}

impl<S: Scalar> Operation<S> {
    /// Returns the step of this number, from 1.
    fn step(&self, number: i64) -> Option<&OperationStep<S>> {
        self.steps.get(usize::try_from(number - 1).ok()?)
    }

    /// Begins the next step, or ends after the last; returns the event.
    fn go_on(&self, time_s: f64, own: &mut ElementState<'_, S>, inputs: &[S]) -> Occurrence {
        own.modes[STEP] += 1;
        own.numbers[BEGAN] = S::constant(time_s);
        let (from, kept) = own.numbers[FROM..].split_at_mut(inputs.len());
        from.copy_from_slice(inputs);
        let next = self.step(own.modes[STEP]);
        if let Some(step) = next {
            step.until.begin(kept);
        }
        match next {
            Some(step) => Occurrence { code: "step_begins", what: format!("begins {:?}", step.name) },
            None => Occurrence { code: "operation_ends", what: "ends".to_owned() },
        }
    }

    /// Returns the last move that has begun at this time after the start of the step, and the value from which it
    /// starts. At the start of the step the input is `from`.
    fn begun<'a>(&self, moves: &'a [Move<S>], elapsed_s: f64, from: S) -> Option<(S, &'a Move<S>)> {
        let begun = moves.partition_point(|one| one.at_s <= elapsed_s + TIME_SLACK * self.step_s);
        let last = begun.checked_sub(1)?;
        Some((last.checked_sub(1).map_or(from, |before| moves[before].to), &moves[last]))
    }
}

impl<S: Scalar> Move<S> {
    /// Returns the input at this time after the start of the step; the move starts from the value `from`.
    fn value(&self, from: S, elapsed_s: f64) -> S {
        let gone_s = elapsed_s - self.at_s;
        if gone_s >= self.in_s || self.in_s == 0.0 {
            self.to
        } else {
            from + (self.to - from) * S::constant(gone_s / self.in_s)
        }
    }
}
