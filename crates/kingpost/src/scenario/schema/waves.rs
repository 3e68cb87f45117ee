//! Wave systems.

use kingpost_derive::fields;

use super::{Positive, RecordPath, yes};
use crate::scenario::leaf::Leaf;

/// One wave system of the sea. Directions are those towards which the waves travel, from the world's x axis towards y:
/// 180 degrees is a head sea for a ship at heading 0.
#[fields]
pub enum Waves<S = f64> {
    /// One regular wave.
    Regular(RegularWave<S>),
    /// A developing sea, by the JONSWAP spectrum.
    Jonswap(Jonswap<S>),
    /// A fully developed sea, by the Pierson-Moskowitz spectrum.
    PiersonMoskowitz(PiersonMoskowitz<S>),
    /// Swell and wind sea in one direction, by the six-parameter spectrum of Ochi and Hubble.
    OchiHubble(OchiHubble),
    /// Wind sea and swell of the Norwegian Sea, by the spectrum of Torsethaugen.
    Torsethaugen(PiersonMoskowitz<S>),
    /// A sea whose spectrum is given as a table.
    Spectrum(SpectrumTable),
    /// Measured waves.
    Record(ElevationRecord),
}

/// A regular wave.
#[fields]
pub struct RegularWave<S = f64> {
    /// Whether the sea has these waves.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// Height from trough to crest, m.
    pub height_m: Positive<S>,
    /// Period, s.
    pub period_s: Positive,
    /// Direction that the wave goes to, rad.
    #[serde(default)]
    pub direction_rad: f64,
    /// Phase at the world's origin at time 0, rad: 0 is a crest.
    #[serde(default)]
    pub phase_rad: f64,
}

/// A sea by the JONSWAP spectrum, scaled to the significant height numerically.
#[fields]
pub struct Jonswap<S = f64> {
    /// Whether the sea has these waves.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// Significant wave height Hs, m.
    pub significant_height_m: Positive<S>,
    /// Period at the spectrum's peak, s.
    pub peak_period_s: Positive,
    /// Peak enhancement gamma, from 1 to 10; 1 is Pierson and Moskowitz' spectrum.
    #[serde(default = "gamma")]
    pub gamma: Positive,
    /// Mean direction that the waves go to, rad.
    #[serde(default)]
    pub direction_rad: f64,
    /// Settings of the realisation.
    #[serde(default)]
    pub realisation: WaveRealisation,
}

/// The default of `gamma`.
fn gamma() -> Positive {
    Positive::literal(3.3)
}

/// A sea by significant height and peak period: the Pierson-Moskowitz spectrum, or Torsethaugen's.
#[fields]
pub struct PiersonMoskowitz<S = f64> {
    /// Whether the sea has these waves.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// Significant wave height Hs, m.
    pub significant_height_m: Positive<S>,
    /// Period at the spectrum's peak, s.
    pub peak_period_s: Positive,
    /// Mean direction that the waves go to, rad.
    #[serde(default)]
    pub direction_rad: f64,
    /// Settings of the realisation.
    #[serde(default)]
    pub realisation: WaveRealisation,
}

/// A sea of two parts, each with a spectrum of three parameters.
#[fields]
pub struct OchiHubble {
    /// Whether the sea has these waves.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// Swell.
    pub swell: OchiHubblePart,
    /// Wind sea.
    pub wind_sea: OchiHubblePart,
    /// Mean direction that the waves of both parts go to, rad.
    #[serde(default)]
    pub direction_rad: f64,
    /// Settings of the realisation.
    #[serde(default)]
    pub realisation: WaveRealisation,
}

/// A part of Ochi and Hubble's sea.
#[fields]
pub struct OchiHubblePart {
    /// Significant wave height of the part, m.
    pub significant_height_m: Positive,
    /// Period at the part's peak, s.
    pub peak_period_s: Positive,
    /// Shape lambda, from 0.5 to 20: with 1 the part is a Pierson-Moskowitz spectrum, with more it is narrower.
    pub shape: Positive,
}

/// A sea whose spectrum is given as a table.
#[fields]
pub struct SpectrumTable {
    /// Whether the sea has these waves.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// Angular frequency, rad/s, and density S of the elevation's variance, m^2 s/rad, row by row; linear between rows, no
    /// waves outside.
    pub rows: Vec<[f64; 2]>,
    /// Mean direction that the waves go to, rad.
    #[serde(default)]
    pub direction_rad: f64,
    /// Settings of the realisation.
    #[serde(default)]
    pub realisation: WaveRealisation,
}

/// Waves measured at one point. The record does not contain their direction: give it. The sea repeats after the
/// record's length; the mean elevation is removed.
#[fields]
pub struct ElevationRecord {
    /// Whether the sea has these waves.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// CSV file beside the scenario's own, with the header `time_s,elevation_m` and equal intervals of time.
    pub file: RecordPath,
    /// Where it was measured, x and y in the world, m.
    #[serde(default)]
    pub position_m: [f64; 2],
    /// Direction that the waves go to, rad.
    #[serde(default)]
    pub direction_rad: f64,
    /// Waves below this frequency are left out, rad/s; without it, none are.
    pub lowest_rad_s: Option<Positive>,
    /// Waves above this frequency are left out, rad/s; without it, those above half the sampling frequency.
    pub highest_rad_s: Option<Positive>,
}

/// Settings of one realisation of a spectrum. Its random numbers come from the run's seed.
#[fields(default)]
pub struct WaveRealisation {
    /// Number of components.
    pub components: usize,
    /// Whether the amplitudes are random, as in a record of the sea, or those of the spectrum.
    pub amplitudes: WaveAmplitudes,
    /// s of the spreading function cos^(2 s)(angle / 2), with the angle from the mean direction; without it, the sea is
    /// long-crested.
    pub spreading_exponent: Option<Positive>,
    /// Waves below this frequency are left out with their energy, rad/s; without it, none are.
    pub lowest_rad_s: Option<Positive>,
    /// Waves above this frequency are left out with their energy, rad/s; without it, none are.
    pub highest_rad_s: Option<Positive>,
}

impl Default for WaveRealisation {
    fn default() -> Self {
        Self {
            components: 200,
            amplitudes: WaveAmplitudes::Deterministic,
            spreading_exponent: None,
            lowest_rad_s: None,
            highest_rad_s: None,
        }
    }
}

/// Amplitudes of the components.
#[fields]
#[derive(Copy, Default, Eq)]
pub enum WaveAmplitudes {
    /// Those of the spectrum: every realisation has its significant height.
    #[default]
    Deterministic,
    /// Rayleigh distributed: heights vary from realisation to realisation as at sea.
    Random,
}

impl<S: Leaf> Waves<S> {
    /// The kind, as it is written.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Regular(_) => "regular",
            Self::Jonswap(_) => "jonswap",
            Self::PiersonMoskowitz(_) => "pierson_moskowitz",
            Self::OchiHubble(_) => "ochi_hubble",
            Self::Torsethaugen(_) => "torsethaugen",
            Self::Spectrum(_) => "spectrum",
            Self::Record(_) => "record",
        }
    }

    /// Whether the sea has these waves.
    pub fn enabled(&self) -> bool {
        match self {
            Self::Regular(wave) => wave.enabled,
            Self::Jonswap(sea) => sea.enabled,
            Self::PiersonMoskowitz(sea) | Self::Torsethaugen(sea) => sea.enabled,
            Self::OchiHubble(sea) => sea.enabled,
            Self::Spectrum(sea) => sea.enabled,
            Self::Record(waves) => waves.enabled,
        }
    }
}
