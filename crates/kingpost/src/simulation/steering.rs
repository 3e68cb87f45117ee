//! What elements steer where a step begins, and what a hand set.

use super::{Happened, RunError, Simulation, stage};
use crate::elements::Layout;
use crate::results::{Channels, Sample};
use crate::scalar::Scalar;
use serde::Serialize;

/// An input that a hand set.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LeverMove {
    /// The end of the last step before, s.
    pub time_s: f64,
    /// The input.
    pub input: String,
    /// What it was set to, in its unit.
    pub value: f64,
}

/// Working memory to steer, and the moves of levers.
#[derive(Clone, Debug, Default)]
pub(super) struct Steering<S> {
    /// By steering element: the places in a row of the columns that it reads.
    places: Vec<Vec<usize>>,
    row: Vec<S>,
    read: Vec<S>,
    inputs: Vec<S>,
    /// After so many steps, an input in d, its value.
    moves: Vec<(u64, usize, f64)>,
}

impl<S: Scalar> Steering<S> {
    /// A column that is not there is left out: the scenario has checked them.
    pub(super) fn new(layout: &Layout, channels: &Channels) -> Self {
        let columns: Vec<&String> = channels.list.iter().flat_map(|channel| &channel.columns).collect();
        let place = |name: &String| columns.iter().position(|column| *column == name);
        let places = layout.steers.iter().map(|steer| steer.reads.iter().filter_map(place).collect()).collect();
        Self { places, ..Self::default() }
    }

    /// A hand set an input. Of several moves between two steps the last counts.
    pub(super) fn moved(&mut self, steps: u64, input: usize, value: f64) {
        self.moves.retain(|&(at, moved, _)| (at, moved) != (steps, input));
        self.moves.push((steps, input, value));
    }

    /// Takes back the moves after so many steps.
    pub(super) fn forget_after(&mut self, steps: u64) {
        self.moves.retain(|&(at, ..)| at <= steps);
    }
}

impl<S: Scalar> Simulation<S> {
    /// Lets the elements that steer set their inputs, where a step begins.
    pub(super) fn steer(&mut self) -> Result<(), RunError> {
        let time_s = self.time_s();
        let interval = self.interval();
        let Self { plant, channels, state, steering, v_dot, watch, .. } = self;
        let Steering { places, row, read, inputs, .. } = steering;
        if places.iter().any(|places| !places.is_empty()) {
            row.clear();
            let at = stage(interval, state);
            let observed = plant.observe(at, v_dot);
            channels.write_row(&Sample { time_s, q: at.q, v: at.v, s: at.s, observed }, row);
        }
        for (steer, places) in places.iter().enumerate() {
            read.clear();
            read.extend(places.iter().map(|&place| row[place]));
            let steered = plant.steer(steer, read, inputs, time_s, state);
            let element = || plant.layout().names[plant.layout().steers[steer].element].clone();
            let steered = steered.map_err(|why| RunError::Steering { time_s, element: element(), why })?;
            for what in steered {
                watch.note(state.steps + 1, Happened { time_s, element: element(), what: what.into() });
            }
        }
        Ok(())
    }

    /// What a hand has set so far, in order of time.
    pub fn lever_moves(&self) -> Vec<LeverMove> {
        let inputs = &self.plant.layout().inputs;
        let lever_move = |&(steps, input, value): &(u64, usize, f64)| LeverMove {
            time_s: steps as f64 * self.settings.step_s,
            input: inputs[input].name.clone(),
            value,
        };
        self.steering.moves.iter().map(lever_move).collect()
    }
}
