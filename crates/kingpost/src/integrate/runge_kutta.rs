//! Explicit Runge-Kutta schemes in Munthe-Kaas' form.

use super::{Interval, Sizes, Stage, StepError, System, accumulate};
use crate::scalar::Scalar;
use crate::state::State;

/// Butcher's tableau of an explicit scheme.
#[derive(Debug)]
pub struct Tableau {
    /// Weights of the earlier stages in stages 2, 3 and so on.
    pub a: &'static [&'static [f64]],
    /// Weights of the step, one per stage.
    pub b: &'static [f64],
    /// Times of the stages within the step.
    pub c: &'static [f64],
}

/// The classical scheme of order 4 (Kutta 1901; on the group: Munthe-Kaas 1998).
pub static RUNGE_KUTTA_4: Tableau = Tableau {
    a: &[&[0.5], &[0.0, 0.5], &[0.0, 0.0, 1.0]],
    b: &[1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0],
    c: &[0.0, 0.5, 0.5, 1.0],
};

/// Stages of a step: their rates, and the point at which a weighted sum of rates ends.
#[derive(Clone, Debug)]
pub(super) struct Stages<S> {
    pub(super) tableau: &'static Tableau,
    /// Rates of the local coordinates, of v and of s, by stage.
    pub(super) rates: Vec<Triple<S>>,
    /// Local coordinates relative to the base of the step, v and s at this point.
    pub(super) place: Triple<S>,
    /// q at this point.
    pub(super) q: Vec<S>,
    /// Zero local coordinates, v and s at the base.
    base: Triple<S>,
    /// Whether the system advances states itself.
    advances: bool,
}

/// Values for the local coordinates, v and s in one array of blocks of four, which are summed together.
#[derive(Clone, Debug)]
pub(super) struct Triple<S> {
    blocks: Vec<[S; 4]>,
    velocities: usize,
    extras: usize,
}

impl<S: Scalar> Triple<S> {
    fn zero(Sizes { velocities, extras, .. }: Sizes) -> Self {
        let blocks = vec![[S::ZERO; 4]; (2 * velocities + extras).div_ceil(4)];
        Self { blocks, velocities, extras }
    }

    /// Copies the values of another triple of the same sizes.
    pub(super) fn copy_from(&mut self, other: &Self) {
        self.blocks.copy_from_slice(&other.blocks);
    }

    /// Returns all values for changes.
    pub(super) fn all_mut(&mut self) -> &mut [S] {
        &mut self.blocks.as_flattened_mut()[..2 * self.velocities + self.extras]
    }

    /// Returns the parts of the local coordinates, of v and of s.
    #[inline]
    pub(super) fn parts(&self) -> [&[S]; 3] {
        let (xi, rest) = self.blocks.as_flattened().split_at(self.velocities);
        let (v, rest) = rest.split_at(self.velocities);
        [xi, v, &rest[..self.extras]]
    }

    /// Returns the parts of the local coordinates, of v and of s, for changes.
    #[inline]
    pub(super) fn parts_mut(&mut self) -> [&mut [S]; 3] {
        let (xi, rest) = self.blocks.as_flattened_mut().split_at_mut(self.velocities);
        let (v, rest) = rest.split_at_mut(self.velocities);
        [xi, v, &mut rest[..self.extras]]
    }
}

impl<S: Scalar> Stages<S> {
    pub(super) fn new(tableau: &'static Tableau, sizes: Sizes) -> Self {
        let triple = || Triple::zero(sizes);
        let rates = tableau.b.iter().map(|_| triple()).collect();
        Self { tableau, rates, place: triple(), q: vec![S::ZERO; sizes.positions], base: triple(), advances: false }
    }

    /// Computes the rates of the first stage, which is at the base of the step.
    pub(super) fn begin<Y: System<S>>(&mut self, system: &mut Y, base: Stage<'_, S>) {
        let [xi, v, s] = self.rates[0].parts_mut();
        system.rates(base, v, s);
        xi.copy_from_slice(base.v);
    }

    /// Stores v and s of the step's base for the later stages.
    pub(super) fn stand_on(&mut self, base: Stage<'_, S>) {
        let [_, v, s] = self.base.parts_mut();
        v.copy_from_slice(base.v);
        s.copy_from_slice(base.s);
    }

    /// Computes the rates of the later stages of a step from `base` over its interval.
    ///
    /// # Errors
    /// The system cannot advance its own states.
    pub(super) fn go_on<Y: System<S>>(&mut self, system: &mut Y, base: Stage<'_, S>) -> Result<(), StepError> {
        let Interval { start_s, end_s } = base.interval;
        for (stage, weights) in (1..).zip(self.tableau.a) {
            self.combine(weights, end_s - start_s, system, base.q);
            let time_s = match self.tableau.c[stage] {
                1.0 => end_s,
                c => start_s + c * (end_s - start_s),
            };
            self.advance(system, Stage { time_s, ..base }, false)?;
            let ([xi, v, s], rates) = (self.place.parts(), self.rates[stage].parts_mut());
            let [xi_rate, v_rate, s_rate] = rates;
            system.rates(Stage { time_s, q: &self.q, v, s, ..base }, v_rate, s_rate);
            system.dexp_inverse(xi, v, xi_rate);
        }
        Ok(())
    }

