//! What loads are computed from.

use super::LinkKinematics;
use crate::model::Model;

/// When a law is evaluated: the time, and the interval that is being stepped. At an edge the middle
/// decides which piece of a law holds, so that no step mixes two pieces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clock {
    /// Time, s.
    pub time_s: f64,
    /// Middle of the interval, s.
    pub middle_s: f64,
}

/// What forces and drives act on, and when.
#[derive(Clone, Copy, Debug)]
pub struct Moment<'a, S = f64> {
    /// When.
    pub clock: Clock,
    /// The mechanical model.
    pub model: &'a Model<S>,
    /// Kinematics of its links.
    pub links: &'a LinkKinematics<S>,
    /// Positions.
    pub q: &'a [S],
    /// Velocities.
    pub v: &'a [S],
    /// What is constant over a step: of drives the values of the input table, of forces what they
    /// hold.
    pub held: &'a [S],
    /// Extra states: of drives their own, of forces theirs.
    pub states: &'a [S],
}
