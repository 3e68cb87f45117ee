//! Actions of elements between two steps: start, sampling, response to events.

use super::element_contexts::ElementContexts;
use super::{Plant, Totals};
use crate::elements::{AnyElement, Context, Element, ElementState, Occurrence, Steer, Watched};
use crate::integrate::{Interval, Stage};
use crate::ledger;
use crate::scalar::Scalar;
use crate::spatial::Vector3;
use crate::state::State;

/// Tolerance of a sampling time, as a share of the period: a time closer than this counts as reached.
const TICK_SLACK: f64 = 1e-9;

impl<S: Scalar> Plant<S> {
    /// Writes s, d and m for a run that starts at a time with the q and v of the state; `inputs` are the
    /// values of all inputs.
    pub fn begin(&mut self, time_s: f64, inputs: &[S], state: &mut State<S>) {
        state.s = vec![S::ZERO; self.layout.extras()];
        state.d = inputs.to_vec();
        state.d.resize(self.layout.discrete() - inputs.len(), S::ZERO);
        state.d.extend_from_slice(inputs);
        state.m = vec![0; self.layout.modes.len()];
        for i in 0..self.elements.len() {
            self.change(i, time_s, state, |element, at, own, _| element.begin(at, own));
        }
        self.take_hold(time_s, state);
        self.sample(time_s, state);
        self.open_ledger(time_s, state);
    }

    /// Lets every element set its modes again, after numbers were changed during a run.
    pub fn renew(&mut self, time_s: f64, state: &mut State<S>) {
        for i in 0..self.elements.len() {
            self.change(i, time_s, state, |element, at, own, _| element.renew(at, own));
        }
        self.take_hold(time_s, state);
    }

    /// Sets an input, with effect from now on and at the end of the step; its element can change its modes.
    pub fn set_input(&mut self, input: usize, value: S, time_s: f64, state: &mut State<S>) {
        state.d[self.layout.end_of(input)] = value;
        if state.d[input] == value {
            return;
        }
        state.d[input] = value;
        let Some(owner) = self.layout.slices.iter().position(|share| share.inputs.contains(&input)) else { return };
        let modes = state.m.clone();
        self.change(owner, time_s, state, |element, at, own, _| element.renew(at, own));
        if state.m != modes {
            let changed = core::mem::replace(&mut state.m, modes);
            let before = self.totals(instant(time_s, state));
            state.m = changed;
            let heat = self.take_hold(time_s, state);
            self.book_jump(&before, heat, time_s, state);
        }
    }

    /// Starts the ledger at the present state.
    pub fn open_ledger(&mut self, time_s: f64, state: &mut State<S>) {
        if self.layout.ledger == 0 {
            return;
        }
        let totals = self.totals(instant(time_s, state));
        let s = &mut state.s;
        s[..ledger::COUNT].fill(S::ZERO);
        s[ledger::INITIAL_ENERGY] = totals.kinetic_energy + totals.potential_energy;
        totals.linear_momentum.write_to(&mut s[ledger::LINEAR_MOMENTUM..]);
        totals.angular_momentum.write_to(&mut s[ledger::ANGULAR_MOMENTUM..]);
    }

    /// Returns the next time after `after_s` at which a law changes form or an element samples, s; infinity
    /// if there is none.
    pub fn next_edge_s(&self, after_s: f64, modes: &[i64]) -> f64 {
        let of = |(i, element): (usize, &AnyElement<S>)| {
            let share = &self.layout.slices[i];
            let tick = share
                .period_s
                .map_or(f64::INFINITY, |period| period * (libm::floor(after_s / period + TICK_SLACK) + 1.0));
            let own = modes.get(share.modes.clone()).unwrap_or_default();
            tick.min(element.next_edge_s(after_s, own))
        };
        self.elements.iter().enumerate().map(of).fold(f64::INFINITY, f64::min)
    }

    /// Lets each element with a sampling time now take its sample, in the order of the elements; the wires
    /// from an element are updated directly after its sample.
    pub fn sample(&mut self, time_s: f64, state: &mut State<S>) {
        for i in 0..self.elements.len() {
            let Some(period_s) = self.layout.slices[i].period_s else { continue };
            let ticks = time_s / period_s;
            if (ticks - libm::round(ticks)).abs() <= TICK_SLACK {
                self.change(i, time_s, state, |element, at, own, _| element.sample(at, own));
                self.pass_on(i, time_s, state);
            }
        }
    }

    /// Lets a steering element set its inputs, from the columns that it reads; `values` is working memory.
    ///
    /// # Errors
    /// The element's reason to end the run.
    pub fn update_controls(
        &mut self,
        steer: usize,
        read: &[S],
        values: &mut Vec<S>,
        time_s: f64,
        state: &mut State<S>,
    ) -> Result<Vec<Occurrence>, String> {
        let Steer { element, inputs, .. } = &self.layout.steers[steer];
        let element = *element;
        values.clear();
        values.extend(inputs.iter().map(|&input| state.d[input]));
        let mut steered = Ok(Vec::new());
        self.change(element, time_s, state, |element, at, own, _| {
            steered = element.update_controls(at, read, own, values)
        });
        for (k, value) in values.iter().enumerate() {
            self.set_input(self.layout.steers[steer].inputs[k], *value, time_s, state);
        }
        let Self { model, world, links, layout, evaluation, elements, .. } = self;
        let mut contexts = ElementContexts::new(layout, world, model, links, *evaluation, instant(time_s, state));
        elements[element].at_end(contexts.with_ends(element), values);
        for (&input, value) in layout.steers[steer].inputs.iter().zip(values) {
            state.d[layout.end_of(input)] = *value;
        }
        self.pass_on(element, time_s, state);
        steered
    }

