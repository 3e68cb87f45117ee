//! Newton's method for the accelerations at a stage that they lead to themselves.

use super::linear::Factors;
use super::{Interval, Jacobian, Sizes, Stage, StepError, System, accumulate, largest};
use crate::scalar::Scalar;
use crate::state::State;

/// Iterations until a step is given up.
const MOST_ITERATIONS: usize = 50;

/// The last change of the rates, over their size, that a solution may have.
const ALLOWED: f64 = 1e-9;

/// Changes below this, over the size of the rates, are near rounding.
const SMALL: f64 = 1e-12;

/// The change that is expected next where the iteration ends: rounding.
const ROUNDING: f64 = 1e-16;

/// A change by more than this part of the one before asks for new derivatives.
const SLOW: f64 = 0.25;

/// Positions count with this part of their size over the step in the size of the rates: then a
/// system at rest, whose rates are rounding, converges as well.
const REST: f64 = 1e-3;

/// Numbers of the memory before the derivatives: whether there are any, the iterations with new ones,
/// and those beyond since.
const HEAD: usize = 3;

/// How local coordinates move a rotation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum RotationBy {
    /// The exponential: `xi` is the rotation vector.
    Exponential,
    /// The Cayley transform: the angle is `2 atan` of half the length; here of half a step, so
    /// that the angle is `atan` of the length.
    HalfCayley,
}

/// A stage by the accelerations there: `xi = xi_start + xi_slope v'`, `v = v_start + v_slope v'`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) time_s: f64,
    pub(super) interval: Interval,
    /// s^2.
    pub(super) xi_slope: f64,
    /// s.
    pub(super) v_slope: f64,
    pub(super) rotation: RotationBy,
}

/// The unknown stage, and the memory to find it.
#[derive(Clone, Debug)]
pub(super) struct Newton<S> {
    /// Given: the constant parts of xi and v.
    pub(super) xi_start: Vec<S>,
    pub(super) v_start: Vec<S>,
    /// A guess, then the solution.
    pub(super) v_dot: Vec<S>,
    /// Found: the rates of s, and the stage.
    pub(super) s_dot: Vec<S>,
    pub(super) xi: Vec<S>,
    pub(super) q: Vec<S>,
    pub(super) v: Vec<S>,
    /// `xi` before the Cayley transform.
    linear: Vec<S>,
    change: Vec<S>,
    guess: Vec<S>,
    jacobian: Jacobian<S>,
    factors: Factors<S>,
    kept: Kept,
}

/// What is known of derivatives that were taken in a step before.
#[derive(Clone, Copy, Debug, Default)]
struct Kept {
    known: bool,
    /// Iterations of the step in which they were new.
    least: usize,
    /// Iterations beyond those, in the steps since.
    beyond: usize,
}

impl<S: Scalar> Newton<S> {
    pub(super) fn new(sizes: Sizes) -> Self {
        let n = sizes.velocities;
        let [xi_start, v_start, v_dot, xi, v, linear, change, guess] = core::array::from_fn(|_| vec![S::ZERO; n]);
        let (s_dot, q) = (vec![S::ZERO; sizes.extras], vec![S::ZERO; sizes.positions]);
        let (jacobian, factors) = (Jacobian::new(sizes), Factors::new(n));
        let kept = Kept::default();
        Self { xi_start, v_start, v_dot, s_dot, xi, q, v, linear, change, guess, jacobian, factors, kept }
    }

    /// Numbers that the state's memory holds.
    pub(super) fn memory_len(&self) -> usize {
        HEAD + self.jacobian.by_xi.len() + self.jacobian.by_v.len()
    }

    /// Takes up the derivatives that the state's memory holds.
    pub(super) fn recall(&mut self, memory: &[S]) {
        let (head, derivatives) = memory.split_at(HEAD);
        let [known, least, beyond] = [0, 1, 2].map(|i| head[i].value());
        self.kept = Kept { known: known != 0.0, least: least as usize, beyond: beyond as usize };
        let (by_xi, by_v) = derivatives.split_at(self.jacobian.by_xi.len());
        self.jacobian.by_xi.copy_from_slice(by_xi);
        self.jacobian.by_v.copy_from_slice(by_v);
    }

    /// Leaves them in the state's memory.
    pub(super) fn keep(&self, memory: &mut [S]) {
        let Kept { known, least, beyond } = self.kept;
        let (head, derivatives) = memory.split_at_mut(HEAD);
        head.copy_from_slice(&[f64::from(known), least as f64, beyond as f64].map(S::constant));
        let (by_xi, by_v) = derivatives.split_at_mut(self.jacobian.by_xi.len());
        by_xi.copy_from_slice(&self.jacobian.by_xi);
        by_v.copy_from_slice(&self.jacobian.by_v);
    }

