//! A load cell: a sensor of a rope's tension.

use super::Sampler;
use crate::elements::{Context, Declaration, Element, Output, Own};
use crate::scalar::Scalar;

/// Measures a rope's tension, N. A tension depends on the forces of all elements, so it is read as a column at the
/// start of the first step after each sampling time: a row of results that falls on a sampling time still holds the
/// sample before.
#[derive(Clone, Debug)]
pub struct LoadCell<S = f64> {
    /// Name in the results.
    pub name: String,
    /// The column of the tension.
    pub column: String,
    /// Its sampling.
    pub sampler: Sampler<S>,
}

const KEPT: [&str; 1] = ["tension"];
/// Share of the period by which a sampling time may be late: rounding.
const SLACK: f64 = 1e-9;

impl<S: Scalar> Element<S> for LoadCell<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let tension = Output::number("measured_tension", "measured tension of a rope", "sensor", &self.name, &["N"]);
        let mut modes = self.sampler.mode_names(&KEPT);
        modes.push("next_sample".to_owned());
        Declaration {
            numbers: self.sampler.number_names(&KEPT),
            modes,
            outputs: core::iter::once(tension).chain(self.sampler.status(&self.name)).collect(),
            events: self.sampler.events(),
            goes_alone: self.sampler.drop_outs.is_some(),
            period_s: Some(self.sampler.period_s),
            reads: vec![self.column.clone()],
            ..Declaration::default()
        }
    }

    fn steer(
        &mut self,
        at: &Context<'_, S>,
        read: &[S],
        own: &mut Own<'_, S>,
        _inputs: &mut [S],
    ) -> Result<Vec<String>, String> {
        let Some(&tension) = read.first() else { return Ok(Vec::new()) };
        let next = own.modes.len() - 1;
        let due = libm::floor(at.clock.time_s / self.sampler.period_s + SLACK) as i64 + 1;
        if own.modes[next] == 0 {
            self.sampler.begin(own, &[tension]);
        }
        if own.modes[next] < due {
            own.modes[next] = due;
            self.sampler.take((due - 1) as f64 * self.sampler.period_s, own, &[tension]);
        }
        Ok(Vec::new())
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        self.sampler.outputs(at.numbers, at.modes, out);
    }
}
