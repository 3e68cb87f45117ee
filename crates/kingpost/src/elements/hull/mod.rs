//! Loads of the water on a hull: buoyancy, radiation with memory, and incident waves.
//!
//! The added mass at infinite frequency is not a load: it is part of the inertia of the hull's body, so ship and crane
//! share one mass matrix.

mod added_mass;
pub(crate) mod assembly;
mod by_heading;
mod carried;
mod coordinates;
mod drift_damping;
mod excitation;
pub(crate) mod fields;
mod gap;
mod interaction;
mod linear_limits;
mod mean_attitude;
mod mesh_in_waves;
mod place;
mod radiation;
mod slow_filter;
mod spacing;
mod wave_data;

pub use added_mass::{AddedMass, QuadraticTerms, added_inertia};
use by_heading::ByHeading;
pub use carried::Carried;
use carried::CarriedFilter;
pub use coordinates::WaveCoordinates;
use coordinates::{Seen, States};
pub use excitation::{HullVelocity, WaveExcitation, WaveForceSwitches};
pub use gap::{HullGap, Plan};
pub use interaction::{CoupledHull, HullInteraction};
pub use linear_limits::LinearLimits;
pub use mean_attitude::{LARGEST_LIST_DEG, MeanAttitude};
pub use mesh_in_waves::MeshInWaves;
pub use place::{CoefficientFrame, HullFrame, HullMotion, LowFrequencyFrame, SeaAxes};
pub use radiation::Radiation;
pub use slow_filter::SlowFilter;
pub use spacing::{HullSpacing, SpacedHull};

use super::{
    AnyElement, AnyWatcher, Context, Declaration, Element, ElementState, Output, RegularWaves, ShownWaves, Support,
    VectorFrame, of_kind,
};
use crate::dynamics::{Kinematics, Loads};
use crate::scalar::Scalar;
use crate::sea::database::Database;
use crate::sea::hull::{FloatingPosition, HullMesh, LinearHydrostatics, WettedHull};
use crate::spatial::{Twist, Vector3, Wrench};
use std::sync::Arc;
use wave_data::InRegularWaves;

/// How buoyancy is computed.
#[derive(Clone, Debug)]
pub enum Hydrostatics<S = f64> {
    /// To second order in the motions.
    Linear(LinearHydrostatics),
    /// Exact, for the mesh in its position in still water.
    Mesh(Box<FloatingMesh<S>>),
    /// None.
    None,
}

/// A mesh with the working memory for its wetted part.
#[derive(Clone, Debug)]
pub struct FloatingMesh<S = f64> {
    mesh: HullMesh,
    wetted: WettedHull<S>,
}

impl<S: Scalar> FloatingMesh<S> {
    /// Returns the mesh with its working memory.
    pub fn new(mesh: HullMesh) -> Self {
        Self { wetted: WettedHull::new(&mesh), mesh }
    }
}

impl<S: Scalar> Hydrostatics<S> {
    fn wrench(&mut self, position: &FloatingPosition<S>, specific_weight: S) -> Wrench<S> {
        match self {
            Self::Linear(linear) => linear.wrench(position, specific_weight),
            Self::Mesh(floating) => floating.wetted.buoyancy(&floating.mesh, position).wrench(specific_weight),
            Self::None => Wrench::zero(),
        }
    }

    fn potential_energy(&mut self, position: &FloatingPosition<S>, specific_weight: S) -> S {
        match self {
            Self::Linear(linear) => linear.potential_energy(position, specific_weight),
            Self::Mesh(floating) => {
                floating.wetted.buoyancy(&floating.mesh, position).potential_energy(specific_weight)
            }
            Self::None => S::ZERO,
        }
    }
}

