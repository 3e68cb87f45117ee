//! Lanes: several runs of one structure side by side, one in each lane of a SIMD register.

use super::Scalar;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// N independent numbers. Every operation is that of `f64` lane by lane, so each lane has the bits
/// that it would have alone; the compiler makes SIMD instructions of the loops.
///
/// ```
/// use kingpost::scalar::{Lanes, Scalar};
/// let x = Lanes([0.0, 4.0, 9.0, 2.0]);
/// assert_eq!((x.sqrt() + Lanes::ONE).0, [1.0, 3.0, 4.0, 2.0_f64.sqrt() + 1.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(32))]
pub struct Lanes<const N: usize>(pub [f64; N]);

impl<const N: usize> Lanes<N> {
    #[inline(always)]
    fn zip(self, b: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Self(core::array::from_fn(|k| f(self.0[k], b.0[k])))
    }
}

impl<const N: usize> Default for Lanes<N> {
    #[inline(always)]
    fn default() -> Self {
        Self::ZERO
    }
}

impl<const N: usize> Add for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, b: Self) -> Self {
        self.zip(b, |a, b| a + b)
    }
}

impl<const N: usize> Sub for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, b: Self) -> Self {
        self.zip(b, |a, b| a - b)
    }
}

impl<const N: usize> Mul for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, b: Self) -> Self {
        self.zip(b, |a, b| a * b)
    }
}

impl<const N: usize> Div for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn div(self, b: Self) -> Self {
        self.zip(b, |a, b| a / b)
    }
}

impl<const N: usize> Neg for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(self.0.map(|a| -a))
    }
}

impl<const N: usize> AddAssign for Lanes<N> {
    #[inline(always)]
    fn add_assign(&mut self, b: Self) {
        *self = *self + b;
    }
}

impl<const N: usize> SubAssign for Lanes<N> {
    #[inline(always)]
    fn sub_assign(&mut self, b: Self) {
        *self = *self - b;
    }
}

impl<const N: usize> Scalar for Lanes<N> {
    const ZERO: Self = Self([0.0; N]);
    const ONE: Self = Self([1.0; N]);

    #[inline(always)]
    fn constant(value: f64) -> Self {
        Self([value; N])
    }

    #[inline(always)]
    fn value(self) -> f64 {
        self.0[0]
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let both = self.0.map(libm::sincos);
        (Self(both.map(|(sin, _)| sin)), Self(both.map(|(_, cos)| cos)))
    }

    fn atan2(self, x: Self) -> Self {
        self.zip(x, libm::atan2)
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.map(libm::sqrt))
    }

    /// Where the lanes agree, only one side is evaluated.
    #[inline(always)]
    fn select_less(self, limit: Self, below: impl FnOnce() -> Self, above: impl FnOnce() -> Self) -> Self {
        let less: [bool; N] = core::array::from_fn(|k| self.0[k] < limit.0[k]);
        if less == [true; N] {
            return below();
        }
        if less == [false; N] {
            return above();
        }
        let (below, above) = (below(), above());
        Self(core::array::from_fn(|k| if less[k] { below.0[k] } else { above.0[k] }))
    }

    #[inline(always)]
    fn all(self, test: impl Fn(f64) -> bool) -> bool {
        self.0.into_iter().all(test)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn formula<S: Scalar>(x: S, y: S) -> S {
        let (sin, cos) = (x * y).sin_cos();
        let root = (x * x + y * y).sqrt();
        let mut sum = root / (S::ONE + sin * sin) - cos.clipped(y, x + y);
        sum += x.atan2(y);
        sum -= -y;
        sum.select_less(x, || sum * y, || sum / root)
    }

    proptest! {
        #[test]
        fn every_lane_has_the_bits_that_it_would_have_alone(x: [f64; 4], y: [f64; 4]) {
            let together = formula(Lanes(x), Lanes(y));
            for k in 0..4 {
                let alone = formula(x[k], y[k]);
                prop_assert!(alone.to_bits() == together.0[k].to_bits() || alone.is_nan() && together.0[k].is_nan());
            }
        }
    }
}
