//! A prescribed motion: the joint's rate is given, the force follows.

use super::Profile;
use crate::dynamics::{Clock, Loads};
use crate::scalar::Scalar;

/// The rate of one coordinate over time. The profile must be continuous: a jump would take an
/// infinite force.
#[derive(Clone, Debug)]
pub struct PrescribedMotion<S = f64> {
    /// Index in v.
    pub coordinate: usize,
    /// Rate at full, rad/s or m/s.
    pub rate: S,
    /// Its share of the full rate over time.
    pub profile: Profile<S>,
}

impl<S: Scalar> PrescribedMotion<S> {
    /// Hands over the acceleration; its work is counted once the joint force is known.
    pub fn apply(&self, clock: Clock, loads: &mut Loads<S>) {
        loads.acceleration[self.coordinate] = self.acceleration_at(clock);
    }

    /// The rate, rad/s or m/s.
    pub fn rate_at(&self, clock: Clock) -> S {
        self.rate * self.profile.value(clock)
    }

    /// The acceleration, rad/s^2 or m/s^2.
    pub fn acceleration_at(&self, clock: Clock) -> S {
        self.rate * self.profile.slope_per_s(clock)
    }
}
