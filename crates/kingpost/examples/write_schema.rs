//! Writes `schema/scenario.schema.json` from the types of the scenario.

use std::path::Path;

fn main() -> std::io::Result<()> {
    let mut text = serde_json::to_string_pretty(&kingpost::scenario::json_schema::json_schema())?;
    text.push('\n');
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../schema/scenario.schema.json");
    if let Some(folder) = file.parent() {
        std::fs::create_dir_all(folder)?;
    }
    std::fs::write(file, text)
}
