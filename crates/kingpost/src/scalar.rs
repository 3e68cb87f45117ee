//! One scalar trait for everything that a derivative or a SIMD lane may pass through.
//!
//! The folders from [`spatial`](crate::spatial) to [`forces`](crate::forces) are generic over
//! [`Scalar`]. `f64` is the everyday choice. Transcendental functions go through the pure-Rust
//! `libm` on every target, so native and WASM runs give the same bits.

use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// A real number that the mechanics can be computed with.
pub trait Scalar:
    Copy
    + Debug
    + Default
    + PartialEq
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + 'static
{
    /// Additive identity.
    const ZERO: Self;
    /// Multiplicative identity.
    const ONE: Self;

    /// The constant `value`, with no derivative.
    fn constant(value: f64) -> Self;
    /// The plain value, derivatives dropped.
    fn value(self) -> f64;
    /// Sine and cosine of an angle in radians.
    fn sin_cos(self) -> (Self, Self);
    /// Square root; the argument must not be negative.
    fn sqrt(self) -> Self;
    /// `below()` where `self < limit`, otherwise `above()`. A scalar of several lanes may evaluate
    /// both, so both must be free of side effects.
    fn select_below(self, limit: f64, below: impl FnOnce() -> Self, above: impl FnOnce() -> Self) -> Self;
}

impl Scalar for f64 {
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;

    #[inline]
    fn constant(value: f64) -> Self {
        value
    }

    #[inline]
    fn value(self) -> f64 {
        self
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        libm::sincos(self)
    }

    #[inline]
    fn sqrt(self) -> Self {
        libm::sqrt(self)
    }

    #[inline]
    fn select_below(self, limit: f64, below: impl FnOnce() -> Self, above: impl FnOnce() -> Self) -> Self {
        if self < limit { below() } else { above() }
    }
}
