//! Loads that hang freely on a joint or a line: their weight acts on the ship at the suspension point. Loads that stand
//! on her deck: their weight acts where they are.

use crate::dynamics::{Kinematics, LinkKinematics};
use crate::elements::drives::{
    Brake, ControlledDrive, Cylinder, Motor, Oscillation, PrescribedMotion, Servo, WaveMotion,
};
use crate::elements::{CatenaryLine, Contact, Context, Hull, JointSpring, Rope, SpringLine, Submerged, of_kind};
use crate::model::{Attachment, JointKind, Mode, Model};
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
    /// The joint or the line that it hangs from.
    pub joint: String,
    /// The body under the joint.
    pub body: String,
    /// Mass of the body and all that it carries, less that of the water that it displaces as a lifted object, kg.
    pub mass_kg: f64,
    /// Distance of their centre below the joint, m.
    pub length_m: f64,
    /// The share of that length by which the effective centre of gravity rises, for heel and for trim: `|P u|^2`, with
    /// u the axis of heel or trim and P the projection on the joint's free axes. For a load that swings about one axis
    /// at an angle a to u it is `cos^2 a`.
    pub free_share: [f64; 2],
}

/// The bodies and coordinates that something keeps from swinging.
pub(super) struct Restraints {
    coordinates: Vec<usize>,
    bodies: Vec<usize>,
    /// Spring lines and the legs of ropes, by name.
    lines: Vec<(String, [Attachment; 2])>,
    /// Bodies that loops, cylinders and mooring lines are attached to.
    tied: Vec<usize>,
    /// Hulls in the water.
    wet: Vec<usize>,
    /// Bodies that touch each other.
    touching: Vec<[Option<usize>; 2]>,
    /// The water that lifted objects displace, by body.
    displaced: Vec<(usize, Weight)>,
}

impl Restraints {
    pub(super) fn of(setup: &Setup) -> Self {
        let elements = &setup.elements;
        let by_springs = of_kind(elements).map(|spring: &JointSpring| spring.coordinate);
        let by_motors = of_kind(elements).map(|motor: &Motor| motor.coordinate);
        let by_servos = of_kind(elements).map(|servo: &Servo| servo.coordinate);
        let by_controlled = of_kind(elements).map(|drive: &ControlledDrive| drive.coordinate);
        let by_brakes = of_kind(elements).map(|brake: &Brake| brake.friction.coordinate);
        let oscillating = of_kind(elements).map(|motion: &Oscillation| motion.coordinate);
        let prescribed = of_kind(elements).map(|motion: &PrescribedMotion| motion.coordinate).chain(oscillating);
        let with_waves = of_kind(elements).flat_map(WaveMotion::<f64>::coordinates);
        let driven =
            by_motors.chain(by_servos).chain(by_controlled).chain(by_brakes).chain(prescribed).chain(with_waves);
        let loops = setup.model.loops.iter().map(|closed| [&closed.first, &closed.second]);
        let cylinders = of_kind(elements).map(|cylinder: &Cylinder| [&cylinder.first, &cylinder.second]);
        let lines = of_kind(elements).map(|line: &SpringLine| (line.name.clone(), [line.first, line.second]));
        let legs = taut(setup).into_iter().flat_map(|rope: &Rope| {
            rope.path.stations().windows(2).map(|ends| (rope.name.clone(), [ends[0].centre, ends[1].centre]))
        });
        let lines: Vec<(String, [Attachment; 2])> = lines.chain(legs).collect();
        let moored = of_kind(elements).filter_map(|line: &CatenaryLine| line.fairlead.body);
        let ends = loops.chain(cylinders).flatten().filter_map(|end: &Attachment| end.body);
        let tied: Vec<usize> = ends.chain(moored).collect();
        let of_lines = lines.iter().flat_map(|(_, ends)| ends).filter_map(|end| end.body);
        Self {
            coordinates: by_springs.chain(driven).collect(),
            bodies: tied.iter().copied().chain(of_lines).collect(),
            wet: of_kind(elements).map(|hull: &Hull| hull.frame.body).collect(),
            lines,
            tied,
            touching: touching(setup),
            displaced: displaced(setup),
        }
    }

