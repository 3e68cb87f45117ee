//! Dispersion relation of linear waves, w^2 = g k tanh(k h).
//!
//! Newman, *Marine Hydrodynamics* (1977), ch. 6; Faltinsen, *Sea Loads on Ships and Offshore
//! Structures* (1990), table 2.1.

use super::water::Water;

/// The wave number k, 1/m, of a wave of this angular frequency: w^2 = g k tanh(k h), over infinite depth w^2 = g k. To
/// rounding, by Newton's method within bounds that hold the root. A negative frequency counts as positive; a number
/// that is not finite is returned unchanged.
///
/// ```
/// use kingpost::sea::waves::{Water, wave_number};
/// let deep = wave_number(1.0, &Water::default());
/// assert!((deep - 1.0 / 9.80665).abs() < 1e-16);
/// let shallow = wave_number(0.01, &Water { depth_m: Some(1.0), ..Water::default() });
/// assert!((shallow / (0.01 / 9.80665_f64.sqrt()) - 1.0).abs() < 1e-5); // k = w / sqrt(g h)
/// ```
pub fn wave_number(angular_frequency_rad_s: f64, water: &Water) -> f64 {
    let deep = angular_frequency_rad_s * angular_frequency_rad_s / water.gravity_m_s2;
    match water.depth_m {
        Some(depth_m) if deep > 0.0 && deep.is_finite() => root_of_x_tanh_x(deep * depth_m) / depth_m,
        _ => deep,
    }
}

/// Returns x > 0 with x tanh x = a. As tanh x increases and is below both 1 and x, the root lies between
/// max(a, sqrt a) and a / tanh a. Newton's method starts from Eckart's x = a / sqrt(tanh a), which is within
/// 5 % of the root (Eckart 1952).
fn root_of_x_tanh_x(a: f64) -> f64 {
    let least = a.max(libm::sqrt(a));
    let most = (a / libm::tanh(a)).max(least);
    let mut x = a / libm::sqrt(libm::tanh(a));
    for _ in 0..10 {
        let t = libm::tanh(x);
        let step = (x * t - a) / (t + x * (1.0 - t * t));
        x = (x - step).clamp(least, most);
        if step.abs() <= 2.0 * f64::EPSILON * x {
            break;
        }
    }
    x
}

/// The group velocity dw/dk, m/s, of a wave: the speed of its energy. With the wave number k,
/// c_g = (w / 2 k) (1 + 2 k h / sinh 2 k h) (Newman, ch. 6), which is g / 2 w over infinite depth
/// and sqrt(g h) for long waves. Infinite for a frequency of 0 over infinite depth.
pub fn group_velocity_m_s(angular_frequency_rad_s: f64, water: &Water) -> f64 {
    let frequency = angular_frequency_rad_s.abs();
    let Some(depth_m) = water.depth_m else {
        return water.gravity_m_s2 / (2.0 * frequency);
    };
    let k = wave_number(frequency, water);
    // For long waves the group velocity is sqrt(gh) (1 - (kh)^2 / 2): the difference from sqrt(gh) is below
    // rounding.
    if k * depth_m < 1e-8 {
        return libm::sqrt(water.gravity_m_s2 * depth_m);
    }
    let double = 2.0 * k * depth_m;
    frequency / (2.0 * k) * (1.0 + double / libm::sinh(double))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const G: f64 = 9.80665;

    fn water(depth_m: f64) -> Water {
        Water { depth_m: Some(depth_m), ..Water::default() }
    }

    proptest! {
        /// Condition number of the root: d ln(w^2) / d ln k lies between 1 and 2, so the rounding error of
        /// w^2 is at most twice that of k.
        #[test]
        fn the_wave_number_fulfils_the_dispersion_relation(w in 1e-3..50.0_f64, h in 0.01..2e4_f64) {
            let k = wave_number(w, &water(h));
            let residual = G * k * libm::tanh(k * h) / (w * w) - 1.0;
            prop_assert!(residual.abs() < 8.0 * f64::EPSILON, "{w} rad/s over {h} m: {residual:e}");
        }

        /// Central difference of order 2: with a step of 1e-4 of k, its error is about 1e-8.
        #[test]
        fn the_group_velocity_is_the_slope_of_the_dispersion_relation(w in 0.05..5.0_f64, h in 1.0..500.0_f64) {
            let k = wave_number(w, &water(h));
            let frequency = |k: f64| libm::sqrt(G * k * libm::tanh(k * h));
            let slope = (frequency(k * 1.0001) - frequency(k * 0.9999)) / (2e-4 * k);
            prop_assert!((group_velocity_m_s(w, &water(h)) / slope - 1.0).abs() < 1e-7);
        }
    }

    /// From x tanh x = x^2 - x^4 / 3 + ...: with a = x tanh x, x = sqrt(a) (1 + a / 6 + O(a^2)).
    #[test]
    fn long_waves_propagate_at_the_root_of_g_h() {
        let (h, w) = (10.0, 0.01);
        let x = wave_number(w, &water(h)) * h;
        let first_order = w * libm::sqrt(h / G);
        assert!((x / first_order - 1.0 - first_order * first_order / 6.0).abs() < first_order.powi(4));
        assert!((group_velocity_m_s(0.0, &water(h)) - libm::sqrt(G * h)).abs() < 1e-15);
        assert!((group_velocity_m_s(1e-4, &water(h)) / libm::sqrt(G * h) - 1.0).abs() < 1e-6);
    }

    #[test]
    fn deep_water_is_the_limit_of_great_depth() {
        for w in [0.3, 1.0, 4.0] {
            assert_eq!(wave_number(w, &water(2e4)), wave_number(w, &Water::default()));
            let ratio = group_velocity_m_s(w, &water(2e4)) / group_velocity_m_s(w, &Water::default());
            assert!((ratio - 1.0).abs() < 4.0 * f64::EPSILON);
        }
    }

    #[test]
    fn invalid_frequencies_do_not_cause_an_endless_search() {
        assert_eq!(wave_number(0.0, &water(10.0)), 0.0);
        assert!(wave_number(f64::NAN, &water(10.0)).is_nan());
        assert_eq!(wave_number(1e200, &water(10.0)), f64::INFINITY);
        assert!(wave_number(1e-150, &water(10.0)) > 0.0);
    }
}
