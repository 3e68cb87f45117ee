//! Parts of a scenario that controllers may name, and checks of their numbers.

use crate::model::Model;
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::columns::Column;
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Scenario};

/// A sampling period may differ from a whole number of steps by this share of a step.
const WHOLE: f64 = 1e-6;

/// Parts of a scenario that controllers may name.
pub(crate) struct ControllerReader<'a, S> {
    pub(crate) scenario: &'a Scenario<S>,
    pub(crate) model: &'a Model<S>,
    pub(crate) known: Vec<Column>,
}

impl<S: Quantity> ControllerReader<'_, S> {
    /// The step of the run, s.
    pub(crate) fn step_s(&self) -> f64 {
        self.scenario.simulation.step_s.get()
    }

    /// The sampling period: a whole number of steps.
    pub(crate) fn period_s(&self, field: &str, given: Option<schema::Positive>) -> Result<f64, FieldError> {
        let step_s = self.step_s();
        let Some(period_s) = given.map(|period| period.get()) else { return Ok(step_s) };
        let steps = period_s / step_s;
        if steps < 1.0 - WHOLE || (steps - libm::round(steps)).abs() > WHOLE {
            return Err(FieldError::new(field, period_s, format!("a whole number of steps of {step_s} s")));
        }
        Ok(libm::round(steps) * step_s)
    }
}

/// Checks that all entries of a list are finite.
pub(crate) fn all_finite<S: Quantity>(field: &str, values: &[S]) -> Result<(), FieldError> {
    values.iter().enumerate().try_for_each(|(k, value)| finite(&format!("{field}.{k}"), *value))
}

/// Checks that a number is finite.
pub(crate) fn finite<S: Quantity>(field: &str, value: S) -> Result<(), FieldError> {
    value.outside(f64::is_finite).map_or(Ok(()), |found| Err(FieldError::new(field, found, "a finite number")))
}
