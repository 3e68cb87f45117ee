//! The types that a number of a scenario can be read as: a plain number, the numbers of several runs, or a number with
//! derivatives.

use std::fmt::{self, Debug, Display};

use super::error::FieldError;
use crate::scalar::{Dual, LANES, Lanes, Scalar};

/// A continuous number of a scenario. The types of a scenario are generic over it; numbers that decide the structure of
/// a run (steps, seeds, switching times, grids of tables) are plain.
///
/// The numbers of a file are `f64`; [`OverScalar`](super::over::OverScalar) converts them.
pub trait Leaf: Copy + Debug + Default + PartialEq + 'static {
    /// A default from the source code.
    fn literal(value: f64) -> Self;
    /// A value that is outside its range, if there is one.
    fn outside(self, inside: impl Fn(f64) -> bool) -> Option<f64>;
}

/// The scalar of the JSON Schema: the plain number.
#[cfg(feature = "schema")]
pub trait Described: Leaf + super::writing::ToValue + serde::Serialize + schemars::JsonSchema {}

#[cfg(feature = "schema")]
impl Described for f64 {}

/// A leaf from which a model can be built. A builder computes with all its lanes and derivatives: only the functions
/// here give a plain number, and they fail if that would lose something.
pub trait Quantity: Leaf + Scalar + Display {
    /// Number of scenarios that it holds.
    const SCENARIOS: usize;

    /// From the number in each of the scenarios; without derivatives.
    fn of_each(number: impl Fn(usize) -> f64) -> Self;

    /// The value if all lanes are equal, and whether it has no derivative.
    fn shared(self) -> (Option<f64>, bool);

    /// The plain number, for quantities that are plain in the engine.
    ///
    /// # Errors
    /// Lanes that differ, or a derivative.
    fn same(self, field: &str) -> Result<f64, FieldError> {
        match self.shared() {
            (Some(value), true) => Ok(value),
            _ => Err(FieldError::new(field, self, ONE_NUMBER)),
        }
    }

    /// The plain number, and the factor, 1, that carries its derivatives: for quantities proportional to it.
    ///
    /// # Errors
    /// Lanes that differ.
    fn scaled(self, field: &str) -> Result<(f64, Self), FieldError> {
        let value = self.shared().0.ok_or_else(|| FieldError::new(field, self, ONE_NUMBER))?;
        Ok((value, if value == 0.0 { Self::ONE } else { self / Self::constant(value) }))
    }

    /// Whether a test holds: all lanes must give the same answer.
    ///
    /// # Errors
    /// It holds in some lanes and not in others.
    fn decides(self, field: &str, test: impl Fn(f64) -> bool) -> Result<bool, FieldError> {
        match (self.all(&test), self.all(|value| !test(value))) {
            (true, _) => Ok(true),
            (_, true) => Ok(false),
            _ => Err(FieldError::new(field, self, ONE_NUMBER)),
        }
    }

    /// Whether it is 0 in all lanes with zero derivatives: then the terms that it scales may be left out.
    fn vanishes(self) -> bool {
        self.shared() == (Some(0.0), true)
    }
}

/// Form that is allowed for a number that decides the structure of a run.
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
