//! Types of a number in a scenario: a plain number, the numbers of several runs, or a number with
//! derivatives.

use std::fmt::{self, Debug, Display};

use super::error::FieldError;
use crate::scalar::{Dual, LANES, Lanes, Scalar};

/// A continuous number of a scenario. The types of a scenario are generic over it; numbers that determine the
/// structure of a run (steps, seeds, switching times, grids of tables) are plain.
///
/// The numbers of a file are `f64`; [`OverScalar`](super::over::OverScalar) converts them.
pub trait Leaf: Copy + Debug + Default + PartialEq + 'static {
    /// Returns a default value from the source code.
    fn literal(value: f64) -> Self;
    /// Returns the value if it is outside its range.
    fn outside(self, inside: impl Fn(f64) -> bool) -> Option<f64>;
}

/// The scalar of the JSON Schema: the plain number.
#[cfg(feature = "schema")]
pub trait Described: Leaf + super::writing::ToValue + serde::Serialize + schemars::JsonSchema {}

#[cfg(feature = "schema")]
impl Described for f64 {}

/// A scenario number from which a model can be built. The builder computes with all lanes and derivatives:
/// only the functions of this trait return a plain number, and they fail if lanes or derivatives would be
/// lost.
pub trait Quantity: Leaf + Scalar + Display {
    /// Number of scenarios whose values it holds.
    const SCENARIOS: usize;

    /// Creates the value from the number in each scenario, without derivatives.
    fn of_each(number: impl Fn(usize) -> f64) -> Self;

    /// Returns the value if all lanes are equal, and whether it has no derivative.
    fn shared(self) -> (Option<f64>, bool);

    /// Returns the plain number, for quantities that are plain in the engine.
    ///
    /// # Errors
    /// Lanes that differ, or a derivative.
    fn same(self, field: &str) -> Result<f64, FieldError> {
        match self.shared() {
            (Some(value), true) => Ok(value),
            _ => Err(FieldError::new(field, self, ONE_NUMBER)),
        }
    }

    /// Returns the plain number, and a factor of 1 that carries its derivatives: for quantities proportional
    /// to it.
    ///
    /// # Errors
    /// Lanes that differ.
    fn scaled(self, field: &str) -> Result<(f64, Self), FieldError> {
        let value = self.shared().0.ok_or_else(|| FieldError::new(field, self, ONE_NUMBER))?;
        Ok((value, if value == 0.0 { Self::ONE } else { self / Self::constant(value) }))
    }

    /// Returns whether a test holds: the answer must be the same in all lanes.
    ///
    /// # Errors
    /// The test holds in some lanes and not in others.
    fn decides(self, field: &str, test: impl Fn(f64) -> bool) -> Result<bool, FieldError> {
        match (self.all(&test), self.all(|value| !test(value))) {
            (true, _) => Ok(true),
            (_, true) => Ok(false),
            _ => Err(FieldError::new(field, self, ONE_NUMBER)),
        }
    }

    /// Returns whether the value is 0 in all lanes with zero derivatives: then the terms that it multiplies
    /// can be omitted.
    fn vanishes(self) -> bool {
        self.shared() == (Some(0.0), true)
    }
}

/// Allowed form of a number that determines the structure of a run.
const ONE_NUMBER: &str = "one number: it decides the structure of the run";

impl Leaf for f64 {
    fn literal(value: f64) -> Self {
        value
    }
    fn outside(self, inside: impl Fn(f64) -> bool) -> Option<f64> {
        (!inside(self)).then_some(self)
    }
}

impl Quantity for f64 {
    const SCENARIOS: usize = 1;

    fn of_each(number: impl Fn(usize) -> f64) -> Self {
        number(0)
    }
    fn shared(self) -> (Option<f64>, bool) {
        (Some(self), true)
    }
}

impl Leaf for Lanes {
    fn literal(value: f64) -> Self {
        Self::constant(value)
    }
    fn outside(self, inside: impl Fn(f64) -> bool) -> Option<f64> {
        self.to_array().into_iter().find(|value| !inside(*value))
    }
}

impl Quantity for Lanes {
    const SCENARIOS: usize = LANES;

    fn of_each(number: impl Fn(usize) -> f64) -> Self {
        Self::new(core::array::from_fn(number))
    }
    fn shared(self) -> (Option<f64>, bool) {
        let [first, rest @ ..] = self.to_array();
        (rest.iter().all(|value| value.to_bits() == first.to_bits()).then_some(first), true)
    }
}

impl<const N: usize> Leaf for Dual<N> {
    fn literal(value: f64) -> Self {
        Self::constant(value)
    }
    fn outside(self, inside: impl Fn(f64) -> bool) -> Option<f64> {
        (!inside(self.value)).then_some(self.value)
    }
}

impl<const N: usize> Quantity for Dual<N> {
    const SCENARIOS: usize = 1;

    fn of_each(number: impl Fn(usize) -> f64) -> Self {
        Self::constant(number(0))
    }
    fn shared(self) -> (Option<f64>, bool) {
        (Some(self.value), self.derivative == [0.0; N])
    }
}

impl Display for Lanes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [first, rest @ ..] = self.to_array();
        Display::fmt(&first, f)?;
        rest.iter().filter(|value| **value != first).try_for_each(|value| {
            f.write_str(", ")?;
            Display::fmt(value, f)
        })
    }
}

impl<const N: usize> Display for Dual<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Display::fmt(&self.value, f)
    }
}
