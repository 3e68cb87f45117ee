//! Trailing edges of fins.

use crate::elements::hull::HullFrame;
use crate::elements::submerged::Waters;
use crate::elements::submerged::assembly::check_current;
use crate::elements::{AnyElement, TrailingEdge};
use crate::model::Model;
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::assembly::rigid_bodies::{from_centre, rigid};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Scenario};
use crate::spatial::Vector3;
use crate::world::World;

impl<S: Quantity> Assemble<S> for schema::TrailingEdge<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        Ok(build(at.scenario, name, self, at.model, at.world)?.into_iter().collect())
    }
}

/// Returns a trailing edge, if it is enabled and its body exists.
fn build<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::TrailingEdge<S>,
    model: &Model<S>,
    world: &World<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    rigid(scenario, format!("forces.{name}.trailing_edge.body"), &given.body)?;
    check_current(world)?;
    let Some(body) = model.body(&given.body).filter(|_| given.enabled) else { return Ok(None) };
    let origin = from_centre(scenario, &given.body, Vector3(given.position_m));
    Ok(Some(Box::new(TrailingEdge {
        name: name.to_owned(),
        place: HullFrame { body, origin },
        span: given.span_m.get(),
        waters: Waters::new(world),
    })))
}
