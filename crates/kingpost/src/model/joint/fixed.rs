//! Joint without motion, such as a load lashed to the arm's tip.

use crate::scalar::Scalar;
use crate::spatial::{Frame, Vector3};

/// A rigid connection. The dynamics combines its two bodies.
#[derive(Clone, Copy, Debug)]
pub struct Fixed<S = f64> {
    /// The child's frame in the parent's.
    relative: Frame<S>,
    /// Vector from the joint to the child's centre of mass, child axes, m.
    to_child: Vector3<S>,
}

impl<S: Scalar> Fixed<S> {
    /// Creates a connection at `placement` in the parent's frame; `to_child` is the vector to the child's
    /// centre of mass.
    pub fn new(placement: Frame<S>, to_child: Vector3<S>) -> Self {
        Self { relative: placement.times(&Frame::translation(to_child)), to_child }
    }

    /// Returns a copy of the connection relative to another parent frame.
    pub fn seen_from(&self, parent: &Frame<S>) -> Self {
        Self { relative: parent.times(&self.relative), to_child: self.to_child }
    }

    /// Returns a copy of the connection with the child's frame moved by `offset`, child axes, m.
    pub fn with_child_moved(&self, offset: Vector3<S>) -> Self {
        let relative = self.relative.times(&Frame::translation(offset));
        Self { relative, to_child: self.to_child + offset }
    }

    /// E(child/parent).
    #[inline]
    pub fn relative(&self) -> Frame<S> {
        self.relative
    }

    /// Returns the vector from the joint to the child's centre of mass, child axes, m.
    pub fn to_child(&self) -> Vector3<S> {
        self.to_child
    }
}
