//! The contexts of all elements at a stage.

use crate::dynamics::{Clock, LinkKinematics};
use crate::elements::{Context, EvaluationMode, Layout, StateSlices};
use crate::integrate::Stage;
use crate::model::Model;
use crate::world::World;

/// A stage with its kinematics; it creates the context of each element.
#[derive(Clone, Copy, Debug)]
pub struct ElementContexts<'a, S> {
    /// Indices of all entries.
    pub layout: &'a Layout,
    /// The part that all elements share.
    pub shared: Context<'a, S>,
    /// Entries of s after those of the ledger.
    states: &'a [S],
    discrete: &'a [S],
    modes: &'a [i64],
    /// Context of the last element that has entries.
    own: Option<Context<'a, S>>,
}

impl<'a, S: Copy> ElementContexts<'a, S> {
    /// Creates the contexts at a stage.
    pub fn new(
        layout: &'a Layout,
        world: &'a World<S>,
        model: &'a Model<S>,
        links: &'a LinkKinematics<S>,
        evaluation: EvaluationMode,
        at: Stage<'a, S>,
    ) -> Self {
        let clock = Clock { time_s: at.time_s, middle_s: at.interval.middle_s() };
        let states = at.s.get(layout.ledger..).unwrap_or_default();
        let shared = Context {
            all_states: states,
            ..Context::without_entries(clock, evaluation, world, model, links, (at.q, at.v))
        };
        Self { layout, shared, states, discrete: at.d, modes: at.m, own: None }
    }

    /// Returns the context of an element.
    #[inline]
    pub fn of(&mut self, element: usize) -> &Context<'a, S> {
        let StateSlices { states, inputs, numbers, modes, has_own, seen, .. } = &self.layout.slices[element];
        if !has_own {
            return &self.shared;
        }
        let own = self.own.get_or_insert(self.shared);
        own.states = self.states.get(states.clone()).unwrap_or_default();
        own.inputs = self.discrete.get(inputs.clone()).unwrap_or_default();
        own.numbers = self.discrete.get(numbers.clone()).unwrap_or_default();
        own.modes = self.modes.get(modes.clone()).unwrap_or_default();
        own.seen = seen;
        own
    }

    /// Returns the context of an element with the values of its inputs at the end of the step; loads do not
    /// need these values.
    pub fn with_ends(&mut self, element: usize) -> &Context<'a, S> {
        let ends = self.layout.ends_of(self.layout.slices[element].inputs.clone());
        let ends = self.discrete.get(ends).unwrap_or_default();
        self.of(element);
        match &mut self.own {
            Some(own) if self.layout.slices[element].has_own => {
                own.inputs_at_end = ends;
                own
            }
            _ => &self.shared,
        }
    }
}
