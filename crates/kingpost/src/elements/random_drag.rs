//! Drag that is quadratic in a velocity through the water, in a random sea: its mean over a Gaussian velocity.
//!
//! A linear response to a random sea has the drag `f(r)` of a relative velocity `r` with the mean m and the covariance S as its mean
//! `E[f(r)]` and, for small motions, the slope `E[df/dr]`: of all linear functions of a Gaussian r it is the one with the least mean
//! square error (Atalik & Utku, *Earthquake Eng. Struct. Dyn.* 4, 1976). Along one direction and without a mean it is that of
//! Borgman (*J. Waterways Harbors Div. ASCE* 93(WW2), 1967): `|r| r` becomes `sqrt(8 / pi) sigma r`.

use crate::scalar::Scalar;
use crate::spatial::{Matrix3, Symmetric3, Vector3};
use core::f64::consts::{FRAC_1_SQRT_2, FRAC_2_PI, PI};

/// Motion of the water at a point by waves, for small motions.
#[derive(Clone, Copy, Debug)]
pub struct WaterMotion<S = f64> {
    /// Elevation of the surface above it, m.
    pub elevation: S,
    /// Velocity, world, m/s.
    pub velocity: Vector3<S>,
    /// Acceleration, world, m/s^2.
    pub acceleration: Vector3<S>,
}

/// Number of components of the motion of the water at a point.
pub const WATER_COMPONENTS: usize = 7;

impl<S: Scalar> WaterMotion<S> {
    /// Creates a motion from its components: elevation, velocity, acceleration.
    pub fn from_components(components: [S; WATER_COMPONENTS]) -> Self {
        let [elevation, rest @ ..] = components;
        let [velocity, acceleration] = [0, 3].map(|first| Vector3::from_slice(&rest[first..first + 3]));
        Self { elevation, velocity, acceleration }
    }
}

/// An element with drag at nodes, for its linear response to a random sea.
pub trait RandomDrag<S: Scalar = f64> {
    /// Returns the number of its nodes.
    fn nodes(&self) -> usize;

    /// Sets the covariance of the velocity of the water relative to each node, world, m^2/s^2. From then on its drag is the mean
    /// over the Gaussian velocities.
    fn set_spread(&mut self, spread: &[Symmetric3]);

    /// Sets the motion of the water by waves at a node; `set_spread` comes first.
    fn set_water(&mut self, node: usize, water: WaterMotion<S>);

    /// Returns position (m) and velocity (m/s) of a node at the last evaluation, world.
    fn motion(&self, node: usize) -> [Vector3<S>; 2];
}

/// Smallest variance of a velocity, m^2/s^2: far below every motion that counts, so that the slope has a derivative at rest.
const LEAST: f64 = 1e-12;

/// Number of directions of [`mean_across`], over half a turn. For motions in one direction its error is 2e-6 along this and 6e-4
/// across it; for others less.
const DIRECTIONS: u32 = 64;

/// Returns `E[|r| r]` of a Gaussian r with this mean and variance, and its slope along the mean, without derivatives of its own.
pub fn mean_square<S: Scalar>(mean: S, variance: S) -> [S; 2] {
    let [m, v, force, slope, by_variance] = S::from_values([mean, variance], &|[mean, variance]| {
        let least = variance + LEAST;
        let ratio = mean / least.sqrt() * FRAC_1_SQRT_2;
        let (erf, bell) = (libm::erf(ratio), (FRAC_2_PI * least).sqrt() * libm::exp(-ratio * ratio));
        [mean, variance, (mean * mean + least) * erf + mean * bell, 2.0 * (mean * erf + bell), erf]
    });
    [force + slope * (mean - m) + by_variance * (variance - v), slope]
}

