//! Forces of regular waves on an element, as inputs of the model.

use crate::dynamics::Loads;
use crate::elements::{Context, Declaration, Element, Input};
use crate::scalar::Scalar;
use crate::spatial::{Vector3, Wrench};

/// Number of wave forces of an element; unused ones are zero.
pub(super) const FORCES: usize = 6;

/// Forces on bodies as inputs, so that the rows of results can be differentiated with respect to them.
#[derive(Clone, Debug)]
pub(super) struct WaveForces {
    /// For each body on which forces act, the wrench of each unit force, in body axes about the centre of
    /// mass.
    on: Vec<(usize, [Wrench; FORCES])>,
}

impl WaveForces {
    /// Creates the forces from their wrenches on all bodies.
    pub(super) fn new(on: impl Iterator<Item = (usize, [Wrench; FORCES])>) -> Self {
        let acts = |(_, wrenches): &(usize, [Wrench; FORCES])| wrenches.iter().any(|wrench| *wrench != Wrench::zero());
        Self { on: on.filter(acts).collect() }
    }
}

impl<S: Scalar> Element<S> for WaveForces {
    fn declare(&self) -> Declaration {
        let input = |mode| Input {
            name: format!("force of waves {mode}"),
            unit: "N",
            lower: f64::NEG_INFINITY,
            upper: f64::INFINITY,
            value: 0.0,
            signal: None,
        };
        Declaration { inputs: (0..FORCES).map(input).collect(), ..Declaration::default() }
    }

    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        for (body, wrenches) in &self.on {
            let of = |(unit, force): (&Wrench, &S)| {
                let [moment, along] = [unit.moment, unit.force].map(|part| Vector3::constant(part.0));
                Wrench { moment, force: along } * *force
            };
            let sum = wrenches.iter().zip(at.inputs).map(of).fold(Wrench::zero(), |sum, wrench| sum + wrench);
            loads.wrenches.push((*body, sum));
        }
    }
}
