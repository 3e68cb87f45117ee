//! Scenario: text -> the description of a run, with the place of every error.
//!
//! [`read`] parses YAML (JSON is its subset), renames unit aliases, applies parameters and overrides, types the tree and
//! builds the model once to validate it.

pub mod build;
pub mod range;
pub mod schema;
pub mod text;

pub use schema::Scenario;
