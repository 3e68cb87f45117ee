//! The context of an element's evaluation: the model, the world and the element's own entries.

use crate::dynamics::{Clock, LinkKinematics};
use crate::model::Model;
use crate::scalar::Scalar;
use crate::world::World;
use core::ops::Range;

/// Purpose of an evaluation of the model: which effects take part.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum EvaluationMode {
    /// Run: everything acts.
    #[default]
    Running,
    /// Run, at a stage of an explicit step, to which elements have [advanced](super::Advancing) their states.
    Stepping,
    /// Rest: waves are off, and prescribed motions are held.
    AtRest,
    /// Rest, with sensors that output exact values without sampling and delay.
    Unsampled,
    /// Search for an equilibrium: rest, where elements that hold the model in place act without lag and without limits.
    Settling,
}

impl EvaluationMode {
    /// Whether everything acts, as in a run.
    pub fn runs(self) -> bool {
        matches!(self, Self::Running | Self::Stepping)
    }

    /// Whether waves act.
    pub fn has_waves(self) -> bool {
        self.runs()
    }
}

/// The model and the world at one time, for one element: states, inputs, numbers and modes are those of the element
/// only.
#[derive(Clone, Copy, Debug)]
pub struct Context<'a, S = f64> {
    /// The time.
    pub clock: Clock,
    /// The purpose.
    pub evaluation: EvaluationMode,
    /// The world outside the model.
    pub world: &'a World<S>,
    /// The mechanical model.
    pub model: &'a Model<S>,
    /// Kinematics of its links.
    pub links: &'a LinkKinematics<S>,
    /// Positions.
    pub q: &'a [S],
    /// Velocities.
    pub v: &'a [S],
    /// Its continuous states.
    pub states: &'a [S],
    /// Its inputs, constant over a step.
    pub inputs: &'a [S],
    /// The values of its inputs at the end of the step.
    pub inputs_at_end: &'a [S],
    /// Its discrete numbers, which change at its samples and events.
    pub numbers: &'a [S],
    /// Its modes, which change at its samples and events.
    pub modes: &'a [i64],
    /// The continuous states of all elements.
    pub all_states: &'a [S],
    /// Those of the elements that it [sees](super::Declaration::sees), among all.
    pub seen: &'a [Range<usize>],
}

impl<'a, S> Context<'a, S> {
    /// Returns the context of a model at rest, for an element without states, inputs, numbers and modes.
    pub fn at_rest(
        world: &'a World<S>,
        model: &'a Model<S>,
        links: &'a LinkKinematics<S>,
        (q, v): (&'a [S], &'a [S]),
    ) -> Self {
        let clock = Clock { time_s: 0.0, middle_s: 0.0 };
        Self::without_entries(clock, EvaluationMode::AtRest, world, model, links, (q, v))
    }

    /// Returns the context of an element without states, inputs, numbers and modes.
    pub fn without_entries(
        clock: Clock,
        evaluation: EvaluationMode,
        world: &'a World<S>,
        model: &'a Model<S>,
        links: &'a LinkKinematics<S>,
        (q, v): (&'a [S], &'a [S]),
    ) -> Self {
        let (states, inputs, inputs_at_end, numbers, modes) = Default::default();
        let (all_states, seen) = Default::default();
        Self {
            clock,
            evaluation,
            world,
            model,
            links,
            q,
            v,
            states,
            inputs,
            inputs_at_end,
            numbers,
            modes,
            all_states,
            seen,
        }
    }
}

/// Position of a lever at which it releases its element.
const RELEASES: f64 = 0.5;

impl<'a, S: Scalar> Context<'a, S> {
    /// Returns the context of another element that it sees, with the states of that element and without its other entries.
    ///
    /// # Panics
    /// If it does not see so many elements.
    #[must_use]
    pub fn of_other(&self, index: usize) -> Context<'a, S> {
        let (inputs, inputs_at_end, numbers, modes) = Default::default();
        let states = self.all_states.get(self.seen[index].clone()).unwrap_or_default();
        Context { states, inputs, inputs_at_end, numbers, modes, seen: &[], ..*self }
    }

    /// Whether the first input of the element, its lever, commands its release.
    pub fn is_let_go(&self) -> bool {
        self.inputs.first().is_some_and(|lever| lever.all(|lever| lever >= RELEASES))
    }
}
