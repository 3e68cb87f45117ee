//! A body that moves with the waves by response amplitude operators.

use crate::dynamics::Clock;
use crate::elements::{Declaration, Element, Support};
use crate::scalar::Scalar;
use crate::world::World;
use core::f64::consts::TAU;

/// The six coordinates of a body that moves with the waves, `q(t) = r(t) Re sum X a e^(-i w t)` with exact rates and
/// accelerations; r is the ramp of the world's waves.
#[derive(Clone, Debug)]
pub struct WaveMotion<S = f64> {
    /// Index of the first in v.
    pub velocities: usize,
    /// Index of the first in q.
    pub positions: usize,
    /// w, rad/s, and the real and imaginary part of X a of each coordinate, for each wave.
    pub waves: Vec<(f64, [[S; 2]; 6])>,
}

/// Coordinates, their rates and their accelerations, in m or rad and s.
#[derive(Clone, Copy, Debug)]
pub struct SixMotions<S> {
    /// q.
    pub positions: [S; 6],
    /// q'.
    pub rates: [S; 6],
    /// q''.
    pub accelerations: [S; 6],
}

impl<S: Scalar> Element<S> for WaveMotion<S> {
    fn declare(&self) -> Declaration {
        Declaration { prescribes: true, ..Declaration::default() }
    }

    fn given_positions(&self, world: &World<S>, time_s: f64) -> Option<(usize, [S; 6])> {
        Some((self.positions, self.at(world, time_s).positions))
    }

    fn prescribe(&self, world: &World<S>, clock: Clock, rates: &mut [S], accelerations: &mut [S]) {
        let motion = self.at(world, clock.time_s);
        rates[self.coordinates()].copy_from_slice(&motion.rates);
        accelerations[self.coordinates()].copy_from_slice(&motion.accelerations);
    }

    fn supports(&self) -> Vec<Support> {
        self.coordinates().map(Support::Coordinate).collect()
    }
}

impl<S: Scalar> WaveMotion<S> {
    /// Returns the indices of its coordinates in v.
    pub fn coordinates(&self) -> core::ops::Range<usize> {
        self.velocities..self.velocities + 6
    }

    /// Returns the motions at a time.
    pub fn at(&self, world: &World<S>, time_s: f64) -> SixMotions<S> {
        let [ramp, ramp_rate, ramp_acceleration] = world.wave_ramp(time_s).map(S::constant);
        let steady = self.steady(time_s);
        let two = S::constant(2.0);
        SixMotions {
            positions: steady.map(|[x, _, _]| ramp * x),
            rates: steady.map(|[x, x_dot, _]| ramp * x_dot + ramp_rate * x),
            accelerations: steady
                .map(|[x, x_dot, x_ddot]| ramp * x_ddot + two * ramp_rate * x_dot + ramp_acceleration * x),
        }
    }

    /// Returns the motions without the ramp: each coordinate with its rate and acceleration.
    fn steady(&self, time_s: f64) -> [[S; 3]; 6] {
        let mut sums = [[S::ZERO; 3]; 6];
        for (omega, responses) in &self.waves {
            let (sin, cos) = (omega / TAU * time_s).sin_cos_of_turns();
            let (sin, cos, omega) = (S::constant(sin), S::constant(cos), S::constant(*omega));
            for (sum, [real, imaginary]) in sums.iter_mut().zip(responses) {
                let value = *real * cos + *imaginary * sin;
                sum[0] += value;
                sum[1] += omega * (*imaginary * cos - *real * sin);
                sum[2] -= omega * omega * value;
            }
        }
        sums
    }
}
