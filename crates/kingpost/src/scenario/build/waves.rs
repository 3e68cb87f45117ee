//! The waves of the sea, drawn from its spectra.

use super::super::schema::{self, Positive, Scenario, WaveAmplitudes, WaveRealisation, Waves};
use super::FieldError;
use super::reading::{Gathered, Reading};
use super::water::{gravity, water_of};
use crate::sea::waves::{
    Amplitudes, Band, Jonswap, OchiHubble, OchiHubblePart, PiersonMoskowitz, Spectrum, SpectrumTable, Spreading,
    Torsethaugen, Water, WaveComponent, WaveError, WaveSystem,
};

/// All components of all wave systems, in the order of the file. Amplitudes are gathered from all
/// scenarios; frequencies, directions and phases are those of the first, which all must share.
pub fn build<S: Gathered>(scenario: &Reading<Scenario>, water: &Water) -> Result<Vec<WaveComponent<S>>, FieldError> {
    let realise = |scenario: &&Scenario| realise(scenario, water);
    let all: Vec<Vec<WaveComponent>> = scenario.all().iter().map(realise).collect::<Result<_, _>>()?;
    let together = |i: usize| {
        let amplitudes: Vec<f64> = all.iter().map(|waves| waves[i].amplitude_m).collect();
        WaveComponent { amplitude_m: scenario.gathered(&amplitudes), ..all[0][i].constant() }
    };
    let shared = |waves: &Vec<WaveComponent>| {
        let same = |(a, b): (&WaveComponent, &WaveComponent)| WaveComponent { amplitude_m: b.amplitude_m, ..*a } == *b;
        waves.len() == all[0].len() && waves.iter().zip(&all[0]).all(same)
    };
    match all.iter().all(shared) {
        true => Ok((0..all[0].len()).map(together).collect()),
        false => Err(FieldError::new(
            "sea.waves",
            "another period, direction or seed",
            "heights only: the waves of one realisation change by no other number continuously",
        )),
    }
}

/// The components of one scenario.
fn realise(scenario: &Scenario, water: &Water) -> Result<Vec<WaveComponent>, FieldError> {
    let (mut components, seed) = (Vec::new(), scenario.simulation.seed);
    let systems = scenario.sea.iter().flat_map(|sea| &sea.waves);
    for (number, (name, waves)) in (0..).zip(systems) {
        let field = |field: &str| match waves {
            Waves::Regular(_) | Waves::Record(_) => format!("sea.waves.{name}.{}.{field}", waves.kind()),
            _ if OF_REALISATION.iter().any(|part| field.starts_with(part)) => {
                format!("sea.waves.{name}.{}.realisation.{field}", waves.kind())
            }
            _ => format!("sea.waves.{name}.{}.{field}", waves.kind()),
        };
        let in_place = |error: WaveError| FieldError::new(field(&error.field), error.found, error.allowed);
        let found = match waves {
            _ if !waves.enabled() => Ok(Vec::new()),
            Waves::Regular(wave) => regular(wave, water),
            Waves::Record(given) => record(scenario, given, water),
            _ => of_spectrum(waves, water).and_then(|system| match system {
                Some(system) => system.components(seed, number, water),
                None => Ok(Vec::new()),
            }),
        };
        components.extend(found.map_err(in_place)?);
    }
    Ok(components)
}

/// Fields of the realisation, among those of a spectrum's waves.
const OF_REALISATION: [&str; 4] = ["components", "spreading_exponent", "lowest_rad_s", "highest_rad_s"];

/// What a scenario cuts off its spectra: by the name of the waves, the significant height of the whole spectrum, m, and
/// the share of its energy that is cut off.
pub fn cut_off(scenario: &Scenario) -> Vec<(String, f64, f64)> {
    let Some(sea) = &scenario.sea else { return Vec::new() };
    let Ok(water) = gravity(scenario).and_then(|gravity| water_of(sea, gravity)) else { return Vec::new() };
    let systems = sea.waves.iter().filter(|(_, waves)| waves.enabled());
    let cut = systems.filter_map(|(name, waves)| {
        let system = of_spectrum(waves, &water).ok()??;
        system.band?;
        Some((name.to_string(), system.spectrum.significant_height_m(), system.energy_cut_off()))
    });
    cut.collect()
}

fn regular(wave: &schema::RegularWave, water: &Water) -> Result<Vec<WaveComponent>, WaveError> {
    let schema::RegularWave { height_m, period_s, direction_rad, phase_rad, .. } = wave;
    Ok(vec![WaveComponent::regular(height_m.get(), period_s.get(), *direction_rad, *phase_rad, water)?])
}

fn record(
    scenario: &Scenario,
    given: &schema::ElevationRecord,
    water: &Water,
) -> Result<Vec<WaveComponent>, WaveError> {
    let Some(table) = scenario.files.record(&given.file) else { return Ok(Vec::new()) };
    let all = Band { lowest_rad_s: 0.0, highest_rad_s: f64::INFINITY };
    let band = band(given.lowest_rad_s, given.highest_rad_s).unwrap_or(all);
    table.components(given.position_m, given.direction_rad, band, water)
}

/// The random sea of a spectrum; waves of another kind are none.
fn of_spectrum(waves: &Waves, water: &Water) -> Result<Option<WaveSystem>, WaveError> {
    let (spectrum, direction_rad, realisation) = match waves {
        Waves::Regular(_) | Waves::Record(_) => return Ok(None),
        Waves::Jonswap(sea) => {
            let (height, period) = (sea.significant_height_m.get(), sea.peak_period_s.get());
            let spectrum = Jonswap::new(height, period, sea.gamma.get())?;
            (Spectrum::Jonswap(spectrum), sea.direction_rad, &sea.realisation)
        }
        Waves::PiersonMoskowitz(sea) => {
            let spectrum = PiersonMoskowitz::new(sea.significant_height_m.get(), sea.peak_period_s.get())?;
            (Spectrum::PiersonMoskowitz(spectrum), sea.direction_rad, &sea.realisation)
        }
        Waves::OchiHubble(sea) => {
            let spectrum = OchiHubble::new([&sea.swell, &sea.wind_sea].map(ochi_hubble_part))?;
            (Spectrum::OchiHubble(spectrum), sea.direction_rad, &sea.realisation)
        }
        Waves::Torsethaugen(sea) => {
            let (height, period) = (sea.significant_height_m.get(), sea.peak_period_s.get());
            let spectrum = Torsethaugen::new(height, period, water.gravity_m_s2)?;
            (Spectrum::Torsethaugen(spectrum), sea.direction_rad, &sea.realisation)
        }
        Waves::Spectrum(sea) => (Spectrum::Table(SpectrumTable::new(&sea.rows)?), sea.direction_rad, &sea.realisation),
    };
    drawn(spectrum, direction_rad, realisation).map(Some)
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
    let amplitudes = match given.amplitudes {
        WaveAmplitudes::Deterministic => Amplitudes::Deterministic,
        WaveAmplitudes::Random => Amplitudes::Random,
    };
    let band = band(given.lowest_rad_s, given.highest_rad_s);
    Ok(WaveSystem { spectrum, spreading, direction_rad, components: given.components, amplitudes, band })
}

/// The frequencies that are kept, where anything is cut off.
fn band(lowest: Option<Positive>, highest: Option<Positive>) -> Option<Band> {
    (lowest.is_some() || highest.is_some()).then(|| Band {
        lowest_rad_s: lowest.map_or(0.0, |lowest| lowest.get()),
        highest_rad_s: highest.map_or(f64::INFINITY, |highest| highest.get()),
    })
}
