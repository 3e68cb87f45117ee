//! Wave systems.

use serde::{Deserialize, Serialize};

use super::{Positive, yes};

/// One wave system of the sea. Directions are those that the waves go to, from the world's x axis towards y: 180 degrees
/// is a head sea for a ship at heading 0.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Waves {
    /// One regular wave.
    Regular(RegularWave),
    /// A sea that still grows, by the JONSWAP spectrum.
    Jonswap(Jonswap),
    /// A fully developed sea, by the Pierson-Moskowitz spectrum.
    PiersonMoskowitz(PiersonMoskowitz),
}

/// A regular wave.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct RegularWave {
    /// Whether it runs.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// From trough to crest, m.
    pub height_m: Positive,
    /// Period, s.
    pub period_s: Positive,
    /// Where it goes to, rad.
    #[serde(default)]
    pub direction_rad: f64,
    /// Phase at the world's origin at time 0, rad: with 0 a crest is there.
    #[serde(default)]
    pub phase_rad: f64,
}

/// A sea by the JONSWAP spectrum, scaled to the significant height numerically.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Jonswap {
    /// Whether it runs.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// Significant wave height Hs, m.
    pub significant_height_m: Positive,
    /// Period at the spectrum's peak, s.
    pub peak_period_s: Positive,
    /// Peak enhancement gamma, from 1 to 10; 1 is Pierson and Moskowitz' spectrum.
    #[serde(default = "gamma")]
    pub gamma: Positive,
    /// Mean direction that the waves go to, rad.
    #[serde(default)]
    pub direction_rad: f64,
    /// How the realisation is made.
    #[serde(default)]
    pub realisation: WaveRealisation,
}

/// The default of `gamma`.
const fn gamma() -> Positive {
    Positive::literal(3.3)
}

/// A sea by the Pierson-Moskowitz spectrum.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct PiersonMoskowitz {
    /// Whether it runs.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// Significant wave height Hs, m.
    pub significant_height_m: Positive,
    /// Period at the spectrum's peak, s.
    pub peak_period_s: Positive,
    /// Mean direction that the waves go to, rad.
    #[serde(default)]
    pub direction_rad: f64,
    /// How the realisation is made.
    #[serde(default)]
    pub realisation: WaveRealisation,
}

/// How one realisation of a spectrum is made; its random numbers come from the run's seed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct WaveRealisation {
    /// Number of components.
    pub components: usize,
    /// Whether amplitudes are random too, as in a record of the sea, or those of the spectrum.
    pub amplitudes: WaveAmplitudes,
    /// s of the spreading cos^(2 s) of half the angle from the mean direction; without it, the crests are long.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub spreading_exponent: Option<Positive>,
}

impl Default for WaveRealisation {
    fn default() -> Self {
        Self { components: 200, amplitudes: WaveAmplitudes::Deterministic, spreading_exponent: None }
    }
}

/// Amplitudes of the components.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum WaveAmplitudes {
    /// The spectrum's: every realisation has its significant height.
    #[default]
    Deterministic,
    /// Rayleigh distributed about it: heights vary from realisation to realisation as those of the sea do.
    Random,
}

impl Waves {
    /// The kind, as it is written.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Regular(_) => "regular",
            Self::Jonswap(_) => "jonswap",
            Self::PiersonMoskowitz(_) => "pierson_moskowitz",
        }
    }

    /// Whether it runs.
    pub fn enabled(&self) -> bool {
        match self {
            Self::Regular(wave) => wave.enabled,
            Self::Jonswap(sea) => sea.enabled,
            Self::PiersonMoskowitz(sea) => sea.enabled,
        }
    }
}
