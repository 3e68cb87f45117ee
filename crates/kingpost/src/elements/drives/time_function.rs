//! Histories: a share of the full strength over time, piecewise linear.

use crate::dynamics::Clock;
use crate::scalar::Scalar;

/// A pulse: rise, hold, through zero to the reverse, hold, and back to rest; without a reverse, back to rest after the
/// first hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pulse {
    /// When it begins, s.
    pub start_s: f64,
    /// Duration of a ramp between zero and full strength, s; the ramp from full strength to full reverse takes twice
    /// this time.
    pub rise_s: f64,
    /// Time at full strength, s.
    pub hold_s: f64,
    /// Time at full reverse, s; 0 for a pulse that does not reverse.
    pub reverse_s: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct LinearPiece<S> {
    start_s: f64,
    start: S,
    slope_per_s: S,
}

/// A piecewise linear history. Its times are plain numbers, at which steps end; its shares may carry
/// derivatives.
#[derive(Clone, Debug, PartialEq)]
pub struct TimeFunction<S = f64> {
    /// Pieces in order of time; the first begins at 0, and each ends at the start of the next.
    pieces: Vec<LinearPiece<S>>,
    edges: Vec<f64>,
}

impl<S: Scalar> TimeFunction<S> {
    /// Returns the constant history 1: the motor is switched on as in the paper.
    pub fn constant() -> Self {
        let mut profile = Self::resting_until(0.0);
        profile.push(0.0, S::ONE, S::ZERO);
        profile
    }

    /// Returns the history of a pulse.
    ///
    /// ```
    /// use kingpost::dynamics::Clock;
    /// use kingpost::elements::drives::{TimeFunction, Pulse};
    /// let pulse = TimeFunction::<f64>::pulse(Pulse { start_s: 5.0, rise_s: 2.0, hold_s: 4.0, reverse_s: 0.0 });
    /// assert_eq!(pulse.edges(), [5.0, 7.0, 11.0, 13.0]);
    /// assert_eq!(pulse.value(Clock { time_s: 6.0, middle_s: 6.0 }), 0.5);
    /// assert_eq!(pulse.value(Clock { time_s: 14.0, middle_s: 14.0 }), 0.0);
    /// ```
    pub fn pulse(pulse: Pulse) -> Self {
        let Pulse { start_s, rise_s, hold_s, reverse_s } = pulse;
        let forward = [(rise_s, 0.0, 1.0), (hold_s, 1.0, 1.0)];
        let back: &[_] = if reverse_s > 0.0 {
            &[(2.0 * rise_s, 1.0, -1.0), (reverse_s, -1.0, -1.0), (rise_s, -1.0, 0.0)]
        } else {
            &[(rise_s, 1.0, 0.0)]
        };
        let (mut profile, mut time) = (Self::resting_until(start_s), start_s);
        for &(length_s, start, end) in forward.iter().chain(back) {
            if length_s > 0.0 {
                profile.push(time, S::constant(start), S::constant((end - start) / length_s));
                time += length_s;
            }
        }
        profile.push(time, S::ZERO, S::ZERO);
        profile
    }

    /// Returns the history that is linear between shares at given times, s, which do not decrease: zero before the
    /// first time, the last share after the last time. Two shares at one time are a jump.
    pub fn list(times_s: &[f64], shares: &[S]) -> Self {
        let points: Vec<(f64, S)> = times_s.iter().copied().zip(shares.iter().copied()).collect();
        let mut profile = Self::resting_until(points.first().map_or(0.0, |(start_s, _)| *start_s));
        for pair in points.windows(2) {
            let ((start_s, start), (end_s, end)) = (pair[0], pair[1]);
            if end_s > start_s {
                profile.push(start_s, start, (end - start) / S::constant(end_s - start_s));
            }
        }
        let (end_s, end) = points.last().copied().unwrap_or((0.0, S::ZERO));
        profile.push(end_s, end, S::ZERO);
        profile
    }

    /// Returns a history that is zero up to a time, s; the caller adds the pieces after it.
    fn resting_until(start_s: f64) -> Self {
        let mut profile = Self { pieces: Vec::new(), edges: Vec::new() };
        if start_s > 0.0 {
            profile.push(0.0, S::ZERO, S::ZERO);
        }
        profile
    }

    fn push(&mut self, start_s: f64, start: S, slope_per_s: S) {
        self.pieces.push(LinearPiece { start_s, start, slope_per_s });
        if start_s > 0.0 {
            self.edges.push(start_s);
        }
    }

