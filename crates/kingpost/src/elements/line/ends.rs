//! Ends of a line: their places, the forces on their bodies; clamped ends have a direction of their body, and turn it.

use super::DynamicLine;
use super::bend::LineEnds;
use super::nodes::LineNode;
use crate::dynamics::Loads;
use crate::elements::Context;
use crate::elements::lines::{place, pull_at};
use crate::model::Attachment;
use crate::scalar::Scalar;
use crate::spatial::{Frame, Matrix3, SpatialInertia, Symmetric3, Vector3, Wrench};

impl<S: Scalar> DynamicLine<S> {
    /// Returns positions and directions of its ends.
    pub(super) fn ends_now(&self, at: &Context<'_, S>) -> LineEnds<S> {
        let places = [0, 1].map(|end| place(&self.ends[end], at.model, at.links));
        LineEnds { places, directions: self.directions(at) }
    }

    /// Returns the indices of the nodes at its ends.
    pub(super) fn end_nodes(&self) -> [usize; 2] {
        [0, self.nodes.len() - 1]
    }

    /// Returns the nodes at the ends on bodies or in the world: at both, or at the first one.
    pub(super) fn held_nodes(&self) -> impl Iterator<Item = usize> + use<S> {
        self.end_nodes().into_iter().take(2 - usize::from(self.mesh.free_end))
    }

    /// Adds force and inertia of the line at an end, with its node, to its body.
    pub(super) fn pull(&self, end: &Attachment<S>, node: &LineNode<S>, at: &Context<'_, S>, loads: &mut Loads<S>) {
        let Some(body) = end.body else { return };
        pull_at(end, node.force, at, loads);
        let tangent = at.links.to_body_axes(at.model, body, node.tangent);
        let across = Symmetric3::diagonal([node.mass.across; 3]);
        let linear = across.minus_outer(tangent, node.mass.across - node.mass.along);
        let inertia = SpatialInertia { angular: Symmetric3::default(), coupling: Matrix3::zero(), linear };
        loads.added_inertia.push((body, inertia.to_parent(&Frame::translation(end.in_body.position))));
    }

    /// Returns the fields of its ends.
    pub fn end_fields(&self) -> [&'static str; 2] {
        if self.supply.is_some() { ["path"; 2] } else { ["first", "second"] }
    }

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
