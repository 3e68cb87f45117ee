//! Dual numbers: a value and its derivatives along N directions, exact to rounding.

use super::Scalar;
use core::f64::consts::{LN_2, TAU};
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// `value + sum_k derivative[k] e_k` with `e_j e_k = 0` (Clifford 1873; Griewank & Walther,
/// *Evaluating Derivatives*, 2008, ch. 3).
///
/// ```
/// use kingpost::scalar::{Dual, Scalar};
/// let x = Dual::<1>::variable(2.0, 0);
/// let y = x * x * x + x.sin_cos().0;
/// assert!((y.derivative[0] - (3.0 * 4.0 + 2.0_f64.cos())).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual<const N: usize> {
    /// The value.
    pub value: f64,
    /// Derivatives along the directions.
    pub derivative: [f64; N],
}

impl<const N: usize> Dual<N> {
    /// The number itself as the variable of direction `k`.
    ///
    /// # Panics
    /// When there is no direction `k`.
    pub fn variable(value: f64, k: usize) -> Self {
        let mut derivative = [0.0; N];
        derivative[k] = 1.0;
        Self { value, derivative }
    }

    /// A function's value here, where its slope is known.
    #[inline]
    fn chain(self, value: f64, slope: f64) -> Self {
        Self { value, derivative: self.derivative.map(|d| slope * d) }
    }

    /// A function's value here, where its slopes in both arguments are known.
    #[inline]
    fn combine(self, other: Self, value: f64, slopes: [f64; 2]) -> Self {
        let along = |k: usize| slopes[0] * self.derivative[k] + slopes[1] * other.derivative[k];
        Self { value, derivative: core::array::from_fn(along) }
    }
}

impl<const N: usize> Default for Dual<N> {
    fn default() -> Self {
        Self::ZERO
    }
}

impl<const N: usize> Add for Dual<N> {
    type Output = Self;
    #[inline]
    fn add(self, b: Self) -> Self {
        self.combine(b, self.value + b.value, [1.0, 1.0])
    }
}

impl<const N: usize> Sub for Dual<N> {
    type Output = Self;
    #[inline]
    fn sub(self, b: Self) -> Self {
        self.combine(b, self.value - b.value, [1.0, -1.0])
    }
}

impl<const N: usize> Mul for Dual<N> {
    type Output = Self;
    #[inline]
    fn mul(self, b: Self) -> Self {
        self.combine(b, self.value * b.value, [b.value, self.value])
    }
}

impl<const N: usize> Div for Dual<N> {
    type Output = Self;
    #[inline]
    fn div(self, b: Self) -> Self {
        let quotient = self.value / b.value;
        self.combine(b, quotient, [1.0 / b.value, -quotient / b.value])
    }
}

impl<const N: usize> Neg for Dual<N> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.chain(-self.value, -1.0)
    }
}

impl<const N: usize> AddAssign for Dual<N> {
    #[inline]
    fn add_assign(&mut self, b: Self) {
        *self = *self + b;
    }
}

impl<const N: usize> SubAssign for Dual<N> {
    #[inline]
    fn sub_assign(&mut self, b: Self) {
        *self = *self - b;
    }
}

impl<const N: usize> Scalar for Dual<N> {
    const HAS_DERIVATIVES: bool = true;
    const ZERO: Self = Self { value: 0.0, derivative: [0.0; N] };
    const ONE: Self = Self { value: 1.0, derivative: [0.0; N] };

    #[inline]
    fn constant(value: f64) -> Self {
        Self { value, derivative: [0.0; N] }
    }

    #[inline]
    fn value(self) -> f64 {
        self.value
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = libm::sincos(self.value);
        (self.chain(sin, cos), self.chain(cos, -sin))
    }

    fn sin_cos_of_turns(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos_of_turns();
        (self.chain(sin, TAU * cos), self.chain(cos, -TAU * sin))
    }

    fn cos_of_turns(self) -> Self {
        self.chain(self.value.cos_of_turns(), -TAU * self.value.sin_cos_of_turns().0)
    }

