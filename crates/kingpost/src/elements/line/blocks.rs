//! Linear equations of the nodes of a line: blocks of 3x3, two on each side of the diagonal. The cost is linear in the number
//! of nodes.

use super::mesh::LineMesh;
use crate::scalar::Scalar;
use crate::spatial::{Matrix3, Vector3};
use core::ops::Range;

/// The equations `A x = b` of a line whose first end does not move.
#[derive(Clone, Debug)]
pub struct Blocks<S> {
    /// Blocks of A on the diagonal, by node; once A is factored, the inverses of those of U.
    diagonal: Vec<Matrix3<S>>,
    /// Blocks of A between a node and the next, and the second next one: each is the same above and below the diagonal. Once A
    /// is factored, those of U.
    above: Vec<[Matrix3<S>; 2]>,
    /// Blocks of L below the diagonal, once A is factored.
    below: Vec<[Matrix3<S>; 2]>,
    /// Blocks of A between a node and the next, which are those between the node and the one before it with the sign changed:
    /// in addition to those above, if there are any.
    turns: Vec<Matrix3<S>>,
    /// b, by node.
    right: Vec<Vector3<S>>,
    /// The nodes that move.
    moving: Range<usize>,
    /// Those that are eliminated: all but the last node of a line that is fastened to another one.
    eliminated: Range<usize>,
    /// Whether nodes in the middle of neighbouring elements act on each other, by bending.
    bends: bool,
}

impl<S: Scalar> Blocks<S> {
    /// Allocates the memory for the nodes of a mesh, of which every second one is in the middle of an element.
    pub fn new(mesh: &LineMesh<S>) -> Self {
        let nodes = mesh.nodes.len();
        let (zero, pairs) = (Matrix3::zero(), vec![[Matrix3::zero(); 2]; nodes]);
        Self {
            diagonal: vec![zero; nodes],
            above: pairs.clone(),
            below: pairs,
            turns: Vec::new(),
            right: vec![Vector3::zero(); nodes],
            moving: mesh.moving(),
            eliminated: mesh.with_states(),
            bends: !mesh.bends.is_empty(),
        }
    }

    /// Sets all entries to zero: those of b, and of A with `MATRIX`.
    pub fn clear<const MATRIX: bool>(&mut self) {
        self.right.fill(Vector3::zero());
        if MATRIX {
            self.diagonal.fill(Matrix3::zero());
            self.above.fill([Matrix3::zero(); 2]);
            self.turns.fill(Matrix3::zero());
        }
    }

    /// Adds to b at a node, and to its block of A on the diagonal with `MATRIX`.
    #[inline]
    pub fn add<const MATRIX: bool>(&mut self, node: usize, diagonal: Matrix3<S>, right: Vector3<S>) {
        self.right[node] += right;
        if MATRIX {
            self.diagonal[node] += diagonal;
        }
    }

    /// Adds the force `f w_i` of three successive nodes with these weights, and the stiffness `B w_i w_j` with `MATRIX`.
    #[inline]
    pub fn add_at<const MATRIX: bool>(
        &mut self,
        first: usize,
        weights: &[S; 3],
        stiffness: &Matrix3<S>,
        force: Vector3<S>,
    ) {
        for (k, weight) in weights.iter().enumerate() {
            self.add::<MATRIX>(first + k, stiffness.scaled(*weight * *weight), force * *weight);
        }
        if !MATRIX {
            return;
        }
        let [a, b, c] = *weights;
        self.above[first][0] += stiffness.scaled(a * b);
        self.above[first + 1][0] += stiffness.scaled(b * c);
        self.above[first][1] += stiffness.scaled(a * c);
    }

    /// Adds the derivative of the force on a node along the way from the one before it to the next, with the sign changed.
    pub fn turn(&mut self, node: usize, derivative: Matrix3<S>) {
        self.turns.resize(self.right.len(), Matrix3::zero());
        self.turns[node] += derivative;
    }

    /// Returns b at the nodes; that of the ends has no meaning.
    pub fn right(&self) -> &[Vector3<S>] {
        &self.right
    }

