//! Texts with a fixed form: names, colours and the version of the file format.

use std::borrow::Borrow;
use std::fmt;
use std::ops::Deref;

use serde::Serialize;
use serde_json::Value;

use super::reading::{FileKind, FromName, FromNode, ReadFault, TextKind, TextVisitor, visit_text};
use super::tree::ScenarioNode;
use super::wording::{COLOUR, COORDINATE_NAME, NAME, SIGNAL_NAME, TEXT, VERSION};
use super::writing::ToValue;

/// Name of the inertial frame; a body cannot have it.
pub const WORLD: &str = "world";

macro_rules! formed_text {
    ($(#[$doc:meta])* $name:ident, $allowed:expr, $test:ident, $kind:expr, $schema:tt) => {
        $(#[$doc])*
        #[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize)]
        #[serde(transparent)]
        pub struct $name(String);

        impl $name {
            /// Creates the text; `None` if it does not have the form.
            pub fn new(text: impl Into<String>) -> Option<Self> {
                let text = text.into();
                $test(&text).then_some(Self(text))
            }

            /// Returns the text.
            pub fn as_str(&self) -> &str {
                &self.0
            }
        }

        impl Deref for $name {
            type Target = str;
            fn deref(&self) -> &str {
                &self.0
            }
        }

        impl Borrow<str> for $name {
            fn borrow(&self) -> &str {
                &self.0
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                self.0.fmt(f)
            }
        }

        impl PartialEq<str> for $name {
            fn eq(&self, other: &str) -> bool {
                self.0 == other
            }
        }

        impl PartialEq<&str> for $name {
            fn eq(&self, other: &&str) -> bool {
                self.0 == *other
            }
        }

        impl FromNode for $name {
            fn read(node: &ScenarioNode) -> Result<Self, ReadFault> {
                let text = String::read(node).ok().filter(|text| $test(text));
                text.map(Self).ok_or_else(|| ReadFault::at(node, $allowed))
            }
            fn allowed() -> String {
                $allowed.to_owned()
            }
            fn visit_texts(node: &mut ScenarioNode, visit: &mut TextVisitor<'_>) {
                let kind: Option<TextKind> = $kind;
                if let Some(kind) = kind {
                    visit_text(node, kind, visit);
                }
            }
            fn text_at(path: &[&str]) -> Option<TextKind> {
                if path.is_empty() { $kind } else { None }
            }
        }

        impl ToValue for $name {
            fn to_value(&self) -> Value {
                Value::String(self.0.clone())
            }
        }

        #[cfg(feature = "schema")]
        impl schemars::JsonSchema for $name {
            fn inline_schema() -> bool {
                true
            }
            fn schema_name() -> std::borrow::Cow<'static, str> {
                stringify!($name).into()
            }
            fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
                schemars::json_schema!($schema)
            }
        }
    };
}

fn is_name(text: &str) -> bool {
    text.starts_with(|c: char| c.is_ascii_lowercase())
        && text.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_')
}

fn is_coordinate_name(text: &str) -> bool {
    text.split_once('.').map_or(is_name(text), |(joint, axis)| is_name(joint) && is_name(axis))
}

fn is_signal_name(text: &str) -> bool {
    text.split('.').count() <= 3 && text.split('.').all(is_name)
}

const fn is_any(_: &str) -> bool {
    true
}

fn is_colour(text: &str) -> bool {
    text.strip_prefix('#').is_some_and(|hex| hex.len() == 6 && hex.chars().all(|c| c.is_ascii_hexdigit()))
}

formed_text!(
    /// A name of a body, joint, point, force, drive or parameter: `[a-z][a-z0-9_]*`.
    Name, NAME, is_name, Some(TextKind::Reference), {"type": "string", "pattern": "^[a-z][a-z0-9_]*$"}
);
formed_text!(
    /// A name that is unique beside another one only, as a point of a body: `[a-z][a-z0-9_]*`.
    LocalName, NAME, is_name, None, {"type": "string", "pattern": "^[a-z][a-z0-9_]*$"}
);
formed_text!(
    /// A name of a joint of one axis, or of an axis of a joint: `slew`, `hook.first`.
    CoordinateName, COORDINATE_NAME, is_coordinate_name, Some(TextKind::Reference),
    {"type": "string", "pattern": "^[a-z][a-z0-9_]*(\\.[a-z][a-z0-9_]*)?$"}
);
formed_text!(
    /// A name of an input or of a column of the results: `winch`, `mru.measured_angular_velocity.x`.
    SignalName, SIGNAL_NAME, is_signal_name, Some(TextKind::Reference),
    {"type": "string", "pattern": "^[a-z][a-z0-9_]*(\\.[a-z][a-z0-9_]*){0,2}$"}
);
formed_text!(
    /// A colour as `#rrggbb`.
    Colour, COLOUR, is_colour, None, {"type": "string", "pattern": "^#[0-9a-fA-F]{6}$"}
);
formed_text!(
    /// A column of the results: `hull.roll`.
    ColumnName, TEXT, is_any, Some(TextKind::Reference), {"type": "string"}
);
formed_text!(
    /// A hydrodynamic database beside the scenario or in the gallery, by its path.
    DatabasePath, TEXT, is_any, Some(TextKind::File(FileKind::Database)), {"type": "string"}
);
formed_text!(
    /// A record of the sea's elevation, by its path.
    RecordPath, TEXT, is_any, Some(TextKind::File(FileKind::ElevationRecord)), {"type": "string"}
);
formed_text!(
    /// A file of displacement RAOs, by its path.
    RaosPath, TEXT, is_any, Some(TextKind::File(FileKind::Raos)), {"type": "string"}
);
formed_text!(
    /// A file that its kind reads, by its path.
    FilePath, TEXT, is_any, Some(TextKind::File(FileKind::Text)), {"type": "string"}
);

impl FromName for Name {
    fn from_name(name: &str) -> Result<Self, &'static str> {
        Self::new(name).ok_or(NAME)
    }
}

impl Name {
    /// Returns the name of the inertial frame.
    pub fn world() -> Self {
        Self(WORLD.to_owned())
    }
}

/// The version of the file format; 1 is the only one so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Version;

impl ToValue for Version {
    fn to_value(&self) -> Value {
        Value::from(1)
    }
}

impl Serialize for Version {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_u64(1)
    }
}

impl FromNode for Version {
    fn read(node: &ScenarioNode) -> Result<Self, ReadFault> {
        match f64::read(node) {
            Ok(1.0) => Ok(Self),
            _ => Err(ReadFault::at(node, VERSION)),
        }
    }
    fn allowed() -> String {
        VERSION.to_owned()
    }
}

#[cfg(feature = "schema")]
impl schemars::JsonSchema for Version {
    fn inline_schema() -> bool {
        true
    }
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Version".into()
    }
    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({"const": 1})
    }
}
