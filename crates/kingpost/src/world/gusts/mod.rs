//! Gusts: the variation of the wind speed about its mean, as a sum of many components.

mod spectrum;

pub use spectrum::{GustSpectrum, MeanWind};

use crate::scalar::Scalar;
use crate::sea::waves::{Amplitudes, MOST_COMPONENTS, Noise, ramp};

/// First noise channel of gusts; wave systems use the channels below it.
const FIRST_CHANNEL: u64 = 1 << 32;
/// Purpose of a noise channel.
#[derive(Clone, Copy)]
enum GustDraw {
    Frequency = 0,
    Phase = 1,
    Amplitude = 2,
}

/// A realisation of a gusty wind; equal seeds give realisations that are bitwise identical.
///
/// The band is divided into bins of equal width in ln f, because f S(f) is broad as a function of ln f. Each
/// bin gives one component with the variance of the bin, a frequency drawn uniformly in ln f from the bin, so
/// that the wind does not repeat, and a random phase. Frequencies and phases are the same at all heights: a
/// gust acts on the whole ship at once.
#[derive(Clone, Debug, PartialEq)]
pub struct Gusts<S = f64> {
    /// The spectrum.
    pub spectrum: GustSpectrum<S>,
    components: Vec<Component>,
    ramp_s: f64,
}

/// Settings of a realisation of gusts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GustRealisation {
    /// Seed of every random number.
    pub seed: u64,
    /// Number of components.
    pub components: usize,
    /// Lowest and highest frequency, Hz.
    pub band_hz: [f64; 2],
    /// The way in which amplitudes are drawn.
    pub amplitudes: Amplitudes,
    /// Time over which the gusts grow from zero, s.
    pub ramp_s: f64,
}

/// Error of a setting of a realisation: the field, and the allowed value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GustError {
    /// Field of the realisation.
    pub field: &'static str,
    /// The value found.
    pub found: String,
    /// Range or form that is allowed.
    pub allowed: String,
}

/// A component of the wind speed, without its amplitude.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Component {
    /// Limits of its bin, Hz.
    ends_hz: [f64; 2],
    frequency_hz: f64,
    phase_turns: f64,
    /// Ratio of its variance to the variance of its bin.
    share: f64,
}

/// Gusts computed for one height, for a load that needs them often.
#[derive(Clone, Debug, PartialEq)]
pub struct GustsAtHeight<S = f64> {
    /// Amplitudes of the components, m/s.
    amplitudes: Vec<S>,
    frequencies_hz: Vec<f64>,
    phases_turns: Vec<f64>,
    ramp_s: f64,
}

impl<S: Scalar> Gusts<S> {
    /// Draws a realisation.
    ///
    /// # Errors
    /// No components, more than 20,000 components, or an empty band.
    pub fn new(spectrum: GustSpectrum<S>, of: &GustRealisation) -> Result<Self, GustError> {
        let [lowest, highest] = of.band_hz;
        if of.components == 0 || of.components > MOST_COMPONENTS {
            let allowed = format!("a number from 1 to {MOST_COMPONENTS}");
            return Err(GustError { field: "components", found: of.components.to_string(), allowed });
        }
        if highest <= lowest {
            let allowed = format!("more than lowest_Hz, {lowest}");
            return Err(GustError { field: "highest_Hz", found: highest.to_string(), allowed });
        }
        let (noise, count) = (Noise::new(of.seed), of.components as f64);
        let (begin, width) = (libm::log(lowest), libm::log(highest / lowest) / count);
        let component = |i: u64| {
            let uniform = |draw: GustDraw| noise.uniform(FIRST_CHANNEL + draw as u64, i);
            let at = |bins: f64| libm::exp(begin + width * bins);
            let start = i as f64;
            Component {
                ends_hz: [at(start), at(start + 1.0)],
                frequency_hz: at(start + uniform(GustDraw::Frequency)),
                phase_turns: uniform(GustDraw::Phase),
                share: match of.amplitudes {
                    Amplitudes::Deterministic => 1.0,
                    Amplitudes::Random => -libm::log(uniform(GustDraw::Amplitude)),
                },
            }
        };
        Ok(Self { spectrum, components: (0..of.components as u64).map(component).collect(), ramp_s: of.ramp_s })
    }

    /// Returns the gusts at the height of this mean wind.
    pub fn at_height(&self, mean: &MeanWind<S>) -> GustsAtHeight<S> {
        let amplitude =
            |of: &Component| self.spectrum.deviation(mean, of.ends_hz) * S::constant(libm::sqrt(2.0 * of.share));
        GustsAtHeight {
            amplitudes: self.components.iter().map(amplitude).collect(),
            frequencies_hz: self.components.iter().map(|of| of.frequency_hz).collect(),
            phases_turns: self.components.iter().map(|of| of.phase_turns).collect(),
            ramp_s: self.ramp_s,
        }
    }
}

impl<S: Scalar> GustsAtHeight<S> {
    /// Returns the gust speed along the mean wind, without the mean, at a time (s), m/s.
    pub fn speed(&self, time_s: f64) -> S {
        let waves = self.amplitudes.iter().zip(&self.frequencies_hz).zip(&self.phases_turns);
        let sum = waves.fold(S::ZERO, |sum, ((amplitude, frequency), phase)| {
            sum + *amplitude * S::constant((frequency * time_s + phase).cos_of_turns())
        });
        let [share, ..] = ramp(time_s, self.ramp_s);
        sum * S::constant(share)
    }

    /// Returns the standard deviation of the speed after the ramp, m/s.
    pub fn deviation(&self) -> S {
        let half = S::constant(0.5);
        self.amplitudes.iter().fold(S::ZERO, |sum, a| sum + half * *a * *a).sqrt()
    }
}
