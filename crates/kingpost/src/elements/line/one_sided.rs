//! A damped spring that acts in one direction only: the tension of a line, the support of the ground.
//!
//! Over its stiffness, the force at the deflection x and its rate x' is
//!
//! ```text
//! x' > 0:  max(x, 0) + max(tau x' - max(-x, 0), 0)
//! x' < 0:  max(max(x, 0) + tau x', 0)
//! ```
//!
//! Its elastic part is max(x, 0). The force is continuous, increases with x and with x', and takes energy at any motion: a
//! spring that closes fast acts up to tau x' before it touches, instead of with a jump.

use crate::scalar::Scalar;

/// Difference of two deflections below which the mean of their positive parts is taken at both.
const EQUAL: f64 = 1e-12;

/// The mean force of a one-sided spring over an interval, over its stiffness.
#[derive(Clone, Copy, Debug)]
pub struct OneSided<S> {
    /// Elastic part, whose work is stored.
    pub elastic: S,
    /// Elastic and damping part.
    pub whole: S,
    /// Derivatives of the whole: along the deflection at the end of the interval, and along the rate.
    pub slopes: [S; 2],
}

/// Returns the force at a deflection and its rate over the stiffness: the elastic part, and the whole.
pub fn one_sided<S: Scalar>(deflection: S, rate: S, tau: S) -> [S; 2] {
    let [elastic, gap] = [positive(deflection), positive(-deflection)];
    let closes = elastic + positive(tau * rate - gap);
    let opens = positive(elastic + tau * rate);
    [elastic, rate.select_below(0.0, || opens, || closes)]
}

/// Returns the mean force over an interval between two deflections, with this rate: its elastic part changes max(x, 0)^2 / 2
/// by its product with the change of x.
#[inline(always)]
pub fn mean_one_sided<S: Scalar>([before, after]: [S; 2], rate: S, tau: S) -> OneSided<S> {
    let is_positive = |x: f64| x > 0.0;
    if before.all(is_positive) && after.all(is_positive) {
        return mean_closed([before, after], rate, tau);
    }
    mean_across([before, after], rate, tau)
}

/// Whether a spring has no force over an interval between two deflections, with this rate.
#[inline(always)]
pub fn is_open<S: Scalar>([before, after]: [S; 2], rate: S, tau: S) -> bool {
    let is_negative = |x: f64| x < 0.0;
    let closes = tau * rate + (before + after) * S::constant(0.5);
    before.all(is_negative) && after.all(is_negative) && closes.all(is_negative)
}

/// Returns the mean force over an interval in which the spring is closed at both ends.
#[inline(always)]
fn mean_closed<S: Scalar>([before, after]: [S; 2], rate: S, tau: S) -> OneSided<S> {
    let half = S::constant(0.5);
    let elastic = (before + after) * half;
    let left = elastic + tau * rate;
    let if_positive = |value: S| left.select_below(0.0, || S::ZERO, || value);
    OneSided { elastic, whole: positive(left), slopes: [if_positive(half), if_positive(tau)] }
}

/// Returns the mean force over an interval in which the spring may open or close.
fn mean_across<S: Scalar>([before, after]: [S; 2], rate: S, tau: S) -> OneSided<S> {
    let (elastic, rise) = mean_of_positive(before, after);
    let (gap, narrows) = mean_of_positive(-before, -after);
    let damping = tau * rate;
    let if_positive = |number: S, value: S| number.select_below(0.0, || S::ZERO, || value);
    let over = damping - gap;
    let closes = [elastic + positive(over), rise + if_positive(over, narrows), if_positive(over, tau)];
    let left = elastic + damping;
    let opens = [positive(left), if_positive(left, rise), if_positive(left, tau)];
    let [whole, along, per_rate] = core::array::from_fn(|k| rate.select_below(0.0, || opens[k], || closes[k]));
    OneSided { elastic, whole, slopes: [along, per_rate] }
}

