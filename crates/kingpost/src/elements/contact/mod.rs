//! Contact of a load with a deck, a quay, the seabed, another vessel.

pub(crate) mod assembly;
mod between;
mod closed;
mod curve;
pub(crate) mod fields;
mod friction;
mod hull;
mod law;
mod length;
mod restitution;
mod set_down;
mod sides;
mod solid;
mod spot;
mod watch;

pub use closed::ClosedContact;
pub use curve::Curve;
pub use friction::Friction;
pub use hull::ConvexHull;
pub use restitution::dissipation;
pub use solid::ContactSolid;
pub use spot::Spot;

use crate::dynamics::Loads;
use crate::elements::{
    AnyWatcher, Context, Crossing, Declaration, Element, ElementState, EvaluationMode, Event, Output, PresentSupport,
    StateDeclaration, Support, VectorFrame,
};
use crate::model::Attachment;
use crate::scalar::Scalar;
use crate::spatial::Vector3;
use friction::RESTS;
use law::condition;
use length::length;
use watch::Depth;

/// Contact between two sides, a load and a surface: the spots of each side meet the solid of the other.
///
/// A spot at the depth d is pushed out along the normal with `N = k d (1 + a d')`, never less than 0. The energy `k d^2
/// / 2` is stored, the rest becomes heat ([`hunt_crossley`](crate::elements::hunt_crossley); [`dissipation`] gives a
/// from a restitution). Along the surface a bristle z holds it with `sigma (z + a d v)` up to mu N; beyond that it
/// slides with mu N against the motion until the motion reverses ([`Friction`]). Both forces act at the same point on
/// both bodies, so momentum is conserved. The elastic part of N is the gradient of the stored energy, so lifting and
/// setting down create no energy.
#[derive(Clone, Debug)]
pub struct Contact<S = f64> {
    /// Name in the results.
    pub name: String,
    /// The load's shape and the surface, each on a body or in the world.
    pub sides: [Attachment<S>; 2],
    /// The spots of the load that meet the surface's solid, and those of the surface that meet the load's.
    pub spots: Vec<(Facing, Spot<S>)>,
    /// The solids of load and surface.
    pub solids: [Option<ContactSolid<S>>; 2],
    /// k of a spot, N/m.
    pub stiffness: S,
    /// a, s/m.
    pub dissipation: S,
    /// Friction; without it, the surface is smooth.
    pub friction: Option<Friction<S>>,
    /// Penetration beyond which a run warns, m.
    pub tolerance: S,
    /// Positions of the spots in the solids' axes when their bristles were straight, m.
    pub anchors: Vec<Vector3<S>>,
    /// Whether an equilibrium is being sought.
    pub settles: bool,
}

/// Side that a spot belongs to; it meets the solid of the other side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Facing {
    /// The load's.
    Load,
    /// The surface's.
    Surface,
}

/// The mode of a spot. Only events change it, so that one force law holds throughout a step. If the lanes of a run
/// begin in different modes, the mode follows from the depth until the first event in any lane.
const BY_DEPTH: i64 = 0;
const HOLDS: i64 = 1;
const SLIDES: i64 = 2;
const OPEN: i64 = 3;

/// Events of one spot, in the order of [`Contact::declare`]; the last two with friction.
const EVENTS: [Event; 4] = [
    Event { code: "touches", what: "touches", crossing: Crossing::Rising },
    Event { code: "leaves", what: "leaves", crossing: Crossing::Falling },
    Event { code: "slides", what: "slides", crossing: Crossing::Rising },
    Event { code: "holds", what: "holds", crossing: Crossing::Falling },
];
const TOUCHES: usize = 0;
const LEAVES: usize = 1;
const BEGINS_TO_SLIDE: usize = 2;

/// Distance at which a spot leaves, m: rounding.
const ROUNDING_M: f64 = 1e-10;
/// Length of a bristle that carries only a direction, m.
const DIRECTION_M: f64 = 1e-12;
/// Friction, as a share of its limit, at and above which a spot slides.
const JUST_HOLDS: f64 = 1.0 - 1e-9;
/// A bristle whose force exceeds this multiple of the friction limit is invalid: it belongs to another position.
const PLAUSIBLE: f64 = 1.5;