    /// Solves `v' = f(retract(q0, xi(v')), v(v'))` from the guess in `v_dot`: the change `d` of an
    /// iteration solves `(1 - xi_slope df/dxi - v_slope df/dv) d = f - v'`, and it ends where the next
    /// change would be rounding.
    ///
    /// Derivatives are kept from step to step. New ones cost an evaluation a column: they are taken once
    /// the iterations beyond those of a step with new ones add up to that, or where an iteration with the
    /// kept ones is slow, which then begins again.
    pub(super) fn solve<Y: System<S>>(
        &mut self,
        system: &mut Y,
        state: &State<S>,
        place: Place,
    ) -> Result<(), StepError> {
        system.accept();
        let columns = 2 * (0..self.v_dot.len()).filter(|&i| system.is_free(i)).count();
        if self.kept.known && self.kept.beyond < columns {
            self.guess.copy_from_slice(&self.v_dot);
            if let Ok(iterations) = self.iterate(system, state, place, false) {
                self.kept.beyond += iterations.saturating_sub(self.kept.least);
                return Ok(());
            }
            self.v_dot.copy_from_slice(&self.guess);
        }
        let least = self.iterate(system, state, place, true)?;
        self.kept = Kept { known: true, least, beyond: 0 };
        Ok(())
    }

    /// Iterations until the solution is there. With `renew` derivatives are taken at the first, and again
    /// where it is slow; without, slow is an error.
    fn iterate<Y: System<S>>(
        &mut self,
        system: &mut Y,
        state: &State<S>,
        place: Place,
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
            accumulate(&mut self.v_dot, 1.0, &self.change);
            accumulate(&mut self.v, place.v_slope, &self.change);
            accumulate(&mut self.linear, place.xi_slope, &self.change);
            let before = core::mem::replace(&mut residual, self.residual(place));
            if residual.is_nan() {
                return Err(not_converged(place, residual, iteration));
            }
            let contraction = if iteration == 1 { 1.0 } else { residual / before };
            let next_is_rounding = residual <= SMALL && residual * contraction <= ROUNDING;
            let stalls = iteration > 1 && contraction > 0.5 && residual <= stalled;
            if residual == 0.0 || next_is_rounding || stalls {
                self.put(system, state, place);
                return Ok(iteration);
            }
            stale = iteration > 1 && contraction > SLOW;
            if stale && !renew {
                return Err(not_converged(place, residual, iteration));
            }
        }
        Err(not_converged(place, residual, MOST_ITERATIONS))
    }

    /// The stage that the guess gives. From there it moves by the changes: computed again from the
    /// accelerations, it would carry their rounding times the step squared, which in a stiff system
    /// is far more than its own.
    fn begin(&mut self, place: Place) {
        self.v.copy_from_slice(&self.v_start);
        accumulate(&mut self.v, place.v_slope, &self.v_dot);
        self.linear.copy_from_slice(&self.xi_start);
        accumulate(&mut self.linear, place.xi_slope, &self.v_dot);
    }

    /// The positions of the stage.
    fn put<Y: System<S>>(&mut self, system: &Y, state: &State<S>, place: Place) {
        self.xi.copy_from_slice(&self.linear);
        if place.rotation == RotationBy::HalfCayley {
            half_cayley(system, &mut self.xi);
        }
        system.retract(&state.q, &self.xi, &mut self.q);
    }

    fn differentiate<Y: System<S>>(&mut self, system: &mut Y, state: &State<S>, place: Place) {
        let Self { xi, q, v, jacobian, .. } = self;
        let at = Stage { time_s: place.time_s, interval: place.interval, q, v, s: &state.s, d: &state.d, m: &state.m };
        system.jacobian(&state.q, xi, at, jacobian);
    }

    /// The factors of the derivatives. Those of the Cayley transform are taken as one: it differs by the
    /// square of the angle of a step, and derivatives set the speed of the iteration, not its end.
    fn factor(&mut self, place: Place) {
        let Self { jacobian, factors, v_dot, .. } = self;
        let (xi_slope, v_slope) = (S::constant(place.xi_slope), S::constant(place.v_slope));
        for (k, entry) in factors.entries.iter_mut().enumerate() {
            *entry = -(xi_slope * jacobian.by_xi[k] + v_slope * jacobian.by_v[k]);
        }
        let n = v_dot.len();
        (0..n).for_each(|i| factors.entries[i * n + i] += S::ONE);
        factors.factor();
    }

    /// `change = f - v'`.
    fn evaluate<Y: System<S>>(&mut self, system: &mut Y, state: &State<S>, place: Place) {
        system.reject();
        let Self { v_dot, s_dot, q, v, change, .. } = self;
        let at = Stage { time_s: place.time_s, interval: place.interval, q, v, s: &state.s, d: &state.d, m: &state.m };
        system.rates(at, change, s_dot);
        change.iter_mut().zip(v_dot).for_each(|(change, v_dot)| *change -= *v_dot);
    }

    /// The last change of the rates over their size.
    fn residual(&self, place: Place) -> f64 {
        let step_s = place.interval.end_s - place.interval.start_s;
        let rest = REST * (1.0 + largest(&self.q)) / step_s;
        let rates = largest(&self.v) + place.v_slope * largest(&self.v_dot) + rest;
        place.v_slope * largest(&self.change) / rates
    }
}

fn not_converged(place: Place, residual: f64, iterations: usize) -> StepError {
    StepError::NotConverged { time_s: place.interval.end_s, residual, allowed: ALLOWED, iterations }
}

/// Rotations by half of the Cayley transform of twice `xi`: `atan |xi|` about `xi`; for
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
        let factor = square.select_below(1e-4, series, closed);
        xi[i..i + 3].iter_mut().for_each(|x| *x = *x * factor);
        i += 3;
    }
}