/// A hull in the water.
#[derive(Clone, Debug)]
pub struct Hull<S = f64> {
    /// Name of the force in the scenario.
    pub name: String,
    /// The frame of the upright hull on its body: for buoyancy and drawing.
    pub frame: HullFrame<S>,
    /// The coordinates of its wave loads.
    pub coordinates: WaveCoordinates<S>,
    /// The added mass, if it acts.
    pub added_mass: Option<AddedMass<S>>,
    /// Buoyancy.
    pub hydrostatics: Hydrostatics<S>,
    /// The memory of the waves that it radiates.
    pub radiation: Option<Radiation>,
    /// The forces of the world's waves.
    pub excitation: Option<WaveExcitation<S>>,
    /// The database, if its excitation acts in waves.
    pub wave_data: Option<Arc<Database>>,
    /// The pressure of the waves on the mesh of the hydrostatics, if it acts.
    pub wave_pressure: Option<Box<MeshInWaves<S>>>,
    /// The rectangle around its waterline.
    pub plan: Plan,
    /// Bodies of the other hulls in its database.
    pub feels: Vec<usize>,
    /// Its watchers.
    pub watchers: Vec<AnyWatcher>,
    /// Quadratic terms of the added mass that act.
    pub quadratic_terms: QuadraticTerms,
}

impl<S: Scalar> Hull<S> {
    /// Returns the hulls among elements.
    pub fn among(elements: &[AnyElement<S>]) -> impl Iterator<Item = &Self> {
        of_kind(elements)
    }

    /// Whether any of its loads is linearized about the upright hull at the draught of its data.
    pub fn is_linear(&self) -> bool {
        let Self { hydrostatics, added_mass, radiation, excitation, .. } = self;
        let linear = matches!(hydrostatics, Hydrostatics::Linear(_));
        linear || added_mass.is_some() || radiation.is_some() || excitation.is_some()
    }
}

