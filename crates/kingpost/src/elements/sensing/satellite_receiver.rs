//! A satellite positioning receiver: a sensor of the position of its antenna.

use super::Sampler;
use crate::elements::lines::place;
use crate::elements::{Components, Context, Declaration, Element, ElementState, Output, VectorFrame};
use crate::model::Attachment;
use crate::scalar::Scalar;

/// Measures the position of its antenna in the world, m.
#[derive(Clone, Debug)]
pub struct SatelliteReceiver<S = f64> {
    /// Name in the results.
    pub name: String,
    /// The antenna.
    pub antenna: Attachment<S>,
    /// Its sampling.
    pub sampler: Sampler<S>,
}

const KEPT: [&str; 3] = ["x", "y", "z"];

impl<S: Scalar> Element<S> for SatelliteReceiver<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let what = "measured position of an antenna";
        let position = Output {
            components: Components::Axis,
            frame: VectorFrame::World,
            ..Output::number("measured_position", what, "sensor", &self.name, &["m"])
        };
        self.sampler.declaration(&self.name, &KEPT, vec![position])
    }

    fn begin(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        self.sampler.begin(own, &place(&self.antenna, at.model, at.links).0);
    }

    fn sample(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        self.sampler.take(at.clock.time_s, own, &place(&self.antenna, at.model, at.links).0);
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        self.sampler.outputs(at, out, || place(&self.antenna, at.model, at.links).0);
    }
}
