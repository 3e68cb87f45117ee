//! One line of a tree of lines: the one on which all others hang, or a branch.

use super::bend::LineEnds;
use super::ground::LineGround;
use super::mesh::LineMesh;
use super::nodes::{LineNode, Nodes};
use crate::dynamics::Loads;
use crate::elements::lines::{place, pull_at, velocity};
use crate::elements::{Context, StateDeclaration};
use crate::model::Attachment;
use crate::scalar::Scalar;
use crate::spatial::{Frame, Matrix3, SpatialInertia, Symmetric3, Vector3, Wrench};

/// The shape of a line at rest.
#[derive(Clone, Debug)]
pub struct RestingLine<S> {
    /// Name of the line.
    pub name: String,
    /// Field of each end on a body or in the world, and its position, world, m.
    pub ends: Vec<(&'static str, Vector3<S>)>,
    /// Distance between the first and the last node, m.
    pub distance: S,
    /// Length without tension, m.
    pub unstretched_length: S,
    /// The ground on which it can lie.
    pub ground: Option<LineGround<S>>,
    /// Its largest strain; NaN if no shape was found.
    pub strain: S,
}

/// A node of a line of a tree to which the second end of another one is fastened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LineJoint {
    /// The line: 0 is the one on which all others hang.
    pub strand: usize,
    /// The node, from its first end.
    pub node: usize,
}

/// A line of a tree: the one on which all others hang, or one whose second end is fastened to a node of another line.
#[derive(Clone, Debug)]
pub struct Strand<S = f64> {
    /// Name in the results.
    pub name: String,
    /// Its ends on bodies or in the world: the second one, unless it is free or fastened to another line.
    pub ends: [Option<Attachment<S>>; 2],
    /// Directions from the first end to the second one at clamped ends, in the axes of their bodies.
    pub clamps: [Option<Vector3<S>>; 2],
    /// The ground on which it can lie.
    pub ground: Option<LineGround<S>>,
    /// Number of points along it at which the results have its tension: 0, or 2 and more.
    pub points_along: usize,
    /// Node to which its second end is fastened.
    pub joint: Option<LineJoint>,
    /// Its elements and nodes.
    pub mesh: LineMesh<S>,
    /// Working memory.
    pub nodes: Nodes<S>,
    /// Forces on its ends that return the impulses owed at the base of the step, world, N.
    pub returned: [Vector3<S>; 2],
    /// Forces of the line between its ends on the ends at the last evaluation in a step, with those, world, N: zero where it is
    /// not held.
    pub pulls: [Vector3<S>; 2],
}

impl<S: Scalar> Strand<S> {
    /// Creates a line between its ends: the second one is free without an attachment.
    pub fn new(name: &str, ends: [Option<Attachment<S>>; 2], mesh: LineMesh<S>) -> Self {
        Self {
            name: name.to_owned(),
            ends,
            clamps: [None; 2],
            ground: None,
            points_along: 0,
            joint: None,
            nodes: Nodes::new(&mesh),
            returned: [Vector3::zero(); 2],
            pulls: [Vector3::zero(); 2],
            mesh,
        }
    }

    /// Returns the index of its last node.
    pub fn last(&self) -> usize {
        self.nodes.len() - 1
    }

    /// Returns its ends on bodies or in the world, with their nodes.
    pub fn held(&self) -> impl Iterator<Item = (usize, &Attachment<S>)> {
        let nodes = [0, self.last()];
        nodes.into_iter().zip(&self.ends).filter_map(|(node, end)| Some((node, end.as_ref()?)))
    }

    /// Returns positions and directions of its ends; zero vectors where it is not held.
    pub fn ends_now(&self, at: &Context<'_, S>) -> LineEnds<S> {
        let place_of = |end: &Attachment<S>| place(end, at.model, at.links);
        let places = [0, 1].map(|end| self.ends[end].as_ref().map_or(Vector3::zero(), place_of));
        LineEnds { places, directions: self.directions(at) }
    }

    /// Returns the velocities of its ends, world, m/s; zero vectors where it is not held.
    pub fn end_velocities(&self, at: &Context<'_, S>) -> [Vector3<S>; 2] {
        [0, 1].map(|end| self.ends[end].as_ref().map_or(Vector3::zero(), |end| velocity(end, at)))
    }

    /// Puts the nodes at its ends, and those between them at positions and velocities in this order.
    pub fn put(&mut self, LineEnds { places, directions }: &LineEnds<S>, at: &Context<'_, S>, motions: &[S]) {
        self.nodes.directions = *directions;
        let last = self.last();
        for (end, node) in [0, last].into_iter().enumerate() {
            if let Some(held) = &self.ends[end] {
                self.nodes.put(node, places[end], velocity(held, at));
            }
        }
        let (positions, velocities) = motions.split_at(motions.len() / 2);
        for (k, (x, v)) in positions.chunks_exact(3).zip(velocities.chunks_exact(3)).enumerate() {
            self.nodes.put(k + 1, Vector3::from_slice(x), Vector3::from_slice(v));
        }
    }

    /// Returns the number of its states that are positions and velocities.
    pub fn motions(&self) -> usize {
        6 * self.mesh.with_states().len()
    }

