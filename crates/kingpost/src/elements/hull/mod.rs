//! The water's loads on a hull: buoyancy, the memory of radiated waves, and the incident waves.
//!
//! The infinite-frequency added mass is no load: it stands in the inertia of the hull's body, so
//! that ship and crane share one mass matrix.

mod added_mass;
mod by_heading;
mod excitation;
mod mesh_in_waves;
mod place;
mod radiation;
mod slow_filter;

pub use added_mass::QuadraticTerms;
pub(crate) use by_heading::ByHeading;
pub use excitation::{Excitation, Parts};
pub use mesh_in_waves::MeshInWaves;
pub use place::{HullFrame, HullMotion, SeaAxes, SlowFrame};
pub use radiation::Radiation;
pub use slow_filter::SlowFilter;

use crate::dynamics::{LinkKinematics, Loads, Moment};
use crate::model::Model;
use crate::scalar::Scalar;
use crate::sea::hull::{FloatingPosition, HullMesh, LinearHydrostatics, WettedHull};
use crate::spatial::{Twist, Vector3, Wrench};

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

/// The sea at a hull at one moment. Forces (N) and moments (N m) are about the hull's reference
/// point, along what [`SeaAxes`] says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HullReading<S = f64> {
    /// Of the incident waves at the slow frame's place, m.
    pub wave_elevation: S,
    /// By the incident waves, to first order; and by their pressure on the mesh, where that acts.
    pub excitation_force: [S; 6],
    /// By the incident waves, the mean and slowly varying part of second order.
    pub drift_force: [S; 6],
    /// By the memory of the waves that the hull made; that of the added mass is not in it.
    pub radiation_force: [S; 6],
    /// Kinetic energy of the infinite-frequency added mass, J.
    pub water_kinetic_energy: S,
}

/// A hull in the water.
#[derive(Clone, Debug)]
pub struct Hull<S = f64> {
    /// Name of the force in the scenario.
    pub name: String,
    /// Where it is.
    pub frame: HullFrame<S>,
    /// rho g of the water, N/m^3.
    pub specific_weight: S,
    /// Buoyancy.
    pub hydrostatics: Hydrostatics<S>,
    /// The memory of the waves that it makes.
    pub radiation: Option<Radiation>,
    /// The incident waves.
    pub excitation: Option<Excitation<S>>,
    /// Their own pressure on the mesh of the hydrostatics, if it acts.
    pub wave_pressure: Option<Box<MeshInWaves<S>>>,
    /// Whether the incident waves are left out: for an equilibrium.
    pub calm: bool,
    /// Velocity of the water in the world, m/s.
    pub current: Vector3<S>,
    /// Which quadratic terms of the added mass act.
    pub quadratic_terms: QuadraticTerms,
    /// Where the filter of the slow frame cuts off, rad/s.
    pub cutoff_rad_s: f64,
    /// First of its numbers among what forces hold.
    pub first_held: usize,
    /// First of its states among those of forces.
    pub first_state: usize,
}

impl<S: Scalar> Hull<S> {
    /// Adds what the water does, and its work.
    pub fn apply(&mut self, at: &Moment<'_, S>, loads: &mut Loads<S>) {
        let motion = self.frame.motion(at);
        let buoyancy = self.hydrostatics.wrench(&FloatingPosition::of(&motion.frame), self.specific_weight);
        let slow = self.slow_frame(at);
        let mut by_the_sea = [S::ZERO; 6];
        if let Some(radiation) = &self.radiation {
            by_the_sea = radiation.force(self.own_states(at));
        }
        if let Some(excitation) = self.excitation.as_mut().filter(|_| !self.calm) {
            let (first, drift) = (excitation.force(at.clock.time_s, &slow), excitation.drift(at.clock.time_s, &slow));
            by_the_sea = core::array::from_fn(|mode| by_the_sea[mode] + first[mode] + drift[mode]);
        }
        let axes = SeaAxes::of(&motion.frame, &slow);
        let mut by_the_sea = self.about_centre(by_the_sea, &axes) + self.in_flowing_water(at, &axes, loads);
        if let Some(waves) = self.wave_pressure.as_mut().filter(|_| !self.calm) {
            let pressure = waves.pressure(&motion.frame, self.specific_weight, at.clock.time_s, &buoyancy);
            by_the_sea += self.frame.about_centre(&pressure);
        }
        loads.power.outside += by_the_sea.dot(&at.links.body_twist(at.model, self.frame.body));
        loads.wrenches.push((self.frame.body, self.frame.about_centre(&buoyancy) + by_the_sea));
    }

