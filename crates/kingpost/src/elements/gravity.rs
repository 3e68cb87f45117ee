//! Weight: `-m g` along the world's z on every body (eq. 59).

use super::{Element, Moment};
use crate::dynamics::Loads;
use crate::scalar::Scalar;
use crate::spatial::{Vector3, Wrench};

/// A uniform field.
#[derive(Clone, Copy, Debug)]
pub struct Gravity<S = f64> {
    /// Acceleration, m/s^2, downwards.
    pub acceleration: S,
}

impl<S: Scalar> Element<S> for Gravity<S> {
    /// Adds each body's weight at its centre of mass.
    fn loads(&mut self, at: &Moment<'_, S>, loads: &mut Loads<S>) {
        let Moment { model, links, .. } = *at;
        for (i, body) in model.bodies.iter().enumerate() {
            let weight = Vector3::new(S::ZERO, S::ZERO, -(body.mass * self.acceleration));
            let force = links.to_body_axes(model, i, weight);
            loads.wrenches.push((i, Wrench { moment: Vector3::zero(), force }));
        }
    }

    /// `sum m g z`, J, with z measured from the world's origin.
    fn potential_energy(&mut self, at: &Moment<'_, S>) -> S {
        let Moment { model, links, .. } = *at;
        let height = |body: usize| links.body_frame(model, body).position[2];
        model.bodies.iter().enumerate().fold(S::ZERO, |sum, (i, body)| sum + body.mass * self.acceleration * height(i))
    }
}
