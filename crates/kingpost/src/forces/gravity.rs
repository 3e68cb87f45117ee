//! Weight: `-m g` along the world's z on every body (eq. 59).

use crate::dynamics::{Kinematics, Loads};
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
    /// Adds each body's weight at its centre of mass.
    pub fn apply(&self, model: &Model<S>, links: &Kinematics<S>, loads: &mut Loads<S>) {
        for (body, load) in model.bodies.iter().zip(&mut loads.wrench) {
            if let Some(link) = body.link {
                let weight = Vector3::new(S::ZERO, S::ZERO, -(body.mass * self.acceleration));
                let in_link = links.world[link].rotation.transpose_times(weight);
                load.force += body.in_link.rotation.transpose_times(in_link);
            }
        }
    }

    /// `sum m g z`, J, with z measured from the world's origin.
    pub fn potential_energy(&self, model: &Model<S>, links: &Kinematics<S>) -> S {
        let height = |body: usize| links.body_frame(model, body).position[2];
        model.bodies.iter().enumerate().fold(S::ZERO, |sum, (i, body)| sum + body.mass * self.acceleration * height(i))
    }
}
