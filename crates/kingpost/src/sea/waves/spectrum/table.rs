//! A spectrum given as a table.

use crate::sea::waves::error::{WaveError, between};

/// S(w) at given frequencies, linear between them and 0 outside.
#[derive(Clone, Debug, PartialEq)]
pub struct SpectrumTable {
    frequencies_rad_s: Vec<f64>,
    densities_m2_s: Vec<f64>,
}

/// Smallest and largest angular frequency of a table, rad/s.
const FREQUENCIES_RAD_S: [f64; 2] = [0.0, 1e3];
/// Smallest and largest density of a table, m^2 s/rad.
const DENSITIES_M2_S: [f64; 2] = [0.0, 1e6];

impl SpectrumTable {
    /// Creates the spectrum of these rows: angular frequency, rad/s, and S, m^2 s/rad.
    ///
    /// # Errors
    /// Fewer than two rows, frequencies that do not increase or are negative, densities that are
    /// negative, or zero in all rows.
    pub fn new(rows: &[[f64; 2]]) -> Result<Self, WaveError> {
        if rows.len() < 2 {
            return Err(WaveError::new("rows", format!("{} rows", rows.len()), "at least 2 rows"));
        }
        for (i, &[frequency, density]) in rows.iter().enumerate() {
            between(&format!("rows[{i}][0]"), frequency, FREQUENCIES_RAD_S)?;
            between(&format!("rows[{i}][1]"), density, DENSITIES_M2_S)?;
            if i > 0 && frequency <= rows[i - 1][0] {
                let allowed = format!("a number above that of the row before, {}", rows[i - 1][0]);
                return Err(WaveError::new(format!("rows[{i}][0]"), frequency, allowed));
            }
        }
        if rows.iter().all(|row| row[1] == 0.0) {
            return Err(WaveError::new("rows", "no energy", "at least one density above 0"));
        }
        let [frequencies_rad_s, densities_m2_s] = [0, 1].map(|column| rows.iter().map(|row| row[column]).collect());
        Ok(Self { frequencies_rad_s, densities_m2_s })
    }

    /// S(w), m^2 s/rad.
    pub fn density_m2_s(&self, angular_frequency_rad_s: f64) -> f64 {
        let w = angular_frequency_rad_s;
        let after = self.frequencies_rad_s.partition_point(|&f| f <= w);
        if after == 0 || after == self.frequencies_rad_s.len() {
            let last = self.frequencies_rad_s.len() - 1;
            return if w == self.frequencies_rad_s[last] { self.densities_m2_s[last] } else { 0.0 };
        }
        let (w0, w1) = (self.frequencies_rad_s[after - 1], self.frequencies_rad_s[after]);
        let (s0, s1) = (self.densities_m2_s[after - 1], self.densities_m2_s[after]);
        s0 + (s1 - s0) * (w - w0) / (w1 - w0)
    }

    /// Returns the table's frequencies, rad/s.
    pub fn frequencies_rad_s(&self) -> &[f64] {
        &self.frequencies_rad_s
    }
}
