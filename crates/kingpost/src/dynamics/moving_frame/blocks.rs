//! The blocks of B, B', M, D and {F}.
//!
//! Rows of body a: x' of its centre of mass (world), then omega (its own axes). Columns: the
//! coordinates of every joint on the way from the world to a. With c the joint's child body,
//! `s` the way from c to a in c's axes, and R_ac = R_a^T R_c:
//!
//! | joint of c | row x' | row omega |
//! | --- | --- | --- |
//! | floating, translation | I | 0 |
//! | floating, rotation | R_c hat(s)^T | R_ac |
//! | revolute, axis e | R_c (e x (s + s_C)) | R_ac e |
//! | prismatic, axis e | R_c e | 0 |

use super::Loads;
use crate::model::{JointKind, Model, Tree};
use crate::spatial::{Frame, Matrix3, SpatialInertia, Vector3, hat};
use nalgebra::{DMatrix, DVector};

/// x' of a body (world, m/s).
pub(super) fn x_dot_of(x_dot: &DVector<f64>, body: usize) -> Vector3 {
    Vector3::from_slice(&x_dot.as_slice()[6 * body..])
}

/// omega of a body (body axes, rad/s).
pub(super) fn omega_of(x_dot: &DVector<f64>, body: usize) -> Vector3 {
    Vector3::from_slice(&x_dot.as_slice()[6 * body + 3..])
}

fn set_matrix(out: &mut DMatrix<f64>, row: usize, column: usize, block: &Matrix3) {
    for i in 0..3 {
        set_column_entry(out, row + i, column, block.0[i]);
    }
}

fn set_column_entry(out: &mut DMatrix<f64>, row: usize, column: usize, entries: [f64; 3]) {
    for (j, entry) in entries.into_iter().enumerate() {
        out[(row, column + j)] = entry;
    }
}

fn set_column(out: &mut DMatrix<f64>, row: usize, column: usize, v: Vector3) {
    for i in 0..3 {
        out[(row + i, column)] = v[i];
    }
}

/// Calls `visit(a, c)` for every body a and every body c on its way to the world, a included.
fn for_each_path(tree: &Tree, mut visit: impl FnMut(usize, usize)) {
    for a in 0..tree.nodes.len() {
        let mut next = Some(a);
        while let Some(c) = next {
            visit(a, c);
            next = tree.nodes[c].parent;
        }
    }
}

/// B (eq. 46a, as corrected).
pub(super) fn b_matrix(tree: &Tree, frames: &[Frame]) -> DMatrix<f64> {
    let mut b = DMatrix::zeros(6 * tree.nodes.len(), coordinate_count(tree));
    for_each_path(tree, |a, c| {
        let (row, column) = (6 * a, tree.nodes[c].velocities);
        let r_c = frames[c].rotation;
        let s = r_c.transpose_times(frames[a].position - frames[c].position);
        let r_ac = frames[a].rotation.transpose() * r_c;
        match &tree.nodes[c].kind {
            JointKind::Floating(_) => {
                set_matrix(&mut b, row, column, &Matrix3::identity());
                set_matrix(&mut b, row, column + 3, &(r_c * hat(s).transpose()));
                set_matrix(&mut b, row + 3, column + 3, &r_ac);
            }
            JointKind::Revolute(joint) => {
                set_column(&mut b, row, column, r_c * joint.axis().cross(s + joint.to_child()));
                set_column(&mut b, row + 3, column, r_ac * joint.axis());
            }
            JointKind::Prismatic(joint) => set_column(&mut b, row, column, r_c * joint.axis()),
            JointKind::Fixed(_) => {}
        }
    });
    b
}

/// B', from R' = R hat(omega) (eq. 62) in every block.
pub(super) fn b_dot_matrix(tree: &Tree, frames: &[Frame], x_dot: &DVector<f64>) -> DMatrix<f64> {
    let mut b_dot = DMatrix::zeros(6 * tree.nodes.len(), coordinate_count(tree));
    for_each_path(tree, |a, c| {
        let (row, column) = (6 * a, tree.nodes[c].velocities);
        let (r_c, omega_c) = (frames[c].rotation, omega_of(x_dot, c));
        let s = r_c.transpose_times(frames[a].position - frames[c].position);
        let s_dot = r_c.transpose_times(x_dot_of(x_dot, a) - x_dot_of(x_dot, c)) - omega_c.cross(s);
        let r_ac = frames[a].rotation.transpose() * r_c;
        let omega_of_c_in_a = r_ac * omega_c - omega_of(x_dot, a);
        match &tree.nodes[c].kind {
            JointKind::Floating(_) => {
                let rate = hat(omega_c) * hat(s).transpose() + hat(s_dot).transpose();
                set_matrix(&mut b_dot, row, column + 3, &(r_c * rate));
                set_matrix(&mut b_dot, row + 3, column + 3, &(hat(omega_of_c_in_a) * r_ac));
            }
            JointKind::Revolute(joint) => {
                let (axis, lever) = (joint.axis(), s + joint.to_child());
                let rate = omega_c.cross(axis.cross(lever)) + axis.cross(s_dot);
                set_column(&mut b_dot, row, column, r_c * rate);
                set_column(&mut b_dot, row + 3, column, omega_of_c_in_a.cross(r_ac * axis));
            }
            JointKind::Prismatic(joint) => {
                set_column(&mut b_dot, row, column, r_c * omega_c.cross(joint.axis()));
            }
            JointKind::Fixed(_) => {}
        }
    });
    b_dot
}

