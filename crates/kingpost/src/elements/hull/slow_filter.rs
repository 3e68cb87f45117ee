//! The filter between a hull's position and the position where its first-order loads are computed.

use super::place::LowFrequencyFrame;
use crate::elements::StateDeclaration;
use crate::scalar::Scalar;

/// Number of filters in series.
const ORDER: usize = 6;
/// x, y, heading, roll and pitch.
const COUNT: usize = 5;

/// Position, heading, roll and pitch through `H(s) = (1 + 6 s/w) / (1 + s/w)^6`, w being the cut-off.
///
/// Six first-order filters in series, `x1' = w (x - x1)` to `x6' = w (x5 - x6)`; the output is `6 x5 - 5 x6`. A
/// position that drifts at a steady speed passes without lag, since H = 1 + O(s^2). A motion at a wave frequency omega
/// far above w is reduced to `6 (w / omega)^5`, which is 5e-5 at a period of 8 s; as a phase error of the loads this
/// causes a mean force of the same share of `k X a^2 / 2`. The share must be so small because nothing holds the heading
/// of a free ship: a thousandth of the drift would turn the ship within an hour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlowFilter<S = f64> {
    /// x, y (m), heading, roll and pitch (rad) after each filter.
    stages: [[S; COUNT]; ORDER],
}

impl<S: Scalar> SlowFilter<S> {
    /// Number of its states.
    pub const LEN: usize = COUNT * ORDER;

    /// Returns the steady state for a constant velocity (world, m/s) without rotation.
    pub fn steady(place: &LowFrequencyFrame<S>, [vx, vy]: [S; 2], cutoff_rad_s: f64) -> Self {
        let ([x, y], [roll, pitch]) = (place.position, place.lean);
        let behind = |stage: usize, speed: S| speed * S::constant((stage + 1) as f64 / cutoff_rad_s);
        let stage = |k: usize| [x - behind(k, vx), y - behind(k, vy), place.heading, roll, pitch];
        Self { stages: core::array::from_fn(stage) }
    }

    /// Returns the declarations of its states.
    pub fn declared() -> impl Iterator<Item = StateDeclaration> {
        let signals = [("x", "m"), ("y", "m"), ("heading", "rad"), ("roll", "rad"), ("pitch", "rad")];
        let of = move |stage: usize| {
            signals.map(|(name, unit)| StateDeclaration::memory(format!("slow.{name}.{stage}"), unit))
        };
        (1..=ORDER).flat_map(of)
    }

    /// Reads the filter from its states, which are the first of `states`.
    pub fn read(states: &[S]) -> Self {
        Self { stages: core::array::from_fn(|stage| core::array::from_fn(|k| states[COUNT * stage + k])) }
    }

    /// Writes the filter to its states.
    pub fn write(&self, states: &mut [S]) {
        for (states, stage) in states.chunks_exact_mut(COUNT).zip(&self.stages) {
            states.copy_from_slice(stage);
        }
    }

    /// Returns the output.
    pub fn frame(&self) -> LowFrequencyFrame<S> {
        let [.., before, last] = &self.stages;
        let [x, y, heading, roll, pitch] = combined(before, last);
        LowFrequencyFrame { position: [x, y], heading, lean: [roll, pitch] }
    }

    /// Returns the rate of the output: x and y, world, m/s, and heading, rad/s.
    pub fn output_rates(&self, cutoff_rad_s: f64) -> [S; 3] {
        let [.., second, before, last] = &self.stages;
        let cutoff = S::constant(cutoff_rad_s);
        let rate = |from: &[S; COUNT], to: &[S; COUNT]| core::array::from_fn(|k| cutoff * (from[k] - to[k]));
        let [x, y, heading, ..] = combined(&rate(second, before), &rate(before, last));
        [x, y, heading]
    }

    /// Returns the rates of its states for a hull at `now`.
    pub fn rates(&self, now: &LowFrequencyFrame<S>, cutoff_rad_s: f64) -> Self {
        let slow = self.frame();
        let ([x, y], [roll, pitch]) = (now.position, now.lean);
        let input = [x, y, onward(slow.heading, now.heading), onward(slow.lean[0], roll), pitch];
        let cutoff = S::constant(cutoff_rad_s);
        let before = |stage: usize, k: usize| if stage == 0 { input[k] } else { self.stages[stage - 1][k] };
        let rate = |stage: usize, k: usize| cutoff * (before(stage, k) - self.stages[stage][k]);
        Self { stages: core::array::from_fn(|stage| core::array::from_fn(|k| rate(stage, k))) }
    }
}

/// Returns the angle `now`, changed by full turns to be nearest to `last`.
fn onward<S: Scalar>(last: S, now: S) -> S {
    let (sin, cos) = (now - last).sin_cos();
    last + sin.atan2(cos)
}

/// Returns 6 x5 - 5 x6.
fn combined<S: Scalar>(before: &[S; COUNT], last: &[S; COUNT]) -> [S; COUNT] {
    const N: f64 = ORDER as f64;
    core::array::from_fn(|k| S::constant(N) * before[k] - S::constant(N - 1.0) * last[k])
}

#[cfg(test)]
mod tests {
    use super::*;

    const CUTOFF_RAD_S: f64 = 0.075;
    const STEP_S: f64 = 0.05;

