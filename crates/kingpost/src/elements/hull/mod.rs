//! The water's loads on a hull: buoyancy, the memory of radiated waves, and the incident waves.
//!
//! The infinite-frequency added mass is no load: it stands in the inertia of the hull's body, so
//! that ship and crane share one mass matrix.

mod added_mass;
mod by_heading;
mod excitation;
mod linear_limits;
mod mesh_in_waves;
mod place;
mod radiation;
mod slow_filter;
mod wave_data;

pub use added_mass::QuadraticTerms;
use by_heading::ByHeading;
pub use excitation::{Excitation, Parts};
pub use linear_limits::LinearLimits;
pub use mesh_in_waves::MeshInWaves;
pub use place::{HullFrame, HullMotion, SeaAxes, SlowFrame};
pub use radiation::Radiation;
pub use slow_filter::SlowFilter;

use super::{AnyWatcher, Declaration, Element, Frame, Moment, Output, Own, RegularWaves};
use crate::dynamics::Loads;
use crate::scalar::Scalar;
use crate::sea::database::Database;
use crate::sea::hull::{FloatingPosition, HullMesh, LinearHydrostatics, WettedHull};
use crate::spatial::{Twist, Wrench};
use std::sync::Arc;
use wave_data::InRegularWaves;

/// How buoyancy is computed.
#[derive(Clone, Debug)]
pub enum Hydrostatics<S = f64> {
    /// To second order in the motions.
    Linear(LinearHydrostatics),
    /// Exactly, for the mesh as it stands in still water.
    Mesh(Box<FloatingMesh<S>>),
    /// None.
    None,
}

/// A mesh with the working memory to find what of it is wet.
#[derive(Clone, Debug)]
pub struct FloatingMesh<S = f64> {
    mesh: HullMesh,
    wetted: WettedHull<S>,
}

impl<S: Scalar> FloatingMesh<S> {
    /// For this mesh.
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
    /// Where it is.
    pub frame: HullFrame<S>,
    /// Buoyancy.
    pub hydrostatics: Hydrostatics<S>,
    /// The memory of the waves that it makes.
    pub radiation: Option<Radiation>,
    /// What the world's waves do to it.
    pub excitation: Option<Excitation<S>>,
    /// The database, where its excitation acts whenever there are waves.
    pub wave_data: Option<Arc<Database>>,
    /// Their own pressure on the mesh of the hydrostatics, if it acts.
    pub wave_pressure: Option<Box<MeshInWaves<S>>>,
    /// What watches it, where linear hydrodynamics bound it.
    pub limits: Option<LinearLimits>,
    /// Which quadratic terms of the added mass act.
    pub quadratic_terms: QuadraticTerms,
    /// Where the filter of the slow frame cuts off, rad/s.
    pub cutoff_rad_s: f64,
}

