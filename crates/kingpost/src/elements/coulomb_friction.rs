//! Dry friction along one axis of a joint.

use super::{Context, Element};
use crate::dynamics::Loads;
use crate::scalar::Scalar;

/// Coulomb's law, smoothed about rest: `tau = -T v / sqrt(v^2 + v_s^2)`. Far above the smoothing speed v_s, the
/// magnitude of tau is T; far below, tau is viscous with the coefficient T / v_s, so a joint that should stick creeps.
/// An explicit scheme needs steps well below the moved inertia times v_s / T.
#[derive(Clone, Copy, Debug)]
pub struct CoulombFriction<S = f64> {
    /// Index in v.
    pub coordinate: usize,
    /// T, N m or N.
    pub friction: S,
    /// v_s, rad/s or m/s, greater than 0.
    pub smoothing: S,
}

impl<S: Scalar> Element<S> for CoulombFriction<S> {
    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        self.apply(at.v, loads);
    }
}

impl<S: Scalar> CoulombFriction<S> {
    /// Adds the friction and its heat.
    pub fn apply(&self, v: &[S], loads: &mut Loads<S>) {
        let rate = v[self.coordinate];
        let friction = regularised(self.friction, rate, self.smoothing);
        loads.force[self.coordinate] -= friction;
        loads.power.dissipated += friction * rate;
    }
}

/// `T v / sqrt(v^2 + v_s^2)`.
pub(crate) fn regularised<S: Scalar>(friction: S, rate: S, smoothing: S) -> S {
    friction * rate / (rate * rate + smoothing * smoothing).sqrt()
}
