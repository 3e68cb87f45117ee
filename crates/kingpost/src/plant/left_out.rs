//! Warnings of effects that elements leave out, at the start of a run.

use super::Plant;
use super::element_contexts::ElementContexts;
use crate::elements::MovedMass;
use crate::integrate::Stage;
use crate::spatial::Vector3;

impl Plant {
    /// Returns the warnings of all elements about effects that they leave out and that are not small.
    pub fn left_out(&mut self, at: Stage<'_>) -> Vec<String> {
        self.evaluate_loads(at);
        let moved = self.moved_mass();
        let Self { model, world, links, elements, layout, evaluation, .. } = self;
        let mut contexts = ElementContexts::new(layout, world, model, links, *evaluation, at);
        elements.iter_mut().enumerate().filter_map(|(i, element)| element.left_out(contexts.of(i), &moved)).collect()
    }

    /// Returns the masses that move with the bodies, with the added mass of the loads that were evaluated last.
    fn moved_mass(&self) -> MovedMass {
        let Self { model, links, loads, .. } = self;
        let up = |body| links.to_body_axes(model, body, Vector3::new(0.0, 0.0, 1.0));
        let added = |body: usize| {
            let own = loads.added_inertia.iter().filter(|(of, _)| *of == body);
            own.map(|(_, inertia)| up(body).dot(inertia.linear * up(body))).sum::<f64>()
        };
        let sums = |of: &dyn Fn(usize) -> f64| {
            (0..model.bodies.len()).map(|body| model.carried(body).into_iter().map(of).sum()).collect()
        };
        let mass = |body: usize| model.bodies[body].mass;
        MovedMass { dry_kg: sums(&mass), wet_kg: sums(&|body| mass(body) + added(body)) }
    }
}
