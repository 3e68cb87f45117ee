//! Mean drift, interpolated between the frequencies of a database.

use super::Database;

impl Database {
    /// Returns the mean drift at a frequency, interpolated linearly: surge and sway force and yaw moment per
    /// amplitude squared, by direction; `None` if the data have no mean drift.
    pub fn mean_drift(&self, omega_rad_s: f64) -> Vec<[f64; 3]> {
        let Some(drift) = &self.mean_drift else { return Vec::new() };
        self.between(omega_rad_s, |k, direction| drift[k][direction])
    }

    /// Returns the derivative of the mean drift with respect to frequency, per rad/s: that of the parabola
    /// through three points of the grid, and linear between the points; `None` if the data have no mean
    /// drift.
    pub fn mean_drift_slope(&self, omega_rad_s: f64) -> Vec<[f64; 3]> {
        let Some(drift) = &self.mean_drift else { return Vec::new() };
        let grid = &self.frequencies_rad_s;
        let last = grid.len() - 1;
        let of_line = |k: usize, direction: usize| -> [f64; 3] {
            let (from, to) = (drift[k][direction], drift[k + 1][direction]);
            core::array::from_fn(|mode| (to[mode] - from[mode]) / (grid[k + 1] - grid[k]))
        };
        let at = |k: usize, direction: usize| {
            let middle = k.clamp(1, (last - 1).max(1));
            if last < 2 {
                return of_line(0, direction);
            }
            let (left, right) = (of_line(middle - 1, direction), of_line(middle, direction));
            let (a, b) = (grid[middle] - grid[middle - 1], grid[middle + 1] - grid[middle]);
            let away = grid[k] - grid[middle];
            let slope = |mode: usize| (left[mode] * b + right[mode] * a) / (a + b);
            let bend = |mode: usize| 2.0 * (right[mode] - left[mode]) / (a + b);
            core::array::from_fn(|mode| slope(mode) + away * bend(mode))
        };
        self.between(omega_rad_s, at)
    }

    fn between(&self, omega_rad_s: f64, at: impl Fn(usize, usize) -> [f64; 3]) -> Vec<[f64; 3]> {
        let (below, share) = self.bracket(omega_rad_s);
        let of = |direction: usize| {
            let (a, b) = (at(below, direction), at(below + 1, direction));
            core::array::from_fn(|mode| a[mode] + share * (b[mode] - a[mode]))
        };
        (0..self.wave_directions_rad.len()).map(of).collect()
    }
}
