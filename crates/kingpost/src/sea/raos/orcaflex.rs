//! RAOs in OrcaFlex's YAML; the vessel type states the conventions.

use super::csv::ToRadS;
use super::{RaoEntry, RaoError, RaoFile, phasor};
use core::f64::consts::{PI, TAU};
use serde_json::Value;

/// Key of the table of one direction.
const COLUMNS: &str = "RAOPeriodOrFrequency, RAOSurgeAmp, RAOSurgePhase, RAOSwayAmp, RAOSwayPhase, RAOHeaveAmp, \
                       RAOHeavePhase, RAORollAmp, RAORollPhase, RAOPitchAmp, RAOPitchPhase, RAOYawAmp, RAOYawPhase";

pub(super) fn read(text: &str) -> Result<RaoFile, RaoError> {
    let whole: Value = serde_saphyr::from_str(text)
        .map_err(|error| RaoError::new("the file", error.to_string().replace('\n', " "), "YAML"))?;
    let vessel = only(&whole["VesselTypes"], "VesselTypes")?;
    let conventions = Conventions::of(vessel)?;
    let draught = only(&vessel["Draughts"], "Draughts")?;
    let raos = &draught["DisplacementRAOs"];
    let origin_m = point(&raos["RAOOrigin"], "DisplacementRAOs.RAOOrigin")?
        .ok_or_else(|| RaoError::new("DisplacementRAOs.RAOOrigin", &raos["RAOOrigin"], "three numbers"))?;
    let phase_origin_m = point(&raos["PhaseOrigin"], "DisplacementRAOs.PhaseOrigin")?.unwrap_or(origin_m);
    let Some(tables) = raos["RAOs"].as_array().filter(|tables| !tables.is_empty()) else {
        return Err(RaoError::new("DisplacementRAOs.RAOs", &raos["RAOs"], "a list of directions"));
    };
    let mut rows = Vec::new();
    for table in tables {
        let Some(direction) = table["RAODirection"].as_f64() else {
            return Err(RaoError::new("RAODirection", &table["RAODirection"], "a direction, deg"));
        };
        let Some(lines) = table[COLUMNS].as_array() else {
            return Err(RaoError::new(format!("RAODirection {direction}"), "no table", format!("a table {COLUMNS}")));
        };
        for line in lines {
            rows.push(conventions.row(direction, line)?);
        }
    }
    Ok(RaoFile { rows, origin_m, phase_origin_m, symmetric: Some(conventions.symmetric) })
}

fn only<'a>(list: &'a Value, name: &str) -> Result<&'a Value, RaoError> {
    match list.as_array().map(Vec::as_slice) {
        Some([one]) => Ok(one),
        other => Err(RaoError::new(name, format!("{} of them", other.map_or(0, <[Value]>::len)), "one")),
    }
}

/// Reads a point; `None` for `[~, ~, ~]` and for a missing entry.
fn point(value: &Value, field: &str) -> Result<Option<[f64; 3]>, RaoError> {
    match value.as_array().map(Vec::as_slice) {
        None if value.is_null() => Ok(None),
        Some([x, y, z]) if [x, y, z].iter().all(|entry| entry.is_null()) => Ok(None),
        Some([x, y, z]) => match [x, y, z].map(Value::as_f64) {
            [Some(x), Some(y), Some(z)] => Ok(Some([x, y, z])),
            _ => Err(RaoError::new(field, value, "three numbers")),
        },
        _ => Err(RaoError::new(field, value, "three numbers")),
    }
}

/// Conventions of a vessel type.
struct Conventions {
    to_rad_s: ToRadS,
    /// Factors of the amplitudes, by mode, to m/m and rad/m.
    factors: [f64; 6],
    /// Conversion of a phase to a lag behind the crest: factor and offset, rad.
    lag: [f64; 2],
    symmetric: bool,
}

impl Conventions {
    fn of(vessel: &Value) -> Result<Self, RaoError> {
        let angle = choice(vessel, "RAOResponseUnits", &[("degrees", 1.0_f64.to_radians()), ("radians", 1.0)])?;
        choice(vessel, "RAOWaveUnit", &[("amplitude", ())])?;
        let sense =
            |name: &str, positive: &str, negative: &str| choice(vessel, name, &[(positive, 1.0), (negative, -1.0)]);
        let factors = [
            sense("SurgePositive", "forward", "aft")?,
            sense("SwayPositive", "port", "starboard")?,
            sense("HeavePositive", "up", "down")?,
            sense("RollPositiveStarboard", "down", "up")? * angle,
            sense("PitchPositiveBow", "down", "up")? * angle,
            sense("YawPositiveBow", "port", "starboard")? * angle,
        ];
        let way = choice(vessel, "RAOPhaseConvention", &[("lags", 1.0), ("leads", -1.0)])?;
        let unit = choice(vessel, "RAOPhaseUnitsConvention", &[("degrees", 1.0_f64.to_radians()), ("radians", 1.0)])?;
        // Event of the wave at the origin to which phases refer, as its phase after the crest.
        let references =
            [("crest", 0.0), ("zero down-crossing", PI / 2.0), ("trough", PI), ("zero up-crossing", 1.5 * PI)];
        let after = choice(vessel, "RAOPhaseRelativeToConvention", &references)?;
        let period: ToRadS = |period| TAU / period;
        let kinds = [("period (s)", period), ("frequency (rad/s)", |w| w), ("frequency (Hz)", |f| TAU * f)];
        let to_rad_s = choice(vessel, "WavesReferredToBy", &kinds)?;
        let symmetric = choice(vessel, "Symmetry", &[("xz plane", true), ("None", false)])?;
        Ok(Self { to_rad_s, factors, lag: [way * unit, after], symmetric })
    }

    fn row(&self, direction: f64, line: &Value) -> Result<RaoEntry, RaoError> {
        let number = |cell: &Value| cell.as_f64().or((cell == "Infinity").then_some(f64::INFINITY));
        let numbers: Option<Vec<f64>> = line.as_array().and_then(|cells| cells.iter().map(number).collect());
        let numbers = numbers.filter(|all| all.len() == 13 && all[1..].iter().all(|x| x.is_finite()));
        let wrong = || RaoError::new(format!("RAODirection {direction}"), line, "13 numbers in a row");
        let numbers = numbers.ok_or_else(wrong)?;
        let frequency_rad_s = (self.to_rad_s)(numbers[0]);
        if !(frequency_rad_s.is_finite() && frequency_rad_s >= 0.0) {
            return Err(wrong());
        }
        let response = core::array::from_fn(|mode| {
            let [amplitude, phase] = [numbers[1 + 2 * mode], numbers[2 + 2 * mode]];
            phasor(amplitude * self.factors[mode], self.lag[0] * phase + self.lag[1])
        });
        Ok(RaoEntry { direction_rad: direction.to_radians().rem_euclid(TAU), frequency_rad_s, response })
    }
}

/// Returns the meaning of a convention, which must be stated.
fn choice<T: Copy>(vessel: &Value, name: &str, choices: &[(&str, T)]) -> Result<T, RaoError> {
    // YAML reads None as a text, and ~ as null.
    let found = vessel[name].as_str();
    let chosen = choices.iter().find(|(word, _)| found == Some(*word));
    chosen.map(|(_, meaning)| *meaning).ok_or_else(|| {
        let allowed: Vec<&str> = choices.iter().map(|(word, _)| *word).collect();
        let found = found.map_or_else(|| "nothing".to_owned(), str::to_owned);
        RaoError::new(name, found, format!("{}, stated in the vessel type", allowed.join(" or ")))
    })
}
