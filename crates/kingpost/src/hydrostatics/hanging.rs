//! Loads that hang freely on a joint or a line: their weight acts on the ship at the suspension point. Loads
//! that stand on the deck: their weight acts at their position.

use crate::dynamics::{Kinematics, LinkKinematics};
use crate::elements::{BodyPair, Context, PresentSupport, Rope, Support};
use crate::model::{Attachment, JointKind, Model, MotionType};
use crate::simulation::Setup;
use crate::spatial::Vector3;
use serde::Serialize;

/// A load that hangs on a joint, or on lines.
///
/// A load hangs on a joint if the centre of all that the joint carries is below it, at least one rotation is free, no
/// spring, brake, servo or motor acts on that rotation, and no closed loop, cylinder, spring line or hull is attached
/// to the bodies that it carries.
///
/// A load hangs on spring lines or ropes if they start from one point of the ship, or are legs of one rope with ends
/// close together, and carry a body with a floating joint that nothing else holds: no water, loop, cylinder, contact or
/// other line. Slack ropes carry nothing. The end of a leg at a sheave is the sheave's centre.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct HangingLoad {
    /// Joint or line from which the load hangs.
    pub joint: String,
    /// The body under the joint.
    pub body: String,
    /// Mass of the body and of all bodies that it carries, less the mass of the water that lifted objects
    /// among them displace, kg.
    pub mass_kg: f64,
    /// Distance of their common centre of mass below the joint, m.
    pub length_m: f64,
    /// The share of that length by which the effective centre of gravity rises, for heel and for trim: `|P u|^2`, with
    /// u the axis of heel or trim and P the projection on the joint's free axes. For a load that swings about one axis
    /// at an angle a to u it is `cos^2 a`.
    pub free_share: [f64; 2],
}

/// Bodies and coordinates that cannot swing freely.
#[derive(Default)]
pub(super) struct Restraints {
    coordinates: Vec<usize>,
    bodies: Vec<usize>,
    /// Spring lines and the legs of ropes, by name.
    lines: Vec<(String, [Attachment; 2])>,
    /// Legs of all ropes, slack ones too.
    pub(super) legs: Vec<[Attachment; 2]>,
    /// Bodies to which loops, cylinders and mooring lines are attached.
    tied: Vec<usize>,
    /// Hulls in the water.
    wet: Vec<usize>,
    /// Bodies that touch each other.
    touching: Vec<BodyPair>,
    /// Mass of water that lifted objects displace, by body.
    displaced: Vec<(usize, Weight)>,
}

impl Restraints {
    /// Returns the restraints of a setup in its present position.
    pub(super) fn of(mut setup: Setup) -> Self {
        let loops = setup.model.loops.iter().flat_map(|closed| [closed.first.body, closed.second.body]);
        let mut found = Self { tied: loops.flatten().collect(), ..Self::default() };
        let Setup { model, world, elements, q, v, .. } = &mut setup;
        let mut links = LinkKinematics::new(model);
        links.update(model, q, v);
        let at = Context::at_rest(world, model, &links, (q, v));
        for element in elements {
            element.supports().into_iter().for_each(|support| found.add(support));
            let present = element.present_supports(&at);
            present.into_iter().for_each(|support| found.add_present(element.name(), support));
        }
        let stations = Rope::among(&setup.elements).flat_map(|rope| rope.path.stations().windows(2));
        found.legs = stations.map(|ends| [ends[0].centre, ends[1].centre]).collect();
        let of_lines = found.lines.iter().flat_map(|(_, ends)| ends).filter_map(|end| end.body);
        found.bodies = found.tied.iter().copied().chain(of_lines).collect();
        found
    }

    /// Returns whether a body is a hull in the water.
    pub(super) fn is_wet(&self, body: usize) -> bool {
        self.wet.contains(&body)
    }

    fn add(&mut self, support: Support) {
        match support {
            Support::Coordinate(coordinate) | Support::Spring(coordinate) => self.coordinates.push(coordinate),
            Support::Tie(body) => self.tied.push(body),
            Support::Afloat(body) => self.wet.push(body),
            Support::Carries(_) | Support::Station(_) => {}
        }
    }

    fn add_present(&mut self, name: &str, support: PresentSupport) {
        match support {
            PresentSupport::Line(ends) => self.lines.push((name.to_owned(), ends)),
            PresentSupport::Contact(pair) => self.touching.push(pair),
            PresentSupport::Displaced { body, mass, centre } if mass > 0.0 => {
                self.displaced.push((body, Weight { mass, centre }));
            }
            PresentSupport::Displaced { .. } => {}
        }
    }

