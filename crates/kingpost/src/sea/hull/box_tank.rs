//! Free surface of a slack tank: a liquid in a box whose surface stays level.
//!
//! The surface is always level, without sloshing: valid if the natural periods of the liquid in its tank are
//! well below those of the ship. The volume below a plane n . r = l through a box, and its first moment, are
//! computed like those of a hull (see [`super::WettedHull`]), here for a box whose sizes may carry
//! derivatives.

use super::solids::Below;
use crate::scalar::{Dual, Scalar};
use crate::spatial::{Matrix3, Vector3};

/// Largest number of Newton steps: for a level in a corner, each step leaves two thirds of the error.
const MOST_STEPS: usize = 60;
/// Smallest step that counts, as a share of the tank's extent along the vertical.
const SMALLEST_STEP: f64 = 1e-15;

/// A box that contains a liquid. The box's centre is the origin, and its sides are along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoxTank<S = f64> {
    /// Length, breadth and height: along x, y and z, m.
    pub edges: Vector3<S>,
    /// Ratio of the liquid's volume to that of the box, from 0 to 1; at both ends there is no free surface.
    pub filling: S,
}

impl<S: Scalar> BoxTank<S> {
    /// Returns the volume V of the liquid, m^3.
    pub fn volume(&self) -> S {
        self.edges[0] * self.edges[1] * self.edges[2] * self.filling
    }

    /// V (c - c0), m^4: the change of the liquid's first moment when the vertical, a unit vector in the tank's axes,
    /// turns from z to n. c0 is the liquid's centre upright, c that with a level surface in the tilted box, at the same
    /// volume. Until the surface meets top or bottom it is the wall-sided formula, with I the second moments of the
    /// surface upright about its centroid (Barrass & Derrett, *Ship Stability for Masters and Mates*, ch. on free
    /// surface):
    ///
    /// ```text
    /// V (c - c0) = (-I n_h / n_z, n_h . I n_h / (2 n_z^2)),      n_h = (n_x, n_y)
    /// ```
    ///
    /// ```
    /// use kingpost::sea::hull::BoxTank;
    /// use kingpost::spatial::Vector3;
    /// let tank = BoxTank { edges: Vector3::new(4.0, 6.0, 2.0), filling: 0.5 };
    /// let shift = tank.shift(Vector3::new(0.0, 0.28, 0.96));
    /// let (second_moment, tan) = (4.0 * 6.0_f64.powi(3) / 12.0, 0.28 / 0.96);
    /// assert!((shift[1] + second_moment * tan).abs() < 1e-12);
    /// assert!((shift[2] - second_moment * tan * tan / 2.0).abs() < 1e-12);
    /// ```
    pub fn shift(&self, vertical: Vector3<S>) -> Vector3<S> {
        let room = self.room(vertical);
        let shift = if room.all(|room| room >= 0.0) {
            self.shift_between_walls(vertical)
        } else {
            let cut = self.shift_in_corners(vertical);
            let of = |k: usize| room.select_below(0.0, || cut[k], || self.shift_between_walls(vertical)[k]);
            Vector3([of(0), of(1), of(2)])
        };
        let free = self.filling * (S::ONE - self.filling);
        Vector3(shift.0.map(|moment| free.select_below(f64::MIN_POSITIVE, || S::ZERO, || moment)))
    }

    /// Returns a measure that is not negative if the surface meets only upright walls: twice the smallest
    /// remaining height of liquid or air at the walls.
    fn room(&self, vertical: Vector3<S>) -> S {
        let size = |x: S| x.select_below(0.0, || -x, || x);
        let least = self.filling.select_below(0.5, || self.filling, || S::ONE - self.filling);
        let slack = (least + least) * self.edges[2] * vertical[2];
        slack - size(vertical[0]) * self.edges[0] - size(vertical[1]) * self.edges[1]
    }

    fn shift_between_walls(&self, vertical: Vector3<S>) -> Vector3<S> {
        let ([length, breadth, _], [x, y, z]) = (self.edges.0, vertical.0);
        let ([slope_x, slope_y], area) = ([x / z, y / z], length * breadth * S::constant(1.0 / 12.0));
        let (ahead, to_port) = (-(area * length * length * slope_x), -(area * breadth * breadth * slope_y));
        Vector3::new(ahead, to_port, -(ahead * slope_x + to_port * slope_y) * S::constant(0.5))
    }

    fn shift_in_corners(&self, vertical: Vector3<S>) -> Vector3<S> {
        let upright = self.volume() * (self.filling - S::ONE) * self.edges[2] * S::constant(0.5);
        self.below(vertical, self.level(vertical)).first_moment - Vector3::new(S::ZERO, S::ZERO, upright)
    }

    /// Returns l: height of the surface above the centre of the box, m. The last Newton step carries the
    /// derivatives: with the exact dV/dl, which is the area, they are exact if l is.
    fn level(&self, vertical: Vector3<S>) -> S {
        let ([x, y, z], [length, breadth, height]) = (vertical.0, self.edges.0);
        let [level] = S::from_values([x, y, z, length, breadth, height, self.filling], &|numbers| {
            let [x, y, z, length, breadth, height, filling] = numbers;
            [BoxTank { edges: Vector3::new(length, breadth, height), filling }.find_level(Vector3::new(x, y, z))]
        });
        let below = self.below(vertical, level);
        let excess = below.volume - self.volume();
        level - below.area.select_below(f64::MIN_POSITIVE, || S::ZERO, || excess / below.area)
    }