/// Returns a covariance times a vector.
fn times<S: Scalar>(spread: &Symmetric3, vector: Vector3<S>) -> Vector3<S> {
    let [x, y, z] = vector.0;
    let Symmetric3 { xx, xy, xz, yy, yz, zz } = spread;
    let [xx, xy, xz, yy, yz, zz] = [xx, xy, xz, yy, yz, zz].map(|entry| S::constant(*entry));
    Vector3::new(xx * x + xy * y + xz * z, xy * x + yy * y + yz * z, xz * x + yz * y + zz * z)
}

/// Returns `E[|n| n]` of the part n across a tangent of a Gaussian vector with this mean and covariance, and its slope along the
/// mean.
///
/// For a vector in a plane, `|n| n = 3/8 Int |e.n| (e.n) e da` over the unit vectors e at all angles a: drag across is the mean of
/// drags along one direction, each with a closed form. With a mean, and covariances that are not the same in both directions, it is
/// the linearisation of Langley (*Applied Ocean Research* 6(3), 1984).
pub fn mean_across<S: Scalar>(tangent: Vector3<S>, mean: Vector3<S>, spread: &Symmetric3) -> (Vector3<S>, Matrix3<S>) {
    let [one, other] = beside(tangent);
    let [of_one, of_other] = [one, other].map(|axis| times(spread, axis));
    let [by_one, by_both, by_other] = [of_one.dot(one), of_one.dot(other), of_other.dot(other)];
    let [mean_one, mean_other] = [one, other].map(|axis| axis.dot(mean));
    let (mut force, mut slope) = ([S::ZERO; 2], [S::ZERO; 3]);
    for k in 0..DIRECTIONS {
        let (sin, cos) = libm::sincos(PI * (f64::from(k) + 0.5) / f64::from(DIRECTIONS));
        let [c, s, cc, cs, ss] = [cos, sin, cos * cos, cos * sin, sin * sin].map(S::constant);
        let variance = cc * by_one + (cs + cs) * by_both + ss * by_other;
        let [along, rise] = mean_square(c * mean_one + s * mean_other, variance);
        force = [force[0] + c * along, force[1] + s * along];
        slope = [slope[0] + cc * rise, slope[1] + cs * rise, slope[2] + ss * rise];
    }
    let weight = S::constant(0.75 * PI / f64::from(DIRECTIONS));
    let both = Matrix3::outer(one, other) + Matrix3::outer(other, one);
    let slope = Matrix3::outer(one, one).scaled(slope[0])
        + both.scaled(slope[1])
        + Matrix3::outer(other, other).scaled(slope[2]);
    ((one * force[0] + other * force[1]) * weight, slope.scaled(weight))
}

/// Returns `E[|a| a]` of the part a along a tangent, and its slope.
pub fn mean_along<S: Scalar>(tangent: Vector3<S>, mean: Vector3<S>, spread: &Symmetric3) -> (Vector3<S>, Matrix3<S>) {
    let [along, rise] = mean_square(tangent.dot(mean), times(spread, tangent).dot(tangent));
    (tangent * along, Matrix3::outer(tangent, tangent).scaled(rise))
}

