//! A prescribed motion: the joint's rate is given and the force follows from it.

use super::TimeFunction;
use crate::dynamics::Clock;
use crate::elements::{Declaration, Element, Support};
use crate::scalar::Scalar;
use crate::world::World;

/// The rate of one coordinate over time. The profile must be continuous: a jump would need an infinite force.
#[derive(Clone, Debug)]
pub struct PrescribedMotion<S = f64> {
    /// Index in v.
    pub coordinate: usize,
    /// Full rate, rad/s or m/s.
    pub rate: S,
    /// Its share of the full rate over time.
    pub profile: TimeFunction<S>,
}

impl<S: Scalar> Element<S> for PrescribedMotion<S> {
    fn declare(&self) -> Declaration {
        Declaration { prescribes: true, ..Declaration::default() }
    }

    fn prescribe(&self, _world: &World<S>, clock: Clock, rates: &mut [S], accelerations: &mut [S]) {
        rates[self.coordinate] = self.rate_at(clock);
        accelerations[self.coordinate] = self.acceleration_at(clock);
    }

    fn next_edge_s(&self, after_s: f64, _modes: &[i64]) -> f64 {
        self.profile.next_edge_s(after_s)
    }

    fn supports(&self) -> Vec<Support> {
        vec![Support::Coordinate(self.coordinate)]
    }
}

impl<S: Scalar> PrescribedMotion<S> {
    /// Returns the rate, rad/s or m/s.
    pub fn rate_at(&self, clock: Clock) -> S {
        self.rate * self.profile.value(clock)
    }

    /// Returns the acceleration, rad/s^2 or m/s^2.
    pub fn acceleration_at(&self, clock: Clock) -> S {
        self.rate * self.profile.slope_per_s(clock)
    }
}
