//! Sine and cosine of an angle in turns, and powers of two, for sums of many waves.
//!
//! The functions have no branches, so that a loop over many waves becomes SIMD code. They use only the four
//! basic operations, so the result is bitwise identical on every machine.

use super::Scalar;
use core::f64::consts::{PI, TAU};

/// 1.5 * 2^52: a number added to it is rounded to the nearest whole number, which is then in its last bits.
pub(super) const ROUNDING: f64 = 6_755_399_441_055_744.0;

/// 1.5 * 2^51: a number added to it is rounded to the nearest half, and its last bits hold the number of halves.
const ROUNDING_TO_HALVES: f64 = 0.5 * ROUNDING;

/// Returns sine and cosine of 2 pi times a number, to 2 units in the last place of 1.
///
/// With n the whole number nearest to four times the argument, the remainder is at most an eighth of a turn
/// and exact, whatever the number of turns. The polynomials are those of fdlibm's k_sin.c and k_cos.c (Sun
/// Microsystems 1993).
#[inline(always)]
pub(super) fn sin_cos_of_turns(turns: f64) -> (f64, f64) {
    let quarters = 4.0 * turns + ROUNDING;
    let angle = TAU * (turns - 0.25 * (quarters - ROUNDING));
    let (sin, cos) = (sine(angle).to_bits(), cosine(angle).to_bits());
    let quadrant = quarters.to_bits();
    let odd = (quadrant & 1).wrapping_neg();
    let sign_of_sine = (quadrant & 2) << 62;
    let sign_of_cosine = (quadrant.wrapping_add(1) & 2) << 62;
    let sine = (sin & !odd | cos & odd) ^ sign_of_sine;
    let cosine = (cos & !odd | sin & odd) ^ sign_of_cosine;
    (f64::from_bits(sine), f64::from_bits(cosine))
}

/// Returns the cosine of 2 pi times a number, to 3 units in the last place of 1, at half the cost of
/// [`sin_cos_of_turns`].
///
/// The remainder after half turns is at most a quarter of a turn r, and cos 2 pi r = 1 - 2 sin^2 pi r.
#[inline(always)]
pub(super) fn cos_of_turns(turns: f64) -> f64 {
    let halves = turns + ROUNDING_TO_HALVES;
    let sine = sine(PI * (turns - (halves - ROUNDING_TO_HALVES)));
    let cosine = 1.0 - 2.0 * (sine * sine);
    f64::from_bits(cosine.to_bits() ^ (halves.to_bits() << 63))
}

/// Returns 2 to a power below 1023, to 2 units in the last place; 2^-1022 for powers below -1022.
///
/// With n the whole number nearest to the power, the remainder is at most a half and exact; 2 to the remainder is the
/// rational function of the Cephes library's exp2.c (S. L. Moshier, *Methods and Programs for Mathematical Functions*,
/// 1989).
#[inline(always)]
pub(super) fn power_of_two(power: f64) -> f64 {
    // Coefficients of the numerator and the denominator.
    const P: [f64; 3] = [1_513.906_801_156_151, 20.202_065_669_316_532, 2.309_334_770_573_452_3e-2];
    const Q: [f64; 2] = [4_368.211_668_792_106, 233.184_211_722_314_9];
    let power = if power < -1022.0 { -1022.0 } else { power };
    let whole = power + ROUNDING;
    let rest = power - (whole - ROUNDING);
    let square = rest * rest;
    let p = rest * (P[0] + square * (P[1] + square * P[2]));
    let q = Q[0] + square * (Q[1] + square);
    let scale = f64::from_bits((whole.to_bits() << 52).wrapping_add(1.0_f64.to_bits()));
    (1.0 + 2.0 * (p / (q - p))) * scale
}

