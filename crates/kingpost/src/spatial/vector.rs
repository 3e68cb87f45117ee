//! Columns of three components.

use crate::scalar::Scalar;
use core::ops::{Add, AddAssign, Index, IndexMut, Mul, Neg, Sub, SubAssign};

/// A column of three components in one frame; the frame is in the variable's name.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vector3<S = f64>(pub [S; 3]);

impl<S: Scalar> Vector3<S> {
    /// The column (x, y, z).
    #[inline]
    pub const fn new(x: S, y: S, z: S) -> Self {
        Self([x, y, z])
    }

    /// The zero column.
    #[inline]
    pub const fn zero() -> Self {
        Self([S::ZERO; 3])
    }

    /// The column of plain constants.
    #[inline]
    pub fn constant(v: [f64; 3]) -> Self {
        Self([S::constant(v[0]), S::constant(v[1]), S::constant(v[2])])
    }

    /// Reads the first three entries of a slice.
    ///
    /// # Panics
    /// If the slice has fewer than three entries.
    #[inline]
    pub fn from_slice(v: &[S]) -> Self {
        Self([v[0], v[1], v[2]])
    }

    /// Writes the entries to the first three places of a slice.
    #[inline]
    pub fn write_to(self, out: &mut [S]) {
        out[..3].copy_from_slice(&self.0);
    }

    /// Scalar product.
    #[inline]
    pub fn dot(self, b: Self) -> S {
        self.0[0] * b.0[0] + self.0[1] * b.0[1] + self.0[2] * b.0[2]
    }

    /// Returns the vector product `self x b`; the paper writes it as a skew matrix times a column.
    #[inline]
    pub fn cross(self, b: Self) -> Self {
        let ([a0, a1, a2], [b0, b1, b2]) = (self.0, b.0);
        Self([a1 * b2 - a2 * b1, a2 * b0 - a0 * b2, a0 * b1 - a1 * b0])
    }

    /// Squared Euclidean length.
    #[inline]
    pub fn norm_squared(self) -> S {
        self.dot(self)
    }

    /// Euclidean length.
    #[inline]
    pub fn norm(self) -> S {
        self.norm_squared().sqrt()
    }

    /// Returns the unit vector along this one, which must not be zero. The components are first divided by
    /// the largest one, so that the length does not overflow.
    pub fn direction(self) -> Self {
        let size = |x: S| x.select_below(0.0, || -x, || x);
        let larger = |a: S, b: S| a.select_less(b, || b, || a);
        let largest = self.0.into_iter().fold(S::ZERO, |largest, x| larger(largest, size(x)));
        let scaled = Self(self.0.map(|x| x / largest));
        let length = scaled.norm();
        Self(scaled.0.map(|x| x / length))
    }
}

impl<S> Index<usize> for Vector3<S> {
    type Output = S;
    #[inline]
    fn index(&self, i: usize) -> &S {
        &self.0[i]
    }
}

impl<S> IndexMut<usize> for Vector3<S> {
    #[inline]
    fn index_mut(&mut self, i: usize) -> &mut S {
        &mut self.0[i]
    }
}

impl<S: Scalar> Add for Vector3<S> {
    type Output = Self;
    #[inline]
    fn add(self, b: Self) -> Self {
        Self([self.0[0] + b.0[0], self.0[1] + b.0[1], self.0[2] + b.0[2]])
    }
}

impl<S: Scalar> Sub for Vector3<S> {
    type Output = Self;
    #[inline]
    fn sub(self, b: Self) -> Self {
        Self([self.0[0] - b.0[0], self.0[1] - b.0[1], self.0[2] - b.0[2]])
    }
}

impl<S: Scalar> Mul<S> for Vector3<S> {
    type Output = Self;
    #[inline]
    fn mul(self, k: S) -> Self {
        Self([self.0[0] * k, self.0[1] * k, self.0[2] * k])
    }
}

impl<S: Scalar> Neg for Vector3<S> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self([-self.0[0], -self.0[1], -self.0[2]])
    }
}

impl<S: Scalar> AddAssign for Vector3<S> {
    #[inline]
    fn add_assign(&mut self, b: Self) {
        *self = *self + b;
    }
}

impl<S: Scalar> SubAssign for Vector3<S> {
    #[inline]
    fn sub_assign(&mut self, b: Self) {
        *self = *self - b;
    }
}
