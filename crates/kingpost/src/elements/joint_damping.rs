//! Viscous friction in a joint with one degree of freedom.

use super::{Context, Element};
use crate::dynamics::Loads;
use crate::scalar::Scalar;

/// `tau = -c v` along one coordinate.
#[derive(Clone, Copy, Debug)]
pub struct JointDamping<S = f64> {
    /// Index in v.
    pub coordinate: usize,
    /// c, N m s or N s/m.
    pub damping: S,
}

impl<S: Scalar> Element<S> for JointDamping<S> {
    /// Adds the friction and its heat.
    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        let rate = at.v[self.coordinate];
        let friction = self.damping * rate;
        loads.force[self.coordinate] -= friction;
        loads.power.dissipated += friction * rate;
    }
}
