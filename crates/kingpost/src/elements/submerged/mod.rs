//! The water on a lifted object: in the splash zone and below.

pub(crate) mod assembly;
mod entrained;
pub(crate) mod fields;
mod growth;
mod immersion;
mod loads;

pub use entrained::EntrainedWater;
pub use growth::{AddedMassGrowth, GrowthError};
pub use immersion::Waters;
pub use loads::{AddedMassOf, Drag, Slamming, WindOnDry};

use super::hull::HullFrame;
use super::{
    AnyElement, Components, Context, Crossing, Declaration, Element, ElementState, EvaluationMode, Event, Output,
    PresentSupport, ShownWaves, StateDeclaration, Support, VectorFrame, of_kind,
};
use crate::dynamics::{Kinematics, Loads};
use crate::scalar::Scalar;
use crate::sea::hull::Solid;
use crate::spatial::{Frame, Vector3, Wrench};
use entrained::Levels;
use immersion::{Immersion, Phase};
use loads::SubmergedLoads;

/// A simple solid on a body that is lowered through the surface of the sea and is small compared with the waves.
///
/// The sea's surface is taken as a plane with the elevation and slope at the solid's centre. With the volume V below
/// it, the share s = V / V_0, the centre b of V, the water's velocity u and acceleration a at its depth, and the added
/// mass A = phi(s) A_0 about the solid's centre (DNV-RP-N103, *Modelling and analysis of marine operations*; Newman,
/// *Marine Hydrodynamics*, 1977, sec. 4.14 on the last two; Faltinsen, *Sea Loads*, 1990, sec. 9.2 on slamming as dA/dt
/// v)
///
/// ```text
/// buoyancy and Froude-Krylov force   rho V (g + a), at b
/// drag                               s (1/2 rho C_D A_p |u_r| + c) u_r by axis, u_r = u - v at b
/// added mass                         -(A nu_r' + nu_r x* A nu_r) with the twist nu_r through the water
/// slamming                           -A' nu_r while A grows, or 1/2 rho C_S A_S w^2 while it sinks with the speed w
/// ```
///
/// As the body comes out, the detaching water keeps its momentum, so A decreases without a force. (A force d(A v)/dt
/// would push the body out and add energy.) On entry and on exit, the motion loses the power `|A'| v^2 / 2` to the
/// water.
#[derive(Clone, Debug)]
pub struct Submerged<S = f64> {
    /// Name in the results.
    pub name: String,
    /// The body, and the solid's centre; its axes are the body's.
    pub place: HullFrame<S>,
    /// The solid that the surface cuts.
    pub solid: Solid<S>,
    /// Displaced volume over the solid's volume.
    pub displaced: S,
    /// A_0 for rho = 1, and phi.
    pub added_mass: AddedMassOf<S>,
    /// Slamming by a coefficient, which replaces A' nu_r.
    pub slamming: Option<Slamming<S>>,
    /// Drag of the wet share.
    pub drag: Drag<S>,
    /// Drag of the wind on the dry share.
    pub wind: Option<WindOnDry<S>>,
    /// Water inside.
    pub entrained: Option<EntrainedWater<S>>,
    /// The sea at the solid.
    pub waters: Waters<S>,
}

/// Events, in the order of [`Submerged::declare`].
const EVENTS: [Event; 4] = [
    Event { code: "meets_water", what: "meets the water", crossing: Crossing::Rising },
    Event { code: "goes_under", what: "is under water", crossing: Crossing::Rising },
    Event { code: "comes_to_surface", what: "comes to the surface", crossing: Crossing::Falling },
    Event { code: "leaves_water", what: "leaves the water", crossing: Crossing::Falling },
];
const MEETS: usize = 0;
const IS_UNDER: usize = 1;
const COMES_UP: usize = 2;
const LEAVES: usize = 3;
/// Tolerance of the depth at the limits of a phase, m: rounding.
const ROUNDING_M: f64 = 1e-9;

