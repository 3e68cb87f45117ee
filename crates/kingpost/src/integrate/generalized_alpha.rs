//! The generalized-alpha method.

use super::newton::{ImplicitStage, Newton, RotationBy};
use super::{Interval, Sizes, Stage, StepError, System, accumulate};
use crate::scalar::Scalar;
use crate::state::State;

/// Newmark's rule over algorithmic accelerations `a`, which follow the true ones `v'` with a small lag (Chung & Hulbert
/// 1993; on the group Bruls, Cardona & Arnold 2012, eqs. 13-15):
///
/// ```text
/// (1 - alpha_m) a1 + alpha_m a0 = (1 - alpha_f) v1' + alpha_f v0'
/// q1 = q0 retracted by h v0 + h^2 ((1/2 - beta) a0 + beta a1)
/// v1 = v0 + h ((1 - gamma) a0 + gamma a1)
/// alpha_m = (2 rho - 1) / (rho + 1),   alpha_f = rho / (rho + 1)
/// gamma = 1/2 + alpha_f - alpha_m,     beta = (gamma + 1/2)^2 / 4
/// ```
///
/// Order 2, stable at any step on linear oscillations. `rho` is the factor by which one step reduces
/// oscillations whose period is much shorter than the step: with 1 there is no damping, with 0 they vanish in
/// one step.
///
/// The state's memory contains the lag `(a - v') / h` of each velocity and extra state. The lag stays smooth
/// when `v'` jumps, for example at the edges of a motor's history, and when the step changes. Extra states
/// follow the rule of v.
#[derive(Clone, Debug)]
pub struct GeneralizedAlpha<S = f64> {
    rule: Rule,
    /// v' and s' at the start, one after another.
    rates: Vec<S>,
    /// Algorithmic rates at the start.
    a0: Vec<S>,
    /// Part of the algorithmic rates at the end that does not depend on the state at the end.
    a1: Vec<S>,
    newton: Newton<S>,
}

#[derive(Clone, Copy, Debug)]
struct Rule {
    alpha_m: f64,
    alpha_f: f64,
    beta: f64,
    gamma: f64,
}

impl Rule {
    fn new(rho_infinity: f64) -> Self {
        let alpha_m = (2.0 * rho_infinity - 1.0) / (rho_infinity + 1.0);
        let alpha_f = rho_infinity / (rho_infinity + 1.0);
        let gamma = 0.5 + alpha_f - alpha_m;
        Self { alpha_m, alpha_f, beta: 0.25 * (gamma + 0.5) * (gamma + 0.5), gamma }
    }

    /// d(a1)/d(v1').
    fn slope(&self) -> f64 {
        (1.0 - self.alpha_f) / (1.0 - self.alpha_m)
    }
}

impl<S: Scalar> GeneralizedAlpha<S> {
    /// Creates a scheme for arrays of these sizes.
    pub fn new(sizes: Sizes, rho_infinity: f64) -> Self {
        let [rates, a0, a1] = core::array::from_fn(|_| vec![S::ZERO; sizes.velocities + sizes.extras]);
        Self { rule: Rule::new(rho_infinity), rates, a0, a1, newton: Newton::new(sizes) }
    }

    /// Returns the number of entries in the state's memory: the lags, then the derivatives kept from step to
    /// step.
    pub fn memory_len(&self) -> usize {
        self.rates.len() + self.newton.memory_len()
    }

    /// Moves the state over the interval.
    pub fn step<Y: System<S>>(
        &mut self,
        system: &mut Y,
        interval: Interval,
        state: &mut State<S>,
    ) -> Result<(), StepError> {
        let (rule, h, n) = (self.rule, interval.end_s - interval.start_s, state.v.len());
        self.begin(system, interval, state);
        let Self { rates, a0, a1, newton, .. } = self;
        newton.v_dot.copy_from_slice(&rates[..n]);
        newton.s_dot.copy_from_slice(&rates[n..]);
        newton.v_start.copy_from_slice(&state.v);
        accumulate(&mut newton.v_start, h * (1.0 - rule.gamma), &a0[..n]);
        accumulate(&mut newton.v_start, h * rule.gamma, &a1[..n]);
        newton.s_start.copy_from_slice(&state.s);
        accumulate(&mut newton.s_start, h * (1.0 - rule.gamma), &a0[n..]);
        accumulate(&mut newton.s_start, h * rule.gamma, &a1[n..]);
        newton.xi_start.fill(S::ZERO);
        accumulate(&mut newton.xi_start, h, &state.v);
        accumulate(&mut newton.xi_start, h * h * (0.5 - rule.beta), &a0[..n]);
        accumulate(&mut newton.xi_start, h * h * rule.beta, &a1[..n]);
        let place = ImplicitStage {
            time_s: interval.end_s,
            interval,
            xi_slope: h * h * rule.beta * rule.slope(),
            slope: h * rule.gamma * rule.slope(),
            rotation: RotationBy::Exponential,
        };
        newton.recall(&state.memory[rates.len()..]);
        newton.solve(system, state, place)?;
        newton.keep(&mut state.memory[rates.len()..]);
        state.q.copy_from_slice(&newton.q);
        state.v.copy_from_slice(&newton.v);
        self.end(h, state);
        Ok(())
    }

    /// Computes rates and algorithmic rates at the start, and the known part of those at the end.
    fn begin<Y: System<S>>(&mut self, system: &mut Y, interval: Interval, state: &State<S>) {
        let (rule, h) = (self.rule, interval.end_s - interval.start_s);
        let State { q, v, s, d, m, memory, .. } = state;
        let (v_dot, s_dot) = self.rates.split_at_mut(v.len());
        system.rates(Stage { time_s: interval.start_s, interval, q, v, s, d, m }, v_dot, s_dot);
        self.a0.copy_from_slice(&self.rates);
        accumulate(&mut self.a0, h, &memory[..self.rates.len()]);
        self.a1.fill(S::ZERO);
        accumulate(&mut self.a1, rule.alpha_f / (1.0 - rule.alpha_m), &self.rates);
        accumulate(&mut self.a1, -rule.alpha_m / (1.0 - rule.alpha_m), &self.a0);
    }

    /// Updates the extra states by the rule of v, and the lags for the next step.
    fn end(&mut self, h: f64, state: &mut State<S>) {
        let (rule, n) = (self.rule, state.v.len());
        accumulate(&mut self.a1[..n], rule.slope(), &self.newton.v_dot);
        accumulate(&mut self.a1[n..], rule.slope(), &self.newton.s_dot);
        accumulate(&mut state.s, h * (1.0 - rule.gamma), &self.a0[n..]);
        accumulate(&mut state.s, h * rule.gamma, &self.a1[n..]);
        let rates = self.newton.v_dot.iter().chain(&self.newton.s_dot);
        let step = S::constant(h);
        for ((lag, a1), rate) in state.memory.iter_mut().zip(&self.a1).zip(rates) {
            *lag = (*a1 - *rate) / step;
        }
    }
}
