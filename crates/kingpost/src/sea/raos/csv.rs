//! RAOs as comma-separated values; the column names state the conventions.

use super::{RaoEntry, RaoError, RaoFile, phasor};
use crate::sea::database::MODES;
use core::f64::consts::TAU;

/// Names of amplitudes without their units, and their sign relative to Kingpost's convention, by mode.
const SENSES: [&[(&str, f64)]; 6] = [
    &[("surge_forward", 1.0)],
    &[("sway_port", 1.0), ("sway_starboard", -1.0)],
    &[("heave_up", 1.0)],
    &[("roll_port_up", 1.0), ("roll_starboard_up", -1.0)],
    &[("pitch_bow_down", 1.0), ("pitch_bow_up", -1.0)],
    &[("yaw_bow_port", 1.0), ("yaw_bow_starboard", -1.0)],
];

/// Index of a column, and the factor of its numbers.
type ScaledColumn = (usize, f64);

/// Conversion of a number in a file to rad/s.
pub(super) type ToRadS = fn(f64) -> f64;

/// Indices of the columns.
struct RaoColumns {
    direction: ScaledColumn,
    frequency: (usize, ToRadS),
    amplitudes: [ScaledColumn; 6],
    lags: [ScaledColumn; 6],
}

pub(super) fn read(text: &str) -> Result<RaoFile, RaoError> {
    let mut lines = text.lines().enumerate().filter(|(_, line)| {
        let line = line.trim();
        !line.is_empty() && !line.starts_with('#')
    });
    let Some((_, names)) = lines.next() else {
        return Err(RaoError::new("line 1", "nothing", "a line of names"));
    };
    let names: Vec<&str> = names.split(',').map(str::trim).collect();
    let columns = RaoColumns::find(&names)?;
    let rows: Result<Vec<RaoEntry>, RaoError> =
        lines.map(|(number, line)| columns.row(number + 1, &names, line)).collect();
    Ok(RaoFile { rows: rows?, origin_m: [0.0; 3], phase_origin_m: [0.0; 3], symmetric: None })
}

impl RaoColumns {
    fn find(names: &[&str]) -> Result<Self, RaoError> {
        let one_of = |allowed: &[(String, f64)]| {
            let found =
                allowed.iter().find_map(|(name, factor)| Some((names.iter().position(|n| n == name)?, *factor)));
            let all = || allowed.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>().join(" or ");
            found.ok_or_else(|| RaoError::new("line of names", names.join(","), format!("{} in it", all())))
        };
        let degree = 1.0_f64.to_radians();
        let amplitude = |mode: usize| {
            let units: &[(&str, f64)] =
                if mode < 3 { &[("m_per_m", 1.0)] } else { &[("deg_per_m", 1.0_f64.to_radians()), ("rad_per_m", 1.0)] };
            let named = |(sense, sign): &(&str, f64)| {
                units.iter().map(|(unit, factor)| (format!("{sense}_{unit}"), sign * factor)).collect::<Vec<_>>()
            };
            one_of(&SENSES[mode].iter().flat_map(named).collect::<Vec<_>>())
        };
        let lag = |mode: usize| {
            let named = |way: &str, unit: &str, factor: f64| (format!("{}_{way}_{unit}", MODES[mode]), factor);
            one_of(&[
                named("lag", "deg", degree),
                named("lead", "deg", -degree),
                named("lag", "rad", 1.0),
                named("lead", "rad", -1.0),
            ])
        };
        let mut all = [[(0, 0.0); 2]; 6];
        for (mode, [a, l]) in all.iter_mut().enumerate() {
            (*a, *l) = (amplitude(mode)?, lag(mode)?);
        }
        let kinds: [(&str, ToRadS); 3] =
            [("period_s", |period| TAU / period), ("frequency_rad_s", |w| w), ("frequency_Hz", |f| TAU * f)];
        let frequency = one_of(&kinds.map(|(name, _)| (name.to_owned(), 1.0)))?.0;
        let (_, to_rad_s) = kinds.into_iter().find(|(name, _)| *name == names[frequency]).unwrap_or(kinds[1]);
        let direction = one_of(&[("direction_to_deg".to_owned(), degree), ("direction_to_rad".to_owned(), 1.0)])?;
        let [amplitudes, lags] = [0, 1].map(|k| all.map(|both| both[k]));
        Ok(Self { direction, frequency: (frequency, to_rad_s), amplitudes, lags })
    }

    fn row(&self, line: usize, names: &[&str], text: &str) -> Result<RaoEntry, RaoError> {
        let cells: Vec<&str> = text.split(',').map(str::trim).collect();
        if cells.len() != names.len() {
            let found = format!("{} values", cells.len());
            return Err(RaoError::new(format!("line {line}"), found, format!("{}, one for each name", names.len())));
        }
        let number = |(column, factor): ScaledColumn| {
            let number = cells[column].parse::<f64>().ok().filter(|number| number.is_finite());
            let field = || format!("line {line}, {}", names[column]);
            number.map(|n| n * factor).ok_or_else(|| RaoError::new(field(), cells[column], "a finite number"))
        };
        let frequency_rad_s = (self.frequency.1)(number((self.frequency.0, 1.0))?);
        if !(frequency_rad_s.is_finite() && frequency_rad_s >= 0.0) {
            let field = format!("line {line}, {}", names[self.frequency.0]);
            return Err(RaoError::new(field, cells[self.frequency.0], "a number greater than 0"));
        }
        let mut response = [[0.0; 2]; 6];
        for (mode, parts) in response.iter_mut().enumerate() {
            *parts = phasor(number(self.amplitudes[mode])?, number(self.lags[mode])?);
        }
        Ok(RaoEntry { direction_rad: number(self.direction)?.rem_euclid(TAU), frequency_rad_s, response })
    }
}
