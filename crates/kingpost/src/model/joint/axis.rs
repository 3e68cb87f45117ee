//! One elementary axis; joints of several axes are lists of such axes.

use super::MotionType;
use crate::scalar::Scalar;
use crate::spatial::{Frame, Matrix3, Twist, Vector3, hat};

/// Motion of an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AxisMotion {
    /// Rotation: the coordinate is an angle, rad.
    Rotation,
    /// Translation: the coordinate is a displacement, m.
    Translation,
}

/// A rotation about, or a translation along, a unit vector in the frame after the preceding axes.
#[derive(Clone, Copy, Debug)]
pub struct ElementaryAxis<S = f64> {
    /// Rotation or translation.
    pub motion: AxisMotion,
    /// Unit vector.
    pub direction: Vector3<S>,
    /// How the acceleration of its coordinate is determined.
    pub mode: MotionType,
}

impl<S: Scalar> ElementaryAxis<S> {
    /// Creates a free rotation about the unit vector `direction`.
    pub fn rotation(direction: Vector3<S>) -> Self {
        Self { motion: AxisMotion::Rotation, direction, mode: MotionType::Free }
    }

    /// Creates a free translation along the unit vector `direction`.
    pub fn translation(direction: Vector3<S>) -> Self {
        Self { motion: AxisMotion::Translation, direction, mode: MotionType::Free }
    }

    /// Returns the frame after the axis relative to the frame before it, at a coordinate in rad or m; a
    /// rotation by Rodrigues' formula, `R = e e^T + sin(q) hat(e) + cos(q) (I - e e^T)`.
    pub fn frame(&self, q: S) -> Frame<S> {
        let e = self.direction;
        match self.motion {
            AxisMotion::Rotation => {
                let ((sin, cos), along) = (q.sin_cos(), Matrix3::outer(e, e));
                let rotation = along + hat(e).scaled(sin) + (Matrix3::identity() - along).scaled(cos);
                Frame { rotation, position: Vector3::zero() }
            }
            AxisMotion::Translation => Frame::translation(e * q),
        }
    }

    /// Returns the twist per unit rate of the frame after the axis, about its origin, in its axes.
    pub fn twist(&self) -> Twist<S> {
        match self.motion {
            AxisMotion::Rotation => Twist { angular: self.direction, linear: Vector3::zero() },
            AxisMotion::Translation => Twist { angular: Vector3::zero(), linear: self.direction },
        }
    }
}
