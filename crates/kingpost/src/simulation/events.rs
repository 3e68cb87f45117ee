//! Events: if an indicator changes sign within a step, the step is divided at this time and the element
//! responds.

use super::{RunError, Simulation, stage};
use crate::elements::{Crossing, Watched};
use crate::integrate::{Interval, Stage, System};
use crate::scalar::Scalar;
use crate::state::State;
use serde::Serialize;
use std::borrow::Cow;

/// An event of a run.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct EventRecord {
    /// Time of the event, s.
    pub time_s: f64,
    /// The element that declares the indicator.
    pub element: String,
    /// Code of the event, in words joined by `_`.
    pub code: &'static str,
    /// Description of the event.
    pub what: Cow<'static, str>,
}

/// Tolerance of the located time of an event, s; the rounding error of the time if that is larger.
const TIME_TOLERANCE_S: f64 = 1e-12;
/// Largest number of events in one step; beyond it, the events of an element are taken to be infinitely many.
const MOST_EVENTS: usize = 1000;
/// Step of the central differences that give the rate of an indicator, as a share of the time step.
const RATE_STEP: f64 = 1e-2;
/// Largest number of trials to locate an event; a smooth indicator needs far fewer.
const MOST_TRIALS: usize = 200;

/// Working memory for the location of events, and the table of events.
#[derive(Clone, Debug)]
pub(super) struct Watch<S> {
    records: Vec<EventRecord>,
    /// Step of each event, counted from 1.
    of_step: Vec<u64>,
    /// Number of events in the present step.
    in_step: usize,
    /// Indicators at the start of an interval, at the lower end of the bracket, and at the present state.
    before: Vec<S>,
    low: Vec<S>,
    now: Vec<S>,
    /// State at the start of the interval, and at its end.
    start: State<S>,
    end: State<S>,
}

/// Part of an interval that contains an event: no indicator has changed sign at `low`, at least one has at
/// `high`.
struct Bracket {
    low_s: f64,
    high_s: f64,
    /// The indicator that is estimated to change sign first, and its values at both ends.
    indicator: usize,
    values: [f64; 2],
}

impl<S: Scalar> Watch<S> {
    pub(super) fn new(indicators: usize, state: &State<S>) -> Self {
        let zeros = || vec![S::ZERO; indicators];
        Self {
            records: Vec::new(),
            of_step: Vec::new(),
            in_step: 0,
            before: zeros(),
            low: zeros(),
            now: zeros(),
            start: state.clone(),
            end: state.clone(),
        }
    }

    pub(super) fn records(&self) -> &[EventRecord] {
        &self.records
    }

    pub(super) fn note(&mut self, of_step: u64, record: EventRecord) {
        self.records.push(record);
        self.of_step.push(of_step);
    }

    pub(super) fn begin_step(&mut self) {
        self.in_step = 0;
    }

    /// Removes from the table the events after this number of steps.
    pub(super) fn forget_after(&mut self, steps: u64) {
        let kept = self.of_step.partition_point(|step| *step <= steps);
        self.records.truncate(kept);
        self.of_step.truncate(kept);
    }

    /// Returns whether an indicator has changed sign since the start of the interval, in any lane.
    fn crossed(&self, watched: &[Watched]) -> bool {
        let mut pairs = watched.iter().zip(self.before.iter().zip(&self.now));
        pairs.any(|(watched, (before, now))| !crossed(watched.crossing, *before, *now).all(|crossed| crossed == 0.0))
    }

    /// Returns the indicator that changes sign first by linear interpolation from the lower end, with its
    /// values there and at the present state.
    fn first(&self, watched: &[Watched]) -> Option<(usize, [f64; 2])> {
        let pairs = watched.iter().zip(self.low.iter().zip(&self.now)).enumerate();
        let crossed = pairs.filter_map(|(i, (watched, (low, now)))| {
            let pair = [low.value(), now.value()];
            watched.crossing.happened(pair[0], pair[1]).then_some((i, pair))
        });
        crossed.min_by(|(_, a), (_, b)| share(*a).total_cmp(&share(*b)))
    }
}

/// Returns the zero of the straight line through two values, as a share of the interval.
fn share([low, high]: [f64; 2]) -> f64 {
    low / (low - high)
}

