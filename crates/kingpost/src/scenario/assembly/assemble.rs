//! Contract of a kind in the scenario file: how elements are assembled from its fields.

use crate::elements::{AnyElement, DrawnTank, Input};
use crate::model::Model;
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::columns::Column;
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{Positive, Scenario};
use crate::world::World;

/// Largest deviation of a sampling period from a whole number of steps, in steps.
const WHOLE: f64 = 1e-6;

/// Parts of the setup that are available when a kind is assembled.
#[derive(Clone, Copy)]
pub(crate) struct Surroundings<'a, S> {
    pub(crate) scenario: &'a Scenario<S>,
    pub(crate) model: &'a Model<S>,
    pub(crate) world: &'a World<S>,
    /// q and v at the start of the run.
    pub(crate) start: (&'a [S], &'a [S]),
    /// Elements assembled before this one: for a sensor all elements that it can measure, for a controller
    /// all others.
    pub(crate) elements: &'a [AnyElement<S>],
    /// The columns that a controller may read.
    pub(crate) columns: &'a [Column],
    /// The inputs that a controller may set.
    pub(crate) inputs: &'a [Input],
}

/// A force, a sensor or a controller of the file.
pub(crate) trait Assemble<S: Quantity> {
    /// Assembles its elements: none if it, or the body on which it acts, is disabled.
    ///
    /// # Errors
    /// A field that contradicts another field of the scenario.
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError>;

    /// Returns the tank to draw, if it is one.
    fn tank(&self, _name: &str, _scenario: &Scenario<S>) -> Option<DrawnTank> {
        None
    }
}

impl<S: Quantity, T: Assemble<S>> Assemble<S> for Box<T> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        (**self).assemble(name, at)
    }

    fn tank(&self, name: &str, scenario: &Scenario<S>) -> Option<DrawnTank> {
        (**self).tank(name, scenario)
    }
}

impl<'a, S: Quantity> Surroundings<'a, S> {
    /// Returns the surroundings before any element is assembled.
    pub(crate) fn new(
        scenario: &'a Scenario<S>,
        model: &'a Model<S>,
        world: &'a World<S>,
        start: (&'a [S], &'a [S]),
    ) -> Self {
        Self { scenario, model, world, start, elements: &[], columns: &[], inputs: &[] }
    }

    /// Returns the time step of the run, s.
    pub(crate) fn step_s(self) -> f64 {
        self.scenario.simulation.step_s.get()
    }

    /// Returns the sampling period, which must be a whole number of steps.
    ///
    /// # Errors
    /// A period that is not a whole number of steps.
    pub(crate) fn period_s(self, field: &str, given: Option<Positive>) -> Result<f64, FieldError> {
        let step_s = self.step_s();
        let Some(period_s) = given.map(|period| period.get()) else { return Ok(step_s) };
        let steps = period_s / step_s;
        if steps < 1.0 - WHOLE || (steps - libm::round(steps)).abs() > WHOLE {
            return Err(FieldError::new(field, period_s, format!("a whole number of steps of {step_s} s")));
        }
        Ok(libm::round(steps) * step_s)
    }

    /// Returns the input with this name; `None` if it does not exist yet. A controller is assembled when all
    /// its targets exist.
    pub(crate) fn input(self, name: &str) -> Option<Input> {
        self.inputs.iter().find(|input| input.name == name).cloned()
    }
}
