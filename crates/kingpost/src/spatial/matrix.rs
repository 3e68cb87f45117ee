//! 3x3 matrices, general and symmetric.

use super::Vector3;
use crate::scalar::Scalar;
use core::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

/// A 3x3 matrix by rows.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Matrix3<S = f64>(pub [[S; 3]; 3]);

impl<S: Scalar> Matrix3<S> {
    /// The zero matrix.
    #[inline]
    pub const fn zero() -> Self {
        Self([[S::ZERO; 3]; 3])
    }

    /// The identity.
    #[inline]
    pub const fn identity() -> Self {
        let (o, l) = (S::ZERO, S::ONE);
        Self([[l, o, o], [o, l, o], [o, o, l]])
    }

    /// Returns the matrix whose entry in row i and column j is `f(i, j)`.
    #[inline]
    pub fn from_fn(mut f: impl FnMut(usize, usize) -> S) -> Self {
        let mut m = Self::zero();
        for i in 0..3 {
            for j in 0..3 {
                m.0[i][j] = f(i, j);
            }
        }
        m
    }

    /// Row `i` as a column.
    #[inline]
    pub fn row(&self, i: usize) -> Vector3<S> {
        Vector3(self.0[i])
    }

    /// Column `j`.
    #[inline]
    pub fn column(&self, j: usize) -> Vector3<S> {
        Vector3([self.0[0][j], self.0[1][j], self.0[2][j]])
    }

    /// The transpose; for a rotation matrix, its inverse.
    #[inline]
    pub fn transpose(&self) -> Self {
        let m = &self.0;
        Self([[m[0][0], m[1][0], m[2][0]], [m[0][1], m[1][1], m[2][1]], [m[0][2], m[1][2], m[2][2]]])
    }

    /// `transpose(self) * v` without forming the transpose.
    #[inline]
    pub fn transpose_times(&self, v: Vector3<S>) -> Vector3<S> {
        let (m, v) = (&self.0, v.0);
        Vector3([
            m[0][0] * v[0] + m[1][0] * v[1] + m[2][0] * v[2],
            m[0][1] * v[0] + m[1][1] * v[1] + m[2][1] * v[2],
            m[0][2] * v[0] + m[1][2] * v[1] + m[2][2] * v[2],
        ])
    }

    /// The matrix times a scalar.
    #[inline]
    pub fn scaled(&self, k: S) -> Self {
        Self([(self.row(0) * k).0, (self.row(1) * k).0, (self.row(2) * k).0])
    }

    /// Outer product `a b^T`.
    #[inline]
    pub fn outer(a: Vector3<S>, b: Vector3<S>) -> Self {
        let ([a0, a1, a2], [b0, b1, b2]) = (a.0, b.0);
        Self([[a0 * b0, a0 * b1, a0 * b2], [a1 * b0, a1 * b1, a1 * b2], [a2 * b0, a2 * b1, a2 * b2]])
    }

    /// Returns a rotation matrix whose last column is the unit vector `z`; exactly a permutation if `z` is
    /// along an axis.
    ///
    /// The first column is along the component perpendicular to z of an axis: the axis after that of the
    /// largest entry of z, in the cyclic order x, y, z.
    pub fn with_z(z: Vector3<S>) -> Self {
        let ([a, b, c], one) = (z.0.map(|x| x * x), || S::ONE);
        // In each lane: 1 for the largest entry; for equal entries the later one.
        let x_largest = b.select_less(a, || c.select_less(a, one, || S::ZERO), || S::ZERO);
        let z_largest = c.select_less(b, || S::ZERO, || S::ONE - x_largest);
        let next = Vector3([z_largest, x_largest, S::ONE - x_largest - z_largest]);
        let across = next - z * z.dot(next);
        let x = across * (S::ONE / across.norm());
        let y = z.cross(x);
        Self([[x[0], y[0], z[0]], [x[1], y[1], z[1]], [x[2], y[2], z[2]]])
    }

    /// Returns `self Rz(angle)`: the frame whose axes are the columns, rotated about its own z.
    #[inline]
    pub fn turned_about_z(&self, (sin, cos): (S, S)) -> Self {
        let turned = |[x, y, z]: [S; 3]| [x * cos + y * sin, y * cos - x * sin, z];
        Self([turned(self.0[0]), turned(self.0[1]), turned(self.0[2])])
    }

    /// Returns the inverse, by cofactors; entries are not finite if the matrix is singular.
    #[inline]
    pub fn inverse(&self) -> Self {
        let [a, b, c] = [self.row(0), self.row(1), self.row(2)];
        let cofactors = [b.cross(c), c.cross(a), a.cross(b)];
        let k = S::ONE / a.dot(cofactors[0]);
        Self::from_fn(|i, j| cofactors[j][i] * k)
    }

    /// Determinant.
    #[inline]
    pub fn determinant(&self) -> S {
        self.row(0).dot(self.row(1).cross(self.row(2)))
    }
}

