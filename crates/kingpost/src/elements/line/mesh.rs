//! The elements and nodes of a line, and the length that belongs to each.

use super::section::{LineSection, WetPart};
use crate::elements::Context;
use crate::scalar::Scalar;
use crate::spatial::Vector3;

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
}

impl<S: Scalar> LineMeshNode<S> {
    /// Returns its length in the water, with the node at a point and with this unit tangent.
    pub fn in_water(&self, at: &Context<'_, S>, point: Vector3<S>, tangent: Vector3<S>) -> WetPart<S> {
        let middle = point[2] + tangent[2] * self.length * S::constant(self.middle);
        self.section.in_water(at, self.length, (point, middle, tangent))
    }

    /// Returns its mass without water, kg.
    pub fn dry_mass(&self) -> S {
        self.section.mass_per_length * self.length
    }
}

/// The elements and nodes of a line, from its first end.
#[derive(Clone, Debug)]
pub struct LineMesh<S> {
    /// Elements.
    pub elements: Vec<LineMeshElement<S>>,
    /// Nodes: each second one is in the middle of an element.
    pub nodes: Vec<LineMeshNode<S>>,
    /// Length of the line, m.
    pub length: S,
}

impl<S: Scalar> LineMesh<S> {
    /// Divides the parts of a line into elements of equal length in each.
    pub fn new(parts: &[LinePart<S>]) -> Self {
        let divided = parts.iter().flat_map(|part| {
            let length = part.unstretched_length / S::constant(part.elements as f64);
            core::iter::repeat_n(LineMeshElement { length, section: part.section }, part.elements)
        });
        let elements: Vec<LineMeshElement<S>> = divided.collect();
        let share = |element: &LineMeshElement<S>, sixths: f64| element.length * S::constant(sixths / 6.0);
        let whole = |element: &LineMeshElement<S>, sixths, middle| LineMeshNode {
            length: share(element, sixths),
            section: element.section,
            middle,
        };
        let mut nodes = vec![whole(&elements[0], 1.0, 0.5)];
        for (k, element) in elements.iter().enumerate() {
            nodes.push(whole(element, 4.0, 0.0));
            let at_end = whole(element, 1.0, -0.5);
            nodes.push(elements.get(k + 1).map_or(at_end, |next| at_end.with(&whole(next, 1.0, 0.5))));
        }
        let length = parts.iter().fold(S::ZERO, |sum, part| sum + part.unstretched_length);
        Self { elements, nodes, length }
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
            added_mass: [
                of(|section| section.added_mass[0] * section.diameter * section.diameter) / square,
                of(|section| section.added_mass[1] * section.diameter * section.diameter) / square,
            ],
            drag: [
                of(|section| section.drag[0] * section.diameter) / diameter,
                of(|section| section.drag[1] * section.diameter) / diameter,
            ],
        };
        Self { length, section, middle: 0.0 }
    }
}
