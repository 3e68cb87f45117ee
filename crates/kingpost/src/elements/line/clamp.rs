//! Clamped ends of a line: they have a direction of their body, and turn it.

use super::DynamicLine;
use crate::dynamics::Loads;
use crate::elements::Context;
use crate::scalar::Scalar;
use crate::spatial::{Vector3, Wrench};

impl<S: Scalar> DynamicLine<S> {
    /// Clamps ends in these directions from the first end to the second one, in the axes of their bodies or of the world: unit
    /// vectors. Only bending stiffness makes a difference.
    pub fn clamped(self, clamps: [Option<Vector3<S>>; 2]) -> Self {
        let mesh = self.mesh.clone().clamped(clamps.map(|clamp| clamp.is_some()));
        Self { clamps, ..self.on_mesh(mesh) }
    }

    /// Returns the directions of clamped ends, world; zero vectors for others.
    pub(super) fn directions(&self, at: &Context<'_, S>) -> [Vector3<S>; 2] {
        [0, 1].map(|end| {
            let in_body = self.clamps[end].unwrap_or(Vector3::zero());
            self.ends[end].body.map_or(in_body, |body| at.links.body_frame(at.model, body).rotation * in_body)
        })
    }

    /// Returns the angular velocities of the bodies of clamped ends, world, rad/s; zero vectors for others.
    pub(super) fn turning(&self, at: &Context<'_, S>) -> [Vector3<S>; 2] {
        [0, 1].map(|end| match (self.clamps[end], self.ends[end].body) {
            (Some(_), Some(body)) => {
                at.links.body_frame(at.model, body).rotation * at.links.body_twist(at.model, body).angular
            }
            _ => Vector3::zero(),
        })
    }

    /// Adds the moments of clamped ends to their bodies.
    pub(super) fn turn(&self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        for end in [0, 1] {
            let (Some(_), Some(body)) = (self.clamps[end], self.ends[end].body) else { continue };
            let moment = at.links.to_body_axes(at.model, body, self.nodes.moments[end]);
            loads.wrenches.push((body, Wrench { moment, force: Vector3::zero() }));
        }
    }
}
