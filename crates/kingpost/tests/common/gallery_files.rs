//! The gallery as a host of files.

use kingpost::scenario::{Files, Host, Scenario, ScenarioError, read_with};
use serde_json::Value;
use std::borrow::Cow;
use std::path::{Path, PathBuf};

/// The gallery's folder.
pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios")
}

/// Files of the gallery, and of a scenario that lies in its folder.
#[derive(Debug)]
struct Gallery;

impl Host for Gallery {
    fn text(&self, name: &str) -> Option<Cow<'_, str>> {
        let path = folder().join(name.strip_prefix("gallery:").unwrap_or(name));
        std::fs::read_to_string(path).ok().map(Cow::Owned)
    }
}

/// The gallery's files.
pub fn files() -> Files {
    Files::of(Gallery)
}

/// Names of the files of a folder in the gallery, without their ending `.yaml`, in order.
pub fn names(below: &str) -> Vec<String> {
    let paths = std::fs::read_dir(folder().join(below)).expect("a folder").map(|entry| entry.expect("an entry").path());
    let yaml = paths.filter(|path| path.extension().is_some_and(|ending| ending == "yaml"));
    let mut names: Vec<_> = yaml.map(|path| path.file_stem().expect("a name").to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

/// The text of a file of the gallery.
pub fn text(name: &str) -> String {
    std::fs::read_to_string(folder().join(format!("{name}.yaml"))).expect("the file is there")
}

/// A scenario whose files are the gallery's, with values set over it.
pub fn read(text: &str, set: &[(&str, Value)]) -> Result<Scenario, ScenarioError> {
    let set: Vec<_> = set.iter().map(|(name, value)| ((*name).to_owned(), value.clone())).collect();
    read_with(text, "test.yaml", &set, &files())
}

/// A scenario of the gallery, with values set over it.
#[track_caller]
pub fn scenario(name: &str, set: &[(&str, Value)]) -> Scenario {
    read(&text(name), set).unwrap_or_else(|error| panic!("{name}: {error}"))
}
