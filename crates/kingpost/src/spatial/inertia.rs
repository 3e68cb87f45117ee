//! 6x6 inertia of a body.

use super::{Frame, Matrix3, Symmetric3, Twist, Vector3, Wrench, hat};
use crate::scalar::Scalar;
use core::ops::{Add, AddAssign, Sub};

/// A symmetric 6x6 inertia in body axes about the body's origin: momentum = inertia * twist.
///
/// ```text
/// | moment |   | angular    coupling | | omega |
/// | force  | = | coupling^T linear   | |   v   |
/// ```
///
/// A rigid body about its centre of mass has `coupling = 0` and `linear = m I3`: the blocks of the
/// paper's M (eq. 48). Added mass fills all of it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SpatialInertia<S = f64> {
    /// Moments of inertia J, kg m^2.
    pub angular: Symmetric3<S>,
    /// Angular momentum per linear velocity, kg m.
    pub coupling: Matrix3<S>,
    /// Mass in each direction, kg.
    pub linear: Symmetric3<S>,
}

impl<S: Scalar> SpatialInertia<S> {
    /// Returns the inertia of a rigid body about its centre of mass: mass in kg, J in kg m^2 in body axes.
    pub fn rigid(mass: S, moments: Symmetric3<S>) -> Self {
        Self { angular: moments, coupling: Matrix3::zero(), linear: Symmetric3::diagonal([mass; 3]) }
    }

    /// Creates the inertia from a symmetric 6x6 matrix by rows, angular part first; only its upper triangle is read.
    pub fn from_rows(rows: &[[S; 6]; 6]) -> Self {
        let block = |r: usize, c: usize| Matrix3::from_fn(|i, j| rows[r + i][c + j]);
        Self {
            angular: Symmetric3::from_upper(&block(0, 0)),
            coupling: block(0, 3),
            linear: Symmetric3::from_upper(&block(3, 3)),
        }
    }

    /// Returns the symmetric 6x6 matrix by rows, angular part first.
    pub fn to_rows(&self) -> [[S; 6]; 6] {
        let (angular, linear) = (self.angular.to_matrix().0, self.linear.to_matrix().0);
        core::array::from_fn(|i| {
            core::array::from_fn(|j| match (i < 3, j < 3) {
                (true, true) => angular[i][j],
                (true, false) => self.coupling.0[i][j - 3],
                (false, true) => self.coupling.0[j][i - 3],
                (false, false) => linear[i - 3][j - 3],
            })
        })
    }

    /// Returns the momentum of a twist: its moment part is angular momentum, its force part linear momentum.
    #[inline]
    pub fn times(&self, t: &Twist<S>) -> Wrench<S> {
        Wrench {
            moment: self.angular * t.angular + self.coupling * t.linear,
            force: self.coupling.transpose_times(t.angular) + self.linear * t.linear,
        }
    }

    /// Returns twice the kinetic energy, `v^T I v` (eq. 47, with the transpose that it needs).
    #[inline]
    pub fn quadratic(&self, t: &Twist<S>) -> S {
        self.times(t).dot(t)
    }

    /// Returns the inertia about the origin and in the axes of the parent frame.
    #[inline]
    pub fn to_parent(&self, e: &Frame<S>) -> Self {
        let r = &e.rotation;
        let linear = self.linear.rotated(r);
        let turned = *r * self.coupling * r.transpose();
        let s = hat(e.position);
        let coupling = turned + s * linear.to_matrix();
        let shift = coupling * s + (turned * s).transpose();
        let angular = self.angular.rotated(r).to_matrix() - shift;
        Self { angular: Symmetric3::from_upper(&angular), coupling, linear }
    }

    /// Returns `self - u u^T k`: an articulated inertia with one free joint direction.
    #[inline]
    pub fn minus_outer(&self, u: &Wrench<S>, k: S) -> Self {
        Self {
            angular: self.angular.minus_outer(u.moment, k),
            coupling: self.coupling - Matrix3::outer(u.moment, u.force * k),
            linear: self.linear.minus_outer(u.force, k),
        }
    }

