//! Sine and cosine of an angle in radians, without branches.

use super::Scalar;
use super::turns::{ROUNDING, cosine, sine};
use core::f64::consts::FRAC_2_PI;

/// A quarter of a turn as the sum of three parts: two of 33 bits, whose products with whole numbers up to
/// 2^20 are exact, and the rest (fdlibm's e_rem_pio2.c, Sun Microsystems 1993).
const QUARTER: [f64; 3] = [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_795_950_6e-21];

/// Largest angle, rad, for which the number of quarter turns needs at most 20 bits.
pub(super) const LARGEST: f64 = 1.6e6;

/// Returns sine and cosine to a unit in the last place.
///
/// With n the whole number of quarter turns nearest to the angle, the remainder is at most pi/4 and exact to
/// rounding (Cody and Waite 1980). Only sums and products are used, so the result is bitwise identical on
/// every machine and in lanes.
#[inline(always)]
pub(super) fn sin_cos(angle: f64) -> (f64, f64) {
    if angle.abs() < LARGEST {
        let (quarters, left) = reduced(angle);
        turned(sine(left), cosine(left), quarters)
    } else {
        libm::sincos(angle)
    }
}

/// Returns the whole number of quarter turns, in the last bits, and the remainder, rad.
#[inline(always)]
pub(super) fn reduced<S: Scalar>(angle: S) -> (S, S) {
    let [first, second, third] = [S::constant(QUARTER[0]), S::constant(QUARTER[1]), S::constant(QUARTER[2])];
    let rounding = S::constant(ROUNDING);
    let quarters = angle * S::constant(FRAC_2_PI) + rounding;
    let n = quarters - rounding;
    let (near, second) = (angle - n * first, n * second);
    let left = near - second;
    (quarters, left + (((near - left) - second) - n * third))
}

/// Returns sine and cosine of an angle plus a number of quarter turns, from those of the angle.
#[inline(always)]
pub(super) fn turned(sin: f64, cos: f64, quarters: f64) -> (f64, f64) {
    let by_quadrant = [sin, cos, -sin, -cos, sin];
    let quadrant = (quarters.to_bits() & 3) as usize;
    (by_quadrant[quadrant], by_quadrant[quadrant + 1])
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Comparison with libm, whose error is also below one unit in the last place; a unit is at most
        /// 1.1e-16 below 1, and the relative error also holds for very small numbers.
        #[test]
        fn sine_and_cosine_are_those_of_libm(angle in -1e6..1e6_f64, near in -4.0..4.0_f64) {
            for angle in [angle, near] {
                let ((sin, cos), (exact_sin, exact_cos)) = (sin_cos(angle), libm::sincos(angle));
                prop_assert!((sin - exact_sin).abs() <= 2.3e-16 * exact_sin.abs() + f64::MIN_POSITIVE);
                prop_assert!((cos - exact_cos).abs() <= 2.3e-16 * exact_cos.abs() + f64::MIN_POSITIVE);
            }
        }
    }

    #[test]
    fn near_quarter_turns_the_remainder_keeps_its_digits() {
        for n in -2000..2000_i32 {
            let angle = core::f64::consts::FRAC_PI_2 * f64::from(n);
            let ((sin, cos), (exact_sin, exact_cos)) = (sin_cos(angle), libm::sincos(angle));
            assert!((sin - exact_sin).abs() <= 2.3e-16 * exact_sin.abs(), "{n}");
            assert!((cos - exact_cos).abs() <= 2.3e-16 * exact_cos.abs(), "{n}");
        }
    }

    #[test]
    fn large_and_infinite_angles_use_libm() {
        assert_eq!(sin_cos(1e9), libm::sincos(1e9));
        assert!(sin_cos(f64::NAN).0.is_nan() && sin_cos(f64::INFINITY).1.is_nan());
    }
}
