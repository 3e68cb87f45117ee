//! A scenario over dual numbers, with derivatives with respect to some of its numbers.

use core::fmt::Display;

use super::super::error::FieldError;
use super::super::leaf::Leaf;
use super::super::over::Numbers;
use super::super::schema::Scenario;
use super::super::tree::segments;
use super::super::{units, wording};
use crate::plant::{DIRECTIONS, Number};

/// A number with derivatives.
struct NumberTangent<'a> {
    /// Path of the number in the resolved scenario.
    path: String,
    /// First name that refers to the number.
    name: &'a str,
    derivative: [f64; DIRECTIONS],
    /// Whether the number at its path can have derivatives.
    found: bool,
}

/// Gives the numbers at some paths their derivatives; all other numbers are constants.
pub(super) struct NumberTangents<'a> {
    tangents: Vec<NumberTangent<'a>>,
    /// The present path, and the start of each of its segments.
    path: String,
    begins: Vec<usize>,
}

impl<'a> NumberTangents<'a> {
    /// Returns the derivatives along the directions of `names`: parameters, or paths of numbers. The
    /// derivative of a number in SI is the factor of its unit.
    pub(super) fn of(scenario: &Scenario, names: &[&'a str]) -> Self {
        let mut tangents: Vec<NumberTangent<'a>> = Vec::new();
        for (direction, name) in names.iter().enumerate() {
            for path in scenario.paths_of(name) {
                let (path, factor) = units::si_path(&segments(&path));
                let path = path.join(".");
                let known = tangents.iter().position(|tangent| tangent.path == path).unwrap_or_else(|| {
                    tangents.push(NumberTangent { path, name, derivative: [0.0; DIRECTIONS], found: false });
                    tangents.len() - 1
                });
                tangents[known].derivative[direction] += factor;
            }
        }
        Self { tangents, path: String::new(), begins: Vec::new() }
    }

    /// # Errors
    /// The first path at which there is no number, or one that can have no derivatives.
    pub(super) fn check(&self, scenario: &Scenario) -> Result<(), FieldError> {
        let Some(missed) = self.tangents.iter().find(|tangent| !tangent.found) else { return Ok(()) };
        let value = scenario.written().pointer(&format!("/{}", missed.path.replace('.', "/"))).cloned();
        let is_number = value.is_some_and(|value| value.is_number());
        let found = if is_number { wording::NO_DERIVATIVE } else { wording::NO_NUMBER };
        Err(FieldError::new(missed.name, found, wording::CONTINUOUS))
    }

    /// Returns the error of a field with derivatives as an error of the name that refers to it; returns any
    /// other error unchanged.
    pub(super) fn refused(&self, error: FieldError) -> FieldError {
        let stated = self.tangents.iter().find(|tangent| tangent.path == error.field);
        let within =
            || self.tangents.iter().find(|tangent| !error.field.is_empty() && tangent.path.starts_with(&error.field));
        match stated.or_else(within) {
            Some(tangent) => FieldError::new(tangent.name, wording::NO_DERIVATIVE, wording::CONTINUOUS),
            None => error,
        }
    }
}

impl Numbers<Number> for NumberTangents<'_> {
    fn number(&mut self, value: f64) -> Number {
        let mut number = Number::literal(value);
        if let Some(tangent) = self.tangents.iter_mut().find(|tangent| tangent.path == self.path) {
            tangent.found = true;
            number.derivative = tangent.derivative;
        }
        number
    }

    fn enter(&mut self, segment: &dyn Display) {
        self.begins.push(self.path.len());
        if !self.path.is_empty() {
            self.path.push('.');
        }
        self.path.push_str(&segment.to_string());
    }

    fn leave(&mut self) {
        self.path.truncate(self.begins.pop().unwrap_or_default());
    }
}