impl<S: Scalar> Mul<Vector3<S>> for Matrix3<S> {
    type Output = Vector3<S>;
    #[inline]
    fn mul(self, v: Vector3<S>) -> Vector3<S> {
        Vector3([self.row(0).dot(v), self.row(1).dot(v), self.row(2).dot(v)])
    }
}

impl<S: Scalar> Mul for Matrix3<S> {
    type Output = Self;
    #[inline]
    fn mul(self, b: Self) -> Self {
        Self([b.transpose_times(self.row(0)).0, b.transpose_times(self.row(1)).0, b.transpose_times(self.row(2)).0])
    }
}

impl<S: Scalar> Add for Matrix3<S> {
    type Output = Self;
    #[inline]
    fn add(self, b: Self) -> Self {
        Self([(self.row(0) + b.row(0)).0, (self.row(1) + b.row(1)).0, (self.row(2) + b.row(2)).0])
    }
}

impl<S: Scalar> AddAssign for Matrix3<S> {
    #[inline]
    fn add_assign(&mut self, b: Self) {
        *self = *self + b;
    }
}

impl<S: Scalar> SubAssign for Matrix3<S> {
    #[inline]
    fn sub_assign(&mut self, b: Self) {
        *self = *self - b;
    }
}

impl<S: Scalar> Sub for Matrix3<S> {
    type Output = Self;
    #[inline]
    fn sub(self, b: Self) -> Self {
        Self([(self.row(0) - b.row(0)).0, (self.row(1) - b.row(1)).0, (self.row(2) - b.row(2)).0])
    }
}

impl<S: Scalar> Neg for Matrix3<S> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self([(-self.row(0)).0, (-self.row(1)).0, (-self.row(2)).0])
    }
}

/// A symmetric 3x3 matrix: the entries xx, xy, xz, yy, yz, zz.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Symmetric3<S = f64> {
    /// Entry (x, x).
    pub xx: S,
    /// Entries (x, y) and (y, x).
    pub xy: S,
    /// Entries (x, z) and (z, x).
    pub xz: S,
    /// Entry (y, y).
    pub yy: S,
    /// Entries (y, z) and (z, y).
    pub yz: S,
    /// Entry (z, z).
    pub zz: S,
}

impl<S: Scalar> Symmetric3<S> {
    /// The plain values, derivatives dropped.
    pub fn values(&self) -> Symmetric3<f64> {
        let Self { xx, xy, xz, yy, yz, zz } = self;
        let [xx, xy, xz, yy, yz, zz] = [xx, xy, xz, yy, yz, zz].map(|x| x.value());
        Symmetric3 { xx, xy, xz, yy, yz, zz }
    }

    /// The diagonal matrix of `d`.
    #[inline]
    pub fn diagonal(d: [S; 3]) -> Self {
        Self { xx: d[0], yy: d[1], zz: d[2], ..Self::default() }
    }

    /// The symmetric part of a matrix that is symmetric up to rounding: its upper triangle.
    #[inline]
    pub fn from_upper(m: &Matrix3<S>) -> Self {
        let m = &m.0;
        Self { xx: m[0][0], xy: m[0][1], xz: m[0][2], yy: m[1][1], yz: m[1][2], zz: m[2][2] }
    }

    /// Returns the matrix in full.
    #[inline]
    pub fn to_matrix(self) -> Matrix3<S> {
        Matrix3([[self.xx, self.xy, self.xz], [self.xy, self.yy, self.yz], [self.xz, self.yz, self.zz]])
    }

    /// Returns the congruence `R S R^T`: the tensor in a frame rotated by R.
    #[inline]
    pub fn rotated(self, r: &Matrix3<S>) -> Self {
        let rs = *r * self.to_matrix();
        let entry = |i: usize, j: usize| rs.row(i).dot(r.row(j));
        Self { xx: entry(0, 0), xy: entry(0, 1), xz: entry(0, 2), yy: entry(1, 1), yz: entry(1, 2), zz: entry(2, 2) }
    }

    /// `R D R^T` with the diagonal matrix D of principal moments.
    #[inline]
    pub fn of_principal(moments: [S; 3], r: &Matrix3<S>) -> Self {
        let [a, b, c] = moments;
        let row = |i: usize| Vector3([r.0[i][0] * a, r.0[i][1] * b, r.0[i][2] * c]);
        let rd = [row(0), row(1), row(2)];
        let entry = |i: usize, j: usize| rd[i].dot(r.row(j));
        Self { xx: entry(0, 0), xy: entry(0, 1), xz: entry(0, 2), yy: entry(1, 1), yz: entry(1, 2), zz: entry(2, 2) }
    }

    /// `self - u u^T k`, the rank-one downdate of the articulated inertia.
    #[inline]
    pub fn minus_outer(self, u: Vector3<S>, k: S) -> Self {
        let [a, b, c] = u.0;
        let (ka, kb, kc) = (a * k, b * k, c * k);
        Self {
            xx: self.xx - ka * a,
            xy: self.xy - ka * b,
            xz: self.xz - ka * c,
            yy: self.yy - kb * b,
            yz: self.yz - kb * c,
            zz: self.zz - kc * c,
        }
    }

