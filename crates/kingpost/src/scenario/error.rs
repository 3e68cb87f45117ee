//! The error of a scenario: its place, the field, what was found and what is allowed.

use std::fmt;
use std::sync::Arc;

use thiserror::Error;

use super::{part_names, wording};

/// Largest number of characters of a name, and of the found value, in an error.
const LONGEST_NAME: usize = 200;
const LONGEST_FOUND: usize = 500;

/// An error in a field whose place in the file is not known.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{}: {}", wording::on_one_line(field), wording::found_and_allowed(found, allowed))]
pub struct FieldError {
    /// Dotted path of the field: `bodies.ship.mass_kg`.
    pub field: String,
    /// Value or text that was found there.
    pub found: String,
    /// Range or form that is allowed there.
    pub allowed: String,
}

impl FieldError {
    /// Creates an error of a field. A blank text is shown in quotes, a number with many zeros as a power of
    /// ten.
    pub fn new(field: impl Into<String>, found: impl ToString, allowed: impl Into<String>) -> Self {
        let found = found.to_string();
        let found = if found.trim().is_empty() { wording::quoted(&found) } else { wording::with_powers(&found) };
        let found = wording::beginning(&found, LONGEST_FOUND);
        Self { field: field.into(), found, allowed: wording::with_powers(&allowed.into()) }
    }
}

/// An error in a scenario, with its place. Shown as `paper.yaml:12:14: bodies.ship.mass_kg: found -5, allowed: a number
/// greater than 0`.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub struct ScenarioError {
    /// The file's name, or `--set name` for a value set from outside; empty if there is neither.
    pub file: String,
    /// Line in the file, from 1.
    pub line: Option<usize>,
    /// Column in the file, from 1, in characters.
    pub column: Option<usize>,
    /// Dotted path of the field, list entries by index from 0; empty if it concerns the whole file.
    pub field: String,
    /// Value or text that was found there.
    pub found: String,
    /// Range or form that is allowed there.
    pub allowed: String,
}

impl fmt::Display for ScenarioError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.file.is_empty() {
            match self.file.strip_prefix(SET) {
                Some(name) => write!(f, "{SET}{}", wording::on_one_line(&wording::beginning(name, LONGEST_NAME)))?,
                None => f.write_str(&wording::on_one_line(&self.file))?,
            }
            if let (Some(line), Some(column)) = (self.line, self.column) {
                write!(f, ":{line}:{column}")?;
            }
            f.write_str(": ")?;
        }
        let field_is_the_place = self.file.strip_prefix(SET).is_some_and(|name| name == self.field);
        if !self.field.is_empty() && !field_is_the_place {
            write!(f, "{}: ", wording::on_one_line(&wording::beginning(&self.field, LONGEST_NAME)))?;
        }
        f.write_str(&wording::found_and_allowed(&self.found, &self.allowed))
    }
}

impl From<FieldError> for ScenarioError {
    fn from(error: FieldError) -> Self {
        let FieldError { field, found, allowed } = error;
        Self { file: String::new(), line: None, column: None, field, found, allowed }
    }
}

const SET: &str = "--set ";

/// Source of a value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum SourcePlace {
    /// The main file.
    File {
        /// Line, from 1.
        line: usize,
        /// Column, from 1, in characters.
        column: usize,
    },
    /// The file of a part.
    Part {
        /// Path of the file, relative to the main file's folder, or its name in the gallery.
        file: Arc<str>,
        /// Prefix of the part's names in the whole scenario.
        prefix: Arc<str>,
        /// Line, from 1.
        line: usize,
        /// Column, from 1, in characters.
        column: usize,
    },
    /// Set from outside, under this name.
    Set(String),
}

impl SourcePlace {
    pub(super) const START: Self = Self::File { line: 1, column: 1 };

    /// Returns whether both places are in the same file; a place from outside is in none.
    pub(super) fn is_in_the_file_of(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::File { .. }, Self::File { .. }) => true,
            (Self::Part { file, prefix, .. }, Self::Part { file: of_other, prefix: prefix_of_other, .. }) => {
                file == of_other && prefix == prefix_of_other
            }
            _ => false,
        }
    }
}

/// An error of a field and its place; the name of the file is added last.
#[derive(Clone, Debug)]
pub(super) struct Fault {
    pub(super) place: SourcePlace,
    pub(super) error: FieldError,
}

impl Fault {
    pub(super) fn new(
        place: &SourcePlace,
        field: impl Into<String>,
        found: impl ToString,
        allowed: impl Into<String>,
    ) -> Self {
        Self { place: place.clone(), error: FieldError::new(field, found, allowed) }
    }

    pub(super) fn in_file(self, file: &str) -> ScenarioError {
        let error = ScenarioError::from(self.error);
        match self.place {
            SourcePlace::File { line, column } => {
                ScenarioError { file: file.to_owned(), line: Some(line), column: Some(column), ..error }
            }
            SourcePlace::Part { file: part, prefix, line, column } => ScenarioError {
                file: part_names::beside(file, &part),
                line: Some(line),
                column: Some(column),
                field: part_names::in_part(&error.field, &prefix),
                ..error
            },
            SourcePlace::Set(name) => ScenarioError { file: format!("{SET}{name}"), ..error },
        }
    }
}
