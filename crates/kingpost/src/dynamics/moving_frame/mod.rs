//! The moving frame method as in the paper, block by block.
//!
//! | here | paper |
//! | --- | --- |
//! | `frames`, `relative` | E, absolute (eq. 20) and relative (eq. 24) |
//! | `b` | B (eqs. 45-46): the rates of all bodies from the generalized velocity |
//! | `b_dot` | B', by the product rule |
//! | `x_dot` | the Cartesian rates (eq. 44a): by body, x' in the world, omega in body axes |
//! | `m` | M (eq. 48); a body with a full 6x6 inertia fills its block, inertia between two bodies those beside the diagonal |
//! | `d` | D (eq. 57), the term of the restricted variation of omega (eqs. 55, 58) |
//! | `f` | {F} (eq. 59, there {Q}), motors as couples on the child and back on the parent |
//! | `m_star`, `n_star`, `f_star` | M*, N*, F* (eqs. 60a-60c) |
//! | `j`, `j_dot_v` | not in the paper: J and J' q' of closed loops and of inextensible ropes, which border M* |
//!
//! Rotors add their inertia to the diagonal of M*. For a full 6x6 inertia the block of M turns with the body, so M'
//! enters in addition to B', and D gets the term of Kirchhoff's equations for linear momentum: both vanish for the
//! paper's bodies.

mod blocks;
mod factors;
mod formula;
mod labels;
mod loops;
mod sparse_blocks;
mod symbolic;
mod symbols;

pub use factors::{Factor, Symbol};
pub use formula::{Formula, Instant};
pub use labels::NamedMatrix;
pub use symbolic::{BlockMatrix, SymbolicMatrix};
pub use symbols::{Naming, Symbols};

use super::Loads;
use crate::model::{Model, MotionType, Node};
use crate::spatial::{Frame, Vector3};
use nalgebra::{DMatrix, DVector};
use serde::Serialize;
use sparse_blocks::{Block, SparseBlocks};

/// The variation of the angular velocity in Hamilton's principle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variation {
    /// `delta omega = d/dt delta pi + omega x delta pi` (eq. 55): the correct one.
    Restricted,
    /// `delta omega = d/dt delta pi`, that is D = 0: wrong for rotations in space, kept to show the consequences.
    Naive,
}

/// The method's equations for other languages: the matrices at one state, and the formulas of their blocks.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Equations {
    /// The matrices, in the order of the theory.
    pub matrices: Vec<NamedMatrix>,
    /// The formulas of the matrices that have them, with bodies by number.
    pub formulas: Vec<SymbolicMatrix>,
}

/// Every matrix of the method at one state.
#[derive(Clone, Debug)]
pub struct MovingFrame {
    /// E of each body.
    pub frames: Vec<Frame>,
    /// E(child/parent) of each body.
    pub relative: Vec<Frame>,
    /// B, 6 n_bodies x n_coordinates.
    pub b: DMatrix<f64>,
    /// B', the same shape.
    pub b_dot: DMatrix<f64>,
    /// Cartesian rates, 6 n_bodies.
    pub x_dot: DVector<f64>,
    /// M, 6 n_bodies square.
    pub m: DMatrix<f64>,
    /// M', zero for bodies with a rigid body's inertia.
    pub m_dot: DMatrix<f64>,
    /// D, 6 n_bodies square.
    pub d: DMatrix<f64>,
    /// {F}, 6 n_bodies.
    pub f: DVector<f64>,
    /// M* over the free coordinates.
    pub m_star: DMatrix<f64>,
    /// N* over the free coordinates. Only N* q' is unique, not N* itself.
    pub n_star: DMatrix<f64>,
    /// F* over the free coordinates, with the terms of prescribed motions.
    pub f_star: DVector<f64>,
    /// Generalized velocity of the free coordinates.
    pub free_velocity: DVector<f64>,
    /// Their indices in v.
    pub free: Vec<usize>,
    /// q'' of the prescribed coordinates, over all of them; zero elsewhere.
    pub given_acceleration: DVector<f64>,
    /// J over the free coordinates: one row per constraint of the closed loops, then one per taut inextensible rope.
    pub j: DMatrix<f64>,
    /// The part of phi'' without J q'': J' q', and the terms of prescribed motions.
    pub j_dot_v: DVector<f64>,
    /// Names of the elements that hold the last rows of J.
    pub held_by: Vec<String>,
}

