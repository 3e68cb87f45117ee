//! Warnings of effects that elements leave out, at the start of a run.

use super::Plant;
use super::element_contexts::ElementContexts;
use crate::integrate::Stage;

impl Plant {
    /// Returns the warnings of all elements about effects that they leave out and that are not small.
    pub fn left_out(&mut self, at: Stage<'_>) -> Vec<String> {
        self.evaluate_loads(at);
        let Self { model, world, links, elements, layout, evaluation, loads, .. } = self;
        let mut contexts = ElementContexts::new(layout, world, model, links, *evaluation, at);
        elements.iter_mut().enumerate().filter_map(|(i, element)| element.left_out(contexts.of(i), loads)).collect()
    }
}
