//! The water's loads on a hull: buoyancy, the memory of radiated waves, and the incident waves.
//!
//! The infinite-frequency added mass is no load: it stands in the inertia of the hull's body, so
//! that ship and crane share one mass matrix.

mod by_heading;
mod excitation;
mod mesh_in_waves;
mod place;
mod radiation;

pub(crate) use by_heading::ByHeading;
pub use excitation::{Excitation, Parts};
pub use mesh_in_waves::MeshInWaves;
pub use place::{HullFrame, HullMotion, SLOW_FRAME_LEN, SlowFrame};
pub use radiation::Radiation;

use crate::dynamics::{LinkKinematics, Loads, Moment};
use crate::model::Model;
use crate::scalar::Scalar;
use crate::sea::hull::{FloatingPosition, HullMesh, LinearHydrostatics, WettedHull};
use crate::spatial::{Vector3, Wrench};

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
/// point, in the axes of the slow frame.
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
    /// Their own pressure on the mesh, if it acts.
    pub wave_pressure: Option<Box<MeshInWaves<S>>>,
    /// Whether the incident waves are left out: for an equilibrium.
    pub calm: bool,
    /// Velocity of the water in the world, m/s.
    pub current: Vector3<S>,
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
        let mut wrench = self.hydrostatics.wrench(&FloatingPosition::of(&motion.frame), self.specific_weight);
        let slow = SlowFrame::read(&at.held[self.first_held..]);
        let mut by_the_sea = [S::ZERO; 6];
        if let Some(radiation) = &self.radiation {
            by_the_sea = radiation.force(self.own_states(at));
        }
        if let Some(excitation) = self.excitation.as_mut().filter(|_| !self.calm) {
            let (first, drift) = (excitation.force(at.clock.time_s, &slow), excitation.drift(at.clock.time_s, &slow));
            by_the_sea = core::array::from_fn(|mode| by_the_sea[mode] + first[mode] + drift[mode]);
        }
        let mut by_the_sea = in_body(&by_the_sea, &motion, &slow);
        if let Some(waves) = self.wave_pressure.as_mut().filter(|_| !self.calm) {
            by_the_sea += waves.pressure(&motion.frame, self.specific_weight, at.clock.time_s);
        }
        loads.power.outside += by_the_sea.dot(&motion.twist);
        wrench += by_the_sea;
        loads.wrenches.push((self.frame.body, self.frame.about_centre(&wrench)));
    }

    /// The waves and forces at a moment.
    pub fn reading(&mut self, at: &Moment<'_, S>) -> HullReading<S> {
        let slow = SlowFrame::read(&at.held[self.first_held..]);
        let states = self.own_states(at);
        let (none, time_s) = ([S::ZERO; 6], at.clock.time_s);
        let mut excitation_force = self.excitation.as_mut().map_or(none, |waves| waves.force(time_s, &slow));
        if let Some(waves) = self.wave_pressure.as_mut() {
            let motion = self.frame.motion(at);
            let by_pressure = in_slow(&waves.pressure(&motion.frame, self.specific_weight, time_s), &motion, &slow);
            excitation_force.iter_mut().zip(by_pressure).for_each(|(sum, force)| *sum += force);
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
        let slow = SlowFrame::read(&at.held[self.first_held..]);
        let to_slow = |v: Vector3<S>| slow.rotation().transpose_times(v);
        let linear = to_slow(motion.frame.rotation * motion.twist.linear - self.current).0;
        let angular = to_slow(motion.frame.rotation * motion.twist.angular).0;
        let [x, y, z] = linear;
        let [roll, pitch, yaw] = angular;
        radiation.rates(
            &[x, y, z, roll, pitch, yaw],
            self.own_states(at),
            &mut rates[self.first_state..][..self.state_count()],
        );
    }

    /// What it holds where a run begins.
    pub fn first_held(&self, model: &Model<S>, links: &LinkKinematics<S>, held: &mut [S]) {
        SlowFrame::of(&self.frame.frame(model, links)).write(&mut held[self.first_held..]);
    }

    /// After a step: what it holds over the next.
    pub fn hold(&self, model: &Model<S>, links: &LinkKinematics<S>, step_s: f64, held: &mut [S]) {
        let held = &mut held[self.first_held..];
        let now = SlowFrame::of(&self.frame.frame(model, links));
        SlowFrame::read(held).stepped(&now, self.cutoff_rad_s, step_s).write(held);
    }

    fn own_states<'a>(&self, at: &Moment<'a, S>) -> &'a [S] {
        &at.states[self.first_state..][..self.state_count()]
    }
}

/// A force and moment in the axes of the slow frame as a wrench in the hull's.
fn in_body<S: Scalar>(force: &[S; 6], motion: &HullMotion<S>, slow: &SlowFrame<S>) -> Wrench<S> {
    let [x, y, z, roll, pitch, yaw] = *force;
    let to_body = |v: [S; 3]| motion.frame.rotation.transpose_times(slow.rotation() * Vector3(v));
    Wrench { moment: to_body([roll, pitch, yaw]), force: to_body([x, y, z]) }
}

/// A wrench in the hull's axes as a force and moment in those of the slow frame.
fn in_slow<S: Scalar>(wrench: &Wrench<S>, motion: &HullMotion<S>, slow: &SlowFrame<S>) -> [S; 6] {
    let to_slow = |v: Vector3<S>| slow.rotation().transpose_times(motion.frame.rotation * v).0;
    let ([x, y, z], [roll, pitch, yaw]) = (to_slow(wrench.force), to_slow(wrench.moment));
    [x, y, z, roll, pitch, yaw]
}
