//! Errors in the data of a sea.

use core::fmt::Display;

use thiserror::Error;

/// A quantity outside its allowed range. The field has its name in the scenario.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{field}: found {found}, allowed: {allowed}")]
pub struct WaveError {
    /// The quantity, its unit in its name: `significant_height_m`.
    pub field: String,
    /// Value or text that was found.
    pub found: String,
    /// Range or form that is allowed.
    pub allowed: String,
}

impl WaveError {
    /// Returns an error of this quantity.
    pub fn new(field: impl Into<String>, found: impl Display, allowed: impl Into<String>) -> Self {
        Self { field: field.into(), found: found.to_string(), allowed: allowed.into() }
    }
}

/// Returns the number if it is between the two limits, which are both allowed.
///
/// # Errors
/// If it is outside the limits, or NaN.
pub(crate) fn between(field: &str, number: f64, [least, most]: [f64; 2]) -> Result<f64, WaveError> {
    if number >= least && number <= most {
        return Ok(number);
    }
    Err(WaveError::new(field, number, format!("a number from {least} to {most}")))
}

/// Smallest and largest height of a wave, m: from model tests to more than any sea.
pub(crate) const HEIGHTS_M: [f64; 2] = [1e-6, 100.0];
/// Smallest and largest period of a wave, s.
pub(crate) const PERIODS_S: [f64; 2] = [1e-2, 1e3];