    #[inline]
    fn piece(&self, clock: Clock) -> &LinearPiece<S> {
        if let [only] = self.pieces.as_slice() {
            return only;
        }
        let after = self.pieces.partition_point(|p| p.start_s <= clock.middle_s);
        &self.pieces[after.max(1) - 1]
    }

    /// Returns the value.
    pub fn value(&self, clock: Clock) -> S {
        let piece = self.piece(clock);
        piece.start + piece.slope_per_s * S::constant(clock.time_s - piece.start_s)
    }

    /// Returns the rate, 1/s.
    pub fn slope_per_s(&self, clock: Clock) -> S {
        self.piece(clock).slope_per_s
    }

    /// Returns the first edge after a time, s; infinity if there is none.
    pub fn next_edge_s(&self, after_s: f64) -> f64 {
        let first = self.edges.partition_point(|&edge| edge <= after_s);
        self.edges.get(first).copied().unwrap_or(f64::INFINITY)
    }

    /// Returns the times between pieces, s, in order.
    pub fn edges(&self) -> &[f64] {
        &self.edges
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(time_s: f64) -> Clock {
        Clock { time_s, middle_s: time_s + 1e-9 }
    }

    fn pulse(start_s: f64, rise_s: f64, hold_s: f64, reverse_s: f64) -> TimeFunction {
        TimeFunction::pulse(Pulse { start_s, rise_s, hold_s, reverse_s })
    }

    #[test]
    fn a_pulse_rises_holds_reverses_and_rests() {
        let points = [
            (0.0, 0.0),
            (0.125, 0.5),
            (0.25, 1.0),
            (0.7, 1.0),
            (1.0, 0.0),
            (1.25, -1.0),
            (1.6, -1.0),
            (1.875, -0.5),
            (3.0, 0.0),
        ];
        let (now, later) = (pulse(0.0, 0.25, 0.5, 0.5), pulse(8.0, 0.25, 0.5, 0.5));
        for (time, value) in points {
            assert!((now.value(at(time)) - value).abs() < 1e-12, "at {time} s");
            assert!((later.value(at(8.0 + time)) - value).abs() < 1e-7, "at {time} s");
        }
        assert_eq!(now.edges(), [0.25, 0.75, 1.25, 1.75, 2.0]);
        assert_eq!(later.edges(), [8.0, 8.25, 8.75, 9.25, 9.75, 10.0]);
        assert_eq!(later.value(at(7.9)), 0.0);
    }

    #[test]
    fn a_pulse_without_a_reverse_goes_back_to_rest_and_stays() {
        let profile = pulse(0.0, 0.25, 0.5, 0.0);
        assert_eq!(profile.edges(), [0.25, 0.75, 1.0]);
        for (time, value) in [(0.5, 1.0), (0.875, 0.5), (1.0, 0.0), (1.1, 0.0), (100.0, 0.0)] {
            assert!((profile.value(at(time)) - value).abs() < 1e-8, "at {time} s");
        }
        let jumps = pulse(1.0, 0.0, 2.0, 0.0);
        assert_eq!(jumps.edges(), [1.0, 3.0]);
        assert_eq!([0.5, 1.5, 3.5].map(|time| jumps.value(at(time))), [0.0, 1.0, 0.0]);
    }

    #[test]
    fn a_list_is_zero_before_straight_between_and_stays_at_its_last_share() {
        let profile = TimeFunction::list(&[5.0, 8.0, 8.0, 20.0], &[0.0, 1.0, -0.5, 0.25]);
        assert_eq!(profile.edges(), [5.0, 8.0, 20.0]);
        let points = [(0.0, 0.0), (4.9, 0.0), (6.5, 0.5), (8.0, -0.5), (14.0, -0.125), (20.0, 0.25), (99.0, 0.25)];
        for (time, value) in points {
            assert!((profile.value(at(time)) - value).abs() < 1e-12, "at {time} s");
        }
        assert_eq!(TimeFunction::list(&[0.0], &[1.0]), TimeFunction::constant());
        assert_eq!(profile.value(Clock { time_s: 8.0, middle_s: 7.9 }), 1.0);
    }

    #[test]
    fn an_edge_belongs_to_the_interval_that_is_stepped() {
        let profile = pulse(0.0, 0.0, 1.0, 1.0);
        assert_eq!(profile.value(Clock { time_s: 1.0, middle_s: 0.95 }), 1.0);
        assert_eq!(profile.value(Clock { time_s: 1.0, middle_s: 1.05 }), -1.0);
    }
}