    /// The twist that has this momentum: elimination with `I = L D L^T`, L with ones on its diagonal (Golub & Van
    /// Loan, *Matrix Computations*, 2013, sec. 4.1.2). First the linear part A, of whose equations `[C^T | p]` is on
    /// the right, then what remains of the angular part, `J - C A^-1 C^T`, with the coupling C.
    #[inline]
    pub fn solve(&self, p: &Wrench<S>) -> Twist<S> {
        let (pivots, c, f) = (Pivots::new(&self.linear), &self.coupling.0, &p.force.0);
        let column = |k: usize| [c[0][k], c[1][k], c[2][k], f[k]];
        let right = [column(0), column(1), column(2)];
        let reduced = pivots.forward(right);
        let scaled = pivots.scale(reduced);
        let j = self.angular.to_matrix().0;
        let row = |i: usize| {
            let row = [j[i][0], j[i][1], j[i][2], p.moment[i]];
            let row = minus(minus(row, reduced[0][i], scaled[0]), reduced[1][i], scaled[1]);
            minus(row, reduced[2][i], scaled[2])
        };
        let [[xx, xy, xz, mx], [_, yy, yz, my], [_, _, zz, mz]] = [row(0), row(1), row(2)];
        let angular_pivots = Pivots::new(&Symmetric3 { xx, xy, xz, yy, yz, zz });
        let [[mx], [my], [mz]] = angular_pivots.scale(angular_pivots.forward([[mx], [my], [mz]]));
        let angular = Vector3(angular_pivots.back([mx, my, mz]));
        let left = |[x, y, z, f]: [S; 4]| f - Vector3([x, y, z]).dot(angular);
        let linear = pivots.back([left(scaled[0]), left(scaled[1]), left(scaled[2])]);
        Twist { angular, linear: Vector3(linear) }
    }

    /// Returns whether this is a rigid body about its centre of mass, with the paper's block-diagonal M.
    pub fn is_rigid_about_centre_of_mass(&self) -> bool {
        let m = &self.linear;
        self.coupling == Matrix3::zero()
            && m.xx == m.yy
            && m.yy == m.zz
            && [m.xy, m.xz, m.yz].iter().all(|x| *x == S::ZERO)
    }
}

/// Factors `L D L^T` of a symmetric matrix.
struct Pivots<S> {
    /// Reciprocals of D.
    reciprocal: [S; 3],
    /// Entries (y, x), (z, x) and (z, y) of L.
    below: [S; 3],
}

impl<S: Scalar> Pivots<S> {
    #[inline]
    fn new(m: &Symmetric3<S>) -> Self {
        let first = S::ONE / m.xx;
        let (yx, zx) = (m.xy * first, m.xz * first);
        let second = S::ONE / (m.yy - yx * m.xy);
        let rest = m.yz - yx * m.xz;
        let zy = rest * second;
        let third = S::ONE / (m.zz - zx * m.xz - zy * rest);
        Self { reciprocal: [first, second, third], below: [yx, zx, zy] }
    }

    /// `L^-1 rows`.
    #[inline]
    fn forward<const K: usize>(&self, [x, y, z]: [[S; K]; 3]) -> [[S; K]; 3] {
        let [yx, zx, zy] = self.below;
        let y = minus(y, yx, x);
        [x, y, minus(minus(z, zx, x), zy, y)]
    }

    /// `D^-1 rows`.
    #[inline]
    fn scale<const K: usize>(&self, [x, y, z]: [[S; K]; 3]) -> [[S; K]; 3] {
        let [a, b, c] = self.reciprocal;
        [times(x, a), times(y, b), times(z, c)]
    }

    /// `L^-T v`.
    #[inline]
    fn back(&self, [x, y, z]: [S; 3]) -> [S; 3] {
        let [yx, zx, zy] = self.below;
        let y = y - zy * z;
        [x - zx * z - yx * y, y, z]
    }
}

/// `a - k b`, entry by entry.
#[inline]
fn minus<S: Scalar, const K: usize>(mut a: [S; K], k: S, b: [S; K]) -> [S; K] {
    for i in 0..K {
        a[i] -= k * b[i];
    }
    a
}

/// `k a`.
#[inline]
fn times<S: Scalar, const K: usize>(mut a: [S; K], k: S) -> [S; K] {
    for entry in &mut a {
        *entry = *entry * k;
    }
    a
}

impl<S: Scalar> Add for SpatialInertia<S> {
    type Output = Self;
    #[inline]
    fn add(self, b: Self) -> Self {
        Self { angular: self.angular + b.angular, coupling: self.coupling + b.coupling, linear: self.linear + b.linear }
    }
}