/// E of each body, from E(child/parent): parents come first.
fn in_world(nodes: &[Node], relative: impl Iterator<Item = Frame>) -> Vec<Frame> {
    let mut frames: Vec<Frame> = Vec::with_capacity(nodes.len());
    for (node, relative) in nodes.iter().zip(relative) {
        frames.push(node.parent.map_or(relative, |p: usize| frames[p].times(&relative)));
    }
    frames
}

impl MovingFrame {
    /// Computes all matrices from q, v and the loads.
    pub fn assemble(model: &Model, q: &[f64], v: &[f64], loads: &Loads, variation: Variation) -> Self {
        let nodes = &model.tree.nodes;
        let relative: Vec<Frame> = nodes.iter().map(|node| node.kind.relative(&q[node.positions..])).collect();
        let frames = in_world(nodes, relative.iter().copied());
        let velocity = DVector::from_column_slice(v);
        let columns = blocks::joint_columns(&model.tree, &frames, q);
        let b = blocks::b_matrix(&model.tree, &frames, &columns);
        let x_dot = &b * &velocity;
        let column_rates = blocks::joint_column_rates(&model.tree, &columns, v, &x_dot);
        let b_dot = blocks::b_dot_matrix(&model.tree, &frames, &x_dot, &columns, &column_rates);
        let [m, m_dot] = blocks::mass_matrices(model, &frames, &x_dot, loads);
        let d = match variation {
            Variation::Restricted => blocks::d_blocks(model, &frames, &x_dot, loads),
            Variation::Naive => vec![Block::zeros(); frames.len()],
        };
        let momentum_rate = blocks::momentum_rate(&m, &m_dot, &d);
        let f = blocks::force_list(model, &frames, &columns, loads);

        let free = model.free_coordinates();
        let (b_free, b_dot_free) = (b.select_columns(&free), b_dot.select_columns(&free));
        let mut m_star = b_free.transpose() * m.times(&b_free);
        for (k, &i) in free.iter().enumerate() {
            m_star[(k, k)] += model.rotor_inertia[i];
        }
        let rate_of_momentum = m.times(&b_dot_free) + momentum_rate.times(&b_free);
        let n_star = b_free.transpose() * rate_of_momentum;
        let (given_velocity, given_acceleration) = prescribed(model, v, loads);
        let column = |x: DVector<f64>| DMatrix::from_column_slice(x.len(), 1, x.as_slice());
        let given = m.times(&column(&b * &given_acceleration + &b_dot * &given_velocity))
            + momentum_rate.times(&column(&b * given_velocity));
        let f_star = b_free.transpose() * (&f - given.column(0));
        let free_velocity = DVector::from_iterator(free.len(), free.iter().map(|&i| v[i]));
        let x_bias_acceleration = &b_dot * &velocity;
        let motion = loops::BodiesMotion {
            model,
            frames: &frames,
            b: &b,
            x_dot: &x_dot,
            x_bias_acceleration: &x_bias_acceleration,
        };
        let (j_all, own_bias_acceleration) = loops::rows(&motion, &loads.restraints);
        let acting = loads.restraints.iter().filter(|restraint| restraint.acts);
        let held_by = acting.map(|restraint| restraint.name.clone()).collect();
        let (j, j_dot_v) = (j_all.select_columns(&free), own_bias_acceleration + &j_all * &given_acceleration);
        Self {
            frames,
            relative,
            b,
            b_dot,
            x_dot,
            m: m.to_matrix(),
            m_dot: m_dot.to_matrix(),
            d: SparseBlocks { diagonal: d, beside: Vec::new() }.to_matrix(),
            f,
            m_star,
            n_star,
            f_star,
            free_velocity,
            free,
            given_acceleration,
            j,
            j_dot_v,
            held_by,
        }
    }

