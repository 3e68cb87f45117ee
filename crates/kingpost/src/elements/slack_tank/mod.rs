//! The free surface of a tank that is neither empty nor full.

pub(crate) mod assembly;
pub(crate) mod fields;

use crate::dynamics::{LinkKinematics, Loads};
use crate::elements::hull::HullFrame;
use crate::elements::{AnyElement, Context, Element, of_kind};
use crate::model::Model;
use crate::scalar::Scalar;
use crate::sea::hull::BoxTank;
use crate::spatial::{Vector3, Wrench};

/// A box of liquid on a body. Its weight `rho g V` is part of the body's weight, with the liquid in its position in the
/// upright body.
///
/// The surface is always level, so the liquid's centre moves from c0 to c(n), n being the vertical in body axes
/// ([`BoxTank::shift`]). This adds only a moment, independent of the tank's position, with the potential energy
///
/// ```text
/// U = rho g V n . (c - c0),      M = n x dU/dn = (c - c0) x (-rho g V n)
/// ```
///
/// since dU/dn = rho g V (c - c0): at constant volume the liquid moves only along the surface.
#[derive(Clone, Debug)]
pub struct SlackTank<S = f64> {
    /// Name of the force in the scenario.
    pub name: String,
    /// The body, and the centre of the box; the box's axes are the body's.
    pub place: HullFrame<S>,
    /// The box and its filling.
    pub tank: BoxTank<S>,
    /// rho of the liquid, kg/m^3.
    pub density: S,
}

impl<S: Scalar> Element<S> for SlackTank<S> {
    fn name(&self) -> &str {
        &self.name
    }

    /// Adds the moment of the shifted liquid.
    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        let vertical = self.vertical(at.model, at.links);
        let moment = vertical.cross(self.tank.shift(vertical)) * (self.density * at.world.gravity);
        loads.wrenches.push((self.place.body, Wrench { moment, force: Vector3::zero() }));
    }

    /// Returns the energy of the liquid relative to the upright position, J: never positive.
    fn potential_energy(&mut self, at: &Context<'_, S>) -> S {
        let vertical = self.vertical(at.model, at.links);
        vertical.dot(self.tank.shift(vertical)) * self.density * at.world.gravity
    }
}

impl<S: Scalar> SlackTank<S> {
    /// Returns the slack tanks among elements.
    pub fn among(elements: &[AnyElement<S>]) -> impl Iterator<Item = &Self> {
        of_kind(elements)
    }

    /// Returns n, in the body's axes.
    fn vertical(&self, model: &Model<S>, links: &LinkKinematics<S>) -> Vector3<S> {
        links.to_body_axes(model, self.place.body, Vector3::new(S::ZERO, S::ZERO, S::ONE))
    }
}
