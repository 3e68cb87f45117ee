//! Connections of bodies to the world, directly or through other bodies.

use crate::elements::{AnyElement, BodyPair};
use crate::model::{JointKind, Model};

/// Returns for each body whether joints, closed loops and these ties connect it to the world, directly or
/// through other bodies.
pub fn tied_to_the_world(model: &Model, ties: impl Iterator<Item = BodyPair>) -> Vec<bool> {
    let loops = model.loops.iter().map(|closed| [closed.first.body, closed.second.body]);
    let ties: Vec<BodyPair> = joints(model).chain(loops).chain(ties).collect();
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

/// Returns the ties that hold bodies in surge, sway and yaw.
pub fn stations(elements: &[AnyElement]) -> impl Iterator<Item = BodyPair> + '_ {
    elements.iter().flat_map(|element| element.supports()).filter_map(|support| support.station())
}

/// Returns the ties by which one body can carry another.
pub fn carrying(elements: &[AnyElement]) -> impl Iterator<Item = BodyPair> + '_ {
    elements.iter().flat_map(|element| element.supports()).filter_map(|support| support.carries())
}

fn joints(model: &Model) -> impl Iterator<Item = BodyPair> + '_ {
    let joined = (0..model.bodies.len()).filter(|&body| !floats_freely(model, body));
    joined.map(|body| [Some(body), model.tree.nodes[body].parent])
}

/// Returns whether the joint of a body lets it move away freely.
pub fn floats_freely(model: &Model, body: usize) -> bool {
    matches!(model.tree.nodes[body].kind, JointKind::Floating(floating) if !floating.hold_translation)
}
