//! The filter between where a hull is and where its loads of first order are taken.

use super::place::SlowFrame;
use crate::scalar::Scalar;

/// How many filters stand in a row.
const ORDER: usize = 4;
/// x, y, heading, roll and pitch.
const COUNT: usize = 5;

/// Place, heading, roll and pitch through `H(s) = (1 + 4 s/w) / (1 + s/w)^4`, w the cut-off.
///
/// Four filters of first order stand in a row, `x1' = w (x - x1)` to `x4' = w (x3 - x4)`, and `4 x3 - 3 x4` comes out: a
/// place that drifts at a steady speed without any lag, since H = 1 + O(s^2). Of a motion with the waves, at omega far
/// above w, there remain `4 (w / omega)^3`, 0.1 % of a period of 8 s: as the phase of the loads it makes a mean force of
/// that share of `k X a^2 / 2`, small beside the drift. One filter of first order would leave `w / omega`, 6 %, which
/// makes more than the drift.
///
/// Stepped exactly for a place that is constant over a step, and held in between.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlowFilter<S = f64> {
    /// x, y (m), heading, roll and pitch (rad) behind each filter.
    stages: [[S; COUNT]; ORDER],
}

impl<S: Scalar> SlowFilter<S> {
    /// Number of its numbers among what forces hold.
    pub const LEN: usize = COUNT * ORDER;

    /// Where a hull has always been.
    pub fn at_rest(place: &SlowFrame<S>) -> Self {
        let ([x, y], [roll, pitch]) = (place.position, place.lean);
        Self { stages: [[x, y, place.heading, roll, pitch]; ORDER] }
    }

    /// From what a force holds.
    pub fn read(held: &[S]) -> Self {
        Self { stages: core::array::from_fn(|stage| core::array::from_fn(|k| held[COUNT * stage + k])) }
    }

    /// Into what a force holds.
    pub fn write(&self, held: &mut [S]) {
        for (held, stage) in held.chunks_exact_mut(COUNT).zip(&self.stages) {
            held.copy_from_slice(stage);
        }
    }

    /// What comes out.
    pub fn frame(&self) -> SlowFrame<S> {
        let [.., x3, x4] = &self.stages;
        let [x, y, heading, roll, pitch] = combined(x3, x4);
        SlowFrame { position: [x, y], heading, lean: [roll, pitch] }
    }

    /// The rate of what comes out: of x and y, world, m/s, and of the heading, rad/s.
    pub fn rates(&self, cutoff_rad_s: f64) -> [S; 3] {
        let [.., x2, x3, x4] = &self.stages;
        let cutoff = S::constant(cutoff_rad_s);
        let rate = |from: &[S; COUNT], to: &[S; COUNT]| core::array::from_fn(|k| cutoff * (from[k] - to[k]));
        let [x, y, heading, ..] = combined(&rate(x2, x3), &rate(x3, x4));
        [x, y, heading]
    }

    /// After a step of `step_s` to the place `now`.
    pub fn stepped(&self, now: &SlowFrame<S>, cutoff_rad_s: f64, step_s: f64) -> Self {
        let slow = self.frame();
        let ([x, y], [roll, pitch]) = (now.position, now.lean);
        let input = [x, y, onward(slow.heading, now.heading), onward(slow.lean[0], roll), pitch];
        let shares = shares(cutoff_rad_s * step_s);
        let after = |stage: usize, k: usize| {
            let share = |earlier: usize| S::constant(shares[stage - earlier]) * (self.stages[earlier][k] - input[k]);
            (0..=stage).fold(input[k], |sum, earlier| sum + share(earlier))
        };
        Self { stages: core::array::from_fn(|stage| core::array::from_fn(|k| after(stage, k))) }
    }
}

/// The angle `now`, less full turns away from `last`.
fn onward<S: Scalar>(last: S, now: S) -> S {
    let (sin, cos) = (now - last).sin_cos();
    last + sin.atan2(cos)
}

/// What a filter keeps of itself, and of those before it one, two and three places ahead, after the time t / w:
/// `e^-t t^n / n!`.
fn shares(t: f64) -> [f64; ORDER] {
    let decay = libm::exp(-t);
    [decay, decay * t, decay * t * t / 2.0, decay * t * t * t / 6.0]
}

