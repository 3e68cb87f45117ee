//! Linear equations of the nodes of a tree of lines.
//!
//! Each line has the [blocks](super::blocks) of its nodes. The last node of a branch moves with a node of another line: the nodes
//! of the branch are eliminated first, and what is left at its last node is added to that node of the other line. So no block
//! fills in that the lines alone do not have, and the cost is linear in the number of nodes.

use super::blocks::Blocks;
use super::strand::{LineJoint, Strand};
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// The equations `A x = b` of a tree of lines: each line comes behind the one to which it is fastened.
#[derive(Clone, Debug)]
pub struct LineEquations<S> {
    /// Those of each line.
    pub strands: Vec<Blocks<S>>,
    joints: Vec<Option<LineJoint>>,
    /// Index of the first node of each line among those of all.
    firsts: Vec<usize>,
}

impl<S: Scalar> LineEquations<S> {
    /// Allocates the memory for these lines.
    pub fn new(strands: &[Strand<S>]) -> Self {
        let of = |strand: &Strand<S>| Blocks::new(&strand.mesh);
        Self {
            strands: strands.iter().map(of).collect(),
            joints: strands.iter().map(|strand| strand.joint).collect(),
            firsts: firsts(strands),
        }
    }

    /// Factors A.
    pub fn factor(&mut self) {
        for k in (0..self.strands.len()).rev() {
            self.strands[k].factor();
            if let Some(LineJoint { strand, node }) = self.joints[k] {
                let (block, _) = self.strands[k].condensed();
                self.strands[strand].add::<true>(node, block, Vector3::zero());
            }
        }
    }

    /// Takes the factors of other equations in all lanes but the open ones, which have 1, not 0.
    pub fn keep(&mut self, kept: &Self, open: S) {
        self.strands.iter_mut().zip(&kept.strands).for_each(|(blocks, kept)| blocks.keep(kept, open));
    }

    /// Solves for x at the nodes of all lines, with A factored; see [`Blocks::substitute`].
    pub fn solve(&mut self, x: &mut [Vector3<S>]) {
        for k in (0..self.strands.len()).rev() {
            self.strands[k].eliminate_right();
            if let Some(LineJoint { strand, node }) = self.joints[k] {
                let (block, right) = self.strands[k].condensed();
                self.strands[strand].add::<false>(node, block, right);
            }
        }
        for (k, blocks) in self.strands.iter().enumerate() {
            let at_joint = self.joints[k].map_or(Vector3::zero(), |joint| x[self.firsts[joint.strand] + joint.node]);
            let first = self.firsts[k];
            blocks.substitute(at_joint, &mut x[first..first + blocks.right().len()]);
        }
    }
}

