//! Changes of numbers during a run.

use super::from_outside::LARGEST_GAP_GIVEN;
use super::{EventRecord, Simulation, stage};
use crate::elements::AnyElement;
use crate::world::World;

impl Simulation {
    /// Returns the elements of the model.
    pub fn elements(&self) -> &[AnyElement] {
        self.plant.elements()
    }

    /// Returns the world outside the model.
    pub fn world(&self) -> &World {
        &self.plant.world
    }

    /// Returns warnings of effects that elements leave out and that are not small in the present state.
    pub fn left_out(&mut self) -> Vec<String> {
        self.plant.left_out(stage(self.interval(), &self.state))
    }

    /// Continues from the present state with the parameters of another simulation of the same structure.
    /// Time, q, v, s, d and the modes of elements are kept, unless elements set them again; the integrator
    /// restarts, because its memory belongs to the old parameters. The change of energy and momentum is
    /// entered in the ledger as at an event; a reset returns to the start of the other simulation.
    ///
    /// The table of events records that `what` was set.
    ///
    /// # Errors
    /// The reason why it cannot; nothing has changed then.
    pub fn go_on_as(&mut self, mut next: Simulation, what: &str) -> Result<(), &'static str> {
        if !self.is_laid_out_like(&next) {
            return Err("which changes the structure of the run");
        }
        let gap = next.plant.loop_gap(&self.state.q, &self.state.v);
        if gap.is_some_and(|(_, gap)| gap >= LARGEST_GAP_GIVEN) {
            return Err("which opens a closed loop here");
        }
        let at = stage(self.interval(), &self.state);
        let before = self.plant.totals(at);
        let time_s = self.time_s();
        let memory = next.state.memory.len();
        next.state.copy_from(&self.state);
        next.state.memory = vec![0.0; memory];
        let interval = next.interval();
        next.plant.prescribe(interval, &mut next.state.v);
        next.plant.renew(time_s, &mut next.state);
        next.plant.book_jump(&before, 0.0, time_s, &mut next.state);
        next.last_good.copy_from(&next.state);
        next.plant.evaluations = self.plant.evaluations;
        core::mem::swap(&mut next.watch, &mut self.watch);
        core::mem::swap(&mut next.limits, &mut self.limits);
        next.steering.take_history(&mut self.steering);
        next.steering.parameter_set(next.state.steps, what);
        let (element, code) = (what.to_owned(), "parameter_set");
        let record = EventRecord { time_s, element, code, what: "was set".into() };
        next.watch.note(next.state.steps, record);
        next.note_brought_about(time_s, next.state.steps);
        *self = next;
        Ok(())
    }
    /// Returns whether the states of this simulation have the same meaning in another one, with the same columns.
    fn is_laid_out_like(&self, other: &Self) -> bool {
        let motion = |of: &Self| (of.state.q.len(), of.state.v.len());
        let names = |of: &Self| {
            let layout = of.plant.layout();
            let inputs = layout.inputs.iter().map(|input| input.name.clone());
            let states = layout.states.iter().map(|state| state.name.clone());
            let discrete = [&layout.numbers, &layout.modes].into_iter().flatten().cloned();
            (inputs.chain(states).chain(discrete).collect::<Vec<_>>(), layout.watched.len())
        };
        motion(self) == motion(other) && self.channels() == other.channels() && names(self) == names(other)
    }
}
