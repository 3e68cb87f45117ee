//! Motions of bodies and named points from those of the free coordinates.

use super::excitation::{kinematics, twists};
use crate::simulation::Simulation;
use crate::spatial::{Matrix3, Twist, Vector3};
use nalgebra::{Complex, DMatrix, DVector};

/// The rows of a response.
pub(super) struct Outputs {
    pub(super) places: Vec<String>,
    /// Positions of the bodies and points at rest, world, m.
    pub(super) places_m: Vec<[f64; 3]>,
    pub(super) bodies: Vec<String>,
    /// Jacobian of positions and angles with respect to the free coordinates.
    jacobian: DMatrix<Complex<f64>>,
}

impl Outputs {
    pub(super) fn new(rest: &Simulation, free: &[usize]) -> Self {
        let (model, q) = (rest.model(), &rest.state().q);
        let (at, twists) = (kinematics(model, q), twists(model, q, free));
        let mut places: Vec<(String, usize, Vector3)> = Vec::new();
        places.extend(model.bodies.iter().enumerate().map(|(i, body)| (body.name.clone(), i, Vector3::zero())));
        for (i, body) in model.bodies.iter().enumerate() {
            places.extend(body.points.iter().map(|(name, r)| (format!("{}.{name}", body.name), i, *r)));
        }
        let mut rows: Vec<Vec<[f64; 3]>> = Vec::new();
        for (_, body, r) in &places {
            let rotation = at.world[*body].rotation;
            let moved = |twist: &Vec<Twist>| (rotation * (twist[*body].linear + twist[*body].angular.cross(*r))).0;
            rows.push(twists.iter().map(moved).collect());
        }
        for body in 0..model.bodies.len() {
            let rotation = at.world[body].rotation;
            rows.push(twists.iter().map(|twist| euler_rates(&rotation, twist[body].angular)).collect());
        }
        let place_at_rest = |(_, body, r): &(String, usize, Vector3)| at.world[*body].point(*r).0;
        let entry = |row: usize, column: usize| Complex::new(rows[row / 3][column][row % 3], 0.0);
        Self {
            jacobian: DMatrix::from_fn(3 * rows.len(), free.len(), entry),
            places_m: places.iter().map(place_at_rest).collect(),
            places: places.into_iter().map(|(name, ..)| name).collect(),
            bodies: model.bodies.iter().map(|body| body.name.clone()).collect(),
        }
    }

    /// Returns the number of rows.
    pub(super) fn rows(&self) -> usize {
        self.jacobian.nrows() + self.jacobian.ncols()
    }

    /// Returns all rows for small motions of the free coordinates.
    pub(super) fn of(&self, xi: &DVector<Complex<f64>>) -> Vec<Complex<f64>> {
        let motions = &self.jacobian * xi;
        motions.iter().chain(xi.iter()).copied().collect()
    }
}

/// Returns the rates of roll, pitch and yaw of `R = Rz Ry Rx` for an angular velocity in body axes; not
/// finite if the body's x axis is vertical.
fn euler_rates(rotation: &Matrix3, angular: Vector3) -> [f64; 3] {
    let Matrix3([.., [down, across, up]]) = *rotation;
    // `across` and `up` are sin and cos of the roll times cos of the pitch; `-down` is sin of the pitch.
    let cos_squared = across * across + up * up;
    let cos = libm::sqrt(cos_squared);
    let turning = (across * angular[1] + up * angular[2]) / cos_squared;
    [angular[0] - down * turning, (up * angular[1] - across * angular[2]) / cos, turning]
}
