//! Weight: `-m g` along the world's z on every body (eq. 59).

pub mod assembly;
pub mod fields;

use super::{Context, Element};
use crate::dynamics::Loads;
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// The weight of every body in the world's gravity.
#[derive(Clone, Copy, Debug)]
pub struct Gravity;

impl<S: Scalar> Element<S> for Gravity {
    /// Adds the weight of every body.
    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        loads.add_gravity(Vector3::new(S::ZERO, S::ZERO, -at.world.gravity));
    }

    /// Returns `sum m g z`, J, with z measured from the world's origin.
    fn potential_energy(&mut self, at: &Context<'_, S>) -> S {
        let Context { world, model, links, .. } = *at;
        let height = |body: usize| links.body_frame(model, body).position[2];
        model.bodies.iter().enumerate().fold(S::ZERO, |sum, (i, body)| sum + body.mass * world.gravity * height(i))
    }
}
