//! Unit quaternions (w, x, y, z), by which a state stores rotations.

use super::rotation::SERIES_LIMIT;
use super::{Matrix3, Vector3};
use crate::scalar::Scalar;

/// A unit quaternion, scalar part first; it converts body components to the parent's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quaternion<S = f64>(pub [S; 4]);

impl<S: Scalar> Quaternion<S> {
    /// Returns the quaternion without rotation.
    pub const fn identity() -> Self {
        Self([S::ONE, S::ZERO, S::ZERO, S::ZERO])
    }

    /// Reads (w, x, y, z).
    ///
    /// # Panics
    /// When the slice has fewer than four entries.
    #[inline]
    pub fn from_slice(q: &[S]) -> Self {
        Self([q[0], q[1], q[2], q[3]])
    }

    /// The quaternion of a rotation vector in radians, `exp(a / 2)`.
    #[inline]
    pub fn exp(a: Vector3<S>) -> Self {
        let c = S::constant;
        let x = a.norm_squared() * c(0.25);
        let w = x.select_below(
            SERIES_LIMIT,
            || c(1.0) - x * (c(0.5) - x * (c(1.0 / 24.0) - x * (c(1.0 / 720.0) - x * c(1.0 / 40320.0)))),
            || x.sqrt().sin_cos().1,
        );
        let sine_over_angle = x.select_below(
            SERIES_LIMIT,
            || c(1.0) - x * (c(1.0 / 6.0) - x * (c(1.0 / 120.0) - x * c(1.0 / 5040.0))),
            || x.sqrt().sin_cos().0 / x.sqrt(),
        );
        let k = sine_over_angle * c(0.5);
        Self([w, a[0] * k, a[1] * k, a[2] * k])
    }

    /// The rotation vector of a unit quaternion, of length at most pi, rad: `2 atan(|u| / w) u / |u|`
    /// with `u` = (x, y, z).
    pub fn log(self) -> Vector3<S> {
        let c = S::constant;
        let [w, x, y, z] = self.0;
        let sign = w.select_below(0.0, || -S::ONE, || S::ONE);
        let (w, u) = (w * sign, Vector3::new(x, y, z) * sign);
        let n2 = u.norm_squared();
        let scale = n2.select_below(
            SERIES_LIMIT,
            || {
                let t = n2 / (w * w);
                let rest = c(1.0 / 7.0) - t * (c(1.0 / 9.0) - t * c(1.0 / 11.0));
                (S::ONE - t * (c(1.0 / 3.0) - t * (c(1.0 / 5.0) - t * rest))) / w
            },
            || n2.sqrt().atan2(w) / n2.sqrt(),
        );
        u * (scale + scale)
    }

    /// Returns the quaternion product: the rotation by `b`, followed by that by `self`.
    #[inline]
    pub fn times(self, b: Self) -> Self {
        let ([p, x, y, z], [q, u, v, w]) = (self.0, b.0);
        Self([
            p * q - x * u - y * v - z * w,
            p * u + x * q + y * w - z * v,
            p * v - x * w + y * q + z * u,
            p * w + x * v - y * u + z * q,
        ])
    }

    /// Returns the quaternion scaled to unit length.
    #[inline]
    pub fn normalized(self) -> Self {
        let [w, x, y, z] = self.0;
        let k = S::ONE / (w * w + x * x + y * y + z * z).sqrt();
        let [w, x, y, z] = self.0;
        Self([w * k, x * k, y * k, z * k])
    }

    /// The rotation matrix of a unit quaternion.
    #[inline]
    pub fn to_matrix(self) -> Matrix3<S> {
        let [w, x, y, z] = self.0;
        let (x2, y2, z2) = (x + x, y + y, z + z);
        let (xx, xy, xz) = (x * x2, x * y2, x * z2);
        let (yy, yz, zz) = (y * y2, y * z2, z * z2);
        let (wx, wy, wz) = (w * x2, w * y2, w * z2);
        Matrix3([
            [S::ONE - (yy + zz), xy - wz, xz + wy],
            [xy + wz, S::ONE - (xx + zz), yz - wx],
            [xz - wy, yz + wx, S::ONE - (xx + yy)],
        ])
    }

    /// Returns the unit quaternion of a rotation matrix, with w >= 0, computed from its largest component
    /// (Shepperd 1978). Not for lanes, because their largest components can differ.
    pub fn from_matrix(r: &Matrix3<S>) -> Self {
        let (m, one) = (&r.0, S::ONE);
        let squares = [
            one + m[0][0] + m[1][1] + m[2][2],
            one + m[0][0] - m[1][1] - m[2][2],
            one - m[0][0] + m[1][1] - m[2][2],
            one - m[0][0] - m[1][1] + m[2][2],
        ];
        let greater = |a: usize, b: usize| squares[a].value() > squares[b].value();
        let largest = (1..4).fold(0, |best, i| if greater(i, best) { i } else { best });
        let [wx, wy, wz] = [m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]];
        let [xy, xz, yz] = [m[0][1] + m[1][0], m[0][2] + m[2][0], m[1][2] + m[2][1]];
        let products =
            [[squares[0], wx, wy, wz], [wx, squares[1], xy, xz], [wy, xy, squares[2], yz], [wz, xz, yz, squares[3]]];
        let quaternion = Self(products[largest]).normalized();
        if quaternion.0[0].value() < 0.0 { Self(quaternion.0.map(|x| -x)) } else { quaternion }
    }

    /// Returns the unit quaternion of intrinsic z-y-x angles in radians: rotation by yaw, then pitch, then
    /// roll.
    pub fn from_roll_pitch_yaw(angles: Vector3<S>) -> Self {
        let ([roll, pitch, yaw], o) = (angles.0, S::ZERO);
        let turn = |x, y, z| Self::exp(Vector3::new(x, y, z));
        turn(o, o, yaw).times(turn(o, pitch, o)).times(turn(roll, o, o))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spatial::exp;

    #[test]
    fn quaternion_and_matrix_exponentials_agree() {
        for v in [[0.3, -0.2, 0.5], [1e-3, 0.0, 2e-3], [0.05, 0.03, -0.02], [2.0, 1.0, -1.5]] {
            let (q, r) = (Quaternion::exp(Vector3(v)), exp(Vector3(v)));
            let difference = q.to_matrix() - r;
            assert!(difference.0.iter().flatten().all(|x: &f64| x.abs() < 1e-15));
            let back = Quaternion::from_matrix(&r);
            assert!((0..4).all(|i| (back.0[i] - q.0[i]).abs() < 1e-14));
        }
    }

    #[test]
    fn logarithm_undoes_the_exponential_whatever_the_sign_of_the_quaternion() {
        for v in [[0.3, -0.2, 0.5], [1e-9, 0.0, 2e-9], [0.05, 0.03, -0.02], [0.0; 3], [2.0, 1.0, -1.5]] {
            let q = Quaternion::exp(Vector3(v));
            for q in [q, Quaternion(q.0.map(|x| -x))] {
                assert!((q.log() - Vector3(v)).norm() < 1e-15 * 4.0);
            }
        }
    }

    #[test]
    fn product_of_quaternions_is_product_of_matrices() {
        let (a, b) = (Vector3::new(0.3, 0.9, -0.4), Vector3::new(-1.0, 0.2, 0.1));
        let both = Quaternion::exp(a).times(Quaternion::exp(b)).to_matrix();
        let difference = both - exp(a) * exp(b);
        assert!(difference.0.iter().flatten().all(|x: &f64| x.abs() < 1e-15));
    }
}
