//! The loads of forces, drives and water on the dynamics.

use super::{LinkKinematics, UnilateralConstraint};
use crate::model::Model;
use crate::scalar::Scalar;
use crate::spatial::{SpatialInertia, Twist, Vector3, Wrench};

/// The paper's {F} (eq. 59), the motors, and added mass.
#[derive(Clone, Debug)]
pub struct Loads<S = f64> {
    /// Wrenches from outside on a body, in body axes about its centre of mass; a body may occur several times.
    pub wrenches: Vec<(usize, Wrench<S>)>,
    /// Force along each coordinate of v, N or N m, with its reaction on the parent.
    pub force: Vec<S>,
    /// Acceleration of each prescribed coordinate, m/s^2 or rad/s^2; ignored for others.
    pub acceleration: Vec<S>,
    /// Inertia added to a body, in body axes about its centre of mass. Energy and momentum of the
    /// bodies do not contain it: to them it is a load from outside, its [reaction](Self::hand_over).
    pub added_inertia: Vec<(usize, SpatialInertia<S>)>,
    /// Acceleration of free fall, world axes, m/s^2: it acts on every body's mass. The wrenches above do not contain
    /// weight.
    pub gravity: Option<Vector3<S>>,
    /// The restraints of elements, each at its own index.
    pub restraints: Vec<UnilateralConstraint<S>>,
    /// Power by source.
    pub power: Power<S>,
}

/// Power by source, W. Conservative loads are not included: they have potential energy.
#[derive(Clone, Copy, Debug, Default)]
pub struct Power<S = f64> {
    /// Motors, servos and prescribed motions.
    pub drives: S,
    /// Everything outside the model.
    pub outside: S,
    /// Turned into heat; never negative.
    pub dissipated: S,
}

impl<S: Scalar> Loads<S> {
    /// No loads on a model.
    pub fn new(model: &Model<S>) -> Self {
        Self::with_room_for(model, 1)
    }

    /// No loads, with memory for this number of wrenches on every body.
    pub fn with_room_for(model: &Model<S>, wrenches: usize) -> Self {
        Self {
            wrenches: Vec::with_capacity(wrenches * model.bodies.len()),
            force: vec![S::ZERO; model.velocity_count],
            acceleration: vec![S::ZERO; model.velocity_count],
            added_inertia: Vec::with_capacity(model.bodies.len()),
            gravity: None,
            restraints: Vec::new(),
            power: Power::default(),
        }
    }

    /// Adds a wrench on a body, given about the origin of its link's root in root axes (in world axes, if the body is
    /// fixed to the world); on the world itself nothing is added.
    pub fn add_on_link(
        &mut self,
        model: &Model<S>,
        links: &LinkKinematics<S>,
        body: Option<usize>,
        in_root: &Wrench<S>,
    ) {
        let Some(body) = body else { return };
        let (link, in_link) = (model.bodies[body].link, &model.bodies[body].in_link);
        let frame = link.map_or(*in_link, |link| links.in_root(link).times(in_link));
        self.wrenches.push((body, frame.wrench_to_child(in_root)));
    }

    /// Adds a uniform gravity field with this acceleration, world axes, m/s^2.
    pub fn add_gravity(&mut self, acceleration: Vector3<S>) {
        self.gravity = Some(self.gravity.unwrap_or(Vector3::zero()) + acceleration);
    }

    /// The weight of a body, world axes, N; `None` without gravity.
    #[inline]
    pub fn weight(&self, mass: S) -> Option<Vector3<S>> {
        self.gravity.map(|gravity| gravity * mass)
    }

    /// Once accelerations are known: turns the added inertia I into a wrench, `-(I a + nu x* I nu)`. `twist_and_rate`
    /// of a body are nu and the spatial acceleration a, in body axes about its centre of mass.
    pub fn hand_over(&mut self, twist_and_rate: impl Fn(usize) -> (Twist<S>, Twist<S>)) {
        for (body, added) in self.added_inertia.drain(..) {
            let (twist, rate) = twist_and_rate(body);
            let reaction = -(added.times(&rate) + twist.cross_momentum(&added.times(&twist)));
            self.power.outside += reaction.dot(&twist);
            self.wrenches.push((body, reaction));
        }
    }

    /// Removes all loads.
    pub fn clear(&mut self) {
        self.clear_but_accelerations();
        self.acceleration.fill(S::ZERO);
    }

    /// Removes all loads but prescribed accelerations, for callers that write every one of these, or have none.
    #[inline]
    pub fn clear_but_accelerations(&mut self) {
        self.wrenches.clear();
        self.force.fill(S::ZERO);
        self.added_inertia.clear();
        self.gravity = None;
        self.restraints.iter_mut().for_each(|restraint| restraint.acts = false);
        self.power = Power::default();
    }

    /// Adds the loads of the active restraints, with their multipliers in the same order.
    pub fn carry(&mut self, multipliers: &[S]) {
        let Self { restraints, wrenches, force, .. } = self;
        for (restraint, multiplier) in restraints.iter().filter(|restraint| restraint.acts).zip(multipliers) {
            wrenches.extend(restraint.wrenches.iter().map(|(body, wrench)| (*body, *wrench * *multiplier)));
            for (coordinate, load) in &restraint.along {
                force[*coordinate] += *load * *multiplier;
            }
        }
    }
}
