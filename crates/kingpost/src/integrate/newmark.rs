//! Newmark's method.

use super::newton::{ImplicitStage, Newton, RotationBy};
use super::{Interval, Sizes, Stage, StepError, System, accumulate};
use crate::scalar::Scalar;
use crate::state::State;

/// With `a = v'` at both ends of the step (Newmark 1959; on the rotation group Simo & Vu-Quoc
/// 1988),
///
/// ```text
/// q1 = q0 retracted by h v0 + h^2 ((1/2 - beta) a0 + beta a1)
/// v1 = v0 + h ((1 - gamma) a0 + gamma a1)
/// ```
///
/// The predictor is `a1 = a0`; Newton's method corrects it. Order 2 for gamma = 1/2, otherwise 1; stable at
/// any step on linear oscillations for `2 beta >= gamma >= 1/2` (Hughes, *The Finite Element Method*, 1987,
/// section 9.1). beta = 1/4 and gamma = 1/2 have no numerical damping. Extra states follow the rule of v.
#[derive(Clone, Debug)]
pub struct Newmark<S = f64> {
    beta: f64,
    gamma: f64,
    a0: Vec<S>,
    s_dot0: Vec<S>,
    newton: Newton<S>,
}

impl<S: Scalar> Newmark<S> {
    /// Creates a scheme for arrays of these sizes.
    pub fn new(sizes: Sizes, beta: f64, gamma: f64) -> Self {
        let (a0, s_dot0) = (vec![S::ZERO; sizes.velocities], vec![S::ZERO; sizes.extras]);
        Self { beta, gamma, a0, s_dot0, newton: Newton::new(sizes) }
    }

    /// Returns the number of entries in the state's memory: derivatives, kept from step to step.
    pub fn memory_len(&self) -> usize {
        self.newton.memory_len()
    }

    /// Moves the state over the interval.
    pub fn step<Y: System<S>>(
        &mut self,
        system: &mut Y,
        interval: Interval,
        state: &mut State<S>,
    ) -> Result<(), StepError> {
        let Self { beta, gamma, a0, s_dot0, newton } = self;
        let h = interval.end_s - interval.start_s;
        let State { q, v, s, d, m, .. } = &*state;
        system.rates(Stage { time_s: interval.start_s, interval, q, v, s, d, m }, a0, s_dot0);
        newton.v_dot.copy_from_slice(a0);
        newton.s_dot.copy_from_slice(s_dot0);
        newton.v_start.copy_from_slice(v);
        accumulate(&mut newton.v_start, h * (1.0 - *gamma), a0);
        newton.s_start.copy_from_slice(s);
        accumulate(&mut newton.s_start, h * (1.0 - *gamma), s_dot0);
        newton.xi_start.fill(S::ZERO);
        accumulate(&mut newton.xi_start, h, v);
        accumulate(&mut newton.xi_start, h * h * (0.5 - *beta), a0);
        let place = ImplicitStage {
            time_s: interval.end_s,
            interval,
            xi_slope: h * h * *beta,
            slope: h * *gamma,
            rotation: RotationBy::Exponential,
        };
        newton.recall(&state.memory);
        newton.solve(system, state, place)?;
        newton.keep(&mut state.memory);
        state.q.copy_from_slice(&newton.q);
        state.v.copy_from_slice(&newton.v);
        state.s.copy_from_slice(&newton.s_start);
        accumulate(&mut state.s, h * *gamma, &newton.s_dot);
        Ok(())
    }
}
