//! The rotation group SO(3): hat and vee, exponential, logarithm and its differential.

use super::{Matrix3, Vector3};
use crate::scalar::Scalar;

/// Squared angle below which the coefficients are computed by their series; its truncation error is below
/// 1e-17.
pub(super) const SERIES_LIMIT: f64 = 1e-3;

/// Returns the skew matrix of a column, `hat(a) b = a x b` (eq. 8; the paper writes a double arrow).
#[inline]
pub fn hat<S: Scalar>(a: Vector3<S>) -> Matrix3<S> {
    let ([x, y, z], o) = (a.0, S::ZERO);
    Matrix3([[o, -z, y], [z, o, -x], [-y, x, o]])
}

/// Returns the column of a skew matrix, from its skew part (eq. 10).
#[inline]
pub fn vee<S: Scalar>(m: &Matrix3<S>) -> Vector3<S> {
    let (m, half) = (&m.0, S::constant(0.5));
    Vector3([(m[2][1] - m[1][2]) * half, (m[0][2] - m[2][0]) * half, (m[1][0] - m[0][1]) * half])
}

/// Rodrigues' formula, the exponential of eq. 63 by the Cayley-Hamilton theorem:
/// `exp(hat(a)) = I + sin(t)/t hat(a) + (1 - cos(t))/t^2 hat(a)^2` with `t = |a|` in radians.
///
/// ```
/// use kingpost::spatial::{exp, Vector3};
/// let quarter_turn = exp(Vector3::new(0.0, 0.0, core::f64::consts::FRAC_PI_2));
/// let y = quarter_turn * Vector3::new(1.0, 0.0, 0.0);
/// assert!((y - Vector3::new(0.0, 1.0, 0.0)).norm() < 1e-15);
/// ```
pub fn exp<S: Scalar>(a: Vector3<S>) -> Matrix3<S> {
    let (sine, one_minus_cosine) = rodrigues_coefficients(a.norm_squared());
    let skew = hat(a);
    Matrix3::identity() + skew.scaled(sine) + (skew * skew).scaled(one_minus_cosine)
}

/// Returns `sin(t)/t` and `(1 - cos(t))/t^2` from `t^2`.
#[inline]
fn rodrigues_coefficients<S: Scalar>(t2: S) -> (S, S) {
    let c = S::constant;
    let sine = t2.select_below(
        SERIES_LIMIT,
        || c(1.0) - t2 * (c(1.0 / 6.0) - t2 * (c(1.0 / 120.0) - t2 * c(1.0 / 5040.0))),
        || t2.sqrt().sin_cos().0 / t2.sqrt(),
    );
    let one_minus_cosine = t2.select_below(
        SERIES_LIMIT,
        || c(0.5) - t2 * (c(1.0 / 24.0) - t2 * (c(1.0 / 720.0) - t2 * c(1.0 / 40320.0))),
        || (S::ONE - t2.sqrt().sin_cos().1) / t2,
    );
    (sine, one_minus_cosine)
}

/// Returns the logarithm of a rotation matrix: the rotation vector with an angle in [0, pi] rad.
pub fn log(r: &Matrix3<f64>) -> Vector3<f64> {
    let sine_axis = vee(r);
    let cosine = 0.5 * (r.0[0][0] + r.0[1][1] + r.0[2][2] - 1.0);
    let sine = sine_axis.norm();
    let angle = libm::atan2(sine, cosine);
    if cosine > -0.9 {
        // angle / sine - 1 is sine^2 / 6, which is below rounding.
        let scale = if sine < 1e-8 { 1.0 } else { angle / sine };
        return sine_axis * scale;
    }
    // Near half a turn the skew part vanishes, but the symmetric part contains the axis.
    let squares: [f64; 3] = core::array::from_fn(|i| ((r.0[i][i] - cosine) / (1.0 - cosine)).max(0.0));
    let largest = (0..3).fold(0, |best, i| if squares[i] > squares[best] { i } else { best });
    let pivot = libm::sqrt(squares[largest]);
    let axis = Vector3(core::array::from_fn(|j| {
        let symmetric = 0.5 * (r.0[largest][j] + r.0[j][largest]);
        if j == largest { pivot } else { symmetric / ((1.0 - cosine) * pivot) }
    }));
    let sign = if axis.dot(sine_axis) < 0.0 { -1.0 } else { 1.0 };
    axis * (sign * angle / axis.norm())
}

/// Computes the logarithm of a rotation well below half a turn, with derivatives: `t / sin(t)` times the skew
/// part.
pub fn log_of_part_turn<S: Scalar>(r: &Matrix3<S>) -> Vector3<S> {
    let (sine_axis, c) = (vee(r), S::constant);
    let square = sine_axis.norm_squared();
    let cosine = (r.0[0][0] + r.0[1][1] + r.0[2][2] - S::ONE) * c(0.5);
    let scale = square.select_below(
        SERIES_LIMIT,
        || {
            c(1.0)
                + square
                    * (c(1.0 / 6.0)
                        + square * (c(3.0 / 40.0) + square * (c(15.0 / 336.0) + square * c(105.0 / 3456.0))))
        },
        || square.sqrt().atan2(cosine) / square.sqrt(),
    );
    sine_axis * scale
}

