//! Names of a part in the whole scenario: the fields that contain names, and the prefix of these names.

use serde_json::Value;

use super::super::error::{Fault, SourcePlace};
use super::super::part_names::{self, SECTIONS};
use super::super::reading::{FromNode, TextKind, TextVisitor};
use super::super::schema::Scenario;
use super::super::tree::{Content, ScenarioNode};
use super::super::wording;

/// Returns a path of a part as a path of the whole scenario.
fn in_whole(path: &str, prefix: &str) -> String {
    match path.split_once('.') {
        Some((section, rest)) if SECTIONS.contains(&section) => format!("{section}.{prefix}{rest}"),
        _ => path.to_owned(),
    }
}

/// Adds the prefix to every name of a part, and makes the paths of its files relative to the main file.
pub fn into_whole(tree: &mut ScenarioNode, prefix: &str, file: &str, label: &str) -> Result<(), Fault> {
    let Content::Fields(fields) = &mut tree.content else { return Ok(()) };
    for (section, field) in fields.iter_mut() {
        match &mut field.node.content {
            Content::Fields(entries) if SECTIONS.contains(&section.as_str()) => {
                let named = std::mem::take(entries).into_iter();
                *entries = named.map(|(name, field)| (format!("{prefix}{name}"), field)).collect();
            }
            Content::List(entries) if section == "parameters" => {
                for (index, entry) in entries.iter_mut().enumerate() {
                    parameter(entry, index, prefix, label)?;
                }
            }
            _ => {}
        }
    }
    for section in SECTIONS {
        visit_section(tree, section, &mut |kind, text| match kind {
            TextKind::Reference if text != super::WORLD => text.insert_str(0, prefix),
            TextKind::Reference => {}
            TextKind::File(_) => *text = part_names::from_folder_of(file, text),
        });
    }
    Ok(())
}

/// Visits the texts of one section that name entries or files.
fn visit_section(tree: &mut ScenarioNode, section: &str, visit: &mut TextVisitor<'_>) {
    let Content::Fields(fields) = &mut tree.content else { return };
    let Some(field) = fields.get_mut(section) else { return };
    let alone = Content::Fields([(section.to_owned(), field.clone())].into_iter().collect());
    let mut alone = ScenarioNode::new(field.node.place.clone(), alone);
    Scenario::<f64>::visit_texts(&mut alone, visit);
    if let Content::Fields(mut visited) = alone.content
        && let Some(visited) = visited.swap_remove(section)
    {
        *field = visited;
    }
}

/// Converts a parameter of a part to one of the whole scenario.
fn parameter(node: &mut ScenarioNode, index: usize, prefix: &str, label: &str) -> Result<(), Fault> {
    let Content::Fields(fields) = &mut node.content else { return Ok(()) };
    if let Some(writes) = fields.get_mut("writes")
        && let Content::List(paths) = &mut writes.node.content
    {
        for (nth, path) in paths.iter_mut().enumerate() {
            let Content::Scalar(Value::String(text)) = &mut path.content else { continue };
            if Scenario::<f64>::text_at(&text.split('.').collect::<Vec<_>>()).is_some() {
                let field = format!("parameters.{index}.writes.{nth}");
                return Err(Fault::new(&path.place, field, wording::quoted(text), wording::NO_REFERENCE));
            }
            *text = in_whole(text, prefix);
        }
    }
    let text = |node: &ScenarioNode| node.to_value().as_str().map(str::to_owned);
    let name = fields.get("name").and_then(|field| text(&field.node)).unwrap_or_default();
    let shown = fields.get("label").and_then(|field| text(&field.node)).unwrap_or_else(|| name.clone());
    if let Some(field) = fields.get_mut("name") {
        field.node.content = Content::Scalar(format!("{prefix}{name}").into());
    }
    if !prefix.is_empty() {
        let place = node.place.clone();
        super::put(node, &["label"], &format!("{label}: {shown}").into(), &place);
    }
    Ok(())
}

/// Converts the places of a parsed file to places of a part.
pub fn places_of_part(node: &mut ScenarioNode, file: &str) {
    each_place(node, &mut |place| *place = place_in_part(place, file));
}

/// Converts a place of a parsed file to a place of a part.
pub fn place_in_part(place: &SourcePlace, file: &str) -> SourcePlace {
    match place {
        SourcePlace::File { line, column } => {
            SourcePlace::Part { file: file.into(), prefix: "".into(), line: *line, column: *column }
        }
        other => other.clone(),
    }
}

/// Stores a prefix in the places of a part; places of values that the including file `from` sets do not
/// change.
pub fn places_with_prefix(node: &mut ScenarioNode, prefix: &str, from: &str) {
    each_place(node, &mut |place| {
        if let SourcePlace::Part { file, prefix: inner, .. } = place
            && **file != *from
        {
            *inner = format!("{prefix}{inner}").into();
        }
    });
}

fn each_place(node: &mut ScenarioNode, change: &mut impl FnMut(&mut SourcePlace)) {
    change(&mut node.place);
    match &mut node.content {
        Content::Scalar(_) => {}
        Content::List(entries) => entries.iter_mut().for_each(|entry| each_place(entry, change)),
        Content::Fields(fields) => {
            for field in fields.values_mut() {
                change(&mut field.name_place);
                each_place(&mut field.node, change);
            }
        }
    }
}
