//! Loads on ropes whose weight is not at its suspension point in GM: on slack slings, held by a connection, below a hook
//! block that hangs free.

use super::HullAfloat;
use super::floating::LoadedHull;
use super::hanging::{aboard, on_lines};
use crate::elements::significant;
use crate::model::{Attachment, JointKind};
use crate::spatial::Vector3;

/// Smallest change of GM that is reported, m: the last digit in a report.
const SMALLEST_CHANGE_M: f64 = 1e-3;

/// Free bodies that ropes connect to each other and to a ship.
struct RopedGroup {
    /// The first bodies of their branches.
    roots: Vec<usize>,
    /// Highest end of their ropes on the ship, in the world, m.
    suspension_z_m: f64,
}

impl LoadedHull<'_> {
    /// Returns by how much GM changes if loads on ropes hang from their suspension points, for those that do not in
    /// `afloat`.
    pub(super) fn unsuspended(&self, afloat: &HullAfloat) -> Vec<String> {
        self.groups().iter().filter_map(|group| self.change_of(group, afloat)).collect()
    }

    /// Returns the groups of free bodies on the ship's ropes, without those in the water.
    fn groups(&self) -> Vec<RopedGroup> {
        let (model, ship) = (self.model, self.model.carried(self.hull.frame.body));
        let is_free = |root: &usize| {
            let node = &model.tree.nodes[*root];
            node.parent.is_none() && !ship.contains(root) && matches!(node.kind, JointKind::Floating(_))
        };
        let mut left: Vec<usize> = (0..model.bodies.len()).filter(is_free).collect();
        let root_of = |end: &Attachment| {
            let mut body = end.body?;
            while let Some(parent) = model.tree.nodes[body].parent {
                body = parent;
            }
            Some(body)
        };
        let mut groups = Vec::new();
        while let Some(first) = left.pop() {
            let mut roots = vec![first];
            loop {
                let joined = |root: &usize| {
                    self.restraints.legs.iter().any(|[one, other]| {
                        let ends = [root_of(one), root_of(other)];
                        ends.contains(&Some(*root)) && ends.iter().flatten().any(|end| roots.contains(end))
                    })
                };
                let Some(next) = left.iter().position(joined) else { break };
                roots.push(left.swap_remove(next));
            }
            let on_ship = self.restraints.legs.iter().filter_map(|[one, other]| {
                let joins = |load: &Attachment, end: &Attachment| {
                    root_of(load).is_some_and(|root| roots.contains(&root))
                        && end.body.is_some_and(|body| ship.contains(&body))
                };
                let end = if joins(one, other) {
                    other
                } else if joins(other, one) {
                    one
                } else {
                    return None;
                };
                Some(self.at.world[end.body?].point(end.in_body.position)[2])
            });
            let highest = on_ship.fold(f64::NEG_INFINITY, f64::max);
            let is_wet = roots.iter().any(|root| model.carried(*root).iter().any(|body| self.restraints.is_wet(*body)));
            if highest.is_finite() && !is_wet {
                groups.push(RopedGroup { roots, suspension_z_m: highest });
            }
        }
        groups
    }

    /// Returns the change of GM if a group hangs from the highest end of its ropes.
    fn change_of(&self, group: &RopedGroup, afloat: &HullAfloat) -> Option<String> {
        let hull = self.hull.frame.body;
        let aboard = aboard(self.model, self.at, hull, self.restraints);
        let hanging: Vec<usize> =
            on_lines(self.model, self.at, hull, self.restraints).into_iter().flat_map(|load| load.bodies).collect();
        let of = |root: &usize| self.restraints.weight(self.model, self.at, &self.model.carried(*root));
        let (standing, missing): (Vec<usize>, Vec<usize>) =
            group.roots.iter().filter(|root| !hanging.contains(root)).partition(|root| aboard.contains(root));
        // The centre of gravity in the world, with hanging loads at their suspension points and free surfaces.
        let rise = afloat.fluid_keel_to_gravity_m[0] - afloat.keel_to_gravity_m;
        let centre_z_m = self.carried_weight().centre[2] + rise;
        let moment = |roots: &[usize], from: &dyn Fn(Vector3) -> f64, to_z_m: Option<f64>| -> f64 {
            roots.iter().map(of).map(|of| of.mass * (to_z_m.unwrap_or(of.centre[2]) - from(of.centre))).sum()
        };
        let added: f64 = missing.iter().map(of).map(|of| of.mass).sum();
        let total = afloat.mass_kg + added;
        let top = Some(group.suspension_z_m);
        let fixed = -moment(&missing, &|_| centre_z_m, None) / total;
        let hung = -(moment(&missing, &|_| centre_z_m, top) + moment(&standing, &|centre| centre[2], top)) / total;
        if hung.abs() < SMALLEST_CHANGE_M && fixed.abs() < SMALLEST_CHANGE_M {
            return None;
        }
        let names = |roots: &[usize]| {
            let names: Vec<&str> = roots.iter().map(|root| self.model.bodies[*root].name.as_str()).collect();
            names.join(", ")
        };
        let gm = afloat.metacentric_height_m[0];
        let hangs = format!(
            "with {} hanging from the highest end of the ropes it changes by {} m, to {} m",
            names(&group.roots),
            metres(hung),
            metres(gm + hung)
        );
        let name = &afloat.body;
        Some(if missing.is_empty() {
            format!("{name}: GM is with {} on slack ropes, standing: {hangs}", names(&standing))
        } else {
            format!(
                "{name}: KG, GM and GZ are without {}, {} t: aboard in this position GM changes by {} m, to {} m; {hangs}",
                names(&missing),
                significant(added / 1e3, 4),
                metres(fixed),
                metres(gm + fixed)
            )
        })
    }
}

fn metres(value: f64) -> String {
    format!("{value:.3}")
}
