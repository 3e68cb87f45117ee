//! Forward Euler with the midpoint rate in Rodrigues' formula: the improved rotation update that the paper
//! proposes.

use super::{Interval, Sizes, Stage, System, accumulate};
use crate::scalar::Scalar;
use crate::state::State;

/// `v1 = v0 + h v0'`, joints `q1 = q0 + h v0`, ship `R1 = R0 exp(h hat((omega0 + omega1) / 2))`. Order 1,
/// with a smaller error of the rotation.
#[derive(Clone, Debug)]
pub struct MidpointEuler<S = f64> {
    v_dot: Vec<S>,
    s_dot: Vec<S>,
    v: Vec<S>,
    xi: Vec<S>,
    q: Vec<S>,
}

impl<S: Scalar> MidpointEuler<S> {
    /// Creates a scheme for arrays of these sizes.
    pub fn new(sizes: Sizes) -> Self {
        let velocities = || vec![S::ZERO; sizes.velocities];
        Self {
            v_dot: velocities(),
            s_dot: vec![S::ZERO; sizes.extras],
            v: velocities(),
            xi: velocities(),
            q: vec![S::ZERO; sizes.positions],
        }
    }

    /// Moves the state over the interval.
    pub fn step<Y: System<S>>(&mut self, system: &mut Y, interval: Interval, state: &mut State<S>) {
        let h = interval.end_s - interval.start_s;
        let State { q, v, s, d, m, .. } = &*state;
        let stage = Stage { time_s: interval.start_s, interval, q, v, s, d, m };
        system.rates(stage, &mut self.v_dot, &mut self.s_dot);
        self.v.copy_from_slice(v);
        accumulate(&mut self.v, h, &self.v_dot);
        let (half, length) = (S::constant(0.5), S::constant(h));
        for (i, xi) in self.xi.iter_mut().enumerate() {
            *xi = length * if system.is_rotation_rate(i) { half * (v[i] + self.v[i]) } else { v[i] };
        }
        system.retract(q, &self.xi, &mut self.q);
        accumulate(&mut state.s, h, &self.s_dot);
        state.q.copy_from_slice(&self.q);
        state.v.copy_from_slice(&self.v);
    }
}
