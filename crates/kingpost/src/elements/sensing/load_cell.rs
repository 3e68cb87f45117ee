//! A load cell: a sensor of a rope's tension.

use super::Sampler;
use crate::elements::ticks::{Due, due};
use crate::elements::{Context, Declaration, Element, ElementState, Occurrence, Output};
use crate::scalar::Scalar;

/// Measures a rope's tension, N. A tension depends on the forces of all elements, so it is read as a column at the
/// start of the first step after each sampling time: a row of results at a sampling time still holds the previous
/// sample.
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

impl<S: Scalar> Element<S> for LoadCell<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let tension = Output::number("measured_tension", "measured tension of a rope", "sensor", &self.name, &["N"]);
        let mut declaration = self.sampler.declaration(&self.name, &KEPT, vec![tension]);
        declaration.modes.push("next_sample".to_owned());
        Declaration { reads: vec![self.column.clone()], ..declaration }
    }

    fn update_controls(
        &mut self,
        at: &Context<'_, S>,
        read: &[S],
        own: &mut ElementState<'_, S>,
        _inputs: &mut [S],
    ) -> Result<Vec<Occurrence>, String> {
        let Some(&tension) = read.first() else { return Ok(Vec::new()) };
        let next = own.modes.len() - 1;
        let period_s = self.sampler.period_s;
        let Some(Due { sample, is_first }) = due(at.clock.time_s, period_s, &mut own.modes[next]) else {
            return Ok(Vec::new());
        };
        if is_first {
            self.sampler.begin(own, &[tension]);
        }
        self.sampler.take(sample as f64 * period_s, own, &[tension]);
        Ok(Vec::new())
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        // The sensor knows the tension only at its samples.
        self.sampler.outputs(at, out, || [at.numbers[0]]);
    }
}
