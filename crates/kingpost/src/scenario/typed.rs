//! The types of a scenario over its tree, and the words of what does not fit them.

use super::error::Fault;
use super::schema::Scenario;
use super::tree::{Content, ScenarioNode, value_at};
use super::wording;
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;
use serde_path_to_error::Segment;

pub(super) fn check_version(tree: &ScenarioNode) -> Result<(), Fault> {
    match tree.field("version").map(|field| &field.node) {
        None => Err(Fault::new(&tree.place, "version", wording::NOTHING, wording::VERSION)),
        Some(node) if node.to_value().as_f64() == Some(1.0) => Ok(()),
        Some(node) => {
            let found = wording::found(&node.to_value());
            Err(Fault::new(&node.place, "version", found, wording::VERSION))
        }
    }
}

/// The types of a scenario over a tree, with the place of the first error.
pub(super) fn typed(tree: &ScenarioNode) -> Result<Scenario, Fault> {
    typed_as(tree)
}

/// The same for the types of any file of ours.
pub(super) fn typed_as<T: DeserializeOwned + Serialize>(tree: &ScenarioNode) -> Result<T, Fault> {
    let value = tree.to_value();
    let read: T = serde_path_to_error::deserialize(&value).map_err(|error| type_fault::<T>(tree, &value, &error))?;
    // Serde takes the fields of a type from a list too, in the order in which the type happens to have them.
    let whole = serde_json::to_value(&read).unwrap_or_default();
    list_of_fields(tree, &whole, &mut Vec::new()).map_or(Ok(read), Err)
}

/// The error of the first list that stands where fields have names.
fn list_of_fields(node: &ScenarioNode, whole: &Value, path: &mut Vec<String>) -> Option<Fault> {
    let mut below = |segment: &str, node: &ScenarioNode, whole: Option<&Value>| {
        path.push(segment.to_owned());
        let fault = list_of_fields(node, whole?, path);
        path.pop();
        fault
    };
    match (&node.content, whole) {
        (Content::List(_), Value::Object(_)) => {
            Some(Fault::new(&node.place, path.join("."), wording::found(&node.to_value()), wording::FIELDS))
        }
        (Content::List(entries), Value::Array(all)) => {
            entries.iter().zip(all).enumerate().find_map(|(k, (node, whole))| below(&k.to_string(), node, Some(whole)))
        }
        (Content::Fields(fields), Value::Object(all)) => {
            fields.iter().find_map(|(name, field)| below(name, &field.node, all.get(name)))
        }
        _ => None,
    }
}

type TypeError = serde_path_to_error::Error<serde_json::Error>;

/// The path that the typed read stopped at.
fn path_of(error: &TypeError) -> Vec<String> {
    let segment = |segment: &Segment| match segment {
        Segment::Seq { index } => Some(index.to_string()),
        Segment::Map { key } => Some(key.clone()),
        Segment::Enum { variant } => Some(variant.clone()),
        Segment::Unknown => None,
    };
    error.path().iter().filter_map(segment).collect()
}

/// A typed read's error in our words and with its place.
fn type_fault<T: DeserializeOwned>(tree: &ScenarioNode, value: &Value, error: &TypeError) -> Fault {
    let mut path = path_of(error);
    let message = error.inner().to_string();
    if let Some(rest) = message.strip_prefix("unknown field ") {
        let names = wording::names_in_backquotes(rest);
        let (name, allowed) = names.split_first().map_or(("", &names[..]), |(name, rest)| (*name, rest));
        if path.last().is_none_or(|last| last.as_str() != name) || value_at(value, &path).is_none() {
            path.push(name.to_owned());
        }
        let written = tree.written_path(&path);
        let meant = written.rsplit('.').next().unwrap_or_default();
        let allowed = wording::one_of_with_hint(allowed, meant);
        return Fault::new(&tree.name_place_of(&path), &written, wording::UNKNOWN_FIELD, allowed);
    }
    if let Some(rest) = message.strip_prefix("missing field ") {
        path.extend(wording::names_in_backquotes(rest).first().map(|name| (*name).to_owned()));
    }
    let fault = name_fault(tree, &path, &message).or_else(|| kind_fault(tree, &path, &message));
    if let Some(fault) = fault.or_else(|| list_fault::<T>(tree, value, &path)) {
        return fault;
    }
    let own = expected(&message);
    let allowed = match own {
        Some(own) if message.starts_with("invalid value") && !message.starts_with("invalid value: map") => own,
        own => allowed_at::<T>(value, &path).or(own).unwrap_or_else(|| wording::REQUIRED.to_owned()),
    };
    let node = tree.at(&path);
    let found = node.map_or_else(|| wording::NOTHING.to_owned(), |node| found_in(node, &message));
    Fault::new(&tree.place_of(&path), tree.written_path(&path), found, allowed)
}

