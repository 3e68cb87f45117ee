//! A measured wave record, as a sum of regular waves.

use core::f64::consts::TAU;
use std::sync::{Mutex, PoisonError};

use super::components::{ANGLES_RAD, MOST_COMPONENTS, WaveComponent};
use super::error::{WaveError, between};
use super::spectrum::Band;
use super::water::Water;

/// Elevations at equal intervals of time from a file, with the harmonics that have been computed so far.
#[derive(Debug)]
pub struct ElevationTable {
    start_s: f64,
    interval_s: f64,
    elevations_m: Vec<f64>,
    harmonics: Mutex<Vec<Option<[f64; 2]>>>,
}

impl PartialEq for ElevationTable {
    fn eq(&self, other: &Self) -> bool {
        let of = |table: &Self| (table.start_s, table.interval_s);
        of(self) == of(other) && self.elevations_m == other.elevations_m
    }
}

/// First line of a table.
const HEADER: &str = "time_s,elevation_m";
/// Largest deviation of a time from equal intervals, in intervals: printed times are rounded.
const UNEVEN: f64 = 0.05;

impl ElevationTable {
    /// Reads comma-separated values with the header `time_s,elevation_m`.
    ///
    /// # Errors
    /// Another header, a line that is not two numbers, fewer than 4 or more than 65,536 lines, times that do
    /// not increase by equal intervals, elevations that are all equal.
    ///
    /// ```
    /// use kingpost::sea::waves::ElevationTable;
    /// let table = ElevationTable::read_csv("time_s,elevation_m\n0,0.5\n0.25,0.1\n0.5,-0.4\n0.75,-0.2\n")?;
    /// assert_eq!((table.interval_s(), table.elevations_m()[2]), (0.25, -0.4));
    /// # Ok::<(), kingpost::sea::waves::WaveError>(())
    /// ```
    pub fn read_csv(text: &str) -> Result<Self, WaveError> {
        let mut lines = text.lines().map(str::trim).enumerate().filter(|(_, line)| !line.is_empty());
        let header = lines.next().map_or("", |(_, line)| line);
        if header.replace(' ', "") != HEADER {
            let shown: String = header.chars().take(60).collect();
            return Err(WaveError::new("line 1", format!("{shown:?}"), HEADER));
        }
        let row = |(number, line): (usize, &str)| {
            let numbers = line.split_once(',').and_then(|(time, elevation)| {
                Some([time.trim().parse::<f64>().ok()?, elevation.trim().parse::<f64>().ok()?])
            });
            let shown: String = line.chars().take(60).collect();
            let error =
                || WaveError::new(format!("line {}", number + 1), format!("{shown:?}"), "a time and an elevation");
            numbers.ok_or_else(error)
        };
        let rows: Vec<[f64; 2]> = lines.map(row).collect::<Result<_, _>>()?;
        Self::regular(&rows)
    }

    fn regular(rows: &[[f64; 2]]) -> Result<Self, WaveError> {
        check_samples(rows.len())?;
        let (first, last) = (rows[0][0], rows[rows.len() - 1][0]);
        let interval_s = (last - first) / (rows.len() - 1) as f64;
        for (i, [time, _]) in rows.iter().enumerate() {
            let off = (time - first - i as f64 * interval_s).abs();
            if !(interval_s > 0.0 && off <= UNEVEN * interval_s) {
                let allowed = format!("{} s, by equal intervals of {interval_s} s", first + i as f64 * interval_s);
                return Err(WaveError::new(format!("row {}", i + 1), format!("{time} s"), allowed));
            }
        }
        let elevations_m: Vec<f64> = rows.iter().map(|[_, elevation]| *elevation).collect();
        check_waves(&elevations_m)?;
        Ok(Self { start_s: first, interval_s, elevations_m, harmonics: Mutex::default() })
    }

    /// Returns the time of the first sample, s.
    pub fn start_s(&self) -> f64 {
        self.start_s
    }

