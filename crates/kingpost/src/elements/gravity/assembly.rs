//! Assembly of gravity.

use crate::elements::{AnyElement, Gravity};
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Force};

/// Assembles one gravity element: the world holds the sum of all gravity forces.
impl<S: Quantity> Assemble<S> for schema::Gravity<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        let acts = |force: &Force<S>| gravity_of(force).is_some_and(|gravity| gravity.enabled);
        let first = at.scenario.forces.iter().find(|(_, force)| acts(force));
        let is_first = first.is_some_and(|(first, _)| *first == *name);
        Ok(if is_first { vec![Box::new(Gravity)] } else { Vec::new() })
    }
}

/// Returns the fields of a gravity force; `None` for another force.
pub fn gravity_of<S>(force: &Force<S>) -> Option<&schema::Gravity<S>> {
    if let Force::Gravity(gravity) = force { Some(gravity) } else { None }
}
