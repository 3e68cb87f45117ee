//! A line with mass: a wire or a chain between two points, in waves and current and on the seabed.
//!
//! The line is divided into finite elements with three nodes each, on which the position is quadratic along the line
//! (`strain.rs`). The masses, and all loads per length, are lumped at the nodes by Simpson's rule, so that the mass
//! matrix has 3x3 blocks on its diagonal only. Natural frequencies have an error of fourth order in the length of an
//! element, as those of quadratic elements with consistent masses (Cook et al., *Concepts and Applications of Finite
//! Element Analysis*, 2002, sec. 11.3).

mod ground;
mod nodes;
mod section;
mod strain;

pub use ground::LineGround;
pub use section::LineSection;

use super::lines::{declaration_of_line, place, pull_at, shares, velocity};
use super::{Context, Declaration, Element, ElementState, StateDeclaration, Support};
use crate::dynamics::Loads;
use crate::model::Attachment;
use crate::scalar::Scalar;
use crate::spatial::{Frame, Matrix3, SpatialInertia, Symmetric3, Vector3};
use nodes::{LineNode, Nodes};

/// A line with inertia between two points on bodies or in the world.
///
/// Its states are positions and velocities of the nodes between its ends, in the world. The nodes at its ends move with
/// the bodies, which get the forces of the line there, and its mass there as an added inertia. Explicit schemes need steps
/// that resolve its axial waves; implicit ones do not.
#[derive(Clone, Debug)]
pub struct DynamicLine<S = f64> {
    /// Name in the results.
    pub name: String,
    /// Its ends.
    pub ends: [Attachment<S>; 2],
    /// L without tension, m.
    pub unstretched_length: S,
    /// Its properties per length.
    pub section: LineSection<S>,
    /// The ground on which it can lie, at the depth of the water.
    pub ground: Option<LineGround<S>>,
    /// Positions of the nodes between the ends at the start, world, m: an odd number, one less than twice the number of
    /// elements.
    pub start: Vec<Vector3<S>>,
    /// Working memory.
    nodes: Nodes<S>,
}

impl<S: Scalar> DynamicLine<S> {
    /// Creates a line whose nodes at the start are at `start`, between its ends; an even number of them loses the last.
    pub fn new(
        name: &str,
        ends: [Attachment<S>; 2],
        unstretched_length: S,
        section: LineSection<S>,
        mut start: Vec<Vector3<S>>,
    ) -> Self {
        start.truncate(start.len().saturating_sub(1) / 2 * 2 + 1);
        let nodes = Nodes::new(start.len() + 2, unstretched_length);
        Self { name: name.to_owned(), ends, unstretched_length, section, ground: None, start, nodes }
    }

    /// Lets the line lie on a ground.
    pub fn on(self, ground: LineGround<S>) -> Self {
        Self { ground: Some(ground), ..self }
    }

    /// Reads the motion of all nodes, and computes the forces on them and the accelerations between the ends.
    fn evaluate(&mut self, at: &Context<'_, S>) {
        for (end, node) in self.ends.iter().zip([0, self.nodes.len() - 1]) {
            self.nodes.put(node, place(end, at.model, at.links), velocity(end, at));
        }
        let (positions, velocities) = at.states.split_at(at.states.len() / 2);
        for (k, (x, v)) in positions.chunks_exact(3).zip(velocities.chunks_exact(3)).enumerate() {
            self.nodes.put(k + 1, Vector3::from_slice(x), Vector3::from_slice(v));
        }
        self.nodes.stretch(&self.section);
        self.nodes.load(&self.section, self.ground.as_ref(), at);
    }

    /// Adds force and inertia of the line at an end, with its node, to its body.
    fn pull(&self, end: &Attachment<S>, node: &LineNode<S>, at: &Context<'_, S>, loads: &mut Loads<S>) {
        let Some(body) = end.body else { return };
        pull_at(end, node.force, at, loads);
        let tangent = at.links.to_body_axes(at.model, body, node.tangent);
        let across = Symmetric3::diagonal([node.mass.across; 3]);
        let linear = across.minus_outer(tangent, node.mass.across - node.mass.along);
        let inertia = SpatialInertia { angular: Symmetric3::default(), coupling: Matrix3::zero(), linear };
        loads.added_inertia.push((body, inertia.to_parent(&Frame::translation(end.in_body.position))));
    }
}

impl<S: Scalar> Element<S> for DynamicLine<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let of = |what: &str, unit: &'static str| {
            let name = |k: usize, axis: &str| format!("node_{}.{what}.{axis}", k + 1);
            let axes = |k: usize| ["x", "y", "z"].map(|axis| StateDeclaration::new(name(k, axis), unit));
            (0..self.start.len()).flat_map(axes).collect::<Vec<_>>()
        };
        let states = [of("position", "m"), of("velocity", "m/s")].concat();
        Declaration { states, keeps_states: true, ..declaration_of_line(&self.name) }
    }

    fn begin(&mut self, _at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        own.states.fill(S::ZERO);
        for (position, state) in self.start.iter().zip(own.states.chunks_exact_mut(3)) {
            position.write_to(state);
        }
    }

    /// Adds the forces and inertias at both ends, and the power of damping and water.
    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        self.evaluate(at);
        loads.power.dissipated += self.nodes.dissipated;
        loads.power.outside += self.nodes.outside;
        for (end, node) in self.ends.iter().zip([0, self.nodes.len() - 1]) {
            self.pull(end, self.nodes.node(node), at, loads);
        }
    }

    fn rates(&mut self, at: &Context<'_, S>, rates: &mut [S]) {
        let half = rates.len() / 2;
        rates[..half].copy_from_slice(&at.states[half..]);
        for (k, rate) in rates[half..].chunks_exact_mut(3).enumerate() {
            self.nodes.node(k + 1).acceleration.write_to(rate);
        }
    }

    /// Returns the energy of strain, weight and ground, and the kinetic energy of the nodes between the ends, J.
    fn potential_energy(&mut self, at: &Context<'_, S>) -> S {
        self.evaluate(at);
        self.nodes.energy(&self.section, self.ground.as_ref(), at)
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        self.evaluate(at);
        let [first, last] = self.nodes.end_tensions();
        out.extend([first, last, self.nodes.grounded_length(at)]);
    }

    fn draw(&mut self, at: &Context<'_, S>, points: &mut Vec<S>) {
        self.evaluate(at);
        shares().for_each(|share: f64| points.extend(self.nodes.at(share).0));
    }

    fn supports(&self) -> Vec<Support> {
        let ends = [self.ends[0].body, self.ends[1].body];
        vec![Support::Carries(ends), Support::Station(ends)]
    }
}