    /// Returns the part of the box below the plane n . r = l.
    fn below(&self, vertical: Vector3<S>, level: S) -> Below<S> {
        Below::of_box(self.edges, vertical, level)
    }
}

impl BoxTank {
    /// Newton's method, dV/dl = area. It starts with the level of a surface that meets only walls along one
    /// axis; for such a surface this level is exact. Otherwise the volume below that level is larger than the
    /// liquid (smaller, for a tank more than half full). From the middle of the box outward V is convex
    /// (concave) over l, because it is the convolution of three even densities. So every step goes towards
    /// the level but never beyond it, and a step in the other direction is a rounding error.
    fn find_level(&self, vertical: Vector3) -> f64 {
        let extents: [f64; 3] = core::array::from_fn(|k| (vertical[k] * self.edges[k]).abs());
        let fullness = self.filling - 0.5;
        let smallest = SMALLEST_STEP * (extents[0] + extents[1] + extents[2]);
        let volume = self.volume();
        let mut level = fullness * extents[0].max(extents[1]).max(extents[2]);
        for _ in 0..MOST_STEPS {
            let below = self.below(vertical, level);
            let step = (below.volume - volume) / below.area;
            let onward = if fullness > 0.0 { -step } else { step };
            let moves = onward > smallest && below.area > 0.0;
            if !moves {
                break;
            }
            level -= step;
        }
        level
    }

    /// Returns i, m^4: the second moment of the free surface about its centroid, along the unit vectors t and
    /// u in the surface, in the tank's axes. It is minus the derivative of V c along t when the vertical
    /// turns towards u.
    pub fn second_moment(&self, vertical: Vector3, t: Vector3, u: Vector3) -> f64 {
        let turning = Vector3(core::array::from_fn(|k| Dual::<1> { value: vertical[k], derivative: [u[k]] }));
        let tank = BoxTank { edges: Vector3::constant(self.edges.0), filling: Dual::constant(self.filling) };
        let rate = tank.shift(turning).0.map(|moment| moment.derivative[0]);
        -t.dot(Vector3(rate))
    }
}

/// A slack tank that moves with a hull.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HullTank {
    /// The box and its filling.
    pub tank: BoxTank,
    /// Rotation from the tank's axes to the hull's.
    pub rotation: Matrix3,
    /// Density of the liquid, kg/m^3.
    pub density: f64,
}

impl HullTank {
    /// Returns rho V (c - c0) in hull axes, kg m; see [`BoxTank::shift`].
    pub fn shift(&self, vertical: Vector3) -> Vector3 {
        self.rotation * (self.tank.shift(self.rotation.transpose_times(vertical)) * self.density)
    }

    /// Returns rho i along tangents in hull axes, kg m^2; see [`BoxTank::second_moment`].
    pub fn second_moment(&self, vertical: Vector3, t: Vector3, u: Vector3) -> f64 {
        let [vertical, t, u] = [vertical, t, u].map(|axis| self.rotation.transpose_times(axis));
        self.density * self.tank.second_moment(vertical, t, u)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// The error is that of the sum of twelve triangles' volumes, with a few rounding errors each; the
        /// level is found to 1e-15 of the box's extent.
        #[test]
        fn the_volume_below_the_surface_is_that_of_the_liquid_in_any_orientation(
            edges in prop::array::uniform3(0.1..10.0_f64),
            filling in prop_oneof![0.0..1.0_f64, 0.0..1e-6_f64, 0.999..1.0_f64],
            vertical in prop::array::uniform3(-1.0..1.0_f64),
            flat in prop::array::uniform3(prop::bool::ANY),
        ) {
            let vertical = Vector3(core::array::from_fn(|k| if flat[k] { 1e-9 * vertical[k] } else { vertical[k] }));
            prop_assume!(vertical.norm() > 0.0);
            let tank = BoxTank { edges: Vector3(edges), filling };
            let vertical = vertical.direction();
            let whole = edges[0] * edges[1] * edges[2];
            let found = tank.below(vertical, tank.level(vertical)).volume;
            let across: f64 = (0..3).map(|k| (vertical[k] * whole / edges[k]).abs()).sum();
            let extent: f64 = (0..3).map(|k| (vertical[k] * edges[k]).abs()).sum();
            let rounding = 12.0 * f64::EPSILON * across * extent;
            prop_assert!((found - tank.volume()).abs() < rounding, "{found}, liquid {}", tank.volume());
        }

        /// The volume of the box cut by a plane agrees with the closed form of the wedges, to rounding.
        #[test]
        fn a_surface_between_walls_cuts_the_volume_of_the_closed_form(
            edges in prop::array::uniform3(0.1..10.0_f64),
            filling in 0.001..0.999_f64,
            slopes in prop::array::uniform2(-1.0..1.0_f64),
            share in 0.0..1.0_f64,
        ) {
            let tank = BoxTank { edges: Vector3(edges), filling };
            let spread = (slopes[0] * edges[0]).abs() + (slopes[1] * edges[1]).abs();
            let slope = share * 2.0 * filling.min(1.0 - filling) * edges[2] / spread;
            let vertical = Vector3::new(slope * slopes[0], slope * slopes[1], 1.0).direction();
            prop_assert!(tank.room(vertical) > -1e-12, "{}", tank.room(vertical));
            let apart = tank.shift_in_corners(vertical) - tank.shift_between_walls(vertical);
            let size = tank.edges.norm() * edges[0] * edges[1] * edges[2];
            prop_assert!(apart.norm() < 1e-14 * size, "{apart:?} of {size}");
        }
    }
}
