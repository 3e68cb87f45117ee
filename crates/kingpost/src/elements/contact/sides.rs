//! The two sides of a contact: their positions, their motion and the forces between them.

use super::Facing;
use super::solid::ContactSolid;
use super::spot::{Nearness, Spot};
use crate::dynamics::Loads;
use crate::elements::Context;
use crate::model::Attachment;
use crate::scalar::Scalar;
use crate::spatial::{Frame, Matrix3, Vector3, Wrench};

/// One side: all in world axes.
#[derive(Clone, Copy, Debug)]
struct ContactSide<S> {
    /// Frame of its shape.
    frame: Frame<S>,
    /// Frame of its body; the identity if it is fixed to the world.
    body: Frame<S>,
    /// Velocity of the origin of its body, m/s.
    velocity: Vector3<S>,
    /// rad/s.
    angular_velocity: Vector3<S>,
}

/// The two sides: the load and the surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sides<S> {
    sides: [ContactSide<S>; 2],
    /// The frame of each shape in the axes of the other.
    seen: [Frame<S>; 2],
}

/// A spot and the solid that it touches.
#[derive(Clone, Copy, Debug)]
pub(super) struct Met<S> {
    facing: Facing,
    /// Rotation of the solid.
    rotation: Matrix3<S>,
    /// Point at which the contact forces act, world, m.
    pub(super) point: Vector3<S>,
    /// Velocity of the spot relative to the solid at that point, in the solid's axes, m/s.
    velocity: Vector3<S>,
    /// Outward normal of the solid, in its axes.
    pub(super) normal: Vector3<S>,
    /// Growth of the depth per displacement against the normal.
    pub(super) gain: S,
    /// Depth of the spot in the solid, m.
    pub(super) depth: S,
    /// The middle of the spot, in the solid's axes, m.
    pub(super) middle: Vector3<S>,
}

/// Forces on the load, in world axes, and their moments on both sides about the origins of their bodies.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sum<S> {
    origins: [Vector3<S>; 2],
    force: Vector3<S>,
    moments: [Vector3<S>; 2],
}

impl<S: Scalar> Sides<S> {
    pub(super) fn new(sides: &[Attachment<S>; 2], at: &Context<'_, S>) -> Self {
        let sides = sides.each_ref().map(|side| {
            let still = (Frame::identity(), Vector3::zero(), Vector3::zero());
            let (body, velocity, angular_velocity) = side.body.map_or(still, |body| {
                let (frame, twist) = (at.links.body_frame(at.model, body), at.links.body_twist(at.model, body));
                (frame, frame.rotation * twist.linear, frame.rotation * twist.angular)
            });
            ContactSide { frame: body.times(&side.in_body), body, velocity, angular_velocity }
        });
        let seen = [0, 1].map(|k: usize| sides[1 - k].frame.inverse().times(&sides[k].frame));
        Self { sides, seen }
    }

    pub(super) fn met(&self, facing: Facing, spot: &Spot<S>, solid: &ContactSolid<S>) -> Met<S> {
        let [own, other] = [&self.sides[facing as usize], &self.sides[1 - facing as usize]];
        let Nearness { point, normal, gain, depth, middle } = spot.nearness(solid, &self.seen[facing as usize]);
        let point = other.frame.point(point);
        let velocity = other.frame.rotation.transpose_times(own.velocity_at(point) - other.velocity_at(point));
        Met { facing, rotation: other.frame.rotation, point, velocity, normal, gain, depth, middle }
    }

    pub(super) fn nothing(&self) -> Sum<S> {
        let origins = self.sides.each_ref().map(|side| side.body.position);
        Sum { origins, force: Vector3::zero(), moments: [Vector3::zero(); 2] }
    }

    /// Applies the force to both bodies.
    pub(super) fn hand_over(&self, sum: &Sum<S>, sides: &[Attachment<S>; 2], loads: &mut Loads<S>) {
        for (k, force) in [sum.force, -sum.force].into_iter().enumerate() {
            let Some(body) = sides[k].body else { continue };
            let rotation = &self.sides[k].body.rotation;
            let (moment, force) = (rotation.transpose_times(sum.moments[k]), rotation.transpose_times(force));
            loads.wrenches.push((body, Wrench { moment, force }));
        }
    }
}

impl<S: Scalar> ContactSide<S> {
    fn velocity_at(&self, point: Vector3<S>) -> Vector3<S> {
        self.velocity + self.angular_velocity.cross(point - self.body.position)
    }
}

impl<S: Scalar> Met<S> {
    /// Returns the rate of the depth, d', m/s.
    pub(super) fn rate(&self) -> S {
        -self.normal.dot(self.velocity) * self.gain
    }

    /// Returns the slip v along the surface, in the solid's axes, m/s.
    pub(super) fn slip(&self) -> Vector3<S> {
        self.along(self.velocity)
    }

    /// Returns the component of a vector along the surface.
    pub(super) fn along(&self, vector: Vector3<S>) -> Vector3<S> {
        vector - self.normal * self.normal.dot(vector)
    }

    /// Transforms a vector from the solid's axes to the world's.
    pub(super) fn in_world(&self, vector: Vector3<S>) -> Vector3<S> {
        self.rotation * vector
    }

    /// Returns the force on the load due to a force on the spot.
    pub(super) fn on_load(&self, force: Vector3<S>) -> Vector3<S> {
        if self.facing == Facing::Load { force } else { -force }
    }
}

impl<S: Scalar> Sum<S> {
    /// Adds a force on a spot, world axes.
    pub(super) fn push(&mut self, force: Vector3<S>, met: &Met<S>) {
        let force = met.on_load(force);
        self.force += force;
        for (k, on_side) in [force, -force].into_iter().enumerate() {
            self.moments[k] += (met.point - self.origins[k]).cross(on_side);
        }
    }
}
