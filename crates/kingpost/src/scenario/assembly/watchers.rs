//! Watchers of joints and closed loops, of the gaps between hulls, and of the energy.

use crate::elements::hull::HullGap;
use crate::elements::{AnyWatcher, Hull, Pendant, Rod};
use crate::ledger::EnergyBalance;
use crate::model::{Attachment, Constraint, Loop, Model, MotionType};
use crate::simulation::Setup;

/// Returns the watchers: of joints and loops that represent ropes, of every pair of hulls, and of the energy.
pub fn of(setup: &Setup) -> Vec<AnyWatcher> {
    let Setup { model, world, elements, .. } = setup;
    let supports = elements.iter().flat_map(|element| element.supports());
    let springs: Vec<usize> = supports.filter_map(|support| support.spring()).collect();
    let has_gravity = world.gravity != 0.0;
    let pendants = (0..model.bodies.len()).filter(|&body| has_gravity && hangs(model, &springs, body));
    let pendants = pendants.map(|body| -> AnyWatcher {
        let joint = &model.joints[body];
        Box::new(Pendant::new(&joint.name, &model.bodies[body].name, -joint.kind.to_child()))
    });
    let rods = model.loops.iter().filter_map(|closed| rod(model, closed));
    let hulls: Vec<&Hull> = Hull::among(elements).collect();
    let mass: f64 = model.bodies.iter().filter(|body| body.link.is_some()).map(|body| body.mass).sum();
    let energy: AnyWatcher = Box::new(EnergyBalance::new(mass * world.gravity));
    pendants.chain(rods).chain(gaps(model, &hulls)).chain([energy]).collect()
}

/// The hydrodynamics of a hull neglects the interaction with other hulls that are not in its database.
fn gaps<'a>(model: &'a Model, hulls: &'a [&'a Hull]) -> impl Iterator<Item = AnyWatcher> + 'a {
    let of = |hull: &Hull| (model.bodies[hull.frame.body].name.as_str(), hull.plan);
    let pairs =
        hulls.iter().enumerate().flat_map(|(k, first)| hulls[k + 1..].iter().map(move |second| [first, second]));
    let pairs = pairs
        .filter(|[first, second]| first.frame.body != second.frame.body && !first.feels.contains(&second.frame.body));
    pairs.map(move |pair| -> AnyWatcher { Box::new(HullGap::new(pair.map(|hull| of(hull)))) })
}

/// Returns whether a body without children swings freely, without a spring, about a point of its parent that
/// is not its centre of mass.
fn hangs(model: &Model, springs: &[usize], body: usize) -> bool {
    let node = &model.tree.nodes[body];
    let own = node.velocities..node.velocities + node.kind.velocity_count();
    let carries = model.tree.nodes.iter().any(|other| other.parent == Some(body));
    let is_free = own.clone().all(|i| model.modes[i] == MotionType::Free && !springs.contains(&i));
    node.parent.is_some() && node.kind.swings() && is_free && !carries && node.kind.to_child().norm() > 0.0
}

fn rod(model: &Model, closed: &Loop) -> Option<AnyWatcher> {
    let [(_, Constraint::Distance(_))] = closed.constraints.as_slice() else { return None };
    let end = |tie: &Attachment| tie.body.map(|body| model.bodies[body].name.as_str());
    let ends = [(&closed.first, end(&closed.first)), (&closed.second, end(&closed.second))];
    Some(Box::new(Rod::new(&closed.name, ends)))
}
