//! Breaking limits of waves.

use super::dispersion::wave_number;
use super::error::WaveError;
use super::water::Water;
use core::f64::consts::TAU;

/// Steepness H / L at which a wave breaks in deep water (Michell 1893).
const STEEPEST: f64 = 0.142;

/// The height, m, at which a wave of this period breaks: 0.142 L tanh(k h) (Miche 1944; DNV-RP-C205, 3.4.6).
///
/// ```
/// use kingpost::sea::waves::{Water, breaking_height_m};
/// let deep = Water::default();
/// assert!((breaking_height_m(8.0, &deep) - 0.142 * 9.80665 / std::f64::consts::TAU * 64.0).abs() < 1e-12);
/// let shallow = Water { depth_m: Some(2.0), ..deep };
/// assert!((breaking_height_m(60.0, &shallow) / 2.0 - 0.89).abs() < 0.01); // 0.142 * 2 pi of the depth
/// ```
pub fn breaking_height_m(period_s: f64, water: &Water) -> f64 {
    let k = wave_number(TAU / period_s, water);
    STEEPEST * TAU / k * water.depth_m.map_or(1.0, |depth_m| libm::tanh(k * depth_m))
}

/// Returns an error if waves of this height would break; `field` is the name of the height's field.
pub(crate) fn unbroken(field: &str, height_m: f64, period_s: f64, water: &Water) -> Result<(), WaveError> {
    let most = breaking_height_m(period_s, water);
    if height_m <= most {
        return Ok(());
    }
    Err(WaveError::new(field, height_m, format!("at most {most:.2} m, at which waves of {period_s} s break")))
}
