//! A position servo: it holds a joint, such as that of a crane's boom, with a limited torque or force.

use crate::dynamics::Loads;
use crate::elements::{Context, Declaration, Element, Input, Support};
use crate::scalar::Scalar;

/// `tau = k (target + offset - q) - c v`, clipped to the limit.
#[derive(Clone, Debug)]
pub struct Servo<S = f64> {
    /// Index in q.
    pub position: usize,
    /// Index in v.
    pub coordinate: usize,
    /// Target position, rad or m.
    pub target: S,
    /// k, N m/rad or N/m.
    pub stiffness: S,
    /// c, N m s/rad or N s/m.
    pub damping: S,
    /// Largest torque or force, N m or N.
    pub limit: S,
    /// The input that gives the offset, if there is one.
    pub offset: Option<Input>,
}

impl<S: Scalar> Element<S> for Servo<S> {
    fn declare(&self) -> Declaration {
        Declaration { inputs: self.offset.iter().cloned().collect(), ..Declaration::default() }
    }

    /// Adds the torque or force and its work.
    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        let rate = at.v[self.coordinate];
        let target = at.inputs.first().map_or(self.target, |offset| self.target + *offset);
        let wanted = self.stiffness * (target - at.q[self.position]) - self.damping * rate;
        let effort = wanted.clipped(-self.limit, self.limit);
        loads.force[self.coordinate] += effort;
        loads.power.drives += effort * rate;
    }

    fn supports(&self) -> Vec<Support> {
        vec![Support::Coordinate(self.coordinate)]
    }
}
