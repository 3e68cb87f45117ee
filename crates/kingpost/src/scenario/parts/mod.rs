//! Parts: other files that are mounted into the tree of a scenario, before the whole tree is converted to
//! types.
//!
//! The text of a part becomes a tree whose places contain the part's file. Values that its mounting sets are
//! written into the tree, its names get the prefix, entries attached to the world are moved to the mounting,
//! and the result is merged into the including tree. No `parts` remain there.

mod merge;
mod names;
mod overrides;
mod placement;

use indexmap::IndexMap;
use serde_json::{Value, json};

use super::error::{Fault, SourcePlace};
use super::files::Files;
use super::parameters::{self, Override, OverrideTarget};
use super::reading::check_version;
use super::schema::{Mounting, Name, Scenario, WORLD};
use super::tree::{Content, Field, ScenarioNode, segments};
use super::writing::ToValue;
use super::{parse, part_names, reading, unit_conversion, wording};

/// Largest nesting depth, and largest number of parts: more are probably a mistake and would exhaust the
/// machine.
const MOST_LEVELS: usize = 16;
const MOST_PARTS: usize = 256;

/// Parts of a scenario after mounting.
#[derive(Default)]
pub(super) struct Mounted {
    /// Parts by their names in the whole scenario, also those within parts.
    pub(super) parts: IndexMap<Name, Mounting>,
    /// Files of the parts, each once, named as the main file would name them.
    pub(super) files: Vec<String>,
    /// Whether a part's file was missing.
    pub(super) incomplete: bool,
}

/// Mounts parts with the texts of a host.
pub(super) struct Mounter<'a> {
    host: &'a Files,
    /// Whether missing files are skipped, to find the names of all files that are needed.
    only_names: bool,
    mounted: Mounted,
    count: usize,
}

/// A file whose parts are mounted.
struct Level<'a> {
    /// Files that include this one, the main file first, and this file.
    chain: Vec<&'a str>,
    /// Prefix of its names in the whole scenario.
    prefix: String,
    /// Prefix of the names of its parts in the list of all parts.
    list: String,
}

/// Converts the units of a parsed scenario and mounts its parts. Returns the parts, and the overrides that do
/// not concern a mounting.
pub(super) fn mount<'a>(
    tree: &mut ScenarioNode,
    file: &str,
    given: Vec<Override<'a>>,
    host: &Files,
    only_names: bool,
) -> Result<(Mounted, Vec<Override<'a>>), Fault> {
    let mut mounter = Mounter { host, only_names, mounted: Mounted::default(), count: 0 };
    let main = part_names::of_main(file);
    let level = Level { chain: vec![&main], prefix: String::new(), list: String::new() };
    let rest = mounter.mount_all(tree, &level, given)?;
    Ok((mounter.mounted, rest))
}

