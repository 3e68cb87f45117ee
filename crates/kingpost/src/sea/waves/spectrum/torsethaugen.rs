//! Simplified two-peaked spectrum of Torsethaugen.

use core::f64::consts::{PI, TAU};

use super::{Band, gamma_shape, integral, peak_enhancement};
use crate::sea::waves::error::{HEIGHTS_M, PERIODS_S, WaveError, between};

/// Wind sea and swell of the Norwegian Sea from the height and period of the total sea: Torsethaugen & Haver,
/// "Simplified double peak spectral model for ocean waves", *Proc. 14th ISOPE* (2004), paper 2004-JSC-193;
/// DNV-RP-C205, sec. 3.5 and app. A. With T_f = 6.6 Hs^(1/3), the peak belongs to the wind sea if Tp <= T_f,
/// otherwise to the swell. Each system is S(w) = (Hs_j^2 / 16 w_pj) G A x^-4 exp(-x^-4) gamma_j^exp(-(x -
/// 1)^2 / (2 sigma^2)) with x = w / w_pj and gamma = 1 for the secondary system. The source gives G = 3.26
/// and a fit for A; here both are computed by integration over all frequencies, so that m0 = Hs^2 / 16.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Torsethaugen {
    primary: TorsethaugenPart,
    secondary: TorsethaugenPart,
}

/// One of the two wave systems.
#[derive(Clone, Copy, Debug, PartialEq)]
struct TorsethaugenPart {
    peak_rad_s: f64,
    gamma: f64,
    /// Hs_j^2 G A / 16 w_pj, m^2 s/rad.
    scale: f64,
}

impl Torsethaugen {
    /// Creates the spectrum for this significant wave height and peak period of the total sea.
    ///
    /// # Errors
    /// A height outside 1e-6 to 100 m, a period outside 0.01 to 1000 s, a sea outside the model's range of
    /// steepness and length: Tp not above 2 sqrt(Hs) or not below 25 s.
    pub fn new(significant_height_m: f64, peak_period_s: f64, gravity_m_s2: f64) -> Result<Self, WaveError> {
        let (height, period) = (significant_height_m, peak_period_s);
        between("significant_height_m", height, HEIGHTS_M)?;
        between("peak_period_s", period, PERIODS_S)?;
        let shortest = 2.0 * libm::sqrt(height);
        let fully_developed = 6.6 * libm::cbrt(height);
        if period <= shortest || period >= 25.0 || fully_developed >= 25.0 {
            let allowed = format!("above {shortest:.3} s, which is 2 sqrt(Hs), and below 25 s, with Hs below 54 m");
            return Err(WaveError::new("peak_period_s", period, allowed));
        }
        let steepness = |height: f64, period: f64| TAU / gravity_m_s2 * height / (period * period);
        let sharpness = |steepness: f64| 35.0 * libm::pow(steepness, 6.0 / 7.0);
        if period <= fully_developed {
            let distance = (fully_developed - period) / (fully_developed - shortest);
            let share = 0.7 + 0.3 * libm::exp(-(2.0 * distance) * (2.0 * distance));
            let (wind, swell) = shared(height, share);
            let primary = TorsethaugenPart::new(wind, period, sharpness(steepness(wind, period)));
            let secondary = TorsethaugenPart::new(swell, fully_developed + 2.0, 1.0);
            return Ok(Self { primary, secondary });
        }
        let distance = (period - fully_developed) / (25.0 - fully_developed);
        let share = 0.6 + 0.4 * libm::exp(-(distance / 0.3) * (distance / 0.3));
        let (swell, wind) = shared(height, share);
        let gamma = sharpness(steepness(height, fully_developed)) * (1.0 + 6.0 * distance);
        let primary = TorsethaugenPart::new(swell, period, gamma);
        let secondary = TorsethaugenPart::new(wind, 6.6 * libm::cbrt(wind), 1.0);
        Ok(Self { primary, secondary })
    }

    /// S(w), m^2 s/rad.
    pub fn density_m2_s(&self, angular_frequency_rad_s: f64) -> f64 {
        self.primary.density_m2_s(angular_frequency_rad_s) + self.secondary.density_m2_s(angular_frequency_rad_s)
    }

    /// Returns the angular frequencies of the two peaks, rad/s, increasing; only that of the primary system
    /// if the secondary system has no energy.
    pub fn peaks_rad_s(&self) -> Vec<f64> {
        let mut peaks = vec![self.primary.peak_rad_s];
        if self.secondary.scale > 0.0 {
            peaks.push(self.secondary.peak_rad_s);
        }
        peaks.sort_by(f64::total_cmp);
        peaks
    }
}

/// Returns the heights of two systems with this total height; the first has this share of the total.
fn shared(height: f64, share: f64) -> (f64, f64) {
    (share * height, height * libm::sqrt((1.0 - share * share).max(0.0)))
}

impl TorsethaugenPart {
    /// Creates a system with this height, peak period and peak enhancement factor. A gamma below 1, which the
    /// formulas give for seas of low steepness, counts as 1.
    fn new(height_m: f64, peak_period_s: f64, gamma: f64) -> Self {
        let gamma = gamma.max(1.0);
        if height_m <= 0.0 {
            return Self { peak_rad_s: TAU, gamma: 1.0, scale: 0.0 };
        }
        let all = Band { lowest_rad_s: 0.1, highest_rad_s: 1e4 };
        let shape = integral(&[1.0], all, |x| gamma_shape(x, 4.0, 4.0) * peak_enhancement(x, gamma));
        let peak_rad_s = 2.0 * PI / peak_period_s;
        Self { peak_rad_s, gamma, scale: height_m * height_m / (16.0 * shape * peak_rad_s) }
    }

    fn density_m2_s(&self, angular_frequency_rad_s: f64) -> f64 {
        let x = angular_frequency_rad_s / self.peak_rad_s;
        self.scale * gamma_shape(x, 4.0, 4.0) * peak_enhancement(x, self.gamma)
    }
}