    /// Returns the sampling interval, s.
    pub fn interval_s(&self) -> f64 {
        self.interval_s
    }

    /// Returns the elevations, m.
    pub fn elevations_m(&self) -> &[f64] {
        &self.elevations_m
    }

    /// Returns the components of these elevations, like [`ElevationRecord::components`]; each harmonic is
    /// computed only once.
    ///
    /// # Errors
    /// Those of [`ElevationRecord::components`].
    pub fn components(
        &self,
        position_m: [f64; 2],
        direction_rad: f64,
        band: Band,
        water: &Water,
    ) -> Result<Vec<WaveComponent>, WaveError> {
        let record = ElevationRecord {
            elevations_m: self.elevations_m.clone(),
            start_s: self.start_s,
            interval_s: self.interval_s,
            position_m,
            direction_rad,
            band: Some(band),
        };
        let mut known = self.harmonics.lock().unwrap_or_else(PoisonError::into_inner);
        known.resize(self.elevations_m.len(), None);
        record.components_of(water, |turn, m| *known[m].get_or_insert_with(|| harmonic(&self.elevations_m, turn, m)))
    }
}

/// Copies a table without its computed harmonics.
impl Clone for ElevationTable {
    fn clone(&self) -> Self {
        let Self { start_s, interval_s, elevations_m, .. } = self;
        Self {
            start_s: *start_s,
            interval_s: *interval_s,
            elevations_m: elevations_m.clone(),
            harmonics: Mutex::default(),
        }
    }
}

/// A constant record contains no waves.
fn check_waves(elevations_m: &[f64]) -> Result<(), WaveError> {
    let level = elevations_m[0];
    if elevations_m.iter().any(|elevation| *elevation != level) {
        return Ok(());
    }
    let found = format!("no waves in the record: every elevation is {level} m");
    Err(WaveError::new("elevations_m", found, "elevations that differ"))
}

fn check_samples(count: usize) -> Result<(), WaveError> {
    if (4..=MOST_SAMPLES).contains(&count) {
        return Ok(());
    }
    Err(WaveError::new("elevations_m", format!("{count} samples"), format!("4 to {MOST_SAMPLES} samples")))
}

/// Surface elevation at one point, measured at equal intervals.
#[derive(Clone, Debug, PartialEq)]
pub struct ElevationRecord {
    /// Elevations, m.
    pub elevations_m: Vec<f64>,
    /// Time of the first sample, s.
    pub start_s: f64,
    /// Sampling interval, s.
    pub interval_s: f64,
    /// Position of the measurement: x and y, world, m.
    pub position_m: [f64; 2],
    /// Propagation direction, from the world's x counter-clockwise, rad. A measurement at one point does not
    /// determine it.
    pub direction_rad: f64,
    /// Frequencies that are kept; `None` for all below half the sampling frequency.
    pub band: Option<Band>,
}

/// Most samples of a record: three hours at 6 Hz.
pub const MOST_SAMPLES: usize = 65_536;

impl ElevationRecord {
    /// Returns the waves whose sum has these elevations at this point: the discrete Fourier transform of the
    /// record, one wave for each harmonic in the band. The mean is omitted, and also the harmonic at half the
    /// sampling frequency, because the samples do not determine its phase. The sum is periodic with the
    /// record's length, so the first sample should continue the last one.
    ///
    /// The transform is summed directly. A record of 20 minutes at 2 Hz needs 3 million multiplications and
    /// the longest 10^9, so a fast Fourier transform would not justify the larger download in the browser. An
    /// [`ElevationTable`] stores the harmonics, so each harmonic of a file is summed once, however often a
    /// scenario is built. Sines and cosines are read from a table, so that errors do not grow along the sum.
    ///
    /// # Errors
    /// Fewer than 4 samples or more than 65,536, elevations above 100 m, not finite or all the same, an interval
    /// outside 1e-3 to 1e3 s, a band without a harmonic or with more than 20,000.
    pub fn components(&self, water: &Water) -> Result<Vec<WaveComponent>, WaveError> {
        self.components_of(water, |turn, m| harmonic(&self.elevations_m, turn, m))
    }

