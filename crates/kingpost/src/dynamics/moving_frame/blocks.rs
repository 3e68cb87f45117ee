//! The blocks of B, B', M, D and {F}.
//!
//! Rows of body a: x' of its centre of mass (world), then omega (its own axes). Columns: the coordinates of every joint
//! between the world and a. With c the joint's child body, `s` the vector from c to a in c's axes, R_ac = R_a^T R_c,
//! and (w, u) the joint's column of motion, that is c's twist per unit rate in c's axes:
//!
//! | joint of c | w | u | row x' | row omega |
//! | --- | --- | --- | --- | --- |
//! | any | | | R_c (u + w x s) | R_ac w |
//! | floating, translation | 0 | R_c^T | I | 0 |
//! | floating, rotation | I | 0 | R_c hat(s)^T | R_ac |
//! | revolute, axis e | e | e x s_C | R_c (e x (s + s_C)) | R_ac e |
//! | prismatic, axis e | 0 | e | R_c e | 0 |
//! | spherical | I | hat(s_C)^T | R_c hat(s + s_C)^T | R_ac |
//!
//! Joints of several axes have a column for each, carried to the child by the axes after it.

use super::Loads;
use super::sparse_blocks::{Block, SparseBlocks};
use crate::model::{JointKind, Model, Node, Tree, joint::Columns};
use crate::spatial::{CrossInertia, Frame, Matrix3, SpatialInertia, Twist, Vector3, Wrench, hat};
use nalgebra::{DMatrix, DVector};

/// x' of a body (world, m/s).
pub(super) fn x_dot_of(x_dot: &DVector<f64>, body: usize) -> Vector3 {
    Vector3::from_slice(&x_dot.as_slice()[6 * body..])
}

/// omega of a body (body axes, rad/s).
pub(super) fn omega_of(x_dot: &DVector<f64>, body: usize) -> Vector3 {
    Vector3::from_slice(&x_dot.as_slice()[6 * body + 3..])
}

fn set_column(out: &mut DMatrix<f64>, row: usize, column: usize, v: Vector3) {
    for i in 0..3 {
        out[(row + i, column)] = v[i];
    }
}

/// Calls `visit(a, c)` for every body a and every ancestor c of it, a included.
fn for_each_path(tree: &Tree, mut visit: impl FnMut(usize, usize)) {
    for a in 0..tree.nodes.len() {
        let mut next = Some(a);
        while let Some(c) = next {
            visit(a, c);
            next = tree.nodes[c].parent;
        }
    }
}

/// Columns of motion of each body's joint, body axes about its centre of mass.
pub(super) fn joint_columns(tree: &Tree, frames: &[Frame], q: &[f64]) -> Vec<Columns> {
    tree.nodes.iter().zip(frames).map(|(node, frame)| node.kind.columns(&q[node.positions..], frame)).collect()
}

/// Their rates.
pub(super) fn joint_column_rates(tree: &Tree, columns: &[Columns], v: &[f64], x_dot: &DVector<f64>) -> Vec<Columns> {
    let rates = |(c, columns)| {
        let node: &Node = &tree.nodes[c];
        node.kind.column_rates(columns, &v[node.velocities..], omega_of(x_dot, c))
    };
    columns.iter().enumerate().map(rates).collect()
}

/// B (eq. 46a, as corrected).
pub(super) fn b_matrix(tree: &Tree, frames: &[Frame], columns: &[Columns]) -> DMatrix<f64> {
    let mut b = DMatrix::zeros(6 * tree.nodes.len(), tree.velocity_count());
    for_each_path(tree, |a, c| {
        let r_c = frames[c].rotation;
        let s = r_c.transpose_times(frames[a].position - frames[c].position);
        let r_ac = frames[a].rotation.transpose() * r_c;
        for (k, Twist { angular, linear }) in columns[c].iter().enumerate() {
            let (row, column) = (6 * a, tree.nodes[c].velocities + k);
            set_column(&mut b, row, column, r_c * (*linear + angular.cross(s)));
            set_column(&mut b, row + 3, column, r_ac * *angular);
        }
    });
    b
}