impl Mounter<'_> {
    /// Mounts every part of a file.
    fn mount_all<'a>(
        &mut self,
        tree: &mut ScenarioNode,
        level: &Level<'_>,
        given: Vec<Override<'a>>,
    ) -> Result<Vec<Override<'a>>, Fault> {
        let parts = take(tree, "parts");
        unit_conversion::to_si(tree)?;
        let Some(mut parts) = parts else { return Ok(given) };
        let rest = overrides::write(&mut parts, tree, given)?;
        let mountings = overrides::typed_mountings(&mut parts)?;
        let mounts = mountings.iter().map(|(name, mounting)| {
            let node = parts.node.field(name).unwrap_or(&parts);
            Mount { name, mounting, node, place: &node.name_place }
        });
        for mount in mounts.clone() {
            if let Some(part) = self.part(&mount, level)? {
                merge::into(tree, part, &mount)?;
            }
        }
        if !self.mounted.incomplete {
            mounts.clone().try_for_each(|mount| merge::check_mounted_on(tree, &mount))?;
            merge::check_writes(tree)?;
        }
        self.mounted.parts.extend(mounts.filter_map(|mount| mount.listed(level)));
        Ok(rest)
    }

    /// Returns the tree of a part, ready for the including file; `None` if only names are needed and a file
    /// is missing.
    fn part(&mut self, mount: &Mount<'_>, level: &Level<'_>) -> Result<Option<merge::Part>, Fault> {
        let from = level.chain.last().copied().unwrap_or_default();
        let file = part_names::of_part(from, &mount.mounting.part);
        self.check_chain(mount, &level.chain, &file)?;
        if !self.mounted.files.contains(&file) {
            self.mounted.files.push(file.clone());
        }
        let Some(text) = self.host.text_of(&file) else {
            if !self.only_names {
                return Err(mount.fault("part", format!("no file {file}"), wording::PART_THERE));
            }
            self.mounted.incomplete = true;
            return Ok(None);
        };
        let prefix = mount.prefix()?;
        let mut tree = parsed(&text, &file)?;
        let inside = Level {
            chain: level.chain.iter().copied().chain([file.as_str()]).collect(),
            prefix: format!("{}{prefix}", level.prefix),
            list: format!("{}{}_", level.list, mount.name),
        };
        let rest = mount.remapped(self.mount_all(&mut tree, &inside, mount.overrides()))?;
        if self.mounted.incomplete {
            return Ok(None);
        }
        mount.remapped(apply(&mut tree, &rest))?;
        passed_up(&mut tree, &mount.mounting.parameters);
        names::into_whole(&mut tree, &prefix, &file, mount.name)?;
        names::places_with_prefix(&mut tree, &prefix, from);
        let whole = mount.remapped(reading::read::<Scenario>(&tree))?.to_value();
        let frames = placement::on_the_mounting(&mut tree, &whole, mount)?;
        Ok(Some(merge::Part { tree, frames }))
    }

    fn check_chain(&mut self, mount: &Mount<'_>, chain: &[&str], file: &str) -> Result<(), Fault> {
        self.count += 1;
        if chain.contains(&file) {
            let found = format!("{} -> {file}", chain.join(" -> "));
            return Err(mount.fault("part", found, wording::PART_ENDS));
        }
        if chain.len() > MOST_LEVELS || self.count > MOST_PARTS {
            let found = format!("more than {MOST_LEVELS} nested parts, or {MOST_PARTS} in total");
            return Err(mount.fault("part", found, wording::FEWER_PARTS));
        }
        Ok(())
    }
}

/// Mounting of a part, in the file that includes it.
#[derive(Clone, Copy)]
struct Mount<'a> {
    name: &'a str,
    mounting: &'a Mounting,
    /// Fields of the mounting, with their places.
    node: &'a Field,
    place: &'a SourcePlace,
}

impl Mount<'_> {
    /// Returns an error of a field of the mounting.
    fn fault(&self, field: &str, found: impl ToString, allowed: impl Into<String>) -> Fault {
        let place = self.node.node.field(field).map_or(self.place, |field| &field.node.place);
        let dot = if field.is_empty() { "" } else { "." };
        Fault::new(place, format!("parts.{}{dot}{field}", self.name), found, allowed)
    }

    /// Returns the prefix of the part's names.
    fn prefix(&self) -> Result<String, Fault> {
        match self.mounting.prefix.as_deref() {
            None | Some("") => {}
            Some(prefix) if Name::new(prefix).is_some() => {}
            Some(prefix) => {
                return Err(self.fault("prefix", wording::quoted(prefix), wording::PREFIX));
            }
        }
        Ok(self.mounting.prefix(self.name))
    }

    /// Returns the entry of this mounting in the list of all parts.
    fn listed(&self, level: &Level<'_>) -> Option<(Name, Mounting)> {
        let mut mounting = self.mounting.clone();
        if mounting.on != WORLD {
            mounting.on = Name::new(format!("{}{}", level.prefix, mounting.on))?;
        }
        Some((Name::new(format!("{}{}", level.list, self.name))?, mounting))
    }

    /// Returns the values that the mounting sets in the part.
    fn overrides(&self) -> Vec<Override<'_>> {
        let Some(Content::Fields(places)) = self.node.node.field("parameters").map(|field| &field.node.content) else {
            return Vec::new();
        };
        let set = self.mounting.parameters.iter();
        set.filter_map(|(name, value)| Some(Override { name, value, place: places.get(name)?.node.place.clone() }))
            .collect()
    }

    /// Changes an error in a value that the mounting sets, so that it names the field of the mounting.
    fn remapped<T>(&self, result: Result<T, Fault>) -> Result<T, Fault> {
        result.map_err(|mut fault| {
            if let Some(set) = self.overrides().iter().find(|set| set.place == fault.place) {
                fault.error.field = format!("parts.{}.parameters.{}", self.name, set.name);
            }
            fault
        })
    }
}

