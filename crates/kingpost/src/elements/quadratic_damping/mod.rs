//! Quadratic damping, such as the drag of a hull's bilges in roll and of its sides in sway.

pub(crate) mod assembly;
pub(crate) mod fields;

use crate::dynamics::Loads;
use crate::elements::hull::HullFrame;
use crate::elements::{Context, DampedAgainst, Element};
use crate::scalar::Scalar;
use crate::spatial::{Vector3, Wrench};

/// `F = -c |v| v` and `M = -c |omega| omega`, component by component in body axes, at a point whose velocity v is
/// relative to the water or to the earth. A drag coefficient C_d on the area A gives c = rho C_d A / 2 (Faltinsen, *Sea
/// Loads*, 1990, ch. 6).
#[derive(Clone, Copy, Debug)]
pub struct QuadraticDamping<S = f64> {
    /// The body, and the point at which the force acts.
    pub place: HullFrame<S>,
    /// Reference against which the velocity is measured.
    pub relative_to: DampedAgainst,
    /// c along x, y, z, N s^2/m^2.
    pub linear: Vector3<S>,
    /// c about x, y, z (roll, pitch, yaw), N m s^2.
    pub angular: Vector3<S>,
}

impl<S: Scalar> Element<S> for QuadraticDamping<S> {
    /// Adds the drag, its heat, and the work of the current.
    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        let (through, stream) = self.place.through_water(at, self.relative_to.velocity(at.world));
        let wrench =
            Wrench { moment: against(self.angular, through.angular), force: against(self.linear, through.linear) };
        loads.power.dissipated -= wrench.dot(&through);
        loads.power.outside += wrench.force.dot(stream);
        loads.wrenches.push((self.place.body, self.place.about_centre(&wrench)));
    }

    fn left_out_at_rest(&self) -> Option<&'static str> {
        Some("the response leaves out quadratic damping, which is zero at rest; in a run it damps large motions more")
    }
}

/// Returns `-c |rate| rate`, component by component.
fn against<S: Scalar>(c: Vector3<S>, rate: Vector3<S>) -> Vector3<S> {
    let size = |x: S| x.select_below(0.0, || -x, || x);
    Vector3(core::array::from_fn(|i| -(c[i] * size(rate[i]) * rate[i])))
}
