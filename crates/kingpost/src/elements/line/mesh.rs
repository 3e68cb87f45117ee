//! The elements and nodes of a line, and the length that belongs to each.

use super::bend::{Bend, bends};
use super::in_random_sea::RandomWater;
use super::section::{ClumpWeight, LineSection, WetPart};
use crate::elements::Context;
use crate::scalar::Scalar;
use crate::spatial::Vector3;
use core::ops::Range;

/// A part of a line with the same properties along it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinePart<S = f64> {
    /// Length without tension, m.
    pub unstretched_length: S,
    /// Properties per length.
    pub section: LineSection<S>,
    /// Number of its elements.
    pub elements: usize,
}

/// Properties of an element.
#[derive(Clone, Copy, Debug)]
pub struct LineMeshElement<S> {
    /// Unstretched length, m.
    pub length: S,
    /// Its properties.
    pub section: LineSection<S>,
}

/// Properties of a node, by Simpson's rule.
#[derive(Clone, Copy, Debug)]
pub struct LineMeshNode<S> {
    /// Unstretched length, m.
    pub length: S,
    /// Mean properties of this length.
    pub section: LineSection<S>,
    /// Middle of this length, from the node along the line, as a share of the length: not 0 at the ends.
    pub middle: f64,
    /// Where the node is in a first part that is [paid out](LineMesh::pays_out): 1 at the first end of the line, 0 at the end of
    /// the part and beyond, or if nothing is paid out.
    pub share: f64,
    /// Derivative of the length along that of the first part, if it is paid out.
    pub growth: f64,
    /// Clump weight or buoy that is fastened to it.
    pub clump: Option<ClumpWeight<S>>,
    /// The random sea about it, in a linear response.
    pub random: Option<RandomWater<S>>,
}

impl<S: Scalar> LineMeshNode<S> {
    /// Returns its length in the water, with the node at a point and with this unit tangent.
    pub fn in_water(&self, at: &Context<'_, S>, point: Vector3<S>, tangent: Vector3<S>) -> WetPart<S> {
        let middle = point[2] + tangent[2] * self.length * S::constant(self.middle);
        let wet = self.section.in_water(at, self.length, (point, middle, tangent), self.clump.as_ref());
        self.random.as_ref().map_or(wet, |sea| wet.in_random_sea(sea))
    }

    /// Returns its mass without water, kg.
    pub fn dry_mass(&self) -> S {
        let own = self.section.mass_per_length * self.length;
        self.clump.map_or(own, |clump| own + clump.mass)
    }
}

/// Hold of the second end of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SecondEnd {
    /// A body or the world.
    Held,
    /// Nothing.
    Free,
    /// A node of another line.
    Joined,
}

/// The elements and nodes of a line, from its first end.
#[derive(Clone, Debug)]
pub struct LineMesh<S> {
    /// Elements.
    pub elements: Vec<LineMeshElement<S>>,
    /// Nodes: each second one is in the middle of an element.
    pub nodes: Vec<LineMeshNode<S>>,
    /// Its bends, if it has bending stiffness.
    pub bends: Vec<Bend<S>>,
    /// Hold of the second end.
    pub second: SecondEnd,
    /// Nodes to which other lines are fastened.
    pub joints: Vec<usize>,
    /// Length of the line, m.
    pub length: S,
    /// Number of elements of the first part, whose length changes as it is paid out; 0 if none does.
    pub supplied: usize,
    /// Length of the first part, and of all others, m.
    first: S,
    others: S,
    /// Node at the end of the first part, without the length of that part.
    beyond: Option<LineMeshNode<S>>,
}

/// Sixths of the length of an element at its nodes: Simpson's rule.
const SIMPSON: [f64; 3] = [1.0, 4.0, 1.0];
/// Sixths in the element at a drum or sheave: without mass there, so that the inertia of the line is on its nodes alone. The
/// total and the first moment are those of Simpson's rule; the error of natural frequencies is of third order there.
const AT_DRUM: [f64; 3] = [0.0, 6.0, 0.0];

impl<S: Scalar> LineMesh<S> {
    /// Divides the parts of a line into elements of equal length in each.
    pub fn new(parts: &[LinePart<S>]) -> Self {
        let divided = parts.iter().flat_map(|part| {
            let length = part.unstretched_length / S::constant(part.elements as f64);
            core::iter::repeat_n(LineMeshElement { length, section: part.section }, part.elements)
        });
        let elements: Vec<LineMeshElement<S>> = divided.collect();
        let mut nodes = vec![node(&elements[0], SIMPSON[0], 0.5)];
        for (k, element) in elements.iter().enumerate() {
            nodes.push(node(element, SIMPSON[1], 0.0));
            let at_end = node(element, SIMPSON[2], -0.5);
            nodes.push(elements.get(k + 1).map_or(at_end, |next| at_end.with(&node(next, SIMPSON[0], 0.5))));
        }
        let first = parts[0].unstretched_length;
        let others = parts[1..].iter().fold(S::ZERO, |sum, part| sum + part.unstretched_length);
        let mesh = Self {
            elements,
            nodes,
            bends: Vec::new(),
            second: SecondEnd::Held,
            joints: Vec::new(),
            length: first + others,
            supplied: 0,
            first,
            others,
            beyond: None,
        };
        mesh.clamped([false; 2])
    }

