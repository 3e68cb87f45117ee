//! Golden runs, bit for bit. `cargo run -p kingpost --example write_golden` wrote them; Python and
//! WASM compare against the same files.

#[path = "../golden/cases.rs"]
mod cases;

use cases::Golden;

#[test]
fn golden_runs_are_bitwise_identical() {
    for (scenario, computed) in cases::compute() {
        let path = format!("{}/tests/golden/{scenario}.json", env!("CARGO_MANIFEST_DIR"));
        let text = std::fs::read_to_string(path).expect("the file is there");
        let stored: Vec<Golden> = serde_json::from_str(&text).expect("the file reads");
        assert_eq!(stored.len(), computed.len());
        for (stored, computed) in stored.iter().zip(&computed) {
            assert_eq!(stored.name, computed.name);
            assert_eq!((&stored.overrides, stored.steps), (&computed.overrides, computed.steps));
            let bits = |row: &[f64]| row.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
            assert_eq!(bits(&stored.row), bits(&computed.row), "{scenario}: {}", stored.name);
        }
    }
}