    fn power_of_two(self) -> Self {
        let power = self.value.power_of_two();
        self.chain(power, LN_2 * power)
    }

    fn atan2(self, x: Self) -> Self {
        let square = self.value * self.value + x.value * x.value;
        self.combine(x, libm::atan2(self.value, x.value), [x.value / square, -self.value / square])
    }

    /// At zero the slope is infinite where the argument moves, and taken as zero where it rests.
    #[inline]
    fn sqrt(self) -> Self {
        let root = libm::sqrt(self.value);
        let slope = |d: f64| if d == 0.0 { 0.0 } else { d / (2.0 * root) };
        Self { value: root, derivative: self.derivative.map(slope) }
    }

    fn exp(self) -> Self {
        let power = libm::exp(self.value);
        self.chain(power, power)
    }

    fn ln_1p(self) -> Self {
        self.chain(libm::log1p(self.value), 1.0 / (1.0 + self.value))
    }

    fn exp_m1(self) -> Self {
        self.chain(libm::expm1(self.value), libm::exp(self.value))
    }

    fn ln(self) -> Self {
        self.chain(libm::log(self.value), 1.0 / self.value)
    }

    fn pow(self, exponent: Self) -> Self {
        let power = libm::pow(self.value, exponent.value);
        self.combine(exponent, power, [exponent.value * power / self.value, power * libm::log(self.value)])
    }

    fn from_values<const K: usize, const M: usize>(
        arguments: [Self; K],
        function: impl Fn([f64; K]) -> [f64; M],
    ) -> [Self; M] {
        function(arguments.map(Self::value)).map(Self::constant)
    }

    #[inline]
    fn select_less(self, limit: Self, below: impl FnOnce() -> Self, above: impl FnOnce() -> Self) -> Self {
        if self.value < limit.value { below() } else { above() }
    }

    #[inline]
    fn all(self, test: impl Fn(f64) -> bool) -> bool {
        test(self.value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Every operation of the trait, smooth where x > 0.
    fn formula<S: Scalar>(x: S, y: S) -> S {
        let (sin, cos) = (x * y).sin_cos();
        let angle = (sin + S::constant(2.0)).atan2(cos - y);
        let mut sum = x / (y * y + S::ONE) - x.sqrt() * angle;
        sum += -cos;
        sum -= y.clipped(S::constant(-1.0), x) * sin;
        sum += (x * S::constant(0.1)).cos_of_turns() * (-x).power_of_two();
        sum += (x * x).ln_1p() + x.ln() * y.exp_m1() - x.pow(y);
        sum.select_below(0.3, || sum * sum, || sum * S::constant(0.6) - S::constant(0.09))
    }

    proptest! {
        /// Central differences with step h err by the third derivative times h squared and by
        /// rounding over h.
        #[test]
        fn derivatives_agree_with_central_differences(x in 0.2..3.0_f64, y in -0.9..0.15_f64) {
            let h = 1e-5;
            let exact = formula(Dual::<2>::variable(x, 0), Dual::variable(y, 1));
            prop_assert_eq!(exact.value, formula(x, y));
            let along_x = (formula(x + h, y) - formula(x - h, y)) / (2.0 * h);
            let along_y = (formula(x, y + h) - formula(x, y - h)) / (2.0 * h);
            let scale = 1.0 + along_x.abs() + along_y.abs();
            prop_assert!((exact.derivative[0] - along_x).abs() < 1e-6 * scale);
            prop_assert!((exact.derivative[1] - along_y).abs() < 1e-6 * scale);
        }
    }

    #[test]
    fn what_is_not_a_number_stays_so_when_it_is_clipped() {
        let nan = Dual::<1>::constant(f64::NAN);
        assert!(nan.clipped(Dual::constant(-1.0), Dual::ONE).value.is_nan());
        assert!(f64::NAN.clipped(-1.0, 1.0).is_nan());
    }
}
