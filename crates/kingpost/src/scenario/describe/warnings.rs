//! What a person should know of a model before it runs.

use crate::elements::AnyElement;
use crate::model::{JointKind, Model};
use crate::world::World;

/// A pair of bodies that are tied together; `None` is the world.
type Tie = [Option<usize>; 2];

/// All warnings.
pub fn of(model: &Model, world: &World, elements: &[AnyElement]) -> Vec<String> {
    let falls = |body: usize| format!("gravity acts and nothing carries {}: it falls", model.bodies[body].name);
    falling(model, world, elements).into_iter().map(falls).collect()
}

/// Floating bodies that gravity pulls on and nothing ties to the world, through however many bodies: no joint, no closed
/// loop and no element that may hold one body up by another. Damping slows a fall but carries nothing.
fn falling(model: &Model, world: &World, elements: &[AnyElement]) -> Vec<usize> {
    if world.gravity == 0.0 {
        return Vec::new();
    }
    let loops = model.loops.iter().map(|closed| [closed.first.body, closed.second.body]);
    let ties: Vec<Tie> = joints(model).chain(loops).chain(elements.iter().flat_map(|element| element.ties())).collect();
    let mut carried = vec![false; model.bodies.len()];
    loop {
        let before = carried.clone();
        let holds = |carried: &[bool], end: Option<usize>| end.is_none_or(|body| carried[body]);
        for [first, second] in &ties {
            if holds(&carried, *first) || holds(&carried, *second) {
                [first, second].into_iter().flatten().for_each(|body| carried[*body] = true);
            }
        }
        if carried == before {
            break;
        }
    }
    (0..model.bodies.len()).filter(|&body| floats_freely(model, body) && !carried[body]).collect()
}

fn joints(model: &Model) -> impl Iterator<Item = Tie> + '_ {
    let joined = (0..model.bodies.len()).filter(|&body| !floats_freely(model, body));
    joined.map(|body| [Some(body), model.tree.nodes[body].parent])
}

/// Whether a body's joint leaves it free to move away.
fn floats_freely(model: &Model, body: usize) -> bool {
    matches!(model.tree.nodes[body].kind, JointKind::Floating(floating) if !floating.hold_translation)
}