    fn place(motion: f64) -> LowFrequencyFrame {
        LowFrequencyFrame { position: [motion, 0.0], heading: motion, lean: [motion, 0.0] }
    }

    /// Returns the states after one RK4 step of a given motion.
    fn stepped(filter: &SlowFilter, start_s: f64, step_s: f64, motion: &dyn Fn(f64) -> f64) -> SlowFilter {
        let rates = |states: &SlowFilter, time_s: f64| states.rates(&place(motion(time_s)), CUTOFF_RAD_S);
        let moved = |by: f64, rates: &SlowFilter| {
            let entry = |stage: usize, k: usize| filter.stages[stage][k] + by * rates.stages[stage][k];
            SlowFilter { stages: core::array::from_fn(|stage| core::array::from_fn(|k| entry(stage, k))) }
        };
        let half = 0.5 * step_s;
        let first = rates(filter, start_s);
        let second = rates(&moved(half, &first), start_s + half);
        let third = rates(&moved(half, &second), start_s + half);
        let fourth = rates(&moved(step_s, &third), start_s + step_s);
        let all = [(1.0, first), (2.0, second), (2.0, third), (1.0, fourth)];
        let sum =
            |stage: usize, k: usize| all.iter().map(|(weight, rates)| weight * rates.stages[stage][k]).sum::<f64>();
        let mean = SlowFilter { stages: core::array::from_fn(|stage| core::array::from_fn(|k| sum(stage, k) / 6.0)) };
        moved(step_s, &mean)
    }

    /// Returns the slow frame's x and heading after each step, for a hull whose x and heading follow the given motion.
    fn filtered(steps: usize, motion: impl Fn(f64) -> f64) -> Vec<[f64; 2]> {
        let mut filter = SlowFilter::steady(&place(motion(0.0)), [0.0; 2], CUTOFF_RAD_S);
        let after = |k: usize| {
            filter = stepped(&filter, k as f64 * STEP_S, STEP_S, &motion);
            [filter.frame().position[0], filter.frame().heading]
        };
        (0..steps).map(after).collect()
    }

    /// H(s) = 1 + O(s^2): the filter follows a ramp, also through full turns of the heading. RK4 is exact for a ramp
    /// except for the transient, 45^5 e^-45.
    #[test]
    fn a_steady_drift_has_no_lag() {
        let speed = 0.03;
        let last = *filtered(12_000, |time_s| speed * time_s).last().unwrap();
        for value in last {
            assert!((value - speed * 600.0).abs() < 1e-9 * speed * 600.0, "{value}");
        }
    }

    /// A steady drift before the start is filtered correctly from the start.
    #[test]
    fn a_steady_drift_before_the_start_has_no_lag_at_the_start() {
        let past = SlowFilter::steady(&place(2.0), [0.7, -0.3], CUTOFF_RAD_S);
        let [x, y, _] = past.output_rates(CUTOFF_RAD_S);
        assert!((past.frame().position[0] - 2.0).abs() < 1e-12 && (past.frame().heading - 2.0).abs() < 1e-12);
        assert!((x - 0.7).abs() < 1e-12 && (y + 0.3).abs() < 1e-12, "{x} {y}");
    }

    /// |H| and its phase at a wave's frequency.
    #[test]
    fn a_motion_at_a_wave_frequency_is_reduced_by_the_transfer_function() {
        let omega = core::f64::consts::TAU / 8.0;
        let all = filtered(16_000, |time_s| libm::sin(omega * time_s));
        // Over the last 20 periods: the sine and the cosine component.
        let periods = &all[16_000 - 3_200..];
        let mut parts = [0.0; 2];
        for (k, [x, _]) in periods.iter().enumerate() {
            let (sin, cos) = libm::sincos(omega * (12_801 + k) as f64 * STEP_S);
            parts[0] += 2.0 * x * sin / 3_200.0;
            parts[1] += 2.0 * x * cos / 3_200.0;
        }
        let r = omega / CUTOFF_RAD_S;
        let size = libm::sqrt(1.0 + 36.0 * r * r) / libm::pow(1.0 + r * r, 3.0);
        let phase = libm::atan(6.0 * r) - 6.0 * libm::atan(r);
        let (sin, cos) = libm::sincos(phase);
        assert!(size < 5e-5);
        // RK4 integrates by Simpson's rule, whose error is (omega h)^4 / 2880 of the input.
        assert!((parts[0] - size * cos).abs() < 1e-3 * size && (parts[1] - size * sin).abs() < 1e-3 * size);
    }

    #[test]
    fn its_output_rates_are_those_of_what_comes_out() {
        let motion = |time_s: f64| libm::sin(0.3 * time_s) + 0.2 * time_s;
        let mut filter = SlowFilter::steady(&place(0.0), [0.0; 2], CUTOFF_RAD_S);
        for k in 0..200 {
            filter = stepped(&filter, 0.05 * f64::from(k), 0.05, &motion);
        }
        // The output rates are the limits of difference quotients.
        let later = stepped(&filter, 10.0, 1e-6, &motion);
        let rates = filter.output_rates(CUTOFF_RAD_S);
        let [before, after] =
            [filter, later].map(|filter| filter.frame()).map(|f| [f.position[0], f.position[1], f.heading]);
        for k in 0..3 {
            assert!(((after[k] - before[k]) / 1e-6 - rates[k]).abs() < 1e-6, "{k}");
        }
    }
}
