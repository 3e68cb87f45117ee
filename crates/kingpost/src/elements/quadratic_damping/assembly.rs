//! Assembly of quadratic damping.

use crate::elements::hull::HullFrame;
use crate::elements::viscous_damping::assembly::against;
use crate::elements::{AnyElement, QuadraticDamping};
use crate::model::Model;
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::assembly::rigid_bodies::{from_centre, rigid};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Scenario};
use crate::spatial::Vector3;

impl<S: Quantity> Assemble<S> for schema::QuadraticDamping<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        Ok(quadratic(at.scenario, name, self, at.model)?.into_iter().collect())
    }
}

/// Returns the quadratic damping, if it is enabled and its body exists.
fn quadratic<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::QuadraticDamping<S>,
    model: &Model<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    rigid(scenario, format!("forces.{name}.quadratic_damping.body"), &given.body)?;
    let Some(body) = model.body(&given.body).filter(|_| given.enabled) else { return Ok(None) };
    let origin = from_centre(scenario, &given.body, Vector3(given.position_m));
    Ok(Some(Box::new(QuadraticDamping {
        place: HullFrame { body, origin },
        relative_to: against(given.relative_to),
        linear: Vector3(given.linear_n_s2_m2.map(|c| c.get())),
        angular: Vector3(given.angular_n_m_s2.map(|c| c.get())),
    })))
}
