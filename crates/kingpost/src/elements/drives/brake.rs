//! A brake: dry friction of a capacity that a lever sets.

use crate::dynamics::Loads;
use crate::elements::CoulombFriction;
use crate::scalar::Scalar;

/// `tau = -u T v / sqrt(v^2 + v_s^2)` with the capacity T and the application u, from 0 (released)
/// to 1 (set). Like all friction it makes heat, and does no work on anything.
#[derive(Clone, Debug)]
pub struct Brake<S = f64> {
    /// Its friction when set.
    pub friction: CoulombFriction<S>,
    /// The input that sets it, where a lever does; a brake without one is set.
    pub input: Option<usize>,
}

impl<S: Scalar> Brake<S> {
    /// Adds the friction and the heat that it makes.
    pub fn apply(&self, v: &[S], inputs: &[S], loads: &mut Loads<S>) {
        let applied = self.input.map_or(S::ONE, |input| inputs[input]);
        let friction = self.friction.friction * applied;
        CoulombFriction { friction, ..self.friction }.apply(v, loads);
    }
}
