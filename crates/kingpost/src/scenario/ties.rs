//! What ties bodies to the world, one through another.

use crate::elements::AnyElement;
use crate::model::{JointKind, Model};

/// A pair of bodies of which one may hold the other; `None` is the world.
pub type Tie = [Option<usize>; 2];

/// By body whether joints, closed loops and these ties lead from it to the world, through however many bodies.
pub fn tied_to_the_world(model: &Model, ties: impl Iterator<Item = Tie>) -> Vec<bool> {
    let loops = model.loops.iter().map(|closed| [closed.first.body, closed.second.body]);
    let ties: Vec<Tie> = joints(model).chain(loops).chain(ties).collect();
    let mut tied = vec![false; model.bodies.len()];
    loop {
        let before = tied.clone();
        let holds = |tied: &[bool], end: Option<usize>| end.is_none_or(|body| tied[body]);
        for [first, second] in &ties {
            if holds(&tied, *first) || holds(&tied, *second) {
                [first, second].into_iter().flatten().for_each(|body| tied[*body] = true);
            }
        }
        if tied == before {
            return tied;
        }
    }
}

/// The ties that keep bodies in their places, in surge, sway and yaw.
pub fn stations(elements: &[AnyElement]) -> impl Iterator<Item = Tie> + '_ {
    elements.iter().filter_map(|element| element.keeps_station())
}

fn joints(model: &Model) -> impl Iterator<Item = Tie> + '_ {
    let joined = (0..model.bodies.len()).filter(|&body| !floats_freely(model, body));
    joined.map(|body| [Some(body), model.tree.nodes[body].parent])
}

/// Whether a body's joint leaves it free to move away.
pub fn floats_freely(model: &Model, body: usize) -> bool {
    matches!(model.tree.nodes[body].kind, JointKind::Floating(floating) if !floating.hold_translation)
}
