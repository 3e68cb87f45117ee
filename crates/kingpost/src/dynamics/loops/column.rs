//! A constraint in the solver, of a loop or of an element: a column of J^T.

use super::Row;
use crate::dynamics::forward::Response;
use crate::dynamics::{LinkKinematics, TemporaryConstraint};
use crate::model::Model;
use crate::scalar::Scalar;
use crate::spatial::{Twist, Wrench};

/// phi with its derivatives, and the load of a unit multiplier on the links.
#[derive(Clone, Debug)]
pub(super) struct ConstraintColumn<S> {
    /// phi, m or rad.
    pub residual: S,
    /// phi', m/s or rad/s.
    pub rate: S,
    /// phi'' for zero spatial acceleration of all links and zero acceleration of the coordinates in `along`.
    bias_acceleration: S,
    /// Loads by link, about its root's origin in root axes.
    on: Vec<(usize, Wrench<S>)>,
    /// Loads by index in v.
    along: Vec<(usize, S)>,
}

impl<S: Scalar> ConstraintColumn<S> {
    /// Creates an empty column.
    pub fn new() -> Self {
        let (on, along) = Default::default();
        Self { residual: S::ZERO, rate: S::ZERO, bias_acceleration: S::ZERO, on, along }
    }

    /// Copies a constraint of a loop.
    pub fn take_row(&mut self, row: &Row<S>) {
        (self.residual, self.rate, self.bias_acceleration) = (row.residual, row.rate, row.bias_acceleration);
        self.on.clear();
        let ends = [(row.second, row.on_second), (row.first, row.on_first)];
        self.on.extend(ends.into_iter().filter_map(|(link, wrench)| Some((link?, wrench))));
    }

    /// Copies the restraint of an element.
    pub fn take_restraint(&mut self, model: &Model<S>, links: &LinkKinematics<S>, held: &TemporaryConstraint<S>) {
        (self.residual, self.rate, self.bias_acceleration) = (held.residual, held.rate, held.bias_acceleration);
        held.write_on_links(model, links, &mut self.on);
        self.along.clone_from(&held.along);
    }

    /// Returns `J a`, from the spatial accelerations of the links in root axes and those of the coordinates.
    #[inline]
    pub fn times(&self, acceleration: impl Fn(usize) -> Twist<S>, rates: &[S]) -> S {
        let by_links = self.on.iter().fold(S::ZERO, |sum, (link, wrench)| sum + wrench.dot(&acceleration(*link)));
        self.along.iter().fold(by_links, |sum, (coordinate, load)| sum + *load * rates[*coordinate])
    }

    /// Returns phi'' for these accelerations.
    pub fn acceleration(&self, of_links: impl Fn(usize) -> Twist<S>, rates: &[S]) -> S {
        self.times(of_links, rates) + self.bias_acceleration
    }

    /// Applies the load times `multiplier` to the links.
    pub fn press(&self, multiplier: S, response: &mut Response<S>) {
        for (link, wrench) in &self.on {
            response.add(Some(*link), &(*wrench * multiplier));
        }
        for (coordinate, load) in &self.along {
            response.add_along(*coordinate, *load * multiplier);
        }
    }
}
