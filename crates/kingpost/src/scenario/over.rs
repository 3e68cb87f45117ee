//! Conversion of a type of the scenario file to another scalar: each of its continuous numbers is converted,
//! in the order of the declarations; everything else is copied.

use core::fmt::Display;
use core::hash::{BuildHasher, Hash};

use indexmap::IndexMap;

/// A type of the scenario file over plain numbers. `#[fields]` implements this trait for a type that is
/// generic over scalars.
pub trait OverScalar<S> {
    /// The type over the other scalar.
    type Over;
    /// Converts the numbers of the value.
    fn over(&self, numbers: &mut dyn Numbers<S>) -> Self::Over;
}

/// Conversion of the continuous numbers of a scenario, in the order of their declarations.
pub trait Numbers<S> {
    /// Converts the number at the present path.
    fn number(&mut self, value: f64) -> S;
    /// Appends a field, a variant, or an entry of a map or of a list to the present path.
    fn enter(&mut self, _: &dyn Display) {}
    /// Removes the last segment from the present path.
    fn leave(&mut self) {}
}

/// Converts a field, a variant, or an entry of a map or list; `segment` extends the present path to it.
pub fn within<S, T: OverScalar<S>>(value: &T, segment: &dyn Display, numbers: &mut dyn Numbers<S>) -> T::Over {
    numbers.enter(segment);
    let converted = value.over(numbers);
    numbers.leave();
    converted
}

impl<S> OverScalar<S> for f64 {
    type Over = S;
    fn over(&self, numbers: &mut dyn Numbers<S>) -> S {
        numbers.number(*self)
    }
}

impl<S, T: OverScalar<S>> OverScalar<S> for Option<T> {
    type Over = Option<T::Over>;
    fn over(&self, numbers: &mut dyn Numbers<S>) -> Self::Over {
        self.as_ref().map(|value| value.over(numbers))
    }
}

impl<S, T: OverScalar<S>> OverScalar<S> for Box<T> {
    type Over = Box<T::Over>;
    fn over(&self, numbers: &mut dyn Numbers<S>) -> Self::Over {
        Box::new((**self).over(numbers))
    }
}

impl<S, T: OverScalar<S>> OverScalar<S> for Vec<T> {
    type Over = Vec<T::Over>;
    fn over(&self, numbers: &mut dyn Numbers<S>) -> Self::Over {
        self.iter().enumerate().map(|(k, entry)| within(entry, &k, numbers)).collect()
    }
}

impl<S, T: OverScalar<S>, const N: usize> OverScalar<S> for [T; N] {
    type Over = [T::Over; N];
    fn over(&self, numbers: &mut dyn Numbers<S>) -> Self::Over {
        core::array::from_fn(|k| within(&self[k], &k, numbers))
    }
}

impl<S, K: Clone + Display + Eq + Hash, T: OverScalar<S>, H: BuildHasher + Default> OverScalar<S>
    for IndexMap<K, T, H>
{
    type Over = IndexMap<K, T::Over, H>;
    fn over(&self, numbers: &mut dyn Numbers<S>) -> Self::Over {
        self.iter().map(|(name, entry)| (name.clone(), within(entry, name, numbers))).collect()
    }
}
