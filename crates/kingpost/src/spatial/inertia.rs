//! The 6x6 inertia of a body.

use super::{Frame, Matrix3, Symmetric3, Twist, Vector3, Wrench, hat};
use crate::scalar::Scalar;
use core::ops::{Add, AddAssign};

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
    /// Angular momentum per velocity, kg m.
    pub coupling: Matrix3<S>,
    /// Mass, direction by direction, kg.
    pub linear: Symmetric3<S>,
}

impl<S: Scalar> SpatialInertia<S> {
    /// A rigid body about its centre of mass: mass in kg, J in kg m^2 in body axes.
    pub fn rigid(mass: S, moments: Symmetric3<S>) -> Self {
        Self { angular: moments, coupling: Matrix3::zero(), linear: Symmetric3::diagonal([mass; 3]) }
    }

    /// From the full 6x6 by rows, angular part first; the matrix is taken as symmetric.
    pub fn from_rows(rows: &[[S; 6]; 6]) -> Self {
        let block = |r: usize, c: usize| Matrix3::from_fn(|i, j| rows[r + i][c + j]);
        Self {
            angular: Symmetric3::from_upper(&block(0, 0)),
            coupling: block(0, 3),
            linear: Symmetric3::from_upper(&block(3, 3)),
        }
    }

    /// Momentum of a twist: the moment part is angular momentum, the force part linear.
    #[inline]
    pub fn times(&self, t: &Twist<S>) -> Wrench<S> {
        Wrench {
            moment: self.angular * t.angular + self.coupling * t.linear,
            force: self.coupling.transpose_times(t.angular) + self.linear * t.linear,
        }
    }

    /// Twice the kinetic energy, `v^T I v` (eq. 47, written with the transpose it needs).
    #[inline]
    pub fn quadratic(&self, t: &Twist<S>) -> S {
        self.times(t).dot(t)
    }

    /// The same inertia about the origin and in the axes of the parent frame.
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

    /// `self - u u^T k`: what remains of an articulated inertia once a joint direction is free.
    #[inline]
    pub fn minus_outer(&self, u: &Wrench<S>, k: S) -> Self {
        Self {
            angular: self.angular.minus_outer(u.moment, k),
            coupling: self.coupling - Matrix3::outer(u.moment, u.force * k),
            linear: self.linear.minus_outer(u.force, k),
        }
    }

    /// The twist that has this momentum, by the Schur complement of the linear block.
    #[inline]
    pub fn solve(&self, p: &Wrench<S>) -> Twist<S> {
        let linear_inverse = self.linear.inverse();
        let gain = Matrix3(core::array::from_fn(|i| (linear_inverse * self.coupling.row(i)).0));
        let schur = self.angular.to_matrix() - gain * self.coupling.transpose();
        let angular = Symmetric3::from_upper(&schur).inverse() * (p.moment - gain * p.force);
        let linear = linear_inverse * (p.force - self.coupling.transpose_times(angular));
        Twist { angular, linear }
    }

    /// Whether this is a rigid body about its centre of mass: the paper's block-diagonal M.
    pub fn is_rigid_about_centre_of_mass(&self) -> bool {
        let m = &self.linear;
        self.coupling == Matrix3::zero()
            && m.xx == m.yy
            && m.yy == m.zz
            && [m.xy, m.xz, m.yz].iter().all(|x| *x == S::ZERO)
    }
}

impl<S: Scalar> Add for SpatialInertia<S> {
    type Output = Self;
    #[inline]
    fn add(self, b: Self) -> Self {
        Self { angular: self.angular + b.angular, coupling: self.coupling + b.coupling, linear: self.linear + b.linear }
    }
}

impl<S: Scalar> AddAssign for SpatialInertia<S> {
    #[inline]
    fn add_assign(&mut self, b: Self) {
        *self = *self + b;
    }
}

/// Moments of inertia that no distribution of mass can have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TriangleInequality {
    /// A principal moment is negative, kg m^2.
    Negative(f64),
    /// The largest principal moment exceeds the sum of the other two, kg m^2.
    Exceeded {
        /// The largest principal moment.
        largest: f64,
        /// The sum of the other two.
        others: f64,
    },
}

impl Symmetric3<f64> {
    /// Principal values in ascending order, by the trigonometric solution of the characteristic
    /// equation (Smith 1961).
    pub fn principal_values(&self) -> Vector3<f64> {
        let mean = (self.xx + self.yy + self.zz) / 3.0;
        let d = Self::diagonal([self.xx - mean, self.yy - mean, self.zz - mean]);
        let off = self.xy * self.xy + self.xz * self.xz + self.yz * self.yz;
        let spread = libm::sqrt((d.xx * d.xx + d.yy * d.yy + d.zz * d.zz + 2.0 * off) / 6.0);
        if spread == 0.0 {
            return Vector3([mean; 3]);
        }
        let shifted = Self { xy: self.xy, xz: self.xz, yz: self.yz, ..d }.to_matrix().scaled(1.0 / spread);
        let angle = libm::acos((0.5 * shifted.determinant()).clamp(-1.0, 1.0)) / 3.0;
        let value = |k: f64| mean + 2.0 * spread * libm::cos(angle + k * core::f64::consts::TAU / 3.0);
        Vector3([value(1.0), value(2.0), value(0.0)])
    }

    /// Checks that the moments can belong to a body: principal moments are not negative and none
    /// exceeds the sum of the other two, within rounding.
    pub fn check_triangle_inequality(&self) -> Result<(), TriangleInequality> {
        let [smallest, middle, largest] = self.principal_values().0;
        let slack = 1e-12 * largest.abs();
        if smallest < -slack {
            return Err(TriangleInequality::Negative(smallest));
        }
        if largest > smallest + middle + slack {
            return Err(TriangleInequality::Exceeded { largest, others: smallest + middle });
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spatial::exp;

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
    fn principal_values_are_those_of_the_diagonal_and_survive_a_turn() {
        let d = Symmetric3::diagonal([5.0, 2.0, 4.0]);
        let turned = d.rotated(&exp(Vector3::new(0.3, 1.0, -0.8)));
        for s in [d, turned] {
            assert!((s.principal_values() - Vector3::new(2.0, 4.0, 5.0)).norm() < 1e-13);
        }
    }

    #[test]
    fn a_plate_may_reach_the_triangle_limit_and_no_body_may_pass_it() {
        assert_eq!(Symmetric3::diagonal([1.0, 2.0, 3.0]).check_triangle_inequality(), Ok(()));
        let broken = Symmetric3::diagonal([1.0, 2.0, 3.1]).check_triangle_inequality();
        assert!(matches!(broken, Err(TriangleInequality::Exceeded { .. })));
    }
}
