//! A constraint in the solver, of a loop or of an element: a column of J^T.

use super::Row;
use crate::dynamics::ball::Ball;
use crate::dynamics::forward::Response;
use crate::dynamics::{LinkKinematics, TemporaryConstraint};
use crate::model::{LinkJoint, Model, MotionType};
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

    /// Returns the length of the row of J over the free coordinates, relative to that of its loads: zero if no coordinate
    /// changes phi.
    pub fn motion(&self, model: &Model<S>, links: &LinkKinematics<S>) -> S {
        let of_links = self.on.iter().fold(S::ZERO, |sum, (_, wrench)| sum + size(wrench));
        let whole = self.along.iter().fold(of_links, |sum, (_, load)| sum + *load * *load);
        let mut squares = S::ZERO;
        for (i, plan) in model.plan.iter().enumerate() {
            let carried = self.on.iter().filter(|(link, _)| is_on_the_way(model, i, *link));
            let wrench = carried.fold(Wrench::zero(), |sum, (_, wrench)| sum + *wrench);
            let along = |coordinate: usize| {
                let own = self.along.iter().filter(|(at, _)| *at == coordinate);
                own.fold(S::ZERO, |sum, (_, load)| sum + *load)
            };
            squares += match plan.joint {
                LinkJoint::Floating => {
                    let free = |held: bool| if held { S::ZERO } else { S::ONE };
                    wrench.force.norm_squared() * free(plan.floating.hold_translation)
                        + wrench.moment.norm_squared() * free(plan.floating.hold_rotation)
                }
                LinkJoint::Spherical if plan.mode == MotionType::Free => {
                    let axes = Ball::new(plan, links.in_root(i)).axes();
                    axes.iter().fold(S::ZERO, |sum, axis| sum + wrench.dot(axis) * wrench.dot(axis))
                }
                _ if plan.mode == MotionType::Free => {
                    let load = wrench.dot(links.axis(i)) + along(plan.velocities);
                    load * load
                }
                _ => S::ZERO,
            };
        }
        (squares / whole).sqrt()
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

/// Returns the square of the length of a wrench, by the sizes of its entries.
fn size<S: Scalar>(wrench: &Wrench<S>) -> S {
    wrench.force.norm_squared() + wrench.moment.norm_squared()
}

/// Returns whether a link is an ancestor of another link, or the same link.
fn is_on_the_way<S>(model: &Model<S>, link: usize, from: usize) -> bool {
    let mut next = Some(from);
    while let Some(at) = next.filter(|at| *at >= link) {
        if at == link {
            return true;
        }
        next = model.plan[at].parent();
    }
    false
}
