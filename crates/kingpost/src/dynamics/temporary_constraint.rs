//! Temporary constraint of an element: a taut inextensible rope, a connection that can be released.

use super::LinkKinematics;
use crate::model::Model;
use crate::scalar::Scalar;
use crate::spatial::{Twist, Wrench};

/// A constraint phi(q) = 0 of an element that holds it in some of its modes. The force of a one-sided constraint, the multiplier,
/// is positive while it is active, and it releases when the force would become negative.
///
/// Its row of J is given by the loads of a unit multiplier on the bodies and along coordinates: `phi' = sum W . V + sum
/// c q'`, by d'Alembert's principle.
#[derive(Clone, Debug)]
pub struct TemporaryConstraint<S = f64> {
    /// Name of the element.
    pub name: String,
    /// Whether the constraint is active.
    pub acts: bool,
    /// Whether its force can only be positive.
    pub is_one_sided: bool,
    /// Name of the constraint within the element, and unit of phi.
    pub part: (&'static str, &'static str),
    /// phi, m or rad (for an angle, its sine).
    pub residual: S,
    /// phi', m/s or rad/s.
    pub rate: S,
    /// phi'' for zero spatial acceleration of all bodies, so that each point x has only the acceleration
    /// omega x x', and constant rates of the coordinates in `along`, m/s^2 or rad/s^2.
    pub bias_acceleration: S,
    /// Wrench of a unit multiplier on each body, in body axes about its centre of mass.
    pub wrenches: Vec<(usize, Wrench<S>)>,
    /// Load of a unit multiplier along coordinates, by index in v, with its reaction on the parent.
    pub along: Vec<(usize, S)>,
}

impl<S: Scalar> TemporaryConstraint<S> {
    /// Creates a restraint of the element with this name: a one-sided one of a length, which is not yet active.
    pub fn new(name: &str) -> Self {
        let (name, wrenches, along) = (name.to_owned(), Vec::new(), Vec::new());
        let [residual, rate, bias_acceleration] = [S::ZERO; 3];
        Self {
            name,
            acts: false,
            is_one_sided: true,
            part: ("length", "m"),
            residual,
            rate,
            bias_acceleration,
            wrenches,
            along,
        }
    }

    /// Removes the loads on the bodies.
    pub fn clear(&mut self) {
        self.wrenches.clear();
        self.along.clear();
    }

    /// Writes the load of a unit multiplier on each link, about its root's origin in root axes.
    pub(super) fn write_on_links(&self, model: &Model<S>, links: &LinkKinematics<S>, on: &mut Vec<(usize, Wrench<S>)>) {
        on.clear();
        for (body, wrench) in &self.wrenches {
            let body = &model.bodies[*body];
            if let Some(link) = body.link {
                let in_link = body.in_link.wrench_to_parent(wrench);
                on.push((link, links.in_root(link).wrench_to_parent(&in_link)));
            }
        }
    }

    /// Returns `sum W . V + sum c q'` of the bodies' twists, in body axes about their centres of mass, and of
    /// the coordinates' rates.
    pub fn times(&self, twist: impl Fn(usize) -> Twist<S>, rates: &[S]) -> S {
        let by_bodies = self.wrenches.iter().fold(S::ZERO, |sum, (body, wrench)| sum + wrench.dot(&twist(*body)));
        self.along.iter().fold(by_bodies, |sum, (coordinate, load)| sum + *load * rates[*coordinate])
    }
}
