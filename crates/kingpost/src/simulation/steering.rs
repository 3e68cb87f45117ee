//! Steering elements at the start of a step, and the user's changes of inputs.

use super::{EventRecord, RunError, Simulation, stage};
use crate::elements::{Layout, Occurrence};
use crate::integrate::Stage;
use crate::plant::Plant;
use crate::results::{Channels, Readings, Sample};
use crate::scalar::Scalar;
use serde::Serialize;

/// A change of an input by the user.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LeverMove {
    /// End of the last step before the change, s.
    pub time_s: f64,
    /// Name of the input.
    pub input: String,
    /// New value, in the input's unit.
    pub value: f64,
}

/// A change of a parameter during the run.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ParameterSet {
    /// End of the last step before the change, s.
    pub time_s: f64,
    /// Name of the parameter.
    pub parameter: String,
}

/// Working memory for steering, the user's changes of inputs, and the parameters set during the run.
#[derive(Clone, Debug, Default)]
pub(super) struct Steering<S> {
    /// Columns that each steering element reads.
    readings: Vec<Readings<S>>,
    read: Vec<S>,
    inputs: Vec<S>,
    /// Inputs at the present time, with the discrete numbers.
    now: Vec<S>,
    shown: Vec<S>,
    /// For each change: number of steps before it, index of the input in d, new value.
    moves: Vec<(u64, usize, f64)>,
    /// For each change: number of steps before it, name of the parameter.
    parameters: Vec<(u64, String)>,
}

impl<S: Scalar> Steering<S> {
    /// Creates the working memory; columns that do not exist are ignored, because the scenario has checked
    /// the names.
    pub(super) fn new(layout: &Layout, channels: &Channels) -> Self {
        let readings = layout.steers.iter().map(|steer| Readings::new(&steer.reads, channels, layout)).collect();
        Self { readings, ..Self::default() }
    }

    /// Returns the readings of the columns that a steering element reads.
    pub(super) fn readings(&mut self, steer: usize) -> &mut Readings<S> {
        &mut self.readings[steer]
    }

    /// Returns the stage as a row shows it: with each input at the stage's time.
    pub(super) fn shown<'a>(&'a mut self, plant: &Plant<S>, at: Stage<'a, S>) -> Stage<'a, S> {
        if self.readings.is_empty() {
            return at;
        }
        self.shown.clear();
        self.shown.extend_from_slice(at.d);
        plant.show_ends(&mut self.shown);
        Stage { d: &self.shown, ..at }
    }

    /// Records a change of an input by the user. Of several changes between two steps, the last one counts.
    pub(super) fn moved(&mut self, steps: u64, input: usize, value: f64) {
        self.moves.retain(|&(at, moved, _)| (at, moved) != (steps, input));
        self.moves.push((steps, input, value));
    }

    /// Records that a parameter was set. Of several changes between two steps, the last one counts.
    pub(super) fn parameter_set(&mut self, steps: u64, name: &str) {
        self.parameters.retain(|(at, set)| (*at, set.as_str()) != (steps, name));
        self.parameters.push((steps, name.to_owned()));
    }

    /// Takes the changes that were made in the run that this one continues.
    pub(super) fn take_history(&mut self, of: &mut Self) {
        self.moves = core::mem::take(&mut of.moves);
        self.parameters = core::mem::take(&mut of.parameters);
    }

    /// Removes the moves after this number of steps.
    pub(super) fn forget_after(&mut self, steps: u64) {
        self.moves.retain(|&(at, ..)| at <= steps);
        self.parameters.retain(|&(at, _)| at <= steps);
    }
}

impl<S: Scalar> Simulation<S> {
    /// Lets steering elements set their inputs at the start of a step.
    pub(super) fn update_controls(&mut self) -> Result<(), RunError> {
        let time_s = self.time_s();
        if self.steering.readings.is_empty() {
            self.note_brought_about(time_s, self.state.steps + 1);
            return Ok(());
        }
        let interval = self.interval();
        let Self { plant, channels, state, steering, v_dot, watch, .. } = self;
        let Steering { readings, read, inputs, now, shown, .. } = steering;
        now.clear();
        now.extend_from_slice(&state.d[plant.layout().end_of(0)..]);
        for (steer, readings) in readings.iter_mut().enumerate() {
            if !readings.is_empty() {
                shown.clear();
                shown.extend_from_slice(&state.d);
                shown[..now.len()].copy_from_slice(now);
                let at = Stage { d: shown, ..stage(interval, state) };
                let observed = plant.observe(at, readings.extent(), v_dot);
                readings.read(&Sample { time_s, q: at.q, v: at.v, s: at.s, observed }, channels, read);
            }
            let steered = plant.update_controls(steer, read, inputs, time_s, state);
            let element = || plant.layout().names[plant.layout().steers[steer].element].clone();
            let steered = steered.map_err(|why| RunError::Steering { time_s, element: element(), why })?;
            for Occurrence { code, what } in steered {
                watch.note(state.steps + 1, EventRecord { time_s, element: element(), code, what: what.into() });
            }
        }
        self.note_brought_about(time_s, self.state.steps + 1);
        Ok(())
    }

    /// Returns the user's changes of inputs so far, in order of time.
    pub fn lever_moves(&self) -> Vec<LeverMove> {
        let inputs = &self.plant.layout().inputs;
        let lever_move = |&(steps, input, value): &(u64, usize, f64)| LeverMove {
            time_s: steps as f64 * self.settings.step_s,
            input: inputs[input].name.clone(),
            value,
        };
        self.steering.moves.iter().map(lever_move).collect()
    }

    /// Returns the parameters set since the start of the run, in order of time: if there are any,
    /// [`lever_moves`](Self::lever_moves) alone do not reproduce the run.
    pub fn parameters_set(&self) -> Vec<ParameterSet> {
        let set = |(steps, name): &(u64, String)| ParameterSet {
            time_s: *steps as f64 * self.settings.step_s,
            parameter: name.clone(),
        };
        self.steering.parameters.iter().map(set).collect()
    }
}
