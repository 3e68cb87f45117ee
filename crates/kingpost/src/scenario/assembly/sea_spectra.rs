//! Directional wave spectra of a scenario's sea, independent of the seed.

use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::still_water::{gravity, water_of};
use crate::scenario::assembly::waves::{SystemField, of_spectrum, record, regular};
use crate::scenario::error::SourcePlace;
use crate::scenario::schema::{Name, Scenario, Waves};
use crate::scenario::tree::ScenarioNode;
use crate::scenario::{ScenarioError, reading};
use crate::sea::waves::{Water, WaveComponent};
use indexmap::IndexMap;
use serde::Serialize;
use serde_json::Value;

/// Wave systems of a sea by name, as in the scenario.
pub type SeaWaves = IndexMap<Name, Waves>;

/// Reads wave systems from a value with the form of `sea.waves` in a file.
///
/// # Errors
/// The first field that is unknown, missing or out of its range.
pub fn read_sea_waves(value: &Value) -> Result<SeaWaves, ScenarioError> {
    let tree = ScenarioNode::from_value(value, &SourcePlace::START);
    reading::read(&tree).map_err(|fault| ScenarioError::from(fault.error))
}

/// Spectrum of one wave system.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SeaSpectrum {
    /// Name of the wave system in the scenario.
    pub name: String,
    /// Propagation directions, each with the same share of the energy, rad; one direction if the system is
    /// long-crested.
    pub directions_rad: Vec<f64>,
    /// Lowest and highest frequency of the waves, rad/s; `None` for waves of single frequencies.
    pub band_rad_s: Option<[f64; 2]>,
    /// Frequencies where the density changes its form, rad/s.
    pub nodes_rad_s: Vec<f64>,
    /// Spectral density of the elevation at each requested frequency, m^2 s/rad; 0 outside the band.
    pub density_m2_s: Vec<f64>,
    /// Variance of the elevation over all frequencies, m^2.
    pub variance_m2: f64,
    /// Waves of single frequencies: angular frequency, rad/s, direction, rad, and variance of the elevation, m^2.
    pub lines: Vec<[f64; 3]>,
}

impl Scenario {
    /// Returns the spectrum of each enabled wave system, as the mean over all seeds. `waves` replaces the
    /// wave systems of the scenario; a short-crested system is divided into `directions` directions of equal
    /// energy.
    ///
    /// # Errors
    /// A wave system that is not valid.
    pub fn sea_spectra(
        &self,
        waves: &SeaWaves,
        frequencies_rad_s: &[f64],
        directions: usize,
    ) -> Result<Vec<SeaSpectrum>, ScenarioError> {
        let Some(sea) = &self.sea else { return Ok(Vec::new()) };
        let water = water_of(sea, sea.density_kg_m3.get(), &gravity(self)?)?;
        let running = waves.iter().filter(|(_, waves)| waves.enabled());
        let each = running.map(|(name, waves)| -> Result<SeaSpectrum, ScenarioError> {
            let found = self.sea_spectrum(waves, &water, frequencies_rad_s, directions)?;
            Ok(SeaSpectrum { name: name.to_string(), ..found })
        });
        each.collect()
    }

    fn sea_spectrum(
        &self,
        waves: &Waves,
        water: &Water,
        frequencies_rad_s: &[f64],
        directions: usize,
    ) -> Result<SeaSpectrum, FieldError> {
        let at = SystemField::of(waves);
        let lines = |components: Vec<WaveComponent>| SeaSpectrum {
            name: String::new(),
            directions_rad: Vec::new(),
            band_rad_s: None,
            nodes_rad_s: Vec::new(),
            density_m2_s: vec![0.0; frequencies_rad_s.len()],
            variance_m2: 0.0,
            lines: components.iter().map(line).collect(),
        };
        match waves {
            Waves::Regular(wave) => {
                let found = regular(wave, water).map_err(|error| at.error(error))?;
                Ok(lines(found.iter().map(|wave| wave.component()).collect()))
            }
            Waves::Record(given) => Ok(lines(record(self, given, water).map_err(|error| at.error(error))?)),
            _ => {
                let Some((system, _)) = of_spectrum::<f64>(waves, water, &at)? else { return Ok(lines(Vec::new())) };
                let (band, factor) = system.kept_band().map_err(|error| at.of_realisation(error))?;
                let within = |omega: f64| (band.lowest_rad_s..=band.highest_rad_s).contains(&omega);
                let density =
                    |&omega: &f64| if within(omega) { factor * system.spectrum.density_m2_s(omega) } else { 0.0 };
                let shares: Vec<f64> = (0..directions).map(|i| (i as f64 + 0.5) / directions as f64).collect();
                let mut angles = system.spreading.quantiles_rad(&shares);
                angles.dedup();
                Ok(SeaSpectrum {
                    directions_rad: angles.iter().map(|angle| system.direction_rad + angle).collect(),
                    band_rad_s: Some([band.lowest_rad_s, band.highest_rad_s]),
                    nodes_rad_s: system.spectrum.nodes_rad_s(),
                    density_m2_s: frequencies_rad_s.iter().map(density).collect(),
                    variance_m2: factor * system.spectrum.moment(0, band),
                    ..lines(Vec::new())
                })
            }
        }
    }
}

fn line(wave: &WaveComponent) -> [f64; 3] {
    [wave.angular_frequency_rad_s, wave.direction_rad, 0.5 * wave.amplitude_m * wave.amplitude_m]
}
