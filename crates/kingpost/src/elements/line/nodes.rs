//! The nodes of a line: their motion, the forces on them, and their energy.

use super::ground::LineGround;
use super::section::{LineSection, PartMass, WaterForce};
use super::strain::{GAUSS, shapes, slopes, strained, sum};
use crate::elements::Context;
use crate::elements::lines::length_and_direction;
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// A node.
#[derive(Clone, Copy, Debug)]
pub struct LineNode<S> {
    /// Position, world, m.
    pub position: Vector3<S>,
    /// Velocity, world, m/s.
    pub velocity: Vector3<S>,
    /// Unit tangent.
    pub tangent: Vector3<S>,
    /// Mass with the added mass of the water.
    pub mass: PartMass<S>,
    /// Force of the line, its weight, the water and the ground, world, N.
    pub force: Vector3<S>,
    /// Acceleration, if it is between the ends, m/s^2.
    pub acceleration: Vector3<S>,
}

/// The nodes of a line, from its first end: every second one is in the middle of an element.
#[derive(Clone, Debug)]
pub struct Nodes<S> {
    nodes: Vec<LineNode<S>>,
    /// Length of an element, m.
    element: S,
    /// Tensions at the points of Gauss's rule, N.
    tensions: Vec<S>,
    /// Power that becomes heat, W.
    pub dissipated: S,
    /// Power of the water on the line, W; without the heat.
    pub outside: S,
    /// Energy of strain, J.
    strain: S,
}

impl<S: Scalar> Nodes<S> {
    /// Allocates the memory for a line of this unstretched length.
    pub fn new(count: usize, length: S) -> Self {
        let zero = Vector3::zero();
        let mass = PartMass { across: S::ZERO, along: S::ZERO };
        let node = LineNode { position: zero, velocity: zero, tangent: zero, mass, force: zero, acceleration: zero };
        let elements = count / 2;
        Self {
            nodes: vec![node; count],
            element: length / S::constant(elements as f64),
            tensions: Vec::with_capacity(2 * elements),
            dissipated: S::ZERO,
            outside: S::ZERO,
            strain: S::ZERO,
        }
    }

    /// Returns the number of nodes.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Returns a node.
    pub fn node(&self, node: usize) -> &LineNode<S> {
        &self.nodes[node]
    }

    /// Sets the motion of a node.
    pub fn put(&mut self, node: usize, position: Vector3<S>, velocity: Vector3<S>) {
        let put = &mut self.nodes[node];
        (put.position, put.velocity, put.force) = (position, velocity, Vector3::zero());
    }

    /// Returns the length of the line that belongs to a node by Simpson's rule, m.
    fn length_at(&self, node: usize) -> S {
        let sixths = match node {
            _ if node % 2 == 1 => 4.0,
            0 => 1.0,
            _ if node + 1 == self.nodes.len() => 1.0,
            _ => 2.0,
        };
        self.element * S::constant(sixths / 6.0)
    }

    fn of_element<T>(&self, element: usize, part: impl Fn(&LineNode<S>) -> T) -> [T; 3] {
        [0, 1, 2].map(|k| part(&self.nodes[2 * element + k]))
    }

    /// Adds the forces of the tension, `-T t N_i' h / 2` at each point of Gauss's rule.
    pub fn stretch(&mut self, section: &LineSection<S>) {
        self.tensions.clear();
        (self.dissipated, self.strain) = (S::ZERO, S::ZERO);
        let half = self.element * S::constant(0.5);
        for element in 0..self.nodes.len() / 2 {
            let positions = self.of_element(element, |node| node.position);
            let velocities = self.of_element(element, |node| node.velocity);
            for xi in [-GAUSS, GAUSS] {
                let slopes = slopes(xi, self.element);
                let found = strained(section, &slopes, &positions, &velocities);
                let ([elastic, whole], [ratio, rate]) = (found.tension, found.ratio);
                for (node, slope) in self.nodes[2 * element..].iter_mut().zip(slopes) {
                    node.force -= found.tangent * (whole * slope * half);
                }
                self.dissipated += (whole - elastic) * rate * half;
                self.strain += elastic * (ratio - S::ONE) * half * S::constant(0.5);
                self.tensions.push(whole);
            }
        }
        self.set_tangents();
    }