    /// M* and J over the free coordinates alone, without the matrices over all bodies: their size is that of the square of
    /// the number of bodies.
    pub fn mass_and_constraints(model: &Model, q: &[f64], v: &[f64], loads: &Loads) -> (DMatrix<f64>, DMatrix<f64>) {
        let nodes = &model.tree.nodes;
        let frames = in_world(nodes, nodes.iter().map(|node| node.kind.relative(&q[node.positions..])));
        let columns = blocks::joint_columns(&model.tree, &frames, q);
        let b = blocks::b_matrix(&model.tree, &frames, &columns);
        let (x_dot, free) = (&b * DVector::from_column_slice(v), model.free_coordinates());
        let b_free = b.select_columns(&free);
        let [m, _] = blocks::mass_matrices(model, &frames, &x_dot, loads);
        let mut m_star = b_free.transpose() * m.times(&b_free);
        for (k, &i) in free.iter().enumerate() {
            m_star[(k, k)] += model.rotor_inertia[i];
        }
        // J does not depend on the bias acceleration.
        let x_bias_acceleration = DVector::zeros(x_dot.len());
        let motion = loops::BodiesMotion {
            model,
            frames: &frames,
            b: &b,
            x_dot: &x_dot,
            x_bias_acceleration: &x_bias_acceleration,
        };
        (m_star, loops::rows(&motion, &loads.restraints).0.select_columns(&free))
    }

    /// The velocity terms N* q' (N, N m).
    pub fn bias_force(&self) -> DVector<f64> {
        &self.n_star * &self.free_velocity
    }

    /// q'' of the free coordinates from M* q'' = F* - N* q' (eq. 61), with closed loops from [`MovingFrame::solve`];
    /// `None` if the matrix is singular.
    pub fn acceleration(&self) -> Option<DVector<f64>> {
        self.solve().map(|(acceleration, _)| acceleration)
    }

    /// q'' of the free coordinates and the loops' multipliers lambda (N, N m), from
    ///
    /// ```text
    /// | M*  J^T | |  q''    |   | F* - N* q' |
    /// | J   0   | | -lambda | = | -J' q'     |
    /// ```
    ///
    /// `None` if the matrix is singular.
    pub fn solve(&self) -> Option<(DVector<f64>, DVector<f64>)> {
        let right = &self.f_star - self.bias_force();
        let (n, m) = (self.m_star.nrows(), self.j.nrows());
        if m == 0 {
            return Some((self.m_star.clone().cholesky()?.solve(&right), DVector::zeros(0)));
        }
        let mut bordered = DMatrix::zeros(n + m, n + m);
        bordered.view_mut((0, 0), (n, n)).copy_from(&self.m_star);
        bordered.view_mut((0, n), (n, m)).copy_from(&self.j.transpose());
        bordered.view_mut((n, 0), (m, n)).copy_from(&self.j);
        let both = DVector::from_iterator(n + m, right.iter().copied().chain(self.j_dot_v.iter().map(|rate| -rate)));
        let solution = bordered.lu().solve(&both)?;
        Some((solution.rows(0, n).into_owned(), -solution.rows(n, m).into_owned()))
    }

    /// J M*^-1 J^T, whose pivots show whether the loops' constraints are independent here; `None` if M* is singular.
    pub fn loop_matrix(&self) -> Option<DMatrix<f64>> {
        Some(&self.j * self.m_star.clone().cholesky()?.solve(&self.j.transpose()))
    }

    /// Omega (eq. 29) of a body: angular velocity in body axes and R^T x'.
    pub fn omega(&self, body: usize) -> (Vector3, Vector3) {
        let x_dot = blocks::x_dot_of(&self.x_dot, body);
        let angular = blocks::omega_of(&self.x_dot, body);
        (angular, self.frames[body].rotation.transpose_times(x_dot))
    }
}

/// Velocity and acceleration of the prescribed coordinates, zero elsewhere.
fn prescribed(model: &Model, v: &[f64], loads: &Loads) -> (DVector<f64>, DVector<f64>) {
    let given = |values: &[f64]| {
        let pick = |(mode, value): (&MotionType, &f64)| if *mode == MotionType::Prescribed { *value } else { 0.0 };
        DVector::from_iterator(values.len(), model.modes.iter().zip(values).map(pick))
    };
    (given(v), given(&loads.acceleration))
}
