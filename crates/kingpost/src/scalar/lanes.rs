//! Lanes: several runs of one structure in SIMD registers.

use super::turns::{cosine, sine};
use super::{Scalar, radians};
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};
use wide::f64x4;

/// Number of runs that [`Lanes`] holds.
pub const LANES: usize = 4;

/// Independent numbers. Every operation is that of `f64` lane by lane, without fused multiplication, so each
/// lane is bitwise identical to a run alone.
///
/// ```
/// use kingpost::scalar::{Lanes, Scalar};
/// let x = Lanes::new([0.0, 4.0, 9.0, 2.0]);
/// assert_eq!((x.sqrt() + Lanes::ONE).to_array(), [1.0, 3.0, 4.0, 2.0_f64.sqrt() + 1.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lanes(f64x4);

impl Lanes {
    /// Creates a value from one number per lane.
    #[inline]
    pub fn new(numbers: [f64; LANES]) -> Self {
        Self(f64x4::new(numbers))
    }

    /// Returns the number of each lane.
    #[inline]
    pub fn to_array(self) -> [f64; LANES] {
        self.0.to_array()
    }

    /// Applies a function to each lane's number.
    #[inline(always)]
    fn by_lane(self, function: impl Fn(f64) -> f64) -> Self {
        let mut numbers = self.to_array();
        for x in &mut numbers {
            *x = function(*x);
        }
        Self::new(numbers)
    }

    /// Applies a function with two results to each lane's number.
    #[inline(always)]
    fn by_lane_both(self, functions: impl Fn(f64) -> (f64, f64)) -> (Self, Self) {
        let (mut first, mut second) = (self.to_array(), self.to_array());
        for k in 0..LANES {
            (first[k], second[k]) = functions(first[k]);
        }
        (Self::new(first), Self::new(second))
    }
}

impl Default for Lanes {
    #[inline]
    fn default() -> Self {
        Self::ZERO
    }
}

impl Add for Lanes {
    type Output = Self;
    #[inline]
    fn add(self, b: Self) -> Self {
        Self(self.0 + b.0)
    }
}

impl Sub for Lanes {
    type Output = Self;
    #[inline]
    fn sub(self, b: Self) -> Self {
        Self(self.0 - b.0)
    }
}

impl Mul for Lanes {
    type Output = Self;
    #[inline]
    fn mul(self, b: Self) -> Self {
        Self(self.0 * b.0)
    }
}

impl Div for Lanes {
    type Output = Self;
    #[inline]
    fn div(self, b: Self) -> Self {
        Self(self.0 / b.0)
    }
}

impl Neg for Lanes {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl AddAssign for Lanes {
    #[inline]
    fn add_assign(&mut self, b: Self) {
        *self = *self + b;
    }
}

impl SubAssign for Lanes {
    #[inline]
    fn sub_assign(&mut self, b: Self) {
        *self = *self - b;
    }
}

impl Scalar for Lanes {
    const LANES: usize = LANES;
    const ZERO: Self = Self(f64x4::ZERO);
    const ONE: Self = Self(f64x4::ONE);

    #[inline]
    fn constant(value: f64) -> Self {
        Self(f64x4::splat(value))
    }

    #[inline]
    fn value(self) -> f64 {
        self.to_array()[0]
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        if !self.0.abs().simd_lt(f64x4::splat(radians::LARGEST)).all() {
            return self.by_lane_both(Scalar::sin_cos);
        }
        let (quarters, left) = radians::reduced(self);
        let (mut sin, mut cos, quarters) = (sine(left).to_array(), cosine(left).to_array(), quarters.to_array());
        for k in 0..LANES {
            (sin[k], cos[k]) = radians::turned(sin[k], cos[k], quarters[k]);
        }
        (Self::new(sin), Self::new(cos))
    }

    #[inline]
    fn sin_cos_of_turns(self) -> (Self, Self) {
        self.by_lane_both(f64::sin_cos_of_turns)
    }

    #[inline]
    fn cos_of_turns(self) -> Self {
        self.by_lane(f64::cos_of_turns)
    }

    #[inline]
    fn power_of_two(self) -> Self {
        self.by_lane(f64::power_of_two)
    }

    fn atan2(self, x: Self) -> Self {
        let (y, x) = (self.to_array(), x.to_array());
        Self::new(core::array::from_fn(|k| libm::atan2(y[k], x[k])))
    }

    #[inline]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }

    fn exp(self) -> Self {
        self.by_lane(libm::exp)
    }

    fn ln_1p(self) -> Self {
        self.by_lane(libm::log1p)
    }

    fn exp_m1(self) -> Self {
        self.by_lane(libm::expm1)
    }

    fn ln(self) -> Self {
        self.by_lane(libm::log)
    }

    fn pow(self, exponent: Self) -> Self {
        let (base, exponent) = (self.to_array(), exponent.to_array());
        Self::new(core::array::from_fn(|k| libm::pow(base[k], exponent[k])))
    }

    fn from_values<const N: usize, const M: usize>(
        arguments: [Self; N],
        function: &dyn Fn([f64; N]) -> [f64; M],
    ) -> [Self; M] {
        let arguments = arguments.map(Self::to_array);
        let lanes: [[f64; M]; LANES] = core::array::from_fn(|k| function(arguments.map(|lanes| lanes[k])));
        core::array::from_fn(|i| Self::new(lanes.map(|numbers| numbers[i])))
    }

    /// If the lanes agree on the side, only this side is evaluated.
    #[inline]
    fn select_less(self, limit: Self, below: impl FnOnce() -> Self, above: impl FnOnce() -> Self) -> Self {
        let less = self.0.simd_lt(limit.0);
        if less.all() {
            return below();
        }
        if !less.any() {
            return above();
        }
        Self(less.select(below().0, above().0))
    }

    #[inline]
    fn all(self, test: impl Fn(f64) -> bool) -> bool {
        self.to_array().into_iter().all(test)
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
        sum += (-x * x).exp() * y.sin_cos_of_turns().1;
        sum -= -y * x.cos_of_turns() * (-y * y).power_of_two();
        let [difference, product] = S::from_values([sum, x], &|[a, b]| [a - b, a * b]);
        sum += difference / product + (x * x).ln_1p() + y.exp_m1() * (y * y).ln() - (x * x).pow(y);
        sum.select_less(x, || sum * y, || sum / root)
    }

    proptest! {
        #[test]
        fn every_lane_is_bitwise_identical_to_a_single_run(x: [f64; LANES], y: [f64; LANES]) {
            let together = formula(Lanes::new(x), Lanes::new(y)).to_array();
            for k in 0..LANES {
                let alone = formula(x[k], y[k]);
                prop_assert!(alone.to_bits() == together[k].to_bits() || alone.is_nan() && together[k].is_nan());
            }
        }
    }
}
