//! Newton's method for the rates of an implicit stage, where the stage depends on these rates.

use super::linear::Factors;
use super::{Interval, Jacobian, Sizes, Stage, StepError, System, accumulate, largest};
use crate::scalar::Scalar;
use crate::state::State;
use core::ops::Range;

/// Largest number of iterations of a step.
const MOST_ITERATIONS: usize = 50;

/// Largest relative change of the rates in the last iteration of a valid solution.
const ALLOWED: f64 = 1e-9;

/// Relative change of the rates that is near rounding.
const SMALL: f64 = 1e-12;

/// Largest expected next relative change at which the iteration ends: rounding.
const ROUNDING: f64 = 1e-16;

/// Largest ratio of a change to the previous one without new derivatives.
const SLOW: f64 = 0.25;

/// Share of the positions over the step that is added to the magnitude of the rates, so that the iteration
/// also converges for a system at rest, whose rates are rounding errors.
const REST: f64 = 1e-3;

/// Smallest magnitude of s, so that the iteration also converges for extra states at zero.
const SMALLEST_EXTRA: f64 = 1e-9;

/// Number of entries in the memory before the derivatives: whether there are derivatives, number of
/// iterations with new ones, and number of additional iterations since.
const HEAD: usize = 3;

/// Map from local coordinates to a rotation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum RotationBy {
    /// The exponential: `xi` is the rotation vector.
    Exponential,
    /// The Cayley transform: the angle is `2 atan` of half the length; here for half a step, so the angle is `atan` of
    /// the length.
    HalfCayley,
}

/// A stage as a function of its rates: `xi = xi_start + xi_slope v'`, `v = v_start + slope v'`, `s = s_start + slope
/// s'`.
#[derive(Clone, Copy, Debug)]
pub(super) struct ImplicitStage {
    pub(super) time_s: f64,
    pub(super) interval: Interval,
    /// Derivative of `xi` with respect to the rates, s^2.
    pub(super) xi_slope: f64,
    /// Derivative of v and s with respect to the rates, s.
    pub(super) slope: f64,
    pub(super) rotation: RotationBy,
}

/// Unknown stage of the iteration, with working memory.
#[derive(Clone, Debug)]
pub(super) struct Newton<S> {
    /// Given: constant parts of xi, v and s.
    pub(super) xi_start: Vec<S>,
    pub(super) v_start: Vec<S>,
    pub(super) s_start: Vec<S>,
    /// Initial guess, then the solution.
    pub(super) v_dot: Vec<S>,
    pub(super) s_dot: Vec<S>,
    /// Result: the stage.
    pub(super) xi: Vec<S>,
    pub(super) q: Vec<S>,
    pub(super) v: Vec<S>,
    s: Vec<S>,
    /// `xi` before the Cayley transform.
    linear: Vec<S>,
    /// Rates at the stage, and their difference from the unknown rates: s first, whose equations are of order
    /// one in any unit.
    v_dot_here: Vec<S>,
    s_dot_here: Vec<S>,
    change: Vec<S>,
    v_guess: Vec<S>,
    s_guess: Vec<S>,
    jacobian: Jacobian<S>,
    factors: Factors<S>,
    kept: KeptDerivatives,
}

/// Data about derivatives from an earlier step.
#[derive(Clone, Copy, Debug, Default)]
struct KeptDerivatives {
    known: bool,
    /// Number of iterations in the step in which the derivatives were computed.
    least: usize,
    /// Number of additional iterations in the steps since then.
    beyond: usize,
}

impl<S: Scalar> Newton<S> {
    pub(super) fn new(sizes: Sizes) -> Self {
        let of_v = || vec![S::ZERO; sizes.velocities];
        let of_s = || vec![S::ZERO; sizes.extras];
        let unknowns = sizes.velocities + sizes.active();
        Self {
            xi_start: of_v(),
            v_start: of_v(),
            s_start: of_s(),
            v_dot: of_v(),
            s_dot: of_s(),
            xi: of_v(),
            q: vec![S::ZERO; sizes.positions],
            v: of_v(),
            s: of_s(),
            linear: of_v(),
            v_dot_here: of_v(),
            s_dot_here: of_s(),
            change: vec![S::ZERO; unknowns],
            v_guess: of_v(),
            s_guess: of_s(),
            jacobian: Jacobian::new(sizes),
            factors: Factors::new(unknowns),
            kept: KeptDerivatives::default(),
        }
    }

    /// Returns the number of entries in the state's memory.
    pub(super) fn memory_len(&self) -> usize {
        HEAD + self.jacobian.parts().iter().map(|part| part.len()).sum::<usize>()
    }

    /// Reads the derivatives from the state's memory.
    pub(super) fn recall(&mut self, memory: &[S]) {
        let (head, mut derivatives) = memory.split_at(HEAD);
        let [known, least, beyond] = [0, 1, 2].map(|i| head[i].value());
        self.kept = KeptDerivatives { known: known != 0.0, least: least as usize, beyond: beyond as usize };
        for part in self.jacobian.parts_mut() {
            let (own, rest) = derivatives.split_at(part.len());
            part.copy_from_slice(own);
            derivatives = rest;
        }
    }

