//! A prescribed oscillation of a coordinate.

use crate::dynamics::Clock;
use crate::elements::{Declaration, Element, Support};
use crate::scalar::Scalar;
use crate::sea::waves::ramp;
use crate::world::World;

/// The motion of a coordinate about its initial value,
///
/// ```text
/// q = q_0 + s(t / T_r) A sin(w t + phi),    s(x) = x^3 (10 - 15 x + 6 x^2)
/// ```
///
/// with s = 1 after the ramp T_r. Position, rate and acceleration are continuous, and zero at the start.
#[derive(Clone, Copy, Debug)]
pub struct Oscillation<S = f64> {
    /// Index in v.
    pub coordinate: usize,
    /// A, rad or m.
    pub amplitude: S,
    /// w, rad/s.
    pub frequency_rad_s: S,
    /// phi, rad.
    pub phase_rad: S,
    /// T_r, s.
    pub ramp_s: f64,
}

impl<S: Scalar> Element<S> for Oscillation<S> {
    fn declare(&self) -> Declaration {
        Declaration { prescribes: true, ..Declaration::default() }
    }

    fn prescribe(&self, _world: &World<S>, clock: Clock, rates: &mut [S], accelerations: &mut [S]) {
        [_, rates[self.coordinate], accelerations[self.coordinate]] = self.motion(clock);
    }

    fn next_edge_s(&self, after_s: f64, _modes: &[i64]) -> f64 {
        if after_s < self.ramp_s { self.ramp_s } else { f64::INFINITY }
    }

    fn supports(&self) -> Vec<Support> {
        vec![Support::Coordinate(self.coordinate)]
    }
}

impl<S: Scalar> Oscillation<S> {
    /// Returns the displacement from the initial value, its rate and its acceleration.
    ///
    /// ```
    /// use kingpost::dynamics::Clock;
    /// use kingpost::elements::drives::Oscillation;
    /// let swing = Oscillation { coordinate: 0, amplitude: 0.5, frequency_rad_s: 2.0, phase_rad: 0.0, ramp_s: 1.0 };
    /// let [position, rate, acceleration] = swing.motion(Clock { time_s: 4.0, middle_s: 4.0 });
    /// assert_eq!(position, 0.5 * f64::sin(8.0));
    /// assert_eq!([rate, acceleration], [f64::cos(8.0), -4.0 * position]);
    /// ```
    pub fn motion(&self, clock: Clock) -> [S; 3] {
        let phase = self.frequency_rad_s * S::constant(clock.time_s) + self.phase_rad;
        let (sine, cosine) = phase.sin_cos();
        let position = self.amplitude * sine;
        let rate = self.amplitude * self.frequency_rad_s * cosine;
        let acceleration = -(self.frequency_rad_s * self.frequency_rad_s * position);
        let [share, first, second] = ramp(clock.time_s, self.ramp_s).map(S::constant);
        let twice = first + first;
        [share * position, share * rate + first * position, share * acceleration + twice * rate + second * position]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Central differences, whose error is of second order in the step; near the end of the ramp, where the third
    /// derivative jumps, of first order.
    #[test]
    fn rate_and_acceleration_are_the_derivatives_of_the_position_and_start_and_continue_without_a_jump() {
        let swing = Oscillation { coordinate: 0, amplitude: 0.3, frequency_rad_s: 1.7, phase_rad: 0.8, ramp_s: 2.0 };
        let at = |time_s: f64| swing.motion(Clock { time_s, middle_s: time_s });
        let h = 1e-5;
        for time in [0.4, 1.0, 1.9, 2.0, 3.1] {
            let [position, rate, acceleration] = at(time);
            let (before, after) = (at(time - h), at(time + h));
            assert!(((after[0] - before[0]) / (2.0 * h) - rate).abs() < 1e-9, "at {time} s");
            assert!(((after[1] - before[1]) / (2.0 * h) - acceleration).abs() < 1e-4, "at {time} s");
            assert!(position.abs() <= 0.3);
        }
        assert_eq!(at(0.0), [0.0; 3]);
        let end = swing.motion(Clock { time_s: 2.0, middle_s: 1.9 });
        for (ramp, after) in end.iter().zip(at(2.0)) {
            assert!((ramp - after).abs() < 1e-12);
        }
    }
}