    /// Factors A = L U.
    pub fn factor(&mut self) {
        self.below.copy_from_slice(&self.above);
        for (node, turn) in self.turns.iter().enumerate().take(self.moving.end).skip(1) {
            self.above[node][0] += *turn;
            self.below[node - 1][0] -= *turn;
        }
        self.eliminated.clone().for_each(|node| self.eliminate(node));
    }

    /// Takes the factors of other equations in all lanes but the open ones, which have 1, not 0.
    pub fn keep(&mut self, kept: &Self, open: S) {
        let keep = |one: &mut Matrix3<S>, kept: &Matrix3<S>| {
            *one = Matrix3::from_fn(|i, j| open.select_below(0.5, || kept.0[i][j], || one.0[i][j]));
        };
        self.diagonal.iter_mut().zip(&kept.diagonal).for_each(|(one, kept)| keep(one, kept));
        let pairs = self.above.iter_mut().chain(&mut self.below).zip(kept.above.iter().chain(&kept.below));
        pairs.flat_map(|(one, kept)| one.iter_mut().zip(kept)).for_each(|(one, kept)| keep(one, kept));
    }

    /// Returns what elimination leaves at the last node of a line that is fastened to another one: of A, and of b.
    pub fn condensed(&self) -> (Matrix3<S>, Vector3<S>) {
        let last = self.right.len() - 1;
        (self.diagonal[last], self.right[last])
    }

    /// Eliminates the nodes from b, with A factored.
    pub fn eliminate_right(&mut self) {
        for node in self.eliminated.clone() {
            let right = self.right[node];
            for behind in 1..=self.reach(node) {
                self.right[node + behind] -= self.below[node][behind - 1] * right;
            }
        }
    }

    /// Solves for x, with A factored and the nodes eliminated from b; entries are not finite if A is singular. It is zero at nodes
    /// that do not move, and this at the last one of a line that is fastened to another one.
    pub fn substitute(&self, at_joint: Vector3<S>, x: &mut [Vector3<S>]) {
        x[0] = Vector3::zero();
        x[self.eliminated.end..].fill(at_joint);
        for node in self.eliminated.clone().rev() {
            let mut right = self.right[node];
            for behind in 1..=self.reach(node) {
                right -= self.above[node][behind - 1] * x[node + behind];
            }
            x[node] = self.diagonal[node] * right;
        }
    }

    /// Sets b to the forces on the moving nodes by moves of the first end and, unless it moves freely, of the second one, with A
    /// factored.
    pub fn move_ends(&mut self, [first, last]: [Vector3<S>; 2]) {
        self.right.fill(Vector3::zero());
        for (node, block) in [1, 2].into_iter().zip(self.above[0]) {
            self.right[node] -= block * first;
        }
        let end = self.moving.end;
        for (back, before) in [1, 2].into_iter().filter_map(|back| Some((back, end.checked_sub(back)?))) {
            if end < self.right.len() && before > 0 {
                self.right[before] -= self.above[before][back - 1] * last;
            }
        }
    }

    /// Returns the number of moving nodes behind a node on which it acts.
    fn reach(&self, node: usize) -> usize {
        let reach = if self.bends || node.is_multiple_of(2) { 2 } else { 1 };
        reach.min(self.moving.end - 1 - node)
    }

    /// Eliminates a node.
    fn eliminate(&mut self, node: usize) {
        let inverse = self.diagonal[node].inverse();
        let (reach, [near, far]) = (self.reach(node), self.above[node]);
        for behind in 1..=reach {
            let factor = self.below[node][behind - 1] * inverse;
            self.below[node][behind - 1] = factor;
            let row = [factor * near, if reach > 1 { factor * far } else { Matrix3::zero() }];
            self.diagonal[node + behind] -= row[behind - 1];
            if reach == 2 {
                let pair = if behind == 1 { &mut self.above } else { &mut self.below };
                pair[node + 1][0] -= row[2 - behind];
            }
        }
        self.diagonal[node] = inverse;
    }
}
