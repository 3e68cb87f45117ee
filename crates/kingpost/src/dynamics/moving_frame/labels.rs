//! The matrices by name, with labels and units, for printing and for other languages.

use super::MovingFrame;
use crate::model::Model;
use crate::spatial::{Frame, hat};
use nalgebra::{DMatrix, DVector};

/// A labelled matrix; `data` by rows.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedMatrix {
    /// As in the paper: `B`, `M_star`, `E_tower/ship`.
    pub name: String,
    /// One label a row.
    pub row_labels: Vec<String>,
    /// One label a column; a column list has the single label of what it is.
    pub column_labels: Vec<String>,
    /// Unit of the entries; where rows or columns differ, what the entries are made of.
    pub unit: &'static str,
    /// Entries by rows.
    pub data: Vec<f64>,
}

const AXES: [&str; 3] = ["x", "y", "z"];
const MIXED: &str = "SI by row and column";

impl MovingFrame {
    /// Every matrix with its labels, in the order of the theory.
    pub fn named(&self, model: &Model) -> Vec<NamedMatrix> {
        let mut all = self.frame_matrices(model);
        let bodies = body_labels(model);
        let coordinates = model.coordinate_names();
        let free: Vec<String> = self.free.iter().map(|&i| coordinates[i].clone()).collect();
        let column = |label: &str| vec![label.to_owned()];
        let list = |v: &DVector<f64>| DMatrix::from_column_slice(v.len(), 1, v.as_slice());
        all.push(named("B", &bodies, &coordinates, MIXED, &self.b));
        all.push(named("B_dot", &bodies, &coordinates, MIXED, &self.b_dot));
        all.push(named("X_dot", &bodies, &column("rate"), "m/s, rad/s", &list(&self.x_dot)));
        all.push(named("M", &bodies, &bodies, "kg, kg m, kg m^2", &self.m));
        all.push(named("D", &bodies, &bodies, "rad/s, m/s", &self.d));
        all.push(named("F", &bodies, &column("load"), "N, N m", &list(&self.f)));
        all.push(named("q_dot", &free, &column("rate"), "m/s, rad/s", &list(&self.free_velocity)));
        all.push(named("M_star", &free, &free, "kg, kg m, kg m^2", &self.m_star));
        all.push(named("N_star", &free, &free, "kg/s, kg m/s, kg m^2/s", &self.n_star));
        all.push(named("F_star", &free, &column("load"), "N, N m", &list(&self.f_star)));
        all
    }

    /// E, R, relative E and Omega of each body.
    fn frame_matrices(&self, model: &Model) -> Vec<NamedMatrix> {
        let axes: Vec<String> = AXES.iter().map(|s| (*s).to_owned()).collect();
        let homogeneous: Vec<String> = AXES.iter().chain(&["1"]).map(|s| (*s).to_owned()).collect();
        let mut all = Vec::new();
        for (i, body) in model.bodies.iter().enumerate() {
            let frame = &self.frames[i];
            let rotation = DMatrix::from_fn(3, 3, |r, c| frame.rotation.0[r][c]);
            all.push(named(&format!("R_{}", body.name), &axes, &axes, "1", &rotation));
            all.push(named(&format!("E_{}", body.name), &homogeneous, &homogeneous, "1, m", &homogeneous_of(frame)));
            if let Some(parent) = model.tree.nodes[i].parent {
                let name = format!("E_{}/{}", body.name, model.bodies[parent].name);
                all.push(named(&name, &homogeneous, &homogeneous, "1, m", &homogeneous_of(&self.relative[i])));
            }
            let (angular, linear) = self.omega(i);
            let skew = hat(angular);
            let omega = DMatrix::from_fn(4, 4, |r, c| match (r, c) {
                (3, _) => 0.0,
                (_, 3) => linear[r],
                _ => skew.0[r][c],
            });
            all.push(named(&format!("Omega_{}", body.name), &homogeneous, &homogeneous, "rad/s, m/s", &omega));
        }
        all
    }
}

/// `ship.x_dot`, ..., `ship.omega_z`, body by body.
fn body_labels(model: &Model) -> Vec<String> {
    let rows = |name: &str| {
        let linear = AXES.map(|axis| format!("{name}.{axis}_dot"));
        let angular = AXES.map(|axis| format!("{name}.omega_{axis}"));
        linear.into_iter().chain(angular).collect::<Vec<_>>()
    };
    model.bodies.iter().flat_map(|body| rows(&body.name)).collect()
}

fn homogeneous_of(frame: &Frame) -> DMatrix<f64> {
    DMatrix::from_fn(4, 4, |r, c| match (r, c) {
        (3, 3) => 1.0,
        (3, _) => 0.0,
        (_, 3) => frame.position[r],
        _ => frame.rotation.0[r][c],
    })
}

fn named(name: &str, rows: &[String], columns: &[String], unit: &'static str, m: &DMatrix<f64>) -> NamedMatrix {
    NamedMatrix {
        name: name.to_owned(),
        row_labels: rows.to_vec(),
        column_labels: columns.to_vec(),
        unit,
        data: m.transpose().as_slice().to_vec(),
    }
}