    /// Returns whether a hull floats alone: it does not hang, carries no other hull, and no line or loop
    /// connects it to another body.
    pub(super) fn floats_alone(&self, model: &Model, hull: usize) -> bool {
        let own = model.carried(hull);
        let is_own = |end: &Attachment| end.body.is_some_and(|body| own.contains(&body));
        let leads_out = |ends: &[Attachment; 2]| {
            ends.iter().any(is_own) && ends.iter().any(|end| end.body.is_some() && !is_own(end))
        };
        let by_loops = model.loops.iter().any(|closed| leads_out(&[closed.first, closed.second]));
        let by_lines = self.lines.iter().any(|(_, ends)| leads_out(ends));
        let with_other_hulls = own.iter().any(|body| *body != hull && self.wet.contains(body));
        model.tree.nodes[hull].parent.is_none() && !by_loops && !by_lines && !with_other_hulls
    }
}

/// A load that hangs on lines from a single point of a ship.
pub(super) struct OnLine {
    line: String,
    pub(super) bodies: Vec<usize>,
    /// The suspension point in the world.
    point: Vector3,
}

/// Largest distance between ends of the legs of one rope that count as one point, as a share of the distance
/// to the load: the relative error of the pendulum length is (spread / distance)^2.
const NARROW: f64 = 0.1;

/// Largest distance between ends of lines that count as one point, m.
const ONE_POINT_M: f64 = 1e-6;

/// Returns the loads that hang on lines from a hull and the bodies that its joints carry.
pub(super) fn on_lines(model: &Model, at: &Kinematics, hull: usize, restraints: &Restraints) -> Vec<OnLine> {
    let ship = model.carried(hull);
    let point = |end: &Attachment| end.body.map(|body| at.world[body].point(end.in_body.position));
    let roots = (0..model.bodies.len()).filter(|&body| model.tree.nodes[body].parent.is_none());
    roots
        .filter(|root| !ship.contains(root) && matches!(model.joints[*root].kind, JointKind::Floating(_)))
        .filter_map(|root| {
            let bodies = model.carried(root);
            let has = |end: &Attachment| end.body.is_some_and(|body| bodies.contains(&body));
            let stands = |body: &usize| restraints.touching.iter().flatten().any(|end| end.as_ref() == Some(body));
            let is_held =
                |body: &usize| restraints.tied.contains(body) || restraints.wet.contains(body) || stands(body);
            if bodies.iter().any(is_held) {
                return None;
            }
            let outside =
                restraints.lines.iter().filter_map(|(name, [first, second])| match [has(first), has(second)] {
                    [true, false] => Some((name, second)),
                    [false, true] => Some((name, first)),
                    _ => None,
                });
            let outside: Vec<_> = outside.collect();
            let from_ship = |end: &Attachment| end.body.is_some_and(|body| ship.contains(&body));
            let (line, end) = outside.first()?;
            let first = point(end)?;
            let load = restraints.weight(model, at, &bodies).centre;
            let near = |name: &String| if name == *line { NARROW * (load - first).norm() } else { ONE_POINT_M };
            let together = |name: &String, end: &Attachment| {
                from_ship(end) && point(end).is_some_and(|p| (p - first).norm() < near(name))
            };
            let all = outside.iter().all(|(name, end)| together(name, end));
            let sum = outside.iter().filter_map(|(_, end)| point(end)).fold(Vector3::zero(), |sum, end| sum + end);
            let point = sum * (1.0 / outside.len() as f64);
            all.then(|| OnLine { line: (*line).clone(), bodies, point })
        })
        .collect()
}

/// A mass, and its centre in the world.
#[derive(Clone, Copy, Debug)]
pub(super) struct Weight {
    pub(super) mass: f64,
    pub(super) centre: Vector3,
}

impl Restraints {
    /// Returns the total weight of several bodies, less the buoyancy of those that are lifted objects in the
    /// water.
    pub(super) fn weight(&self, model: &Model, at: &Kinematics, bodies: &[usize]) -> Weight {
        let of_body = |&body: &usize| (model.bodies[body].mass, at.world[body].position);
        let buoyant = self.displaced.iter().filter(|(body, _)| bodies.contains(body));
        let parts = bodies.iter().map(of_body).chain(buoyant.map(|(_, water)| (-water.mass, water.centre)));
        let sum =
            |(mass, moment): (f64, Vector3), (of_part, at): (f64, Vector3)| (mass + of_part, moment + at * of_part);
        let (mass, moment) = parts.fold((0.0, Vector3::zero()), sum);
        Weight { mass, centre: moment * (1.0 / mass) }
    }
}

