//! Conversion of a file's tree to types. `#[fields]` implements [`FromNode`] for a type with fields or kinds.

use indexmap::IndexMap;
use serde_json::Value;
use std::hash::Hash;

use super::error::{Fault, SourcePlace};
use super::tree::{Content, Field, ScenarioNode};
use super::wording;

/// A type that is read from a node of a file's tree.
pub(crate) trait FromNode: Sized {
    /// Reads the value of a node.
    fn read(node: &ScenarioNode) -> Result<Self, ReadFault>;

    /// Returns the allowed form, as text for an error.
    fn allowed() -> String;

    /// Returns the value of an omitted field; `None` if the field is required.
    fn absent() -> Option<Self> {
        None
    }

    /// Returns the fields of the type, or the kinds of an enum that have fields.
    fn declared_fields() -> &'static [DeclaredField] {
        &[]
    }

    /// Visits the texts in a node that name other entries or files.
    fn visit_texts(node: &mut ScenarioNode, visit: &mut TextVisitor<'_>) {
        visit_fields(Self::declared_fields(), node, visit);
    }

    /// Returns the kind of the text at a path; `None` if no such text is there.
    fn text_at(path: &[&str]) -> Option<TextKind> {
        let (first, rest) = path.split_first()?;
        let field = Self::declared_fields().iter().find(|field| field.name == *first)?;
        (field.text_at)(rest)
    }
}

/// A visitor of texts.
pub(crate) type TextVisitor<'a> = dyn FnMut(TextKind, &mut String) + 'a;

/// A field in files, or a kind with its fields, and the functions of its type.
pub(crate) struct DeclaredField {
    pub(crate) name: &'static str,
    /// Its kind of place in the world.
    pub(crate) placed: Option<PlaceKind>,
    /// Returns the fields of its type.
    pub(crate) fields: fn() -> &'static [DeclaredField],
    visit_texts: fn(&mut ScenarioNode, &mut TextVisitor<'_>),
    text_at: fn(&[&str]) -> Option<TextKind>,
}

impl DeclaredField {
    pub(crate) const fn of<T: FromNode>(name: &'static str, placed: Option<PlaceKind>) -> Self {
        Self { name, placed, fields: T::declared_fields, visit_texts: T::visit_texts, text_at: T::text_at }
    }
}

/// A text that changes when a part is mounted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TextKind {
    /// Name of another entry of the scenario, or of an entry's axis, input or column.
    Reference,
    /// Path of a file with this content.
    File(FileKind),
}

/// Content of a file that a scenario names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FileKind {
    /// A hydrodynamic database.
    Database,
    /// A record of the sea's elevation.
    ElevationRecord,
    /// Displacement RAOs.
    Raos,
    /// A text whose format the kind of its entry defines.
    Text,
}

/// A position in the world that is given without a body: the mounting of a part moves it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PlaceKind {
    /// A point: x, y, z.
    Point,
    /// A place on the water and a heading: `x_m`, `y_m`, `heading_rad`.
    Station,
}

/// Type of the names in a map.
pub(crate) trait FromName: Sized + Eq + Hash {
    /// Reads a name.
    ///
    /// # Errors
    /// What is allowed.
    fn from_name(name: &str) -> Result<Self, &'static str>;
}

/// An error at a node. On return from nested fields, each one adds its segment in front of the path.
#[derive(Debug)]
pub(crate) struct ReadFault {
    place: SourcePlace,
    path: Vec<String>,
    found: String,
    allowed: String,
}

impl ReadFault {
    fn new(place: &SourcePlace, found: impl Into<String>, allowed: impl Into<String>) -> Self {
        Self { place: place.clone(), path: Vec::new(), found: found.into(), allowed: allowed.into() }
    }

    /// Returns the error for a value that is not allowed.
    pub(crate) fn at(node: &ScenarioNode, allowed: impl Into<String>) -> Self {
        Self::new(&node.place, wording::found(&node.written_value()), allowed)
    }

    /// Adds a field or an entry in front of the path.
    pub(crate) fn within(mut self, segment: impl Into<String>) -> Self {
        self.path.push(segment.into());
        self
    }
}

impl From<ReadFault> for Fault {
    fn from(fault: ReadFault) -> Self {
        let ReadFault { place, mut path, found, allowed } = fault;
        path.reverse();
        Self::new(&place, path.join("."), found, allowed)
    }
}

/// Checks the version before anything else: another version may have other fields.
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

/// Reads a typed value from the tree of a file. The error holds the place of the first fault.
pub(super) fn read<T: FromNode>(tree: &ScenarioNode) -> Result<T, Fault> {
    Ok(T::read(tree)?)
}

/// Returns the fields of a node.
pub(crate) fn fields(node: &ScenarioNode) -> Result<&IndexMap<String, Field>, ReadFault> {
    match &node.content {
        Content::Fields(fields) => Ok(fields),
        _ => Err(ReadFault::at(node, wording::FIELDS)),
    }
}