    /// Writes the derivatives to the state's memory.
    pub(super) fn keep(&self, memory: &mut [S]) {
        let KeptDerivatives { known, least, beyond } = self.kept;
        let (head, mut derivatives) = memory.split_at_mut(HEAD);
        head.copy_from_slice(&[f64::from(known), least as f64, beyond as f64].map(S::constant));
        for part in self.jacobian.parts() {
            let (own, rest) = derivatives.split_at_mut(part.len());
            own.copy_from_slice(part);
            derivatives = rest;
        }
    }

    /// Solves `r = f(retract(q0, xi(r)), v(r), s(r))` for the rates `r = (v', s')` from the guess in `v_dot`
    /// and `s_dot`: the change `d` in an iteration solves `(1 - xi_slope df/dxi - slope df/d(v, s)) d = f -
    /// r`, and it ends when the next change would be rounding.
    ///
    /// Derivatives are kept from step to step. New ones cost one evaluation per column. They are computed
    /// when the additional iterations with the old ones have cost as much, or when an iteration with the old
    /// ones is slow; that iteration then restarts.
    pub(super) fn solve<Y: System<S>>(
        &mut self,
        system: &mut Y,
        state: &State<S>,
        place: ImplicitStage,
    ) -> Result<(), StepError> {
        system.accept();
        let free = (0..self.v_dot.len()).filter(|&i| system.is_free(i)).count();
        let columns = 2 * free + self.active().len();
        if self.kept.known && self.kept.beyond < columns {
            self.v_guess.copy_from_slice(&self.v_dot);
            self.s_guess.copy_from_slice(&self.s_dot);
            if let Ok(iterations) = self.iterate(system, state, place, false) {
                self.kept.beyond += iterations.saturating_sub(self.kept.least);
                return Ok(());
            }
            self.v_dot.copy_from_slice(&self.v_guess);
            self.s_dot.copy_from_slice(&self.s_guess);
        }
        let least = self.iterate(system, state, place, true)?;
        self.kept = KeptDerivatives { known: true, least, beyond: 0 };
        Ok(())
    }

    /// Iterates to the solution. With `renew`, derivatives are computed in the first iteration, and again if
    /// the iteration is slow; without it, slow convergence is an error.
    fn iterate<Y: System<S>>(
        &mut self,
        system: &mut Y,
        state: &State<S>,
        place: ImplicitStage,
        renew: bool,
    ) -> Result<usize, StepError> {
        let (mut residual, mut stale) = (f64::INFINITY, renew);
        let stalled = if renew { ALLOWED } else { SMALL };
        self.begin(place);
        for iteration in 1..=MOST_ITERATIONS {
            self.put(system, state, place);
            if stale {
                self.differentiate(system, state, place);
            }
            if stale || iteration == 1 {
                self.factor(place);
            }
            self.evaluate(system, state, place);
            self.factors.solve(&mut self.change);
            self.move_by_change(place);
            let before = core::mem::replace(&mut residual, self.residual(place));
            if residual.is_nan() {
                return Err(not_converged(place, residual, iteration));
            }
            let contraction = if iteration == 1 { 1.0 } else { residual / before };
            let next_is_rounding = residual <= SMALL && residual * contraction <= ROUNDING;
            let stalls = iteration > 1 && contraction > 0.5 && residual <= stalled;
            if residual == 0.0 || next_is_rounding || stalls {
                self.put(system, state, place);
                let carried = self.jacobian.passive;
                self.s_dot[..carried].copy_from_slice(&self.s_dot_here[..carried]);
                return Ok(iteration);
            }
            stale = iteration > 1 && contraction > SLOW;
            if stale && !renew {
                return Err(not_converged(place, residual, iteration));
            }
        }
        Err(not_converged(place, residual, MOST_ITERATIONS))
    }

    /// Computes the stage of the initial guess. The iteration then adds the changes to this stage. A stage
    /// recomputed from the accelerations would have their rounding error times the step squared, which is far
    /// larger in a stiff system.
    fn begin(&mut self, place: ImplicitStage) {
        self.v.copy_from_slice(&self.v_start);
        accumulate(&mut self.v, place.slope, &self.v_dot);
        self.s.copy_from_slice(&self.s_start);
        accumulate(&mut self.s, place.slope, &self.s_dot);
        self.linear.copy_from_slice(&self.xi_start);
        accumulate(&mut self.linear, place.xi_slope, &self.v_dot);
    }

    /// Adds the change to the rates and to the stage.
    fn move_by_change(&mut self, place: ImplicitStage) {
        let active = self.active();
        let (of_s, of_v) = self.change.split_at(active.len());
        accumulate(&mut self.s_dot[active.clone()], 1.0, of_s);
        accumulate(&mut self.s[active], place.slope, of_s);
        accumulate(&mut self.v_dot, 1.0, of_v);
        accumulate(&mut self.v, place.slope, of_v);
        accumulate(&mut self.linear, place.xi_slope, of_v);
    }