fn coordinate_count(tree: &Tree) -> usize {
    tree.nodes.last().map_or(0, |node| node.velocities + node.kind.velocity_count())
}

/// Inertia of each body with what the loads add to it.
fn inertias(model: &Model, loads: &Loads) -> Vec<SpatialInertia> {
    let mut all: Vec<SpatialInertia> = model.tree.nodes.iter().map(|node| node.inertia).collect();
    for (body, added) in &loads.added_inertia {
        all[*body] += *added;
    }
    all
}

/// M (eq. 48) and its rate.
pub(super) fn mass_matrices(
    model: &Model,
    frames: &[Frame],
    x_dot: &DVector<f64>,
    loads: &Loads,
) -> (DMatrix<f64>, DMatrix<f64>) {
    let n = 6 * frames.len();
    let (mut m, mut m_dot) = (DMatrix::zeros(n, n), DMatrix::zeros(n, n));
    for (body, inertia) in inertias(model, loads).iter().enumerate() {
        let (at, angular) = (6 * body, inertia.angular.to_matrix());
        set_matrix(&mut m, at + 3, at + 3, &angular);
        if inertia.is_rigid_about_centre_of_mass() {
            set_matrix(&mut m, at, at, &inertia.linear.to_matrix());
            continue;
        }
        let (r, r_t, skew) = (frames[body].rotation, frames[body].rotation.transpose(), hat(omega_of(x_dot, body)));
        let (linear, coupling) = (inertia.linear.to_matrix(), inertia.coupling);
        set_matrix(&mut m, at, at, &(r * linear * r_t));
        set_matrix(&mut m, at, at + 3, &(r * coupling.transpose()));
        set_matrix(&mut m, at + 3, at, &(coupling * r_t));
        set_matrix(&mut m_dot, at, at, &(r * (skew * linear - linear * skew) * r_t));
        set_matrix(&mut m_dot, at, at + 3, &(r * skew * coupling.transpose()));
        set_matrix(&mut m_dot, at + 3, at, &-(coupling * skew * r_t));
    }
    (m, m_dot)
}

/// D (eq. 57): diag(0, hat(omega)) by body, and for a full 6x6 inertia `R^T hat(x')` below it.
pub(super) fn d_matrix(model: &Model, frames: &[Frame], x_dot: &DVector<f64>, loads: &Loads) -> DMatrix<f64> {
    let n = 6 * frames.len();
    let mut d = DMatrix::zeros(n, n);
    for (body, inertia) in inertias(model, loads).iter().enumerate() {
        let at = 6 * body;
        set_matrix(&mut d, at + 3, at + 3, &hat(omega_of(x_dot, body)));
        if !inertia.is_rigid_about_centre_of_mass() {
            let block = frames[body].rotation.transpose() * hat(x_dot_of(x_dot, body));
            set_matrix(&mut d, at + 3, at, &block);
        }
    }
    d
}

/// {F} (eq. 59): by body, force in the world, moment in body axes. A force along a coordinate acts
/// on the child and, reversed, on the parent.
pub(super) fn force_list(model: &Model, frames: &[Frame], loads: &Loads) -> DVector<f64> {
    let mut f = DVector::zeros(6 * frames.len());
    for (body, wrench) in &loads.wrenches {
        add(&mut f, *body, frames[*body].rotation * wrench.force, wrench.moment);
    }
    for (body, node) in model.tree.nodes.iter().enumerate() {
        let tau = &loads.force[node.velocities..];
        match &node.kind {
            JointKind::Floating(_) => add(&mut f, body, Vector3::from_slice(tau), Vector3::from_slice(&tau[3..])),
            JointKind::Revolute(joint) => {
                let moment = joint.axis() * tau[0];
                add(&mut f, body, Vector3::zero(), moment);
                if let Some(parent) = node.parent {
                    let in_parent = frames[parent].rotation.transpose_times(frames[body].rotation * moment);
                    add(&mut f, parent, Vector3::zero(), -in_parent);
                }
            }
            JointKind::Prismatic(joint) => {
                let force = frames[body].rotation * (joint.axis() * tau[0]);
                add(&mut f, body, force, Vector3::zero());
                if let Some(parent) = node.parent {
                    let lever = frames[body].position - frames[parent].position;
                    add(&mut f, parent, -force, frames[parent].rotation.transpose_times(lever.cross(-force)));
                }
            }
            JointKind::Fixed(_) => {}
        }
    }
    f
}

fn add(f: &mut DVector<f64>, body: usize, force: Vector3, moment: Vector3) {
    for i in 0..3 {
        f[6 * body + i] += force[i];
        f[6 * body + 3 + i] += moment[i];
    }
}
