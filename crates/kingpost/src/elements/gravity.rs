//! Weight: `-m g` along the world's z on every body (eq. 59).

use super::{Element, Moment};
use crate::dynamics::Loads;
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// A uniform field.
#[derive(Clone, Copy, Debug)]
pub struct Gravity<S = f64> {
    /// Acceleration, m/s^2, downwards.
    pub acceleration: S,
}

impl<S: Scalar> Element<S> for Gravity<S> {
    /// Puts every body's mass into the field.
    fn loads(&mut self, _: &Moment<'_, S>, loads: &mut Loads<S>) {
        loads.add_gravity(Vector3::new(S::ZERO, S::ZERO, -self.acceleration));
    }

    /// `sum m g z`, J, with z measured from the world's origin.
    fn potential_energy(&mut self, at: &Moment<'_, S>) -> S {
        let Moment { model, links, .. } = *at;
        let height = |body: usize| links.body_frame(model, body).position[2];
        model.bodies.iter().enumerate().fold(S::ZERO, |sum, (i, body)| sum + body.mass * self.acceleration * height(i))
    }
}
