//! Cholesky factorisation in the order of the rows: those of constraints in J M*^-1 J^T, or those of coupled roots.
//!
//! The order is fixed and not chosen by the magnitude of the pivots, so a vanishing pivot identifies the first
//! constraint that depends on those before it.

use crate::scalar::Scalar;

/// Smallest pivot that is used, as a ratio to its reference: below it the constraint has become dependent on
/// the others, for example within 1e-5 rad of a dead centre.
pub const SMALLEST_PIVOT: f64 = 1e-10;

/// Smallest length of a row of J, as a share of its wrench: with a shorter row, no coordinate affects the
/// constraint.
const SMALLEST_MOTION: f64 = 1e-9;

/// The matrix with its Cholesky factor, by rows.
#[derive(Clone, Debug)]
pub struct CholeskyFactor<S = f64> {
    count: usize,
    /// Matrix, whose lower triangle is read; its factor L replaces it.
    matrix: Vec<S>,
    /// Reciprocal of the diagonal of L; zero if the pivot is too small.
    reciprocal: Vec<S>,
    /// Reference of each pivot.
    reference: Vec<S>,
    /// Pivots divided by their references.
    pivots: Vec<S>,
}

impl<S: Scalar> CholeskyFactor<S> {
    /// Allocates the memory for this number of constraints.
    pub fn new(count: usize) -> Self {
        let many = |value| vec![value; count];
        Self {
            count,
            matrix: vec![S::ZERO; count * count],
            reciprocal: many(S::ZERO),
            reference: many(S::ONE),
            pivots: many(S::ONE),
        }
    }

    /// Starts with this number of constraints, at most that of the memory.
    pub fn begin(&mut self, count: usize) {
        self.count = count;
    }

    /// Writes an entry of the lower triangle.
    #[inline]
    pub fn set(&mut self, row: usize, column: usize, value: S) {
        self.matrix[row * self.count + column] = value;
    }

    /// Adds to an entry of the lower triangle.
    #[inline]
    pub fn add(&mut self, row: usize, column: usize, value: S) {
        self.matrix[row * self.count + column] += value;
    }

    /// Sets the present diagonal as the reference of a constraint's pivots; infinity unless the constraint
    /// `moves` something, because its diagonal is then a rounding error.
    pub fn take_reference(&mut self, row: usize, moves: S) {
        let own = self.matrix[row * self.count + row];
        self.reference[row] = moves.select_below(SMALLEST_MOTION, || S::constant(f64::INFINITY), || own);
    }

    /// Factors the matrix in place. A constraint whose pivot is too small is omitted: its load is zero, and
    /// its pivot shows this.
    pub fn factor(&mut self) {
        let n = self.count;
        for i in 0..n {
            for j in 0..=i {
                let sum =
                    (0..j).fold(self.matrix[i * n + j], |sum, k| sum - self.matrix[i * n + k] * self.matrix[j * n + k]);
                if i != j {
                    self.matrix[i * n + j] = sum * self.reciprocal[j];
                    continue;
                }
                let limit = S::constant(SMALLEST_PIVOT) * self.reference[i];
                self.pivots[i] = sum / self.reference[i];
                // The comparison is written so that NaN is also omitted.
                let root = limit.select_less(sum, || sum.sqrt(), || S::ZERO);
                self.reciprocal[i] = limit.select_less(sum, || S::ONE / root, || S::ZERO);
                self.matrix[i * n + i] = root;
            }
        }
    }

    /// Solves for the multipliers in place.
    pub fn solve(&self, x: &mut [S]) {
        let n = self.count;
        for i in 0..n {
            let sum = (0..i).fold(x[i], |sum, k| sum - self.matrix[i * n + k] * x[k]);
            x[i] = sum * self.reciprocal[i];
        }
        for i in (0..n).rev() {
            let sum = (i + 1..n).fold(x[i], |sum, k| sum - self.matrix[k * n + i] * x[k]);
            x[i] = sum * self.reciprocal[i];
        }
    }

    /// Returns the pivots divided by their references.
    pub fn pivots(&self) -> &[S] {
        &self.pivots[..self.count]
    }

    /// Returns the first constraint whose pivot is too small, in any lane.
    pub fn dependent(&self) -> Option<usize> {
        self.pivots().iter().position(|pivot| !pivot.all(|pivot| pivot > SMALLEST_PIVOT))
    }

    /// Returns the constraints before `row` on which it depends.
    pub fn depends_on(&self, row: usize) -> Vec<usize> {
        // The row of L is L^T c, where c are the shares of the rows before it.
        let (n, mut share) = (self.count, vec![0.0; row]);
        let entry = |row: usize, column: usize| self.matrix[row * n + column].value();
        for i in (0..row).rev() {
            let sum = (i + 1..row).fold(entry(row, i), |sum, k| sum - entry(k, i) * share[k]);
            share[i] = sum * self.reciprocal[i].value();
        }
        let reference = |i: usize| self.reference[i].value();
        let size = |i: usize| libm::sqrt(share[i] * share[i] * reference(i) / reference(row));
        // Shares are relative to the row: a share below 1e-6 does not count as a dependence.
        (0..row).filter(|&i| size(i) > 1e-6).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn factor(rows: &[[f64; 3]; 3]) -> CholeskyFactor {
        let mut factor = CholeskyFactor::new(3);
        (0..3).for_each(|i| (0..=i).for_each(|j| factor.set(i, j, rows[i][j])));
        (0..3).for_each(|i| factor.take_reference(i, 1.0));
        factor.factor();
        factor
    }

    #[test]
    fn a_positive_definite_system_is_solved() {
        let rows = [[4.0, 1.0, 0.5], [1.0, 3.0, -0.7], [0.5, -0.7, 2.0]];
        let mut x = [1.0, -2.0, 0.3];
        factor(&rows).solve(&mut x);
        for (row, right) in rows.iter().zip([1.0, -2.0, 0.3]) {
            let left: f64 = row.iter().zip(&x).map(|(a, x)| a * x).sum();
            assert!((left - right).abs() < 1e-15);
        }
    }

    #[test]
    fn a_dependent_row_is_named_with_the_rows_it_depends_on_and_carries_no_load() {
        // Rows J = (1, 0), (1, 1e-3), (0, 2): the third is 2000 times the difference of the second and the
        // first.
        let rows = [[1.0, 1.0, 0.0], [1.0, 1.0 + 1e-6, 2e-3], [0.0, 2e-3, 4.0]];
        let factor = factor(&rows);
        assert_eq!(factor.dependent(), Some(2));
        assert_eq!(factor.depends_on(2), [0, 1]);
        let mut x = [1.0, 2.0, 3.0];
        factor.solve(&mut x);
        assert!(x[2] == 0.0 && x.iter().all(|x| x.is_finite()));
    }
}
