//! A sea as a sum of regular waves.

use core::f64::consts::TAU;

use super::dispersion::wave_number;
use super::error::{HEIGHTS_M, PERIODS_S, WaveError, between};
use super::water::Water;
use crate::scalar::Scalar;

/// One regular wave of a sum: elevation = Re{a e^(i (k x cos b + k y sin b - w t + phase))}.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WaveComponent<S = f64> {
    /// Amplitude a, m.
    pub amplitude_m: S,
    /// Angular frequency w, rad/s.
    pub angular_frequency_rad_s: S,
    /// Wave number k, 1/m.
    pub wave_number_per_m: S,
    /// Propagation direction b, from the world's x counter-clockwise, rad.
    pub direction_rad: S,
    /// Phase at the world's origin at time 0, rad; with 0 a crest is at the origin.
    pub phase_rad: S,
}

impl WaveComponent {
    /// Returns the wave of this angular frequency in this water.
    pub fn in_water(
        water: &Water,
        amplitude_m: f64,
        angular_frequency_rad_s: f64,
        direction_rad: f64,
        phase_rad: f64,
    ) -> Self {
        let wave_number_per_m = wave_number(angular_frequency_rad_s, water);
        Self { amplitude_m, angular_frequency_rad_s, wave_number_per_m, direction_rad, phase_rad }
    }

    /// Returns a regular wave with this height from trough to crest, twice the amplitude.
    ///
    /// ```
    /// use kingpost::sea::waves::{Water, WaveComponent};
    /// let wave = WaveComponent::regular(2.0, 8.0, 0.0, 0.0, &Water::default())?;
    /// assert_eq!(wave.amplitude_m, 1.0);
    /// assert!((std::f64::consts::TAU / wave.wave_number_per_m - 99.9).abs() < 0.1); // g T^2 / 2 pi
    /// # Ok::<(), kingpost::sea::waves::WaveError>(())
    /// ```
    ///
    /// # Errors
    /// A height outside 1e-6 to 100 m, a period outside 0.01 to 1000 s, a direction or phase that is
    /// not finite or is above 1e4 rad.
    pub fn regular(
        height_m: f64,
        period_s: f64,
        direction_rad: f64,
        phase_rad: f64,
        water: &Water,
    ) -> Result<Self, WaveError> {
        between("height_m", height_m, HEIGHTS_M)?;
        between("period_s", period_s, PERIODS_S)?;
        between("direction_rad", direction_rad, ANGLES_RAD)?;
        between("phase_rad", phase_rad, ANGLES_RAD)?;
        Ok(Self::in_water(water, 0.5 * height_m, TAU / period_s, direction_rad, phase_rad))
    }

    /// Returns the wave over another scalar, without derivatives.
    pub fn constant<S: Scalar>(&self) -> WaveComponent<S> {
        WaveComponent {
            amplitude_m: S::constant(self.amplitude_m),
            angular_frequency_rad_s: S::constant(self.angular_frequency_rad_s),
            wave_number_per_m: S::constant(self.wave_number_per_m),
            direction_rad: S::constant(self.direction_rad),
            phase_rad: S::constant(self.phase_rad),
        }
    }
}

impl<S: Scalar> WaveComponent<S> {
    /// Returns the wave in plain numbers: all except the amplitude belong to the structure of a run, which
    /// all lanes share.
    pub fn plain(&self) -> WaveComponent {
        WaveComponent {
            amplitude_m: self.amplitude_m.value(),
            angular_frequency_rad_s: self.angular_frequency_rad_s.value(),
            wave_number_per_m: self.wave_number_per_m.value(),
            direction_rad: self.direction_rad.value(),
            phase_rad: self.phase_rad.value(),
        }
    }
}

/// Largest number of waves of one wave system.
pub const MOST_COMPONENTS: usize = 20_000;

/// Smallest and largest angle of an input, rad.
pub(crate) const ANGLES_RAD: [f64; 2] = [-1e4, 1e4];

/// Returns the significant wave height of a sum of waves, m: 4 sqrt(sum of a^2 / 2).
pub fn significant_height_of_components_m(components: &[WaveComponent]) -> f64 {
    4.0 * libm::sqrt(components.iter().map(|wave| 0.5 * wave.amplitude_m * wave.amplitude_m).sum())
}
