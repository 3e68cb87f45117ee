//! Coefficients that depend on where the waves go against the hull, at any heading.

use crate::scalar::Scalar;
use core::f64::consts::TAU;

/// Numbers given on a regular grid of directions, as trigonometric polynomials: the interpolation
/// that is exact for what has no more harmonics than half the grid's points. A ship's transfer
/// functions have about `k L / 2` of them.
///
/// Row by row, a number f(beta - psi) at a component's own direction beta is kept as the weights of
/// 1, cos psi, sin psi, cos 2 psi, ..., so that all rows share the powers of one heading psi.
#[derive(Clone)]
pub struct ByHeading<S = f64> {
    harmonics: usize,
    weights: Vec<f64>,
    heading: Option<S>,
    basis: Vec<S>,
    values: Vec<S>,
}

impl<S: Scalar> ByHeading<S> {
    /// No rows, on a grid of so many directions.
    pub fn new(directions: usize) -> Self {
        let harmonics = directions / 2;
        let basis = vec![S::ONE; 2 * harmonics + 1];
        Self { harmonics, weights: Vec::new(), heading: None, basis, values: Vec::new() }
    }

    /// Appends a row: f on the grid, for waves that go to `direction_rad` in the world.
    pub fn push(&mut self, direction_rad: f64, on_grid: &[f64]) {
        let n = on_grid.len() as f64;
        for m in 0..=self.harmonics {
            let (mut cosine, mut sine) = (0.0, 0.0);
            for (k, f) in on_grid.iter().enumerate() {
                let (sin, cos) = libm::sincos(TAU * ((m * k) % on_grid.len()) as f64 / n);
                cosine += f * cos;
                sine += f * sin;
            }
            // The highest harmonic of an even grid is its own mirror image.
            let whole = if m == 0 || 2 * m == on_grid.len() { 1.0 } else { 2.0 } / n;
            let (sin, cos) = libm::sincos(m as f64 * direction_rad);
            self.weights.push(whole * (cosine * cos + sine * sin));
            if m > 0 {
                self.weights.push(whole * (cosine * sin - sine * cos));
            }
        }
        self.values.push(S::ZERO);
    }

    /// All rows at a heading, rad.
    pub fn at(&mut self, heading: S) -> &[S] {
        if self.heading != Some(heading) {
            self.turn_to(heading);
        }
        &self.values
    }

    fn turn_to(&mut self, heading: S) {
        let (sin, cos) = heading.sin_cos();
        let mut power = [S::ONE, S::ZERO];
        for pair in self.basis[1..].chunks_exact_mut(2) {
            power = [power[0] * cos - power[1] * sin, power[0] * sin + power[1] * cos];
            pair.copy_from_slice(&power);
        }
        for (value, weights) in self.values.iter_mut().zip(self.weights.chunks_exact(self.basis.len())) {
            *value = dot(weights, &self.basis);
        }
        self.heading = Some(heading);
    }
}

/// A sum in one order, in four strands that a processor can add side by side.
fn dot<S: Scalar>(weights: &[f64], basis: &[S]) -> S {
    let mut strands = [S::ZERO; 4];
    let (weights, basis) = (weights.chunks_exact(4), basis.chunks_exact(4));
    let rest = weights.remainder().iter().zip(basis.remainder());
    let rest = rest.fold(S::ZERO, |sum, (w, b)| sum + S::constant(*w) * *b);
    for (w, b) in weights.zip(basis) {
        for k in 0..4 {
            strands[k] += S::constant(w[k]) * b[k];
        }
    }
    (strands[0] + strands[1]) + (strands[2] + strands[3]) + rest
}

/// The weights are many: a hash stands for them.
impl<S: core::fmt::Debug> core::fmt::Debug for ByHeading<S> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let hash = self.weights.iter().fold(0_u64, |hash, w| (hash ^ w.to_bits()).wrapping_mul(0x0100_0000_01b3));
        f.debug_struct("ByHeading").field("harmonics", &self.harmonics).field("hash", &hash).finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const DIRECTIONS: usize = 24;

    fn f(beta: f64) -> f64 {
        1.5 + libm::cos(beta) - 0.25 * libm::sin(3.0 * beta) + 0.125 * libm::cos(11.0 * beta)
    }

    fn table(direction: f64) -> ByHeading {
        let grid: Vec<f64> = (0..DIRECTIONS).map(|k| f(TAU * k as f64 / DIRECTIONS as f64)).collect();
        let mut table = ByHeading::new(DIRECTIONS);
        table.push(direction, &grid);
        table
    }

    #[test]
    fn what_has_few_harmonics_is_met_between_the_points_of_the_grid() {
        for (direction, heading) in [(0.0, 0.0), (2.1, 0.3), (-1.0, 4.0), (3.0, -7.5)] {
            let found = table(direction).at(heading)[0];
            assert!((found - f(direction - heading)).abs() < 1e-13, "{direction} {heading}: {found}");
        }
    }

    #[test]
    fn a_table_on_any_grid_goes_through_its_points() {
        for n in [4_usize, 5, 8, 9] {
            let grid: Vec<f64> = (0..n).map(|k| libm::sin(1.0 + (k * k) as f64)).collect();
            let mut table = ByHeading::<f64>::new(n);
            table.push(0.0, &grid);
            for (k, expected) in grid.iter().enumerate() {
                let found = table.at(-TAU * k as f64 / n as f64)[0];
                assert!((found - expected).abs() < 1e-13, "{n} {k}: {found} {expected}");
            }
        }
    }
}
