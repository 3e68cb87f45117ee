//! Parameters of a scenario, each with the fields that it sets.

use kingpost_derive::fields;
use serde::{Serialize, Serializer};
use serde_json::{Number, Value};

use super::Name;
use crate::scenario::reading::{FromNode, ReadFault};
use crate::scenario::tree::ScenarioNode;
use crate::scenario::wording::PARAMETER_VALUE;
use crate::scenario::writing::ToValue;

/// A parameter that a user can change. Command line, Python and the app set the fields in `writes` by its name.
#[fields]
pub struct Parameter {
    /// The name by which it is set; it may not be the name of a field at the top of the file.
    pub name: Name,
    /// The label that views show; without it, the name.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub label: String,
    /// Unit, for display.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub unit: String,
    /// The default value; without it, the value of the first field in `writes`.
    pub default: Option<ParameterValue>,
    /// Least and largest value of a number.
    pub range: Option<[f64; 2]>,
    /// The texts allowed.
    pub choices: Option<Vec<String>>,
    /// Whether it can change during a run; if not, it takes effect at the next reset.
    #[serde(default)]
    pub live: bool,
    /// The fields that it sets, as dotted paths: `bodies.ship.mass_kg`.
    pub writes: Vec<String>,
}

impl Parameter {
    /// The text that views show: the label, or the name if there is none.
    pub fn shown(&self) -> &str {
        if self.label.is_empty() { &self.name } else { &self.label }
    }
}

/// Kind of control that a parameter is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum ParameterKind {
    /// True or false.
    Boolean,
    /// A number.
    Number,
    /// One of several texts.
    Choice,
}

/// A value of a parameter.
#[derive(Clone, Debug, PartialEq)]
pub enum ParameterValue {
    /// True or false.
    Boolean(bool),
    /// A number.
    Number(f64),
    /// One of the choices.
    Text(String),
}

impl ParameterValue {
    /// The kind of control that sets a value like this.
    pub fn kind(&self) -> ParameterKind {
        match self {
            Self::Boolean(_) => ParameterKind::Boolean,
            Self::Number(_) => ParameterKind::Number,
            Self::Text(_) => ParameterKind::Choice,
        }
    }
}

impl ToValue for ParameterValue {
    fn to_value(&self) -> Value {
        match self {
            Self::Boolean(value) => Value::Bool(*value),
            Self::Number(value) => Number::from_f64(*value).map_or(Value::Null, Value::Number),
            Self::Text(value) => Value::String(value.clone()),
        }
    }
}

impl Serialize for ParameterValue {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Boolean(value) => serializer.serialize_bool(*value),
            Self::Number(value) => serializer.serialize_f64(*value),
            Self::Text(value) => serializer.serialize_str(value),
        }
    }
}

impl FromNode for ParameterValue {
    fn read(node: &ScenarioNode) -> Result<Self, ReadFault> {
        let boolean = || bool::read(node).map(Self::Boolean);
        let number = |_| f64::read(node).map(Self::Number);
        let text = |_| String::read(node).map(Self::Text);
        boolean().or_else(number).or_else(text).map_err(|_| ReadFault::at(node, PARAMETER_VALUE))
    }
    fn allowed() -> String {
        PARAMETER_VALUE.to_owned()
    }
}

#[cfg(feature = "schema")]
impl schemars::JsonSchema for ParameterValue {
    fn inline_schema() -> bool {
        true
    }
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "ParameterValue".into()
    }
    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({"type": ["boolean", "number", "string"]})
    }
}
