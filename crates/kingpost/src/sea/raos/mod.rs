//! Displacement RAOs of a ship: its motion in a regular wave of unit amplitude. They are read from a file
//! that states its conventions.

mod csv;
mod long_waves;
mod orcaflex;

pub use long_waves::OtherUnit;

use crate::scalar::Scalar;
use core::f64::consts::{PI, TAU};
use thiserror::Error;

/// An error in a file of RAOs.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("{field}: found {found}, allowed: {allowed}")]
pub struct RaoError {
    /// The field.
    pub field: String,
    /// Value or text that was found.
    pub found: String,
    /// Range or form that is allowed.
    pub allowed: String,
}

/// Smallest difference of two directions, rad, below which they are equal: tables have at most five digits of
/// a degree.
const ONE_DIRECTION_RAD: f64 = 1e-6;

impl RaoError {
    fn new(field: impl ToString, found: impl ToString, allowed: impl ToString) -> Self {
        Self { field: field.to_string(), found: found.to_string(), allowed: allowed.to_string() }
    }
}

/// Response in surge, sway, heave (m/m), roll, pitch, yaw (rad/m), real and imaginary part of each: x
/// forward, y to port, z up, right-handed, with the motion Re{X a e^(-i w t)} for a wave Re{a e^(-i w t)} at
/// the RAOs' origin. A positive angle is a lag.
pub type MotionResponse<S = f64> = [[S; 2]; 6];

/// Displacement RAOs over wave direction and frequency.
#[derive(Clone, Debug, PartialEq)]
pub struct RaoTable {
    /// Point whose motion the RAOs give, in the file's vessel axes, m.
    pub origin_m: [f64; 3],
    /// Point of the wave to which the phases refer, in the same axes, m.
    pub phase_origin_m: [f64; 3],
    /// Whether port and starboard are symmetric, if the file states it.
    pub symmetric: Option<bool>,
    /// Propagation directions of the waves, from the x axis counter-clockwise, rad, increasing within one
    /// turn.
    directions_rad: Vec<f64>,
    /// Frequencies, rad/s, increasing.
    frequencies_rad_s: Vec<f64>,
    /// Responses by direction and frequency.
    responses: Vec<Vec<MotionResponse>>,
}

/// An entry of a file: a wave, and the response to it.
struct RaoEntry {
    direction_rad: f64,
    frequency_rad_s: f64,
    response: MotionResponse,
}

/// The contents of a file.
struct RaoFile {
    rows: Vec<RaoEntry>,
    origin_m: [f64; 3],
    phase_origin_m: [f64; 3],
    symmetric: Option<bool>,
}

/// Smallest difference of angles, rad, or frequencies, rad/s, below which they are equal.
const SAME: f64 = 1e-9;

impl RaoTable {
    /// Reads the text of a file: OrcaFlex's YAML if it contains `VesselTypes`, otherwise CSV.
    ///
    /// The first line of the CSV has names that state the conventions: `direction_to_deg` (where the waves go to, from
    /// x counter-clockwise: 180 is a head sea); `period_s`, `frequency_rad_s` or `frequency_Hz`; and for each motion
    /// its amplitude and its phase, `surge_forward_m_per_m`, `sway_port_m_per_m` or `sway_starboard_m_per_m`,
    /// `heave_up_m_per_m`, `roll_port_up_deg_per_m` or `roll_starboard_up_...`, `pitch_bow_down_...` or
    /// `pitch_bow_up_...`, `yaw_bow_port_...` or `yaw_bow_starboard_...`, in `deg_per_m` or `rad_per_m`; phases as
    /// `surge_lag_deg` or `surge_lead_deg` against the crest at the origin.
    ///
    /// # Errors
    /// Missing, unknown or NaN entries, by line and name; directions with different frequencies.
    pub fn read(text: &str) -> Result<Self, RaoError> {
        let text = text.trim_start_matches('\u{feff}');
        let is_yaml = text.lines().any(|line| line.trim_end() == "VesselTypes:");
        Self::from_content(if is_yaml { orcaflex::read(text)? } else { csv::read(text)? })
    }

    fn from_content(content: RaoFile) -> Result<Self, RaoError> {
        let RaoFile { mut rows, origin_m, phase_origin_m, symmetric } = content;
        let order = |a: &RaoEntry, b: &RaoEntry| {
            let by_direction = a.direction_rad.total_cmp(&b.direction_rad);
            by_direction.then(a.frequency_rad_s.total_cmp(&b.frequency_rad_s))
        };
        rows.sort_by(order);
        let (directions_rad, frequencies_rad_s, responses) = (vec![], vec![], vec![]);
        let mut table = Self { origin_m, phase_origin_m, symmetric, directions_rad, frequencies_rad_s, responses };
        let mut frequencies: Vec<Vec<f64>> = Vec::new();
        for row in rows {
            if table.directions_rad.last().is_none_or(|last| row.direction_rad - last > SAME) {
                table.directions_rad.push(row.direction_rad);
                frequencies.push(Vec::new());
                table.responses.push(Vec::new());
            }
            if let (Some(of_direction), Some(responses)) = (frequencies.last_mut(), table.responses.last_mut()) {
                of_direction.push(row.frequency_rad_s);
                responses.push(row.response);
            }
        }
        table.frequencies_rad_s = frequencies.first().cloned().unwrap_or_default();
        table.check(&frequencies)?;
        Ok(table)
    }