    /// Lets the system replace the states that it advances itself, at this point.
    fn advance<Y: System<S>>(&mut self, system: &mut Y, at: Stage<'_, S>, is_end: bool) -> Result<(), StepError> {
        if !self.advances {
            return Ok(());
        }
        let Self { q, place, .. } = self;
        let [_, v, s] = place.parts_mut();
        system.advance(Stage { q, v, s: &[], ..at }, s, is_end)
    }

    /// Computes q, v, s: the base, whose q is given, plus h times the weighted rates.
    pub(super) fn combine<Y: System<S>>(&mut self, weights: &[f64], h: f64, system: &Y, q: &[S]) {
        match *weights {
            [a] => self.sum(h, [(a, 0)]),
            [0.0, a] => self.sum(h, [(a, 1)]),
            [0.0, 0.0, a] => self.sum(h, [(a, 2)]),
            [a, b, c, d] => self.sum(h, [(a, 0), (b, 1), (c, 2), (d, 3)]),
            _ => self.sum_of_many(weights, h),
        }
        system.retract(q, self.place.parts()[0], &mut self.q);
    }

    /// Computes the point at which a few weighted stages end.
    #[inline]
    fn sum<const K: usize>(&mut self, h: f64, terms: [(f64, usize); K]) {
        let (mut weights, mut rates): ([S; K], [&[S]; K]) = ([S::ZERO; K], [&[]; K]);
        for (k, (weight, stage)) in terms.into_iter().enumerate() {
            (weights[k], rates[k]) = (S::constant(h * weight), self.rates[stage].blocks.as_flattened());
        }
        weigh(self.place.blocks.as_flattened_mut(), self.base.blocks.as_flattened(), weights, rates);
    }

    /// Computes the point at which any number of weighted stages end, stage by stage.
    fn sum_of_many(&mut self, weights: &[f64], h: f64) {
        let place = self.place.blocks.as_flattened_mut();
        place.copy_from_slice(self.base.blocks.as_flattened());
        for (weight, rates) in weights.iter().zip(&self.rates).filter(|(weight, _)| **weight != 0.0) {
            accumulate(place, h * weight, rates.blocks.as_flattened());
        }
    }

    /// Writes q, v and s of this point.
    pub(super) fn hand_out(&self, q: &mut [S], v: &mut [S], s: &mut [S]) {
        let [_, v_here, s_here] = self.place.parts();
        q.copy_from_slice(&self.q);
        v.copy_from_slice(v_here);
        s.copy_from_slice(s_here);
    }
}

/// `out = base + k1 r1 + k2 r2 + ...`, entry by entry, from left to right.
#[inline(never)]
fn weigh<S: Scalar, const K: usize>(out: &mut [S], base: &[S], weights: [S; K], mut rates: [&[S]; K]) {
    let n = out.len();
    let base = &base[..n];
    for rates in &mut rates {
        *rates = &rates[..n];
    }
    for i in 0..n {
        let mut sum = base[i];
        for k in 0..K {
            sum += weights[k] * rates[k][i];
        }
        out[i] = sum;
    }
}

/// An explicit scheme with its working memory.
#[derive(Clone, Debug)]
pub struct ExplicitRungeKutta<S = f64> {
    stages: Stages<S>,
}

impl<S: Scalar> ExplicitRungeKutta<S> {
    /// Creates a scheme for arrays of these sizes.
    pub fn new(tableau: &'static Tableau, sizes: Sizes) -> Self {
        Self { stages: Stages { advances: true, ..Stages::new(tableau, sizes) } }
    }

    /// Moves the state over the interval. Extra states have the weights of v, except those that the system advances itself.
    ///
    /// # Errors
    /// The system cannot advance its own states.
    pub fn step<Y: System<S>>(
        &mut self,
        system: &mut Y,
        interval: Interval,
        state: &mut State<S>,
    ) -> Result<(), StepError> {
        let stages = &mut self.stages;
        let State { q, v, s, d, m, .. } = &*state;
        let base = Stage { time_s: interval.start_s, interval, q, v, s, d, m };
        system.begin_stages(base);
        stages.begin(system, base);
        stages.stand_on(base);
        stages.go_on(system, base)?;
        stages.combine(stages.tableau.b, interval.end_s - interval.start_s, system, base.q);
        stages.advance(system, Stage { time_s: interval.end_s, ..base }, true)?;
        stages.hand_out(&mut state.q, &mut state.v, &mut state.s);
        Ok(())
    }
}
