//! A learned policy: inputs set by a small neural network that reads columns of the results.

pub(crate) mod assembly;
pub(crate) mod fields;

use crate::elements::commanded::changed_commands;
use crate::elements::ticks::is_tick;
use crate::elements::{Context, Declaration, Element, ElementState, Input, LinearLaw, Occurrence};
use crate::scalar::Scalar;

/// Sets inputs by a multilayer perceptron, at multiples of its period:
///
/// ```text
/// o = (sum of columns - reference) / scale,            clipped to 10 on either side
/// a = tanh(W_n tanh(... tanh(W_1 o + b_1)) + b_n)
/// u = c + lower + (a + 1) (upper - lower) / 2,          within the input's limits
/// ```
///
/// c are its commands (Goodfellow, Bengio & Courville, *Deep Learning*, 2016, sec. 6.1, 6.3). Between two samples a is
/// held; changes of c act at every step.
#[derive(Clone, Debug)]
pub struct Policy<S = f64> {
    /// Name in the results.
    pub name: String,
    /// Columns that it reads.
    pub reads: Vec<PolicyRead<S>>,
    /// Inputs that it sets.
    pub steers: Vec<PolicySteer<S>>,
    /// Layers from the first to the last. The first fits the columns, each other fits the layer before, and the last
    /// fits the inputs.
    pub layers: Vec<PolicyLayer<S>>,
    /// Sampling period, s: a whole number of steps.
    pub period_s: f64,
    /// Whether it acts; if not, its commands pass unchanged.
    pub acts: bool,
}

/// An observation of a policy.
#[derive(Clone, Debug)]
pub struct PolicyRead<S = f64> {
    /// The columns that are added.
    pub columns: Vec<String>,
    /// Sum of the columns at which the observation is 0.
    pub reference: S,
    /// Difference from the reference at which the observation is 1.
    pub scale: S,
}

/// An input that a policy sets.
#[derive(Clone, Debug)]
pub struct PolicySteer<S = f64> {
    /// The input.
    pub to: Input,
    /// The name of its command.
    pub command: String,
    /// Its values at -1 and 1.
    pub bounds: [S; 2],
}

/// A layer: tanh(W x + b).
#[derive(Clone, Debug)]
pub struct PolicyLayer<S = f64> {
    /// W, a row for each output.
    pub weights: Vec<Vec<S>>,
    /// b.
    pub biases: Vec<S>,
}

/// Limit, on either side, to which observations are clipped.
const LARGEST_SEEN: f64 = 10.0;

impl<S: Scalar> Element<S> for Policy<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let reads = self.reads.iter().flat_map(|read| read.columns.iter().cloned()).collect();
        changed_commands("addition", self.steers.iter().map(|steer| (&steer.to, &*steer.command)), reads)
    }

    fn update_controls(
        &mut self,
        at: &Context<'_, S>,
        read: &[S],
        own: &mut ElementState<'_, S>,
        inputs: &mut [S],
    ) -> Result<Vec<Occurrence>, String> {
        if self.acts && is_tick(at.clock.time_s, self.period_s) {
            let acted = self.acted(self.seen(read));
            for ((steer, acted), addition) in self.steers.iter().zip(acted).zip(&mut *own.numbers) {
                let [lower, upper] = steer.bounds;
                *addition = lower + (acted + S::ONE) * (S::constant(0.5) * (upper - lower));
            }
        }
        self.act(at.inputs, own.numbers, inputs);
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

    /// Returns the Jacobian at zero observations: at rest at the target.
    fn linear_law(&self) -> Option<LinearLaw> {
        self.acts.then(|| LinearLaw { gains: self.jacobian(), integral_gains: Vec::new(), period_s: self.period_s })
    }

    fn passes_to(&self, command: usize) -> Option<usize> {
        Some(command)
    }
}

impl<S: Scalar> Policy<S> {
    /// Writes the actions: the commands plus the additions, within the limits of the inputs.
    fn act(&self, commands: &[S], additions: &[S], actions: &mut [S]) {
        let each = actions.iter_mut().zip(&self.steers).zip(commands.iter().zip(additions));
        for ((action, PolicySteer { to, .. }), (command, addition)) in each {
            *action = (*command + *addition).clipped(S::constant(to.lower), S::constant(to.upper));
        }
    }

    /// Returns o.
    fn seen(&self, read: &[S]) -> Vec<S> {
        let mut values = read.iter();
        let largest = S::constant(LARGEST_SEEN);
        let each = self.reads.iter().map(|read| {
            let sum = values.by_ref().take(read.columns.len()).fold(S::ZERO, |sum, value| sum + *value);
            ((sum - read.reference) / read.scale).clipped(-largest, largest)
        });
        each.collect()
    }

    /// Returns a.
    fn acted(&self, seen: Vec<S>) -> Vec<S> {
        self.layers.iter().fold(seen, |signal, layer| layer.output(&signal))
    }

    /// Returns the derivatives of its additions to the commands with respect to the columns that it reads.
    fn jacobian(&self) -> Vec<Vec<f64>> {
        let sizes = self.reads.iter().map(|read| (read.columns.len(), 1.0 / read.scale.value()));
        let per_column = sizes.flat_map(|(columns, by)| (0..columns).map(move |_| by)).collect::<Vec<f64>>();
        let of = self.reads.iter().enumerate().flat_map(|(k, read)| read.columns.iter().map(move |_| k));
        let mut signal = vec![S::ZERO; self.reads.len()];
        let mut slopes: Vec<Vec<f64>> =
            (0..self.reads.len()).map(|i| of.clone().map(|k| if i == k { 1.0 } else { 0.0 }).collect()).collect();
        for layer in &self.layers {
            signal = layer.output(&signal);
            let row = |(weights, output): (&Vec<S>, &S)| {
                let flat = 1.0 - output.value() * output.value();
                let by = |c: usize| weights.iter().zip(&slopes).fold(0.0, |sum, (w, s)| sum + w.value() * s[c]);
                (0..per_column.len()).map(|c| flat * by(c)).collect()
            };
            slopes = layer.weights.iter().zip(&signal).map(row).collect();
        }
        for (row, steer) in slopes.iter_mut().zip(&self.steers) {
            let half = 0.5 * (steer.bounds[1] - steer.bounds[0]).value();
            row.iter_mut().zip(&per_column).for_each(|(slope, by)| *slope *= half * by);
        }
        slopes
    }
}

impl<S: Scalar> PolicyLayer<S> {
    fn output(&self, signal: &[S]) -> Vec<S> {
        let sum = |weights: &Vec<S>| weights.iter().zip(signal).fold(S::ZERO, |sum, (w, x)| sum + *w * *x);
        self.weights.iter().zip(&self.biases).map(|(weights, bias)| tanh(sum(weights) + *bias)).collect()
    }
}

/// Returns tanh as `-m / (m + 2)` with `m = exp(-2 |x|) - 1` and the sign of x: exact to a few units of rounding.
fn tanh<S: Scalar>(x: S) -> S {
    let of_size = |size: S| {
        let m = (S::constant(-2.0) * size).exp_m1();
        -m / (m + S::constant(2.0))
    };
    x.select_below(0.0, || -of_size(-x), || of_size(x))
}
