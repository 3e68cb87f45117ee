//! docs/parts.md: its scenario reads with its part, and runs.

use crate::common::gallery_files;

use kingpost::scenario::{Files, Host, read_with};
use std::borrow::Cow;

const PAGE: &str = include_str!("../../../../docs/parts.md");

/// The page's davit beside its vessel, and the gallery.
#[derive(Debug)]
struct Folder;

impl Host for Folder {
    fn text(&self, name: &str) -> Option<Cow<'_, str>> {
        match name.strip_prefix("gallery:") {
            None => (name == "davit.yaml").then(|| Cow::Borrowed(blocks()[1])),
            Some(name) => std::fs::read_to_string(gallery_files::folder().join(name)).ok().map(Cow::Owned),
        }
    }
}

fn blocks() -> Vec<&'static str> {
    PAGE.split("```yaml\n").skip(1).map(|rest| rest.split("```").next().unwrap_or_default()).collect()
}

#[test]
fn the_page_is_a_vessel_with_two_cranes_that_runs() {
    let set = [("bodies.davit_post.mass_t".to_owned(), 0.9.into()), ("davit_load_t".to_owned(), 2.into())];
    let scenario = read_with(blocks()[0], "cranes/vessel.yaml", &set, &Files::of(Folder));
    let scenario = scenario.unwrap_or_else(|error| panic!("{error}"));
    for body in ["vessel_hull", "aft_main_boom", "davit_post"] {
        assert!(scenario.bodies.contains_key(body), "{body}");
    }
    let mut simulation = scenario.simulation().unwrap_or_else(|error| panic!("{error}"));
    simulation.step(100).expect("it does not diverge");
    for (place, part) in [("parts.davit.position_m.0", 25.into()), ("parts.davit.part", "paper_crane".into())] {
        let set = [(place.to_owned(), part)];
        read_with(blocks()[0], "vessel.yaml", &set, &Files::of(Folder)).unwrap_or_else(|error| panic!("{error}"));
    }
}

#[test]
fn the_page_shows_the_error_that_it_describes() {
    #[derive(Debug)]
    struct Wrong;
    impl Host for Wrong {
        fn text(&self, name: &str) -> Option<Cow<'_, str>> {
            Folder.text(name).map(|text| Cow::Owned(text.replace("mass_t: 0.8", "mass_t: -0.8")))
        }
    }
    let error = read_with(blocks()[0], "cranes/vessel.yaml", &[], &Files::of(Wrong)).unwrap_err().to_string();
    assert!(PAGE.contains(&error), "{error}");
}
