//! Solution of `(s - A) x = b` for many numbers s: frequencies, eigenvalues.

use nalgebra::linalg::{Hessenberg, balancing::balance_parlett_reinsch};
use nalgebra::{Complex, DMatrix, DVector};

/// A in Hessenberg form `D Q H Q^T D^-1`: a solution costs the square of the number of states, not its cube (Laub, *IEEE Trans.
/// Automatic Control* 26(2), 1981).
pub(in crate::analysis) struct Shifted {
    scales: DVector<f64>,
    q: DMatrix<f64>,
    h: DMatrix<f64>,
}

impl Shifted {
    /// Reduces A, which has at least one state.
    pub(in crate::analysis) fn new(a: &DMatrix<f64>) -> Self {
        let mut balanced = a.clone();
        let scales = balance_parlett_reinsch(&mut balanced);
        let (q, h) = Hessenberg::new(balanced).unpack();
        Self { scales, q, h }
    }

    /// Returns `x` for a number s, one column for each of `b`; `None` if the matrix is singular there.
    pub(in crate::analysis) fn solve(
        &self,
        shift: Complex<f64>,
        right: &DMatrix<Complex<f64>>,
    ) -> Option<DMatrix<Complex<f64>>> {
        let scaled = |part: fn(&Complex<f64>) -> f64| {
            let scaled = DMatrix::from_fn(right.nrows(), right.ncols(), |i, j| part(&right[(i, j)]) / self.scales[i]);
            self.q.tr_mul(&scaled)
        };
        let (re, im) = (scaled(|x| x.re), scaled(|x| x.im));
        // By rows: the elimination adds rows.
        let mut rows: Vec<Vec<Complex<f64>>> = (0..re.nrows())
            .map(|i| {
                let shifted = (0..re.nrows()).map(|j| if i == j { shift } else { Complex::ZERO } - self.h[(i, j)]);
                shifted.chain((0..re.ncols()).map(|j| Complex::new(re[(i, j)], im[(i, j)]))).collect()
            })
            .collect();
        eliminate(&mut rows);
        substitute_back(&mut rows)?;
        let [re, im] = [|x: &Complex<f64>| x.re, |x: &Complex<f64>| x.im].map(|part| {
            let found = DMatrix::from_fn(re.nrows(), re.ncols(), |i, j| part(&rows[i][re.nrows() + j]));
            &self.q * found
        });
        Some(DMatrix::from_fn(re.nrows(), re.ncols(), |i, j| Complex::new(re[(i, j)], im[(i, j)]) * self.scales[i]))
    }
}

/// Eliminates the entries below the diagonal, one in each column, with the larger of both rows as the pivot.
fn eliminate(rows: &mut [Vec<Complex<f64>>]) {
    for k in 1..rows.len() {
        if rows[k][k - 1].norm_sqr() > rows[k - 1][k - 1].norm_sqr() {
            rows.swap(k - 1, k);
        }
        let (above, below) = rows.split_at_mut(k);
        let (pivot, row) = (&above[k - 1], &mut below[0]);
        if row[k - 1] == Complex::ZERO {
            continue;
        }
        let factor = row[k - 1] / pivot[k - 1];
        row.iter_mut().zip(pivot).skip(k - 1).for_each(|(entry, of_pivot)| *entry -= factor * of_pivot);
    }
}

/// Replaces the right sides, behind an upper triangle, by the solutions; `None` if a pivot is zero.
fn substitute_back(rows: &mut [Vec<Complex<f64>>]) -> Option<()> {
    let n = rows.len();
    for k in (0..n).rev() {
        let (before, rest) = rows.split_at_mut(k);
        let row = &mut rest[0];
        let pivot = row[k];
        if pivot == Complex::ZERO {
            return None;
        }
        row[n..].iter_mut().for_each(|entry| *entry /= pivot);
        for other in before {
            let factor = other[k];
            other[n..].iter_mut().zip(&row[n..]).for_each(|(entry, of_row)| *entry -= factor * of_row);
        }
    }
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_solution_fulfils_the_equations() {
        for n in [1, 2, 9] {
            let number = |k: usize| libm::sin(1.0 + 3.7 * k as f64);
            // Rows of very different sizes, as in seconds and pascals.
            let a = DMatrix::from_fn(n, n, |i, j| number(n * i + j) * libm::pow(10.0, i as f64 - j as f64));
            let b = DMatrix::from_fn(n, 2, |i, j| Complex::new(number(i + j), number(2 * i + 3 * j + 1)));
            let x = Shifted::new(&a).solve(Complex::new(0.0, -0.7), &b).expect("it is regular");
            let product = x.map(|x| x * Complex::new(0.0, -0.7)) - a.map(|entry| Complex::new(entry, 0.0)) * &x;
            for (i, j) in (0..n).flat_map(|i| (0..2).map(move |j| (i, j))) {
                let size = (0..n).fold(1.0, |sum, k| sum + a[(i, k)].abs() * x[(k, j)].norm_sqr().sqrt());
                // A few units in the last place of the products of a row, and the growth of an elimination.
                assert!((product[(i, j)] - b[(i, j)]).norm_sqr().sqrt() < 1e-12 * size, "{n} {i} {j}");
            }
        }
    }
}