impl<S: Scalar> Element<S> for Submerged<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        Declaration {
            states: self.entrained.iter().map(|_| StateDeclaration::new("entrained_level", "m")).collect(),
            modes: vec!["phase".to_owned()],
            outputs: outputs(&self.name, self.entrained.is_some()),
            events: EVENTS.to_vec(),
            ..Declaration::default()
        }
    }

    fn begin(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        self.renew(at, own);
        if let Some(water) = &self.entrained {
            let depth = self.waters.depth(at, &self.place, water.floor());
            own.states[0] = water.at_start(water.outside(depth));
        }
    }

    fn renew(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        let [low, high] = self.waters.margins(at, &self.place, &self.solid);
        own.modes[0] = Phase::of(low, high) as i64;
    }

    fn rates(&mut self, at: &Context<'_, S>, rates: &mut [S]) {
        let Some(water) = self.entrained else { return };
        let outside = water.outside(self.waters.depth(at, &self.place, water.floor()));
        rates[0] = water.rate(at.world.gravity, &Levels { inside: at.states[0], outside });
    }

    /// Adds the loads, the added mass and the power.
    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        let now = self.immersion(at);
        let parts = self.parts(at, &now);
        let (about_centre, twist) = (|wrench: &Wrench<S>| self.place.about_centre(wrench), &now.twist);
        let still = self.still_buoyancy(at, &now);
        let rest = parts.sum() - parts.drag - still;
        loads.power.outside += rest.dot(twist) + parts.drag.force.dot(now.stream);
        loads.power.dissipated += parts.drag.force.dot(now.stream - now.velocity_at_centre());
        loads.wrenches.push((self.place.body, about_centre(&parts.sum())));
        if !now.share.all(|share| share == 0.0) {
            let added = self.added_mass.inertia(at.world.water_density, now.factor);
            loads.added_inertia.push((self.place.body, added.to_parent(&Frame::translation(self.place.origin))));
        }
        if let Some((water, levels)) = self.inside(at, &now) {
            let carried = water.inertia(at.world.water_density, &levels);
            loads.added_inertia.push((self.place.body, carried.to_parent(&Frame::translation(self.place.origin))));
        }
    }

    /// Returns the work of pushing it into still water, J.
    fn potential_energy(&mut self, at: &Context<'_, S>) -> S {
        let frame = self.place.frame(at.model, at.links);
        let (vertical, level) = (frame.rotation.row(2), -frame.position[2]);
        let below = self.solid.below(vertical, level);
        let height_moment = vertical.dot(below.first_moment) - level * below.volume;
        -(height_moment * at.world.specific_weight() * self.displaced)
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let now = self.immersion(at);
        let parts = self.parts(at, &now);
        let world = |vector: Vector3<S>| now.frame.rotation * vector;
        out.push(now.share);
        let forces = [parts.buoyancy, parts.drag, parts.inertia, parts.slamming].map(|part| part.force);
        forces.into_iter().for_each(|force| out.extend(world(force).0));
        let sum = parts.sum();
        out.extend(world(sum.force).0);
        out.extend(world(sum.moment).0);
        let factor = at.world.water_density * now.factor;
        out.extend(self.added_mass.linear.0.map(|volume| volume * factor));
        if let Some((water, levels)) = self.inside(at, &now) {
            let density = at.world.water_density;
            out.extend([water.mass(density, &levels), water.mass_above(density * at.world.gravity, &levels)]);
        }
    }

    fn event_indicators(&mut self, at: &Context<'_, S>, values: &mut [S]) {
        let phase = Phase::at(at);
        let [low, high] = self.waters.margins(at, &self.place, &self.solid);
        for (event, value) in values.iter_mut().enumerate() {
            let is_watched = match event {
                MEETS => matches!(phase, Phase::Dry | Phase::ByLevel),
                LEAVES | IS_UNDER => matches!(phase, Phase::Cut | Phase::ByLevel),
                _ => matches!(phase, Phase::Wet | Phase::ByLevel),
            };
            *value = match event {
                MEETS | IS_UNDER if !is_watched => -S::ONE,
                _ if !is_watched => S::ONE,
                MEETS => low,
                IS_UNDER => high,
                COMES_UP => high + S::constant(ROUNDING_M),
                _ => low + S::constant(ROUNDING_M),
            };
        }
    }

    fn handle_event(&mut self, event: usize, _at: &Context<'_, S>, own: &mut ElementState<'_, S>, _v: &mut [S]) {
        own.modes[0] = match event {
            MEETS | COMES_UP => Phase::Cut,
            IS_UNDER => Phase::Wet,
            _ => Phase::Dry,
        } as i64;
    }

    fn shown_waves(&self, _bodies: &Kinematics<S>) -> Vec<(usize, ShownWaves<S>)> {
        let written = self.declare().outputs.iter().map(Output::len).sum();
        (0..written).map(|number| (number, ShownWaves::NotLinear)).collect()
    }

    fn left_out_at_rest(&self) -> Option<&'static str> {
        Some("the response leaves out wave loads and drag on its submerged part; a run contains them")
    }

    fn supports(&self) -> Vec<Support> {
        vec![Support::Carries([Some(self.place.body), None])]
    }

    fn present_supports(&mut self, at: &Context<'_, S>) -> Vec<PresentSupport<S>> {
        let (mass, centre) = self.displaced(at);
        vec![PresentSupport::Displaced { body: self.place.body, mass, centre }]
    }
}