    fn check(&self, frequencies: &[Vec<f64>]) -> Result<(), RaoError> {
        let first = &self.frequencies_rad_s;
        if first.len() < 2 || first.windows(2).any(|pair| pair[1] - pair[0] <= SAME) {
            return Err(RaoError::new("frequencies", format!("{first:?} rad/s"), "two or more, each once"));
        }
        for (direction, other) in self.directions_rad.iter().zip(frequencies) {
            if other.len() != first.len() || other.iter().zip(first).any(|(a, b)| (a - b).abs() > SAME) {
                let field = format!("direction {:.6} deg", direction.to_degrees());
                let found = format!("frequencies {other:?} rad/s");
                return Err(RaoError::new(field, found, format!("those of the first direction, {first:?}")));
            }
        }
        Ok(())
    }

    /// Returns the table over the whole circle. If `symmetric` states that port and starboard are symmetric,
    /// directions from 0 to 180 degrees are enough.
    ///
    /// # Errors
    /// A gap of more than a quarter of the circle between directions; a half circle without a statement of symmetry.
    pub fn whole_circle(&self, symmetric: Option<bool>) -> Result<Self, RaoError> {
        let mut table = self.clone();
        if self.symmetric.or(symmetric) == Some(true) {
            for (direction, responses) in self.directions_rad.iter().zip(&self.responses).rev() {
                let mirrored = (TAU - direction).rem_euclid(TAU);
                let is_there = |known: &f64| {
                    let apart = (mirrored - known).abs();
                    !(ONE_DIRECTION_RAD..=TAU - ONE_DIRECTION_RAD).contains(&apart)
                };
                if !table.directions_rad.iter().any(is_there) {
                    let at = table.directions_rad.partition_point(|known| *known < mirrored);
                    table.directions_rad.insert(at, mirrored);
                    table.responses.insert(at, responses.iter().map(mirror).collect());
                }
            }
        }
        let next = |i: usize| table.directions_rad.get(i + 1).copied().unwrap_or(table.directions_rad[0] + TAU);
        let gap = |i: usize| next(i) - table.directions_rad[i];
        match (0..table.directions_rad.len()).find(|&i| gap(i) > PI / 2.0 + ONE_DIRECTION_RAD) {
            Some(i) => {
                let [from, to] = [table.directions_rad[i], next(i)].map(f64::to_degrees);
                let found = format!("nothing from {from:.1} to {to:.1} deg");
                let allowed = "gaps of at most 90 deg; with symmetric: true directions from 0 to 180 deg are enough";
                Err(RaoError::new("directions", found, allowed))
            }
            None => Ok(table),
        }
    }

    /// Returns whether a frequency is within those of the table.
    pub fn covers(&self, frequency_rad_s: f64) -> bool {
        let [lowest, highest] = self.band_rad_s();
        (lowest..=highest).contains(&frequency_rad_s)
    }

    /// Returns the lowest and the highest frequency, rad/s.
    pub fn band_rad_s(&self) -> [f64; 2] {
        [self.frequencies_rad_s[0], self.frequencies_rad_s[self.frequencies_rad_s.len() - 1]]
    }

    /// Returns the real and imaginary parts of the response, interpolated linearly between the nearest
    /// directions and frequencies; zero outside the table.
    pub fn at<S: Scalar>(&self, frequency_rad_s: f64, direction_rad: S) -> MotionResponse<S> {
        if !self.covers(frequency_rad_s) {
            return [[S::ZERO; 2]; 6];
        }
        let between = |[direction]: [f64; 1]| {
            let (share, width, ends) = self.between_directions(frequency_rad_s, direction);
            core::array::from_fn(|k| match k {
                0 => share,
                1 => width,
                _ => ends[(k - 2) / 12][(k - 2) / 2 % 6][k % 2],
            })
        };
        let found: [S; 26] = S::from_values([direction_rad], &between);
        // The share has its present value, and its derivative with respect to the direction.
        let share = found[0] + (direction_rad - direction_rad.plain()) / found[1];
        core::array::from_fn(|mode| {
            core::array::from_fn(|part| {
                let [before, after] = [0, 1].map(|end| found[2 + 12 * end + 2 * mode + part]);
                before + share * (after - before)
            })
        })
    }

    /// Returns the position of a direction between the two nearest ones, the angle between these, rad, and
    /// the responses at both.
    fn between_directions(&self, frequency_rad_s: f64, direction_rad: f64) -> (f64, f64, [MotionResponse; 2]) {
        let n = self.directions_rad.len();
        let first = self.directions_rad[0];
        let direction = (direction_rad - first).rem_euclid(TAU) + first;
        let before = self.directions_rad.partition_point(|known| *known <= direction).max(1) - 1;
        let after = (before + 1) % n;
        let width = (self.directions_rad[after] - self.directions_rad[before]).rem_euclid(TAU);
        let share = if width > 0.0 { (direction - self.directions_rad[before]) / width } else { 0.0 };
        let high = self.frequencies_rad_s.partition_point(|known| *known < frequency_rad_s).max(1);
        let [low_at, high_at] = [high - 1, high].map(|i| self.frequencies_rad_s[i]);
        let along = (frequency_rad_s - low_at) / (high_at - low_at);
        let of = |i: usize, mode: usize, part: usize| {
            let [low, high] = [high - 1, high].map(|k| self.responses[i][k][mode][part]);
            low + along * (high - low)
        };
        let at = |i: usize| core::array::from_fn(|mode| [of(i, mode, 0), of(i, mode, 1)]);
        (share, if width > 0.0 { width } else { TAU }, [at(before), at(after)])
    }
}

/// Returns the response to the mirrored wave.
fn mirror(response: &MotionResponse) -> MotionResponse {
    let sign = |mode: usize| if mode.is_multiple_of(2) { 1.0 } else { -1.0 };
    core::array::from_fn(|mode| response[mode].map(|part| sign(mode) * part))
}

/// Returns A e^(i lag).
fn phasor(amplitude: f64, lag_rad: f64) -> [f64; 2] {
    let (sin, cos) = libm::sincos(lag_rad);
    [amplitude * cos, amplitude * sin]
}
