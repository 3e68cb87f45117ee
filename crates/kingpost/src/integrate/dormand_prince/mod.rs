//! Dormand-Prince pair of orders 5 and 4, with error control and dense output.

mod control;

use super::runge_kutta::{Stages, Tableau, Triple};
use super::{Interval, Sizes, Stage, StepError, System};
use crate::scalar::Scalar;
use crate::state::State;
use control::{Controller, error};

pub use control::Tolerances;

/// The pair's scheme of order 5 (Dormand & Prince 1980; Hairer, Norsett & Wanner, *Solving Ordinary
/// Differential Equations I*, 2nd ed., 1993, table II.5.2). The last stage is at the end of the step and is
/// the first stage of the next step.
static TABLEAU: Tableau = Tableau {
    a: &[
        &[1.0 / 5.0],
        &[3.0 / 40.0, 9.0 / 40.0],
        &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
        &[19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0],
        &[9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0],
        &[35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
    ],
    b: &WEIGHTS,
    c: &[0.0, 1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0, 1.0, 1.0],
};

const STAGES: usize = 7;

const WEIGHTS: [f64; STAGES] = [35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0, 0.0];

/// Weights of the term `theta^2 (1 - theta)^2` of the dense output (Shampine 1986; the book above,
/// section II.6, and the program DOPRI5 in its appendix).
const DENSE: [f64; STAGES] = [
    -12715105075.0 / 11282082432.0,
    0.0,
    87487479700.0 / 32700410799.0,
    -10690763975.0 / 1880347072.0,
    701980252875.0 / 199316789632.0,
    -1453857185.0 / 822651844.0,
    69997945.0 / 29380423.0,
];

/// Number of entries at the start of the memory: start and end of the inner step, s, and two of the
/// controller.
const HEAD: usize = 4;

/// Scheme that takes inner steps as long as its tolerances allow, and computes the state at the end of each
/// interval by dense output of order 4. An inner step may reach beyond the interval, but never beyond the
/// next edge. It continues in the next interval unless the state was changed, by a lever or from outside;
/// then the scheme restarts. Loops are closed at the end of each inner step, and its last stage is then
/// evaluated again. The state's memory contains the inner step, so a run from a snapshot is bitwise
/// identical. Extra states have the same weights; of them only [motions](System::motions) are part of the error.
#[derive(Clone, Debug)]
pub struct DormandPrince<S = f64> {
    controller: Controller,
    /// Last inner step; its length is 0 if there is none.
    inner: Interval,
    q: Vec<S>,
    v: Vec<S>,
    s: Vec<S>,
    stages: Stages<S>,
}

impl<S: Scalar> DormandPrince<S> {
    /// Creates a scheme for arrays of these sizes; `step_s` is tried first.
    pub fn new(sizes: Sizes, tolerances: Tolerances, step_s: f64) -> Self {
        let zeros = |n| vec![S::ZERO; n];
        Self {
            controller: Controller::new(tolerances, step_s),
            inner: Interval { start_s: 0.0, end_s: 0.0 },
            q: zeros(sizes.positions),
            v: zeros(sizes.velocities),
            s: zeros(sizes.extras),
            stages: Stages::new(&TABLEAU, sizes),
        }
    }

    /// Returns the number of entries in the state's memory, with `discrete` discrete numbers and modes.
    pub fn memory_len(&self, discrete: usize) -> usize {
        let (velocities, extras) = (self.v.len(), self.s.len());
        HEAD + self.q.len() + velocities + extras + STAGES * (2 * velocities + extras) + discrete
    }

    /// Moves the state over the interval; `edge_s` is the next time at which a law changes form, s.
    pub fn step<Y: System<S>>(
        &mut self,
        system: &mut Y,
        interval: Interval,
        edge_s: f64,
        state: &mut State<S>,
    ) -> Result<(), StepError> {
        self.load(state);
        if !self.continues(system, interval.start_s, state) {
            self.begin(system, interval, state);
        }
        while self.inner.end_s < interval.end_s {
            self.inner_step(system, edge_s, state)?;
        }
        self.hand_out(system, interval.end_s, state);
        if self.inner.end_s == edge_s {
            // The rates at an edge are those of the law before the edge.
            self.inner.start_s = edge_s;
        }
        self.save(state);
        Ok(())
    }

    /// Moves q, v and s of a state to a time within the inner step in its memory, by dense output; returns
    /// whether there is such a step.
    pub fn interpolate<Y: System<S>>(&mut self, system: &Y, time_s: f64, state: &mut State<S>) -> bool {
        self.load(state);
        let Interval { start_s, end_s } = self.inner;
        let is_within = start_s < end_s && (start_s..=end_s).contains(&time_s);
        if is_within {
            self.hand_out(system, time_s, state);
        }
        is_within
    }

    fn hand_out<Y: System<S>>(&mut self, system: &Y, time_s: f64, state: &mut State<S>) {
        self.dense_output(system, time_s);
        self.stages.hand_out(&mut state.q, &mut state.v, &mut state.s);
    }

    /// Returns whether the state is that of the last inner step. The rates of coordinates that are not free
    /// are functions of time; a difference by rounding does not count.
    fn continues<Y: System<S>>(&mut self, system: &mut Y, time_s: f64, state: &State<S>) -> bool {
        let Interval { start_s, end_s } = self.inner;
        if start_s == end_s || !(start_s..=end_s).contains(&time_s) || !self.same_discrete(state) {
            return false;
        }
        self.dense_output(system, time_s);
        let Stages { q, place, .. } = &mut self.stages;
        let [_, v, s] = place.parts_mut();
        system.close(q, v);
        let same_rates = (0..v.len()).all(|i| v[i] == state.v[i] || !system.is_free(i));
        same_rates && q[..] == state.q[..] && s[..] == state.s[..]
    }

    /// Returns whether the discrete numbers and modes equal those in the memory.
    fn same_discrete(&self, state: &State<S>) -> bool {
        let (modes, numbers) = (state.m.len(), state.d.len());
        let (_, held) = state.memory.split_at(state.memory.len() - numbers - modes);
        let of_modes = state.m.iter().map(|mode| S::constant(*mode as f64));
        held.iter().copied().eq(state.d.iter().copied().chain(of_modes))
    }

    /// Sets an inner step of length 0 at the state, with its first stage.
    fn begin<Y: System<S>>(&mut self, system: &mut Y, interval: Interval, state: &State<S>) {
        self.inner = Interval { start_s: interval.start_s, end_s: interval.start_s };
        self.q.copy_from_slice(&state.q);
        self.v.copy_from_slice(&state.v);
        self.s.copy_from_slice(&state.s);
        let State { q, v, s, d, m, .. } = state;
        self.stages.begin(system, Stage { time_s: interval.start_s, interval, q, v, s, d, m });
        system.accept();
    }

    /// Takes the next inner step, shortened until its error is within the tolerances.
    fn inner_step<Y: System<S>>(&mut self, system: &mut Y, edge_s: f64, state: &State<S>) -> Result<(), StepError> {
        self.move_to_end(system, state);
        let Self { controller, inner, q, v, s, stages } = self;
        let start_s = inner.end_s;
        loop {
            let interval = controller.interval(start_s, edge_s);
            let h = interval.end_s - start_s;
            let base = Stage { time_s: start_s, interval, q, v, s, d: &state.d, m: &state.m };
            stages.stand_on(base);
            stages.go_on(system, base)?;
            let error = error(stages, controller.tolerances, h, v, system.motions());
            if controller.accepts(interval, error)? {
                *inner = interval;
                system.accept();
                return Ok(());
            }
            system.reject();
        }
    }

    /// Makes the end of the last inner step the base of the next step, and its last stage the first one.
    fn move_to_end<Y: System<S>>(&mut self, system: &mut Y, state: &State<S>) {
        if self.inner.start_s == self.inner.end_s {
            return;
        }
        self.dense_output(system, self.inner.end_s);
        let Self { inner, q, v, s, stages, .. } = self;
        stages.hand_out(q, v, s);
        if system.close(q, v) {
            let (time_s, interval) = (inner.end_s, Interval { start_s: inner.end_s, end_s: inner.end_s });
            stages.begin(system, Stage { time_s, interval, q, v, s, d: &state.d, m: &state.m });
            system.accept();
            return;
        }
        let (first, last) = stages.rates.split_at_mut(STAGES - 1);
        first[0].copy_from(&last[0]);
        first[0].parts_mut()[0].copy_from_slice(v);
    }

    /// Computes q, v, s of the stages at a time within the inner step.
    fn dense_output<Y: System<S>>(&mut self, system: &Y, time_s: f64) {
        let Self { inner, q, v, s, stages, .. } = self;
        let h = inner.end_s - inner.start_s;
        let theta = if time_s == inner.end_s { 1.0 } else { (time_s - inner.start_s) / h };
        let base = Stage { time_s: inner.start_s, interval: *inner, q, v, s, d: &[], m: &[] };
        stages.stand_on(base);
        stages.combine(&dense_weights(theta), h, system, base.q);
    }

    fn load(&mut self, state: &State<S>) {
        let mut from = state.memory.as_slice();
        let mut next = || {
            let (first, rest) = from.split_at(1);
            from = rest;
            first[0].value()
        };
        self.inner = Interval { start_s: next(), end_s: next() };
        self.controller.restore(next(), next());
        for part in self.parts() {
            let (numbers, rest) = from.split_at(part.len());
            part.copy_from_slice(numbers);
            from = rest;
        }
    }

    fn save(&mut self, state: &mut State<S>) {
        let (wanted_s, error) = self.controller.memory();
        let head = [self.inner.start_s, self.inner.end_s, wanted_s, error].map(S::constant);
        let (start, mut to) = state.memory.split_at_mut(HEAD);
        start.copy_from_slice(&head);
        for part in self.parts() {
            let (numbers, rest) = to.split_at_mut(part.len());
            numbers.copy_from_slice(part);
            to = rest;
        }
        let (numbers, modes) = to.split_at_mut(state.d.len());
        numbers.copy_from_slice(&state.d);
        modes.iter_mut().zip(&state.m).for_each(|(held, mode)| *held = S::constant(*mode as f64));
    }

    /// Returns the parts of the inner step in the memory: its base and the rates of its stages.
    fn parts(&mut self) -> impl Iterator<Item = &mut [S]> {
        let rates = self.stages.rates.iter_mut().map(Triple::all_mut);
        [&mut self.q, &mut self.v, &mut self.s].into_iter().map(Vec::as_mut_slice).chain(rates)
    }
}

/// Returns the weights of the stages at a share `theta` of the step: the cubic Hermite interpolant and the
/// term of [`DENSE`].
fn dense_weights(theta: f64) -> [f64; STAGES] {
    let rest = 1.0 - theta;
    let mut weights =
        core::array::from_fn(|i| theta * theta * ((3.0 - 2.0 * theta) * WEIGHTS[i] + rest * rest * DENSE[i]));
    weights[0] += theta * rest * rest;
    weights[STAGES - 1] -= theta * theta * rest;
    weights
}
