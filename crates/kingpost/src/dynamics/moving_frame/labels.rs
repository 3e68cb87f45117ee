//! The matrices by name, with labels and units, for printing and for other languages.

use super::MovingFrame;
use crate::model::{Constraint, Model, MotionType};
use crate::spatial::{Frame, hat};
use nalgebra::{DMatrix, DVector};
use serde::Serialize;

/// A labelled matrix; `data` by rows.
///
/// A matrix maps a list in the units of its columns to one in the units of its rows, so each entry has its row's unit
/// over its column's: M* (row N m, column rad/s^2) has kg m^2.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct NamedMatrix {
    /// Name, as in the paper: `B`, `M_star`, `E_tower/ship`.
    pub name: String,
    /// One label per row.
    pub row_labels: Vec<String>,
    /// One label per column; a list has a single label.
    pub column_labels: Vec<String>,
    /// One SI unit per row.
    pub row_units: Vec<&'static str>,
    /// One SI unit per column; `1` for a list.
    pub column_units: Vec<&'static str>,
    /// Entries by rows.
    pub data: Vec<f64>,
}

const AXES: [&str; 3] = ["x", "y", "z"];

/// The labels and units of the rows or columns of a matrix.
struct MatrixSide {
    labels: Vec<String>,
    units: Vec<&'static str>,
}

/// Units of translations and of rotations: rates, loads, ...
type Units = [&'static str; 2];

const DISPLACEMENTS: Units = ["m", "rad"];
const RATES: Units = ["m/s", "rad/s"];
const ACCELERATIONS: Units = ["m/s^2", "rad/s^2"];
const LOADS: Units = ["N", "N m"];

impl MovingFrame {
    /// Every matrix with its labels and units, in the order of the theory.
    pub fn named(&self, model: &Model) -> Vec<NamedMatrix> {
        let bodies = |units: Units| MatrixSide { labels: body_labels(model), units: body_units(model, units) };
        let (names, turning) = (model.coordinate_names(), model.turning_coordinates());
        let coordinates = |units: Units, which: &[usize]| MatrixSide {
            labels: which.iter().map(|&i| names[i].clone()).collect(),
            units: which.iter().map(|&i| units[usize::from(turning[i])]).collect(),
        };
        let every: Vec<usize> = (0..names.len()).collect();
        let all_rates = coordinates(RATES, &every);
        let free = |units: Units| coordinates(units, &self.free);
        let mut all = self.frame_matrices(model);
        all.push(named("B", &bodies(RATES), &all_rates, &self.b));
        all.push(named("B_dot", &bodies(ACCELERATIONS), &all_rates, &self.b_dot));
        all.push(list("X_dot", &bodies(RATES), "rate", &self.x_dot));
        all.push(named("M", &bodies(LOADS), &bodies(ACCELERATIONS), &self.m));
        all.push(named("D", &bodies(RATES), &bodies(DISPLACEMENTS), &self.d));
        all.push(list("F", &bodies(LOADS), "load", &self.f));
        all.push(list("q_dot", &free(RATES), "rate", &self.free_velocity));
        all.push(named("M_star", &free(LOADS), &free(ACCELERATIONS), &self.m_star));
        all.push(named("N_star", &free(LOADS), &free(RATES), &self.n_star));
        all.push(list("F_star", &free(LOADS), "load", &self.f_star));
        if model.modes.contains(&MotionType::Prescribed) {
            let every = coordinates(ACCELERATIONS, &every);
            all.push(list("q_ddot_given", &every, "acceleration", &self.given_acceleration));
        }
        if self.j.nrows() > 0 {
            all.push(named("J", &self.constraint_rates(model), &free(RATES), &self.j));
        }
        all
    }

    /// `hook.x`, ...: the rates of the closed loops' constraints, followed by the paths of ropes.
    fn constraint_rates(&self, model: &Model) -> MatrixSide {
        let constraints = || model.loops.iter().flat_map(|tie| tie.constraints.iter().map(move |each| (tie, each)));
        let unit = |turns: bool| RATES[usize::from(turns)];
        let of_loops = constraints().map(|(tie, (name, _))| format!("{}.{name}", tie.name));
        let units_of_loops = constraints().map(|(_, (_, of))| unit(matches!(of, Constraint::Perpendicular { .. })));
        MatrixSide {
            labels: of_loops.chain(self.held_by.iter().map(|name| format!("{name}.length"))).collect(),
            units: units_of_loops.chain(self.held_by.iter().map(|_| unit(false))).collect(),
        }
    }

    /// E, R, relative E and Omega of each body.
    fn frame_matrices(&self, model: &Model) -> Vec<NamedMatrix> {
        let axes = MatrixSide { labels: AXES.map(str::to_owned).to_vec(), units: vec!["1"; 3] };
        let homogeneous = |unit: &'static str, last: &'static str| MatrixSide {
            labels: AXES.iter().chain(&["1"]).map(|s| (*s).to_owned()).collect(),
            units: vec![unit, unit, unit, last],
        };
        let points = homogeneous("m", "1");
        let mut all = Vec::new();
        for (i, body) in model.bodies.iter().enumerate() {
            let frame = &self.frames[i];
            let rotation = DMatrix::from_fn(3, 3, |r, c| frame.rotation.0[r][c]);
            all.push(named(&format!("R_{}", body.name), &axes, &axes, &rotation));
            all.push(named(&format!("E_{}", body.name), &points, &points, &homogeneous_of(frame)));
            if let Some(parent) = model.tree.nodes[i].parent {
                let name = format!("E_{}/{}", body.name, model.bodies[parent].name);
                all.push(named(&name, &points, &points, &homogeneous_of(&self.relative[i])));
            }
            let (angular, linear) = self.omega(i);
            let skew = hat(angular);
            let omega = DMatrix::from_fn(4, 4, |r, c| match (r, c) {
                (3, _) => 0.0,
                (_, 3) => linear[r],
                _ => skew.0[r][c],
            });
            all.push(named(&format!("Omega_{}", body.name), &homogeneous("m/s", "1/s"), &points, &omega));
        }
        all
    }
}

fn body_units(model: &Model, [linear, angular]: Units) -> Vec<&'static str> {
    model.bodies.iter().flat_map(|_| [linear, linear, linear, angular, angular, angular]).collect()
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

fn named(name: &str, rows: &MatrixSide, columns: &MatrixSide, m: &DMatrix<f64>) -> NamedMatrix {
    NamedMatrix {
        name: name.to_owned(),
        row_labels: rows.labels.clone(),
        column_labels: columns.labels.clone(),
        row_units: rows.units.clone(),
        column_units: columns.units.clone(),
        data: m.transpose().as_slice().to_vec(),
    }
}

/// A list: a matrix of one column.
fn list(name: &str, rows: &MatrixSide, what: &str, entries: &DVector<f64>) -> NamedMatrix {
    let column = MatrixSide { labels: vec![what.to_owned()], units: vec!["1"] };
    named(name, rows, &column, &DMatrix::from_column_slice(entries.len(), 1, entries.as_slice()))
}
