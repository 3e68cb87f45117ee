//! Change of the wave drift with the velocity of a hull, by Aranha's formula.

use crate::sea::database::Database;
use core::f64::consts::PI;

/// Numbers per wave: for surge and sway, per velocity along x and y, through the water and over ground.
pub const RATES: usize = 8;

/// Returns the change of the drift coefficients D of surge and sway per velocity along the hull's x and y, by direction
/// of a database; in deep water
///
/// ```text
/// D(V) = (1 - 4 (w / g) V.e) D(w - k Vg.e, b + 2 (w / g) (V x e))
/// ```
///
/// with e along the wave, V the velocity of the hull through the water and Vg that over ground, to first order in them
/// (Aranha, *J. Fluid Mech.* 272, 1994, p. 147, and 313, 1996, p. 39). The frequency w of a wave is that at a fixed
/// point, so a hull at rest over ground in a current encounters it unchanged: only Vg shifts the frequency. The formula
/// does not change the yaw moment.
///
/// The index is `4 mode + 2 reference + axis`: mode is surge (0) or sway (1), reference is through the water (0) or
/// over ground (1).
pub fn rates(database: &Database, omega: f64, wave_number: f64) -> Vec<[f64; RATES]> {
    let (drift, slopes) = (database.mean_drift(omega), database.mean_drift_slope(omega));
    let by_gravity = omega / database.water.gravity_m_s2;
    let turned: [Vec<f64>; 2] = core::array::from_fn(|mode| {
        let on_grid: Vec<f64> = drift.iter().map(|d| d[mode]).collect();
        derivative(&on_grid)
    });
    let at = |(i, direction): (usize, &f64)| {
        let (sin, cos) = libm::sincos(*direction);
        core::array::from_fn(|place| {
            let (mode, over_ground, axis) = (place / 4, place / 2 % 2 == 1, place % 2);
            let (along, aside) = if axis == 0 { (cos, sin) } else { (sin, -cos) };
            match over_ground {
                false => by_gravity * (2.0 * turned[mode][i] * aside - 4.0 * drift[i][mode] * along),
                true => -wave_number * slopes[i][mode] * along,
            }
        })
    };
    database.wave_directions_rad.iter().enumerate().map(at).collect()
}

/// Returns the derivative, at the grid points, of the trigonometric polynomial through values on a regular grid of the
/// circle (Trefethen, *Spectral Methods in MATLAB*, 2000, ch. 3).
fn derivative(on_grid: &[f64]) -> Vec<f64> {
    let n = on_grid.len();
    let weight = |apart: usize| {
        let (sin, cos) = libm::sincos(PI * apart as f64 / n as f64);
        let sign = if apart.is_multiple_of(2) { 0.5 } else { -0.5 };
        sign * if n.is_multiple_of(2) { cos } else { 1.0 } / sin
    };
    let weights: Vec<f64> = (1..n).map(weight).collect();
    (0..n).map(|i| (1..n).map(|apart| weights[apart - 1] * on_grid[(i + n - apart) % n]).sum()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::TAU;

    /// Exact for a polynomial with at most half as many harmonics as grid points, on even and odd grids.
    #[test]
    fn the_derivative_of_a_trigonometric_polynomial_is_exact_on_the_grid() {
        for n in [24_usize, 25] {
            let grid: Vec<f64> = (0..n).map(|i| TAU * i as f64 / n as f64).collect();
            let on_grid: Vec<f64> = grid.iter().map(|b| 2.0 + libm::cos(3.0 * b) - 0.5 * libm::sin(*b)).collect();
            for (b, found) in grid.iter().zip(derivative(&on_grid)) {
                let expected = -3.0 * libm::sin(3.0 * b) - 0.5 * libm::cos(*b);
                assert!((found - expected).abs() < 1e-12, "{n}: {found} {expected}");
            }
        }
    }
}