    /// Returns the indices of the entries of s whose rates are unknown.
    fn active(&self) -> Range<usize> {
        self.jacobian.passive..self.s.len()
    }

    /// Computes the positions of the stage.
    fn put<Y: System<S>>(&mut self, system: &Y, state: &State<S>, place: ImplicitStage) {
        self.xi.copy_from_slice(&self.linear);
        if place.rotation == RotationBy::HalfCayley {
            half_cayley(system, &mut self.xi);
        }
        system.retract(&state.q, &self.xi, &mut self.q);
    }

    fn differentiate<Y: System<S>>(&mut self, system: &mut Y, state: &State<S>, place: ImplicitStage) {
        let Self { xi, q, v, s, jacobian, .. } = self;
        let at = Stage { time_s: place.time_s, interval: place.interval, q, v, s, d: &state.d, m: &state.m };
        system.jacobian(&state.q, xi, at, jacobian);
    }

    /// Factors the derivatives. The derivative of the Cayley transform is replaced by the identity: the
    /// difference is of the order of the squared angle of a step, and derivatives affect only the speed of
    /// convergence.
    fn factor(&mut self, place: ImplicitStage) {
        let Self { jacobian, factors, v_dot, .. } = self;
        let (xi_slope, slope) = (S::constant(place.xi_slope), S::constant(place.slope));
        let (rows, n) = (jacobian.rows, v_dot.len());
        let active = rows - n;
        // Index among the unknowns, where s' is first, of a row of the derivatives, where v' is first.
        let unknown = |row: usize| if row < n { row + active } else { row - n };
        for column in 0..rows {
            let to = &mut factors.entries[unknown(column) * rows..][..rows];
            for row in 0..rows {
                let derivative = match column.checked_sub(n) {
                    None => xi_slope * jacobian.by_xi[column * rows + row] + slope * jacobian.by_v[column * rows + row],
                    Some(extra) => slope * jacobian.by_s[extra * rows + row],
                };
                to[unknown(row)] = -derivative;
            }
            to[unknown(column)] += S::ONE;
        }
        factors.factor();
    }

    /// `change = f - r`.
    fn evaluate<Y: System<S>>(&mut self, system: &mut Y, state: &State<S>, place: ImplicitStage) {
        system.reject();
        let active = self.active();
        let Self { v_dot, s_dot, q, v, s, v_dot_here, s_dot_here, change, .. } = self;
        let at = Stage { time_s: place.time_s, interval: place.interval, q, v, s, d: &state.d, m: &state.m };
        system.rates(at, v_dot_here, s_dot_here);
        let here = s_dot_here[active.clone()].iter().chain(&*v_dot_here);
        let sought = s_dot[active].iter().chain(&*v_dot);
        for ((change, here), sought) in change.iter_mut().zip(here).zip(sought) {
            *change = *here - *sought;
        }
    }

    /// Returns the last relative change of the rates: of v', or of s' if that is larger.
    fn residual(&self, place: ImplicitStage) -> f64 {
        let step_s = place.interval.end_s - place.interval.start_s;
        let (of_s, of_v) = self.change.split_at(self.active().len());
        let rest = REST * (1.0 + largest(&self.q)) / step_s;
        let velocities = largest(&self.v) + place.slope * largest(&self.v_dot) + rest;
        let motion = place.slope * largest(of_v) / velocities;
        let (s, s_dot) = (&self.s[self.active()], &self.s_dot[self.active()]);
        let extras = largest(s) + place.slope * largest(s_dot) + SMALLEST_EXTRA;
        let memory = place.slope * largest(of_s) / extras;
        if motion >= memory || motion.is_nan() { motion } else { memory }
    }
}

fn not_converged(place: ImplicitStage, residual: f64, iterations: usize) -> StepError {
    StepError::NotConverged { time_s: place.interval.end_s, residual, allowed: ALLOWED, iterations }
}

/// Returns half of the rotation vector of the Cayley transform of twice `xi`: `atan |xi|` about `xi`; for
/// small angles its series.
fn half_cayley<S: Scalar, Y: System<S>>(system: &Y, xi: &mut [S]) {
    let mut i = 0;
    while i < xi.len() {
        if !system.is_rotation_rate(i) {
            i += 1;
            continue;
        }
        let square = xi[i..i + 3].iter().fold(S::ZERO, |sum, x| sum + *x * *x);
        let series = || {
            let c = S::constant;
            S::ONE - square * (c(1.0 / 3.0) - square * (c(0.2) - square * c(1.0 / 7.0)))
        };
        let closed = || {
            let length = square.sqrt();
            length.atan2(S::ONE) / length
        };
        // Below this angle the first omitted term of the series is below rounding.
        let factor = square.select_below(1e-4, series, closed);
        xi[i..i + 3].iter_mut().for_each(|x| *x = *x * factor);
        i += 3;
    }
}
