//! State feedback: inputs set from columns of the results by gains.

pub(crate) mod assembly;
pub(crate) mod fields;

use crate::elements::commanded::changed_commands;
use crate::elements::ticks::is_tick;
use crate::elements::{Context, Declaration, Element, ElementState, Input, LinearLaw, Occurrence};
use crate::scalar::Scalar;

/// Sets inputs from the columns x that it reads and its commands c, at multiples of its period:
///
/// ```text
/// u = c - K e - K_I (integral of e),    e = x - x_ref - w,    within its limits
/// ```
///
/// w is the command of the input that a column follows, and 0 for a column that follows none: the angle of a crane, for
/// example, follows the command of its slewing gear. With gains of a position and its rate in K, and of the position in
/// K_I, it is a PID controller. The integral is the sum over the samples times the period. While an input is at a
/// limit, its integral does not grow further beyond the limit (conditional integration: Astrom & Hagglund, *Advanced
/// PID Control*, 2006, sec. 3.5). Between two samples the correction is held; changes of the commands act at every
/// step.
#[derive(Clone, Debug)]
pub struct StateFeedback<S = f64> {
    /// Name in the results.
    pub name: String,
    /// Columns that it reads.
    pub reads: Vec<FeedbackRead<S>>,
    /// Inputs that it sets.
    pub steers: Vec<FeedbackSteer<S>>,
    /// Sampling period, s: a whole number of steps.
    pub period_s: f64,
    /// Whether it acts; if not, its commands pass unchanged.
    pub acts: bool,
}

/// A column that is fed back.
#[derive(Clone, Debug)]
pub struct FeedbackRead<S = f64> {
    /// The column, or the state of an element.
    pub column: String,
    /// x_ref.
    pub reference: S,
    /// The steered input whose command it follows.
    pub follows: Option<usize>,
}

/// An input that is steered.
#[derive(Clone, Debug)]
pub struct FeedbackSteer<S = f64> {
    /// The input.
    pub to: Input,
    /// The name of its command.
    pub command: String,
    /// Its row of K.
    pub gains: Vec<S>,
    /// Its row of K_I, in the unit of K over s; empty without integral gains.
    pub integral_gains: Vec<S>,
    /// Its limits.
    pub limits: [S; 2],
}

impl<S: Scalar> Element<S> for StateFeedback<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let reads = self.reads.iter().map(|read| read.column.clone()).collect();
        let steers = self.steers.iter().map(|steer| (&steer.to, &*steer.command));
        let mut declared = changed_commands("correction", steers, reads);
        declared.numbers.extend(self.steers.iter().map(|steer| format!("integral_{}", steer.to.name)));
        declared
    }

    fn update_controls(
        &mut self,
        at: &Context<'_, S>,
        read: &[S],
        own: &mut ElementState<'_, S>,
        inputs: &mut [S],
    ) -> Result<Vec<Occurrence>, String> {
        let (corrections, integrals) = own.numbers.split_at_mut(self.steers.len());
        if self.acts && is_tick(at.clock.time_s, self.period_s) {
            for (k, steer) in self.steers.iter().enumerate() {
                let proportional = self.correction(&steer.gains, read, at.inputs);
                let grown = self.correction(&steer.integral_gains, read, at.inputs) * S::constant(self.period_s);
                integrals[k] += steer.kept(grown, at.inputs[k] - proportional - integrals[k] - grown);
                corrections[k] = proportional + integrals[k];
            }
        }
        self.act(at.inputs, corrections, inputs);
        Ok(Vec::new())
    }

    fn at_end(&self, at: &Context<'_, S>, inputs: &mut [S]) {
        self.act(at.inputs_at_end, at.numbers, inputs);
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let first = out.len();
        out.extend_from_slice(at.inputs);
        self.act(at.inputs, at.numbers, &mut out[first..]);
    }

    fn linear_law(&self) -> Option<LinearLaw> {
        // An omitted row is zero.
        let row = |gains: &[S]| {
            (0..self.reads.len()).map(|k| gains.get(k).map_or(0.0, |gain| -gain.value())).collect::<Vec<_>>()
        };
        let integrates = self.steers.iter().any(|steer| !steer.integral_gains.is_empty());
        let integral_steers = if integrates { self.steers.as_slice() } else { &[] };
        self.acts.then(|| LinearLaw {
            gains: self.steers.iter().map(|steer| row(&steer.gains)).collect(),
            integral_gains: integral_steers.iter().map(|steer| row(&steer.integral_gains)).collect(),
            period_s: self.period_s,
        })
    }

    fn passes_to(&self, command: usize) -> Option<usize> {
        Some(command)
    }
}

impl<S: Scalar> StateFeedback<S> {
    /// Writes the actions: the commands less the corrections, within the limits.
    fn act(&self, commands: &[S], corrections: &[S], actions: &mut [S]) {
        let each = actions.iter_mut().zip(&self.steers).zip(commands.iter().zip(corrections));
        for ((action, FeedbackSteer { limits: [lower, upper], .. }), (command, correction)) in each {
            *action = (*command - *correction).clipped(*lower, *upper);
        }
    }

    /// Returns a row of gains times the deviations.
    fn correction(&self, gains: &[S], read: &[S], commands: &[S]) -> S {
        let deviation = |(of, value): (&FeedbackRead<S>, &S)| {
            let still = *value - of.reference;
            of.follows.map_or(still, |command| still - commands[command])
        };
        let terms = self.reads.iter().zip(read).map(deviation).zip(gains);
        terms.fold(S::ZERO, |sum, (deviation, gain)| sum + *gain * deviation)
    }
}

impl<S: Scalar> FeedbackSteer<S> {
    /// Returns the growth of an integral: 0 if the action is beyond a limit and the growth would push it further.
    fn kept(&self, grown: S, action: S) -> S {
        let beyond = action - action.clipped(self.limits[0], self.limits[1]);
        (beyond * grown).select_below(0.0, || S::ZERO, || grown)
    }
}
