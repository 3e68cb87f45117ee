//! A small linear system, solved in place.

use crate::scalar::Scalar;

/// `A = P L U` by Gaussian elimination with row pivots (Golub & Van Loan, *Matrix Computations*,
/// 4th ed., 2013, section 3.4), in memory that is allocated once.
#[derive(Clone, Debug)]
pub(super) struct Factors<S> {
    size: usize,
    /// A by columns; after [`Factors::factor`], L below the diagonal, and U on and above it.
    pub(super) entries: Vec<S>,
    pivots: Vec<usize>,
}

impl<S: Scalar> Factors<S> {
    pub(super) fn new(size: usize) -> Self {
        Self { size, entries: vec![S::ZERO; size * size], pivots: vec![0; size] }
    }

    /// Replaces A by its factors. If A is singular, solutions are not finite. All lanes use the pivots of the
    /// first lane.
    pub(super) fn factor(&mut self) {
        let n = self.size;
        for k in 0..n {
            let size = |i: &usize| self.entries[k * n + i].value().abs();
            let pivot = (k..n).reduce(|best, i| if size(&i) > size(&best) { i } else { best }).unwrap_or(k);
            self.pivots[k] = pivot;
            for column in 0..n {
                self.entries.swap(column * n + k, column * n + pivot);
            }
            let inverse = S::ONE / self.entries[k * n + k];
            for i in k + 1..n {
                self.entries[k * n + i] = self.entries[k * n + i] * inverse;
            }
            for column in k + 1..n {
                let (before, from) = self.entries.split_at_mut(column * n);
                let above = from[k];
                subtract(&mut from[k + 1..n], above, &before[k * n + k + 1..(k + 1) * n]);
            }
        }
    }

    /// Replaces b by the solution of `A x = b`.
    pub(super) fn solve(&self, b: &mut [S]) {
        let n = self.size;
        for (k, &pivot) in self.pivots.iter().enumerate() {
            b.swap(k, pivot);
        }
        for k in 0..n {
            let (known, below) = (b[k], &self.entries[k * n + k + 1..(k + 1) * n]);
            subtract(&mut b[k + 1..], known, below);
        }
        for k in (0..n).rev() {
            b[k] = b[k] / self.entries[k * n + k];
            let (known, above) = (b[k], &self.entries[k * n..k * n + k]);
            subtract(&mut b[..k], known, above);
        }
    }
}

/// `from -= known column`, entry by entry.
fn subtract<S: Scalar>(from: &mut [S], known: S, column: &[S]) {
    for (from, entry) in from.iter_mut().zip(column) {
        *from -= *entry * known;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_system_whose_pivots_are_zero_at_first_is_solved() {
        let rows = [[0.0, 2.0, 1.0], [1.0, 0.0, -3.0], [4.0, 5.0, 0.0]];
        let x = [3.0, -1.0, 0.5];
        let mut factors = Factors::new(3);
        factors.entries = (0..9).map(|k| rows[k % 3][k / 3]).collect();
        factors.factor();
        let mut b: Vec<f64> = rows.iter().map(|row| row.iter().zip(&x).map(|(a, x)| a * x).sum()).collect();
        factors.solve(&mut b);
        // Three unknowns, entries of order one: an error of a few units in the last place.
        assert!(b.iter().zip(&x).all(|(b, x)| (b - x).abs() < 1e-14), "{b:?}");
    }

    #[test]
    fn a_singular_system_gives_a_solution_that_is_not_finite() {
        let mut factors = Factors::new(2);
        factors.entries = vec![1.0, 2.0, 2.0, 4.0];
        factors.factor();
        let mut b = [1.0, 1.0];
        factors.solve(&mut b);
        assert!(b.iter().any(|x: &f64| !x.is_finite()));
    }
}
