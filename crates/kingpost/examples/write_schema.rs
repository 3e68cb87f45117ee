//! Writes `schema/scenario.schema.json` from the types of the scenario, `schema/study.schema.json` from those of a study, and
//! `schema/model.schema.json`, `schema/hydrostatics.schema.json` and `schema/equations.schema.json` from those of what the engine says of it, of its
//! hulls and of its equations.

use kingpost::hydrostatics;
use kingpost::scenario::json_schema::{equations_schema, json_schema, published_schema, study_schema};
use serde_json::Value;
use std::path::Path;

fn main() -> std::io::Result<()> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../schema");
    std::fs::create_dir_all(&folder)?;
    write(&folder.join("scenario.schema.json"), &json_schema())?;
    write(&folder.join("study.schema.json"), &study_schema())?;
    write(&folder.join("model.schema.json"), &published_schema())?;
    write(&folder.join("hydrostatics.schema.json"), &hydrostatics::json_schema())?;
    write(&folder.join("equations.schema.json"), &equations_schema())
}

fn write(file: &Path, schema: &Value) -> std::io::Result<()> {
    let mut text = serde_json::to_string_pretty(schema)?;
    text.push('\n');
    std::fs::write(file, text)
}
