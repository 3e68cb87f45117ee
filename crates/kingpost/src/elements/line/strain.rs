//! The tension in an element of a line, on which the position is quadratic.

use super::section::LineSection;
use crate::elements::lines::length_and_direction;
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// Coordinate of the two points of Gauss's rule, from the middle of an element, in halves of its length; 1 / sqrt(3).
pub const GAUSS: f64 = 0.577_350_269_189_625_8;

/// Distance from the second of them to the end of the element, over that between both.
pub const BEYOND_GAUSS: f64 = 0.5 * (1.0 / GAUSS - 1.0);

/// Returns the coordinate in its element of the k-th point of Gauss's rule along a line, two of them in each element.
pub fn gauss(k: usize) -> f64 {
    [-GAUSS, GAUSS][k % 2]
}

/// State of an element at a point of Gauss's rule.
#[derive(Clone, Copy, Debug)]
pub struct Strained<S> {
    /// Unit tangent.
    pub tangent: Vector3<S>,
    /// Stored part of the tension, and the whole, N.
    pub tension: [S; 2],
    /// Stretch ratio and its rate.
    pub ratio: [S; 2],
}

/// Returns the derivatives of the three shape functions along an element of length h, at xi in halves of it from the
/// middle: `N' = (xi - 1/2, -2 xi, xi + 1/2) 2 / h`.
pub fn slopes<S: Scalar>(xi: f64, length: S) -> [S; 3] {
    let per_half = S::constant(2.0) / length;
    [xi - 0.5, -2.0 * xi, xi + 0.5].map(|slope| S::constant(slope) * per_half)
}

/// Returns the values of the three shape functions.
pub fn shapes<S: Scalar>(xi: f64) -> [S; 3] {
    [0.5 * xi * (xi - 1.0), 1.0 - xi * xi, 0.5 * xi * (xi + 1.0)].map(S::constant)
}

/// Returns the weighted sum of three vectors.
pub fn sum<S: Scalar>(weights: &[S; 3], of: &[Vector3<S>; 3]) -> Vector3<S> {
    of[0] * weights[0] + of[1] * weights[1] + of[2] * weights[2]
}

/// Returns tension and tangent at a point with these slopes of the shape functions, from positions and velocities of the
/// nodes: the strain is that of the arc, `e = |x'| - 1`.
pub fn strained<S: Scalar>(
    section: &LineSection<S>,
    slopes: &[S; 3],
    positions: &[Vector3<S>; 3],
    velocities: &[Vector3<S>; 3],
) -> Strained<S> {
    let way = sum(slopes, positions);
    let (ratio, tangent) = length_and_direction(way);
    let rate = tangent.dot(sum(slopes, velocities));
    Strained { tangent, tension: section.tension(ratio, rate), ratio: [ratio, rate] }
}
