//! Control of the step length.

use super::{Interval, STAGES, Stages, StepError};
use crate::integrate::largest;
use crate::scalar::Scalar;

/// Tolerances for the error of a step, and the largest step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerances {
    /// Absolute error of every coordinate, rad or m, and of every rate, rad/s or m/s.
    pub absolute: f64,
    /// Relative error, added to the absolute one: relative to the motion of a coordinate in the step, and to
    /// a rate.
    pub relative: f64,
    /// Largest step, s.
    pub largest_step_s: f64,
}

/// Weights of order 5 minus those of order 4 (table II.5.2).
const ERROR: [f64; STAGES] =
    [71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339_200.0, 22.0 / 525.0, -1.0 / 40.0];

/// Smallest step, as a share of the step between two output states.
const LEAST: f64 = 1e-5;

/// Ratio of a step to the step that its error would allow.
const SAFETY: f64 = 0.9;

/// Smallest and largest ratio of a step to the one before.
const SHRINK: f64 = 0.2;
const GROWTH: f64 = 5.0;

/// Exponents of the controller.
const PROPORTIONAL: f64 = 0.04;
const INTEGRAL: f64 = 0.2 - 0.75 * PROPORTIONAL;

/// Smallest error for the controller, so that one step with a small error by chance does not determine the
/// next step.
const SMALLEST_ERROR: f64 = 1e-4;

/// Gustafsson's controller: `h (0.9 / e^0.17) e_before^0.04` after a step whose error is e times the allowed one
/// (Hairer & Wanner, *Solving Ordinary Differential Equations II*, 2nd ed., 1996, section IV.2), and `0.9 h / e^0.2`
/// after one that is rejected.
#[derive(Clone, Copy, Debug)]
pub(super) struct Controller {
    pub(super) tolerances: Tolerances,
    first_s: f64,
    /// Proposed next step, s; zero before the first step.
    wanted_s: f64,
    /// Error of the step before.
    before: f64,
    rejected: bool,
}

impl Controller {
    pub(super) fn new(tolerances: Tolerances, first_s: f64) -> Self {
        Self { tolerances, first_s, wanted_s: 0.0, before: 0.0, rejected: false }
    }

    /// Returns the memory of the controller from step to step.
    pub(super) fn memory(&self) -> (f64, f64) {
        (self.wanted_s, self.before)
    }

    pub(super) fn restore(&mut self, wanted_s: f64, before: f64) {
        (self.wanted_s, self.before, self.rejected) = (wanted_s, before, false);
    }

    fn least_s(&self) -> f64 {
        LEAST * self.first_s
    }

    /// Returns the interval of the step to try: up to the edge if it is near, half of the way if it is not
    /// far.
    pub(super) fn interval(&self, start_s: f64, edge_s: f64) -> Interval {
        let wanted_s = if self.wanted_s > 0.0 { self.wanted_s } else { self.first_s };
        let (wanted_s, left_s) = (wanted_s.min(self.tolerances.largest_step_s), edge_s - start_s);
        let end_s = if wanted_s >= left_s {
            edge_s
        } else if 2.0 * wanted_s > left_s {
            start_s + 0.5 * left_s
        } else {
            start_s + wanted_s
        };
        Interval { start_s, end_s }
    }

    /// Returns whether a step with this error is accepted, and sets the length of the next step. A step whose
    /// error is NaN is rejected.
    pub(super) fn accepts(&mut self, step: Interval, error: f64) -> Result<bool, StepError> {
        let h = step.end_s - step.start_s;
        let least_s = self.least_s();
        if error <= 1.0 {
            let error = error.max(SMALLEST_ERROR);
            let before = if self.before > 0.0 { self.before } else { 1.0 };
            let factor = SAFETY * libm::pow(before, PROPORTIONAL) / libm::pow(error, INTEGRAL);
            let most = if self.rejected { 1.0 } else { GROWTH };
            let next_s = h * factor.clamp(SHRINK, most);
            // A step that was shortened to an edge does not limit the next one.
            let whole = h >= self.wanted_s || self.wanted_s == 0.0;
            self.wanted_s = if whole { next_s } else { next_s.max(self.wanted_s) }.max(least_s);
            (self.before, self.rejected) = (error, false);
            return Ok(true);
        }
        let next_s = h * (SAFETY / libm::pow(error, 0.2)).max(SHRINK);
        if next_s < least_s {
            return Err(StepError::Collapsed { time_s: step.start_s, step_s: next_s, least_s });
        }
        (self.wanted_s, self.rejected) = (next_s, true);
        Ok(false)
    }
}

/// Returns the largest ratio of a coordinate's or a rate's error to its tolerance, over all lanes; NaN if an
/// entry is NaN. `v` contains the rates at the start, `motions` the entries of s that count; the stages are at the end.
pub(super) fn error<S: Scalar>(stages: &Stages<S>, tolerances: Tolerances, h: f64, v: &[S], motions: &[usize]) -> f64 {
    let size = |x: S| x.select_below(0.0, || -x, || x);
    let larger = |a: S, b: S| a.select_less(b, || b, || a);
    let (absolute, relative) = (S::constant(tolerances.absolute), S::constant(tolerances.relative));
    let over = |error: S, scale: S| largest(&[error / (absolute + relative * scale)]);
    let mut worst = 0.0_f64;
    for (i, v0) in v.iter().enumerate() {
        let (mut xi_error, mut v_error) = (S::ZERO, S::ZERO);
        for (weight, rates) in ERROR.iter().zip(&stages.rates) {
            let weight = S::constant(h * weight);
            let [xi, v, _] = rates.parts();
            xi_error += weight * xi[i];
            v_error += weight * v[i];
        }
        let [xi, v, _] = stages.place.parts();
        let of_position = over(xi_error, size(xi[i]));
        let of_rate = over(v_error, larger(size(*v0), size(v[i])));
        if of_position.is_nan() || of_rate.is_nan() {
            return f64::NAN;
        }
        worst = worst.max(of_position).max(of_rate);
    }
    for &i in motions {
        let weighted = ERROR.iter().zip(&stages.rates);
        let error = weighted.fold(S::ZERO, |sum, (weight, rates)| sum + S::constant(h * weight) * rates.parts()[2][i]);
        let of_motion = over(error, size(stages.place.parts()[2][i]));
        if of_motion.is_nan() {
            return f64::NAN;
        }
        worst = worst.max(of_motion);
    }
    worst
}
