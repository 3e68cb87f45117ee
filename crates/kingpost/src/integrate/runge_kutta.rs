//! Explicit Runge-Kutta schemes in Munthe-Kaas' form.

use super::{Interval, Sizes, Stage, System, accumulate};
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
struct Rates {
    xi: Vec<f64>,
    v: Vec<f64>,
    s: Vec<f64>,
}

/// An explicit scheme with its working memory.
#[derive(Clone, Debug)]
pub struct ExplicitRungeKutta {
    tableau: &'static Tableau,
    rates: Vec<Rates>,
    /// Local coordinates, and q, v, s of a stage.
    xi: Vec<f64>,
    q: Vec<f64>,
    v: Vec<f64>,
    s: Vec<f64>,
}

impl ExplicitRungeKutta {
    /// A scheme for arrays of these sizes.
    pub fn new(tableau: &'static Tableau, sizes: Sizes) -> Self {
        let Sizes { positions, velocities, extras } = sizes;
        let rates = || Rates { xi: vec![0.0; velocities], v: vec![0.0; velocities], s: vec![0.0; extras] };
        Self {
            tableau,
            rates: (0..tableau.stages).map(|_| rates()).collect(),
            xi: vec![0.0; velocities],
            q: vec![0.0; positions],
            v: vec![0.0; velocities],
            s: vec![0.0; extras],
        }
    }

    /// Moves the state over the interval.
    pub fn step<Y: System>(&mut self, system: &mut Y, interval: Interval, state: &mut State) {
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
    fn combine<Y: System>(&mut self, weights: &[f64], h: f64, system: &Y, state: &State) {
        self.xi.fill(0.0);
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
    fn evaluate<Y: System>(&mut self, stage: usize, system: &mut Y, interval: Interval, state: &State) {
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
