//! Merges the tree of a part into the tree of the file that includes it.

use indexmap::IndexMap;
use serde_json::Value;

use super::super::error::{Fault, SourcePlace};
use super::super::part_names::SECTIONS;
use super::super::tree::{Content, Field, ScenarioNode};
use super::super::wording;
use super::{Mount, WORLD, take};

/// A part whose names and positions are those of the including file.
pub struct Part {
    pub tree: ScenarioNode,
    /// Paths of the fields that hold the position of the mounting: a parameter of the position writes them.
    /// `Err` holds the path of an entry whose position is given separately.
    pub frames: Result<Vec<String>, String>,
}

/// Adds the part's entries and parameters to the tree.
pub fn into(tree: &mut ScenarioNode, mut part: Part, mount: &Mount<'_>) -> Result<(), Fault> {
    place_of_the_part(tree, &part, mount)?;
    for section in SECTIONS {
        let Some(Field { node: ScenarioNode { content: Content::Fields(entries), .. }, .. }) =
            take(&mut part.tree, section)
        else {
            continue;
        };
        let Some(here) = section_of(tree, section, mount.place) else { continue };
        for (name, field) in entries {
            if here.contains_key(&name) {
                let found = format!("{section}.{name} a second time");
                return Err(mount.fault("", found, wording::OTHER_PREFIX));
            }
            here.insert(name, field);
        }
    }
    parameters(tree, &mut part.tree, mount)
}

/// Returns the entries of a section; the section is created if it does not exist.
fn section_of<'a>(
    tree: &'a mut ScenarioNode,
    section: &str,
    place: &SourcePlace,
) -> Option<&'a mut IndexMap<String, Field>> {
    let Content::Fields(fields) = &mut tree.content else { return None };
    let empty = || Field::new(place.clone(), ScenarioNode::new(place.clone(), Content::Fields(IndexMap::new())));
    match &mut fields.entry(section.to_owned()).or_insert_with(empty).node.content {
        Content::Fields(entries) => Some(entries),
        _ => None,
    }
}

/// Adds the part's parameters after the existing ones.
fn parameters(tree: &mut ScenarioNode, part: &mut ScenarioNode, mount: &Mount<'_>) -> Result<(), Fault> {
    let Some(Field { node: ScenarioNode { content: Content::List(new), .. }, .. }) = take(part, "parameters") else {
        return Ok(());
    };
    let Content::Fields(fields) = &mut tree.content else { return Ok(()) };
    let empty = || Field::new(mount.place.clone(), ScenarioNode::new(mount.place.clone(), Content::List(Vec::new())));
    let Content::List(here) = &mut fields.entry("parameters".to_owned()).or_insert_with(empty).node.content else {
        return Ok(());
    };
    let name = |parameter: &ScenarioNode| parameter.field("name").map(|field| field.node.to_value());
    for parameter in new {
        if let Some(Value::String(taken)) = name(&parameter)
            && here.iter().any(|other| name(other).is_some_and(|other| other == taken.as_str()))
        {
            let found = format!("the parameter {taken} a second time");
            return Err(mount.fault("", found, wording::OTHER_PARAMETER));
        }
        here.push(parameter);
    }
    Ok(())
}

/// Calls `change` with the paths that each parameter of a tree writes, and with the field of these paths.
fn each_write(
    tree: &mut ScenarioNode,
    mut change: impl FnMut(String, &mut Vec<ScenarioNode>) -> Result<(), Fault>,
) -> Result<(), Fault> {
    let Content::Fields(fields) = &mut tree.content else { return Ok(()) };
    let Some(Content::List(parameters)) = fields.get_mut("parameters").map(|field| &mut field.node.content) else {
        return Ok(());
    };
    for (index, parameter) in parameters.iter_mut().enumerate() {
        let Content::Fields(fields) = &mut parameter.content else { continue };
        if let Some(Content::List(writes)) = fields.get_mut("writes").map(|field| &mut field.node.content) {
            change(format!("parameters.{index}.writes"), writes)?;
        }
    }
    Ok(())
}

fn text(node: &ScenarioNode) -> &str {
    match &node.content {
        Content::Scalar(Value::String(text)) => text,
        _ => "",
    }
}

/// Redirects parameters that write the part's position to the fields that hold it in the whole scenario.
fn place_of_the_part(tree: &mut ScenarioNode, part: &Part, mount: &Mount<'_>) -> Result<(), Fault> {
    let own = format!("parts.{}.", mount.name);
    each_write(tree, |field, writes| {
        let mut written = Vec::with_capacity(writes.len());
        for (nth, node) in std::mem::take(writes).into_iter().enumerate() {
            let rest = text(&node).strip_prefix(&own).filter(|rest| is_place(rest)).map(str::to_owned);
            match (rest, &part.frames) {
                (None, _) => written.push(node),
                (Some(rest), Ok(frames)) => written.extend(frames.iter().map(|frame| {
                    let path = Value::from(format!("{frame}.{rest}"));
                    ScenarioNode::new(node.place.clone(), Content::Scalar(path))
                })),
                (Some(_), Err(with_own)) => {
                    let found = format!("the position of a part in which {with_own} has a position of its own");
                    return Err(Fault::new(&node.place, format!("{field}.{nth}"), found, wording::PLACE_OF_A_PART));
                }
            }
        }
        *writes = written;
        Ok(())
    })
}

fn is_place(path: &str) -> bool {
    let field = path.split('.').next().unwrap_or_default();
    ["position_m", "orientation_rad", "orientation_deg"].contains(&field)
}

/// Checks that no parameter writes a field that is removed when parts are mounted.
pub fn check_writes(tree: &mut ScenarioNode) -> Result<(), Fault> {
    each_write(tree, |field, writes| {
        match writes.iter().enumerate().find(|(_, node)| text(node).starts_with("parts.")) {
            Some((nth, node)) => {
                let found = wording::quoted(text(node));
                Err(Fault::new(&node.place, format!("{field}.{nth}"), found, wording::PLACE_OF_A_PART))
            }
            None => Ok(()),
        }
    })
}

/// Checks that the body on which a part is mounted exists.
pub fn check_mounted_on(tree: &ScenarioNode, mount: &Mount<'_>) -> Result<(), Fault> {
    let on = mount.mounting.on.as_str();
    let bodies = tree.field("bodies").map(|bodies| bodies.node.names()).unwrap_or_default();
    if on == WORLD || bodies.contains(&on) {
        return Ok(());
    }
    let names: Vec<&str> = bodies.into_iter().chain([WORLD]).collect();
    Err(mount.fault("on", on, wording::one_of_with_hint(&names, on)))
}
