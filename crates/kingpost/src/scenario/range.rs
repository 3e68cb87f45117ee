//! Numbers with a range: one type for each range, so that the reader, the JSON Schema and the engine agree on
//! the allowed values.

use std::fmt;
use std::ops::Deref;

use serde::Serialize;
use serde_json::Value;

use super::leaf::Leaf;
use super::over::{Numbers, OverScalar};
use super::reading::{FromNode, ReadFault};
use super::tree::ScenarioNode;
use super::wording::{DIRECTION, FRACTION, NON_NEGATIVE, POSITIVE, PROBABILITY};
use super::writing::ToValue;

macro_rules! ranged_number {
    ($(#[$doc:meta])* $name:ident, $allowed:expr, $test:expr, $schema:tt) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, PartialOrd, Serialize)]
        #[serde(transparent)]
        pub struct $name<S = f64>(S);

        impl<S: Leaf> $name<S> {
            /// Creates the value; `None` if it is outside the range or not finite.
            pub fn new(value: S) -> Option<Self> {
                value.outside(Self::inside).is_none().then_some(Self(value))
            }

            fn inside(value: f64) -> bool {
                let inside: fn(f64) -> bool = $test;
                value.is_finite() && inside(value)
            }

            /// Returns the number.
            pub fn get(self) -> S {
                self.0
            }

            /// Creates a default value from a literal in the source code.
            pub(crate) fn literal(value: f64) -> Self {
                assert!(Self::inside(value));
                Self(S::literal(value))
            }
        }

        impl Deref for $name {
            type Target = f64;
            fn deref(&self) -> &f64 {
                &self.0
            }
        }

        impl From<$name> for f64 {
            fn from(value: $name) -> f64 {
                value.0
            }
        }

        impl<S> OverScalar<S> for $name {
            type Over = $name<S>;
            fn over(&self, numbers: &mut dyn Numbers<S>) -> $name<S> {
                $name(self.0.over(numbers))
            }
        }

        impl<S: fmt::Display> fmt::Display for $name<S> {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                self.0.fmt(f)
            }
        }

        impl FromNode for $name {
            fn read(node: &ScenarioNode) -> Result<Self, ReadFault> {
                let number = f64::read(node).ok().filter(|number| Self::inside(*number));
                number.map(Self).ok_or_else(|| ReadFault::at(node, $allowed))
            }
            fn allowed() -> String {
                $allowed.to_owned()
            }
        }

        impl<S: ToValue> ToValue for $name<S> {
            fn to_value(&self) -> Value {
                self.0.to_value()
            }
        }

        #[cfg(feature = "schema")]
        impl<S> schemars::JsonSchema for $name<S> {
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

ranged_number!(
    /// A finite number greater than 0.
    Positive, POSITIVE, |x| x > 0.0, {"type": "number", "exclusiveMinimum": 0}
);
ranged_number!(
    /// A finite number not less than 0.
    NonNegative, NON_NEGATIVE, |x| x >= 0.0, {"type": "number", "minimum": 0}
);
ranged_number!(
    /// A number from 0 to 1.
    Fraction, FRACTION, |x| (0.0..=1.0).contains(&x), {"type": "number", "minimum": 0, "maximum": 1}
);
ranged_number!(
    /// A number between 0 and 1, neither included.
    Probability, PROBABILITY, |x| 0.0 < x && x < 1.0, {"type": "number", "exclusiveMinimum": 0, "exclusiveMaximum": 1}
);

/// 0, the default of every leaf.
impl<S: Default> Default for NonNegative<S> {
    fn default() -> Self {
        Self(S::default())
    }
}

/// A vector of any non-zero length, as written in the file; only its direction is used.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(transparent)]
pub struct Direction<S = f64>([S; 3]);

impl<S: Leaf> Direction<S> {
    /// Creates the direction; `None` if all components are 0 or one is not finite.
    pub fn new(components: [S; 3]) -> Option<Self> {
        let finite = components.iter().all(|component| component.outside(f64::is_finite).is_none());
        let directed = components.iter().any(|component| component.outside(|c| c != 0.0).is_none());
        (finite && directed).then_some(Self(components))
    }

    /// Creates a default value from a literal in the source code.
    pub(crate) fn literal(components: [f64; 3]) -> Self {
        assert!(components.iter().any(|component| *component != 0.0));
        Self(components.map(S::literal))
    }

    /// Returns the components as written, not normalised.
    pub fn get(self) -> [S; 3] {
        self.0
    }
}

impl Direction {
    /// Returns the unit vector. The components are first divided by the largest one, so that the length does
    /// not overflow.
    pub fn unit(self) -> [f64; 3] {
        let largest = self.0.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        let [x, y, z] = self.0.map(|c| c / largest);
        let length = libm::sqrt(x * x + y * y + z * z);
        [x / length, y / length, z / length]
    }
}

impl<S> OverScalar<S> for Direction {
    type Over = Direction<S>;
    fn over(&self, numbers: &mut dyn Numbers<S>) -> Direction<S> {
        Direction(self.0.over(numbers))
    }
}

impl FromNode for Direction {
    fn read(node: &ScenarioNode) -> Result<Self, ReadFault> {
        Self::new(<[f64; 3]>::read(node)?).ok_or_else(|| ReadFault::at(node, DIRECTION))
    }
    fn allowed() -> String {
        <[f64; 3]>::allowed()
    }
}

impl<S: ToValue> ToValue for Direction<S> {
    fn to_value(&self) -> Value {
        self.0.to_value()
    }
}

#[cfg(feature = "schema")]
impl<S> schemars::JsonSchema for Direction<S> {
    fn inline_schema() -> bool {
        true
    }
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Direction".into()
    }
    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3})
    }
}