    /// Returns the inverse, by cofactors; entries are not finite if the matrix is singular.
    #[inline]
    pub fn inverse(self) -> Self {
        let Self { xx, xy, xz, yy, yz, zz } = self;
        let (cxx, cxy, cxz) = (yy * zz - yz * yz, xz * yz - xy * zz, xy * yz - xz * yy);
        let k = S::ONE / (xx * cxx + xy * cxy + xz * cxz);
        Self {
            xx: cxx * k,
            xy: cxy * k,
            xz: cxz * k,
            yy: (xx * zz - xz * xz) * k,
            yz: (xy * xz - xx * yz) * k,
            zz: (xx * yy - xy * xy) * k,
        }
    }
}

impl<S: Scalar> Mul<Vector3<S>> for Symmetric3<S> {
    type Output = Vector3<S>;
    #[inline]
    fn mul(self, v: Vector3<S>) -> Vector3<S> {
        let [x, y, z] = v.0;
        Vector3([
            self.xx * x + self.xy * y + self.xz * z,
            self.xy * x + self.yy * y + self.yz * z,
            self.xz * x + self.yz * y + self.zz * z,
        ])
    }
}

impl<S: Scalar> Add for Symmetric3<S> {
    type Output = Self;
    #[inline]
    fn add(self, b: Self) -> Self {
        Self {
            xx: self.xx + b.xx,
            xy: self.xy + b.xy,
            xz: self.xz + b.xz,
            yy: self.yy + b.yy,
            yz: self.yz + b.yz,
            zz: self.zz + b.zz,
        }
    }
}

impl<S: Scalar> Sub for Symmetric3<S> {
    type Output = Self;
    #[inline]
    fn sub(self, b: Self) -> Self {
        Self {
            xx: self.xx - b.xx,
            xy: self.xy - b.xy,
            xz: self.xz - b.xz,
            yy: self.yy - b.yy,
            yz: self.yz - b.yz,
            zz: self.zz - b.zz,
        }
    }
}

impl<S: Scalar> AddAssign for Symmetric3<S> {
    #[inline]
    fn add_assign(&mut self, b: Self) {
        *self = *self + b;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spatial::exp;

    #[test]
    fn a_frame_with_z_along_an_axis_is_a_permutation_and_otherwise_a_rotation() {
        for (k, sign) in [(0, 1.0), (1, 1.0), (2, 1.0), (0, -1.0), (1, -1.0), (2, -1.0)] {
            let z = Vector3(core::array::from_fn(|i| if i == k { sign } else { 0.0 }));
            let r = Matrix3::with_z(z);
            assert_eq!((r.column(2), r.determinant()), (z, 1.0));
            assert!(r.0.iter().flatten().all(|x: &f64| [0.0, 1.0].contains(&x.abs())));
        }
        let turn = exp(Vector3::new(0.4, -0.7, 1.1));
        // Tolerance of a few units in the last place, like the error of the length of z.
        for z in [turn.column(0), turn.column(1), turn.column(2), Vector3::new(1.0, 1.0, 1.0) * (1.0 / 3.0_f64.sqrt())]
        {
            let r = Matrix3::with_z(z);
            let difference = r * r.transpose() - Matrix3::identity();
            assert!(difference.0.iter().flatten().all(|x: &f64| x.abs() < 1e-15));
            assert!((r.determinant() - 1.0_f64).abs() < 1e-15 && (r.column(2) - z).norm() < 1e-16);
        }
    }

    #[test]
    fn the_inverse_of_a_matrix_times_the_matrix_is_the_identity() {
        let matrix = exp(Vector3::new(0.4, -0.7, 1.1))
            + Matrix3::outer(Vector3::new(1.0, 2.0, 3.0), Vector3::new(0.5, -1.0, 2.0));
        let difference = matrix.inverse() * matrix - Matrix3::identity();
        // A few units in the last place times the condition of the matrix, about 10.
        assert!(difference.0.iter().flatten().all(|x: &f64| x.abs() < 1e-14));
    }

    #[test]
    fn turning_columns_is_a_product_with_a_rotation_about_z() {
        let (r, angle) = (exp(Vector3::new(0.4, -0.7, 1.1)), 0.8_f64);
        let difference = r.turned_about_z(Scalar::sin_cos(angle)) - r * exp(Vector3::new(0.0, 0.0, angle));
        assert!(difference.0.iter().flatten().all(|x: &f64| x.abs() < 4e-16));
    }

    #[test]
    fn principal_moments_turn_like_a_diagonal_matrix() {
        let r = exp(Vector3::new(0.4, -0.7, 1.1));
        let moments = [3.0, 0.0, 5.0];
        assert_eq!(Symmetric3::of_principal(moments, &r), Symmetric3::diagonal(moments).rotated(&r));
    }
}
