//! Scenario: from text to the description of a run, with the place of every error.
//!
//! [`read`] parses YAML (JSON is its subset), renames unit aliases, applies parameters and overrides,
//! converts the tree to types and builds the model once to validate it; [`BuiltScenario`] keeps the setup.

pub mod assembly;
mod assignment;
mod built;
pub mod describe;
mod error;
mod field_search;
mod files;
#[cfg(feature = "schema")]
pub mod json_schema;
pub mod leaf;
mod live;
mod named_files;
pub mod over;
mod parameters;
mod parse;
mod part_names;
mod parts;
pub mod range;
pub(crate) mod read;
pub(crate) mod reading;
mod replay;
mod scalar_conversion;
pub mod schema;
pub mod study;
pub mod text;
mod ties;
pub(crate) mod tree;
mod unit_conversion;
mod units;
pub mod wording;
pub mod writing;

pub use assignment::parse_assignment;
pub use built::BuiltScenario;
pub use error::{FieldError, ScenarioError};
pub use files::{Files, Host};
pub use live::ParameterError;
pub use named_files::NamedFiles;
pub use read::{file_names, read, read_with};
#[cfg(not(target_family = "wasm"))]
pub(crate) use scalar_conversion::side_by_side;
pub use schema::{LIVE_SETTINGS, Scenario};
pub use units::{UNIT_ALIASES, UnitAlias};
