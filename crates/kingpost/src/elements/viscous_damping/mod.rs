//! Damping proportional to a body's rates, such as that of a hull in the water.

pub(crate) mod assembly;
pub(crate) mod fields;

use crate::dynamics::Loads;
use crate::elements::hull::HullFrame;
use crate::elements::{Context, DampedAgainst, Element};
use crate::scalar::Scalar;
use crate::spatial::{Twist, Vector3, Wrench};

/// `F = -c v` and `M = -zeta omega`, component by component in body axes at a point, with v relative to the water or to
/// the earth; and the loads of a full 6x6 matrix, `(F, M) = -B (v, omega)`.
#[derive(Clone, Debug)]
pub struct ViscousDamping<S = f64> {
    /// The damped body, and the point where the force acts and whose velocity is used.
    pub place: HullFrame<S>,
    /// Reference against which the velocity is measured.
    pub relative_to: DampedAgainst,
    /// c along x, y, z, N s/m.
    pub linear: Vector3<S>,
    /// zeta about x, y, z (roll, pitch, yaw), N m s.
    pub angular: Vector3<S>,
    /// B, by rows force x, y, z and moment x, y, z; its symmetric part must not be negative.
    pub matrix: Option<Box<[[S; 6]; 6]>>,
}

impl<S: Scalar> Element<S> for ViscousDamping<S> {
    /// Adds the damping, its heat, and the work of the current.
    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        let (through, stream) = self.place.through_water(at, self.relative_to.velocity(at.world));
        let along = |c: Vector3<S>, rate: Vector3<S>| Vector3(core::array::from_fn(|i| c[i] * rate[i]));
        let mut wrench =
            Wrench { moment: along(self.angular, through.angular), force: along(self.linear, through.linear) };
        if let Some(matrix) = &self.matrix {
            wrench += times(matrix, &through);
        }
        loads.power.dissipated += wrench.dot(&through);
        loads.power.outside -= wrench.force.dot(stream);
        loads.wrenches.push((self.place.body, self.place.about_centre(&-wrench)));
    }
}

fn times<S: Scalar>(matrix: &[[S; 6]; 6], twist: &Twist<S>) -> Wrench<S> {
    let ([x, y, z], [roll, pitch, yaw]) = (twist.linear.0, twist.angular.0);
    let rates = [x, y, z, roll, pitch, yaw];
    let row = |i: usize| (0..6).fold(S::ZERO, |sum, j| sum + matrix[i][j] * rates[j]);
    Wrench { force: Vector3([row(0), row(1), row(2)]), moment: Vector3([row(3), row(4), row(5)]) }
}