    /// The waves and forces at a moment.
    pub fn reading(&mut self, at: &Moment<'_, S>) -> HullReading<S> {
        let slow = self.slow_frame(at);
        let states = self.own_states(at);
        let (none, time_s) = ([S::ZERO; 6], at.clock.time_s);
        let mut excitation_force = self.excitation.as_mut().map_or(none, |waves| waves.force(time_s, &slow));
        if let Some(waves) = self.wave_pressure.as_mut() {
            let motion = self.frame.motion(at);
            let still = self.hydrostatics.wrench(&FloatingPosition::of(&motion.frame), self.specific_weight);
            let by_pressure = waves.pressure(&motion.frame, self.specific_weight, time_s, &still);
            let axes = SeaAxes::of(&motion.frame, &slow);
            let Wrench { moment, force } = axes.wrench_of_body(&by_pressure);
            let along = axes.modes(force, moment);
            excitation_force.iter_mut().zip(along).for_each(|(sum, force)| *sum += force);
        }
        HullReading {
            radiation_force: self.radiation.as_ref().map_or(none, |radiation| radiation.force(states)),
            excitation_force,
            drift_force: self.excitation.as_mut().map_or(none, |waves| waves.drift(time_s, &slow)),
            water_kinetic_energy: self.water_kinetic_energy(at),
            wave_elevation: self.excitation.as_mut().map_or(S::ZERO, |waves| waves.elevation(time_s, &slow)),
        }
    }

    fn water_kinetic_energy(&self, at: &Moment<'_, S>) -> S {
        let twist = at.links.body_twist(at.model, self.frame.body);
        let own = at.model.added_inertias.iter().filter(|(body, _)| *body == self.frame.body);
        own.fold(S::ZERO, |sum, (_, added)| sum + added.quadratic(&twist) * S::constant(0.5))
    }

    /// Energy of the water that it displaces, J.
    pub fn potential_energy(&mut self, model: &Model<S>, links: &LinkKinematics<S>) -> S {
        let position = FloatingPosition::of(&self.frame.frame(model, links));
        self.hydrostatics.potential_energy(&position, self.specific_weight)
    }

    /// Number of its extra states.
    pub fn state_count(&self) -> usize {
        self.radiation.as_ref().map_or(0, Radiation::state_count)
    }

    /// Writes the rates of its extra states.
    pub fn state_rates(&self, at: &Moment<'_, S>, rates: &mut [S]) {
        let Some(radiation) = &self.radiation else { return };
        let motion = self.frame.motion(at);
        let slow = self.slow_frame(at);
        let velocity = self.velocity_through_water(&motion, &slow);
        radiation.rates(&velocity, self.own_states(at), &mut rates[self.first_state..][..self.state_count()]);
    }

    /// Writes the extra states of a hull that has always moved through the water as it does in the plane; of heave, roll,
    /// pitch and yaw the water has no memory yet.
    pub fn first_states(&self, model: &Model<S>, links: &LinkKinematics<S>, states: &mut [S]) {
        let Some(radiation) = &self.radiation else { return };
        let motion = self.frame.motion_of(model, links);
        let [x, y, ..] = self.velocity_through_water(&motion, &SlowFrame::of(&motion.frame));
        let none = S::ZERO;
        radiation.steady(&[x, y, none, none, none, none], &mut states[self.first_state..][..self.state_count()]);
    }

    /// Velocity and angular velocity of the reference point relative to the water, along the axes of the sea's loads.
    fn velocity_through_water(&self, motion: &HullMotion<S>, slow: &SlowFrame<S>) -> [S; 6] {
        let HullMotion { frame, twist } = motion;
        let of_centre = twist.linear - twist.angular.cross(self.frame.origin);
        let linear = of_centre - frame.rotation.transpose_times(self.current);
        self.along(&SeaAxes::of(frame, slow), &Twist { linear, ..*twist })
    }

    /// Velocity and angular velocity of the reference point along those axes, by the twist of the body about its centre of
    /// mass. The lever between the two is that of the hull on average.
    pub(crate) fn along(&self, axes: &SeaAxes<S>, of_body: &Twist<S>) -> [S; 6] {
        let Twist { angular, linear } = self.frame.in_body().twist_to_child(&axes.twist(of_body));
        axes.modes(linear, angular)
    }

    /// A force and moment along those axes as a wrench about the body's centre of mass, in its axes.
    fn about_centre(&self, force: [S; 6], axes: &SeaAxes<S>) -> Wrench<S> {
        axes.wrench_to_body(&self.frame.about_centre(&axes.of_modes(force)))
    }

    /// What it holds where a run begins.
    pub fn first_held(&self, model: &Model<S>, links: &LinkKinematics<S>, held: &mut [S]) {
        let place = SlowFrame::of(&self.frame.frame(model, links));
        SlowFilter::at_rest(&place).write(self.own_held(held));
    }

    /// After a step: what it holds over the next.
    pub fn hold(&self, model: &Model<S>, links: &LinkKinematics<S>, step_s: f64, held: &mut [S]) {
        let held = self.own_held(held);
        let now = SlowFrame::of(&self.frame.frame(model, links));
        SlowFilter::read(held).stepped(&now, self.cutoff_rad_s, step_s).write(held);
    }

    fn own_held<'a>(&self, held: &'a mut [S]) -> &'a mut [S] {
        &mut held[self.first_held..][..SlowFilter::<S>::LEN]
    }

    fn slow_frame(&self, at: &Moment<'_, S>) -> SlowFrame<S> {
        SlowFilter::read(&at.held[self.first_held..]).frame()
    }

    fn own_states<'a>(&self, at: &Moment<'a, S>) -> &'a [S] {
        &at.states[self.first_state..][..self.state_count()]
    }
}
