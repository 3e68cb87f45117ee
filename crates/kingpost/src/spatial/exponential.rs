//! Exponential of a square matrix of any size.

use nalgebra::DMatrix;

/// Largest norm of a matrix whose exponential is computed: beyond it the result would be rounding noise.
const LARGEST_NORM: f64 = 1e9;

/// Returns the exponential of a matrix by scaling and squaring, with Taylor's series of the scaled matrix
/// (Moler & Van Loan, "Nineteen dubious ways to compute the exponential of a matrix", *SIAM Review* 45(1),
/// 2003, method 3): exact to rounding with 18 terms up to a norm of 1/2. NaN beyond the largest norm.
pub fn exponential(matrix: DMatrix<f64>) -> DMatrix<f64> {
    let n = matrix.nrows();
    let norm = matrix.norm();
    if !norm.is_finite() || norm > LARGEST_NORM {
        return DMatrix::from_element(n, n, f64::NAN);
    }
    let (mut small, mut squarings) = (matrix, 0);
    while small.norm() > 0.5 {
        small *= 0.5;
        squarings += 1;
    }
    let mut term = DMatrix::identity(n, n);
    let mut sum = term.clone();
    for k in 1..=18 {
        term = &term * &small / f64::from(k);
        sum += &term;
    }
    (0..squarings).for_each(|_| sum = &sum * &sum);
    sum
}