/// Returns the tree of a part's text, with its places; an error if it cannot be mounted.
fn parsed(text: &str, file: &str) -> Result<ScenarioNode, Fault> {
    let in_part = |fault: Fault| Fault { place: names::place_in_part(&fault.place, file), error: fault.error };
    let mut tree = parse::parse(text).map_err(in_part)?;
    names::places_of_part(&mut tree, file);
    check_version(&tree)?;
    for field in ["simulation", "sea", "wind"] {
        if let Some(found) = tree.field(field) {
            return Err(Fault::new(&found.name_place, field, field, wording::OF_THE_PART));
        }
    }
    for name in tree.field("forces").map(|forces| forces.node.names()).unwrap_or_default() {
        let path = ["forces".to_owned(), name.to_owned(), "gravity".to_owned()];
        if tree.at(&path).is_some() {
            return Err(Fault::new(&tree.name_place_of(&path), path.join("."), "gravity", wording::OF_THE_PART));
        }
    }
    Ok(tree)
}

/// Writes the part's defaults, then the given values.
fn apply(tree: &mut ScenarioNode, given: &[Override<'_>]) -> Result<(), Fault> {
    let as_written: Scenario = reading::read(tree)?;
    let whole = as_written.to_value();
    parameters::apply(OverrideTarget { tree, whole: &whole }, &as_written.parameters, given).map(|_| ())
}

/// Keeps the parameters that are not set, without their defaults: the fields already hold these values.
fn passed_up(tree: &mut ScenarioNode, set: &IndexMap<String, Value>) {
    let Content::Fields(fields) = &mut tree.content else { return };
    let Some(Content::List(parameters)) = fields.get_mut("parameters").map(|field| &mut field.node.content) else {
        return;
    };
    parameters.retain(|parameter| {
        let name = parameter.field("name").map(|field| field.node.to_value());
        !name.is_some_and(|name| name.as_str().is_some_and(|name| set.contains_key(name)))
    });
    for parameter in parameters {
        if let Content::Fields(fields) = &mut parameter.content {
            fields.shift_remove("default");
        }
    }
}

/// Removes a field from a tree and returns it.
fn take(tree: &mut ScenarioNode, name: &str) -> Option<Field> {
    match &mut tree.content {
        Content::Fields(fields) => fields.shift_remove(name),
        _ => None,
    }
}

/// Writes a value, which comes from `place`, at a path of field names and list indices; missing fields are
/// created.
fn put(tree: &mut ScenarioNode, path: &[&str], value: &Value, place: &SourcePlace) {
    let Some((name, rest)) = path.split_first() else {
        *tree = ScenarioNode::from_value(value, place);
        return;
    };
    match &mut tree.content {
        Content::Fields(fields) => {
            let new = || Field::new(place.clone(), ScenarioNode::from_value(&json!({}), place));
            put(&mut fields.entry((*name).to_owned()).or_insert_with(new).node, rest, value, place);
        }
        Content::List(entries) => {
            if let Some(entry) = name.parse().ok().and_then(|index: usize| entries.get_mut(index)) {
                put(entry, rest, value, place);
            }
        }
        Content::Scalar(_) => {}
    }
}

/// Returns the numbers at a path of a value.
fn numbers<const N: usize>(value: &Value, path: &str) -> Option<[f64; N]> {
    let entries = super::tree::value_at(value, &segments(path))?.as_array()?;
    let numbers: Vec<f64> = entries.iter().filter_map(Value::as_f64).collect();
    numbers.try_into().ok()
}
