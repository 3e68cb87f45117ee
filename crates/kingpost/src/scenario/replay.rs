//! What a hand did in a run, as a scenario that does it again.

use super::error::FieldError;
use super::schema::{InputMove, NonNegative, Operation, OperationStep, Positive, Scenario, SignalName};
use crate::simulation::{LeverMove, Simulation};

/// The step that holds what a hand set.
const STEP: &str = "by hand";

impl Scenario {
    /// What a hand has set in a simulation of this scenario, as the operation of one: a run with it gives the same bits.
    ///
    /// It has what was set since the start or the last reset. A parameter that was set under way is no lever:
    /// [`Simulation::parameters_set`].
    ///
    /// # Errors
    /// An operation of the scenario that is enabled: the two would be one beside the other.
    pub fn operation_by_hand(&self, simulation: &Simulation) -> Result<Operation, FieldError> {
        if self.operation.as_ref().is_some_and(|operation| operation.enabled) {
            return Err(FieldError::new("operation", "one in the scenario", "operation.enabled: false"));
        }
        let set = simulation.lever_moves().into_iter().filter_map(input_move).collect();
        Ok(Operation {
            enabled: true,
            steps: vec![OperationStep { name: STEP.to_owned(), set, until: None, time_out_s: None }],
        })
    }

    /// This scenario as a simulation of it was steered: with what a hand has set as its operation, and as long as it has
    /// run where that is longer than its duration. Without moves its own operation stays.
    ///
    /// Parameters have the values that they have now, whenever they were set.
    ///
    /// # Errors
    /// As [`operation_by_hand`](Self::operation_by_hand), where a hand has set something.
    pub fn replay(&self, simulation: &Simulation) -> Result<Scenario, FieldError> {
        let mut replay = self.clone();
        if !simulation.lever_moves().is_empty() {
            replay.operation = Some(self.operation_by_hand(simulation)?);
            // The steps that parameters wrote into are no longer there.
            let stays = |path: &String| path == "operation.enabled" || !path.starts_with("operation.");
            replay.parameters.iter_mut().for_each(|parameter| parameter.writes.retain(stays));
            replay.parameters.retain(|parameter| !parameter.writes.is_empty());
        }
        if let Some(ran_s) = Positive::new(simulation.time_s()).filter(|ran_s| **ran_s > *self.simulation.duration_s) {
            replay.simulation.duration_s = ran_s;
        }
        Ok(replay)
    }
}

/// A lever's name has the form of one, and time does not run backwards: none is left out.
fn input_move(LeverMove { time_s, input, value }: LeverMove) -> Option<InputMove> {
    let (input, at_s) = (SignalName::new(input)?, NonNegative::new(time_s)?);
    Some(InputMove { input, to: value, unit: None, at_s, in_s: NonNegative::new(0.0)? })
}
