//! An encoder: a sensor of a joint's angle or extension.

use super::Sampler;
use crate::elements::{Context, Declaration, Element, ElementState, Output};
use crate::model::AxisMotion;
use crate::scalar::Scalar;

/// Measures the coordinate of a joint, rad or m.
#[derive(Clone, Debug)]
pub struct Encoder<S = f64> {
    /// Name in the results.
    pub name: String,
    /// Index in q.
    pub position: usize,
    /// Whether the joint turns or slides.
    pub motion: AxisMotion,
    /// Its sampling.
    pub sampler: Sampler<S>,
}

impl<S: Scalar> Element<S> for Encoder<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let number = |variable, description, unit| Output::number(variable, description, "sensor", &self.name, unit);
        let (kept, output) = match self.motion {
            AxisMotion::Rotation => ("angle", number("measured_angle", "measured angle of a joint", &["rad"])),
            AxisMotion::Translation => {
                ("extension", number("measured_extension", "measured extension of a joint", &["m"]))
            }
        };
        self.sampler.declaration(&self.name, &[kept], vec![output])
    }

    fn begin(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        self.sampler.begin(own, &[at.q[self.position]]);
    }

    fn sample(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        self.sampler.take(at.clock.time_s, own, &[at.q[self.position]]);
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        self.sampler.outputs(at, out, || [at.q[self.position]]);
    }
}
