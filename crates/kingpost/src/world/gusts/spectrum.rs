//! Gust spectra: spectral density of the wind speed over frequency.

use crate::scalar::Scalar;

/// One-sided spectrum S(f) of the speed along the mean wind, m^2/s^2 per Hz; U(z) is the mean speed at the
/// height z, and U_10 the mean speed at 10 m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum GustSpectrum<S = f64> {
    /// The spectrum of the Norwegian Petroleum Directorate, from wind measured off Froya (ISO 19901-1:2015, A.7.4; API
    /// RP 2MET), for the mean over one hour,
    ///
    /// ```text
    /// S = 320 (U_10 / 10)^2 (z / 10)^0.45 / (1 + x^n)^(5 / (3 n)),   x = 172 f (z / 10)^(2/3) (U_10 / 10)^(-3/4),   n = 0.468
    /// ```
    Npd,
    /// The spectrum of API RP 2A-WSD, 21st ed., 2.3.2: sigma = U(z) I with I = 0.15 (z / 20)^-0.125 up to 20 m and 0.15
    /// (z / 20)^-0.275 above, and `S = sigma^2 / f_p / (1 + 1.5 f / f_p)^(5/3)`, `f_p = c U(z) / z`.
    Api {
        /// c, from 0.01 to 0.10, on average 0.025.
        peak_coefficient: S,
    },
    /// Kaimal's spectrum in the form of IEC 61400-1, annex B: sigma = I U(z), `S = 4 sigma^2 (L / U) / (1 + 6 f L /
    /// U)^(5/3)`, which is API's formula with `f_p = U / (4 L)`.
    Kaimal {
        /// I: ratio of sigma to the mean speed.
        turbulence_intensity: S,
        /// Length scale L, m.
        length_scale: S,
    },
}

/// Mean wind for which a spectrum is evaluated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeanWind<S = f64> {
    /// Height z, m.
    pub height: S,
    /// Mean speed U(z) at this height, m/s.
    pub speed: S,
    /// Mean speed U_10 at 10 m, m/s.
    pub at_ten_metres: S,
}

/// Mean speed below which gusts are proportional to it, m/s.
const LEAST_M_S: f64 = 1e-6;
/// Exponent n of the NPD spectrum.
const N: f64 = 0.468;
/// Points and weights of the Gauss-Legendre rule on (-1, 1) (Abramowitz & Stegun, table 25.4, n = 4).
const RULE: [(f64, f64); 4] = [
    (-0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
    (-0.339_981_043_584_856_3, 0.652_145_154_862_546_1),
    (0.339_981_043_584_856_3, 0.652_145_154_862_546_1),
    (0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
];

impl<S: Scalar> GustSpectrum<S> {
    /// Returns S(f), m^2/s.
    pub fn density(&self, mean: &MeanWind<S>, frequency_hz: f64) -> S {
        let scale = self.scale(mean);
        scale * scale * self.shape(mean, frequency_hz)
    }

    /// Returns the standard deviation of the speed between two frequencies above 0, Hz, from the integral of
    /// f S over ln f, m/s.
    pub fn deviation(&self, mean: &MeanWind<S>, [lowest, highest]: [f64; 2]) -> S {
        let (from, to) = (libm::log(lowest), libm::log(highest));
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let at = |(point, weight): &(f64, f64)| {
            let frequency = libm::exp(middle + half * point);
            self.shape(mean, frequency) * S::constant(weight * half * frequency)
        };
        self.scale(mean) * RULE.iter().map(at).fold(S::ZERO, |sum, part| sum + part).sqrt()
    }

    /// Returns the scale of the speed, m/s, to the square of which S is proportional; 0 without wind.
    fn scale(&self, mean: &MeanWind<S>) -> S {
        match self {
            Self::Npd => mean.at_ten_metres,
            Self::Api { .. } => mean.speed * api_intensity(mean.height),
            Self::Kaimal { turbulence_intensity, .. } => mean.speed * *turbulence_intensity,
        }
    }

    /// Returns S divided by the square of the scale, 1/Hz.
    fn shape(&self, mean: &MeanWind<S>, frequency_hz: f64) -> S {
        let (c, f) = (S::constant, S::constant(frequency_hz));
        let speed = at_least(mean.speed);
        match self {
            Self::Npd => {
                let (z, u) = (mean.height / c(10.0), at_least(mean.at_ten_metres) / c(10.0));
                let x = c(172.0) * f * z.pow(c(2.0 / 3.0)) * u.pow(c(-0.75));
                c(3.2) * z.pow(c(0.45)) * (S::ONE + x.pow(c(N))).pow(c(-5.0 / (3.0 * N)))
            }
            Self::Api { peak_coefficient } => five_thirds(f, *peak_coefficient * speed / mean.height),
            Self::Kaimal { length_scale, .. } => five_thirds(f, speed / (c(4.0) * *length_scale)),
        }
    }
}

/// Returns the turbulence intensity of API RP 2A at a height, m.
fn api_intensity<S: Scalar>(height: S) -> S {
    let (c, ratio) = (S::constant, height / S::constant(20.0));
    let exponent = ratio.select_below(1.0, || c(-0.125), || c(-0.275));
    c(0.15) * ratio.pow(exponent)
}

/// Returns 1 / f_p / (1 + 1.5 f / f_p)^(5/3), whose integral over all frequencies is 1.
fn five_thirds<S: Scalar>(frequency: S, peak: S) -> S {
    let base = S::ONE + S::constant(1.5) * frequency / peak;
    base.pow(S::constant(-5.0 / 3.0)) / peak
}

fn at_least<S: Scalar>(speed: S) -> S {
    let least = S::constant(LEAST_M_S);
    speed.select_below(LEAST_M_S, || least, || speed)
}
