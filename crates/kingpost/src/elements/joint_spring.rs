//! A linear spring along one axis of a joint.

use super::{Context, Element, Support};
use crate::dynamics::Loads;
use crate::scalar::Scalar;

/// `tau = -k (q - rest)` along one coordinate, with the energy `k (q - rest)^2 / 2`.
#[derive(Clone, Copy, Debug)]
pub struct JointSpring<S = f64> {
    /// Index in q.
    pub position: usize,
    /// Index in v.
    pub coordinate: usize,
    /// k, N m/rad or N/m.
    pub stiffness: S,
    /// Coordinate at which it has no force, rad or m.
    pub rest: S,
}

impl<S: Scalar> Element<S> for JointSpring<S> {
    /// Adds the spring's force.
    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        loads.force[self.coordinate] -= self.stiffness * (at.q[self.position] - self.rest);
    }

    /// Returns the stored energy, J.
    fn potential_energy(&mut self, at: &Context<'_, S>) -> S {
        let stretch = at.q[self.position] - self.rest;
        self.stiffness * stretch * stretch * S::constant(0.5)
    }

    fn supports(&self) -> Vec<Support> {
        vec![Support::Spring(self.coordinate)]
    }
}
