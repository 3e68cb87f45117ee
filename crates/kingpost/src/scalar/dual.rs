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
///
/// Over another scalar, it adds derivatives to those that the scalar already has: for example the time
/// derivative of a dual number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual<const N: usize, S = f64> {
    /// The value.
    pub value: S,
    /// Derivatives along the directions.
    pub derivative: [S; N],
}

impl<const N: usize, S: Scalar> Dual<N, S> {
    /// Returns the variable of direction `k` with this value: its derivative along `k` is 1.
    ///
    /// # Panics
    /// If there is no direction `k`.
    pub fn variable(value: S, k: usize) -> Self {
        let mut derivative = [S::ZERO; N];
        derivative[k] = S::ONE;
        Self { value, derivative }
    }

    /// Returns a constant: all derivatives are zero.
    #[inline]
    pub fn still(value: S) -> Self {
        Self { value, derivative: [S::ZERO; N] }
    }

    /// Returns a function's value with its derivatives, from the slope of the function (chain rule).
    #[inline]
    fn chain(self, value: S, slope: S) -> Self {
        let mut derivative = self.derivative;
        for d in &mut derivative {
            *d = slope * *d;
        }
        Self { value, derivative }
    }

    /// Returns the value of a function of two arguments with its derivatives, from the slopes with respect to
    /// both arguments.
    #[inline]
    fn combine(self, other: Self, value: S, slopes: [S; 2]) -> Self {
        let mut derivative = self.derivative;
        for (d, other) in derivative.iter_mut().zip(other.derivative) {
            *d = slopes[0] * *d + slopes[1] * other;
        }
        Self { value, derivative }
    }
}

impl<const N: usize, S: Scalar> Default for Dual<N, S> {
    fn default() -> Self {
        Self::ZERO
    }
}

impl<const N: usize, S: Scalar> Add for Dual<N, S> {
    type Output = Self;
    #[inline]
    fn add(self, b: Self) -> Self {
        self.combine(b, self.value + b.value, [S::ONE, S::ONE])
    }
}

impl<const N: usize, S: Scalar> Sub for Dual<N, S> {
    type Output = Self;
    #[inline]
    fn sub(self, b: Self) -> Self {
        self.combine(b, self.value - b.value, [S::ONE, -S::ONE])
    }
}

impl<const N: usize, S: Scalar> Mul for Dual<N, S> {
    type Output = Self;
    #[inline]
    fn mul(self, b: Self) -> Self {
        self.combine(b, self.value * b.value, [b.value, self.value])
    }
}

impl<const N: usize, S: Scalar> Div for Dual<N, S> {
    type Output = Self;
    #[inline]
    fn div(self, b: Self) -> Self {
        let quotient = self.value / b.value;
        self.combine(b, quotient, [S::ONE / b.value, -quotient / b.value])
    }
}

impl<const N: usize, S: Scalar> Neg for Dual<N, S> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.chain(-self.value, -S::ONE)
    }
}

impl<const N: usize, S: Scalar> AddAssign for Dual<N, S> {
    #[inline]
    fn add_assign(&mut self, b: Self) {
        *self = *self + b;
    }
}

impl<const N: usize, S: Scalar> SubAssign for Dual<N, S> {
    #[inline]
    fn sub_assign(&mut self, b: Self) {
        *self = *self - b;
    }
}

impl<const N: usize, S: Scalar> Scalar for Dual<N, S> {
    const LANES: usize = S::LANES;
    const HAS_DERIVATIVES: bool = true;
    const ZERO: Self = Self { value: S::ZERO, derivative: [S::ZERO; N] };
    const ONE: Self = Self { value: S::ONE, derivative: [S::ZERO; N] };

    #[inline]
    fn constant(value: f64) -> Self {
        Self::still(S::constant(value))
    }

    #[inline]
    fn value(self) -> f64 {
        self.value.value()
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (self.chain(sin, cos), self.chain(cos, -sin))
    }

    fn sin_cos_of_turns(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos_of_turns();
        let tau = S::constant(TAU);
        (self.chain(sin, tau * cos), self.chain(cos, -(tau * sin)))
    }

    fn cos_of_turns(self) -> Self {
        self.chain(self.value.cos_of_turns(), S::constant(-TAU) * self.value.sin_cos_of_turns().0)
    }

    fn power_of_two(self) -> Self {
        let power = self.value.power_of_two();
        self.chain(power, S::constant(LN_2) * power)
    }

    fn atan2(self, x: Self) -> Self {
        let square = self.value * self.value + x.value * x.value;
        self.combine(x, self.value.atan2(x.value), [x.value / square, -self.value / square])
    }

    /// Returns the square root. At zero the derivative is infinite if the argument varies, and zero if it is
    /// constant.
    #[inline]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        let mut derivative = self.derivative;
        for d in &mut derivative {
            *d = if *d == S::ZERO { S::ZERO } else { *d / (root + root) };
        }
        Self { value: root, derivative }
    }

    fn exp(self) -> Self {
        let power = self.value.exp();
        self.chain(power, power)
    }

    fn ln_1p(self) -> Self {
        self.chain(self.value.ln_1p(), S::ONE / (S::ONE + self.value))
    }

    fn exp_m1(self) -> Self {
        self.chain(self.value.exp_m1(), self.value.exp())
    }

    fn ln(self) -> Self {
        self.chain(self.value.ln(), S::ONE / self.value)
    }

    fn pow(self, exponent: Self) -> Self {
        let power = self.value.pow(exponent.value);
        self.combine(exponent, power, [exponent.value * power / self.value, power * self.value.ln()])
    }

    fn from_values<const K: usize, const M: usize>(
        arguments: [Self; K],
        function: &dyn Fn([f64; K]) -> [f64; M],
    ) -> [Self; M] {
        S::from_values(arguments.map(|argument| argument.value), function).map(Self::still)
    }

    #[inline]
    fn select_less(self, limit: Self, below: impl FnOnce() -> Self, above: impl FnOnce() -> Self) -> Self {
        if const { S::LANES == 1 } {
            return if self.value.value() < limit.value.value() { below() } else { above() };
        }
        let (below, above) = (below(), above());
        let select = |below: S, above: S| self.value.select_less(limit.value, || below, || above);
        let mut derivative = below.derivative;
        for (d, above) in derivative.iter_mut().zip(above.derivative) {
            *d = select(*d, above);
        }
        Self { value: select(below.value, above.value), derivative }
    }

    #[inline]
    fn all(self, test: impl Fn(f64) -> bool) -> bool {
        self.value.all(test)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Uses every operation of the trait, smooth where x > 0.
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
        /// The error of central differences with step h is the third derivative times h squared, plus
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
    fn nan_stays_nan_when_clipped() {
        let nan = Dual::<1>::constant(f64::NAN);
        assert!(nan.clipped(Dual::constant(-1.0), Dual::ONE).value.is_nan());
        assert!(f64::NAN.clipped(-1.0, 1.0).is_nan());
    }
}
