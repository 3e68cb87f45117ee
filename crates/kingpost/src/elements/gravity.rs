//! Weight: `-m g` along the world's z on every body (eq. 59).

use crate::dynamics::{LinkKinematics, Loads};
use crate::model::Model;
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// A uniform field.
#[derive(Clone, Copy, Debug)]
pub struct Gravity<S = f64> {
    /// Acceleration, m/s^2, downwards.
    pub acceleration: S,
}

impl<S: Scalar> Gravity<S> {
    /// Puts every body's mass into the field.
    pub fn apply(&self, loads: &mut Loads<S>) {
        loads.add_gravity(Vector3::new(S::ZERO, S::ZERO, -self.acceleration));
    }

    /// `sum m g z`, J, with z measured from the world's origin.
    pub fn potential_energy(&self, model: &Model<S>, links: &LinkKinematics<S>) -> S {
        let height = |body: usize| links.body_frame(model, body).position[2];
        model.bodies.iter().enumerate().fold(S::ZERO, |sum, (i, body)| sum + body.mass * self.acceleration * height(i))
    }
}