/// Returns the rate of the rotation vector `a` if `R = R0 exp(hat(a))` rotates with the angular velocity
/// `omega` in body components: `a' = omega + a x omega / 2 + c a x (a x omega)` with `c = (1 - t/2 cot(t/2))
/// / t^2` (Munthe-Kaas 1998; Iserles et al. 2000, eq. B.11, in body form).
pub fn dexp_inverse_body<S: Scalar>(a: Vector3<S>, omega: Vector3<S>) -> Vector3<S> {
    let c = S::constant;
    let t2 = a.norm_squared();
    let series = || c(1.0 / 12.0) + t2 * (c(1.0 / 720.0) + t2 * (c(1.0 / 30240.0) + t2 * c(1.0 / 1_209_600.0)));
    let closed = || {
        let half = t2.sqrt() * c(0.5);
        let (sin, cos) = half.sin_cos();
        (S::ONE - half * cos / sin) / t2
    };
    let coefficient = t2.select_below(SERIES_LIMIT, series, closed);
    let first = a.cross(omega);
    omega + first * c(0.5) + a.cross(first) * coefficient
}

/// Returns the rotation matrix of roll about x, pitch about y and yaw about z, intrinsic z-y-x, in radians:
/// `R = Rz(yaw) Ry(pitch) Rx(roll)`.
pub fn rotation_from_roll_pitch_yaw<S: Scalar>(roll_pitch_yaw: Vector3<S>) -> Matrix3<S> {
    let ([roll, pitch, yaw], o) = (roll_pitch_yaw.0, S::ZERO);
    exp(Vector3::new(o, o, yaw)) * exp(Vector3::new(o, pitch, o)) * exp(Vector3::new(roll, o, o))
}

/// Returns roll, pitch and yaw in radians of a rotation matrix; pitch in [-pi/2, pi/2].
pub fn roll_pitch_yaw<S: Scalar>(r: &Matrix3<S>) -> Vector3<S> {
    let m = &r.0;
    let roll = m[2][1].atan2(m[2][2]);
    let pitch = (-m[2][0]).atan2((m[0][0] * m[0][0] + m[1][0] * m[1][0]).sqrt());
    let yaw = m[1][0].atan2(m[0][0]);
    Vector3::new(roll, pitch, yaw)
}

#[cfg(test)]
mod tests {
    use super::*;

    const VECTORS: [[f64; 3]; 4] = [[0.3, -0.2, 0.5], [1e-4, 2e-4, -1e-4], [2.0, 1.0, -1.5], [0.02, -0.01, 0.022]];

    fn distance(a: &Matrix3, b: &Matrix3) -> f64 {
        (*a - *b).0.iter().flatten().fold(0.0, |m: f64, x| m.max(x.abs()))
    }

    #[test]
    fn exponential_is_a_rotation_and_the_logarithm_undoes_it() {
        for v in VECTORS {
            let a = Vector3(v);
            let r = exp(a);
            assert!(distance(&(r * r.transpose()), &Matrix3::identity()) < 1e-15);
            assert!((r.determinant() - 1.0).abs() < 1e-15);
            assert!((log(&r) - a).norm() < 1e-14);
            assert!((log_of_part_turn(&r) - a).norm() < 1e-14);
        }
    }

    #[test]
    fn logarithm_holds_near_half_a_turn() {
        for angle in [3.0, 3.1, core::f64::consts::PI - 1e-9] {
            let a = Vector3::new(0.6, -0.64, 0.48) * angle;
            assert!((log(&exp(a)) - a).norm() < 1e-7);
        }
    }

    #[test]
    fn the_rotation_vector_rate_agrees_with_the_body_rate_by_differences() {
        let omega = Vector3::new(0.7, -1.1, 0.4);
        for v in VECTORS {
            let (a, h) = (Vector3(v), 1e-5);
            let rate = dexp_inverse_body(a, omega);
            let r_dot = (exp(a + rate * h) - exp(a - rate * h)).scaled(0.5 / h);
            let measured = vee(&(exp(a).transpose() * r_dot));
            assert!((measured - omega).norm() < 1e-9, "{a:?}: {measured:?}");
        }
    }

    #[test]
    fn roll_pitch_yaw_round_trip() {
        let angles = Vector3::new(0.4, -1.2, 2.8);
        assert!((roll_pitch_yaw(&rotation_from_roll_pitch_yaw(angles)) - angles).norm() < 1e-14);
    }
}
