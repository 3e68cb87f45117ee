//! The contract of a force of the file: the elements that are assembled from its fields.

use crate::elements::AnyElement;
use crate::model::Model;
use crate::scenario::assembly::FieldError;
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::Scenario;
use crate::world::World;

/// Parts of a setup that a force is assembled with.
#[derive(Clone, Copy)]
pub(crate) struct Surroundings<'a, S> {
    pub(crate) scenario: &'a Scenario<S>,
    pub(crate) model: &'a Model<S>,
    pub(crate) world: &'a World<S>,
    /// q and v at the start.
    pub(crate) start: (&'a [S], &'a [S]),
}

/// A force of the file.
pub(crate) trait Assemble<S: Quantity> {
    /// Assembles its elements: none if it is disabled, or acts on a body that is.
    ///
    /// # Errors
    /// A field that does not fit the others of the scenario.
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError>;
}

impl<S: Quantity, T: Assemble<S>> Assemble<S> for Box<T> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        (**self).assemble(name, at)
    }
}
