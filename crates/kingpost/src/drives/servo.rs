//! A position servo: holds a crane up against gravity, as far as its limit goes.

use crate::dynamics::Loads;

/// `tau = k (target - q) - c v`, clipped to the limit.
#[derive(Clone, Debug)]
pub struct Servo {
    /// Index in q.
    pub position: usize,
    /// Index in v.
    pub coordinate: usize,
    /// Wanted position, rad or m.
    pub target: f64,
    /// k, N m/rad or N/m.
    pub stiffness: f64,
    /// c, N m s/rad or N s/m.
    pub damping: f64,
    /// Largest torque or force, N m or N.
    pub limit: f64,
}

impl Servo {
    /// Adds the torque and the work that it does.
    pub fn apply(&self, q: &[f64], v: &[f64], loads: &mut Loads) {
        let rate = v[self.coordinate];
        let wanted = self.stiffness * (self.target - q[self.position]) - self.damping * rate;
        // Not `clamp`: a rate that is not a number must stay one, so that the run sees it diverge.
        let effort = if wanted.abs() > self.limit { self.limit.copysign(wanted) } else { wanted };
        loads.force[self.coordinate] += effort;
        loads.power.drives += effort * rate;
    }
}
