//! Waves of the sea, realised from its spectra.

use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::still_water::{gravity, water_of};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Positive, Scenario, WaveAmplitudes, WaveRealisation, Waves};
use crate::sea::waves::{
    Amplitudes, Band, Jonswap, OchiHubble, OchiHubblePart, PiersonMoskowitz, Spectrum, SpectrumTable, Spreading,
    Torsethaugen, Water, WaveComponent, WaveError, WaveSystem, unbroken,
};

/// A wave of the sea: its amplitude can carry derivatives or differ between lanes; its other properties
/// belong to the structure.
#[derive(Clone, Copy, Debug)]
pub struct Wave<S> {
    /// The wave, with the amplitude of all lanes, or of the first lane if they differ.
    pub of: WaveComponent,
    /// Amplitude, m.
    pub amplitude_m: S,
}

impl<S: Quantity> Wave<S> {
    /// Converts the wave to a type of the engine.
    pub fn component(&self) -> WaveComponent<S> {
        WaveComponent { amplitude_m: self.amplitude_m, ..self.of.constant() }
    }
}

/// Returns all components of all wave systems, in the order of the file.
pub fn build<S: Quantity>(scenario: &Scenario<S>, water: &Water) -> Result<Vec<Wave<S>>, FieldError> {
    let (mut components, seed) = (Vec::new(), scenario.simulation.seed);
    let systems = scenario.sea.iter().flat_map(|sea| &sea.waves);
    for (number, (name, waves)) in (0..).zip(systems) {
        let at = SystemField { path: format!("sea.waves.{name}.{}", waves.kind()) };
        let found = match waves {
            _ if !waves.enabled() => continue,
            Waves::Regular(wave) => regular(wave, water).map_err(|error| at.error(error))?,
            Waves::Record(given) => constant(record(scenario, given, water).map_err(|error| at.error(error))?, S::ONE),
            _ => match of_spectrum(waves, water, &at)? {
                Some((system, scale)) => {
                    constant(system.components(seed, number, water).map_err(|error| at.of_realisation(error))?, scale)
                }
                None => continue,
            },
        };
        components.extend(found);
    }
    Ok(components)
}

/// Returns waves with plain amplitudes times a factor of 1 that carries the derivatives.
fn constant<S: Quantity>(waves: Vec<WaveComponent>, scale: S) -> Vec<Wave<S>> {
    let wave = |of: WaveComponent| Wave { of, amplitude_m: S::constant(of.amplitude_m) * scale };
    waves.into_iter().map(wave).collect()
}

/// Path of a wave system.
pub(crate) struct SystemField {
    path: String,
}

impl SystemField {
    /// Returns the path of waves without a name.
    pub(crate) fn of(waves: &Waves) -> Self {
        Self { path: format!("sea.waves.{}", waves.kind()) }
    }

    fn field(&self, name: &str) -> String {
        format!("{}.{name}", self.path)
    }

    pub(crate) fn error(&self, error: WaveError) -> FieldError {
        FieldError::new(self.field(&error.field), error.found, error.allowed)
    }

    /// Converts an error of a spectrum's waves; some of its fields belong to the realisation.
    pub(crate) fn of_realisation(&self, error: WaveError) -> FieldError {
        let of_realisation = OF_REALISATION.iter().any(|part| error.field.starts_with(part));
        let field = if of_realisation { format!("realisation.{}", error.field) } else { error.field };
        FieldError::new(self.field(&field), error.found, error.allowed)
    }
}

/// Fields that belong to the realisation.
const OF_REALISATION: [&str; 4] = ["components", "spreading_exponent", "lowest_rad_s", "highest_rad_s"];

/// Returns the wave systems whose spectra are cut off: name of the waves, significant height of the whole
/// spectrum, m, and share of the energy that is cut off.
pub fn cut_off(scenario: &Scenario) -> Vec<(String, f64, f64)> {
    let Some(sea) = &scenario.sea else { return Vec::new() };
    let water = gravity(scenario).and_then(|gravity| water_of(sea, sea.density_kg_m3.get(), &gravity));
    let Ok(water) = water else { return Vec::new() };
    let systems = sea.waves.iter().filter(|(_, waves)| waves.enabled());
    let cut = systems.filter_map(|(name, waves)| {
        let (system, _) = of_spectrum(waves, &water, &SystemField { path: String::new() }).ok()??;
        system.band?;
        Some((name.to_string(), system.spectrum.significant_height_m(), system.energy_cut_off()))
    });
    cut.collect()
}

pub(crate) fn regular<S: Quantity>(wave: &schema::RegularWave<S>, water: &Water) -> Result<Vec<Wave<S>>, WaveError> {
    let schema::RegularWave { height_m, period_s, direction_rad, phase_rad, .. } = wave;
    let height_m = height_m.get();
    let of = |height: f64| WaveComponent::regular(height, period_s.get(), *direction_rad, *phase_rad, water);
    if let Some(height) = height_m.outside(|height| unbroken("height_m", height, period_s.get(), water).is_ok()) {
        unbroken("height_m", height, period_s.get(), water)?;
    }
    // The height must be valid in each lane; in all else the waves of the lanes are equal.
    match height_m.outside(|height| of(height).is_ok()) {
        Some(height) => of(height).map(|_| Vec::new()),
        None => Ok(vec![Wave { of: of(1.0)?, amplitude_m: S::constant(0.5) * height_m }]),
    }
}