/// The error of a name with the wrong form.
fn name_fault(tree: &ScenarioNode, path: &[String], message: &str) -> Option<Fault> {
    let is_name = message.starts_with("invalid value: string") && !tree.at(path)?.to_value().is_string();
    let name = path.last().filter(|_| is_name)?;
    let field = tree.written_path(path);
    Some(Fault::new(&tree.name_place_of(path), field, wording::quoted(name), expected(message)?))
}

/// The error of a kind that is written without the fields it needs, or with fields that it does not have.
fn kind_fault(tree: &ScenarioNode, path: &[String], message: &str) -> Option<Fault> {
    let (kind, parent) = path.split_last()?;
    let allowed = match message.split_once(", expected ")?.1 {
        "newtype variant" => wording::with_fields(kind),
        "unit" | "unit variant" => wording::without_fields(kind),
        _ => return None,
    };
    let node = tree.at(parent)?;
    Some(Fault::new(&node.place, tree.written_path(parent), wording::found(&node.to_value()), allowed))
}

/// The error of a list that stands where fields have names: what is wrong inside of it tells nothing.
fn list_fault<T: DeserializeOwned>(tree: &ScenarioNode, value: &Value, path: &[String]) -> Option<Fault> {
    let wants_fields = |path: &[String]| {
        let mut probed = value.clone();
        *slot(&mut probed, path)? = serde_json::json!({"?": null});
        let error = serde_path_to_error::deserialize::<_, T>(&probed).err()?;
        error.inner().to_string().starts_with("unknown field `?`").then_some(())
    };
    (1..=path.len()).map(|end| &path[..end]).find_map(|path| {
        let node = tree.at(path).filter(|node| matches!(node.content, Content::List(_)))?;
        wants_fields(path)?;
        Some(Fault::new(&node.place, tree.written_path(path), wording::found(&node.to_value()), wording::FIELDS))
    })
}

/// What was found: the value as written, or the name if the name is wrong.
fn found_in(node: &ScenarioNode, message: &str) -> String {
    let value = node.written_value();
    match message.strip_prefix("unknown variant ") {
        Some(rest) if value.is_object() => wording::quoted(wording::names_in_backquotes(rest).first().unwrap_or(&"")),
        _ => wording::found(&value),
    }
}

/// What a serde message says is allowed.
fn expected(message: &str) -> Option<String> {
    if message.starts_with("unknown variant ") {
        let names = wording::names_in_backquotes(message);
        return names.split_first().map(|(written, names)| wording::one_of_with_hint(names, written));
    }
    message.split_once(", expected ").map(|(_, expected)| wording::allowed(expected))
}

/// What the types allow at a path, learned by reading again with values there that nothing or only little allows. The
/// types are the one source of these words; a message about a wrong type alone would hide a range or a list of kinds.
fn allowed_at<T: DeserializeOwned>(value: &Value, path: &[String]) -> Option<String> {
    let probes = [Value::from(-1.5), Value::from("?"), serde_json::json!({"?": null})];
    let mut of_type = None;
    for probe in probes {
        let mut probed = value.clone();
        *slot(&mut probed, path)? = probe;
        let Err(error) = serde_path_to_error::deserialize::<_, T>(&probed) else { continue };
        let message = error.inner().to_string();
        if path_of(&error) != path || message.starts_with("unknown field ") {
            continue;
        }
        let Some(allowed) = expected(&message) else { continue };
        if !message.starts_with("invalid type") {
            return Some(allowed);
        }
        of_type.get_or_insert(allowed);
    }
    of_type
}

/// The value at a path; a field that is not there is made.
fn slot<'a>(value: &'a mut Value, path: &[String]) -> Option<&'a mut Value> {
    path.iter().try_fold(value, |value, segment| match value {
        Value::Object(fields) => Some(fields.entry(segment.clone()).or_insert(Value::Null)),
        Value::Array(entries) => entries.get_mut(segment.parse::<usize>().ok()?),
        _ => None,
    })
}
