//! Simulations that another program steps: inputs set by index, and their state as one lane of several.

use super::Simulation;
use crate::scalar::{LANES, Lanes, Scalar};
use crate::state::State;

impl<S: Scalar> Simulation<S> {
    /// Sets an input by its index, with effect from the next step. The change is not recorded as a move of
    /// the user, and the value must be within the input's bounds.
    pub(crate) fn put_input(&mut self, input: usize, value: S) {
        if self.switches_modes(input) {
            let time_s = self.time_s();
            self.plant.set_input(input, value, time_s, &mut self.state);
            self.note_brought_about(time_s, self.state.steps);
        } else {
            self.state.d[input] = value;
            self.state.d[self.plant.layout().end_of(input)] = value;
        }
    }

    /// Returns whether the element of an input may change its mode when the input changes; such inputs cannot
    /// differ between lanes.
    pub(crate) fn switches_modes(&self, input: usize) -> bool {
        let mut shares = self.plant.layout().slices.iter();
        shares.any(|share| share.inputs.contains(&input) && !share.modes.is_empty())
    }
}

impl Simulation {
    /// Copies the numbers of one lane.
    pub(crate) fn take_lane(&mut self, from: &Simulation<Lanes>, lane: usize) {
        let take = |from: &[Lanes], to: &mut [f64]| {
            to.iter_mut().zip(from).for_each(|(to, from)| *to = from.to_array()[lane]);
        };
        let (state, from) = (&mut self.state, &from.state);
        state.steps = from.steps;
        take(&from.q, &mut state.q);
        take(&from.v, &mut state.v);
        take(&from.s, &mut state.s);
        take(&from.d, &mut state.d);
        take(&from.memory, &mut state.memory);
        state.m.copy_from_slice(&from.m);
    }

    /// Returns whether this simulation can continue in a lane beside another one: time and modes are equal.
    pub(crate) fn is_level_with<S: Scalar>(&self, other: &Simulation<S>) -> bool {
        self.state.steps == other.state.steps && self.state.m == other.state.m
    }
}

impl Simulation<Lanes> {
    /// Fills every lane with the numbers of a simulation.
    pub(crate) fn fill_lanes(&mut self, from: [&Simulation; LANES]) {
        let states = from.map(|simulation| &simulation.state);
        let fill = |to: &mut [Lanes], part: fn(&State) -> &[f64]| {
            for (i, to) in to.iter_mut().enumerate() {
                *to = Lanes::new(states.map(|state| part(state)[i]));
            }
        };
        let state = &mut self.state;
        state.steps = states[0].steps;
        fill(&mut state.q, |state| &state.q);
        fill(&mut state.v, |state| &state.v);
        fill(&mut state.s, |state| &state.s);
        fill(&mut state.d, |state| &state.d);
        fill(&mut state.memory, |state| &state.memory);
        state.m.copy_from_slice(&states[0].m);
    }
}
