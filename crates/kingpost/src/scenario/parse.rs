//! Conversion of text to a tree, by serde-saphyr. Its limits against hostile files (depth, aliases, number of
//! values) are active.

use std::fmt;

use indexmap::IndexMap;
use serde::de::{MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};
use serde_json::{Number, Value};
use serde_saphyr::{DuplicateKeyPolicy, Location, NonFiniteFloatPolicy, Options, Spanned};

use super::error::{Fault, SourcePlace};
use super::tree::{Content, Field, ScenarioNode};
use super::wording;

/// The values from the YAML parser.
enum Raw {
    Null,
    Boolean(bool),
    Integer(i64),
    Unsigned(u64),
    Float(f64),
    Text(String),
    List(Vec<Spanned<Raw>>),
    Fields(Vec<(Spanned<String>, Spanned<Raw>)>),
}

struct RawVisitor;

impl<'de> Visitor<'de> for RawVisitor {
    type Value = Raw;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("any value")
    }
    fn visit_unit<E>(self) -> Result<Raw, E> {
        Ok(Raw::Null)
    }
    fn visit_none<E>(self) -> Result<Raw, E> {
        Ok(Raw::Null)
    }
    fn visit_bool<E>(self, value: bool) -> Result<Raw, E> {
        Ok(Raw::Boolean(value))
    }
    fn visit_i64<E>(self, value: i64) -> Result<Raw, E> {
        Ok(Raw::Integer(value))
    }
    fn visit_u64<E>(self, value: u64) -> Result<Raw, E> {
        Ok(Raw::Unsigned(value))
    }
    fn visit_f64<E>(self, value: f64) -> Result<Raw, E> {
        Ok(Raw::Float(value))
    }
    fn visit_str<E>(self, value: &str) -> Result<Raw, E> {
        Ok(Raw::Text(value.to_owned()))
    }
    fn visit_seq<A: SeqAccess<'de>>(self, mut access: A) -> Result<Raw, A::Error> {
        let mut entries = Vec::new();
        while let Some(entry) = access.next_element()? {
            entries.push(entry);
        }
        Ok(Raw::List(entries))
    }
    fn visit_map<A: MapAccess<'de>>(self, mut access: A) -> Result<Raw, A::Error> {
        let mut fields = Vec::new();
        while let Some(field) = access.next_entry()? {
            fields.push(field);
        }
        Ok(Raw::Fields(fields))
    }
}

impl<'de> Deserialize<'de> for Raw {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(RawVisitor)
    }
}

/// Returns the tree of a text with named fields at the top level.
pub(super) fn parse(text: &str) -> Result<ScenarioNode, Fault> {
    parse_as(text, wording::SCENARIO)
}

/// Returns the tree of a Kingpost file with named fields at the top level; `allowed` is the expected kind of
/// file.
pub(super) fn parse_as(text: &str, allowed: &str) -> Result<ScenarioNode, Fault> {
    let raw = raw(text, DuplicateKeyPolicy::Error).map_err(|error| fault(text, &error))?;
    let node = node(raw, &mut Vec::new())?;
    match &node.content {
        Content::Fields(_) => Ok(node),
        Content::Scalar(Value::Null) => Err(Fault::new(&SourcePlace::START, "", wording::EMPTY_FILE, allowed)),
        // A file of another kind can contain confidential text: a scenario from elsewhere can name any file.
        // The text is not shown.
        Content::Scalar(Value::String(text)) => {
            let found = format!("a text of {} characters, without named fields", text.chars().count());
            Err(Fault::new(&node.place, "", found, allowed))
        }
        _ => Err(Fault::new(&node.place, "", wording::found(&node.to_value()), allowed)),
    }
}

fn raw(text: &str, duplicate_keys: DuplicateKeyPolicy) -> Result<Spanned<Raw>, serde_saphyr::Error> {
    let mut options = Options::default();
    options.duplicate_keys = duplicate_keys;
    options.non_finite_float_policy = NonFiniteFloatPolicy::PassThrough;
    options.reject_unsupported_tags = true;
    options.strict_booleans = true;
    options.with_snippet = false;
    serde_saphyr::from_str_with_options(text, options)
}

fn place(location: Location) -> SourcePlace {
    let count = |number: u64| usize::try_from(number).unwrap_or(usize::MAX).max(1);
    SourcePlace::File { line: count(location.line()), column: count(location.column()) }
}

