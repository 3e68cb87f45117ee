//! Semi-implicit (symplectic) Euler: velocities first, then positions with the new velocities.

use super::{Interval, Sizes, Stage, System, accumulate};
use crate::scalar::Scalar;
use crate::state::State;

/// `v1 = v0 + h v'(t0, q0, v0)`, `q1 = q0` retracted by `h v1` (de Vogelaere 1956; Hairer, Lubich & Wanner,
/// *Geometric Numerical Integration*, 2006, I.1.2). Order 1; for oscillations it is stable if `h omega < 2`,
/// while forward Euler is never stable. Extra states use the rates at the start.
#[derive(Clone, Debug)]
pub struct SemiImplicitEuler<S = f64> {
    v_dot: Vec<S>,
    s_dot: Vec<S>,
    xi: Vec<S>,
    q: Vec<S>,
}

impl<S: Scalar> SemiImplicitEuler<S> {
    /// Creates a scheme for arrays of these sizes.
    pub fn new(sizes: Sizes) -> Self {
        let velocities = || vec![S::ZERO; sizes.velocities];
        Self {
            v_dot: velocities(),
            s_dot: vec![S::ZERO; sizes.extras],
            xi: velocities(),
            q: vec![S::ZERO; sizes.positions],
        }
    }

    /// Moves the state over the interval.
    pub fn step<Y: System<S>>(&mut self, system: &mut Y, interval: Interval, state: &mut State<S>) {
        let h = interval.end_s - interval.start_s;
        let State { q, v, s, d, m, .. } = state;
        let stage = Stage { time_s: interval.start_s, interval, q, v, s, d, m };
        system.rates(stage, &mut self.v_dot, &mut self.s_dot);
        accumulate(v, h, &self.v_dot);
        accumulate(s, h, &self.s_dot);
        self.xi.fill(S::ZERO);
        accumulate(&mut self.xi, h, v);
        system.retract(q, &self.xi, &mut self.q);
        q.copy_from_slice(&self.q);
    }
}