    /// Returns the waves of these harmonics, computed with the table of sines and cosines.
    fn components_of(
        &self,
        water: &Water,
        mut harmonic: impl FnMut(&[(f64, f64)], usize) -> [f64; 2],
    ) -> Result<Vec<WaveComponent>, WaveError> {
        self.check()?;
        let count = self.elevations_m.len();
        let step_rad_s = TAU / (count as f64 * self.interval_s);
        let band = self.band.unwrap_or(Band { lowest_rad_s: 0.0, highest_rad_s: f64::INFINITY });
        let kept = |&m: &usize| (band.lowest_rad_s..=band.highest_rad_s).contains(&(m as f64 * step_rad_s));
        let harmonics: Vec<usize> = (1..count.div_ceil(2)).filter(kept).collect();
        if harmonics.is_empty() || harmonics.len() > MOST_COMPONENTS {
            let found = format!("{} harmonics of {step_rad_s:.6} rad/s", harmonics.len());
            let allowed = format!("a band with 1 to {MOST_COMPONENTS} harmonics below half the sampling frequency");
            return Err(WaveError::new("lowest_rad_s, highest_rad_s", found, allowed));
        }
        let turn: Vec<(f64, f64)> = (0..count).map(|n| libm::sincos(TAU * n as f64 / count as f64)).collect();
        let wave = |&m: &usize| self.wave(m as f64 * step_rad_s, harmonic(&turn, m), water);
        Ok(harmonics.iter().map(wave).collect())
    }

    /// Returns the wave with this complex elevation at the point and the time of the first sample.
    fn wave(&self, frequency_rad_s: f64, [real, imaginary]: [f64; 2], water: &Water) -> WaveComponent {
        let amplitude = libm::sqrt(real * real + imaginary * imaginary);
        let mut wave = WaveComponent::in_water(water, amplitude, frequency_rad_s, self.direction_rad, 0.0);
        let (sin, cos) = libm::sincos(self.direction_rad);
        let along = self.position_m[0] * cos + self.position_m[1] * sin;
        wave.phase_rad = libm::atan2(imaginary, real) + frequency_rad_s * self.start_s - wave.wave_number_per_m * along;
        wave
    }

    fn check(&self) -> Result<(), WaveError> {
        check_samples(self.elevations_m.len())?;
        for (i, &elevation) in self.elevations_m.iter().enumerate() {
            between(&format!("elevations_m[{i}]"), elevation, [-100.0, 100.0])?;
        }
        check_waves(&self.elevations_m)?;
        // From pressure gauges at 1 kHz to one sample in a quarter of an hour.
        between("interval_s", self.interval_s, [1e-3, 1e3])?;
        between("start_s", self.start_s, [-1e7, 1e7])?;
        between("direction_rad", self.direction_rad, ANGLES_RAD)?;
        between("position_m[0]", self.position_m[0], [-1e6, 1e6])?;
        between("position_m[1]", self.position_m[1], [-1e6, 1e6])?;
        Ok(())
    }
}

/// Returns (2 / N) sum of eta_n e^(2 pi i m n / N): the complex amplitude of e^(-i w_m t).
fn harmonic(elevations_m: &[f64], turn: &[(f64, f64)], m: usize) -> [f64; 2] {
    let (count, mut place) = (elevations_m.len(), 0);
    let (mut real, mut imaginary) = (0.0, 0.0);
    for elevation in elevations_m {
        let (sin, cos) = turn[place];
        real += elevation * cos;
        imaginary += elevation * sin;
        place = (place + m) % count;
    }
    let scale = 2.0 / count as f64;
    [scale * real, scale * imaginary]
}