impl<S: Scalar> Element<S> for Contact<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let number = |variable, description, unit| Output::number(variable, description, "contact", &self.name, unit);
        let of_spots = |what: &str| {
            let axes = |i: usize| ["x", "y", "z"].map(|axis| format!("{what}_{i}_{axis}"));
            let count = if self.friction.is_some() { self.spots.len() } else { 0 };
            (0..count).flat_map(axes).collect::<Vec<_>>()
        };
        let bristles = of_spots("bristle").into_iter().map(|name| StateDeclaration::memory(name, "m"));
        let components = crate::elements::Components::Axis;
        let force = number("contact_force", "force on the load by the surface", &["N"]);
        Declaration {
            states: bristles.chain([StateDeclaration::memory("impulse", "N s")]).collect(),
            numbers: of_spots("anchor").into_iter().chain(set_down::NUMBERS.map(str::to_owned)).collect(),
            modes: (0..self.spots.len()).map(|i| format!("spot_{i}")).collect(),
            outputs: vec![
                Output { components, frame: VectorFrame::World, ..force },
                number("contact_normal_force", "sum of the normal forces of a contact", &["N"]),
                number(
                    "contact_friction_force",
                    "sum of the friction forces of a contact's points, each by its magnitude",
                    &["N"],
                ),
                number("contact_impulse", "impulse of the normal force of a contact", &["N s"]),
                number("contact_penetration", "depth of the deepest contact point; 0 without contact", &["m"]),
                number(
                    "contact_gap",
                    "smallest distance between a load's corners, edges or round surface and its contact surface; negative: penetration",
                    &["m"],
                ),
                number("contact_points", "number of points of a contact that touch", &["1"]),
            ]
            .into_iter()
            .chain(set_down::outputs(&self.name))
            .collect(),
            goes_alone: true,
            events: (0..self.spots.len()).flat_map(|_| &EVENTS[..self.events_of_a_spot()]).copied().collect(),
            ..Declaration::default()
        }
    }

    fn begin(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        own.numbers.fill(S::ZERO);
        let sides = self.sides_at(at);
        let first_of_search = at.evaluation == EvaluationMode::Settling && !self.settles;
        self.settles = at.evaluation == EvaluationMode::Settling;
        for i in 0..self.spots.len() {
            let met = self.met(i, &sides);
            own.modes[i] = match (met.depth.all(|depth| depth >= 0.0), met.depth.all(|depth| depth < 0.0)) {
                (true, _) => HOLDS,
                (_, true) => OPEN,
                _ => BY_DEPTH,
            };
            let Some(friction) = self.friction else { continue };
            if first_of_search {
                self.anchors[i] = met.middle;
            }
            let limit = friction.coefficient * self.by_depth(&met).normal;
            let along = met.along(met.middle - self.anchors[i]);
            let is_plausible = (length(along) * friction.stiffness - limit * S::constant(PLAUSIBLE)).all(|x| x <= 0.0);
            let limit = limit * S::constant(RESTS);
            let bristle = if is_plausible { friction.within_limit(along, limit) } else { Vector3::zero() };
            bristle.write_to(&mut own.states[3 * i..]);
            self.anchors[i].write_to(&mut own.numbers[3 * i..]);
            if own.modes[i] == HOLDS {
                self.hold_or_slide(i, &friction, &met, bristle, own);
            }
        }
    }

    fn renew(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        let sides = self.sides_at(at);
        for i in 0..self.spots.len() {
            let met = self.met(i, &sides);
            let touches = met.depth.all(|depth| depth >= 0.0);
            match (own.modes[i], touches, self.friction) {
                (OPEN, true, Some(friction)) => self.touch(i, &friction, &met, own),
                (OPEN, true, None) => own.modes[i] = HOLDS,
                (HOLDS, true, Some(friction)) => {
                    let bristle = Vector3::from_slice(&own.states[3 * i..]);
                    self.hold_or_slide(i, &friction, &met, bristle, own);
                }
                (HOLDS | SLIDES, false, _) => self.let_go(i, own),
                _ => {}
            }
        }
    }

    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        let sides = self.sides_at(at);
        let (mut sum, mut heat) = (sides.nothing(), S::ZERO);
        for i in 0..self.spots.len() {
            let Some((met, pressed, drag)) = self.acting(i, &sides, at) else { continue };
            let force = met.in_world(met.normal * pressed.normal - drag.force);
            sum.push(force, &met);
            heat += pressed.heat + drag.heat;
        }
        sides.hand_over(&sum, &self.sides, loads);
        loads.power.dissipated += heat;
    }

    fn rates(&mut self, at: &Context<'_, S>, rates: &mut [S]) {
        let sides = self.sides_at(at);
        rates.fill(S::ZERO);
        let impulse = rates.len() - 1;
        for i in 0..self.spots.len() {
            let Some((_, pressed, drag)) = self.acting(i, &sides, at) else { continue };
            rates[impulse] += pressed.normal;
            if self.friction.is_some() {
                drag.rate.write_to(&mut rates[3 * i..]);
            }
        }
    }

    fn potential_energy(&mut self, at: &Context<'_, S>) -> S {
        let sides = self.sides_at(at);
        let half = S::constant(0.5);
        (0..self.spots.len()).fold(S::ZERO, |sum, i| {
            let met = self.met(i, &sides);
            let bristle = self.bristle(i, &met, at);
            let stored = self.friction.map_or(S::ZERO, |friction| friction.stiffness * bristle.norm_squared() * half);
            sum + self.pressed(condition(i, at), &met).energy + stored
        })
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let sides = self.sides_at(at);
        let (mut force, mut normal, mut friction, mut count) = (Vector3::zero(), S::ZERO, S::ZERO, S::ZERO);
        let mut deepest = S::constant(f64::MIN);
        for i in 0..self.spots.len() {
            let depth = self.met(i, &sides).depth;
            deepest = deepest.select_less(depth, || depth, || deepest);
            let Some((met, pressed, drag)) = self.acting(i, &sides, at) else { continue };
            force += met.on_load(met.in_world(met.normal * pressed.normal - drag.force));
            normal += pressed.normal;
            friction += length(drag.force);
            count += met.depth.select_below(-ROUNDING_M, || S::ZERO, || S::ONE);
        }
        let impulse = at.states.last().copied().unwrap_or(S::ZERO);
        out.extend(force.0);
        let penetration = deepest.select_below(0.0, || S::ZERO, || deepest);
        out.extend([normal, friction, impulse, penetration, -deepest, count]);
        out.extend(set_down::values(at, &self.sides));
    }

    fn event_indicators(&mut self, at: &Context<'_, S>, values: &mut [S]) {
        let sides = self.sides_at(at);
        for (i, of_spot) in values.chunks_mut(self.events_of_a_spot()).enumerate() {
            let met = self.met(i, &sides);
            of_spot.iter_mut().enumerate().for_each(|(event, value)| *value = self.indicator(event, i, &met, at));
        }
    }

    fn handle_event(&mut self, event: usize, at: &Context<'_, S>, own: &mut ElementState<'_, S>, _v: &mut [S]) {
        let (i, event) = (event / self.events_of_a_spot(), event % self.events_of_a_spot());
        let met = self.met(i, &self.sides_at(at));
        let is_alone = (0..self.spots.len()).all(|other| other == i || !matches!(own.modes[other], HOLDS | SLIDES));
        if event == TOUCHES {
            set_down::record(own.numbers, met.rate(), is_alone);
        }
        match (event, self.friction) {
            (LEAVES, _) => self.let_go(i, own),
            (TOUCHES, None) => own.modes[i] = HOLDS,
            (TOUCHES, Some(friction)) => self.touch(i, &friction, &met, own),
            (BEGINS_TO_SLIDE, Some(friction)) => {
                let bristle = self.bristle(i, &met, at);
                self.hold_or_slide(i, &friction, &met, bristle, own);
            }
            (_, Some(friction)) => {
                let normal = self.pressed(SLIDES, &met).normal;
                let rubbing = self.rubbing(&friction, &met, normal, self.bristle(i, &met, at));
                let (bristle, holds) = friction.after_sliding(&rubbing);
                own.modes[i] = if holds { HOLDS } else { SLIDES };
                bristle.write_to(&mut own.states[3 * i..]);
            }
            (_, None) => {}
        }
    }

    fn watchers(&self) -> Vec<AnyWatcher> {
        vec![Box::new(Depth::new(&self.name, self.tolerance.value()))]
    }

    fn supports(&self) -> Vec<Support> {
        vec![Support::Carries(self.sides.each_ref().map(|side| side.body))]
    }

    fn present_supports(&mut self, at: &Context<'_, S>) -> Vec<PresentSupport<S>> {
        let touches = self.depth(at).value() > 0.0;
        touches.then(|| PresentSupport::Contact(self.sides.each_ref().map(|side| side.body))).into_iter().collect()
    }
}