/// Returns, for each lane, 1 if an indicator has changed sign and 0 if it has not.
fn crossed<S: Scalar>(crossing: Crossing, before: S, now: S) -> S {
    let rising =
        |before: S, now: S| before.select_below(0.0, || now.select_below(0.0, || S::ZERO, || S::ONE), || S::ZERO);
    match crossing {
        Crossing::Rising => rising(before, now),
        Crossing::Falling => rising(-before, -now),
        Crossing::Either => rising(before, now) + rising(-before, -now),
    }
}

impl<S: Scalar> Simulation<S> {
    /// Steps to the end of an interval, or to the first event in it, and lets the elements respond to the
    /// event; returns the time reached.
    pub(super) fn step_to_event(&mut self, interval: Interval, edge_s: f64) -> Result<f64, RunError> {
        if self.watch.before.is_empty() {
            self.scheme.step(&mut self.plant, interval, edge_s, &mut self.state)?;
            return Ok(interval.end_s);
        }
        let Self { plant, watch, state, scheme, .. } = self;
        plant.event_indicators(stage(interval, state), &mut watch.before);
        watch.start.copy_from(state);
        scheme.step(plant, interval, edge_s, state)?;
        self.look(interval, interval.end_s);
        if !self.watch.crossed(&self.plant.layout().watched) {
            return Ok(interval.end_s);
        }
        if S::LANES > 1 {
            return Err(RunError::EventNotAlone { time_s: interval.end_s });
        }
        self.watch.end.copy_from(&self.state);
        let time_s = self.locate(interval, edge_s)?;
        self.answer(interval, time_s)?;
        Ok(time_s)
    }

    /// Evaluates the indicators at the present state, at a time within an interval.
    fn look(&mut self, interval: Interval, time_s: f64) {
        let at = Stage { time_s, ..stage(interval, &self.state) };
        self.plant.event_indicators(at, &mut self.watch.now);
    }

    /// Moves the state to the first time in an interval at which an indicator has changed sign, by the secant
    /// method with bisection steps in between; both ends of the last bracket are within the tolerance.
    fn locate(&mut self, interval: Interval, edge_s: f64) -> Result<f64, RunError> {
        let Interval { start_s, end_s } = interval;
        let tolerance_s = TIME_TOLERANCE_S.max(4.0 * f64::EPSILON * end_s.abs());
        self.watch.low.copy_from_slice(&self.watch.before);
        let first = self.watch.first(&self.plant.layout().watched);
        let Some((indicator, values)) = first else { return Ok(end_s) };
        let mut bracket = Bracket { low_s: start_s, high_s: end_s, indicator, values };
        for trial in 0..MOST_TRIALS {
            if bracket.high_s - bracket.low_s <= tolerance_s {
                break;
            }
            let time_s = bracket.guess(trial, tolerance_s);
            self.go_to(interval, time_s, edge_s)?;
            self.look(interval, time_s);
            match self.watch.first(&self.plant.layout().watched) {
                Some((indicator, values)) => bracket = Bracket { high_s: time_s, indicator, values, ..bracket },
                None => {
                    self.watch.low.copy_from_slice(&self.watch.now);
                    bracket.low_s = time_s;
                    bracket.values[0] = self.watch.low[bracket.indicator].value();
                }
            }
        }
        self.go_to(interval, bracket.high_s, edge_s)?;
        self.look(interval, bracket.high_s);
        Ok(bracket.high_s)
    }

    /// Moves the state from the start of an interval to a time in it.
    fn go_to(&mut self, interval: Interval, time_s: f64, edge_s: f64) -> Result<(), RunError> {
        let Self { plant, watch, state, scheme, .. } = self;
        state.copy_from(&watch.end);
        if !scheme.interpolate(plant, time_s, state) {
            state.copy_from(&watch.start);
            let part = Interval { end_s: time_s, ..interval };
            scheme.step(plant, part, edge_s.max(time_s), state)?;
        }
        Ok(())
    }

    /// Lets the elements respond to their events, in the order of their declaration. Events at the same time
    /// see the motion before all of them: their delays are computed before the first response.
    fn answer(&mut self, interval: Interval, time_s: f64) -> Result<(), RunError> {
        let end_s = time_s + self.settings.step_s;
        let after = Interval { start_s: time_s, end_s: self.next_edge_s(time_s, end_s).min(end_s) };
        let (mut present, mut reached) = (interval, S::ZERO);
        for (i, delay) in self.delays(interval, time_s) {
            let watched = self.plant.layout().watched[i];
            let element = self.plant.layout().names[watched.element].clone();
            self.watch.in_step += 1;
            if self.watch.in_step > MOST_EVENTS {
                return Err(RunError::TooManyEvents { time_s, element, what: watched.what, allowed: MOST_EVENTS });
            }
            self.drift(present, time_s, delay - reached);
            (present, reached) = (after, delay);
            self.plant.handle_event(watched, time_s, &mut self.state);
            let record = EventRecord { time_s, element, code: watched.code, what: Cow::Borrowed(watched.what) };
            self.watch.note(self.state.steps, record);
            self.note_brought_about(time_s, self.state.steps);
        }
        self.drift(after, time_s, -reached);
        Ok(())
    }

