//! Explicit Runge-Kutta schemes in Munthe-Kaas' form.

use super::{Interval, Sizes, Stage, System, accumulate};
use crate::scalar::Scalar;
use crate::state::State;

/// Butcher's tableau of an explicit scheme.
#[derive(Debug)]
pub struct Tableau {
    /// Weights of earlier stages in stages 2, 3 and so on.
    pub a: &'static [&'static [f64]],
    /// Weights of the step, one a stage.
    pub b: &'static [f64],
    /// Places of the stages in the step.
    pub c: &'static [f64],
}

/// The classical scheme of order 4 (Kutta 1901; on the group: Munthe-Kaas 1998).
pub static RUNGE_KUTTA_4: Tableau = Tableau {
    a: &[&[0.5], &[0.0, 0.5], &[0.0, 0.0, 1.0]],
    b: &[1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0],
    c: &[0.0, 0.5, 0.5, 1.0],
};

/// Rates of one stage.
#[derive(Clone, Debug)]
pub(super) struct Rates<S> {
    pub(super) xi: Vec<S>,
    pub(super) v: Vec<S>,
    pub(super) s: Vec<S>,
}

/// The stages of a step: their rates, and the place that weighted rates lead to.
#[derive(Clone, Debug)]
pub(super) struct Stages<S> {
    pub(super) tableau: &'static Tableau,
    pub(super) rates: Vec<Rates<S>>,
    /// Local coordinates about the step's base, and q, v, s there.
    pub(super) xi: Vec<S>,
    pub(super) q: Vec<S>,
    pub(super) v: Vec<S>,
    pub(super) s: Vec<S>,
}

impl<S: Scalar> Stages<S> {
    pub(super) fn new(tableau: &'static Tableau, sizes: Sizes) -> Self {
        let Sizes { positions, velocities, extras, .. } = sizes;
        let zeros = |n| vec![S::ZERO; n];
        let rates = || Rates { xi: zeros(velocities), v: zeros(velocities), s: zeros(extras) };
        Self {
            tableau,
            rates: tableau.b.iter().map(|_| rates()).collect(),
            xi: zeros(velocities),
            q: zeros(positions),
            v: zeros(velocities),
            s: zeros(extras),
        }
    }

    /// Rates of the first stage, which stands at the base of the step itself.
    pub(super) fn begin<Y: System<S>>(&mut self, system: &mut Y, base: Stage<'_, S>) {
        let rates = &mut self.rates[0];
        system.rates(base, &mut rates.v, &mut rates.s);
        rates.xi.copy_from_slice(base.v);
    }

    /// Rates of the later stages of a step from `base` over its interval.
    pub(super) fn go_on<Y: System<S>>(&mut self, system: &mut Y, base: Stage<'_, S>) {
        let Interval { start_s, end_s } = base.interval;
        for (stage, weights) in (1..).zip(self.tableau.a) {
            self.combine(weights, end_s - start_s, system, base);
            let time_s = match self.tableau.c[stage] {
                1.0 => end_s,
                c => start_s + c * (end_s - start_s),
            };
            let Self { rates, xi, q, v, s, .. } = self;
            let rates = &mut rates[stage];
            system.rates(Stage { time_s, q, v, s, ..base }, &mut rates.v, &mut rates.s);
            system.dexp_inverse(xi, v, &mut rates.xi);
        }
    }

    /// q, v, s at `base` plus h times the weighted rates.
    pub(super) fn combine<Y: System<S>>(&mut self, weights: &[f64], h: f64, system: &Y, base: Stage<'_, S>) {
        match *weights {
            [a] => self.sum(h, [(a, 0)], base),
            [0.0, a] => self.sum(h, [(a, 1)], base),
            [0.0, 0.0, a] => self.sum(h, [(a, 2)], base),
            [a, b, c, d] => self.sum(h, [(a, 0), (b, 1), (c, 2), (d, 3)], base),
            _ => self.sum_of_many(weights, h, base),
        }
        system.retract(base.q, &self.xi, &mut self.q);
    }
}

impl<S: Scalar> Stages<S> {
    /// Local coordinates, v and s of a few weighted stages, in one pass over each array.
    #[inline]
    fn sum<const K: usize>(&mut self, h: f64, terms: [(f64, usize); K], base: Stage<'_, S>) {
        let Self { rates, xi, v, s, .. } = self;
        let weights = terms.map(|(weight, _)| S::constant(h * weight));
        let rates = terms.map(|(_, stage)| &rates[stage]);
        weigh(xi, None, weights, rates.map(|rates| rates.xi.as_slice()));
        weigh(v, Some(base.v), weights, rates.map(|rates| rates.v.as_slice()));
        weigh(s, Some(base.s), weights, rates.map(|rates| rates.s.as_slice()));
    }

    /// The same of any number, stage by stage.
    fn sum_of_many(&mut self, weights: &[f64], h: f64, base: Stage<'_, S>) {
        self.xi.fill(S::ZERO);
        self.v.copy_from_slice(base.v);
        self.s.copy_from_slice(base.s);
        for (weight, rates) in weights.iter().zip(&self.rates).filter(|(weight, _)| **weight != 0.0) {
            accumulate(&mut self.xi, h * weight, &rates.xi);
            accumulate(&mut self.v, h * weight, &rates.v);
            accumulate(&mut self.s, h * weight, &rates.s);
        }
    }
}

/// `out = base + k1 r1 + k2 r2 + ...`, entry by entry, from left to right; without a base, from zero.
#[inline]
fn weigh<S: Scalar, const K: usize>(out: &mut [S], base: Option<&[S]>, weights: [S; K], rates: [&[S]; K]) {
    let n = out.len();
    let (rates, base) = (rates.map(|rates| &rates[..n]), base.map(|base| &base[..n]));
    for i in 0..n {
        let start = base.map_or(S::ZERO, |base| base[i]);
        out[i] = (0..K).fold(start, |sum, k| sum + weights[k] * rates[k][i]);
    }
}

/// An explicit scheme with its working memory.
#[derive(Clone, Debug)]
pub struct ExplicitRungeKutta<S = f64> {
    stages: Stages<S>,
}

impl<S: Scalar> ExplicitRungeKutta<S> {
    /// A scheme for arrays of these sizes.
    pub fn new(tableau: &'static Tableau, sizes: Sizes) -> Self {
        Self { stages: Stages::new(tableau, sizes) }
    }

    /// Moves the state over the interval. Extra states take the weights of v.
    pub fn step<Y: System<S>>(&mut self, system: &mut Y, interval: Interval, state: &mut State<S>) {
        let stages = &mut self.stages;
        let State { q, v, s, d, m, .. } = &*state;
        let base = Stage { time_s: interval.start_s, interval, q, v, s, d, m };
        stages.begin(system, base);
        stages.go_on(system, base);
        stages.combine(stages.tableau.b, interval.end_s - interval.start_s, system, base);
        state.q.copy_from_slice(&stages.q);
        state.v.copy_from_slice(&stages.v);
        state.s.copy_from_slice(&stages.s);
    }
}
