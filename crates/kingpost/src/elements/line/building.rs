//! Creation of lines, and of trees of them.

use super::mesh::{LineMesh, SecondEnd};
use super::nodes::Nodes;
use super::statics::LineStatics;
use super::step::LineStep;
use super::strand::{LineJoint, Strand};
use super::{ClumpWeight, DynamicLine, LineGround, LinePart, LineSupply};
use crate::elements::ropes::{Drum, Station};
use crate::model::Attachment;
use crate::scalar::Scalar;
use crate::spatial::Vector3;

impl<S: Scalar> DynamicLine<S> {
    /// Creates a line of these parts, from its first end, which begins at rest.
    pub fn new(name: &str, ends: [Attachment<S>; 2], parts: &[LinePart<S>]) -> Self {
        Self::of(vec![Strand::new(name, ends.map(Some), LineMesh::new(parts))])
    }

    /// Creates a line of these parts, from its first end; its second end is free.
    pub fn ending_free(name: &str, first: Attachment<S>, parts: &[LinePart<S>]) -> Self {
        let mesh = LineMesh::new(parts).held_by(SecondEnd::Free);
        Self::of(vec![Strand::new(name, [Some(first), None], mesh)])
    }

    /// Lets the first of these parts be paid out, over the stations of a path: its last two are the ends of the line.
    pub fn over(name: &str, stations: &[Station<S>], drum: Option<Drum<S>>, parts: &[LinePart<S>]) -> Self {
        let supply = LineSupply::new(stations, drum, parts[0].unstretched_length);
        let ends = [2, 1].map(|from_last| Some(stations[stations.len() - from_last].centre));
        let mesh = LineMesh::new(parts).pays_out(parts[0].elements);
        Self { supply: Some(supply), ..Self::of(vec![Strand::new(name, ends, mesh)]) }
    }

    /// Creates the element of lines, each behind the one to which it is fastened.
    fn of(strands: Vec<Strand<S>>) -> Self {
        Self {
            supply: None,
            start: None,
            responds: false,
            statics: LineStatics::new(&strands),
            step: LineStep::new(&strands),
            strands,
            on_ends: S::ZERO,
            at_base: [S::ZERO; 2],
        }
    }

    /// Gives the element other lines.
    fn with_strands(self, strands: Vec<Strand<S>>) -> Self {
        let Self { statics, step, strands, .. } = Self::of(strands);
        Self { statics, step, strands, ..self }
    }

    /// Changes the line on which all others hang.
    fn map_root(mut self, change: impl FnOnce(Strand<S>) -> Strand<S>) -> Self {
        let root = change(self.strands.remove(0));
        let strand = Strand { nodes: Nodes::new(&root.mesh), ..root };
        let mut strands = core::mem::take(&mut self.strands);
        strands.insert(0, strand);
        self.with_strands(strands)
    }

    /// Lets the line begin with its nodes at these positions between the ends, world, m: one less than twice the number of
    /// elements. No other line is fastened to it.
    pub fn beginning_at(self, start: Vec<Vector3<S>>) -> Self {
        Self { start: Some(start), ..self }
    }

    /// Fastens a clump weight or a buoy to the end of an element, counted from the first end, from 1.
    pub fn with_clump(mut self, element: usize, clump: ClumpWeight<S>) -> Self {
        self.strands[0].mesh.nodes[2 * element].clump = Some(clump);
        self
    }

    /// Lets the line lie on a ground.
    pub fn on(mut self, ground: LineGround<S>) -> Self {
        self.strands[0].ground = Some(ground);
        self
    }

    /// Lets the results have its tension at this number of points along it: 0, or 2 and more.
    pub fn with_points_along(mut self, points: usize) -> Self {
        self.strands[0].points_along = points;
        self
    }

    /// Clamps ends in these directions from the first end to the second one, in the axes of their bodies or of the world: unit
    /// vectors. Only bending stiffness makes a difference.
    pub fn clamped(self, clamps: [Option<Vector3<S>>; 2]) -> Self {
        let is_clamped = clamps.map(|clamp| clamp.is_some());
        self.map_root(|root| Strand { clamps, mesh: root.mesh.clamped(is_clamped), ..root })
    }

    /// Fastens the second end of another line, which [ends free](Self::ending_free), to the end of an element of this line,
    /// counted from the first end, from 1. What is fastened to the other line comes with it.
    pub fn with_branch(self, element: usize, branch: Self) -> Self {
        let node = 2 * element;
        let mut tree = self.map_root(|mut root| {
            let joints = &mut root.mesh.joints;
            joints.push(node);
            joints.sort_unstable();
            joints.dedup();
            root
        });
        let before = tree.strands.len();
        let branch = branch.map_root(|root| Strand { mesh: root.mesh.held_by(SecondEnd::Joined), ..root });
        let mut strands = core::mem::take(&mut tree.strands);
        strands.extend(branch.strands.into_iter().map(|strand| {
            let joint = strand
                .joint
                .map_or(LineJoint { strand: 0, node }, |joint| LineJoint { strand: joint.strand + before, ..joint });
            Strand { joint: Some(joint), ..strand }
        }));
        tree.with_strands(strands)
    }
}
