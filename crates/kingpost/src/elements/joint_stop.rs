//! A stop at the end of an axis' travel.

use super::{Context, Element};
use crate::dynamics::Loads;
use crate::scalar::Scalar;

/// End of the travel at which a stop acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StopSide {
    /// It stops coordinates below the limit.
    Lower,
    /// It stops coordinates above the limit.
    Upper,
}

/// A one-sided spring whose damping grows with the depth, so that the force is continuous: at the depth d beyond the
/// limit, `F = k d (1 + a d')` towards the travel, never less than 0 (Hunt & Crossley, *J. Appl. Mech.* 42, 1975,
/// 440-445, with the exponent 1). After an impact at a small speed u the axis rebounds at about `u (1 - 2/3 a u)`.
#[derive(Clone, Copy, Debug)]
pub struct JointStop<S = f64> {
    /// Index in q.
    pub position: usize,
    /// Index in v.
    pub coordinate: usize,
    /// Its end of the travel.
    pub side: StopSide,
    /// Coordinate at which the contact begins, rad or m.
    pub limit: S,
    /// k, N m/rad or N/m.
    pub stiffness: S,
    /// a, s/rad or s/m.
    pub dissipation: S,
}

/// Returns the force of a stop, `k d max(1 + a d', 0)`, N or N m, and its heat, W: the power of the force less the
/// power stored in the spring, `k d d' max(a d', -1)`. `speed` is d'.
#[inline]
pub fn hunt_crossley<S: Scalar>(stiffness: S, dissipation: S, depth: S, speed: S) -> (S, S) {
    let elastic = stiffness * depth;
    let excess = dissipation * speed;
    let excess = excess.select_below(-1.0, || -S::ONE, || excess);
    (elastic * (S::ONE + excess), elastic * speed * excess)
}

impl<S: Scalar> Element<S> for JointStop<S> {
    /// Adds the stop's force and its heat.
    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        let (outwards, depth) = (self.outwards(), self.depth(at.q));
        let (force, heat) = hunt_crossley(self.stiffness, self.dissipation, depth, outwards * at.v[self.coordinate]);
        loads.force[self.coordinate] -= outwards * force;
        loads.power.dissipated += heat;
    }

    /// Returns the stored energy, J.
    fn potential_energy(&mut self, at: &Context<'_, S>) -> S {
        let depth = self.depth(at.q);
        self.stiffness * depth * depth * S::constant(0.5)
    }
}

impl<S: Scalar> JointStop<S> {
    fn outwards(&self) -> S {
        match self.side {
            StopSide::Lower => -S::ONE,
            StopSide::Upper => S::ONE,
        }
    }

    /// Returns the depth beyond the limit; 0 within the travel.
    fn depth(&self, q: &[S]) -> S {
        let beyond = self.outwards() * (q[self.position] - self.limit);
        beyond.select_below(0.0, || S::ZERO, || beyond)
    }
}
