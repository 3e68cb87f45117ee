//! Tree of a scenario's text: every value with its place.

use indexmap::IndexMap;
use serde_json::Value;

use super::error::SourcePlace;

/// A value, its place, and how it was written.
#[derive(Clone, Debug)]
pub(crate) struct ScenarioNode {
    pub(crate) place: SourcePlace,
    pub(crate) content: Content,
    /// The number as written, if it was written in another unit.
    pub(crate) written: Option<Value>,
}

/// The content of a node.
#[derive(Clone, Debug)]
pub(crate) enum Content {
    /// Null, a boolean, a number or a text.
    Scalar(Value),
    /// Entries by index.
    List(Vec<ScenarioNode>),
    /// Fields by name.
    Fields(IndexMap<String, Field>),
}

/// A field of a node.
#[derive(Clone, Debug)]
pub(crate) struct Field {
    pub(crate) name_place: SourcePlace,
    /// The name as written, if it was written with another unit.
    pub(crate) written: Option<String>,
    pub(crate) node: ScenarioNode,
}

impl ScenarioNode {
    pub(crate) fn new(place: SourcePlace, content: Content) -> Self {
        Self { place, content, written: None }
    }

    /// Returns the tree of a value whose parts all come from one place.
    pub(crate) fn from_value(value: &Value, place: &SourcePlace) -> Self {
        let content = match value {
            Value::Array(entries) => {
                Content::List(entries.iter().map(|entry| Self::from_value(entry, place)).collect())
            }
            Value::Object(fields) => Content::Fields(
                fields
                    .iter()
                    .map(|(name, value)| (name.clone(), Field::new(place.clone(), Self::from_value(value, place))))
                    .collect(),
            ),
            scalar => Content::Scalar(scalar.clone()),
        };
        Self::new(place.clone(), content)
    }

    /// Returns the value without places.
    pub(crate) fn to_value(&self) -> Value {
        match &self.content {
            Content::Scalar(value) => value.clone(),
            Content::List(entries) => entries.iter().map(Self::to_value).collect(),
            Content::Fields(fields) => {
                Value::Object(fields.iter().map(|(name, field)| (name.clone(), field.node.to_value())).collect())
            }
        }
    }

    /// Returns the value as written, for an error.
    pub(crate) fn written_value(&self) -> Value {
        self.written.clone().unwrap_or_else(|| self.to_value())
    }

    /// Returns the field with this name.
    pub(crate) fn field(&self, name: &str) -> Option<&Field> {
        match &self.content {
            Content::Fields(fields) => fields.get(name),
            _ => None,
        }
    }

    /// Returns the names of the fields.
    pub(crate) fn names(&self) -> Vec<&str> {
        match &self.content {
            Content::Fields(fields) => fields.keys().map(String::as_str).collect(),
            _ => Vec::new(),
        }
    }

    fn child(&self, segment: &str) -> Option<&Self> {
        match &self.content {
            Content::Scalar(_) => None,
            Content::List(entries) => entries.get(segment.parse::<usize>().ok()?),
            Content::Fields(fields) => fields.get(segment).map(|field| &field.node),
        }
    }

    /// Returns the node at a path, if it exists.
    pub(crate) fn at(&self, path: &[String]) -> Option<&Self> {
        path.iter().try_fold(self, |node, segment| node.child(segment))
    }

    /// Returns the place of the node at a path; if it does not exist, the place of its nearest ancestor.
    pub(crate) fn place_of(&self, path: &[String]) -> SourcePlace {
        let mut node = self;
        for segment in path {
            match node.child(segment) {
                Some(child) => node = child,
                None => break,
            }
        }
        node.place.clone()
    }

    /// Returns the place of the field's name at a path, to report a field that is not allowed.
    pub(crate) fn name_place_of(&self, path: &[String]) -> SourcePlace {
        let field = path.split_last().and_then(|(last, parents)| self.at(parents)?.field(last));
        field.map_or_else(|| self.place_of(path), |field| field.name_place.clone())
    }
}

impl Field {
    pub(crate) fn new(name_place: SourcePlace, node: ScenarioNode) -> Self {
        Self { name_place, written: None, node }
    }
}

/// Returns the segments of a dotted path.
pub(crate) fn segments(path: &str) -> Vec<String> {
    path.split('.').map(str::to_owned).collect()
}

/// Returns the value at a path.
pub(crate) fn value_at<'a>(value: &'a Value, path: &[String]) -> Option<&'a Value> {
    path.iter().try_fold(value, |value, segment| value_child(value, segment))
}

/// Returns the value at a segment below this one.
pub(crate) fn value_child<'a>(value: &'a Value, segment: &str) -> Option<&'a Value> {
    match value {
        Value::Array(entries) => entries.get(segment.parse::<usize>().ok()?),
        Value::Object(fields) => fields.get(segment),
        _ => None,
    }
}
