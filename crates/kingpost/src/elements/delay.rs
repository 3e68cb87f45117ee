//! A delay by a whole number of samples.

use super::ElementState;
use crate::scalar::Scalar;

/// A delay of whole samples: a ring buffer in an element's discrete numbers, whose head is a mode.
///
/// ```
/// use kingpost::elements::{Delay, ElementState};
/// let delay = Delay { first_number: 0, mode: 0, ticks: 2 };
/// let (mut numbers, mut modes) = ([0.0; 2], [0]);
/// let mut own = ElementState { states: &mut [], numbers: &mut numbers, modes: &mut modes, also: None };
/// let out: Vec<f64> = [1.0, 2.0, 3.0, 4.0].into_iter().map(|value| delay.pass(&mut own, value)).collect();
/// assert_eq!(out, [0.0, 0.0, 1.0, 2.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Delay {
    /// Index of the first of its `ticks` numbers among the element's.
    pub first_number: usize,
    /// Index of the mode that holds the position of the oldest value in the buffer.
    pub mode: usize,
    /// The delay, in samples.
    pub ticks: usize,
}

impl Delay {
    /// Stores a value and returns the value of `ticks` samples ago; call once per sample.
    pub fn pass<S: Scalar>(&self, own: &mut ElementState<'_, S>, value: S) -> S {
        if self.ticks == 0 {
            return value;
        }
        let head = own.modes[self.mode].rem_euclid(self.ticks as i64) as usize;
        own.modes[self.mode] = ((head + 1) % self.ticks) as i64;
        core::mem::replace(&mut own.numbers[self.first_number + head], value)
    }
}
