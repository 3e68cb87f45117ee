//! A motor: torque (or force) on a joint's coordinate, its reaction on the parent (eq. 59).

use super::Profile;
use crate::dynamics::{Clock, Loads};
use crate::scalar::Scalar;

/// A torque or force history on one coordinate.
#[derive(Clone, Debug)]
pub struct Motor<S = f64> {
    /// Index in v.
    pub coordinate: usize,
    /// At full, N m or N.
    pub effort: S,
    /// Its share of the full effort over time.
    pub profile: Profile<S>,
    /// The input that scales it, where a lever drives it.
    pub input: Option<usize>,
}

impl<S: Scalar> Motor<S> {
    /// Adds the torque and the work that it does.
    pub fn apply(&self, clock: Clock, v: &[S], inputs: &[S], loads: &mut Loads<S>) {
        let lever = self.input.map_or(S::ONE, |input| inputs[input]);
        let effort = self.effort * self.profile.value(clock) * lever;
        loads.force[self.coordinate] += effort;
        loads.power.drives += effort * v[self.coordinate];
    }
}
