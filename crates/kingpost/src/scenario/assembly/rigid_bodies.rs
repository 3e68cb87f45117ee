//! Rigid bodies on which elements act, and points on these bodies.

use crate::scenario::assembly::{FieldError, known};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::Scenario;
use crate::spatial::Vector3;

/// Converts a point from a body's drawing frame to a vector from the body's centre of mass.
pub(crate) fn from_centre<S: Quantity>(scenario: &Scenario<S>, body: &str, point: Vector3<S>) -> Vector3<S> {
    point - Vector3(scenario.bodies[body].centre_of_mass_m)
}

/// Returns an error unless a body exists and is rigid.
pub(crate) fn rigid<S: Quantity>(scenario: &Scenario<S>, field: String, body: &str) -> Result<(), FieldError> {
    known(&field, body, scenario.bodies.keys().map(|body| body.as_str()))?;
    if scenario.bodies.get(body).is_some_and(|body| body.flexible.is_some()) {
        return Err(FieldError::new(field, body, "a body that is not flexible"));
    }
    Ok(())
}