/// Returns two unit vectors that are perpendicular to a unit vector and to each other.
fn beside<S: Scalar>(unit: Vector3<S>) -> [Vector3<S>; 2] {
    let axes = [Vector3::new(S::ONE, S::ZERO, S::ZERO), Vector3::new(S::ZERO, S::ZERO, S::ONE)];
    let is_along_x = unit[0].all(|x| x.abs() > FRAC_1_SQRT_2);
    let one = unit.cross(axes[usize::from(is_along_x)]).direction();
    [one, unit.cross(one)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Source: quadrature of |r| r and 2 |r| over the density of r; sqrt(8 / pi) sigma without a mean.
    #[test]
    fn the_mean_of_a_square_is_that_over_the_density() {
        for (mean, sigma) in [(0.0, 0.7), (0.4, 0.5), (-1.5, 0.3), (2.0, 1e-5)] {
            let steps = 200_000;
            let (mut force, mut slope) = (0.0, 0.0);
            for k in 0..steps {
                let x = 20.0 * (f64::from(k) + 0.5) / f64::from(steps) - 10.0;
                let weight = libm::exp(-0.5 * x * x) / (2.0 * PI).sqrt() * 20.0 / f64::from(steps);
                let r: f64 = mean + sigma * x;
                force += weight * r.abs() * r;
                slope += weight * 2.0 * r.abs();
            }
            let found = mean_square(mean, sigma * sigma);
            // The midpoint rule over 200,000 steps, at the kink of the slope.
            assert!((found[0] - force).abs() < 1e-8 && (found[1] - slope).abs() < 1e-8, "{mean} {sigma} {found:?}");
        }
        assert!((mean_square(0.0, 0.49)[1] - (8.0 / PI).sqrt() * 0.7).abs() < 1e-10);
    }

    /// Source: E[|n| n] by quadrature over two Gaussian components, in a plane across an oblique tangent.
    #[test]
    fn the_mean_across_is_that_over_both_components() {
        let tangent = Vector3::new(0.6, 0.0, 0.8);
        let [one, other] = beside(tangent);
        let (deviations, mean) = ([0.8, 0.3], one * 0.5 + other * 0.2 + tangent * 3.0);
        let of = |unit: Vector3<f64>, sigma: f64| Matrix3::outer(unit, unit).scaled(sigma * sigma);
        let spread = Symmetric3::from_upper(&(of(one, deviations[0]) + of(other, deviations[1]) + of(tangent, 2.0)));
        let (mut force, mut slope) = ([0.0; 2], [[0.0; 2]; 2]);
        let steps = 600;
        let at = |k: i32| 16.0 * (f64::from(k) + 0.5) / f64::from(steps) - 8.0;
        for (x, y) in (0..steps).flat_map(|i| (0..steps).map(move |j| (at(i), at(j)))) {
            let step = 16.0 / f64::from(steps);
            let weight = libm::exp(-0.5 * (x * x + y * y)) / (2.0 * PI) * step * step;
            let n = [0.5 + deviations[0] * x, 0.2 + deviations[1] * y];
            let speed = libm::hypot(n[0], n[1]);
            for i in 0..2 {
                force[i] += weight * speed * n[i];
                for j in 0..2 {
                    slope[i][j] += weight * (n[i] * n[j] / speed + if i == j { speed } else { 0.0 });
                }
            }
        }
        let (found, rise) = mean_across(tangent, mean, &spread);
        let axes = [one, other];
        assert!(found.dot(tangent).abs() < 1e-12);
        for i in 0..2 {
            // The midpoint rule in steps of 0.03 sigma, where the slope has a kink.
            assert!((found.dot(axes[i]) - force[i]).abs() < 1e-4, "{i}");
            for j in 0..2 {
                assert!((axes[i].dot(rise * axes[j]) - slope[i][j]).abs() < 1e-4, "{i} {j}");
            }
        }
    }

    /// Source: in one direction sqrt(8 / pi) sigma along it and half of it across, by E[|n|]; in both alike
    /// 3/2 E[|n|] = 3/2 sqrt(pi / 2) sigma.
    #[test]
    fn closed_forms_of_one_direction_and_of_both_alike() {
        let tangent = Vector3::new(0.0, 0.0, 1.0);
        let along_one = mean_across(tangent, Vector3::zero(), &Symmetric3::diagonal([0.25, 0.0, 0.0])).1;
        let one = (8.0 / PI).sqrt() * 0.5;
        // The errors of the sum over directions.
        assert!((along_one.0[0][0] / one - 1.0).abs() < 1e-5 && (along_one.0[1][1] / (0.5 * one) - 1.0).abs() < 2e-3);
        let both = mean_across(tangent, Vector3::zero(), &Symmetric3::diagonal([0.25, 0.25, 0.0])).1;
        assert!((both.0[0][0] / (1.5 * (0.5 * PI).sqrt() * 0.5) - 1.0).abs() < 1e-9);
    }
}