    /// Whether a hull floats alone: it hangs on nothing, carries no other hull, and no line or loop connects it to
    /// another body.
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

/// A load that hangs on lines from one point of a ship.
pub(super) struct OnLine {
    line: String,
    bodies: Vec<usize>,
    /// The suspension point in the world.
    point: Vector3,
}

/// Ends of the legs of one rope count as one point if they are closer together than this share of the distance to the
/// load: the relative error of the pendulum length is (spread / distance)^2.
const NARROW: f64 = 0.1;

/// Ends of lines closer together than this count as one point, m.
const ONE_POINT_M: f64 = 1e-6;

/// The loads that hang on lines from a hull and the bodies that its joints carry.
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

/// A weight and its centre in the world.
#[derive(Clone, Copy, Debug)]
pub(super) struct Weight {
    pub(super) mass: f64,
    pub(super) centre: Vector3,
}

impl Restraints {
    /// The weight of several bodies together, less the buoyancy of those that are lifted objects in the water.
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

/// The loads that hang on a hull, each at the outermost joint that lets it swing; `axes` are those of
/// heel and trim in the world.
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

/// The bodies whose weight a hull carries: by its joints, on lines, and those that stand on its deck.
pub(super) fn aboard(model: &Model, at: &Kinematics, hull: usize, restraints: &Restraints) -> Vec<usize> {
    let on_lines = on_lines(model, at, hull, restraints).into_iter().flat_map(|load| load.bodies);
    let on_deck = on_deck(model, hull, restraints);
    model.carried(hull).into_iter().chain(on_lines).chain(on_deck).collect()
}

/// Free bodies, with the bodies that their joints carry, that touch a hull or a body on it, and that nothing else
/// holds.
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

/// The water that lifted objects displace in the setup's position.
fn displaced(setup: &Setup) -> Vec<(usize, Weight)> {
    at_rest(setup, |at| {
        let of = |solid: &Submerged| {
            let (mass, centre) = solid.clone().displaced(at);
            (solid.place.body, Weight { mass, centre })
        };
        of_kind(&setup.elements).map(of).filter(|(_, water)| water.mass > 0.0).collect()
    })
}

/// The bodies of the contacts that touch in the setup's position.
fn touching(setup: &Setup) -> Vec<[Option<usize>; 2]> {
    at_rest(setup, |at| {
        let contacts = of_kind(&setup.elements).filter(|contact: &&Contact| contact.depth(at) > 0.0);
        contacts.map(|contact| contact.sides.each_ref().map(|side| side.body)).collect()
    })
}

/// The ropes that pull in the setup's position: a slack one carries nothing.
fn taut(setup: &Setup) -> Vec<&Rope> {
    at_rest(setup, |at| {
        let pulls = |rope: &&Rope| (*rope).clone().tension_here(at) > 0.0;
        of_kind(&setup.elements).filter(pulls).collect()
    })
}

fn at_rest<R>(setup: &Setup, see: impl FnOnce(&Context<'_>) -> R) -> R {
    let Setup { model, world, q, v, .. } = setup;
    let mut links = LinkKinematics::new(model);
    links.update(model, q, v);
    see(&Context::at_rest(world, model, &links, (q, v)))
}

/// Smaller shares are rounding.
const SMALLEST_SHARE: f64 = 1e-9;

/// Unit vectors, at right angles, that span the axes about which a body turns freely, in the world.
fn free_axes(model: &Model, at: &Kinematics, body: usize, restraints: &Restraints) -> Vec<Vector3> {
    let node = &model.tree.nodes[body];
    let own = node.velocities..node.velocities + node.kind.velocity_count();
    let free = own.filter(|i| model.modes[*i] == Mode::Free && !restraints.coordinates.contains(i));
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
