//! Nodes at which lines are fastened to each other: they move together, by the forces and masses of all.

use super::DynamicLine;
use super::equations::firsts;
use super::strand::{LineJoint, Strand};
use crate::scalar::Scalar;
use crate::spatial::{Matrix3, Vector3};

impl<S: Scalar> DynamicLine<S> {
    /// Moves the last node of a branch as the node to which it is fastened.
    pub(super) fn follow_joint(&mut self, strand: usize) {
        let Some(joint) = self.strands[strand].joint else { return };
        let node = self.strands[joint.strand].nodes.node(joint.node);
        let (position, velocity) = (node.position, node.velocity);
        let last = self.strands[strand].last();
        self.strands[strand].nodes.put(last, position, velocity);
    }

    /// Returns the line and the node of it with this index among the nodes of all lines.
    pub(super) fn among_all(&self, node: usize) -> (usize, usize) {
        let firsts = firsts(&self.strands);
        let strand = firsts.partition_point(|first| *first <= node) - 1;
        (strand, node - firsts[strand])
    }

    /// Computes the accelerations of joints, after the nodes of all lines are loaded.
    pub(super) fn accelerate_joints(&mut self) {
        for strand in 0..self.strands.len() {
            for k in 0..self.strands[strand].mesh.joints.len() {
                let node = self.strands[strand].mesh.joints[k];
                self.accelerate_joint(LineJoint { strand, node });
            }
        }
    }

    fn accelerate_joint(&mut self, joint: LineJoint) {
        let (mut mass, mut force) = (Matrix3::zero(), Vector3::zero());
        for (strand, node) in self.at_joint(joint) {
            let node = self.strands[strand].nodes.node(node);
            mass += node.mass.about(node.tangent);
            force += node.force;
        }
        let acceleration = mass.inverse() * force;
        for k in 0..self.strands.len() {
            let Strand { mesh, nodes, joint: fastened, .. } = &mut self.strands[k];
            if joint.strand == k {
                nodes.accelerate(joint.node, mesh, acceleration);
            }
            if *fastened == Some(joint) {
                nodes.accelerate(mesh.nodes.len() - 1, mesh, acceleration);
            }
        }
    }

    /// Returns the lines that meet at a joint, with their nodes.
    fn at_joint(&self, joint: LineJoint) -> impl Iterator<Item = (usize, usize)> {
        let branches = self.strands.iter().enumerate().filter(move |(_, strand)| strand.joint == Some(joint));
        core::iter::once((joint.strand, joint.node)).chain(branches.map(|(k, strand)| (k, strand.last())))
    }
}