fn node(raw: Spanned<Raw>, path: &mut Vec<String>) -> Result<ScenarioNode, Fault> {
    let here = place(raw.referenced);
    let content = match raw.value {
        Raw::Null => Content::Scalar(Value::Null),
        Raw::Boolean(value) => Content::Scalar(Value::Bool(value)),
        Raw::Integer(value) => Content::Scalar(value.into()),
        Raw::Unsigned(value) => Content::Scalar(value.into()),
        Raw::Text(value) => Content::Scalar(Value::String(value)),
        Raw::Float(value) => match Number::from_f64(value) {
            Some(number) => Content::Scalar(Value::Number(number)),
            None => {
                let found = value.to_string().to_lowercase();
                return Err(Fault::new(&here, path.join("."), found, wording::FINITE));
            }
        },
        Raw::List(entries) => {
            let mut nodes = Vec::with_capacity(entries.len());
            for (index, entry) in entries.into_iter().enumerate() {
                path.push(index.to_string());
                nodes.push(node(entry, path)?);
                path.pop();
            }
            Content::List(nodes)
        }
        Raw::Fields(fields) => {
            let mut nodes = IndexMap::with_capacity(fields.len());
            for (name, value) in fields {
                if let Some((_, found)) = odd_blank_in(&name.value) {
                    return Err(Fault::new(&place(name.referenced), path.join("."), found, wording::PLAIN_SPACE));
                }
                path.push(name.value.clone());
                nodes.insert(name.value, Field::new(place(name.referenced), node(value, path)?));
                path.pop();
            }
            Content::Fields(nodes)
        }
    };
    Ok(ScenarioNode::new(here, content))
}

/// Converts an error of the parser to a scenario error.
fn fault(text: &str, error: &serde_saphyr::Error) -> Fault {
    use serde_saphyr::Error as E;
    let error = error.without_snippet();
    let here = error.location().map_or(SourcePlace::START, place);
    let (found, allowed) = match error {
        E::DuplicateMappingKey { key, .. } => {
            let key = key.clone().unwrap_or_default();
            let path = path_of_second(text, &here).unwrap_or_else(|| key.clone());
            return Fault::new(&here, path, format!("{key} a second time"), "each name once");
        }
        E::Budget { .. }
        | E::AliasReplayLimitExceeded { .. }
        | E::AliasExpansionLimitExceeded { .. }
        | E::AliasReplayStackDepthExceeded { .. } => wording::too_much(),
        E::MultipleDocuments { .. } => wording::second_document(),
        E::UnknownAnchor { .. } => wording::unknown_anchor(),
        E::NullIntoString { .. } | E::Unexpected { .. } => wording::not_a_name(),
        other => match odd_blank(text, &here) {
            Some((place, found)) => return Fault::new(&place, "", found, wording::PLAIN_SPACE),
            None => wording::syntax(&other.to_string()),
        },
    };
    Fault::new(&here, "", found, allowed)
}

/// Returns the last blank, up to a line, that is not a blank in YAML: text copied from a web page or a word
/// processor contains such blanks, and an editor does not show them.
fn odd_blank(text: &str, here: &SourcePlace) -> Option<(SourcePlace, String)> {
    let SourcePlace::File { line: last, .. } = *here else { return None };
    let of_line = |(line, text): (usize, &str)| {
        let (column, found) = odd_blank_in(text)?;
        Some((SourcePlace::File { line: line + 1, column: column + 1 }, found))
    };
    text.lines().enumerate().take(last).filter_map(of_line).last()
}

/// Returns the first such blank of a text, and its place.
fn odd_blank_in(text: &str) -> Option<(usize, String)> {
    let is_odd = |letter: &char| letter.is_whitespace() && !letter.is_ascii_whitespace();
    let (place, letter) = text.chars().enumerate().find(|(_, letter)| is_odd(letter))?;
    let name = if letter == '\u{a0}' { "a no-break space" } else { "a blank" };
    Some((place, format!("{name} (U+{:04X})", u32::from(letter))))
}

/// Returns the path of the name at this place, in a file where a name occurs twice.
fn path_of_second(text: &str, here: &SourcePlace) -> Option<String> {
    fn search(raw: &Raw, here: &SourcePlace, path: &mut Vec<String>) -> bool {
        match raw {
            Raw::Fields(fields) => fields.iter().any(|(name, value)| {
                path.push(name.value.clone());
                let found = place(name.referenced) == *here || search(&value.value, here, path);
                if !found {
                    path.pop();
                }
                found
            }),
            Raw::List(entries) => entries.iter().enumerate().any(|(index, entry)| {
                path.push(index.to_string());
                let found = search(&entry.value, here, path);
                if !found {
                    path.pop();
                }
                found
            }),
            _ => false,
        }
    }
    let tree = raw(text, DuplicateKeyPolicy::LastWins).ok()?;
    let mut path = Vec::new();
    search(&tree.value, here, &mut path).then(|| path.join("."))
}