/// B', from R' = R hat(omega) (eq. 62) in every block.
pub(super) fn b_dot_matrix(
    tree: &Tree,
    frames: &[Frame],
    x_dot: &DVector<f64>,
    columns: &[Columns],
    column_rates: &[Columns],
) -> DMatrix<f64> {
    let mut b_dot = DMatrix::zeros(6 * tree.nodes.len(), tree.velocity_count());
    for_each_path(tree, |a, c| {
        let (r_c, omega_c) = (frames[c].rotation, omega_of(x_dot, c));
        let s = r_c.transpose_times(frames[a].position - frames[c].position);
        let s_dot = r_c.transpose_times(x_dot_of(x_dot, a) - x_dot_of(x_dot, c)) - omega_c.cross(s);
        let r_ac = frames[a].rotation.transpose() * r_c;
        let omega_of_c_in_a = r_ac * omega_c - omega_of(x_dot, a);
        for (k, (own, rate)) in columns[c].iter().zip(column_rates[c].iter()).enumerate() {
            let (row, column) = (6 * a, tree.nodes[c].velocities + k);
            let turned = omega_c.cross(own.linear + own.angular.cross(s));
            let moved = rate.linear + rate.angular.cross(s) + own.angular.cross(s_dot);
            set_column(&mut b_dot, row, column, r_c * (turned + moved));
            set_column(&mut b_dot, row + 3, column, omega_of_c_in_a.cross(r_ac * own.angular) + r_ac * rate.angular);
        }
    });
    b_dot
}

/// Inertia of each body with the added inertia of the loads.
fn inertias(model: &Model, loads: &Loads) -> Vec<SpatialInertia> {
    let mut all: Vec<SpatialInertia> = model.tree.nodes.iter().map(|node| node.inertia).collect();
    for (body, added) in &loads.added_inertia {
        all[*body] += *added;
    }
    all
}

/// A body's block of M (eq. 48), and its rate: x' in the world first, then omega in its own axes.
fn mass_block(inertia: &SpatialInertia, rotation: &Matrix3, omega: Vector3) -> [Block; 2] {
    let (mut m, mut m_dot) = (Block::zeros(), Block::zeros());
    put(&mut m, 3, 3, &inertia.angular.to_matrix());
    if inertia.is_rigid_about_centre_of_mass() {
        put(&mut m, 0, 0, &inertia.linear.to_matrix());
        return [m, m_dot];
    }
    let (r, r_t, skew) = (*rotation, rotation.transpose(), hat(omega));
    let (linear, coupling) = (inertia.linear.to_matrix(), inertia.coupling);
    put(&mut m, 0, 0, &(r * linear * r_t));
    put(&mut m, 0, 3, &(r * coupling.transpose()));
    put(&mut m, 3, 0, &(coupling * r_t));
    put(&mut m_dot, 0, 0, &(r * (skew * linear - linear * skew) * r_t));
    put(&mut m_dot, 0, 3, &(r * skew * coupling.transpose()));
    put(&mut m_dot, 3, 0, &-(coupling * skew * r_t));
    [m, m_dot]
}

fn put(block: &mut Block, row: usize, column: usize, entries: &Matrix3) {
    for (i, row_of) in entries.0.iter().enumerate() {
        for (j, entry) in row_of.iter().enumerate() {
            block[(row + i, column + j)] = *entry;
        }
    }
}

/// The block of M in the rows of the first of two bodies with inertia between them, and its rate: `G_1 C G_2^T` with `G =
/// diag(R, I)`, forces first.
fn cross_block(inertia: &CrossInertia, rotations: [&Matrix3; 2], omegas: [Vector3; 2]) -> [Block; 2] {
    let ([r, s], [skew, other_skew]) = (rotations, omegas.map(hat));
    let (s_t, linear) = (s.transpose(), inertia.linear);
    let (mut m, mut m_dot) = (Block::zeros(), Block::zeros());
    put(&mut m, 0, 0, &(*r * linear * s_t));
    put(&mut m, 0, 3, &(*r * inertia.force_by_turning));
    put(&mut m, 3, 0, &(inertia.moment_by_velocity * s_t));
    put(&mut m, 3, 3, &inertia.angular);
    put(&mut m_dot, 0, 0, &(*r * (skew * linear - linear * other_skew) * s_t));
    put(&mut m_dot, 0, 3, &(*r * skew * inertia.force_by_turning));
    put(&mut m_dot, 3, 0, &-(inertia.moment_by_velocity * other_skew * s_t));
    [m, m_dot]
}

/// M (eq. 48) and its rate.
pub(super) fn mass_matrices(model: &Model, frames: &[Frame], x_dot: &DVector<f64>, loads: &Loads) -> [SparseBlocks; 2] {
    let inertias = inertias(model, loads);
    let of =
        |(body, inertia): (usize, &SpatialInertia)| mass_block(inertia, &frames[body].rotation, omega_of(x_dot, body));
    let own: Vec<[Block; 2]> = inertias.iter().enumerate().map(of).collect();
    let between = loads.added_inertia_between.iter().flat_map(|([first, second], inertia)| {
        let rotations = [*first, *second].map(|body| &frames[body].rotation);
        let blocks = cross_block(inertia, rotations, [*first, *second].map(|body| omega_of(x_dot, body)));
        let mirrored = blocks.map(|block| block.transpose());
        [(*first, *second, blocks), (*second, *first, mirrored)]
    });
    let between: Vec<(usize, usize, [Block; 2])> = between.collect();
    [0, 1].map(|k| SparseBlocks {
        diagonal: own.iter().map(|blocks| blocks[k]).collect(),
        beside: between.iter().map(|(row, column, blocks)| (*row, *column, blocks[k])).collect(),
    })
}

