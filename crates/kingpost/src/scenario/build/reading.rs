//! Numbers of one scenario, or of several of one structure, read as one scalar.

use crate::scalar::{Dual, LANES, Lanes, Scalar};
use crate::spatial::Vector3;
use core::cell::Cell;

/// The same part of one scenario or of several. Structure (names, switches, kinds) is that of the
/// first. A number is gathered from all: from one scenario as it is, from N side by side into lanes,
/// from one and N neighbours, in each of which one parameter was moved, into a dual number.
#[derive(Debug)]
pub struct Reading<'a, T> {
    parts: Vec<&'a T>,
    neighbours: &'a [Neighbour],
}

/// What sets a neighbour apart from the first scenario.
#[derive(Debug)]
pub struct Neighbour {
    /// By how much its parameter was moved.
    pub moved: f64,
    /// Whether a number that was read differs.
    pub seen: Cell<bool>,
}

/// A scalar that can be gathered from the numbers of several scenarios.
pub trait Gathered: Scalar {
    /// How many scenarios stand side by side, neighbours apart.
    const WIDTH: usize;
    /// From the number in each scenario.
    fn gather(numbers: &[f64], neighbours: &[Neighbour]) -> Self;
}

impl<'a, T> Reading<'a, T> {
    /// One scenario, or several side by side.
    pub fn new(parts: Vec<&'a T>) -> Self {
        Self { parts, neighbours: &[] }
    }

    /// A scenario, and after it its neighbours.
    pub fn with_neighbours(parts: Vec<&'a T>, neighbours: &'a [Neighbour]) -> Self {
        Self { parts, neighbours }
    }

    /// The part in the first scenario: the one that decides.
    pub fn first(&self) -> &'a T {
        self.parts[0]
    }

    /// A part of this part.
    pub fn part<U>(&self, pick: impl Fn(&'a T) -> &'a U) -> Reading<'a, U> {
        Reading { parts: self.parts.iter().map(|part| pick(part)).collect(), neighbours: self.neighbours }
    }

    /// A part that the first scenario is known to have.
    ///
    /// # Panics
    /// When another scenario does not have it: the caller promises one structure.
    pub fn kind<U>(&self, pick: impl Fn(&'a T) -> Option<&'a U>) -> Reading<'a, U> {
        self.part(|part| pick(part).expect("scenarios that are read together have one structure"))
    }

    /// A number of this part.
    pub fn number<S: Gathered>(&self, read: impl Fn(&T) -> f64) -> S {
        let numbers: Vec<f64> = self.parts.iter().map(|part| read(part)).collect();
        self.gathered(&numbers)
    }

    /// This part in every scenario, the first one first.
    pub fn all(&self) -> &[&'a T] {
        &self.parts
    }

    /// A number that is known in every scenario, in the order of [`all`](Self::all).
    pub fn gathered<S: Gathered>(&self, numbers: &[f64]) -> S {
        for (neighbour, number) in self.neighbours.iter().zip(&numbers[1..]) {
            neighbour.seen.set(neighbour.seen.get() || *number != numbers[0]);
        }
        S::gather(numbers, self.neighbours)
    }

    /// Several numbers of this part.
    pub fn numbers<S: Gathered, const N: usize>(&self, read: impl Fn(&T) -> [f64; N]) -> [S; N] {
        core::array::from_fn(|i| self.number(|part| read(part)[i]))
    }

    /// Three numbers of this part.
    pub fn vector<S: Gathered>(&self, read: impl Fn(&T) -> [f64; 3]) -> Vector3<S> {
        Vector3(self.numbers(read))
    }

    /// Whether a number differs from zero in any of the scenarios.
    pub fn any_nonzero(&self, read: impl Fn(&T) -> f64) -> bool {
        self.parts.iter().any(|part| read(part) != 0.0)
    }
}

impl Gathered for f64 {
    const WIDTH: usize = 1;

    fn gather(numbers: &[f64], _: &[Neighbour]) -> Self {
        numbers[0]
    }
}

impl Gathered for Lanes {
    const WIDTH: usize = LANES;

    fn gather(numbers: &[f64], _: &[Neighbour]) -> Self {
        Self::new(core::array::from_fn(|k| numbers[k]))
    }
}

/// A parameter is written to a field as it is or by the constant factor of its unit, so the
/// quotient of differences is the derivative, to rounding.
impl<const N: usize> Gathered for Dual<N> {
    const WIDTH: usize = 1;

    fn gather(numbers: &[f64], neighbours: &[Neighbour]) -> Self {
        let along = |k: usize| neighbours.get(k).map_or(0.0, |n| (numbers[k + 1] - numbers[0]) / n.moved);
        Self { value: numbers[0], derivative: core::array::from_fn(along) }
    }
}