    /// Lets this hold the second end.
    pub fn held_by(self, second: SecondEnd) -> Self {
        Self { second, ..self }
    }

    /// Returns the nodes that are not at an end on a body or in the world.
    pub fn moving(&self) -> Range<usize> {
        1..self.nodes.len() - usize::from(self.second == SecondEnd::Held)
    }

    /// Returns the nodes that move by themselves: not the last one if it moves with a node of another line.
    pub fn with_states(&self) -> Range<usize> {
        1..self.nodes.len() - usize::from(self.second != SecondEnd::Free)
    }

    /// Whether other lines act on a node.
    pub fn is_joint(&self, node: usize) -> bool {
        (self.second == SecondEnd::Joined && node + 1 == self.nodes.len()) || self.joints.contains(&node)
    }

    /// Whether nothing holds the second end, no other line either.
    pub fn hangs_free(&self) -> bool {
        self.second == SecondEnd::Free && !self.joints.contains(&(self.nodes.len() - 1))
    }

    /// Clamps some of its ends, if it has bending stiffness.
    pub fn clamped(self, ends: [bool; 2]) -> Self {
        let each = |element: &LineMeshElement<S>| (element.length, element.section.bending_stiffness);
        let elements: Vec<(S, S)> = self.elements.iter().map(each).collect();
        Self { bends: bends(&elements, ends), ..self }
    }

    /// Lets the length of the first part change: this number of elements.
    pub fn pays_out(self, supplied: usize) -> Self {
        let beyond = self.elements.get(supplied).map(|next| node(next, SIMPSON[0], 0.5));
        let mut mesh = Self { supplied, beyond, ..self };
        let all = supplied as f64;
        for i in 0..=2 * supplied {
            let of = [i.checked_sub(1).map(|_| (i - 1) / 2), (i < 2 * supplied).then_some(i / 2)];
            let sixths = match of {
                [_, Some(element)] if i % 2 == 1 => sixths(element)[1],
                [before, behind] => before.map_or(0.0, |e| sixths(e)[2]) + behind.map_or(0.0, |e| sixths(e)[0]),
            };
            (mesh.nodes[i].share, mesh.nodes[i].growth) = (1.0 - i as f64 / (2.0 * all), sixths / (6.0 * all));
        }
        mesh.set_first(mesh.first);
        mesh
    }

    /// Sets the length of the first part, m.
    pub fn set_first(&mut self, length: S) {
        let element_length = length / S::constant(self.supplied as f64);
        self.elements[..self.supplied].iter_mut().for_each(|element| element.length = element_length);
        let end = 2 * self.supplied;
        for node in &mut self.nodes[..=end] {
            node.length = length * S::constant(node.growth);
        }
        if let Some(beyond) = &self.beyond {
            let LineMeshNode { growth, share, clump, random, .. } = self.nodes[end];
            let own = node(&self.elements[self.supplied - 1], 0.0, 0.0);
            let own = LineMeshNode { length: length * S::constant(growth), ..own };
            self.nodes[end] = LineMeshNode { growth, share, clump, random, ..own.with(beyond) };
        }
        (self.first, self.length) = (length, length + self.others);
    }

    /// Returns the length of the first part, m.
    pub fn first(&self) -> S {
        self.first
    }

    /// Returns the mass per length of the first part, kg/m.
    pub fn mass_per_length(&self) -> S {
        self.elements[0].section.mass_per_length
    }

    /// Returns the length of the shortest element, m.
    pub fn shortest(&self) -> S {
        self.elements.iter().fold(self.length, |least, one| one.length.select_less(least, || one.length, || least))
    }
}

impl<S: Scalar> LineMeshNode<S> {
    /// Returns a node with the lengths of two, and the means of their masses, displaced volumes and drag areas.
    fn with(&self, other: &Self) -> Self {
        let length = self.length + other.length;
        let of = |value: fn(&LineSection<S>) -> S| {
            (value(&self.section) * self.length + value(&other.section) * other.length) / length
        };
        let diameter = of(|section| section.diameter * section.diameter).sqrt();
        let square = diameter * diameter;
        let section = LineSection {
            mass_per_length: of(|section| section.mass_per_length),
            diameter,
            axial_stiffness: of(|section| section.axial_stiffness),
            damping_time: of(|section| section.damping_time),
            bending_stiffness: of(|section| section.bending_stiffness),
            added_mass: [
                of(|section| section.added_mass[0] * section.diameter * section.diameter) / square,
                of(|section| section.added_mass[1] * section.diameter * section.diameter) / square,
            ],
            drag: [
                of(|section| section.drag[0] * section.diameter) / diameter,
                of(|section| section.drag[1] * section.diameter) / diameter,
            ],
        };
        Self { length, section, middle: 0.0, share: 0.0, growth: 0.0, clump: None, random: None }
    }
}

/// Returns a node with these sixths of an element, whose middle is at this share of them from the node.
fn node<S: Scalar>(element: &LineMeshElement<S>, sixths: f64, middle: f64) -> LineMeshNode<S> {
    let length = element.length * S::constant(sixths / 6.0);
    LineMeshNode { length, section: element.section, middle, share: 0.0, growth: 0.0, clump: None, random: None }
}

/// Returns the sixths of an element of a part that is paid out.
fn sixths(element: usize) -> [f64; 3] {
    if element == 0 { AT_DRUM } else { SIMPSON }
}