/// Share of the rate at the end of an interval in the rate of damping; the rest is the mean rate of the interval.
///
/// With the mean rate alone the midpoint rule keeps the velocity of a motion that is much shorter than the interval, with the
/// sign changed from step to step. This share takes a sixth of it in each step, and adds an error of (omega h)^2 / 16 to the
/// frequency omega.
pub fn share_at_end<S: Scalar>(interval_s: S, tau: S) -> S {
    interval_s / (interval_s + tau * S::constant(4.0))
}

/// Returns max(x, 0).
pub fn positive<S: Scalar>(x: S) -> S {
    x.select_below(0.0, || S::ZERO, || x)
}

/// Returns the mean of max(x, 0) over the way from one number to another, which is the difference quotient of
/// max(x, 0)^2 / 2, and its derivative along the second number.
fn mean_of_positive<S: Scalar>(before: S, after: S) -> (S, S) {
    let half = S::constant(0.5);
    let [a, b] = [positive(before), positive(after)];
    let way = after - before;
    let near = way.select_below(EQUAL, || way.select_below(-EQUAL, || S::ZERO, || S::ONE), || S::ZERO);
    let is_below = |x: S| x.select_below(0.0, || S::ONE, || S::ZERO);
    let differ = is_below(before) - is_below(after);
    let one_sign = S::ONE - differ * differ;
    let simple = (one_sign + near).select_below(0.5, || S::ZERO, || S::ONE);
    let safe = simple.select_below(0.5, || way, || S::ONE);
    let quotient = (b * b - a * a) * half / safe;
    let slope = after.select_below(0.0, || S::ZERO, || half);
    (
        simple.select_below(0.5, || quotient, || (a + b) * half),
        simple.select_below(0.5, || (b - quotient) / safe, || slope),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    const DEFLECTIONS: [f64; 6] = [-0.3, -0.1, 0.0, 0.05, 0.2, 1.0];

    /// The mean force with the mean rate of an interval of 0.1 s.
    fn at_mean_rate(before: f64, after: f64) -> OneSided<f64> {
        mean_one_sided([before, after], (after - before) / 0.1, 0.03)
    }

    #[test]
    fn the_elastic_part_changes_the_stored_energy_and_damping_takes_energy() {
        let energy = |x: f64| 0.5 * x.max(0.0) * x.max(0.0);
        for before in DEFLECTIONS {
            for after in DEFLECTIONS {
                let mean = at_mean_rate(before, after);
                // Rounding of numbers of about 1.
                assert!((mean.elastic * (after - before) - (energy(after) - energy(before))).abs() < 1e-15);
                assert!((mean.whole - mean.elastic) * (after - before) >= -1e-15, "{before} {after}");
                assert!(mean.whole >= 0.0);
            }
        }
    }

    #[test]
    fn the_mean_force_over_a_short_interval_is_the_force() {
        for deflection in DEFLECTIONS {
            for rate in [-2.0, -0.1, 0.0, 0.5, 20.0] {
                let mean = mean_one_sided([deflection, deflection + 1e-7 * rate], rate, 0.03);
                let [_, now] = one_sided(deflection, rate, 0.03);
                // First order in the interval, at rates of up to 20.
                assert!((mean.whole - now).abs() < 1e-5, "{deflection} {rate} {mean:?} {now:?}");
            }
        }
    }

    #[test]
    fn the_slopes_are_the_derivatives_of_the_mean_force() {
        for before in DEFLECTIONS {
            for after in [-0.25, -0.04, 0.03, 0.21, 0.9] {
                for rate in [-3.1, -0.7, 0.9, 4.3] {
                    let at = |after: f64, rate: f64| mean_one_sided([before, after], rate, 0.03);
                    let by_deflection = (at(after + 1e-6, rate).whole - at(after - 1e-6, rate).whole) / 2e-6;
                    let by_rate = (at(after, rate + 1e-6).whole - at(after, rate - 1e-6).whole) / 2e-6;
                    let [along, per_rate] = at(after, rate).slopes;
                    assert!((by_deflection - along).abs() < 1e-6, "{before} {after} {rate}");
                    assert!((by_rate - per_rate).abs() < 1e-6, "{before} {after} {rate}");
                }
            }
        }
    }
}
