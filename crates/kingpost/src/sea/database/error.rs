//! Errors of a database.

use thiserror::Error;

/// An error in a database.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("{field}: found {found}, allowed: {allowed}")]
pub struct DatabaseError {
    /// Dotted path of the field.
    pub field: String,
    /// Value or text that was found.
    pub found: String,
    /// Range or form that is allowed.
    pub allowed: String,
}

pub(super) type Checked = Result<(), DatabaseError>;

pub(super) fn unless(holds: bool, field: &str, found: impl ToString, allowed: &str) -> Checked {
    if holds {
        return Ok(());
    }
    Err(DatabaseError { field: field.to_owned(), found: found.to_string(), allowed: allowed.to_owned() })
}
