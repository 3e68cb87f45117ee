//! Motion of the water at many points: velocity and acceleration by sums over arrays, without elevation and pressure.

use core::f64::consts::{LOG2_E, TAU};

use super::field::{BLOCK, WaveField};
use super::stretching::{StretchedHeight, Stretching};
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// Depth over which a wave decays by e^-DEEP, in its wave lengths over 2 pi: its motion there is below the rounding of that at
/// the surface.
const DEEP: f64 = 40.0;

impl<S: Scalar> WaveField<S> {
    /// Returns whether a point at this height, m, is under water at any time, and moves there by its height in still water
    /// alone, whatever the elevation.
    pub fn is_always_under(&self, height_m: S) -> bool {
        self.stretching() != Stretching::Wheeler && (height_m + self.highest_m).all(|above| above < 0.0)
    }

    /// Returns velocity and acceleration of the water, world, m/s and m/s^2: those of [`Self::kinematics`] to rounding, for a
    /// known elevation over the point, m. Where [`Self::is_always_under`] holds, any elevation may be given.
    ///
    /// ```
    /// use kingpost::sea::waves::{Water, WaveComponent, WaveField};
    /// use kingpost::spatial::Vector3;
    /// let water = Water::default();
    /// let field = WaveField::new(&[WaveComponent::in_water(&water, 1.0, 0.8, 0.5, 0.3)], water, 0.0);
    /// let point = Vector3::new(4.0, -3.0, -6.0);
    /// let [velocity, _] = field.motion(point, 0.0, 2.0);
    /// assert!((velocity - field.kinematics(point, 2.0).velocity_m_s).norm() < 1e-14);
    /// ```
    pub fn motion(&self, point: Vector3<S>, elevation_m: S, time_s: f64) -> [Vector3<S>; 2] {
        let [x, y, z] = point.0;
        let StretchedHeight { z: level, rise } = self.height(z, elevation_m);
        let mirrored = self.water().depth_m.map(|depth_m| level + S::constant(2.0 * depth_m));
        let (mut cosines, mut sines) = ([S::ZERO; BLOCK], [S::ZERO; BLOCK]);
        let (mut levels, mut upwards) = ([S::ZERO; BLOCK], [S::ZERO; BLOCK]);
        let (mut velocity, mut acceleration) = ([S::ZERO; 3], [S::ZERO; 3]);
        for first in (0..self.len()).step_by(BLOCK) {
            let count = BLOCK.min(self.len() - first);
            let reach = self.least_wave_numbers_per_m[first / BLOCK] * level;
            let reaches = reach.select_below(-DEEP, || S::ZERO, || S::ONE);
            if reaches.all(|reaches| reaches == 0.0) {
                continue;
            }
            self.unit_phasors(first, [x, y], time_s, &mut cosines[..count], &mut sines[..count]);
            for i in 0..count {
                let k = self.wave_numbers_per_m[first + i];
                let doublings = k * S::constant(LOG2_E);
                let down = (doublings * level).power_of_two();
                let (mut c, mut d) = (down, down);
                if let Some(mirrored) = mirrored {
                    let up = (-doublings * mirrored).power_of_two();
                    let scale = self.bottom_scales[first + i];
                    (c, d) = ((down + up) * scale, (down - up) * scale);
                }
                let further = k * rise;
                (levels[i], upwards[i]) = ((c + further * d) * reaches, (d + further * c) * k * reaches);
            }
            for i in 0..count {
                let [kx, ky] = [self.turns.x_per_m[first + i], self.turns.y_per_m[first + i]];
                let a = self.amplitudes_m[first + i];
                let (level, upward) = (levels[i] * a, upwards[i] * a);
                let (real, imaginary) = (level * cosines[i], level * sines[i]);
                let period = self.periods_s[first + i];
                velocity[0] += kx * real * period;
                velocity[1] += ky * real * period;
                velocity[2] += upward * sines[i] * period;
                acceleration[0] += kx * imaginary;
                acceleration[1] += ky * imaginary;
                acceleration[2] -= upward * cosines[i];
            }
        }
        let gravity = S::constant(self.water().gravity_m_s2 * self.ramp(time_s));
        let turn = S::constant(TAU);
        let scaled = |[x, y, z]: [S; 3], k: S| Vector3::new(x * turn * k, y * turn * k, z * k);
        let moving = |vector: Vector3<S>| Vector3(vector.0.map(|x| self.stretching().moving(z, x)));
        [moving(scaled(velocity, gravity * S::constant(1.0 / TAU))), moving(scaled(acceleration, gravity))]
    }
}
