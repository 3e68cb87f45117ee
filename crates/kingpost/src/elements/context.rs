//! The context of an element's evaluation: the model, the world and the element's own entries.

use crate::dynamics::{Clock, LinkKinematics};
use crate::model::Model;
use crate::world::World;

/// The purpose of an evaluation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Situation {
    /// A run.
    #[default]
    Running,
    /// Rest: without waves, and with prescribed motions held.
    AtRest,
    /// The same, and sensors give what they measure at once: without samples, delays and errors.
    Unsampled,
    /// The search for an equilibrium: as at rest, and elements that hold the model in place act at once and without
    /// limits.
    Settling,
}

impl Situation {
    /// Whether waves act.
    pub fn has_waves(self) -> bool {
        self == Self::Running
    }
}

/// The model and the world at one time, as an element sees them. States, inputs, numbers and modes are the element's
/// own.
#[derive(Clone, Copy, Debug)]
pub struct Context<'a, S = f64> {
    /// When.
    pub clock: Clock,
    /// The purpose.
    pub situation: Situation,
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
    /// The values that they reach at the end of the step.
    pub inputs_at_end: &'a [S],
    /// Its discrete numbers, which its samples and events set.
    pub numbers: &'a [S],
    /// Its modes, which its samples and events set.
    pub modes: &'a [i64],
}

impl<'a, S> Context<'a, S> {
    /// A model at rest, for an element without entries of its own; `q` and `v` are the model's.
    pub fn at_rest(
        world: &'a World<S>,
        model: &'a Model<S>,
        links: &'a LinkKinematics<S>,
        (q, v): (&'a [S], &'a [S]),
    ) -> Self {
        let clock = Clock { time_s: 0.0, middle_s: 0.0 };
        let (states, inputs, inputs_at_end, numbers, modes) = Default::default();
        let situation = Situation::AtRest;
        Self { clock, situation, world, model, links, q, v, states, inputs, inputs_at_end, numbers, modes }
    }
}
