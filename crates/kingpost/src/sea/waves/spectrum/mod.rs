//! Wave spectra: spectral density S(w) of the elevation over angular frequency, one file for each spectrum.

mod jonswap;
mod ochi_hubble;
mod pierson_moskowitz;
mod quadrature;
mod table;
mod torsethaugen;

pub use jonswap::Jonswap;
pub use ochi_hubble::{OchiHubble, OchiHubblePart};
pub use pierson_moskowitz::PiersonMoskowitz;
pub(crate) use quadrature::{integral, sub_intervals};
pub use table::SpectrumTable;
pub use torsethaugen::Torsethaugen;

/// A range of angular frequencies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    /// Lowest, rad/s.
    pub lowest_rad_s: f64,
    /// Highest, rad/s.
    pub highest_rad_s: f64,
}

/// A one-sided spectrum of the surface elevation, m^2 s/rad, whose integral over all frequencies is
/// the variance m0 = Hs^2 / 16.
///
/// ```
/// use kingpost::sea::waves::{Jonswap, Spectrum};
/// let spectrum = Spectrum::Jonswap(Jonswap::new(2.5, 8.0, 3.3)?);
/// assert!((spectrum.significant_height_m() - 2.5).abs() < 1e-6);
/// # Ok::<(), kingpost::sea::waves::WaveError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Spectrum {
    /// Pierson-Moskowitz, for a fully developed wind sea.
    PiersonMoskowitz(PiersonMoskowitz),
    /// JONSWAP, for a growing wind sea.
    Jonswap(Jonswap),
    /// Ochi-Hubble: two peaks with three parameters each.
    OchiHubble(OchiHubble),
    /// Torsethaugen: wind sea and swell of the Norwegian Sea, from the height and period of the total sea.
    Torsethaugen(Torsethaugen),
    /// A table of S(w).
    Table(SpectrumTable),
}

impl Spectrum {
    /// Returns S(w), m^2 s/rad; 0 unless w > 0.
    pub fn density_m2_s(&self, angular_frequency_rad_s: f64) -> f64 {
        let w = angular_frequency_rad_s;
        match self {
            Self::PiersonMoskowitz(spectrum) => spectrum.density_m2_s(w),
            Self::Jonswap(spectrum) => spectrum.density_m2_s(w),
            Self::OchiHubble(spectrum) => spectrum.density_m2_s(w),
            Self::Torsethaugen(spectrum) => spectrum.density_m2_s(w),
            Self::Table(spectrum) => spectrum.density_m2_s(w),
        }
    }

    /// Returns the angular frequencies where the formula changes its form, rad/s, increasing: the peaks, or
    /// the rows of a table.
    pub(crate) fn nodes_rad_s(&self) -> Vec<f64> {
        match self {
            Self::PiersonMoskowitz(spectrum) => vec![spectrum.peak_rad_s()],
            Self::Jonswap(spectrum) => vec![spectrum.peak_rad_s()],
            Self::OchiHubble(spectrum) => spectrum.peaks_rad_s().to_vec(),
            Self::Torsethaugen(spectrum) => spectrum.peaks_rad_s().to_vec(),
            Self::Table(spectrum) => spectrum.frequencies_rad_s().to_vec(),
        }
    }

    /// Returns the range in which the spectrum has energy: the rows of a table; otherwise from 0.1 times the
    /// lowest peak frequency, below which the density is less than exp(-(5/4) 10^4), to 10^4 times the
    /// highest.
    pub fn whole_band(&self) -> Band {
        let nodes = self.nodes_rad_s();
        let (first, last) = (nodes[0], nodes[nodes.len() - 1]);
        match self {
            Self::Table(_) => Band { lowest_rad_s: first, highest_rad_s: last },
            _ => Band { lowest_rad_s: 0.1 * first, highest_rad_s: 1e4 * last },
        }
    }

    /// Returns the default band of a sea: the rows of a table; otherwise from half the lowest peak frequency
    /// to five times the highest. The tail that is cut off a Pierson-Moskowitz spectrum contains 0.2 % of its
    /// energy, 1 - exp(-(5/4) / 5^4).
    pub fn usual_band(&self) -> Band {
        let nodes = self.nodes_rad_s();
        let (first, last) = (nodes[0], nodes[nodes.len() - 1]);
        match self {
            Self::Table(_) => Band { lowest_rad_s: first, highest_rad_s: last },
            _ => Band { lowest_rad_s: 0.5 * first, highest_rad_s: 5.0 * last },
        }
    }

    /// Returns the spectral moment of this order, m_n = integral of w^n S(w) dw over the band, m^2 (rad/s)^n.
    /// Over all frequencies it is finite for orders below the power of the tail less one: below 4, for
    /// Torsethaugen's spectrum below 3.
    pub fn moment(&self, order: i32, band: Band) -> f64 {
        integral(&self.nodes_rad_s(), band, |w| power(w, order) * self.density_m2_s(w))
    }

    /// Returns the significant wave height, m: 4 sqrt(m0) of the whole spectrum.
    pub fn significant_height_m(&self) -> f64 {
        4.0 * libm::sqrt(self.moment(0, self.whole_band()))
    }

    /// Returns the mean zero-up-crossing period, s: Tz = 2 pi sqrt(m0 / m2) over the band (Rice 1945;
    /// DNV-RP-C205, sec. 3.5).
    pub fn zero_crossing_period_s(&self, band: Band) -> f64 {
        core::f64::consts::TAU * libm::sqrt(self.moment(0, band) / self.moment(2, band))
    }
}

fn power(base: f64, order: i32) -> f64 {
    libm::pow(base, f64::from(order))
}

/// Returns the shape of the JONSWAP spectrum, x^-5 exp(-5/4 x^-4) times the peak enhancement factor, with x = w / w_p.
pub(crate) fn jonswap_shape(x: f64, gamma: f64) -> f64 {
    gamma_shape(x, 5.0, 4.0) * peak_enhancement(x, gamma)
}

/// Returns x^-n exp(-(n/m) x^-m) with x = w / w_p; 0 unless x > 0.
pub(crate) fn gamma_shape(x: f64, n: f64, m: f64) -> f64 {
    if x > 0.0 { libm::exp(-n * libm::log(x) - n / m * libm::pow(x, -m)) } else { 0.0 }
}

/// Returns the peak enhancement factor gamma^exp(-(x - 1)^2 / (2 sigma^2)), with sigma 0.07 below the peak
/// and 0.09 above it (Hasselmann et al., *Measurements of wind-wave growth and swell decay during JONSWAP*,
/// 1973).
pub(crate) fn peak_enhancement(x: f64, gamma: f64) -> f64 {
    let sigma = if x <= 1.0 { 0.07 } else { 0.09 };
    let distance = (x - 1.0) / sigma;
    libm::exp(libm::log(gamma) * libm::exp(-0.5 * distance * distance))
}
