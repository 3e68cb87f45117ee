//! A brake: dry friction whose share of its capacity a lever sets.

use crate::dynamics::Loads;
use crate::elements::{Context, CoulombFriction, Declaration, Element, Input, Support};
use crate::scalar::Scalar;

/// `tau = -u T v / sqrt(v^2 + v_s^2)` with the capacity T and the application u, from 0 (released) to 1 (set). All of
/// its power becomes heat.
#[derive(Clone, Debug)]
pub struct Brake<S = f64> {
    /// Friction of the fully set brake.
    pub friction: CoulombFriction<S>,
    /// Name of the input that sets it; without one the brake is set.
    pub lever: Option<String>,
}

impl<S: Scalar> Element<S> for Brake<S> {
    fn declare(&self) -> Declaration {
        let inputs = self.lever.iter().map(|name| Input::lever(name, 0.0, 1.0)).collect();
        Declaration { inputs, ..Declaration::default() }
    }

    /// Adds the friction and its heat.
    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        let applied = at.inputs.first().copied().unwrap_or(S::ONE);
        let friction = self.friction.friction * applied;
        CoulombFriction { friction, ..self.friction }.apply(at.v, loads);
    }

    fn supports(&self) -> Vec<Support> {
        vec![Support::Coordinate(self.friction.coordinate)]
    }
}
