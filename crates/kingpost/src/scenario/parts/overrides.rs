//! The mountings of a file, and the values set in them from outside.

use indexmap::IndexMap;
use serde_json::{Value, json};

use super::super::error::{Fault, SourcePlace};
use super::super::parameters::{Override, OverrideTarget};
use super::super::reading;
use super::super::schema::{Mounting, Name, Scenario};
use super::super::tree::{Content, Field, ScenarioNode, segments};
use super::super::writing::ToValue;
use super::super::{unit_conversion, units, wording};
use super::{put, take};

/// Applies the overrides of mountings, such as `parts.crane.position_m`, and returns the others. `tree` is
/// the file without its parts.
pub fn write<'a>(parts: &mut Field, tree: &ScenarioNode, given: Vec<Override<'a>>) -> Result<Vec<Override<'a>>, Fault> {
    to_si(parts)?;
    let (ours, rest): (Vec<_>, Vec<_>) = given.into_iter().partition(|set| set.name.starts_with("parts."));
    for set in &ours {
        let path = segments(set.name);
        match path.iter().map(String::as_str).collect::<Vec<_>>()[..] {
            [_, part, "parameters", ref names @ ..] if !names.is_empty() => {
                let known = parts.node.field(part).is_some_and(|part| matches!(part.node.content, Content::Fields(_)));
                if !known {
                    let allowed = wording::one_of_with_hint(&parts.node.names(), part);
                    return Err(Fault::new(&set.place, set.name, wording::quoted(part), allowed));
                }
                put(&mut parts.node, &[part, "parameters", &names.join(".")], set.value, &set.place);
            }
            _ => {
                if let Some(fault) = set_by_a_parameter(tree, set, &path) {
                    return Err(fault);
                }
                in_probe(parts, |probe| {
                    let whole = json!({ "parts": reading::read::<Scenario>(probe)?.parts.to_value() });
                    OverrideTarget { tree: probe, whole: &whole }.write(set.name, set.value, &set.place, &set.place)
                })?;
            }
        }
    }
    Ok(rest)
}

/// Returns the error for a field that a parameter already writes.
fn set_by_a_parameter(tree: &ScenarioNode, set: &Override<'_>, path: &[String]) -> Option<Fault> {
    let (path, _) = units::si_path(path);
    let parameters = tree.field("parameters")?.node.to_value();
    let written = parameters.as_array()?.iter().filter_map(|parameter| parameter.get("writes")?.as_array().cloned());
    let same = |written: &Value| {
        let (written, _) = units::si_path(&segments(written.as_str().unwrap_or_default()));
        written.len().min(path.len()) > 2 && written.iter().zip(&path).all(|(one, other)| one == other)
    };
    let clash = written.flatten().any(|written| same(&written));
    clash.then(|| Fault::new(&set.place, set.name, wording::found(set.value), wording::SET_BY_NAME))
}

/// Converts mountings to SI units; the names of parameters are not changed.
fn to_si(parts: &mut Field) -> Result<(), Fault> {
    let mut parameters = Vec::new();
    if let Content::Fields(mountings) = &mut parts.node.content {
        for (name, mounting) in mountings.iter_mut() {
            if let Some(given) = take(&mut mounting.node, "parameters") {
                parameters.push((name.clone(), given));
            }
        }
    }
    in_probe(parts, unit_conversion::to_si)?;
    if let Content::Fields(mountings) = &mut parts.node.content {
        for (name, given) in parameters {
            if let Some(mounting) = mountings.get_mut(&name)
                && let Content::Fields(fields) = &mut mounting.node.content
            {
                fields.insert("parameters".to_owned(), given);
            }
        }
    }
    Ok(())
}

/// Returns the mountings by their names.
pub fn typed_mountings(parts: &mut Field) -> Result<IndexMap<Name, Mounting>, Fault> {
    in_probe(parts, |probe| Ok(reading::read::<Scenario>(probe)?.parts))
}

/// Calls `work` with a scenario that contains only these parts.
fn in_probe<T>(parts: &mut Field, work: impl FnOnce(&mut ScenarioNode) -> Result<T, Fault>) -> Result<T, Fault> {
    let mut probe = ScenarioNode::from_value(&json!({"version": 1, "title": "", "bodies": {}}), &SourcePlace::START);
    let hollow =
        Field::new(parts.name_place.clone(), ScenarioNode::new(SourcePlace::START, Content::Scalar(Value::Null)));
    if let Content::Fields(fields) = &mut probe.content {
        fields.insert("parts".to_owned(), std::mem::replace(parts, hollow));
    }
    let found = work(&mut probe);
    if let Some(back) = take(&mut probe, "parts") {
        *parts = back;
    }
    found
}