/// Returns the sine of an angle from -pi/4 to pi/4.
#[inline(always)]
pub(super) fn sine<S: Scalar>(x: S) -> S {
    const COEFFICIENTS: [f64; 6] = [
        -1.666_666_666_666_663_2e-1,
        8.333_333_333_322_49e-3,
        -1.984_126_982_985_795e-4,
        2.755_731_370_707_006_8e-6,
        -2.505_076_025_340_686_3e-8,
        1.589_690_995_211_55e-10,
    ];
    let z = x * x;
    x + x * z * polynomial(COEFFICIENTS, z)
}

/// Returns the cosine of an angle from -pi/4 to pi/4.
#[inline(always)]
pub(super) fn cosine<S: Scalar>(x: S) -> S {
    const COEFFICIENTS: [f64; 6] = [
        4.166_666_666_666_66e-2,
        -1.388_888_888_887_411e-3,
        2.480_158_728_947_673e-5,
        -2.755_731_435_139_066_3e-7,
        2.087_572_321_298_175e-9,
        -1.135_964_755_778_819_5e-11,
    ];
    let z = x * x;
    let rest = z * polynomial(COEFFICIENTS, z);
    let half = S::constant(0.5) * z;
    let near = S::ONE - half;
    near + (((S::ONE - near) - half) + z * rest)
}

/// Returns `c0 + z (c1 + z (c2 + ...))`.
#[inline(always)]
fn polynomial<S: Scalar>(coefficients: [f64; 6], z: S) -> S {
    let c = |k: usize| S::constant(coefficients[k]);
    c(0) + z * (c(1) + z * (c(2) + z * (c(3) + z * (c(4) + z * c(5)))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Comparison with libm for the angle that remains after whole turns, which is exact in both;
        /// multiplied by 2 pi it has a rounding error of half a unit, at most 2e-16 rad.
        #[test]
        fn sine_and_cosine_are_those_of_libm(turns in -1e6..1e6_f64) {
            let (sin, cos) = sin_cos_of_turns(turns);
            let (exact_sin, exact_cos) = libm::sincos(TAU * (turns - libm::round(turns)));
            prop_assert!((sin - exact_sin).abs() < 8e-16 && (cos - exact_cos).abs() < 8e-16);
            prop_assert!((cos_of_turns(turns) - exact_cos).abs() < 1e-15);
        }

        /// Comparison with libm, whose error is below one unit in the last place.
        #[test]
        fn powers_of_two_are_those_of_libm(power in -1021.0..1022.9_f64) {
            prop_assert!((power_of_two(power) / libm::exp2(power) - 1.0).abs() < 6e-16);
        }
    }

    #[test]
    fn whole_powers_of_two_are_exact_and_the_lowest_is_the_least_normal_number() {
        for power in -1022..1024_i32 {
            assert_eq!(power_of_two(f64::from(power)), libm::exp2(f64::from(power)));
        }
        for power in [-1022.5, -1e300, f64::NEG_INFINITY] {
            assert_eq!(power_of_two(power), f64::MIN_POSITIVE);
        }
        assert!(power_of_two(f64::NAN).is_nan());
    }

    #[test]
    fn halves_of_a_turn_have_the_cosine_one_or_minus_one() {
        for n in -8..8_i32 {
            assert_eq!(cos_of_turns(0.5 * f64::from(n)), [1.0, -1.0][n.rem_euclid(2) as usize]);
        }
    }

    #[test]
    fn quarters_of_a_turn_are_exact() {
        let expected = [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)];
        for n in -8..8_i32 {
            assert_eq!(sin_cos_of_turns(0.25 * f64::from(n)), expected[n.rem_euclid(4) as usize]);
        }
    }

    #[test]
    fn an_angle_that_is_not_finite_has_no_sine() {
        for turns in [f64::NAN, f64::INFINITY] {
            let (sin, cos) = sin_cos_of_turns(turns);
            assert!(sin.is_nan() && cos.is_nan() && cos_of_turns(turns).is_nan());
        }
    }
}
