//! J and J' q' of the closed loops, from B and B' by the product rule in world axes.
//!
//! An attachment with the lever r on its body moves with `x' + R hat(r)^T omega`: three rows of J
//! over all coordinates, and three more for its angular velocity. `dynamics::loops` finds the same
//! rows as wrenches, in other axes.

use super::blocks::{omega_of, x_dot_of};
use crate::dynamics::TemporaryConstraint;
use crate::model::{Attachment, Constraint, Model};
use crate::spatial::{Frame, Twist, Vector3};
use nalgebra::{DMatrix, DVector, RowDVector};

/// The data of the rows.
pub(super) struct BodiesMotion<'a> {
    pub model: &'a Model,
    pub frames: &'a [Frame],
    pub b: &'a DMatrix<f64>,
    pub x_dot: &'a DVector<f64>,
    /// B' q'.
    pub x_bias_acceleration: &'a DVector<f64>,
}

/// J over all coordinates, and J' q': of the loops, then of the active restraints.
pub(super) fn rows(motion: &BodiesMotion<'_>, restraints: &[TemporaryConstraint]) -> (DMatrix<f64>, DVector<f64>) {
    let constraints = motion.model.loops.iter().flat_map(|closed| {
        let (first, second) = (motion.point(&closed.first), motion.point(&closed.second));
        closed.constraints.iter().map(move |(_, constraint)| row(&first, &second, constraint)).collect::<Vec<_>>()
    });
    let held = restraints.iter().filter(|restraint| restraint.acts).map(|restraint| motion.held(restraint));
    let (rows, bias): (Vec<RowDVector<f64>>, Vec<f64>) = constraints.chain(held).unzip();
    let j = if rows.is_empty() { DMatrix::zeros(0, motion.b.ncols()) } else { DMatrix::from_rows(&rows) };
    (j, DVector::from_vec(bias))
}

/// An attachment in the world.
#[derive(Clone)]
struct MovingAttachment {
    frame: Frame,
    velocity: Vector3,
    omega: Vector3,
    /// The parts of its accelerations that do not come from q''.
    acceleration: Vector3,
    alpha: Vector3,
    /// Velocity per coordinate: three rows.
    linear: DMatrix<f64>,
    /// Angular velocity per coordinate: three rows.
    angular: DMatrix<f64>,
}

impl BodiesMotion<'_> {
    /// The row of a restraint, and its share of J' q'.
    fn held(&self, restraint: &TemporaryConstraint) -> (RowDVector<f64>, f64) {
        let rotation = |body: usize| self.frames[body].rotation;
        let in_body = |x: &DVector<f64>, body: usize| Twist {
            angular: omega_of(x, body),
            linear: rotation(body).transpose_times(x_dot_of(x, body)),
        };
        let none = vec![0.0; self.b.ncols()];
        let row = (0..self.b.ncols()).map(|k| {
            let (column, mut rates) = (self.b.column(k).into_owned(), none.clone());
            rates[k] = 1.0;
            restraint.times(|body| in_body(&column, body), &rates)
        });
        let row = RowDVector::from_iterator(self.b.ncols(), row);
        // The acceleration of a point, less omega x its velocity, is the linear part of the twist's rate.
        let spatial = |body: usize| {
            let (own, rate) = (in_body(self.x_dot, body), in_body(self.x_bias_acceleration, body));
            Twist { linear: rate.linear - own.angular.cross(own.linear), ..rate }
        };
        (row, restraint.times(spatial, &none) + restraint.bias_acceleration)
    }

    fn point(&self, attachment: &Attachment) -> MovingAttachment {
        let none = DMatrix::zeros(3, self.b.ncols());
        let Some(body) = attachment.body else {
            let [velocity, omega, acceleration, alpha] = [Vector3::zero(); 4];
            let frame = attachment.in_body;
            return MovingAttachment {
                frame,
                velocity,
                omega,
                acceleration,
                alpha,
                linear: none.clone(),
                angular: none,
            };
        };
        let (frame, rotation) = (self.frames[body], self.frames[body].rotation);
        let lever = rotation * attachment.in_body.position;
        let omega = rotation * omega_of(self.x_dot, body);
        let alpha = rotation * omega_of(self.x_bias_acceleration, body);
        let (mut linear, mut angular) = (none.clone(), none);
        for k in 0..self.b.ncols() {
            let entry = |row: usize| Vector3(core::array::from_fn(|i| self.b[(6 * body + row + i, k)]));
            let turning = rotation * entry(3);
            let moving = entry(0) + turning.cross(lever);
            for i in 0..3 {
                linear[(i, k)] = moving[i];
                angular[(i, k)] = turning[i];
            }
        }
        MovingAttachment {
            frame: frame.times(&attachment.in_body),
            velocity: x_dot_of(self.x_dot, body) + omega.cross(lever),
            omega,
            acceleration: x_dot_of(self.x_bias_acceleration, body)
                + alpha.cross(lever)
                + omega.cross(omega.cross(lever)),
            alpha,
            linear,
            angular,
        }
    }
}

/// One row of J, and its share of J' q'.
fn row(first: &MovingAttachment, second: &MovingAttachment, constraint: &Constraint) -> (RowDVector<f64>, f64) {
    let along = |v: Vector3, rows: &DMatrix<f64>| RowDVector::from_row_slice(&v.0) * rows;
    let (way, rate) = (second.frame.position - first.frame.position, second.velocity - first.velocity);
    let between = second.acceleration - first.acceleration;
    let linear = &second.linear - &first.linear;
    match *constraint {
        Constraint::Offset(axis) => {
            let a = first.axis(axis);
            let row = along(a, &linear) + along(a.cross(way), &first.angular);
            (row, a.dot(between) + 2.0 * first.rate_of(a).dot(rate) + first.second_rate_of(a).dot(way))
        }
        Constraint::Perpendicular { first: i, second: j } => {
            let sign = if [(2, 1), (0, 2), (1, 0)].contains(&(i, j)) { 1.0 } else { -1.0 };
            let (a, b) = (first.axis(i) * sign, second.axis(j));
            let row = along(a.cross(b), &first.angular) + along(b.cross(a), &second.angular);
            let both = 2.0 * first.rate_of(a).dot(second.rate_of(b));
            (row, first.second_rate_of(a).dot(b) + both + a.dot(second.second_rate_of(b)))
        }
        Constraint::Distance(_) => {
            let length = way.norm();
            let n = way * (1.0 / length);
            let across = rate - n * n.dot(rate);
            (along(n, &linear), n.dot(between) + across.norm_squared() / length)
        }
    }
}

impl MovingAttachment {
    /// One of its axes, world.
    fn axis(&self, axis: usize) -> Vector3 {
        self.frame.rotation.column(axis)
    }

    /// First derivative of a direction fixed in it.
    fn rate_of(&self, a: Vector3) -> Vector3 {
        self.omega.cross(a)
    }

    /// Its second derivative, without q''.
    fn second_rate_of(&self, a: Vector3) -> Vector3 {
        self.alpha.cross(a) + self.omega.cross(self.omega.cross(a))
    }
}