/// Returns the error for a field that its type does not have.
pub(crate) fn unknown(name: &str, field: &Field, declared: &[DeclaredField]) -> ReadFault {
    let written = field.written.as_deref().unwrap_or(name);
    let known: Vec<&str> = declared.iter().map(|field| field.name).collect();
    let allowed = wording::one_of_with_hint(&known, written);
    ReadFault::new(&field.name_place, wording::UNKNOWN_FIELD, allowed).within(written)
}

/// Reads a field.
pub(crate) fn field<T: FromNode>(name: &str, field: &Field) -> Result<T, ReadFault> {
    T::read(&field.node).map_err(|fault| fault.within(field.written.as_deref().unwrap_or(name)))
}

/// Reads an optional field that is present; null is refused.
pub(crate) fn present<T: FromNode>(name: &str, of: &Field) -> Result<Option<T>, ReadFault> {
    field(name, of).map(Some)
}

/// Returns the value of a field; if it is omitted, its default.
pub(crate) fn or_absent<T: FromNode>(read: Option<T>, name: &str, node: &ScenarioNode) -> Result<T, ReadFault> {
    read.or_else(T::absent).ok_or_else(|| ReadFault::new(&node.place, wording::NOTHING, T::allowed()).within(name))
}

/// Returns the name of a kind, and its field if the kind is written with fields.
pub(crate) fn kind<'a>(node: &'a ScenarioNode, kinds: &[&str]) -> Result<(&'a str, Option<&'a Field>), ReadFault> {
    let known = |name: &str, found: String| match kinds.contains(&name) {
        true => Ok(()),
        false => Err(ReadFault::new(&node.place, found, wording::one_of_with_hint(kinds, name))),
    };
    match &node.content {
        Content::Scalar(Value::String(name)) => {
            known(name, wording::found(&node.written_value()))?;
            Ok((name, None))
        }
        Content::Fields(fields) if fields.len() == 1 => {
            let (name, field) = fields.first().ok_or_else(|| ReadFault::at(node, wording::one_of(kinds)))?;
            known(name, wording::quoted(name))?;
            Ok((name, Some(field)))
        }
        _ => Err(ReadFault::at(node, wording::one_of(kinds))),
    }
}

/// Visits the texts in the fields that are written.
fn visit_fields(known: &[DeclaredField], node: &mut ScenarioNode, visit: &mut TextVisitor<'_>) {
    let Content::Fields(fields) = &mut node.content else { return };
    for field in known {
        if let Some(of) = fields.get_mut(field.name) {
            (field.visit_texts)(&mut of.node, visit);
        }
    }
}

/// Visits the texts in the entries of a list.
fn visit_entries<T: FromNode>(node: &mut ScenarioNode, visit: &mut TextVisitor<'_>) {
    if let Content::List(entries) = &mut node.content {
        entries.iter_mut().for_each(|entry| T::visit_texts(entry, visit));
    }
}

/// Visits the text of a scalar.
pub(crate) fn visit_text(node: &mut ScenarioNode, kind: TextKind, visit: &mut TextVisitor<'_>) {
    if let Content::Scalar(Value::String(text)) = &mut node.content {
        visit(kind, text);
    }
}

/// Reads the fields of a kind with fields.
pub(crate) fn kind_with_fields<T: FromNode>(
    node: &ScenarioNode,
    name: &str,
    of: Option<&Field>,
) -> Result<T, ReadFault> {
    match of {
        Some(of) => field(name, of),
        None => Err(ReadFault::at(node, wording::with_fields(name))),
    }
}

/// Checks that a kind without fields has none.
pub(crate) fn kind_without_fields(node: &ScenarioNode, name: &str, of: Option<&Field>) -> Result<(), ReadFault> {
    match of.map(|field| &field.node.content) {
        None | Some(Content::Scalar(Value::Null)) => Ok(()),
        Some(_) => Err(ReadFault::at(node, wording::without_fields(name))),
    }
}

impl FromNode for f64 {
    fn read(node: &ScenarioNode) -> Result<Self, ReadFault> {
        match &node.content {
            Content::Scalar(value) => value.as_f64().ok_or_else(|| ReadFault::at(node, wording::NUMBER)),
            _ => Err(ReadFault::at(node, wording::NUMBER)),
        }
    }
    fn allowed() -> String {
        wording::NUMBER.to_owned()
    }
}

impl FromNode for bool {
    fn read(node: &ScenarioNode) -> Result<Self, ReadFault> {
        match &node.content {
            Content::Scalar(Value::Bool(value)) => Ok(*value),
            _ => Err(ReadFault::at(node, wording::BOOLEAN)),
        }
    }
    fn allowed() -> String {
        wording::BOOLEAN.to_owned()
    }
}

impl FromNode for String {
    fn read(node: &ScenarioNode) -> Result<Self, ReadFault> {
        match &node.content {
            Content::Scalar(Value::String(text)) => Ok(text.clone()),
            _ => Err(ReadFault::at(node, wording::TEXT)),
        }
    }
    fn allowed() -> String {
        wording::TEXT.to_owned()
    }
}

