//! A motor: torque (or force) on a joint's coordinate, its reaction on the parent (eq. 59).

use super::TimeFunction;
use crate::dynamics::Loads;
use crate::elements::{Context, Declaration, Element, Input, Support};
use crate::scalar::Scalar;

/// A torque or force history on one coordinate.
#[derive(Clone, Debug)]
pub struct Motor<S = f64> {
    /// Index in v.
    pub coordinate: usize,
    /// Full effort, N m or N.
    pub effort: S,
    /// Its share of the full effort over time.
    pub profile: TimeFunction<S>,
    /// Name of the input that scales it, if a lever drives it.
    pub lever: Option<String>,
}

impl<S: Scalar> Element<S> for Motor<S> {
    fn declare(&self) -> Declaration {
        let inputs = self.lever.iter().map(|name| Input::lever(name, -1.0, 0.0)).collect();
        Declaration { inputs, ..Declaration::default() }
    }

    /// Adds the torque or force and its work.
    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        let lever = at.inputs.first().copied().unwrap_or(S::ONE);
        let effort = self.effort * self.profile.value(at.clock) * lever;
        loads.force[self.coordinate] += effort;
        loads.power.drives += effort * at.v[self.coordinate];
    }

    fn next_edge_s(&self, after_s: f64, _modes: &[i64]) -> f64 {
        self.profile.next_edge_s(after_s)
    }

    fn supports(&self) -> Vec<Support> {
        vec![Support::Coordinate(self.coordinate)]
    }
}
