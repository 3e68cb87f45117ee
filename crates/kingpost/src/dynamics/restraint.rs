//! A constraint that an element holds while it acts: an inextensible rope, taut.

use super::LinkKinematics;
use crate::model::Model;
use crate::scalar::Scalar;
use crate::spatial::{Twist, Wrench};

/// One equation phi(q) = 0 that acts one way: what it carries, its multiplier, is positive while it holds, and it lets go where
/// that would be less.
///
/// Its row of J is given by what one unit of the multiplier puts on the bodies and along coordinates: `phi' = sum W . V +
/// sum c q'`, by d'Alembert's principle.
#[derive(Clone, Debug)]
pub struct Restraint<S = f64> {
    /// The element that holds.
    pub name: String,
    /// Whether it holds now.
    pub acts: bool,
    /// phi, m.
    pub residual: S,
    /// phi', m/s.
    pub rate: S,
    /// phi'' where no body has a spatial acceleration, each point x moving by omega x x' alone, and no coordinate's rate
    /// below changes, m/s^2.
    pub drift: S,
    /// By body: the wrench of one unit, in body axes about its centre of mass.
    pub wrenches: Vec<(usize, Wrench<S>)>,
    /// By index in v: the load of one unit along a coordinate, with its reaction on the parent.
    pub along: Vec<(usize, S)>,
}

impl<S: Scalar> Restraint<S> {
    /// Of an element of this name; it does not act yet.
    pub fn new(name: &str) -> Self {
        let (name, wrenches, along) = (name.to_owned(), Vec::new(), Vec::new());
        Self { name, acts: false, residual: S::ZERO, rate: S::ZERO, drift: S::ZERO, wrenches, along }
    }

    /// Takes off what it puts on the bodies.
    pub fn clear(&mut self) {
        self.wrenches.clear();
        self.along.clear();
    }

    /// Writes by link what one unit puts on it, about its root's origin in root axes.
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

    /// `sum W . V + sum c q'` of the bodies' twists, in body axes about their centres of mass, and of the coordinates' rates.
    pub fn times(&self, twist: impl Fn(usize) -> Twist<S>, rates: &[S]) -> S {
        let by_bodies = self.wrenches.iter().fold(S::ZERO, |sum, (body, wrench)| sum + wrench.dot(&twist(*body)));
        self.along.iter().fold(by_bodies, |sum, (coordinate, load)| sum + *load * rates[*coordinate])
    }
}
