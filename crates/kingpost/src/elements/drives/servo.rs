//! A position servo: holds a crane up against gravity, as far as its limit goes.

use crate::dynamics::Loads;
use crate::scalar::Scalar;

/// `tau = k (target - q) - c v`, clipped to the limit.
#[derive(Clone, Debug)]
pub struct Servo<S = f64> {
    /// Index in q.
    pub position: usize,
    /// Index in v.
    pub coordinate: usize,
    /// Wanted position, rad or m.
    pub target: S,
    /// k, N m/rad or N/m.
    pub stiffness: S,
    /// c, N m s/rad or N s/m.
    pub damping: S,
    /// Largest torque or force, N m or N.
    pub limit: S,
}

impl<S: Scalar> Servo<S> {
    /// Adds the torque and the work that it does.
    pub fn apply(&self, q: &[S], v: &[S], loads: &mut Loads<S>) {
        let rate = v[self.coordinate];
        let wanted = self.stiffness * (self.target - q[self.position]) - self.damping * rate;
        let effort = wanted.clipped(-self.limit, self.limit);
        loads.force[self.coordinate] += effort;
        loads.power.drives += effort * rate;
    }
}