/// Returns the loads that hang on a hull, each at the outermost joint about which it can swing; `axes` are
/// those of heel and trim in the world.
pub(super) fn loads(
    model: &Model,
    at: &Kinematics,
    hull: usize,
    restraints: &Restraints,
    axes: [Vector3; 2],
) -> Vec<HangingLoad> {
    let mut found: Vec<HangingLoad> = Vec::new();
    let mut hanging: [Vec<usize>; 2] = Default::default();
    for &body in model.carried(hull).iter().skip(1) {
        let below = model.carried(body);
        if below.iter().any(|body| restraints.bodies.contains(body) || restraints.wet.contains(body)) {
            continue;
        }
        let Weight { mass, centre } = restraints.weight(model, at, &below);
        let pivot = at.world[body].point(-model.tree.nodes[body].kind.to_child());
        let length_m = pivot[2] - centre[2];
        let free = free_axes(model, at, body, restraints);
        let mut free_share = axes.map(|axis| free.iter().map(|u| u.dot(axis) * u.dot(axis)).sum::<f64>());
        for (share, hanging) in free_share.iter_mut().zip(&mut hanging) {
            if hanging.contains(&body) || *share < SMALLEST_SHARE {
                *share = 0.0;
            } else if length_m > 0.0 {
                hanging.extend(&below);
            }
        }
        if length_m > 0.0 && free_share != [0.0; 2] {
            let (joint, body) = (model.joints[body].name.clone(), model.bodies[body].name.clone());
            found.push(HangingLoad { joint, body, mass_kg: mass, length_m, free_share });
        }
    }
    found.extend(on_lines(model, at, hull, restraints).into_iter().filter_map(|load| {
        let Weight { mass, centre } = restraints.weight(model, at, &load.bodies);
        let (body, length_m) = (model.bodies[load.bodies[0]].name.clone(), load.point[2] - centre[2]);
        let hanging = HangingLoad { joint: load.line, body, mass_kg: mass, length_m, free_share: [1.0; 2] };
        (length_m > 0.0).then_some(hanging)
    }));
    found
}

/// Returns the bodies whose weight a hull carries: by its joints, on lines, or on its deck.
pub(super) fn aboard(model: &Model, at: &Kinematics, hull: usize, restraints: &Restraints) -> Vec<usize> {
    let on_lines = on_lines(model, at, hull, restraints).into_iter().flat_map(|load| load.bodies);
    let on_deck = on_deck(model, hull, restraints);
    model.carried(hull).into_iter().chain(on_lines).chain(on_deck).collect()
}

/// Returns the free bodies that stand on a hull or on a body that it carries and that nothing else holds,
/// with the bodies that their joints carry.
fn on_deck(model: &Model, hull: usize, restraints: &Restraints) -> Vec<usize> {
    let ship = model.carried(hull);
    let is_free = |root: &usize| {
        let node = &model.tree.nodes[*root];
        node.parent.is_none() && !ship.contains(root) && matches!(node.kind, JointKind::Floating(_))
    };
    let stands = |bodies: &Vec<usize>| {
        let is_held = |body: &usize| restraints.bodies.contains(body) || restraints.wet.contains(body);
        let has = |end: &Option<usize>| end.is_some_and(|body| bodies.contains(&body));
        let on_ship = |end: &Option<usize>| end.is_some_and(|body| ship.contains(&body));
        let own: Vec<_> = restraints.touching.iter().filter(|pair| pair.iter().any(has)).collect();
        let only_ship = own.iter().all(|pair| pair.iter().all(|end| has(end) || on_ship(end)));
        !bodies.iter().any(is_held) && only_ship && own.iter().any(|pair| pair.iter().any(on_ship))
    };
    let roots = (0..model.bodies.len()).filter(is_free);
    roots.map(|root| model.carried(root)).filter(stands).flatten().collect()
}

/// Smallest share that is not rounding.
const SMALLEST_SHARE: f64 = 1e-9;

/// Returns perpendicular unit vectors that span the axes about which a body turns freely, in the world.
fn free_axes(model: &Model, at: &Kinematics, body: usize, restraints: &Restraints) -> Vec<Vector3> {
    let node = &model.tree.nodes[body];
    let own = node.velocities..node.velocities + node.kind.velocity_count();
    let free = own.filter(|i| model.modes[*i] == MotionType::Free && !restraints.coordinates.contains(i));
    let mut axes: Vec<Vector3> = Vec::new();
    for i in free {
        let axis = at.world[body].rotation * at.columns[i].angular;
        let rest = axes.iter().fold(axis, |rest, u| rest - *u * u.dot(rest));
        if rest.norm() > SMALLEST_SHARE {
            axes.push(rest.direction());
        }
    }
    axes
}