/// 4 x3 - 3 x4.
fn combined<S: Scalar>(x3: &[S; COUNT], x4: &[S; COUNT]) -> [S; COUNT] {
    core::array::from_fn(|k| S::constant(4.0) * x3[k] - S::constant(3.0) * x4[k])
}

#[cfg(test)]
mod tests {
    use super::*;

    const CUTOFF_RAD_S: f64 = 0.05;
    const STEP_S: f64 = 0.05;

    /// The slow frame's x and heading after each step of a motion that both make.
    fn filtered(steps: usize, motion: impl Fn(f64) -> f64) -> Vec<[f64; 2]> {
        let place = |time_s: f64| SlowFrame {
            position: [motion(time_s), 0.0],
            heading: motion(time_s),
            lean: [motion(time_s), 0.0],
        };
        let mut filter = SlowFilter::at_rest(&place(0.0));
        let after = |k: usize| {
            filter = filter.stepped(&place(k as f64 * STEP_S), CUTOFF_RAD_S, STEP_S);
            [filter.frame().position[0], filter.frame().heading]
        };
        (1..=steps).map(after).collect()
    }

    /// H(s) = 1 + O(s^2): a ramp is followed, through full turns of the heading too, to the half step by which a place
    /// that is held over a step runs ahead.
    #[test]
    fn a_steady_drift_has_no_lag() {
        let speed = 0.1;
        let last = *filtered(12_000, |time_s| speed * time_s).last().unwrap();
        for value in last {
            assert!((value - speed * (600.0 + 0.5 * STEP_S)).abs() < 1e-4 * speed * STEP_S, "{value}");
        }
    }

    /// |H| and its phase at a wave's frequency; a place held over a step turns the phase by half a step.
    #[test]
    fn of_a_motion_with_the_waves_what_the_transfer_function_says_remains() {
        let omega = core::f64::consts::TAU / 8.0;
        let all = filtered(16_000, |time_s| libm::sin(omega * time_s));
        // Over the last 20 periods: what goes with the sine, and with the cosine.
        let periods = &all[16_000 - 3_200..];
        let mut parts = [0.0; 2];
        for (k, [x, _]) in periods.iter().enumerate() {
            let (sin, cos) = libm::sincos(omega * (12_801 + k) as f64 * STEP_S);
            parts[0] += 2.0 * x * sin / 3_200.0;
            parts[1] += 2.0 * x * cos / 3_200.0;
        }
        let r = omega / CUTOFF_RAD_S;
        let size = libm::sqrt(1.0 + 16.0 * r * r) / ((1.0 + r * r) * (1.0 + r * r));
        let phase = libm::atan(4.0 * r) - 4.0 * libm::atan(r);
        let (sin, cos) = libm::sincos(phase + 0.5 * omega * STEP_S);
        assert!(size < 0.00105);
        // (omega h)^2 / 24 of what is held is lost.
        assert!((parts[0] - size * cos).abs() < 1e-3 * size && (parts[1] - size * sin).abs() < 1e-3 * size);
    }

    #[test]
    fn its_rates_are_those_of_what_comes_out() {
        let place =
            |time_s: f64| SlowFrame { position: [time_s, libm::sin(time_s)], heading: 0.3 * time_s, lean: [0.0; 2] };
        let mut filter = SlowFilter::at_rest(&place(0.0));
        for k in 1..200 {
            filter = filter.stepped(&place(0.05 * f64::from(k)), CUTOFF_RAD_S, STEP_S);
        }
        // A step of no length to the same place: the rates are the differences' limit.
        let later = filter.stepped(&place(200.0 * 0.05), CUTOFF_RAD_S, 1e-6);
        let rates = filter.rates(CUTOFF_RAD_S);
        let [before, after] =
            [filter, later].map(|filter| filter.frame()).map(|f| [f.position[0], f.position[1], f.heading]);
        for k in 0..3 {
            assert!(((after[k] - before[k]) / 1e-6 - rates[k]).abs() < 1e-6, "{k}");
        }
    }
}