impl<S: Scalar> Element<S> for Hull<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let of_radiation = self.radiation.iter().flat_map(Radiation::declared);
        Declaration {
            states: SlowFilter::<S>::declared().chain(CarriedFilter::<S>::declared()).chain(of_radiation).collect(),
            outputs: outputs(&self.name),
            ..Declaration::default()
        }
    }

    /// Sets the states of a hull that has always moved through the water at its present horizontal velocity; for heave,
    /// roll, pitch and yaw the memory begins at zero.
    fn begin(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        let WaveCoordinates { coefficients, carried: bodies, cutoff_rad_s } = &self.coordinates;
        let in_world = coefficients.frame(at.model, at.links);
        let place = LowFrequencyFrame::of(&in_world);
        let States { place: of_place, carried, radiation: of_radiation } = States::of_mut(own.states);
        let rates = SeaAxes::of(coefficients, &in_world, &place, [S::ZERO; 2])
            .rates(&at.links.body_twist(at.model, self.frame.body));
        let [x, y, _] = (place.rotation() * rates.linear).0;
        SlowFilter::steady(&place, [x, y], *cutoff_rad_s).write(of_place);
        let [centre, _] = bodies.centre(at, self.frame.body, &place);
        CarriedFilter::at_rest(centre).write(carried);
        if let Some(radiation) = &self.radiation {
            let [x, y, ..] = self.through_water(at, &place, &rates);
            radiation.steady(&[x, y, S::ZERO, S::ZERO, S::ZERO, S::ZERO], of_radiation);
        }
    }

    /// Adds the loads of the water and their work.
    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        let (hull, specific_weight) = (self.frame.frame(at.model, at.links), at.world.specific_weight());
        let buoyancy = self.hydrostatics.wrench(&FloatingPosition::of(&hull), specific_weight);
        let Seen { slow, off, axes, twist } = self.coordinates.seen(at);
        let mut by_the_sea = [S::ZERO; 6];
        if let Some(radiation) = &self.radiation {
            by_the_sea = radiation.force(States::of(at.states).radiation);
        }
        let (waves, time_s) = (at.world.waves.as_ref().filter(|_| at.evaluation.has_waves()), at.clock.time_s);
        let velocity = self.velocity(at, &slow, &axes.rates(&twist));
        if let (Some(excitation), Some(waves)) = (&mut self.excitation, waves) {
            let first = excitation.force(waves, time_s, &slow);
            let drift = excitation.drift(waves, time_s, &slow, &velocity);
            by_the_sea = core::array::from_fn(|mode| by_the_sea[mode] + first[mode] + drift[mode]);
        }
        let mut by_the_sea =
            axes.wrench_to_body(&of_modes(by_the_sea)) + self.in_flowing_water(at, &axes, off[1], loads);
        if let (Some(mesh), Some(waves)) = (&mut self.wave_pressure, waves) {
            let pressure = mesh.pressure(waves, &hull, specific_weight, time_s, &buoyancy);
            by_the_sea += self.frame.about_centre(&pressure);
        }
        loads.power.outside += by_the_sea.dot(&twist);
        loads.wrenches.push((self.frame.body, self.frame.about_centre(&buoyancy) + by_the_sea));
    }

    fn rates(&mut self, at: &Context<'_, S>, rates: &mut [S]) {
        let WaveCoordinates { coefficients, carried, cutoff_rad_s } = &self.coordinates;
        let in_world = coefficients.frame(at.model, at.links);
        let (now, of) = (States::of(at.states), States::of_mut(rates));
        let filter = SlowFilter::read(now.place);
        filter.rates(&LowFrequencyFrame::of(&in_world), *cutoff_rad_s).write(of.place);
        let slow = filter.frame();
        let (centre, average) = (carried.centre(at, self.frame.body, &slow), CarriedFilter::read(now.carried));
        average.rates(centre[0], *cutoff_rad_s).write(of.carried);
        if let Some(radiation) = &self.radiation {
            let [off, _] = average.off(centre, *cutoff_rad_s);
            let axes = SeaAxes::of(coefficients, &in_world, &slow, off);
            let rates = axes.rates(&at.links.body_twist(at.model, self.frame.body));
            radiation.rates(&self.through_water(at, &slow, &rates), now.radiation, of.radiation);
        }
    }

    /// Returns the potential energy of buoyancy, J.
    fn potential_energy(&mut self, at: &Context<'_, S>) -> S {
        let position = FloatingPosition::of(&self.frame.frame(at.model, at.links));
        self.hydrostatics.potential_energy(&position, at.world.specific_weight())
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let Seen { slow, axes, twist, .. } = self.coordinates.seen(at);
        let (none, time_s, specific_weight) = ([S::ZERO; 6], at.clock.time_s, at.world.specific_weight());
        let velocity = self.velocity(at, &slow, &axes.rates(&twist));
        let (elevation, mut excitation_force, drift) = match (&mut self.excitation, &at.world.waves) {
            (Some(excitation), Some(waves)) => (
                excitation.elevation(waves, time_s, &slow),
                excitation.force(waves, time_s, &slow),
                excitation.drift(waves, time_s, &slow, &velocity),
            ),
            _ => (S::ZERO, none, none),
        };
        if let (Some(mesh), Some(waves)) = (&mut self.wave_pressure, &at.world.waves) {
            let hull = self.frame.frame(at.model, at.links);
            let still = self.hydrostatics.wrench(&FloatingPosition::of(&hull), specific_weight);
            let by_pressure = mesh.pressure(waves, &hull, specific_weight, time_s, &still);
            let along = axes.wrench_of_body(&self.frame.about_centre(&by_pressure));
            excitation_force.iter_mut().zip(modes(along.force, along.moment)).for_each(|(sum, force)| *sum += force);
        }
        out.push(elevation);
        out.extend(excitation_force);
        out.extend(drift);
        out.extend(self.radiation.as_ref().map_or(none, |radiation| radiation.force(States::of(at.states).radiation)));
        out.push(self.water_kinetic_energy(at));
    }

    fn supports(&self) -> Vec<Support> {
        vec![Support::Carries([Some(self.frame.body), None]), Support::Afloat(self.frame.body)]
    }

    fn watchers(&self) -> Vec<AnyWatcher> {
        self.watchers.clone()
    }

    fn regular_waves(&self) -> Option<Box<dyn RegularWaves<S> + '_>> {
        let database = self.wave_data.as_ref()?;
        Some(Box::new(InRegularWaves::new(self, database)))
    }

    fn shown_waves(&self, bodies: &Kinematics<S>) -> Vec<(usize, ShownWaves<S>)> {
        let Some(waves) = self.regular_waves() else { return Vec::new() };
        let elevation = ShownWaves::Elevation { place: waves.place(bodies).position, times: S::ONE };
        let forces = (0..MODES).map(|mode| (ELEVATIONS + mode, ShownWaves::Force(mode)));
        let drift = (0..MODES).map(|mode| (ELEVATIONS + MODES + mode, ShownWaves::NotLinear));
        [(0, elevation)].into_iter().chain(forces).chain(drift).collect()
    }
}

