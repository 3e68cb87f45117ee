//! The six-parameter spectrum of Ochi and Hubble.

use core::f64::consts::TAU;

use super::gamma_shape;
use crate::sea::waves::error::{HEIGHTS_M, PERIODS_S, WaveError, between};

/// One of the two parts, with its height, period and shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OchiHubblePart {
    /// Significant wave height of the part, m.
    pub significant_height_m: f64,
    /// Peak period of the part, s.
    pub peak_period_s: f64,
    /// Shape parameter lambda; 1 gives the Pierson-Moskowitz spectrum, a larger value a narrower one.
    pub shape: f64,
}

/// S(w) = (1/4) sum over the parts of ((lambda + 1/4) w_p^4)^lambda / Gamma(lambda) Hs^2 w^-(4 lambda + 1)
/// exp(-(lambda + 1/4) (w / w_p)^-4): Ochi & Hubble, "Six-parameter wave spectra", *Proc. 15th Coastal
/// Engineering Conference* (1976), p. 301. Swell and wind sea in one direction. m0 is exactly the sum
/// of the parts' Hs^2 / 16.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OchiHubble {
    /// The parts, in order of increasing peak frequency.
    parts: [OchiHubblePart; 2],
    /// Factor of the shape of each part, m^2 s/rad.
    scales: [f64; 2],
}

impl OchiHubble {
    /// Creates the spectrum of two parts.
    ///
    /// # Errors
    /// A height outside 1e-6 to 100 m, a period outside 0.01 to 1000 s, a shape outside 0.5 to 20.
    pub fn new(parts: [OchiHubblePart; 2]) -> Result<Self, WaveError> {
        for part in parts {
            between("significant_height_m", part.significant_height_m, HEIGHTS_M)?;
            between("peak_period_s", part.peak_period_s, PERIODS_S)?;
            between("shape", part.shape, [0.5, 20.0])?;
        }
        let [a, b] = parts;
        let parts = if a.peak_period_s >= b.peak_period_s { [a, b] } else { [b, a] };
        Ok(Self { parts, scales: parts.map(scale) })
    }

    /// S(w), m^2 s/rad.
    pub fn density_m2_s(&self, angular_frequency_rad_s: f64) -> f64 {
        let of_part = |(part, scale): (&OchiHubblePart, f64)| {
            let x = angular_frequency_rad_s * part.peak_period_s / TAU;
            scale * gamma_shape(x, 4.0 * part.shape + 1.0, 4.0)
        };
        self.parts.iter().zip(self.scales).map(of_part).sum()
    }

    /// Returns the peak frequencies of the parts, rad/s, increasing.
    pub fn peaks_rad_s(&self) -> [f64; 2] {
        self.parts.map(|part| TAU / part.peak_period_s)
    }
}

/// Returns (1/4) Hs^2 (lambda + 1/4)^lambda / (Gamma(lambda) w_p).
fn scale(part: OchiHubblePart) -> f64 {
    let OchiHubblePart { significant_height_m: height, peak_period_s, shape } = part;
    let gamma_part = libm::exp(shape * libm::log(shape + 0.25) - libm::lgamma(shape));
    0.25 * height * height * gamma_part * peak_period_s / TAU
}
