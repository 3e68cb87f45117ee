//! Values with a range: a type for each, so that the reader, the JSON Schema and the engine agree on what is allowed.

use std::fmt;
use std::ops::Deref;

use serde::de::{Error, Unexpected};
use serde::{Deserialize, Deserializer, Serialize};

use super::wording::{DIRECTION, FRACTION, NON_NEGATIVE, POSITIVE};

macro_rules! ranged_number {
    ($(#[$doc:meta])* $name:ident, $allowed:expr, $test:expr, $schema:tt) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, PartialOrd, Serialize)]
        #[serde(transparent)]
        pub struct $name(f64);

        impl $name {
            /// `None` where the value is outside the range or not finite.
            pub fn new(value: f64) -> Option<Self> {
                let inside: fn(f64) -> bool = $test;
                (value.is_finite() && inside(value)).then_some(Self(value))
            }

            /// The number itself.
            pub const fn get(self) -> f64 {
                self.0
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

        impl<'de> Deserialize<'de> for $name {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                let value = f64::deserialize(deserializer)?;
                Self::new(value).ok_or_else(|| D::Error::invalid_value(Unexpected::Float(value), &$allowed))
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

impl NonNegative {
    /// 0.
    pub const ZERO: Self = Self(0.0);
}

impl Default for NonNegative {
    fn default() -> Self {
        Self::ZERO
    }
}

impl Positive {
    /// For default values: a literal that stands in the source.
    pub(crate) const fn literal(value: f64) -> Self {
        assert!(value > 0.0 && value.is_finite());
        Self(value)
    }
}

impl NonNegative {
    /// For default values: a literal that stands in the source.
    pub(crate) const fn literal(value: f64) -> Self {
        assert!(value >= 0.0 && value.is_finite());
        Self(value)
    }
}

impl Fraction {
    /// For default values: a literal that stands in the source.
    pub(crate) const fn literal(value: f64) -> Self {
        assert!(value >= 0.0 && value <= 1.0);
        Self(value)
    }
}

/// A vector of any non-zero length, as written in the file; only its direction counts.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(transparent)]
pub struct Direction([f64; 3]);

impl Direction {
    /// `None` where the components are all 0 or one is not finite.
    pub fn new(components: [f64; 3]) -> Option<Self> {
        let largest = components.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        (components.iter().all(|x| x.is_finite()) && largest > 0.0).then_some(Self(components))
    }

    /// The components as written; not normalised.
    pub const fn get(self) -> [f64; 3] {
        self.0
    }

    /// The unit vector. Scaled by the largest component first, so that no length overflows.
    pub fn unit(self) -> [f64; 3] {
        let largest = self.0.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        let [x, y, z] = self.0.map(|c| c / largest);
        let length = libm::sqrt(x * x + y * y + z * z);
        [x / length, y / length, z / length]
    }
}

impl<'de> Deserialize<'de> for Direction {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let components = <[f64; 3]>::deserialize(deserializer)?;
        Self::new(components).ok_or_else(|| D::Error::invalid_value(Unexpected::Seq, &DIRECTION))
    }
}

#[cfg(feature = "schema")]
impl schemars::JsonSchema for Direction {
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

impl fmt::Display for Positive {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl fmt::Display for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl fmt::Display for NonNegative {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}