/// Number of values at the beginning of [`Hull::outputs`](Element::outputs), before forces of [`MODES`] values each.
const ELEVATIONS: usize = 1;
/// Surge, sway, heave, roll, pitch and yaw.
const MODES: usize = 6;

/// Returns the outputs of a hull, in the order of [`Hull::outputs`](Element::outputs).
fn outputs(name: &str) -> Vec<Output> {
    let wrench = |variable, description| Output::wrench(variable, description, "hull", name, VectorFrame::SlowFrame);
    vec![
        Output::number(
            "wave_elevation",
            "elevation of the incident waves, at the average position of the hull",
            "hull",
            name,
            &["m"],
        ),
        wrench("excitation_force", "force of the waves, with the moment about the hull's reference point"),
        wrench(
            "drift_force",
            "drift force of the waves, mean and slowly varying, with the moment about the hull's reference point",
        ),
        wrench(
            "radiation_force",
            "radiation force of the hull, without added mass, with the moment about its reference point",
        ),
        Output::number(
            "water_kinetic_energy",
            "kinetic energy of the added mass at infinite frequency",
            "hull",
            name,
            &["J"],
        ),
    ]
}

impl<S: Scalar> Hull<S> {
    fn water_kinetic_energy(&self, at: &Context<'_, S>) -> S {
        let twist = at.links.body_twist(at.model, self.frame.body);
        self.added_mass.as_ref().map_or(S::ZERO, |added| added.in_body.quadratic(&twist) * S::constant(0.5))
    }

    /// Returns the hull's velocity. It includes the wave-frequency part, whose mean over the slow changes of the drift
    /// is 0.
    fn velocity(&self, at: &Context<'_, S>, slow: &LowFrequencyFrame<S>, rates: &Twist<S>) -> HullVelocity<S> {
        let [x, y, ..] = self.through_water(at, slow, rates);
        let [u, v, _] = rates.linear.0;
        HullVelocity { through_water: [x, y], over_ground: [u, v] }
    }

    /// Returns the rates along the axes of the wave loads, relative to the water.
    fn through_water(&self, at: &Context<'_, S>, slow: &LowFrequencyFrame<S>, rates: &Twist<S>) -> [S; 6] {
        modes(rates.linear - slow.rotation().transpose_times(at.world.surface_current()), rates.angular)
    }
}

/// Surge, sway, heave, roll, pitch and yaw.
fn modes<S: Scalar>(linear: Vector3<S>, angular: Vector3<S>) -> [S; 6] {
    let ([x, y, z], [roll, pitch, yaw]) = (linear.0, angular.0);
    [x, y, z, roll, pitch, yaw]
}

/// Returns the load with these components.
fn of_modes<S: Scalar>([x, y, z, roll, pitch, yaw]: [S; 6]) -> Wrench<S> {
    Wrench { moment: Vector3([roll, pitch, yaw]), force: Vector3([x, y, z]) }
}