impl<S: Scalar> Element<S> for Hull<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let of_radiation = self.radiation.iter().flat_map(Radiation::declared);
        Declaration {
            states: SlowFilter::<S>::declared().chain(of_radiation).collect(),
            outputs: outputs(&self.name),
            ..Declaration::default()
        }
    }

    /// The hull has always been here, and has always moved through the water as it does in the plane; of heave, roll,
    /// pitch and yaw the water has no memory yet.
    fn begin(&mut self, at: &Moment<'_, S>, own: &mut Own<'_, S>) {
        let motion = self.frame.motion_of(at.model, at.links);
        let place = SlowFrame::of(&motion.frame);
        let (of_filter, of_radiation) = own.states.split_at_mut(SlowFilter::<S>::LEN);
        SlowFilter::at_rest(&place).write(of_filter);
        if let Some(radiation) = &self.radiation {
            let [x, y, ..] = self.velocity_through_water(at, &motion, &place);
            radiation.steady(&[x, y, S::ZERO, S::ZERO, S::ZERO, S::ZERO], of_radiation);
        }
    }

    /// Adds what the water does, and its work.
    fn loads(&mut self, at: &Moment<'_, S>, loads: &mut Loads<S>) {
        let motion = self.frame.motion(at);
        let specific_weight = at.world.specific_weight();
        let buoyancy = self.hydrostatics.wrench(&FloatingPosition::of(&motion.frame), specific_weight);
        let slow = slow_frame(at);
        let mut by_the_sea = [S::ZERO; 6];
        if let Some(radiation) = &self.radiation {
            by_the_sea = radiation.force(radiation_states(at));
        }
        let (waves, time_s) = (at.world.waves.as_ref().filter(|_| at.situation.has_waves()), at.clock.time_s);
        if let (Some(excitation), Some(waves)) = (&mut self.excitation, waves) {
            let (first, drift) = (excitation.force(waves, time_s, &slow), excitation.drift(waves, time_s, &slow));
            by_the_sea = core::array::from_fn(|mode| by_the_sea[mode] + first[mode] + drift[mode]);
        }
        let axes = SeaAxes::of(&motion.frame, &slow);
        let mut by_the_sea = self.about_centre(by_the_sea, &axes) + self.in_flowing_water(at, &axes, loads);
        if let (Some(mesh), Some(waves)) = (&mut self.wave_pressure, waves) {
            let pressure = mesh.pressure(waves, &motion.frame, specific_weight, time_s, &buoyancy);
            by_the_sea += self.frame.about_centre(&pressure);
        }
        loads.power.outside += by_the_sea.dot(&at.links.body_twist(at.model, self.frame.body));
        loads.wrenches.push((self.frame.body, self.frame.about_centre(&buoyancy) + by_the_sea));
    }

    fn rates(&mut self, at: &Moment<'_, S>, rates: &mut [S]) {
        let motion = self.frame.motion(at);
        let (of_filter, of_radiation) = rates.split_at_mut(SlowFilter::<S>::LEN);
        let filter = SlowFilter::read(at.states);
        filter.rates(&SlowFrame::of(&motion.frame), self.cutoff_rad_s).write(of_filter);
        if let Some(radiation) = &self.radiation {
            let velocity = self.velocity_through_water(at, &motion, &filter.frame());
            radiation.rates(&velocity, radiation_states(at), of_radiation);
        }
    }

    /// Energy of the water that it displaces, J.
    fn potential_energy(&mut self, at: &Moment<'_, S>) -> S {
        let position = FloatingPosition::of(&self.frame.frame(at.model, at.links));
        self.hydrostatics.potential_energy(&position, at.world.specific_weight())
    }

    fn outputs(&mut self, at: &Moment<'_, S>, out: &mut Vec<S>) {
        let slow = slow_frame(at);
        let (none, time_s, specific_weight) = ([S::ZERO; 6], at.clock.time_s, at.world.specific_weight());
        let (elevation, mut excitation_force, drift) = match (&mut self.excitation, &at.world.waves) {
            (Some(excitation), Some(waves)) => (
                excitation.elevation(waves, time_s, &slow),
                excitation.force(waves, time_s, &slow),
                excitation.drift(waves, time_s, &slow),
            ),
            _ => (S::ZERO, none, none),
        };
        if let (Some(mesh), Some(waves)) = (&mut self.wave_pressure, &at.world.waves) {
            let motion = self.frame.motion(at);
            let still = self.hydrostatics.wrench(&FloatingPosition::of(&motion.frame), specific_weight);
            let by_pressure = mesh.pressure(waves, &motion.frame, specific_weight, time_s, &still);
            let axes = SeaAxes::of(&motion.frame, &slow);
            let Wrench { moment, force } = axes.wrench_of_body(&by_pressure);
            let along = axes.modes(force, moment);
            excitation_force.iter_mut().zip(along).for_each(|(sum, force)| *sum += force);
        }
        out.push(elevation);
        out.extend(excitation_force);
        out.extend(drift);
        out.extend(self.radiation.as_ref().map_or(none, |radiation| radiation.force(radiation_states(at))));
        out.push(self.water_kinetic_energy(at));
    }

    fn ties(&self) -> Vec<[Option<usize>; 2]> {
        vec![[Some(self.frame.body), None]]
    }

    fn watchers(&self) -> Vec<AnyWatcher> {
        self.limits.iter().map(|limits| -> AnyWatcher { Box::new(limits.clone()) }).collect()
    }

    fn regular_waves(&self) -> Option<Box<dyn RegularWaves<S> + '_>> {
        let database = self.wave_data.as_ref()?;
        Some(Box::new(InRegularWaves::new(self, database)))
    }

    fn keeps_afloat(&self) -> Option<usize> {
        Some(self.frame.body)
    }
}

/// What a hull shows, in the order of [`Hull::outputs`](Element::outputs).
fn outputs(name: &str) -> Vec<Output> {
    let wrench = |variable, description| Output::wrench(variable, description, "hull", name, Frame::SlowFrame);
    vec![
        Output::number(
            "wave_elevation",
            "elevation of the incident waves, where the hull is on average",
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
            "radiation force, of the waves that the hull has made, added mass apart, with the moment about its reference point",
        ),
        Output::number(
            "water_kinetic_energy",
            "the water's part of the kinetic energy, by the infinite-frequency added mass",
            "hull",
            name,
            &["J"],
        ),
    ]
}

/// Where the hull is on average: its first states are the filter's.
fn slow_frame<S: Scalar>(at: &Moment<'_, S>) -> SlowFrame<S> {
    SlowFilter::read(at.states).frame()
}

/// The states of its radiation, behind those of the filter.
fn radiation_states<'a, S: Scalar>(at: &Moment<'a, S>) -> &'a [S] {
    at.states.get(SlowFilter::<S>::LEN..).unwrap_or_default()
}

impl<S: Scalar> Hull<S> {
    fn water_kinetic_energy(&self, at: &Moment<'_, S>) -> S {
        let twist = at.links.body_twist(at.model, self.frame.body);
        let own = at.model.added_inertias.iter().filter(|(body, _)| *body == self.frame.body);
        own.fold(S::ZERO, |sum, (_, added)| sum + added.quadratic(&twist) * S::constant(0.5))
    }

    /// Velocity and angular velocity of the reference point relative to the water, along the axes of the sea's loads.
    fn velocity_through_water(&self, at: &Moment<'_, S>, motion: &HullMotion<S>, slow: &SlowFrame<S>) -> [S; 6] {
        let HullMotion { frame, twist } = motion;
        let of_centre = twist.linear - twist.angular.cross(self.frame.origin);
        let linear = of_centre - frame.rotation.transpose_times(at.world.surface_current());
        self.along(&SeaAxes::of(frame, slow), &Twist { linear, ..*twist })
    }

    /// Velocity and angular velocity of the reference point along those axes, by the twist of the body about its centre of
    /// mass. The lever between the two is that of the hull on average.
    fn along(&self, axes: &SeaAxes<S>, of_body: &Twist<S>) -> [S; 6] {
        let Twist { angular, linear } = self.frame.in_body().twist_to_child(&axes.twist(of_body));
        axes.modes(linear, angular)
    }

    /// A force and moment along those axes as a wrench about the body's centre of mass, in its axes.
    fn about_centre(&self, force: [S; 6], axes: &SeaAxes<S>) -> Wrench<S> {
        axes.wrench_to_body(&self.frame.about_centre(&axes.of_modes(force)))
    }
}