    /// Replaces the inputs in `d` by their values at the end of the step, which a row shows.
    pub fn show_ends(&self, d: &mut [S]) {
        let (inputs, ends) = d.split_at_mut(self.layout.end_of(0));
        inputs[..ends.len()].copy_from_slice(ends);
    }

    /// Writes the outputs of an element to the inputs that wires connect to them.
    fn pass_on(&mut self, element: usize, time_s: f64, state: &mut State<S>) {
        if !self.layout.wires.iter().any(|wire| wire.element == element) {
            return;
        }
        self.links.update(&self.model, &state.q, &state.v);
        let Self { model, world, links, layout, evaluation, elements, outputs, .. } = self;
        let at = instant(time_s, state);
        outputs.clear();
        elements[element]
            .outputs(ElementContexts::new(layout, world, model, links, *evaluation, at).of(element), outputs);
        for wire in layout.wires.iter().filter(|wire| wire.element == element) {
            state.d[wire.input] = outputs[wire.output];
            state.d[layout.end_of(wire.input)] = outputs[wire.output];
        }
    }

    /// Writes every indicator at a stage.
    pub fn event_indicators(&mut self, at: Stage<'_, S>, values: &mut [S]) {
        self.load_restraints(at);
        self.links.update(&self.model, at.q, at.v);
        let Self { model, world, links, layout, evaluation, elements, .. } = self;
        let mut contexts = ElementContexts::new(layout, world, model, links, *evaluation, at);
        let mut rest = values;
        for of_one in layout.watched.chunk_by(|one, next| one.element == next.element) {
            let (own, others) = rest.split_at_mut(of_one.len());
            elements[of_one[0].element].event_indicators(contexts.of(of_one[0].element), own);
            rest = others;
        }
    }

    /// Returns the events that responses and changes from outside have caused since the last call.
    pub fn brought_about(&mut self) -> Vec<Watched> {
        core::mem::take(&mut self.also)
    }

    /// Lets an element respond to its event at a time; the change of energy and momentum is entered in the
    /// ledger.
    pub fn handle_event(&mut self, watched: Watched, time_s: f64, state: &mut State<S>) {
        let before = self.totals(instant(time_s, state));
        self.change(watched.element, time_s, state, |element, at, own, v| {
            element.handle_event(watched.event, at, own, v);
        });
        let heat = self.take_hold(time_s, state);
        self.book_jump(&before, heat, time_s, state);
    }

    /// Enters a sudden change in the ledger, with the heat of an impact, J: a further loss of energy as heat, a gain of
    /// energy and any change of momentum as work and impulse from outside.
    pub fn book_jump(&mut self, before: &Totals<S>, heat: S, time_s: f64, state: &mut State<S>) {
        if self.layout.ledger == 0 {
            return;
        }
        let after = self.totals(instant(time_s, state));
        let gained =
            after.kinetic_energy + after.potential_energy - before.kinetic_energy - before.potential_energy + heat;
        let s = &mut state.s;
        s[ledger::ENERGY_DISSIPATED] += heat;
        s[ledger::WORK_BY_OUTSIDE] += gained.select_below(0.0, || S::ZERO, || gained);
        s[ledger::ENERGY_DISSIPATED] += gained.select_below(0.0, || -gained, || S::ZERO);
        let mut add = |first: usize, jump: Vector3<S>| {
            (0..3).for_each(|k| s[first + k] += jump[k]);
        };
        add(ledger::LINEAR_MOMENTUM, after.linear_momentum - before.linear_momentum);
        add(ledger::ANGULAR_MOMENTUM, after.angular_momentum - before.angular_momentum);
    }

    /// Lets an element change its own entries of the state, and v, at a time.
    fn change(
        &mut self,
        element: usize,
        time_s: f64,
        state: &mut State<S>,
        change: impl FnOnce(&mut dyn Element<S>, &Context<'_, S>, &mut ElementState<'_, S>, &mut [S]),
    ) {
        self.links.update(&self.model, &state.q, &state.v);
        let Self { model, world, links, layout, evaluation, elements, seen, also, .. } = self;
        seen.copy_from(state);
        let at = instant(time_s, seen);
        let State { v, s, d, m, .. } = state;
        let mut contexts = ElementContexts::new(layout, world, model, links, *evaluation, at);
        let mut own = layout.own(element, s, d, m);
        change(&mut *elements[element], contexts.with_ends(element), &mut own, v);
        let is_it = |event| move |watched: &&Watched| (watched.element, watched.event) == (element, event);
        also.extend(own.also.and_then(|event| layout.watched.iter().find(is_it(event))));
    }
}

/// Returns the stage for a state at one time.
pub(super) fn instant<S>(time_s: f64, state: &State<S>) -> Stage<'_, S> {
    let State { q, v, s, d, m, .. } = state;
    Stage { time_s, interval: Interval { start_s: time_s, end_s: time_s }, q, v, s, d, m }
}
