//! Directional spreading of a sea's energy.

use core::f64::consts::PI;

use super::error::{WaveError, between};

/// The distribution of a sea's energy over directions, the same at every frequency.
///
/// ```
/// use kingpost::sea::waves::Spreading;
/// let spreading = Spreading::cos_2s(10.0)?;
/// assert!(spreading.density_per_rad(0.0) > spreading.density_per_rad(0.3));
/// # Ok::<(), kingpost::sea::waves::WaveError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Spreading {
    /// All waves propagate in the mean direction.
    LongCrested,
    /// cos^2s of half the angle from the mean direction.
    Cos2s(Cos2s),
}

/// D(b) = Gamma(s + 1) / (2 sqrt(pi) Gamma(s + 1/2)) cos^2s(b / 2), b from -pi to pi about the mean
/// direction: Longuet-Higgins, Cartwright & Smith (1963); DNV-RP-C205, sec. 3.5.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cos2s {
    exponent: f64,
    scale_per_rad: f64,
}

impl Spreading {
    /// Creates the spreading cos^2s((b - b0) / 2) with this exponent s.
    ///
    /// # Errors
    /// An exponent outside the range from 0 (equal energy in all directions) to 10,000.
    pub fn cos_2s(exponent: f64) -> Result<Self, WaveError> {
        between("spreading_exponent", exponent, [0.0, 1e4])?;
        let ratio = libm::exp(libm::lgamma(exponent + 1.0) - libm::lgamma(exponent + 0.5));
        Ok(Self::Cos2s(Cos2s { exponent, scale_per_rad: ratio / (2.0 * libm::sqrt(PI)) }))
    }

    /// Returns the density of energy, 1/rad, at this angle from the mean direction, rad; for a long-crested
    /// sea it is infinite at 0.
    pub fn density_per_rad(&self, angle_rad: f64) -> f64 {
        match self {
            Self::LongCrested => {
                if angle_rad == 0.0 {
                    f64::INFINITY
                } else {
                    0.0
                }
            }
            Self::Cos2s(spreading) => spreading.density_per_rad(angle_rad),
        }
    }

    /// Returns the angles from the mean direction, rad, below which these shares of the energy lie: the
    /// inverse of the cumulative distribution, which converts uniform random numbers to directions.
    pub fn quantiles_rad(&self, shares: &[f64]) -> Vec<f64> {
        match self {
            Self::LongCrested => vec![0.0; shares.len()],
            Self::Cos2s(spreading) => {
                let table = spreading.cumulative();
                shares.iter().map(|&share| inverse(&table, share)).collect()
            }
        }
    }
}

/// Number of intervals in the table of the cumulative distribution.
const INTERVALS: usize = 4096;

impl Cos2s {
    fn density_per_rad(&self, angle_rad: f64) -> f64 {
        let cosine = libm::cos(0.5 * angle_rad);
        self.scale_per_rad * libm::pow(cosine * cosine, self.exponent)
    }

    /// Returns angles, and the share of the energy below each angle. For large s the distribution approaches
    /// a normal one with the standard deviation sqrt(2 / s); less than 1e-18 of the energy is beyond nine
    /// standard deviations.
    fn cumulative(&self) -> Vec<(f64, f64)> {
        let end = (9.0 * libm::sqrt(2.0 / self.exponent)).min(PI);
        let width = 2.0 * end / INTERVALS as f64;
        let (mut table, mut below) = (vec![(-end, 0.0)], 0.0);
        for i in 0..INTERVALS {
            let start = -end + i as f64 * width;
            let at = |part: f64| self.density_per_rad(start + part * width);
            below += width / 6.0 * (at(0.0) + 4.0 * at(0.5) + at(1.0)); // Simpson's rule
            table.push((start + width, below));
        }
        table.iter().map(|&(angle, share)| (angle, share / below)).collect()
    }
}

/// Interpolates linearly between the rows.
fn inverse(table: &[(f64, f64)], share: f64) -> f64 {
    let after = table.partition_point(|row| row.1 < share).clamp(1, table.len() - 1);
    let ((a0, c0), (a1, c1)) = (table[after - 1], table[after]);
    if c1 > c0 { a0 + (a1 - a0) * ((share - c0) / (c1 - c0)).clamp(0.0, 1.0) } else { a0 }
}
