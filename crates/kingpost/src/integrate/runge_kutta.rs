//! Explicit Runge-Kutta schemes in Munthe-Kaas' form.

use super::{Interval, Sizes, Stage, System, accumulate};
use crate::scalar::Scalar;
use crate::state::State;

/// Butcher's tableau of an explicit scheme with at most four stages.
#[derive(Debug)]
pub struct Tableau {
    /// Number of stages.
    pub stages: usize,
    /// Weights of earlier stages in stages 2, 3, 4.
    pub a: [[f64; 3]; 3],
    /// Weights of the step.
    pub b: [f64; 4],
    /// Places of the stages in the step.
    pub c: [f64; 4],
}

/// The classical scheme of order 4 (Kutta 1901; on the group: Munthe-Kaas 1998).
pub static RUNGE_KUTTA_4: Tableau = Tableau {
    stages: 4,
    a: [[0.5, 0.0, 0.0], [0.0, 0.5, 0.0], [0.0, 0.0, 1.0]],
    b: [1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0],
    c: [0.0, 0.5, 0.5, 1.0],
};

/// Rates of one stage.
#[derive(Clone, Debug)]
struct Rates<S> {
    xi: Vec<S>,
    v: Vec<S>,
    s: Vec<S>,
}

/// An explicit scheme with its working memory.
#[derive(Clone, Debug)]
pub struct ExplicitRungeKutta<S = f64> {
    tableau: &'static Tableau,
    rates: Vec<Rates<S>>,
    /// Local coordinates, and q, v, s of a stage.
    xi: Vec<S>,
    q: Vec<S>,
    v: Vec<S>,
    s: Vec<S>,
}

impl<S: Scalar> ExplicitRungeKutta<S> {
    /// A scheme for arrays of these sizes.
    pub fn new(tableau: &'static Tableau, sizes: Sizes) -> Self {
        let Sizes { positions, velocities, extras } = sizes;
        let rates = || Rates { xi: vec![S::ZERO; velocities], v: vec![S::ZERO; velocities], s: vec![S::ZERO; extras] };
        Self {
            tableau,
            rates: (0..tableau.stages).map(|_| rates()).collect(),
            xi: vec![S::ZERO; velocities],
            q: vec![S::ZERO; positions],
            v: vec![S::ZERO; velocities],
            s: vec![S::ZERO; extras],
        }
    }

    /// Moves the state over the interval.
    pub fn step<Y: System<S>>(&mut self, system: &mut Y, interval: Interval, state: &mut State<S>) {
        let (tableau, h) = (self.tableau, interval.end_s - interval.start_s);
        self.evaluate(0, system, interval, state);
        for stage in 1..tableau.stages {
            self.combine(&tableau.a[stage - 1][..stage], h, system, state);
            self.evaluate(stage, system, interval, state);
        }
        self.combine(&tableau.b[..tableau.stages], h, system, state);
        state.q.copy_from_slice(&self.q);
        state.v.copy_from_slice(&self.v);
        state.s.copy_from_slice(&self.s);
    }

    /// q, v, s at `state` plus h times the weighted rates.
    fn combine<Y: System<S>>(&mut self, weights: &[f64], h: f64, system: &Y, state: &State<S>) {
        self.xi.fill(S::ZERO);
        self.v.copy_from_slice(&state.v);
        self.s.copy_from_slice(&state.s);
        for (weight, rates) in weights.iter().zip(&self.rates).filter(|(weight, _)| **weight != 0.0) {
            accumulate(&mut self.xi, h * weight, &rates.xi);
            accumulate(&mut self.v, h * weight, &rates.v);
            accumulate(&mut self.s, h * weight, &rates.s);
        }
        system.retract(&state.q, &self.xi, &mut self.q);
    }

    /// Rates of a stage; the first stage stands at the state itself.
    fn evaluate<Y: System<S>>(&mut self, stage: usize, system: &mut Y, interval: Interval, state: &State<S>) {
        let time_s = match self.tableau.c[stage] {
            1.0 => interval.end_s,
            c => interval.start_s + c * (interval.end_s - interval.start_s),
        };
        let rates = &mut self.rates[stage];
        let (q, v, s) = if stage == 0 { (&state.q, &state.v, &state.s) } else { (&self.q, &self.v, &self.s) };
        system.rates(Stage { time_s, interval, q, v, s, d: &state.d }, &mut rates.v, &mut rates.s);
        if stage == 0 {
            rates.xi.copy_from_slice(v);
        } else {
            system.dexp_inverse(&self.xi, v, &mut rates.xi);
        }
    }
}