macro_rules! whole_number {
    ($($type:ty),*) => {$(
        impl FromNode for $type {
            fn read(node: &ScenarioNode) -> Result<Self, ReadFault> {
                let Content::Scalar(value) = &node.content else { return Err(ReadFault::at(node, wording::WHOLE)) };
                let whole = value.as_u64().and_then(|whole| whole.try_into().ok());
                whole.ok_or_else(|| ReadFault::at(node, wording::WHOLE))
            }
            fn allowed() -> String {
                wording::WHOLE.to_owned()
            }
        }
    )*};
}

whole_number!(u32, u64, usize);

/// Any value.
impl FromNode for Value {
    fn read(node: &ScenarioNode) -> Result<Self, ReadFault> {
        Ok(node.to_value())
    }
    fn allowed() -> String {
        wording::REQUIRED.to_owned()
    }
}

impl<T: FromNode> FromNode for Option<T> {
    fn read(node: &ScenarioNode) -> Result<Self, ReadFault> {
        match node.content {
            Content::Scalar(Value::Null) if node.written.is_none() => Ok(None),
            _ => T::read(node).map(Some),
        }
    }
    fn allowed() -> String {
        T::allowed()
    }
    fn absent() -> Option<Self> {
        Some(None)
    }
    fn visit_texts(node: &mut ScenarioNode, visit: &mut TextVisitor<'_>) {
        T::visit_texts(node, visit);
    }
    fn text_at(path: &[&str]) -> Option<TextKind> {
        T::text_at(path)
    }
}

impl<T: FromNode> FromNode for Box<T> {
    fn read(node: &ScenarioNode) -> Result<Self, ReadFault> {
        T::read(node).map(Self::new)
    }
    fn declared_fields() -> &'static [DeclaredField] {
        T::declared_fields()
    }
    fn allowed() -> String {
        T::allowed()
    }
    fn visit_texts(node: &mut ScenarioNode, visit: &mut TextVisitor<'_>) {
        T::visit_texts(node, visit);
    }
    fn text_at(path: &[&str]) -> Option<TextKind> {
        T::text_at(path)
    }
}

/// Returns the entries of a list.
fn entries<'a>(node: &'a ScenarioNode, allowed: &str) -> Result<&'a [ScenarioNode], ReadFault> {
    match &node.content {
        Content::List(entries) => Ok(entries),
        _ => Err(ReadFault::at(node, allowed)),
    }
}

fn entry<T: FromNode>((k, node): (usize, &ScenarioNode)) -> Result<T, ReadFault> {
    T::read(node).map_err(|fault| fault.within(k.to_string()))
}

impl<T: FromNode> FromNode for Vec<T> {
    fn read(node: &ScenarioNode) -> Result<Self, ReadFault> {
        entries(node, wording::LIST)?.iter().enumerate().map(entry).collect()
    }
    fn allowed() -> String {
        wording::LIST.to_owned()
    }
    fn visit_texts(node: &mut ScenarioNode, visit: &mut TextVisitor<'_>) {
        visit_entries::<T>(node, visit);
    }
    fn text_at(path: &[&str]) -> Option<TextKind> {
        T::text_at(path.get(1..)?)
    }
}

impl<T: FromNode, const N: usize> FromNode for [T; N] {
    fn read(node: &ScenarioNode) -> Result<Self, ReadFault> {
        let allowed = Self::allowed();
        let all = entries(node, &allowed)?;
        let read: Vec<T> = all.iter().take(N).enumerate().map(entry).collect::<Result<_, _>>()?;
        match read.try_into() {
            Ok(read) if all.len() == N => Ok(read),
            _ => Err(ReadFault::at(node, allowed)),
        }
    }
    fn allowed() -> String {
        wording::list_of_numbers(N)
    }
    fn visit_texts(node: &mut ScenarioNode, visit: &mut TextVisitor<'_>) {
        visit_entries::<T>(node, visit);
    }
    fn text_at(path: &[&str]) -> Option<TextKind> {
        T::text_at(path.get(1..)?)
    }
}

impl<K: FromName, T: FromNode> FromNode for IndexMap<K, T> {
    fn read(node: &ScenarioNode) -> Result<Self, ReadFault> {
        let entry = |(name, of): (&String, &Field)| {
            let written = of.written.as_ref().unwrap_or(name);
            let wrong = |allowed| ReadFault::new(&of.name_place, wording::quoted(name), allowed).within(written);
            Ok((K::from_name(name).map_err(wrong)?, field(name, of)?))
        };
        fields(node)?.iter().map(entry).collect()
    }
    fn allowed() -> String {
        wording::FIELDS.to_owned()
    }
    fn visit_texts(node: &mut ScenarioNode, visit: &mut TextVisitor<'_>) {
        if let Content::Fields(fields) = &mut node.content {
            fields.values_mut().for_each(|field| T::visit_texts(&mut field.node, visit));
        }
    }
    fn text_at(path: &[&str]) -> Option<TextKind> {
        T::text_at(path.get(1..)?)
    }
}

impl FromName for String {
    fn from_name(name: &str) -> Result<Self, &'static str> {
        Ok(name.to_owned())
    }
}
