//! The columns of a joint's motion.

use crate::scalar::Scalar;
use crate::spatial::Twist;
use core::ops::{Deref, DerefMut};

/// Largest number of axes of one joint.
pub const MOST_AXES: usize = 6;

/// One twist per coordinate of a joint, in child axes about the child's centre of mass; a slice of up to six.
#[derive(Clone, Copy, Debug)]
pub struct Columns<S = f64> {
    twists: [Twist<S>; MOST_AXES],
    count: usize,
}

impl<S: Scalar> Columns<S> {
    /// Creates this number of zero columns, at most six.
    pub fn new(count: usize) -> Self {
        Self { twists: [Twist::zero(); MOST_AXES], count }
    }

    /// Creates the columns from a slice of at most six twists.
    pub fn of(twists: &[Twist<S>]) -> Self {
        let mut columns = Self::new(twists.len());
        columns.copy_from_slice(twists);
        columns
    }
}

impl<S> Deref for Columns<S> {
    type Target = [Twist<S>];
    fn deref(&self) -> &[Twist<S>] {
        &self.twists[..self.count]
    }
}

impl<S> DerefMut for Columns<S> {
    fn deref_mut(&mut self) -> &mut [Twist<S>] {
        &mut self.twists[..self.count]
    }
}
