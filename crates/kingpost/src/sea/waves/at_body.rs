//! The sea at a body that is small compared with the waves: the surface, approximated by a plane, and the
//! water's motion at one depth.

use core::f64::consts::{LN_2, LOG2_E};

use super::field::WaveField;
use super::stretching::StretchedHeight;
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// Surface of the sea over a point, with its derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocalSurface<S = f64> {
    /// Elevation above the still water, m.
    pub elevation: S,
    /// Slopes along the world's x and y.
    pub slopes: [S; 2],
    /// Rate of the elevation, m/s.
    pub rate: S,
    /// Rates of the slopes, 1/s.
    pub slope_rates: [S; 2],
    /// Second derivatives of the elevation: xx, xy and yy, 1/m.
    pub curvatures: [S; 3],
}

impl<S: Scalar> LocalSurface<S> {
    /// Returns the surface of still water.
    pub fn still() -> Self {
        let zero = S::ZERO;
        let (slopes, slope_rates, curvatures) = ([zero; 2], [zero; 2], [zero; 3]);
        Self { elevation: zero, slopes, rate: zero, slope_rates, curvatures }
    }
}

/// Waves at one point of the world and one time; their sines are computed once, for both surface and motion.
///
/// ```
/// use kingpost::sea::waves::{Water, WaveComponent, WaveField, WavesAtBody};
/// use kingpost::spatial::Vector3;
/// let water = Water::default();
/// let wave = WaveComponent::regular(2.0, 8.0, 0.0, 0.3, &water).unwrap();
/// let field = WaveField::new(&[wave], water, 0.0);
/// let mut waves = WavesAtBody::new(&field);
/// let surface = waves.surface(&field, [3.0, 1.0], 1.5);
/// let [velocity, acceleration] = waves.motion(&field, surface.elevation, -2.0);
/// let expected = field.kinematics(Vector3::new(3.0, 1.0, -2.0), 1.5);
/// assert!((surface.elevation - expected.elevation_m).abs() < 1e-14);
/// assert!((velocity - expected.velocity_m_s).norm() < 1e-14);
/// assert!((acceleration - expected.acceleration_m_s2).norm() < 1e-14);
/// ```
#[derive(Clone, Debug)]
pub struct WavesAtBody<S = f64> {
    /// a cos q and a sin q of each wave, with the ramp applied.
    real: Vec<S>,
    imaginary: Vec<S>,
    /// kx and ky of each wave, 1/m; k / ln 2; w, rad/s; g / w.
    wave_numbers: Vec<[S; 2]>,
    doublings_per_m: Vec<S>,
    frequencies: Vec<S>,
    speeds: Vec<S>,
}

impl<S: Scalar> WavesAtBody<S> {
    /// Creates the working memory for these waves.
    pub fn new(field: &WaveField<S>) -> Self {
        let none = || vec![S::ZERO; field.len()];
        let gravity = S::constant(field.water().gravity_m_s2);
        let vector = |wave: &super::WaveComponent<S>| {
            let (sin, cos) = wave.direction_rad.sin_cos();
            [wave.wave_number_per_m * cos, wave.wave_number_per_m * sin]
        };
        Self {
            real: none(),
            imaginary: none(),
            wave_numbers: field.components().map(vector).collect(),
            doublings_per_m: field.components().map(|w| w.wave_number_per_m * S::constant(LOG2_E)).collect(),
            frequencies: field.components().map(|w| w.angular_frequency_rad_s).collect(),
            speeds: field.components().map(|w| gravity / w.angular_frequency_rad_s).collect(),
        }
    }

    /// Computes the surface over a point (x, y), world, m.
    pub fn surface(&mut self, field: &WaveField<S>, point: [S; 2], time_s: f64) -> LocalSurface<S> {
        let Self { real, imaginary, wave_numbers, frequencies, .. } = self;
        field.phasors(point, time_s, real, imaginary);
        let mut sum = LocalSurface::still();
        for i in 0..real.len() {
            let (cos, sin, [kx, ky], w) = (real[i], imaginary[i], wave_numbers[i], frequencies[i]);
            let ([x, y], along) = ([kx * sin, ky * sin], w * cos);
            sum.elevation += cos;
            sum.slopes[0] -= x;
            sum.slopes[1] -= y;
            sum.rate += w * sin;
            sum.slope_rates[0] += kx * along;
            sum.slope_rates[1] += ky * along;
            let [xx, xy, yy] = [kx * kx, kx * ky, ky * ky];
            sum.curvatures[0] -= xx * cos;
            sum.curvatures[1] -= xy * cos;
            sum.curvatures[2] -= yy * cos;
        }
        // The phasors contain the ramp factor; the rate of the ramp contributes to the surface's rate.
        let [ramp, ramp_rate, _] = field.ramp_and_rates(time_s);
        if ramp_rate != 0.0 && ramp > 0.0 {
            let growth = S::constant(ramp_rate / ramp);
            sum.rate += sum.elevation * growth;
            (0..2).for_each(|k| sum.slope_rates[k] += sum.slopes[k] * growth);
        }
        sum
    }

    /// Computes velocity (m/s) and local acceleration (m/s^2) of the water under the point of the last
    /// [`surface`](Self::surface), at a height z, m; they equal those of [`WaveField::kinematics`].
    pub fn motion(&self, field: &WaveField<S>, elevation: S, z: S) -> [Vector3<S>; 2] {
        let StretchedHeight { z: level_z, rise } = field.height(z, elevation);
        let (depth, rise) = (field.water().depth_m, rise * S::constant(LN_2));
        let mirrored = -(level_z + S::constant(2.0 * depth.unwrap_or(0.0)));
        let (mut velocity, mut acceleration) = (Vector3::zero(), Vector3::zero());
        for i in 0..self.real.len() {
            let (cos, sin, [kx, ky]) = (self.real[i], self.imaginary[i], self.wave_numbers[i]);
            let doublings = self.doublings_per_m[i];
            let (down, further) = ((doublings * level_z).power_of_two(), doublings * rise);
            let (level, upward) = match depth {
                None => (down, down),
                Some(_) => {
                    let (up, scale) = ((doublings * mirrored).power_of_two(), field.bottom_scales[i]);
                    (scale * (down + up), scale * (down - up))
                }
            };
            let (level, upward) = (level + further * upward, upward + further * level);
            let upward = upward * doublings * S::constant(LN_2);
            let [x, y, speed] = [kx * level, ky * level, self.speeds[i]];
            velocity += Vector3::new(x * cos, y * cos, upward * sin) * speed;
            acceleration += Vector3::new(x * sin, y * sin, -(upward * cos));
        }
        let acceleration = acceleration * S::constant(field.water().gravity_m_s2);
        [velocity, acceleration].map(|vector| Vector3(vector.0.map(|x| field.stretching().moving(z, x))))
    }
}
