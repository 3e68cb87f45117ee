//! A measured wave record as a sum of regular waves.

use core::f64::consts::TAU;

use super::components::{ANGLES_RAD, MOST_COMPONENTS, WaveComponent};
use super::error::{WaveError, between};
use super::spectrum::Band;
use super::water::Water;

/// The surface elevation at one point, measured at equal intervals.
#[derive(Clone, Debug, PartialEq)]
pub struct ElevationRecord {
    /// Elevations, m.
    pub elevations_m: Vec<f64>,
    /// Time of the first, s.
    pub start_s: f64,
    /// Interval between two, s.
    pub interval_s: f64,
    /// Where they were measured: x and y, world, m.
    pub position_m: [f64; 2],
    /// Direction that the waves go to, from the world's x counter-clockwise, rad. One point cannot
    /// tell it.
    pub direction_rad: f64,
    /// Frequencies that are kept; none for all below half the sampling frequency.
    pub band: Option<Band>,
}

/// Most samples of a record: three hours at 6 Hz.
pub const MOST_SAMPLES: usize = 65_536;

impl ElevationRecord {
    /// The waves whose sum has these elevations at this point: the discrete Fourier transform of the
    /// record, one wave for each of its harmonics in the band. The mean is left out, and so is the
    /// harmonic of half the sampling frequency, whose phase the samples do not hold. The sum repeats
    /// after the record's length, so the first sample should go on from the last.
    ///
    /// The transform is summed as it is written. A record of 20 minutes at 2 Hz takes 3 million
    /// multiplications and the longest 10^9, once, which is not worth the size of a fast transform in
    /// the browser; sines and cosines come from a table, so that no error grows along the sum.
    ///
    /// # Errors
    /// Fewer than 4 samples or more than 65,536, elevations above 100 m or not finite, an interval
    /// outside 1e-3 to 1e3 s, a band without a harmonic or with more than 20,000.
    pub fn components(&self, water: &Water) -> Result<Vec<WaveComponent>, WaveError> {
        self.check()?;
        let count = self.elevations_m.len();
        let step_rad_s = TAU / (count as f64 * self.interval_s);
        let band = self.band.unwrap_or(Band { lowest_rad_s: 0.0, highest_rad_s: f64::INFINITY });
        let kept = |&m: &usize| (band.lowest_rad_s..=band.highest_rad_s).contains(&(m as f64 * step_rad_s));
        let harmonics: Vec<usize> = (1..count.div_ceil(2)).filter(kept).collect();
        if harmonics.is_empty() || harmonics.len() > MOST_COMPONENTS {
            let found = format!("{} harmonics of {step_rad_s:.6} rad/s", harmonics.len());
            let allowed = format!("a band with 1 to {MOST_COMPONENTS} harmonics below half the sampling frequency");
            return Err(WaveError::new("lowest_rad_s, highest_rad_s", found, allowed));
        }
        let turn: Vec<(f64, f64)> = (0..count).map(|n| libm::sincos(TAU * n as f64 / count as f64)).collect();
        let wave = |&m: &usize| self.wave(m as f64 * step_rad_s, harmonic(&self.elevations_m, &turn, m), water);
        Ok(harmonics.iter().map(wave).collect())
    }

    /// The wave whose complex elevation at the point and the time of the first sample is this.
    fn wave(&self, frequency_rad_s: f64, [real, imaginary]: [f64; 2], water: &Water) -> WaveComponent {
        let amplitude = libm::sqrt(real * real + imaginary * imaginary);
        let mut wave = WaveComponent::in_water(water, amplitude, frequency_rad_s, self.direction_rad, 0.0);
        let (sin, cos) = libm::sincos(self.direction_rad);
        let along = self.position_m[0] * cos + self.position_m[1] * sin;
        wave.phase_rad = libm::atan2(imaginary, real) + frequency_rad_s * self.start_s - wave.wave_number_per_m * along;
        wave
    }

    fn check(&self) -> Result<(), WaveError> {
        let count = self.elevations_m.len();
        if !(4..=MOST_SAMPLES).contains(&count) {
            let found = format!("{count} samples");
            return Err(WaveError::new("elevations_m", found, format!("4 to {MOST_SAMPLES} samples")));
        }
        for (i, &elevation) in self.elevations_m.iter().enumerate() {
            between(&format!("elevations_m[{i}]"), elevation, [-100.0, 100.0])?;
        }
        between("interval_s", self.interval_s, [1e-3, 1e3])?;
        between("start_s", self.start_s, [-1e7, 1e7])?;
        between("direction_rad", self.direction_rad, ANGLES_RAD)?;
        between("position_m[0]", self.position_m[0], [-1e6, 1e6])?;
        between("position_m[1]", self.position_m[1], [-1e6, 1e6])?;
        Ok(())
    }
}

/// (2 / N) sum of eta_n e^(2 pi i m n / N): the complex amplitude of e^(-i w_m t).
fn harmonic(elevations_m: &[f64], turn: &[(f64, f64)], m: usize) -> [f64; 2] {
    let (count, mut place) = (elevations_m.len(), 0);
    let (mut real, mut imaginary) = (0.0, 0.0);
    for elevation in elevations_m {
        let (sin, cos) = turn[place];
        real += elevation * cos;
        imaginary += elevation * sin;
        place = (place + m) % count;
    }
    let scale = 2.0 / count as f64;
    [scale * real, scale * imaginary]
}