    /// Sets the tangents: between the neighbours of a node, at the ends by the shape of the element.
    fn set_tangents(&mut self) {
        let last = self.nodes.len() - 1;
        let slope_at = |nodes: &[LineNode<S>], first: usize, xi: f64| {
            sum(&slopes(xi, self.element), &[0, 1, 2].map(|k| nodes[first + k].position))
        };
        for node in 0..=last {
            let way = match node {
                0 => slope_at(&self.nodes, 0, -1.0),
                _ if node == last => slope_at(&self.nodes, last - 2, 1.0),
                _ => self.nodes[node + 1].position - self.nodes[node - 1].position,
            };
            self.nodes[node].tangent = length_and_direction(way).1;
        }
    }

    /// Adds weight, and the forces of water and ground; computes the accelerations between the ends.
    pub fn load(&mut self, section: &LineSection<S>, ground: Option<&LineGround<S>>, at: &Context<'_, S>) {
        self.outside = S::ZERO;
        let last = self.nodes.len() - 1;
        for i in 0..=last {
            let length = self.length_at(i);
            let LineNode { position, velocity, tangent, .. } = self.nodes[i];
            let WaterForce { force: water, added, dissipated } =
                section.in_water(at, length, (position, tangent, velocity));
            let dry = section.mass_per_length * length;
            let mass = PartMass { across: dry + added.across, along: dry + added.along };
            let (support, heat, _) = self.on_ground(i, ground, at);
            let node = &mut self.nodes[i];
            node.mass = mass;
            node.force += water + support;
            node.force[2] -= dry * at.world.gravity;
            self.dissipated += dissipated + heat;
            self.outside += water.dot(velocity) + dissipated;
            if i == 0 || i == last {
                continue;
            }
            let along = tangent * tangent.dot(node.force);
            node.acceleration = (node.force - along) * (S::ONE / mass.across) + along * (S::ONE / mass.along);
            // The water's part of the inertia is outside of the line.
            let of_water = node.acceleration * added.across
                + tangent * ((added.along - added.across) * tangent.dot(node.acceleration));
            self.outside -= of_water.dot(velocity);
        }
    }

    /// Returns force, heat and energy of the ground at a node.
    fn on_ground(&self, node: usize, ground: Option<&LineGround<S>>, at: &Context<'_, S>) -> (Vector3<S>, S, S) {
        let (Some(ground), Some(depth)) = (ground, at.world.depth) else {
            return (Vector3::zero(), S::ZERO, S::ZERO);
        };
        let LineNode { position, velocity, .. } = self.nodes[node];
        ground.support(self.length_at(node), -depth - position[2], velocity)
    }

    /// Returns the energy of strain, weight and ground, and the kinetic energy between the ends, J.
    pub fn energy(&self, section: &LineSection<S>, ground: Option<&LineGround<S>>, at: &Context<'_, S>) -> S {
        let last = self.nodes.len() - 1;
        (0..=last).fold(self.strain, |sum, i| {
            let (node, mass) = (&self.nodes[i], section.mass_per_length * self.length_at(i));
            let moves = if i == 0 || i == last { S::ZERO } else { node.velocity.norm_squared() * S::constant(0.5) };
            sum + mass * (at.world.gravity * node.position[2] + moves) + self.on_ground(i, ground, at).2
        })
    }

    /// Returns the tensions at the ends, N, linear through the points of Gauss's rule of the last elements; at least 0.
    pub fn end_tensions(&self) -> [S; 2] {
        let count = self.tensions.len();
        let beyond = |near: S, far: S| {
            let value = near + (near - far) * S::constant(0.5 * (1.0 / GAUSS - 1.0));
            value.select_below(0.0, || S::ZERO, || value)
        };
        [beyond(self.tensions[0], self.tensions[1]), beyond(self.tensions[count - 1], self.tensions[count - 2])]
    }

    /// Returns the unstretched length of the line that lies on the ground, m.
    pub fn grounded_length(&self, at: &Context<'_, S>) -> S {
        let Some(depth) = at.world.depth else { return S::ZERO };
        (0..self.nodes.len()).fold(S::ZERO, |sum, i| {
            let above = self.nodes[i].position[2] + depth;
            sum + above.select_below(0.0, || self.length_at(i), || S::ZERO)
        })
    }

    /// Returns the position at this share of the length, world, m.
    pub fn at(&self, share: f64) -> Vector3<S> {
        let elements = self.nodes.len() / 2;
        let element = ((share * elements as f64) as usize).min(elements - 1);
        let xi = 2.0 * (share * elements as f64 - element as f64) - 1.0;
        sum(&shapes(xi), &self.of_element(element, |node| node.position))
    }
}
