//! Linear equations of the nodes of a line: blocks of 3x3, tridiagonal after the nodes in the middle of the elements
//! are eliminated. The cost is linear in the number of nodes.

use crate::scalar::Scalar;
use crate::spatial::{Matrix3, Vector3};

/// The equations `A x = b` of a line whose ends do not move.
#[derive(Clone, Debug)]
pub struct Blocks<S> {
    /// Blocks of A on the diagonal, by node.
    diagonal: Vec<Matrix3<S>>,
    /// Blocks of A between the nodes of an element: first and middle, middle and last, first and last. Each is the same
    /// above and below the diagonal.
    between: Vec<[Matrix3<S>; 3]>,
    /// b, by node.
    right: Vec<Vector3<S>>,
    /// Blocks between the first and the last node of an element without its middle: above and below the diagonal.
    across: Vec<[Matrix3<S>; 2]>,
}

impl<S: Scalar> Blocks<S> {
    /// Allocates the memory for this odd number of nodes.
    pub fn new(nodes: usize) -> Self {
        let (zero, elements) = (Matrix3::zero(), nodes / 2);
        Self {
            diagonal: vec![zero; nodes],
            between: vec![[zero; 3]; elements],
            right: vec![Vector3::zero(); nodes],
            across: vec![[zero; 2]; elements],
        }
    }

    /// Sets all entries to zero.
    pub fn clear(&mut self) {
        self.diagonal.fill(Matrix3::zero());
        self.between.fill([Matrix3::zero(); 3]);
        self.right.fill(Vector3::zero());
    }

    /// Adds to the block of a node on the diagonal, and to its right side.
    pub fn add(&mut self, node: usize, diagonal: Matrix3<S>, right: Vector3<S>) {
        self.diagonal[node] += diagonal;
        self.right[node] += right;
    }

    /// Adds the stiffness `B N_i' N_j'` and the force `f N_i'` of an element at a point with these slopes.
    pub fn add_at(&mut self, element: usize, slopes: &[S; 3], stiffness: &Matrix3<S>, force: Vector3<S>) {
        for (k, slope) in slopes.iter().enumerate() {
            self.add(2 * element + k, stiffness.scaled(*slope * *slope), force * *slope);
        }
        for (block, [i, j]) in self.between[element].iter_mut().zip([[0, 1], [1, 2], [0, 2]]) {
            *block += stiffness.scaled(slopes[i] * slopes[j]);
        }
    }

    /// Returns b at the nodes; that of the ends has no meaning.
    pub fn right(&self) -> &[Vector3<S>] {
        &self.right
    }

    /// Solves for x, which is zero at the ends; entries are not finite if A is singular. Overwrites A and b.
    pub fn solve(&mut self, x: &mut [Vector3<S>]) {
        self.eliminate_middles();
        self.eliminate_forwards();
        let elements = self.between.len();
        x[0] = Vector3::zero();
        x[2 * elements] = Vector3::zero();
        for e in (1..elements).rev() {
            let node = 2 * e;
            x[node] = self.diagonal[node] * (self.right[node] - self.across[e][0] * x[node + 2]);
        }
        for e in 0..elements {
            let ([first, last, _], middle) = (&self.between[e], 2 * e + 1);
            let right = self.right[middle] - *first * x[middle - 1] - *last * x[middle + 1];
            x[middle] = self.diagonal[middle] * right;
        }
    }

    /// Eliminates the node in the middle of every element; its diagonal block becomes its inverse.
    fn eliminate_middles(&mut self) {
        for e in 0..self.between.len() {
            let ([first, last, both], middle) = (self.between[e], 2 * e + 1);
            let inverse = self.diagonal[middle].inverse();
            let [of_first, of_last] = [first * inverse, last * inverse];
            self.diagonal[middle - 1] -= of_first * first;
            self.diagonal[middle + 1] -= of_last * last;
            self.across[e] = [both - of_first * last, both - of_last * first];
            let right = self.right[middle];
            self.right[middle - 1] -= of_first * right;
            self.right[middle + 1] -= of_last * right;
            self.diagonal[middle] = inverse;
        }
    }

    /// Eliminates the nodes between elements from the first end; their diagonal blocks become their inverses.
    fn eliminate_forwards(&mut self) {
        for e in 1..self.between.len() {
            let node = 2 * e;
            if e > 1 {
                let of_before = self.across[e - 1][1] * self.diagonal[node - 2];
                let (above, right) = (self.across[e - 1][0], self.right[node - 2]);
                self.diagonal[node] -= of_before * above;
                self.right[node] -= of_before * right;
            }
            self.diagonal[node] = self.diagonal[node].inverse();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Multiplies A by x as it was given, at the nodes between the ends.
    fn times(a: &Blocks<f64>, x: &[Vector3]) -> Vec<Vector3> {
        let mut product: Vec<Vector3> = a.diagonal.iter().zip(x).map(|(block, x)| *block * *x).collect();
        for (e, blocks) in a.between.iter().enumerate() {
            for (block, [i, j]) in blocks.iter().zip([[0, 1], [1, 2], [0, 2]]) {
                product[2 * e + i] += *block * x[2 * e + j];
                product[2 * e + j] += *block * x[2 * e + i];
            }
        }
        product
    }

    #[test]
    fn the_solution_fulfils_the_equations() {
        for elements in [1, 2, 3, 7] {
            let count = 2 * elements + 1;
            let mut a = Blocks::new(count);
            let number = |k: usize| libm::sin(1.0 + 3.7 * k as f64);
            for e in 0..elements {
                for point in 0..2 {
                    let k = 20 * e + 10 * point;
                    let b = Matrix3::from_fn(|i, j| number(k + 3 * i + j)) + Matrix3::identity().scaled(4.0);
                    a.add_at(
                        e,
                        &[number(k) - 2.0, number(k + 1), 2.0 + number(k + 2)],
                        &b,
                        Vector3::new(1.0, number(k), 0.3),
                    );
                }
            }
            (0..count).for_each(|node| a.add(node, Matrix3::identity().scaled(20.0), Vector3::zero()));
            let mut x = vec![Vector3::zero(); count];
            let given = a.clone();
            a.solve(&mut x);
            for (node, product) in times(&given, &x).iter().enumerate().take(count - 1).skip(1) {
                // A few units in the last place of the largest products, about 100.
                assert!((*product - given.right[node]).norm() < 1e-12, "{elements} {node}");
            }
        }
    }
}
