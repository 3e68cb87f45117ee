//! Checks that numbers are finite.

use crate::scenario::assembly::FieldError;
use crate::scenario::leaf::Quantity;

/// Checks that all entries of a list are finite.
pub(crate) fn all_finite<S: Quantity>(field: &str, values: &[S]) -> Result<(), FieldError> {
    values.iter().enumerate().try_for_each(|(k, value)| finite(&format!("{field}.{k}"), *value))
}

/// Checks that a number is finite.
pub(crate) fn finite<S: Quantity>(field: &str, value: S) -> Result<(), FieldError> {
    value.outside(f64::is_finite).map_or(Ok(()), |found| Err(FieldError::new(field, found, "a finite number")))
}
