//! The paper's fictitious damping in place of the water: a moment against the ship's body rates.

use crate::dynamics::{LinkKinematics, Loads};
use crate::model::Model;
use crate::scalar::Scalar;
use crate::spatial::{Vector3, Wrench};

/// `F = -c v` and `M = -zeta omega`, component by component in body axes.
#[derive(Clone, Copy, Debug)]
pub struct ViscousDamping<S = f64> {
    /// The damped body.
    pub body: usize,
    /// c along x, y, z, N s/m.
    pub linear: Vector3<S>,
    /// zeta about x, y, z (roll, pitch, yaw), N m s.
    pub angular: Vector3<S>,
}

impl<S: Scalar> ViscousDamping<S> {
    /// Adds the damping and the heat that it makes.
    pub fn apply(&self, model: &Model<S>, links: &LinkKinematics<S>, loads: &mut Loads<S>) {
        let twist = links.body_twist(model, self.body);
        let against = |c: Vector3<S>, rate: Vector3<S>| Vector3(core::array::from_fn(|i| c[i] * rate[i]));
        let (moment, force) = (against(self.angular, twist.angular), against(self.linear, twist.linear));
        loads.power.dissipated += moment.dot(twist.angular) + force.dot(twist.linear);
        loads.wrenches.push((self.body, -Wrench { moment, force }));
    }
}