    /// Returns the declarations of these states, whose names begin with a prefix.
    pub fn declared_motions(&self, prefix: &str) -> Vec<StateDeclaration> {
        let of = |what: &str, unit: &'static str| {
            let name = |k: usize, axis: &str| format!("{prefix}node_{}.{what}.{axis}", k + 1);
            let axes = |k: usize| ["x", "y", "z"].map(|axis| StateDeclaration::new(name(k, axis), unit));
            (0..self.mesh.with_states().len()).flat_map(axes).collect::<Vec<_>>()
        };
        [of("position", "m"), of("velocity", "m/s")].concat()
    }

    /// Writes these states: the nodes where they are, with velocities that vary linearly between these of its ends.
    pub fn begin(&mut self, [first, last]: [Vector3<S>; 2], motions: &mut [S]) {
        let (positions, velocities) = motions.split_at_mut(motions.len() / 2);
        let parts = self.last() as f64;
        for (k, (x, v)) in positions.chunks_exact_mut(3).zip(velocities.chunks_exact_mut(3)).enumerate() {
            let place = self.nodes.node(k + 1).position;
            let velocity = first + (last - first) * S::constant((k + 1) as f64 / parts);
            place.write_to(x);
            velocity.write_to(v);
            self.nodes.put(k + 1, place, velocity);
        }
    }

    /// Writes the rates of these states.
    pub fn rates(&self, motions: &mut [S]) {
        let half = motions.len() / 2;
        let (moves, accelerates) = motions.split_at_mut(half);
        for (k, (x, v)) in moves.chunks_exact_mut(3).zip(accelerates.chunks_exact_mut(3)).enumerate() {
            self.nodes.mesh_velocity(k + 1).write_to(x);
            self.nodes.mesh_acceleration(k + 1, &self.mesh).write_to(v);
        }
    }

    /// Returns its present shape as that at rest, with the fields of its ends in a scenario.
    pub fn resting(&mut self, fields: [&'static str; 2]) -> RestingLine<S> {
        self.nodes.stretch(&self.mesh, [Vector3::zero(); 2]);
        let ends = [0, self.last()].map(|node| self.nodes.node(node).position);
        let held = fields.into_iter().zip(ends).zip(&self.ends).filter(|(_, end)| end.is_some());
        RestingLine {
            name: self.name.clone(),
            ends: held.map(|(end, _)| end).collect(),
            distance: (ends[1] - ends[0]).norm(),
            unstretched_length: self.mesh.length,
            ground: self.ground,
            strain: self.nodes.largest_strain(&self.mesh),
        }
    }

    /// Adds force and inertia at its ends to their bodies.
    pub fn pull(&self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        self.held().for_each(|(node, end)| pull(end, self.nodes.node(node), at, loads));
    }

    /// Returns the directions of clamped ends, world; zero vectors for others.
    fn directions(&self, at: &Context<'_, S>) -> [Vector3<S>; 2] {
        [0, 1].map(|end| {
            let in_body = self.clamps[end].unwrap_or(Vector3::zero());
            self.body_at(end).map_or(in_body, |body| at.links.body_frame(at.model, body).rotation * in_body)
        })
    }

    /// Returns the body at an end.
    pub fn body_at(&self, end: usize) -> Option<usize> {
        self.ends[end].as_ref().and_then(|end| end.body)
    }

    /// Returns the angular velocities of the bodies of clamped ends, world, rad/s; zero vectors for others.
    pub fn turning(&self, at: &Context<'_, S>) -> [Vector3<S>; 2] {
        [0, 1].map(|end| match (self.clamps[end], self.body_at(end)) {
            (Some(_), Some(body)) => {
                at.links.body_frame(at.model, body).rotation * at.links.body_twist(at.model, body).angular
            }
            _ => Vector3::zero(),
        })
    }

    /// Adds the moments of clamped ends to their bodies.
    pub fn turn(&self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        for end in [0, 1] {
            let (Some(_), Some(body)) = (self.clamps[end], self.body_at(end)) else { continue };
            let moment = at.links.to_body_axes(at.model, body, self.nodes.moments[end]);
            loads.wrenches.push((body, Wrench { moment, force: Vector3::zero() }));
        }
    }
}

/// Adds force and inertia of a line at an end, with its node, to its body.
fn pull<S: Scalar>(end: &Attachment<S>, node: &LineNode<S>, at: &Context<'_, S>, loads: &mut Loads<S>) {
    let Some(body) = end.body else { return };
    pull_at(end, node.force, at, loads);
    let tangent = at.links.to_body_axes(at.model, body, node.tangent);
    let across = Symmetric3::diagonal([node.mass.across; 3]);
    let linear = across.minus_outer(tangent, node.mass.across - node.mass.along);
    let inertia = SpatialInertia { angular: Symmetric3::default(), coupling: Matrix3::zero(), linear };
    loads.added_inertia.push((body, inertia.to_parent(&Frame::translation(end.in_body.position))));
}

/// Returns the length of the shortest element of lines, m.
pub fn shortest<S: Scalar>(strands: &[Strand<S>]) -> S {
    let [root, branches @ ..] = strands else { return S::ZERO };
    branches.iter().fold(root.mesh.shortest(), |least, strand| {
        let length = strand.mesh.shortest();
        length.select_less(least, || length, || least)
    })
}