impl<S: Scalar> Submerged<S> {
    /// Returns the lifted objects among elements.
    pub fn among(elements: &[AnyElement<S>]) -> impl Iterator<Item = &Self> {
        of_kind(elements)
    }

    /// Returns the mass of the water that it displaces with the model at rest, kg, and the centre of that water in the
    /// world, m.
    pub fn displaced(&mut self, at: &Context<'_, S>) -> (S, Vector3<S>) {
        let now = self.immersion(at);
        (at.world.water_density * self.displaced * now.below.volume, now.frame.point(now.centre))
    }

    fn immersion(&mut self, at: &Context<'_, S>) -> Immersion<S> {
        let mut now = self.waters.immersion(at, &self.place, &self.solid);
        [now.factor, now.factor_rate] = self.added_mass.growth.at(now.share, now.share_rate);
        now
    }

    fn parts(&self, at: &Context<'_, S>, now: &Immersion<S>) -> SubmergedLoads<S> {
        let density = at.world.water_density;
        let (inertia, of_growth) = self.added_mass.forces(density, now);
        let slamming = self.slamming.as_ref().map_or(of_growth, |given| given.force(density, &self.solid, now));
        SubmergedLoads {
            buoyancy: self.buoyancy(at, now),
            drag: self.drag.force(density, now),
            inertia,
            slamming,
            wind: self.wind.as_ref().map_or(Wrench::zero(), |wind| wind.force(at, now)),
            entrained: self.inside(at, now).map_or(Wrench::zero(), |(water, levels)| {
                water.force(at.world.specific_weight(), now.frame.rotation.row(2), &levels)
            }),
        }
    }

    /// Returns the water inside, if it can hold any. At rest the level inside is the level of the sea.
    fn inside(&self, at: &Context<'_, S>, now: &Immersion<S>) -> Option<(EntrainedWater<S>, Levels<S>)> {
        let water = self.entrained?;
        let outside = water.outside(now.depth(water.floor()));
        let inside = if has_phases(at.evaluation) { *at.states.first()? } else { outside };
        Some((water, Levels { inside, outside }))
    }

    /// Returns rho V (g + a), at the centre of V.
    fn buoyancy(&self, at: &Context<'_, S>, now: &Immersion<S>) -> Wrench<S> {
        let vertical = now.frame.rotation.row(2);
        let field = (vertical * at.world.gravity + now.acceleration) * (at.world.water_density * self.displaced);
        Wrench { moment: now.below.first_moment.cross(field), force: field * now.below.volume }
    }

    /// Returns the buoyancy in still water, which has a potential.
    fn still_buoyancy(&self, at: &Context<'_, S>, now: &Immersion<S>) -> Wrench<S> {
        let vertical = now.frame.rotation.row(2);
        let below = if now.in_waves { self.solid.below(vertical, -now.frame.position[2]) } else { now.below };
        let field = vertical * (at.world.specific_weight() * self.displaced);
        Wrench { moment: below.first_moment.cross(field), force: field * below.volume }
    }
}

/// Returns its outputs, in the order of [`Submerged::outputs`](Element::outputs).
fn outputs(name: &str, holds_water: bool) -> Vec<Output> {
    let number = |variable, description, unit| Output::number(variable, description, "submerged", name, unit);
    let vector = |variable, description, frame, unit| Output {
        components: Components::Axis,
        frame,
        ..number(variable, description, unit)
    };
    let force = |variable, description| vector(variable, description, VectorFrame::World, &["N"]);
    let mut all = vec![
        number("submerged_share", "volume below the surface over the total volume", &["1"]),
        force("submerged_buoyancy", "buoyancy with the Froude-Krylov force of the waves"),
        force("submerged_drag", "drag of the water on the wet part"),
        force(
            "submerged_inertia",
            "force on the added mass due to the water's acceleration and, as the body turns, to its velocity; the body's inertia contains the force due to the body's acceleration",
        ),
        force("submerged_slamming", "slamming force: of the growing added mass, or by a slamming coefficient"),
        Output::wrench(
            "submerged_force",
            "sum of the loads of water and wind, with the moment about the solid's centre; without the force due to the body's acceleration",
            "submerged",
            name,
            VectorFrame::World,
        ),
        vector("submerged_added_mass", "added mass along the body's axes", VectorFrame::Body, &["kg"]),
    ];
    if holds_water {
        let what = "weight of the water inside a lifted object above the level of the sea outside; negative: the sea is higher";
        all.push(number("entrained_water", "water inside a lifted object", &["kg"]));
        all.push(number("entrained_weight", what, &["N"]));
    }
    all
}

/// Whether solids have phases in this mode of evaluation. At rest the level determines the law.
fn has_phases(evaluation: EvaluationMode) -> bool {
    evaluation.runs()
}
