//! The JONSWAP spectrum.

use core::f64::consts::TAU;

use super::{Band, gamma_shape, integral, jonswap_shape, peak_enhancement};
use crate::sea::waves::error::{HEIGHTS_M, PERIODS_S, WaveError, between};

/// S(w) = A Hs^2 w_p^4 w^-5 exp(-(5/4) (w / w_p)^-4) gamma^exp(-(w / w_p - 1)^2 / (2 sigma^2)), sigma 0.07 up
/// to the peak and 0.09 above it: Hasselmann et al. (1973) by height and period, DNV-RP-C205, sec. 3.5. A is
/// computed by integration over all frequencies, so that m0 = Hs^2 / 16 holds to 1e-8; the usual formula 5/16
/// (1 - 0.287 ln gamma) has an error of up to a percent. With gamma = 1 it is the Pierson-Moskowitz spectrum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jonswap {
    peak_rad_s: f64,
    gamma: f64,
    /// A Hs^2 / w_p, m^2 s/rad.
    scale: f64,
}

impl Jonswap {
    /// Creates the spectrum with this significant wave height, peak period and peak enhancement factor gamma.
    ///
    /// # Errors
    /// A height outside 1e-6 to 100 m, a period outside 0.01 to 1000 s, a gamma outside 1 to 20.
    pub fn new(significant_height_m: f64, peak_period_s: f64, gamma: f64) -> Result<Self, WaveError> {
        between("significant_height_m", significant_height_m, HEIGHTS_M)?;
        between("peak_period_s", peak_period_s, PERIODS_S)?;
        between("gamma", gamma, [1.0, 20.0])?;
        let peak_rad_s = TAU / peak_period_s;
        let all = Band { lowest_rad_s: 0.1, highest_rad_s: 1e4 };
        let shape = integral(&[1.0], all, |x| jonswap_shape(x, gamma));
        let variance = significant_height_m * significant_height_m / 16.0;
        Ok(Self { peak_rad_s, gamma, scale: variance / (shape * peak_rad_s) })
    }

    /// S(w), m^2 s/rad.
    pub fn density_m2_s(&self, angular_frequency_rad_s: f64) -> f64 {
        let x = angular_frequency_rad_s / self.peak_rad_s;
        self.scale * gamma_shape(x, 5.0, 4.0) * peak_enhancement(x, self.gamma)
    }

    /// Angular frequency of the peak, rad/s.
    pub fn peak_rad_s(&self) -> f64 {
        self.peak_rad_s
    }
}