pub(crate) fn record<S: Quantity>(
    scenario: &Scenario<S>,
    given: &schema::ElevationRecord,
    water: &Water,
) -> Result<Vec<WaveComponent>, WaveError> {
    let Some(table) = scenario.files.record(&given.file) else { return Ok(Vec::new()) };
    let all = Band { lowest_rad_s: 0.0, highest_rad_s: f64::INFINITY };
    let band = band(given.lowest_rad_s, given.highest_rad_s).unwrap_or(all);
    table.components(given.position_m, given.direction_rad, band, water)
}

/// Returns the random sea of a spectrum, and the factor of 1 that carries the derivatives of its amplitudes;
/// `None` for other kinds of waves. The amplitudes of a spectrum with one peak are proportional to the
/// significant height. In a spectrum with two peaks they are not, because the peak frequencies depend on the
/// heights.
pub(crate) fn of_spectrum<S: Quantity>(
    waves: &Waves<S>,
    water: &Water,
    at: &SystemField,
) -> Result<Option<(WaveSystem, S)>, FieldError> {
    let in_place = |error| at.of_realisation(error);
    let unbroken = |part: &str, height: f64, period: &Positive| {
        unbroken(&format!("{part}significant_height_m"), height, period.get(), water).map_err(in_place)
    };
    let height_field = at.field("significant_height_m");
    let (spectrum, direction_rad, realisation, scale) = match waves {
        Waves::Regular(_) | Waves::Record(_) => return Ok(None),
        Waves::Jonswap(sea) => {
            let (height, scale) = sea.significant_height_m.get().scaled(&height_field)?;
            unbroken("", height, &sea.peak_period_s)?;
            let spectrum = Jonswap::new(height, sea.peak_period_s.get(), sea.gamma.get()).map_err(in_place)?;
            (Spectrum::Jonswap(spectrum), sea.direction_rad, &sea.realisation, scale)
        }
        Waves::PiersonMoskowitz(sea) => {
            let (height, scale) = sea.significant_height_m.get().scaled(&height_field)?;
            unbroken("", height, &sea.peak_period_s)?;
            let spectrum = PiersonMoskowitz::new(height, sea.peak_period_s.get()).map_err(in_place)?;
            (Spectrum::PiersonMoskowitz(spectrum), sea.direction_rad, &sea.realisation, scale)
        }
        Waves::OchiHubble(sea) => {
            for (name, part) in [("swell.", &sea.swell), ("wind_sea.", &sea.wind_sea)] {
                unbroken(name, part.significant_height_m.get(), &part.peak_period_s)?;
            }
            let spectrum = OchiHubble::new([&sea.swell, &sea.wind_sea].map(ochi_hubble_part)).map_err(in_place)?;
            (Spectrum::OchiHubble(spectrum), sea.direction_rad, &sea.realisation, S::ONE)
        }
        Waves::Torsethaugen(sea) => {
            let height = sea.significant_height_m.get().same(&height_field)?;
            let spectrum = Torsethaugen::new(height, sea.peak_period_s.get(), water.gravity_m_s2).map_err(in_place)?;
            unbroken("", height, &sea.peak_period_s)?;
            (Spectrum::Torsethaugen(spectrum), sea.direction_rad, &sea.realisation, S::ONE)
        }
        Waves::Spectrum(sea) => {
            let spectrum = SpectrumTable::new(&sea.rows).map_err(in_place)?;
            (Spectrum::Table(spectrum), sea.direction_rad, &sea.realisation, S::ONE)
        }
    };
    let system = drawn(spectrum, direction_rad, realisation).map_err(in_place)?;
    Ok(Some((system, scale)))
}

fn ochi_hubble_part(part: &schema::OchiHubblePart) -> OchiHubblePart {
    OchiHubblePart {
        significant_height_m: part.significant_height_m.get(),
        peak_period_s: part.peak_period_s.get(),
        shape: part.shape.get(),
    }
}

fn drawn(spectrum: Spectrum, direction_rad: f64, given: &WaveRealisation) -> Result<WaveSystem, WaveError> {
    let spreading = match given.spreading_exponent {
        None => Spreading::LongCrested,
        Some(exponent) => Spreading::cos_2s(exponent.get())?,
    };
    let amplitudes = amplitudes(given.amplitudes);
    let band = band(given.lowest_rad_s, given.highest_rad_s);
    Ok(WaveSystem { spectrum, spreading, direction_rad, components: given.components, amplitudes, band })
}

/// Returns the way in which amplitudes are drawn.
pub(crate) fn amplitudes(given: WaveAmplitudes) -> Amplitudes {
    match given {
        WaveAmplitudes::Deterministic => Amplitudes::Deterministic,
        WaveAmplitudes::Random => Amplitudes::Random,
    }
}

/// Returns the band of frequencies that is kept, if the spectrum is cut off.
fn band(lowest: Option<Positive>, highest: Option<Positive>) -> Option<Band> {
    (lowest.is_some() || highest.is_some()).then(|| Band {
        lowest_rad_s: lowest.map_or(0.0, |lowest| lowest.get()),
        highest_rad_s: highest.map_or(f64::INFINITY, |highest| highest.get()),
    })
}
