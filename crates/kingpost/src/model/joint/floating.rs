//! A body that moves freely relative to the world, such as the ship (eqs. 3, 14).

use super::{Columns, MotionType};
use crate::scalar::Scalar;
use crate::spatial::{Frame, Quaternion, Twist, Vector3, dexp_inverse_body};

/// q: position of the centre of mass (world, m), unit quaternion (w, x, y, z).
/// v: velocity of the centre of mass (world, m/s), angular velocity (body axes, rad/s).
/// Either half can be held.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Floating {
    /// Whether the centre of mass is held at rest (the paper's first pass).
    pub hold_translation: bool,
    /// Whether the rotation is held.
    pub hold_rotation: bool,
}

impl Floating {
    /// Names of the six coordinates of v. The last three are body rates, which are not derivatives of angles.
    pub const LABELS: [&'static str; 6] = ["x", "y", "z", "roll", "pitch", "yaw"];

    /// Returns the mode of each of the six coordinates.
    pub fn modes(&self) -> [MotionType; 6] {
        let mode = |held| if held { MotionType::Held } else { MotionType::Free };
        core::array::from_fn(|i| mode(if i < 3 { self.hold_translation } else { self.hold_rotation }))
    }

    /// Absolute frame connection matrix (eq. 20).
    #[inline]
    pub fn relative<S: Scalar>(q: &[S]) -> Frame<S> {
        let q = &q[..7];
        Frame { rotation: Quaternion::from_slice(&q[3..7]).to_matrix(), position: Vector3::from_slice(q) }
    }

    /// The twist in body components of the velocity `v`.
    #[inline]
    pub fn twist<S: Scalar>(frame: &Frame<S>, v: &[S]) -> Twist<S> {
        let v = &v[..6];
        Twist { angular: Vector3::from_slice(&v[3..6]), linear: frame.rotation.transpose_times(Vector3::from_slice(v)) }
    }

    /// The twist in body components per unit rate of each coordinate.
    pub fn columns<S: Scalar>(frame: &Frame<S>) -> Columns<S> {
        let mut columns = Columns::new(6);
        for k in 0..3 {
            columns[k].linear = frame.rotation.row(k);
            columns[k + 3].angular[k] = S::ONE;
        }
        columns
    }

    /// Returns the rates of the columns: a direction that is fixed in the world rotates relative to the body,
    /// by `-omega x`.
    pub fn column_rates<S: Scalar>(columns: &Columns<S>, omega: Vector3<S>) -> Columns<S> {
        let mut rates = Columns::new(6);
        for k in 0..3 {
            rates[k].linear = columns[k].linear.cross(omega);
        }
        rates
    }

    /// Moves the position by a sum, and the rotation by multiplication with the exponential of the local
    /// rotation vector.
    #[inline]
    pub fn retract<S: Scalar>(q: &[S], xi: &[S], out: &mut [S]) {
        let (q, xi, out) = (&q[..7], &xi[..6], &mut out[..7]);
        (Vector3::from_slice(q) + Vector3::from_slice(xi)).write_to(out);
        let turn = Quaternion::exp(Vector3::from_slice(&xi[3..6]));
        let turned = Quaternion::from_slice(&q[3..7]).times(turn).normalized();
        out[3..7].copy_from_slice(&turned.0);
    }

    /// Rate of the local coordinates.
    #[inline]
    pub fn dexp_inverse<S: Scalar>(xi: &[S], v: &[S], out: &mut [S]) {
        let (xi, v, out) = (&xi[..6], &v[..6], &mut out[..6]);
        out[..3].copy_from_slice(&v[..3]);
        dexp_inverse_body(Vector3::from_slice(&xi[3..6]), Vector3::from_slice(&v[3..6])).write_to(&mut out[3..6]);
    }
}
