//! Lengths that are valid divisors.

use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// Distance from a surface, m, up to which the planes of its faces count: nearer, rounding turns the normal.
pub(super) const SURFACE_M: f64 = 1e-12;

/// Returns the length of a vector, bounded below by the smallest valid divisor.
pub(super) fn length<S: Scalar>(vector: Vector3<S>) -> S {
    root(vector.norm_squared())
}

/// Returns the square root, bounded below by the smallest valid divisor.
pub(super) fn root<S: Scalar>(squared: S) -> S {
    squared.select_below(f64::MIN_POSITIVE, || S::constant(f64::MIN_POSITIVE), || squared).sqrt()
}

/// Returns `below` where `a < b`, otherwise `above`.
pub(super) fn choose<S: Scalar, const N: usize>(a: S, b: S, below: [S; N], above: [S; N]) -> [S; N] {
    core::array::from_fn(|i| a.select_less(b, || below[i], || above[i]))
}
