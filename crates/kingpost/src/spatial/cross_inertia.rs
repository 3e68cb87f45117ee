//! Inertia between two bodies.

use super::{Frame, Matrix3, Twist, Vector3, Wrench};
use crate::scalar::Scalar;

/// Inertia between two bodies, a 6x6 matrix C that need not be symmetric: the first has the momentum `C nu_2` from the twist
/// of the second, and the second `C^T nu_1` from that of the first. The kinetic energy is `nu_1 . C nu_2`.
///
/// ```text
/// | moment on 1 |   | angular           moment_by_velocity | | omega of 2 |
/// | force on 1  | = | force_by_turning  linear             | | v of 2     |
/// ```
///
/// The twist of each body is in its axes, about its centre of mass. (H. Lamb, *Hydrodynamics*, 1932, art. 137: several
/// bodies in one fluid.)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CrossInertia<S = f64> {
    /// Angular momentum per angular velocity, kg m^2.
    pub angular: Matrix3<S>,
    /// Angular momentum per velocity, kg m.
    pub moment_by_velocity: Matrix3<S>,
    /// Momentum per angular velocity, kg m.
    pub force_by_turning: Matrix3<S>,
    /// Momentum per velocity, kg.
    pub linear: Matrix3<S>,
}

impl<S: Scalar> CrossInertia<S> {
    /// Returns the inertia with these columns: `column` maps a twist of the second body to the momentum of the first.
    pub fn from_columns(column: impl Fn(&Twist<S>) -> Wrench<S>) -> Self {
        let unit = |k: usize| Vector3(core::array::from_fn(|i| if i == k { S::ONE } else { S::ZERO }));
        let zero = Vector3::zero();
        let turning: [Wrench<S>; 3] = core::array::from_fn(|k| column(&Twist { angular: unit(k), linear: zero }));
        let moving: [Wrench<S>; 3] = core::array::from_fn(|k| column(&Twist { angular: zero, linear: unit(k) }));
        Self {
            angular: Matrix3::from_fn(|i, k| turning[k].moment[i]),
            moment_by_velocity: Matrix3::from_fn(|i, k| moving[k].moment[i]),
            force_by_turning: Matrix3::from_fn(|i, k| turning[k].force[i]),
            linear: Matrix3::from_fn(|i, k| moving[k].force[i]),
        }
    }

    /// Returns `C nu_2`, the momentum of the first body.
    #[inline]
    pub fn times(&self, second: &Twist<S>) -> Wrench<S> {
        Wrench {
            moment: self.angular * second.angular + self.moment_by_velocity * second.linear,
            force: self.force_by_turning * second.angular + self.linear * second.linear,
        }
    }

    /// Returns `C^T nu_1`, the momentum of the second body.
    #[inline]
    pub fn transpose_times(&self, first: &Twist<S>) -> Wrench<S> {
        let Self { angular, moment_by_velocity, force_by_turning, linear } = self;
        Wrench {
            moment: angular.transpose_times(first.angular) + force_by_turning.transpose_times(first.linear),
            force: moment_by_velocity.transpose_times(first.angular) + linear.transpose_times(first.linear),
        }
    }

    /// Returns the inertia between the parents of the two bodies' frames, about the parents' origins in their axes.
    pub fn to_parents(&self, first: &Frame<S>, second: &Frame<S>) -> Self {
        Self::from_columns(|twist| first.wrench_to_parent(&self.times(&second.twist_to_child(twist))))
    }

    /// Returns the entry in a row and a column, angular part first.
    pub fn entry(&self, row: usize, column: usize) -> S {
        let block = match (row < 3, column < 3) {
            (true, true) => &self.angular,
            (true, false) => &self.moment_by_velocity,
            (false, true) => &self.force_by_turning,
            (false, false) => &self.linear,
        };
        block.0[row % 3][column % 3]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spatial::exp;

    #[test]
    fn energy_is_the_same_in_the_frames_of_the_parents() {
        let block = |k: f64| Matrix3::from_fn(|i, j| libm::sin(k + (3 * i + j) as f64));
        let inertia = CrossInertia {
            angular: block(0.0),
            moment_by_velocity: block(1.0),
            force_by_turning: block(2.0),
            linear: block(3.0),
        };
        let frame = |a: f64| Frame { rotation: exp(Vector3::new(a, -0.7, 1.1)), position: Vector3::new(1.0, a, -0.5) };
        let twist = |a: f64| Twist { angular: Vector3::new(a, 0.5, -0.3), linear: Vector3::new(1.0, -2.0, a) };
        let ([first, second], [on_first, on_second]) = ([frame(0.4), frame(-1.3)], [twist(0.2), twist(0.9)]);
        let children = [first.twist_to_child(&on_first), second.twist_to_child(&on_second)];
        let energy = inertia.times(&children[1]).dot(&children[0]);
        let moved = inertia.to_parents(&first, &second);
        // Rounding of some hundred products of order 1.
        assert!((moved.times(&on_second).dot(&on_first) - energy).abs() < 1e-13);
        assert!((moved.transpose_times(&on_first).dot(&on_second) - energy).abs() < 1e-13);
        assert!((moved.entry(1, 4) - moved.moment_by_velocity.0[1][1]).abs() < f64::EPSILON);
    }
}
