//! Inertia of a rigid body in ten numbers.

use super::{Frame, Matrix3, SpatialInertia, Symmetric3, Twist, Vector3, Wrench, hat};
use crate::scalar::Scalar;
use core::ops::Add;

/// Mass, first moment and moments of inertia about a frame's origin: a compact form of a rigid body's
/// [`SpatialInertia`], at a third of the cost.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RigidInertia<S = f64> {
    /// Mass, kg.
    pub mass: S,
    /// Mass times the centre of mass, kg m.
    pub first_moment: Vector3<S>,
    /// Moments of inertia about the origin, kg m^2.
    pub moments: Symmetric3<S>,
}

impl<S: Scalar> SpatialInertia<S> {
    /// Returns the sum with the inertia of a rigid body about the same origin.
    #[inline]
    pub fn plus_rigid(&self, rigid: &RigidInertia<S>) -> Self {
        let ([x, y, z], [p, q, r], m) = (rigid.first_moment.0, self.coupling.0, rigid.mass);
        let Symmetric3 { xx, yy, zz, .. } = self.linear;
        Self {
            angular: self.angular + rigid.moments,
            coupling: Matrix3([[p[0], p[1] - z, p[2] + y], [q[0] + z, q[1], q[2] - x], [r[0] - y, r[1] + x, r[2]]]),
            linear: Symmetric3 { xx: xx + m, yy: yy + m, zz: zz + m, ..self.linear },
        }
    }
}

impl<S: Scalar> RigidInertia<S> {
    /// Returns the ten numbers of a 6x6 inertia; `None` if it is not that of a rigid body.
    pub fn from_spatial(inertia: &SpatialInertia<S>) -> Option<Self> {
        let (mass, c) = (inertia.linear.xx, &inertia.coupling.0);
        let first_moment = Vector3::new(c[2][1], c[0][2], c[1][0]);
        let rigid = Self { mass, first_moment, moments: inertia.angular };
        let same = rigid.to_spatial();
        (same.coupling == inertia.coupling && same.linear == inertia.linear).then_some(rigid)
    }

    /// Returns the inertia of a body whose centre of mass is at `centre`, m, from the moments about the
    /// centre of mass: Steiner's theorem.
    #[inline]
    pub fn of_centre(mass: S, centre: Vector3<S>, moments: &Symmetric3<S>) -> Self {
        let first_moment = centre * mass;
        let ([x, y, z], [mx, my, mz]) = (centre.0, first_moment.0);
        let (xx, yy, zz) = (mx * x, my * y, mz * z);
        let moments = Symmetric3 {
            xx: moments.xx + (yy + zz),
            xy: moments.xy - mx * y,
            xz: moments.xz - mx * z,
            yy: moments.yy + (xx + zz),
            yz: moments.yz - my * z,
            zz: moments.zz + (xx + yy),
        };
        Self { mass, first_moment, moments }
    }

    /// Returns the inertia in full.
    #[inline]
    pub fn to_spatial(&self) -> SpatialInertia<S> {
        SpatialInertia {
            angular: self.moments,
            coupling: hat(self.first_moment),
            linear: Symmetric3::diagonal([self.mass; 3]),
        }
    }

    /// Momentum of a twist.
    #[inline]
    pub fn times(&self, t: &Twist<S>) -> Wrench<S> {
        Wrench {
            moment: self.moments * t.angular + self.first_moment.cross(t.linear),
            force: t.linear * self.mass - self.first_moment.cross(t.angular),
        }
    }

    /// Returns the inertia about the origin and in the axes of the parent frame, by Steiner's theorem.
    #[inline]
    pub fn to_parent(&self, e: &Frame<S>) -> Self {
        let (x, turned) = (e.position, e.rotation * self.first_moment);
        let y = turned + x * (self.mass * S::constant(0.5));
        let twice = x.dot(y) + x.dot(y);
        let products = Matrix3::outer(x, y);
        let moments = self.moments.rotated(&e.rotation);
        let entry = |i: usize, j: usize| products.0[i][j] + products.0[j][i];
        Self {
            mass: self.mass,
            first_moment: turned + x * self.mass,
            moments: Symmetric3 {
                xx: moments.xx + twice - entry(0, 0),
                xy: moments.xy - entry(0, 1),
                xz: moments.xz - entry(0, 2),
                yy: moments.yy + twice - entry(1, 1),
                yz: moments.yz - entry(1, 2),
                zz: moments.zz + twice - entry(2, 2),
            },
        }
    }
}

impl<S: Scalar> Add for RigidInertia<S> {
    type Output = Self;
    #[inline]
    fn add(self, b: Self) -> Self {
        Self {
            mass: self.mass + b.mass,
            first_moment: self.first_moment + b.first_moment,
            moments: self.moments + b.moments,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spatial::exp;

    #[test]
    fn ten_numbers_move_like_the_full_inertia() {
        let moments = Symmetric3 { xx: 5.0, xy: 0.3, xz: -0.2, yy: 4.0, yz: 0.5, zz: 3.0 };
        let centred = SpatialInertia::rigid(7.0, moments);
        let away = Frame { rotation: exp(Vector3::new(0.2, 0.1, -0.9)), position: Vector3::new(0.5, -1.0, 2.0) };
        let e = Frame { rotation: exp(Vector3::new(0.4, -0.7, 1.1)), position: Vector3::new(1.0, 2.0, -0.5) };
        let twist = Twist { angular: Vector3::new(0.2, 0.5, -0.3), linear: Vector3::new(1.0, -2.0, 0.7) };
        let rigid = RigidInertia::from_spatial(&centred).unwrap().to_parent(&away);
        let full = centred.to_parent(&away);
        for (rigid, full) in [(rigid, full), (rigid.to_parent(&e), full.to_parent(&e))] {
            let difference = rigid.times(&twist) - full.times(&twist);
            assert!(difference.moment.norm() + difference.force.norm() < 1e-13);
        }
    }

    #[test]
    fn an_inertia_that_is_not_rigid_is_not_accepted_as_rigid() {
        let mut inertia = SpatialInertia::rigid(7.0, Symmetric3::diagonal([5.0, 4.0, 3.0]));
        inertia.linear.yy = 8.0;
        assert_eq!(RigidInertia::from_spatial(&inertia), None);
    }
}
