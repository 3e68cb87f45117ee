//! ARCHITECTURE.md says what may import what; this holds the code to it.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn read(path: impl AsRef<Path>) -> String {
    fs::read_to_string(path.as_ref()).unwrap_or_else(|error| panic!("{}: {error}", path.as_ref().display()))
}

/// Module names in the first column of the table under a heading, in order.
fn order_under(heading: &str) -> Vec<String> {
    let text = read(root().join("ARCHITECTURE.md"));
    let section = text.split(heading).nth(1).expect("the heading is there");
    section
        .lines()
        .skip_while(|line| !line.starts_with("| `"))
        .take_while(|line| line.starts_with("| `"))
        .map(|line| line.split('`').nth(1).expect("a name in backticks").trim_end_matches('/').to_owned())
        .collect()
}

fn files_below(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            found.extend(files_below(&path, ending));
        } else if path.to_string_lossy().ends_with(ending) {
            found.push(path);
        }
    }
    found
}

/// The first path component below `folder`, without its ending.
fn module_of(path: &Path, folder: &Path) -> String {
    let relative = path.strip_prefix(folder).expect("below the folder");
    let first = relative.iter().next().expect("a component").to_string_lossy().into_owned();
    first.split('.').next().unwrap_or_default().to_owned()
}

/// Names that follow each `marker` in the code, comments left out.
fn names_after(code: &str, marker: &str) -> BTreeSet<String> {
    let lines = code.lines().filter(|line| !line.trim_start().starts_with("//"));
    let name = |rest: &str| rest.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect::<String>();
    lines.flat_map(|line| line.split(marker).skip(1).map(name).collect::<Vec<_>>()).filter(|n| !n.is_empty()).collect()
}

#[test]
fn every_module_of_the_engine_imports_only_those_before_it() {
    let (order, source) = (order_under("## The engine's modules"), root().join("crates/kingpost/src"));
    let mut seen = BTreeSet::new();
    for path in files_below(&source, ".rs") {
        let module = module_of(&path, &source);
        if module == "lib" {
            continue;
        }
        let place = order.iter().position(|m| *m == module);
        let place = place.unwrap_or_else(|| panic!("ARCHITECTURE.md does not name {module}"));
        seen.insert(module.clone());
        for used in names_after(&read(&path), "crate::") {
            // Types that lib.rs lifts to the top are named by their modules inside the crate.
            let used_place = order.iter().position(|m| *m == used);
            let used_place = used_place.unwrap_or_else(|| panic!("{}: crate::{used} is no module", path.display()));
            assert!(used_place <= place, "{} imports {used}, which comes after {module}", path.display());
        }
    }
    assert_eq!(seen, order.into_iter().collect(), "ARCHITECTURE.md names modules that are gone");
}

#[test]
fn the_engine_has_no_clock_no_output_and_no_input() {
    let source = root().join("crates/kingpost/src");
    for path in files_below(&source, ".rs") {
        let code = read(&path);
        for line in code.lines().filter(|line| !line.trim_start().starts_with("//")) {
            for forbidden in
                ["std::time", "std::fs", "std::io", "std::thread", "std::env", "println!", "eprintln!", "dbg!"]
            {
                assert!(!line.contains(forbidden), "{}: {forbidden}", path.display());
            }
        }
    }
}

#[test]
fn the_engine_depends_on_no_view() {
    let manifest = read(root().join("crates/kingpost/Cargo.toml"));
    for view in ["pyo3", "wasm-bindgen", "kingpost-py", "kingpost-wasm"] {
        assert!(!manifest.contains(view), "the engine names {view}");
    }
}

#[test]
fn files_and_bindings_stay_small() {
    let crates = root().join("crates");
    for path in files_below(&crates, ".rs").iter().filter(|path| !path.to_string_lossy().contains("/target/")) {
        let lines = read(path).lines().count();
        assert!(lines <= 450, "{} has {lines} lines", path.display());
    }
    for binding in ["kingpost-py", "kingpost-wasm"] {
        let sources = files_below(&crates.join(binding).join("src"), ".rs");
        let lines: usize = sources.iter().map(|path| read(path).lines().count()).sum();
        assert!(lines <= 450, "{binding} has {lines} lines: only conversions belong there");
    }
}
