//! Scenario files: the gallery, parts, schema, errors, every number.

#[path = "../common/mod.rs"]
mod common;

mod built;
mod damaged_files;
mod derivatives;
mod drawing_frames;
mod gallery;
mod golden;
mod leaf_cases;
mod leaves;
mod parts;
mod parts_mistakes;
mod parts_page;
mod parts_schema;
mod readings;
mod scenario_errors;
mod scenario_parameters;
mod scenario_properties;
mod scenario_schema;
mod studies;
mod views;
