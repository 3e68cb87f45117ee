//! Square matrices over all bodies, in blocks of six rows and six columns: the zeros are left out.

use nalgebra::{DMatrix, SMatrix};

/// Rows and columns of two bodies.
pub(super) type Block = SMatrix<f64, 6, 6>;

/// A matrix by blocks: one for each body on the diagonal, and some beside it.
#[derive(Clone, Debug)]
pub(super) struct SparseBlocks {
    /// By body.
    pub diagonal: Vec<Block>,
    /// Row, column and block of bodies with inertia between them.
    pub beside: Vec<(usize, usize, Block)>,
}

impl SparseBlocks {
    /// The whole matrix.
    pub fn to_matrix(&self) -> DMatrix<f64> {
        let n = 6 * self.diagonal.len();
        let mut matrix = DMatrix::zeros(n, n);
        for (row, column, block) in self.entries() {
            let mut view = matrix.fixed_view_mut::<6, 6>(6 * row, 6 * column);
            view += block;
        }
        matrix
    }

    /// The product with a matrix.
    pub fn times(&self, right: &DMatrix<f64>) -> DMatrix<f64> {
        let mut product = DMatrix::zeros(right.nrows(), right.ncols());
        for (row, column, block) in self.entries() {
            let rows = block * right.fixed_rows::<6>(6 * column);
            let mut view = product.fixed_rows_mut::<6>(6 * row);
            view += rows;
        }
        product
    }

    fn entries(&self) -> impl Iterator<Item = (usize, usize, &Block)> {
        let own = self.diagonal.iter().enumerate().map(|(body, block)| (body, body, block));
        own.chain(self.beside.iter().map(|(row, column, block)| (*row, *column, block)))
    }
}
