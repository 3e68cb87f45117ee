//! A motor: torque (or force) on a joint's coordinate, its reaction on the parent (eq. 59).

use super::{Clock, Profile};
use crate::dynamics::Loads;

/// A torque or force history on one coordinate.
#[derive(Clone, Debug)]
pub struct Motor {
    /// Index in v.
    pub coordinate: usize,
    /// At full, N m or N.
    pub effort: f64,
    /// Over time, from -1 to 1.
    pub profile: Profile,
    /// The input that scales it, where a lever drives it.
    pub input: Option<usize>,
}

impl Motor {
    /// Adds the torque and the work that it does.
    pub fn apply(&self, clock: Clock, v: &[f64], inputs: &[f64], loads: &mut Loads) {
        let lever = self.input.map_or(1.0, |input| inputs[input]);
        let effort = self.effort * self.profile.value(clock) * lever;
        loads.force[self.coordinate] += effort;
        loads.power.drives += effort * v[self.coordinate];
    }
}
