//! Warnings about a model before it runs.

use crate::elements::AnyElement;
use crate::model::Model;
use crate::scenario::ties::{floats_freely, tied_to_the_world};
use crate::world::World;

/// All warnings.
pub fn of(model: &Model, world: &World, elements: &[AnyElement]) -> Vec<String> {
    let falls = |body: usize| format!("gravity acts and nothing carries {}: it falls", model.bodies[body].name);
    falling(model, world, elements).into_iter().map(falls).collect()
}

/// Floating bodies under gravity that nothing connects to the world: no joint, no closed loop and no element that can
/// carry a body. Damping slows a fall but carries nothing.
fn falling(model: &Model, world: &World, elements: &[AnyElement]) -> Vec<usize> {
    if world.gravity == 0.0 {
        return Vec::new();
    }
    let carried = tied_to_the_world(model, elements.iter().flat_map(|element| element.ties()));
    (0..model.bodies.len()).filter(|&body| floats_freely(model, body) && !carried[body]).collect()
}
