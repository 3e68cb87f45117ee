//! Elevation and pressure at many points at one time.

use core::f64::consts::{LN_2, LOG2_E};

use super::field::WaveField;
use super::stretching::{StretchedHeight, Stretching};
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// Largest rounding error by which a sum of waves can exceed the sum of their amplitudes, as a share.
const ROUNDING: f64 = 1e-9;

/// Waves at one time, for a mesh that needs elevation and pressure at every vertex.
///
/// They equal those of [`WaveField::kinematics`] except for rounding. Terms that all points share are
/// computed once for each time, only cosines of the phases are needed, and exponentials are powers of two.
/// Only computed values are stored, not the waves: every call needs the field for which the object was made.
///
/// ```
/// use kingpost::sea::waves::{Water, WaveComponent, WaveField, WavesAtPoints};
/// use kingpost::spatial::Vector3;
/// let water = Water::default();
/// let wave = WaveComponent::regular(2.0, 8.0, 0.0, 0.0, &water).unwrap();
/// let field = WaveField::new(&[wave], water, 0.0);
/// let (point, time_s) = (Vector3::new(3.0, 0.0, -2.0), 1.5);
/// let expected = field.kinematics(point, time_s);
/// let mut waves = WavesAtPoints::new(&field);
/// waves.set_time(&field, time_s);
/// let [elevation_m, dynamic_pressure_pa] = waves.at(&field, point);
/// assert!((elevation_m - expected.elevation_m).abs() < 1e-14);
/// assert!((dynamic_pressure_pa - expected.dynamic_pressure_pa).abs() < 1e-10);
/// ```
#[derive(Clone, Debug)]
pub struct WavesAtPoints<S = f64> {
    /// k / ln 2: e^kz is computed as a power of two.
    doublings_per_m: Vec<S>,
    /// Phase of each wave at the world's origin at the present time, in turns; and its amplitude at this
    /// time, m.
    phases: Vec<S>,
    amplitudes: Vec<S>,
    highest_m: S,
    /// Working memory: a cos q of each wave at a point, and a C cos q.
    elevations: Vec<S>,
    heads: Vec<S>,
}

impl<S: Scalar> WavesAtPoints<S> {
    /// Creates the working memory for the waves of a field, at time 0.
    pub fn new(field: &WaveField<S>) -> Self {
        let doublings = S::constant(LOG2_E);
        let doublings_per_m = field.components().map(|wave| wave.wave_number_per_m * doublings).collect();
        let none = || vec![S::ZERO; field.len()];
        let (phases, amplitudes, elevations, heads) = (none(), none(), none(), none());
        let mut waves = Self { doublings_per_m, phases, amplitudes, highest_m: S::ZERO, elevations, heads };
        waves.set_time(field, 0.0);
        waves
    }

    /// Sets the time, s.
    pub fn set_time(&mut self, field: &WaveField<S>, time_s: f64) {
        let (turns, time) = (&field.turns, S::constant(time_s));
        for ((now, phase), per_s) in self.phases.iter_mut().zip(&turns.phase).zip(&turns.time_per_s) {
            *now = *phase - *per_s * time;
        }
        let ramp = S::constant(field.ramp(time_s));
        let mut highest = S::ZERO;
        for (now, amplitude) in self.amplitudes.iter_mut().zip(&field.amplitudes_m) {
            *now = *amplitude * ramp;
            highest += now.select_below(0.0, || -*now, || *now);
        }
        self.highest_m = highest * S::constant(1.0 + ROUNDING);
    }

    /// Returns an upper bound of the surface at the present time: the sum of all amplitudes, m above still
    /// water.
    pub fn highest_m(&self) -> S {
        self.highest_m
    }

    /// Returns the elevation over a point of the world, m, and the dynamic pressure at the point, Pa, by the
    /// field's stretching.
    pub fn at(&mut self, field: &WaveField<S>, point: Vector3<S>) -> [S; 2] {
        let elevation = self.elevation_m(field, [point[0], point[1]]);
        let height = field.height(point[2], elevation);
        let weight = S::constant(field.water().gravity_m_s2 * field.water().density_kg_m3);
        // The decay factor is 1 at the still water level, and above it with Wheeler's and with vertical
        // stretching.
        let head = if field.stretching() == Stretching::Extrapolated {
            self.extrapolated_head_m(field, height)
        } else if height.z.all(|z| z >= 0.0) {
            elevation
        } else {
            let head = self.head_m(field, height.z);
            height.z.select_below(0.0, || head, || elevation)
        };
        [elevation, field.stretching().pressure(point[2], weight, head * weight)]
    }

    /// Returns the sum of a cos q, and stores each term.
    fn elevation_m(&mut self, field: &WaveField<S>, [x, y]: [S; 2]) -> S {
        let count = self.elevations.len();
        let turns = &field.turns;
        let (kx, ky) = (&turns.x_per_m[..count], &turns.y_per_m[..count]);
        let (phases, amplitudes) = (&self.phases[..count], &self.amplitudes[..count]);
        for i in 0..count {
            let turns = kx[i] * x + ky[i] * y + phases[i];
            self.elevations[i] = amplitudes[i] * turns.cos_of_turns();
        }
        sum(&self.elevations)
    }

    /// Returns the sum of a C cos q at a height below the still water, m.
    fn head_m(&mut self, field: &WaveField<S>, z: S) -> S {
        let count = self.heads.len();
        let (heads, elevations) = (&mut self.heads[..count], &self.elevations[..count]);
        let doublings = &self.doublings_per_m[..count];
        match field.water().depth_m {
            None => {
                for i in 0..count {
                    heads[i] = elevations[i] * (doublings[i] * z).power_of_two();
                }
            }
            Some(depth_m) => {
                let mirrored = -(z + S::constant(2.0 * depth_m));
                let scales = &field.bottom_scales[..count];
                for i in 0..count {
                    let (down, up) = ((doublings[i] * z).power_of_two(), (doublings[i] * mirrored).power_of_two());
                    heads[i] = elevations[i] * (scales[i] * (down + up));
                }
            }
        }
        sum(heads)
    }

    /// Returns the sum of a C cos q where C continues along its tangent k D above the still water level.
    fn extrapolated_head_m(&mut self, field: &WaveField<S>, height: StretchedHeight<S>) -> S {
        let head = self.head_m(field, height.z);
        let rise = height.rise * S::constant(LN_2);
        for (i, head) in self.heads.iter_mut().enumerate() {
            // D = tanh kh at the still water level: 2 / (1 + e^-2kh) - 1; 1 in infinite depth.
            let upward = field.bottom_scales[i] * S::constant(2.0) - S::ONE;
            let upward = if field.water().depth_m.is_some() { upward } else { S::ONE };
            *head = self.elevations[i] * (self.doublings_per_m[i] * rise * upward);
        }
        head + sum(&self.heads)
    }
}

/// Returns a sum in a fixed order, in four partial sums that a processor can add in parallel.
fn sum<S: Scalar>(numbers: &[S]) -> S {
    let mut strands = [S::ZERO; 4];
    let (fours, rest) = numbers.as_chunks::<4>();
    for four in fours {
        for k in 0..4 {
            strands[k] += four[k];
        }
    }
    (strands[0] + strands[1]) + (strands[2] + strands[3]) + rest.iter().fold(S::ZERO, |sum, number| sum + *number)
}