/// M' + D M, the rate of the momentum per velocity.
pub(super) fn momentum_rate(m: &SparseBlocks, m_dot: &SparseBlocks, d: &[Block]) -> SparseBlocks {
    let own = d.iter().zip(&m.diagonal).zip(&m_dot.diagonal).map(|((d, m), m_dot)| m_dot + d * m);
    let beside = m.beside.iter().zip(&m_dot.beside);
    let beside = beside.map(|((row, column, m), (_, _, m_dot))| (*row, *column, m_dot + d[*row] * m));
    SparseBlocks { diagonal: own.collect(), beside: beside.collect() }
}

/// The blocks of D (eq. 57), by body: diag(0, hat(omega)), and below it `R^T hat(x')` where the inertia is not that of a
/// rigid body.
pub(super) fn d_blocks(model: &Model, frames: &[Frame], x_dot: &DVector<f64>, loads: &Loads) -> Vec<Block> {
    let is_coupled = |body: usize| loads.added_inertia_between.iter().any(|(bodies, _)| bodies.contains(&body));
    let of = |(body, inertia): (usize, &SpatialInertia)| {
        let mut d = Block::zeros();
        put(&mut d, 3, 3, &hat(omega_of(x_dot, body)));
        if !inertia.is_rigid_about_centre_of_mass() || is_coupled(body) {
            put(&mut d, 3, 0, &(frames[body].rotation.transpose() * hat(x_dot_of(x_dot, body))));
        }
        d
    };
    inertias(model, loads).iter().enumerate().map(of).collect()
}

/// {F} (eq. 59): by body, force in the world, moment in body axes. A force along a coordinate acts
/// on the child and, reversed, on the parent.
pub(super) fn force_list(model: &Model, frames: &[Frame], columns: &[Columns], loads: &Loads) -> DVector<f64> {
    let mut f = DVector::zeros(6 * frames.len());
    for (body, wrench) in &loads.wrenches {
        add(&mut f, *body, frames[*body].rotation * wrench.force, wrench.moment);
    }
    for (i, body) in model.bodies.iter().enumerate() {
        if let Some(weight) = loads.weight(body.mass) {
            add(&mut f, i, weight, Vector3::zero());
        }
    }
    for (body, node) in model.tree.nodes.iter().enumerate() {
        let tau = &loads.force[node.velocities..][..node.kind.velocity_count()];
        if let JointKind::Floating(_) = node.kind {
            add(&mut f, body, Vector3::from_slice(tau), Vector3::from_slice(&tau[3..]));
            continue;
        }
        let frame = &frames[body];
        let Wrench { moment, force } = joint_wrench(&columns[body], tau, node.kind.to_child());
        let (moment_in_world, force) = (frame.rotation * moment, frame.rotation * force);
        let to_child = frame.rotation * node.kind.to_child();
        add(&mut f, body, force, frame.rotation.transpose_times(moment_in_world - to_child.cross(force)));
        if let Some(parent) = node.parent {
            let lever = frame.position - to_child - frames[parent].position;
            let moment = moment_in_world + lever.cross(force);
            add(&mut f, parent, -force, -frames[parent].rotation.transpose_times(moment));
        }
    }
    f
}

/// The smallest wrench at a joint with these generalized forces: `S (S^T S)^-1 tau` with the columns S about the joint,
/// child axes.
fn joint_wrench(columns: &Columns, tau: &[f64], to_child: Vector3) -> Wrench {
    let at_joint = |twist: &Twist| {
        let Twist { angular, linear } = twist;
        let linear = *linear - angular.cross(to_child);
        [angular.0, linear.0].concat()
    };
    let s = DMatrix::from_iterator(6, columns.len(), columns.iter().flat_map(at_joint));
    let gram = (s.transpose() * &s).cholesky();
    let wrench = gram.map_or(DVector::zeros(6), |gram| &s * gram.solve(&DVector::from_column_slice(tau)));
    Wrench { moment: Vector3::from_slice(wrench.as_slice()), force: Vector3::from_slice(&wrench.as_slice()[3..]) }
}

fn add(f: &mut DVector<f64>, body: usize, force: Vector3, moment: Vector3) {
    for i in 0..3 {
        f[6 * body + i] += force[i];
        f[6 * body + 3 + i] += moment[i];
    }
}
