//! The names of the fields at the top of a scenario, from its type.

use super::Scenario;
use core::cell::Cell;
use serde::de::value::Error;
use serde::de::{Deserialize, Deserializer, Error as _, Visitor};
use serde::forward_to_deserialize_any;

/// Whether a name is a field at the top of a scenario: no parameter may have it.
pub fn is_top_field(name: &str) -> bool {
    let asked = Cell::new([].as_slice());
    // Nothing is read: when serde asks for a struct, it notes the names of the fields.
    let nothing = Scenario::<f64>::deserialize(FieldNames(&asked));
    nothing.is_err() && asked.get().contains(&name)
}

/// A deserializer without data, which notes the names of the fields that serde asks for.
struct FieldNames<'a>(&'a Cell<&'static [&'static str]>);

impl<'de> Deserializer<'de> for FieldNames<'_> {
    type Error = Error;

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _name: &'static str,
        fields: &'static [&'static str],
        _visitor: V,
    ) -> Result<V::Value, Error> {
        self.0.set(fields);
        Err(Error::custom("nothing to read"))
    }

    fn deserialize_any<V: Visitor<'de>>(self, _visitor: V) -> Result<V::Value, Error> {
        Err(Error::custom("nothing to read"))
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit unit_struct
        newtype_struct seq tuple tuple_struct map enum identifier ignored_any
    }
}

#[cfg(test)]
mod tests {
    use super::is_top_field;

    #[test]
    fn every_field_of_the_scenario_is_known_and_no_other_name() {
        for name in [
            "version",
            "title",
            "description",
            "parameters",
            "simulation",
            "bodies",
            "loops",
            "sea",
            "wind",
            "forces",
            "drives",
            "sensors",
            "controllers",
            "wires",
            "operation",
            "limits",
        ] {
            assert!(is_top_field(name), "{name}");
        }
        assert!(!is_top_field("files") && !is_top_field("crane_x_m") && !is_top_field(""));
    }
}