    /// Records at a time the events that a response, or a change from outside, has caused; `of_step` is
    /// counted from 1.
    pub(super) fn note_brought_about(&mut self, time_s: f64, of_step: u64) {
        for watched in self.plant.brought_about() {
            let element = self.plant.layout().names[watched.element].clone();
            self.watch
                .note(of_step, EventRecord { time_s, element, code: watched.code, what: Cow::Borrowed(watched.what) });
        }
    }
}

/// Derivatives of the time of an event. With the indicator g, f the rates before and f+ those after, `dt = -dg / g'`
/// moves the state by `f dt` up to the event and by `-f+ dt` from there (the saltation matrix: Leine & Nijmeijer,
/// *Dynamics and Bifurcations of Non-Smooth Mechanical Systems*, 2004, sec. 7.2).
impl<S: Scalar> Simulation<S> {
    /// Returns the indicators that have changed sign, in the order of their declaration, with dt of each: dt
    /// has the value 0 and carries the derivatives.
    fn delays(&mut self, interval: Interval, time_s: f64) -> Vec<(usize, S)> {
        let watched = &self.plant.layout().watched;
        let pairs = watched.iter().zip(self.watch.before.iter().zip(&self.watch.now)).enumerate();
        let crossed = pairs.filter(|(_, (watched, (low, now)))| watched.crossing.happened(low.value(), now.value()));
        let crossed: Vec<usize> = crossed.map(|(i, _)| i).collect();
        if !S::HAS_DERIVATIVES {
            return crossed.into_iter().map(|i| (i, S::ZERO)).collect();
        }
        let by_s = RATE_STEP * self.settings.step_s;
        let now = self.watch.now.clone();
        let (behind, ahead) = (self.indicators_at(interval, time_s, -by_s), self.indicators_at(interval, time_s, by_s));
        let delay = |i: usize| {
            let rate = (ahead[i].value() - behind[i].value()) / (2.0 * by_s);
            (i, (S::constant(now[i].value()) - now[i]) / S::constant(rate))
        };
        crossed.into_iter().map(delay).collect()
    }

    /// Returns the indicators after the state has moved for a time at its present rates.
    fn indicators_at(&mut self, interval: Interval, time_s: f64, by_s: f64) -> Vec<S> {
        self.watch.start.copy_from(&self.state);
        self.drift(interval, time_s, S::constant(by_s));
        self.look(interval, time_s);
        self.state.copy_from(&self.watch.start);
        self.watch.now.clone()
    }

    /// Moves the state along its rates at a time, to first order.
    fn drift(&mut self, interval: Interval, time_s: f64, by_s: S) {
        if !S::HAS_DERIVATIVES {
            return;
        }
        let Self { plant, state, v_dot, .. } = self;
        let mut s_dot = vec![S::ZERO; state.s.len()];
        plant.rates(Stage { time_s, ..stage(interval, state) }, v_dot, &mut s_dot);
        let xi: Vec<S> = state.v.iter().map(|rate| *rate * by_s).collect();
        let q = state.q.clone();
        plant.retract(&q, &xi, &mut state.q);
        state.v.iter_mut().zip(v_dot.iter()).for_each(|(v, rate)| *v += *rate * by_s);
        state.s.iter_mut().zip(&s_dot).for_each(|(s, rate)| *s += *rate * by_s);
    }
}

impl Bracket {
    /// Returns the next time to try: at every third trial by bisection, otherwise the zero of the secant,
    /// shifted by the tolerance towards the farther end so that both ends converge.
    fn guess(&self, trial: usize, tolerance_s: f64) -> f64 {
        let width = self.high_s - self.low_s;
        let middle = self.low_s + 0.5 * width;
        if trial % 3 == 2 {
            return middle;
        }
        let zero = self.low_s + share(self.values) * width;
        let nudged = if zero < middle { zero + 0.5 * tolerance_s } else { zero - 0.5 * tolerance_s };
        if nudged > self.low_s && nudged < self.high_s { nudged } else { middle }
    }
}
