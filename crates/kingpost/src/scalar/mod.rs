//! Scalar trait for all code that is evaluated with derivatives or in SIMD lanes.
//!
//! The folders from [`spatial`](crate::spatial) to [`simulation`](crate::simulation) are generic over
//! [`Scalar`]. `f64` is the usual choice, [`Dual`] carries exact derivatives, and [`Lanes`] holds several
//! runs. Transcendental functions are those of the pure-Rust `libm` or of this module on every target, so
//! native and WASM runs are bitwise identical.

mod dual;
mod lanes;
mod radians;
mod turns;

pub use dual::Dual;
pub use lanes::{LANES, Lanes};

use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// A real number with which the mechanics can be computed.
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
    + Send
    + Sync
    + 'static
{
    /// Number of lanes.
    const LANES: usize = 1;
    /// Whether the type carries derivatives.
    const HAS_DERIVATIVES: bool = false;
    /// Additive identity.
    const ZERO: Self;
    /// Multiplicative identity.
    const ONE: Self;

    /// Returns the constant `value`, with zero derivatives, equal in every lane.
    fn constant(value: f64) -> Self;
    /// Returns the plain value without derivatives; the first of several lanes. Only for decisions that all
    /// lanes share, and for display.
    fn value(self) -> f64;
    /// Returns sine and cosine of an angle in radians.
    fn sin_cos(self) -> (Self, Self);
    /// Returns sine and cosine of an angle in turns of 2 pi rad, to about 2e-16 and much faster than
    /// [`sin_cos`](Self::sin_cos): for sums of many waves.
    fn sin_cos_of_turns(self) -> (Self, Self);
    /// Returns the cosine of an angle in turns of 2 pi rad, to about 3e-16, at half the cost of
    /// [`sin_cos_of_turns`](Self::sin_cos_of_turns).
    fn cos_of_turns(self) -> Self;
    /// Returns 2 to the power of this number, which must be below 1023, to a relative error of about 4e-16
    /// and much faster than [`exp`](Self::exp): for sums of many waves. For powers below -1022 it is the
    /// smallest normal number.
    fn power_of_two(self) -> Self;
    /// Returns the angle of the point (`x`, `self`), radians in (-pi, pi].
    fn atan2(self, x: Self) -> Self;
    /// Returns the square root; the argument must not be negative.
    fn sqrt(self) -> Self;
    /// Returns the exponential.
    fn exp(self) -> Self;
    /// Returns log(1 + self), exact to rounding near 0; `self` must be greater than -1.
    fn ln_1p(self) -> Self;
    /// Returns exp(self) - 1, exact to rounding near 0.
    fn exp_m1(self) -> Self;
    /// Returns the natural logarithm; `self` must be greater than 0.
    fn ln(self) -> Self;
    /// Returns `self` to a power; `self` must be greater than 0.
    fn pow(self, exponent: Self) -> Self;
    /// Applies a function of plain numbers, lane by lane, without derivatives: for an iteration whose last
    /// step adds the derivatives.
    fn from_values<const N: usize, const M: usize>(
        arguments: [Self; N],
        function: &dyn Fn([f64; N]) -> [f64; M],
    ) -> [Self; M];
    /// Returns the value without derivatives.
    #[inline]
    fn plain(self) -> Self {
        Self::from_values([self], &|value| value)[0]
    }
    /// Returns `below()` if `self < limit`, otherwise `above()`, also if `self` is NaN. A scalar with several
    /// lanes can evaluate both, so both must be free of side effects.
    fn select_less(self, limit: Self, below: impl FnOnce() -> Self, above: impl FnOnce() -> Self) -> Self;
    /// Returns whether `test` holds for the value in every lane.
    fn all(self, test: impl Fn(f64) -> bool) -> bool;

    /// Compares with a constant like [`select_less`](Self::select_less).
    #[inline]
    fn select_below(self, limit: f64, below: impl FnOnce() -> Self, above: impl FnOnce() -> Self) -> Self {
        self.select_less(Self::constant(limit), below, above)
    }

    /// Returns the number between `lower` and `upper` that is nearest to this one; NaN stays NaN.
    #[inline]
    fn clipped(self, lower: Self, upper: Self) -> Self {
        upper.select_less(self, || upper, || self.select_less(lower, || lower, || self))
    }
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
        radians::sin_cos(self)
    }

    #[inline(always)]
    fn sin_cos_of_turns(self) -> (Self, Self) {
        turns::sin_cos_of_turns(self)
    }

    #[inline(always)]
    fn cos_of_turns(self) -> Self {
        turns::cos_of_turns(self)
    }

    #[inline(always)]
    fn power_of_two(self) -> Self {
        turns::power_of_two(self)
    }

    #[inline]
    fn atan2(self, x: Self) -> Self {
        libm::atan2(self, x)
    }

    #[inline]
    fn sqrt(self) -> Self {
        // The instruction rounds correctly on every target, so the result is bitwise identical to that of
        // libm, which computes it with integers on WASM although WASM has the instruction.
        f64::sqrt(self)
    }

    #[inline]
    fn exp(self) -> Self {
        libm::exp(self)
    }

    #[inline]
    fn ln_1p(self) -> Self {
        libm::log1p(self)
    }

    fn exp_m1(self) -> Self {
        libm::expm1(self)
    }

    fn ln(self) -> Self {
        libm::log(self)
    }

    fn pow(self, exponent: Self) -> Self {
        libm::pow(self, exponent)
    }

    #[inline]
    fn from_values<const N: usize, const M: usize>(
        arguments: [Self; N],
        function: &dyn Fn([f64; N]) -> [f64; M],
    ) -> [Self; M] {
        function(arguments)
    }

    #[inline]
    fn select_less(self, limit: Self, below: impl FnOnce() -> Self, above: impl FnOnce() -> Self) -> Self {
        if self < limit { below() } else { above() }
    }

    #[inline]
    fn all(self, test: impl Fn(f64) -> bool) -> bool {
        test(self)
    }
}