impl<S: Scalar> Sub for SpatialInertia<S> {
    type Output = Self;
    #[inline]
    fn sub(self, b: Self) -> Self {
        Self { angular: self.angular - b.angular, coupling: self.coupling - b.coupling, linear: self.linear - b.linear }
    }
}

impl<S: Scalar> AddAssign for SpatialInertia<S> {
    #[inline]
    fn add_assign(&mut self, b: Self) {
        *self = *self + b;
    }
}

impl Symmetric3<f64> {
    /// Returns whether these can be the moments of inertia of a body: the second moments of mass,
    /// `tr(J)/2 I - J`, must not be negative in any direction, which is the triangle inequality of the
    /// principal moments. A rod and a plate are at the limit; rounding is allowed.
    pub fn holds_triangle_inequality(&self) -> bool {
        let entries = [self.xx, self.xy, self.xz, self.yy, self.yz, self.zz];
        if !entries.iter().all(|x| x.is_finite()) {
            return false;
        }
        let largest = entries.iter().fold(f64::MIN_POSITIVE, |m, x| m.max(x.abs()));
        let [xx, xy, xz, yy, yz, zz] = entries.map(|x| x / largest);
        let half = 0.5 * (xx + yy + zz);
        let (a, b, c) = (half - xx, half - yy, half - zz);
        let minors = [a * b - xy * xy, a * c - xz * xz, b * c - yz * yz];
        let determinant = a * minors[2] - xy * (xy * c + yz * xz) - xz * (xy * yz + b * xz);
        // Tolerance for minors whose entries are at most 1: rounding of products of inertia with about 13
        // digits.
        let slack = -1e-12;
        [a, b, c, determinant].iter().chain(&minors).all(|x| *x >= slack)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spatial::{Vector3, exp};

    fn some_inertia() -> SpatialInertia {
        let a: [[f64; 6]; 6] = core::array::from_fn(|i| core::array::from_fn(|j| ((i * 7 + j * 3) as f64 * 0.9).sin()));
        let rows = core::array::from_fn(|i| {
            core::array::from_fn(|j| (0..6).map(|k| a[i][k] * a[j][k]).sum::<f64>() + if i == j { 3.0 } else { 0.0 })
        });
        SpatialInertia::from_rows(&rows)
    }

    #[test]
    fn kinetic_energy_does_not_depend_on_the_frame() {
        let e = Frame { rotation: exp(Vector3::new(0.4, -0.7, 1.1)), position: Vector3::new(1.0, 2.0, -0.5) };
        let parent = Twist { angular: Vector3::new(0.2, 0.5, -0.3), linear: Vector3::new(1.0, -2.0, 0.7) };
        let i = some_inertia();
        let (child, moved): (f64, f64) = (i.quadratic(&e.twist_to_child(&parent)), i.to_parent(&e).quadratic(&parent));
        assert!((child - moved).abs() < 1e-12 * child);
    }

    #[test]
    fn solve_inverts_times() {
        let t = Twist { angular: Vector3::new(0.2, 0.5, -0.3), linear: Vector3::new(1.0, -2.0, 0.7) };
        let i = some_inertia();
        let back = i.solve(&i.times(&t)) - t;
        assert!(back.angular.norm() + back.linear.norm() < 1e-13);
    }

    #[test]
    fn bodies_hold_the_triangle_inequality_however_slender_and_nothing_else_does() {
        let turn = exp(Vector3::new(0.3, 1.0, -0.8));
        let bodies = [[1.0, 2.0, 3.0], [0.0, 1349.006590147975, 1349.006590147975], [5e-5, 200.0, 200.0], [0.0; 3]];
        for moments in bodies.map(Symmetric3::diagonal) {
            assert!(moments.holds_triangle_inequality() && moments.rotated(&turn).holds_triangle_inequality());
        }
        for moments in [[1.0, 2.0, 3.1], [1e160, 1.0, 1.0], [-1.0, 1.0, 1.0], [f64::NAN, 1.0, 1.0]] {
            let moments = Symmetric3::diagonal(moments);
            assert!(!moments.holds_triangle_inequality() && !moments.rotated(&turn).holds_triangle_inequality());
        }
    }
}
