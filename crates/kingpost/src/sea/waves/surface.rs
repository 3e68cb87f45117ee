//! Surface of the sea on a grid.

use super::field::WaveField;
use crate::scalar::Scalar;

impl<S: Scalar> WaveField<S> {
    /// Returns the elevation of the surface, m, at every grid point of x and y, world, m: first all points of
    /// the first x.
    ///
    /// On a grid `e^(i (kx x + ky y - w t))` is a product of one factor along x and one along y, so the
    /// number of sines is that of grid lines, not of grid points. The result equals [`Self::elevation_m`] at
    /// each grid point except for rounding.
    pub fn elevations_m(&self, x: &[S], y: &[S], time_s: f64) -> Vec<S> {
        let mut elevations = vec![S::ZERO; x.len() * y.len()];
        let along_y: Vec<Vec<(S, S)>> = self
            .components()
            .map(|wave| {
                let wave_number = wave.wave_number_per_m * wave.direction_rad.sin_cos().0;
                y.iter().map(|y| (wave_number * *y).sin_cos()).collect()
            })
            .collect();
        let (mut real, mut imaginary) = (vec![S::ZERO; self.len()], vec![S::ZERO; self.len()]);
        for (line, x) in elevations.chunks_exact_mut(y.len().max(1)).zip(x) {
            self.phasors([*x, S::ZERO], time_s, &mut real, &mut imaginary);
            for ((real, imaginary), along_y) in real.iter().zip(&imaginary).zip(&along_y) {
                for (elevation, (sin, cos)) in line.iter_mut().zip(along_y) {
                    *elevation += *real * *cos - *imaginary * *sin;
                }
            }
        }
        elevations
    }
}
