//! Conversion of the types of a file to values. `#[fields]` implements [`ToValue`] for a type with fields or
//! kinds.

use std::fmt::Display;

use indexmap::IndexMap;
use serde_json::{Map, Value};

/// A type that can be written to a file. Each type has one function that returns its value; with serde, every
/// type would be compiled once for each serializer.
pub trait ToValue {
    /// Returns the value for a file.
    fn to_value(&self) -> Value;
}

/// Writes a field.
pub(crate) fn field(fields: &mut Map<String, Value>, name: &str, value: &dyn ToValue) {
    fields.insert(name.to_owned(), value.to_value());
}

/// Returns a kind without fields: its name.
pub(crate) fn kind(name: &str) -> Value {
    Value::String(name.to_owned())
}

/// Returns a kind with fields, under its name.
pub(crate) fn kind_with_fields(name: &str, given: &dyn ToValue) -> Value {
    let mut fields = Map::new();
    field(&mut fields, name, given);
    Value::Object(fields)
}

macro_rules! by_serde {
    ($($type:ty),*) => {$(
        impl ToValue for $type {
            fn to_value(&self) -> Value {
                // A plain number, a text or a boolean always has a value.
                serde_json::to_value(self).unwrap_or_default()
            }
        }
    )*};
}

by_serde!(f64, bool, u32, u64, usize, String, Value);

impl<T: ToValue> ToValue for Option<T> {
    fn to_value(&self) -> Value {
        self.as_ref().map_or(Value::Null, T::to_value)
    }
}

impl<T: ToValue> ToValue for Box<T> {
    fn to_value(&self) -> Value {
        (**self).to_value()
    }
}

impl<T: ToValue> ToValue for Vec<T> {
    fn to_value(&self) -> Value {
        entries(&mut self.iter().map(T::to_value))
    }
}

impl<T: ToValue, const N: usize> ToValue for [T; N] {
    fn to_value(&self) -> Value {
        entries(&mut self.iter().map(T::to_value))
    }
}

fn entries(values: &mut dyn Iterator<Item = Value>) -> Value {
    Value::Array(values.collect())
}

impl<K: Display, T: ToValue, H> ToValue for IndexMap<K, T, H> {
    fn to_value(&self) -> Value {
        let mut fields = Map::new();
        for (name, value) in self {
            field(&mut fields, &name.to_string(), value);
        }
        Value::Object(fields)
    }
}
