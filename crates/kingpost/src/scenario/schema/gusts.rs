//! Gusts of the wind.

use kingpost_derive::fields;

use super::{NonNegative, Positive, WaveAmplitudes};
use crate::scenario::leaf::Leaf;

/// Gusts: variation of the wind speed about its mean, drawn from a spectrum with the run's seed. They act along the
/// mean wind and on the whole ship at once.
#[fields(default)]
pub struct Gusts<S = f64> {
    /// Whether they blow.
    pub enabled: bool,
    /// Their spectrum.
    pub spectrum: GustSpectrum<S>,
    /// Number of components.
    pub components: usize,
    /// Whether the amplitudes are random or those of the spectrum.
    pub amplitudes: WaveAmplitudes,
    /// Lowest frequency, Hz: slower gusts are left out. 1/3600 unless given, for a mean over one hour.
    pub lowest_hz: Positive,
    /// Highest frequency, Hz: faster gusts, which are smaller than a ship, are left out.
    pub highest_hz: Positive,
    /// Time over which the gusts grow from zero at the start, s.
    pub ramp_s: NonNegative,
}

impl<S: Leaf> Default for Gusts<S> {
    fn default() -> Self {
        Self {
            enabled: true,
            spectrum: GustSpectrum::Npd,
            components: 200,
            amplitudes: WaveAmplitudes::Deterministic,
            lowest_hz: Positive::literal(1.0 / 3600.0),
            highest_hz: Positive::literal(0.5),
            ramp_s: NonNegative::literal(0.0),
        }
    }
}

/// The spectrum of the gusts, for the mean wind at the height of the load.
#[fields]
#[derive(Copy, Default)]
pub enum GustSpectrum<S = f64> {
    /// The spectrum of the Norwegian Petroleum Directorate, in ISO 19901-1 and API RP 2MET.
    #[default]
    Npd,
    /// The spectrum of API RP 2A.
    Api(ApiGusts<S>),
    /// Kaimal's spectrum in the form of IEC 61400-1.
    Kaimal(KaimalGusts<S>),
}

/// S = sigma^2 / f_p / (1 + 1.5 f / f_p)^(5/3), f_p = c U / z, sigma by API RP 2A at the height z.
#[fields(default)]
#[derive(Copy)]
pub struct ApiGusts<S = f64> {
    /// c: 0.01 to 0.1, 0.025 unless given.
    pub peak_coefficient: Positive<S>,
}

impl<S: Leaf> Default for ApiGusts<S> {
    fn default() -> Self {
        Self { peak_coefficient: Positive::literal(0.025) }
    }
}

/// S = 4 sigma^2 (L / U) / (1 + 6 f L / U)^(5/3), sigma = I U.
#[fields]
#[derive(Copy)]
pub struct KaimalGusts<S = f64> {
    /// I: standard deviation of the speed over the mean speed.
    pub turbulence_intensity: Positive<S>,
    /// L, m. In IEC 61400-1 it is 5.67 times the height, and 340 m above 60 m.
    pub length_scale_m: Positive<S>,
}
