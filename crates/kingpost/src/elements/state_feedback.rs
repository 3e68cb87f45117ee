//! State feedback: inputs set by columns of the results, times gains.

use super::commanded::changed_commands;
use super::ticks::is_tick;
use super::{Context, Declaration, Element, Input, LinearLaw, Own};
use crate::scalar::Scalar;

/// Sets inputs from the columns x that it reads and its commands c, at multiples of its period:
///
/// ```text
/// u = c - K (x - x_ref - w),    within its limits
/// ```
///
/// w is the command of the input that a column follows, and 0 for the others: the angle of a crane, for example, follows the
/// command of its slewing gear. Between two samples `K (x - x_ref - w)` is held; the commands pass at every step.
#[derive(Clone, Debug)]
pub struct StateFeedback<S = f64> {
    /// Name in the results.
    pub name: String,
    /// What it reads.
    pub reads: Vec<FeedbackRead<S>>,
    /// What it sets.
    pub steers: Vec<FeedbackSteer<S>>,
    /// Sampling period, s: a whole number of steps.
    pub period_s: f64,
    /// Whether it acts; if not, it passes its commands.
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
    /// Its limits.
    pub limits: [S; 2],
}

impl<S: Scalar> Element<S> for StateFeedback<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let reads = self.reads.iter().map(|read| read.column.clone()).collect();
        changed_commands("correction", self.steers.iter().map(|steer| (&steer.to, &*steer.command)), reads)
    }

    fn begin(&mut self, at: &Context<'_, S>, own: &mut Own<'_, S>) {
        own.numbers[self.steers.len()..].copy_from_slice(at.inputs);
    }

    fn steer(
        &mut self,
        at: &Context<'_, S>,
        read: &[S],
        own: &mut Own<'_, S>,
        inputs: &mut [S],
    ) -> Result<Vec<String>, String> {
        let (corrections, actions) = own.numbers.split_at_mut(self.steers.len());
        if self.acts && is_tick(at.clock.time_s, self.period_s) {
            for (steer, correction) in self.steers.iter().zip(&mut *corrections) {
                *correction = self.correction(&steer.gains, read, at.inputs);
            }
        }
        for (k, FeedbackSteer { limits: [lower, upper], .. }) in self.steers.iter().enumerate() {
            actions[k] = (at.inputs[k] - corrections[k]).clipped(*lower, *upper);
            inputs[k] = actions[k];
        }
        Ok(Vec::new())
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        out.extend_from_slice(&at.numbers[self.steers.len()..]);
    }

    fn linear_law(&self) -> Option<LinearLaw> {
        let row = |steer: &FeedbackSteer<S>| steer.gains.iter().map(|gain| -gain.value()).collect();
        self.acts.then(|| LinearLaw { gains: self.steers.iter().map(row).collect(), period_s: self.period_s })
    }

    fn passes_to(&self, command: usize) -> Option<usize> {
        Some(command)
    }
}

impl<S: Scalar> StateFeedback<S> {
    /// A row of K times the deviations.
    fn correction(&self, gains: &[S], read: &[S], commands: &[S]) -> S {
        let deviation = |(of, value): (&FeedbackRead<S>, &S)| {
            let still = *value - of.reference;
            of.follows.map_or(still, |command| still - commands[command])
        };
        let terms = self.reads.iter().zip(read).map(deviation).zip(gains);
        terms.fold(S::ZERO, |sum, (deviation, gain)| sum + *gain * deviation)
    }
}
