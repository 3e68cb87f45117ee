//! The Pierson-Moskowitz spectrum by height and period.

use core::f64::consts::TAU;

use super::gamma_shape;
use crate::sea::waves::error::{HEIGHTS_M, PERIODS_S, WaveError, between};

/// S(w) = (5/16) Hs^2 w_p^4 w^-5 exp(-(5/4) (w / w_p)^-4): Pierson & Moskowitz (1964) in the form of
/// DNV-RP-C205, sec. 3.5, also known as the Bretschneider, the modified Pierson-Moskowitz or the ISSC
/// spectrum. m0 = Hs^2 / 16 exactly, Tz = 0.710 Tp.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PiersonMoskowitz {
    significant_height_m: f64,
    peak_rad_s: f64,
}

impl PiersonMoskowitz {
    /// Creates the spectrum with this significant wave height and peak period.
    ///
    /// # Errors
    /// A height outside 1e-6 to 100 m, a period outside 0.01 to 1000 s.
    pub fn new(significant_height_m: f64, peak_period_s: f64) -> Result<Self, WaveError> {
        between("significant_height_m", significant_height_m, HEIGHTS_M)?;
        between("peak_period_s", peak_period_s, PERIODS_S)?;
        Ok(Self { significant_height_m, peak_rad_s: TAU / peak_period_s })
    }

    /// S(w), m^2 s/rad.
    pub fn density_m2_s(&self, angular_frequency_rad_s: f64) -> f64 {
        let height = self.significant_height_m;
        let scale = 5.0 / 16.0 * height * height / self.peak_rad_s;
        scale * gamma_shape(angular_frequency_rad_s / self.peak_rad_s, 5.0, 4.0)
    }

    /// Angular frequency of the peak, rad/s.
    pub fn peak_rad_s(&self) -> f64 {
        self.peak_rad_s
    }
}