/// Returns the index of the first node of each line among those of all.
pub fn firsts<S: Scalar>(strands: &[Strand<S>]) -> Vec<usize> {
    let counts = strands.iter().map(|strand| strand.mesh.nodes.len());
    counts.scan(0, |sum, count| core::mem::replace(sum, *sum + count).into()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::elements::line::mesh::{LineMesh, SecondEnd};
    use crate::elements::line::{LinePart, LineSection};
    use crate::spatial::Matrix3;

    fn number(k: usize) -> f64 {
        libm::sin(1.0 + 3.7 * k as f64)
    }

    fn strand(
        elements: usize,
        bends: bool,
        second: SecondEnd,
        (joint, joints): (Option<LineJoint>, &[usize]),
    ) -> Strand {
        let section = LineSection {
            mass_per_length: 1.0,
            diameter: 1.0,
            axial_stiffness: 1.0,
            damping_time: 0.0,
            bending_stiffness: if bends { 1.0 } else { 0.0 },
            added_mass: [0.0; 2],
            drag: [0.0; 2],
        };
        let mut mesh = LineMesh::new(&[LinePart { unstretched_length: 1.0, section, elements }]).held_by(second);
        mesh.joints = joints.to_vec();
        Strand { joint, ..Strand::new("line", [None; 2], mesh) }
    }

    /// Adds numbers to the equations, and returns A x - b at each node of each line, where a branch has the x of its joint.
    fn fill(equations: &mut LineEquations<f64>, bends: bool) -> impl Fn(&[Vec<Vector3>]) -> Vec<Vec<Vector3>> + use<> {
        let mut added = Vec::new();
        for (strand, blocks) in equations.strands.iter_mut().enumerate() {
            let count = blocks.right().len();
            for first in (0..count - 2).step_by(if bends { 1 } else { 2 }) {
                for point in 0..2 {
                    let k = 1000 * strand + 20 * first + 10 * point;
                    let b = Matrix3::from_fn(|i, j| number(k + 3 * i + j)) + Matrix3::identity().scaled(4.0);
                    let weights = [number(k) - 2.0, number(k + 1), 2.0 + number(k + 2)];
                    let right = Vector3::new(1.0, number(k), 0.3);
                    blocks.add_at::<true>(first, &weights, &b, right);
                    added.push((strand, first, weights, b, right));
                }
            }
            for node in 0..count {
                blocks.add::<true>(node, Matrix3::identity().scaled(20.0), Vector3::zero());
            }
        }
        move |x| {
            let mut rest: Vec<Vec<Vector3>> = x.iter().map(|x| x.iter().map(|x| *x * 20.0).collect()).collect();
            for (strand, first, weights, b, right) in &added {
                let sum = (0..3).fold(Vector3::zero(), |sum, k| sum + x[*strand][first + k] * weights[k]);
                for (k, weight) in weights.iter().enumerate() {
                    rest[*strand][first + k] += (*b * sum - *right) * *weight;
                }
            }
            rest
        }
    }

    /// Solves equations of lines. Returns the largest rest at a node that moves by itself.
    fn largest_rest(strands: &[Strand], bends: bool) -> f64 {
        let mut equations = LineEquations::new(strands);
        let rest_of = fill(&mut equations, bends);
        let counts = strands.iter().map(|strand| strand.mesh.nodes.len());
        let mut flat = vec![Vector3::zero(); counts.clone().sum()];
        equations.factor();
        equations.solve(&mut flat);
        let of = |(first, count): (usize, usize)| flat[first..first + count].to_vec();
        let x: Vec<Vec<Vector3>> = firsts(strands).into_iter().zip(counts).map(of).collect();
        let mut rest = rest_of(&x);
        for k in (1..strands.len()).rev() {
            let joint = strands[k].joint.expect("a branch");
            let last = rest[k][strands[k].last()];
            rest[joint.strand][joint.node] += last;
        }
        let moving = strands.iter().zip(&rest).flat_map(|(strand, rest)| &rest[strand.mesh.with_states()]);
        moving.fold(0.0, |most: f64, rest| most.max(rest.norm()))
    }

    #[test]
    fn the_solution_fulfils_the_equations_of_a_line() {
        for elements in [1, 2, 3, 7] {
            for bends in [false, true] {
                for second in [SecondEnd::Held, SecondEnd::Free] {
                    let rest = largest_rest(&[strand(elements, bends, second, (None, &[]))], bends);
                    // A few units in the last place of the largest products, about 100.
                    assert!(rest < 1e-12, "{elements} {bends} {second:?}: {rest}");
                }
            }
        }
    }

    #[test]
    fn the_solution_fulfils_the_equations_of_a_tree() {
        let on = |strand, node| Some(LineJoint { strand, node });
        for bends in [false, true] {
            for second in [SecondEnd::Held, SecondEnd::Free] {
                // Two branches at one node, one at another, and a branch of a branch.
                let strands = [
                    strand(4, bends, second, (None, &[2, 6])),
                    strand(1, bends, SecondEnd::Joined, (on(0, 2), &[])),
                    strand(3, bends, SecondEnd::Joined, (on(0, 2), &[4])),
                    strand(2, bends, SecondEnd::Joined, (on(0, 6), &[])),
                    strand(2, bends, SecondEnd::Joined, (on(2, 4), &[])),
                ];
                let rest = largest_rest(&strands, bends);
                // As for one line, with five of them.
                assert!(rest < 5e-12, "{bends} {second:?}: {rest}");
            }
        }
    }
}
