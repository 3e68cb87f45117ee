//! Writes the golden runs that native, Python and WASM must give bit for bit:
//! `cargo run -p kingpost --example write_golden`. Rewrite them only when a change of the numbers
//! is meant, and say so in the changelog.

#[path = "../tests/golden/cases.rs"]
mod cases;

fn main() -> std::io::Result<()> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden");
    for (scenario, runs) in cases::compute() {
        let text = serde_json::to_string_pretty(&runs).map_err(std::io::Error::other)?;
        std::fs::write(folder.join(scenario).with_extension("json"), text + "\n")?;
    }
    Ok(())
}
