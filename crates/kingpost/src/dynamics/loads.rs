//! Loads of forces, drives and water on the dynamics.

use super::{LinkKinematics, TemporaryConstraint};
use crate::model::Model;
use crate::scalar::Scalar;
use crate::spatial::{CrossInertia, SpatialInertia, Twist, Vector3, Wrench};

/// Loads on a model: the paper's {F} (eq. 59), the motors, and added mass.
#[derive(Clone, Debug)]
pub struct Loads<S = f64> {
    /// External wrenches on bodies, in body axes about the centre of mass; a body can occur several times.
    pub wrenches: Vec<(usize, Wrench<S>)>,
    /// Force along each coordinate of v, N or N m, with its reaction on the parent.
    pub force: Vec<S>,
    /// Acceleration of each prescribed coordinate, m/s^2 or rad/s^2; ignored for others.
    pub acceleration: Vec<S>,
    /// Added inertia of a body, in body axes about its centre of mass. It is not part of the energy and
    /// momentum of the bodies: for these it is an external load, its [reaction](Self::hand_over).
    pub added_inertia: Vec<(usize, SpatialInertia<S>)>,
    /// Added inertia between two bodies that float freely, in body axes about their centres of mass: hulls that feel each
    /// other through the water. For energy and momentum it is an external load, as `added_inertia` is.
    pub added_inertia_between: Vec<([usize; 2], CrossInertia<S>)>,
    /// Acceleration of free fall, world axes, m/s^2: it acts on the mass of every body. The wrenches do not
    /// contain weight.
    pub gravity: Option<Vector3<S>>,
    /// Restraints of elements, each at the index of its element.
    pub restraints: Vec<TemporaryConstraint<S>>,
    /// Power by source.
    pub power: Power<S>,
}

/// Power by source, W. Conservative loads do not count: they have potential energy.
#[derive(Clone, Copy, Debug, Default)]
pub struct Power<S = f64> {
    /// Motors, servos and prescribed motions.
    pub drives: S,
    /// All external loads.
    pub outside: S,
    /// Power that becomes heat; never negative.
    pub dissipated: S,
}

impl<S: Scalar> Loads<S> {
    /// Creates the loads of a model, all zero.
    pub fn new(model: &Model<S>) -> Self {
        Self::with_room_for(model, 1)
    }

    /// Creates the loads, all zero, with memory for this number of wrenches on every body.
    pub fn with_room_for(model: &Model<S>, wrenches: usize) -> Self {
        Self {
            wrenches: Vec::with_capacity(wrenches * model.bodies.len()),
            force: vec![S::ZERO; model.velocity_count],
            acceleration: vec![S::ZERO; model.velocity_count],
            added_inertia: Vec::with_capacity(model.bodies.len()),
            added_inertia_between: Vec::new(),
            gravity: None,
            restraints: Vec::new(),
            power: Power::default(),
        }
    }

    /// Adds a wrench on a body, given about the origin of its link's root in root axes (in world axes if the
    /// body is fixed to the world); a wrench on the world itself is ignored.
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

    /// Returns the weight of a body, world axes, N; `None` without gravity.
    #[inline]
    pub fn weight(&self, mass: S) -> Option<Vector3<S>> {
        self.gravity.map(|gravity| gravity * mass)
    }

    /// Converts the added inertia I to a wrench, `-(I a + nu x* I nu)`, after the accelerations are known; between two
    /// bodies a is that of the other body, and `I nu` the momentum from its twist. `twist_and_rate` returns for a body the
    /// twist nu and the spatial acceleration a, in body axes about its centre of mass.
    pub fn hand_over(&mut self, twist_and_rate: impl Fn(usize) -> (Twist<S>, Twist<S>)) {
        let Self { added_inertia, added_inertia_between, power, wrenches, .. } = self;
        let mut react = |body: usize, twist: &Twist<S>, momentum: &Wrench<S>, rate: &Wrench<S>| {
            let reaction = -(*rate + twist.cross_momentum(momentum));
            power.outside += reaction.dot(twist);
            wrenches.push((body, reaction));
        };
        for (body, added) in added_inertia.drain(..) {
            let (twist, rate) = twist_and_rate(body);
            react(body, &twist, &added.times(&twist), &added.times(&rate));
        }
        for ([first, second], added) in added_inertia_between.drain(..) {
            let ((twist, rate), (other, rate_of_other)) = (twist_and_rate(first), twist_and_rate(second));
            react(first, &twist, &added.times(&other), &added.times(&rate_of_other));
            react(second, &other, &added.transpose_times(&twist), &added.transpose_times(&rate));
        }
    }

    /// Removes all loads.
    pub fn clear(&mut self) {
        self.clear_but_accelerations();
        self.acceleration.fill(S::ZERO);
    }

    /// Removes all loads except prescribed accelerations, for callers that overwrite all of these or have
    /// none.
    #[inline]
    pub fn clear_but_accelerations(&mut self) {
        self.wrenches.clear();
        self.force.fill(S::ZERO);
        self.added_inertia.clear();
        self.added_inertia_between.clear();
        self.gravity = None;
        self.restraints.iter_mut().for_each(|restraint| restraint.acts = false);
        self.power = Power::default();
    }

    /// Adds the loads of the active restraints; their multipliers are in the same order.
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
