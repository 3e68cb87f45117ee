//! Damping of a body's own motion.

use super::super::schema::{self, Force as ForceSchema, Scenario};
use super::reading::{Gathered, Reading};
use super::{FieldError, known};
use crate::elements::hull::HullFrame;
use crate::elements::{AnyElement, QuadraticDamping, ViscousDamping};
use crate::model::Model;
use crate::spatial::Vector3;
use core::array;
use nalgebra::Matrix6;

/// Linear damping, where it is on and its body there.
pub fn viscous<S: Gathered>(
    scenario: &Reading<Scenario>,
    name: &str,
    model: &Model<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    let damping = scenario.part(|scenario| &scenario.forces[name]).kind(viscous_damping_of);
    let given = damping.first();
    rigid(scenario.first(), format!("forces.{name}.viscous_damping.body"), &given.body)?;
    let Some(body) = model.body(&given.body).filter(|_| given.enabled) else { return Ok(None) };
    let origin = match given.position_m {
        Some(_) => from_centre(scenario, &given.body, damping.vector(|damping| damping.position_m.unwrap_or_default())),
        None => Vector3::zero(),
    };
    let matrix = given.matrix.as_deref().map(|given| {
        check_heat(&format!("forces.{name}.viscous_damping.matrix"), given)?;
        let entry = |i: usize, j: usize| damping.number(|damping| damping.matrix.as_deref().unwrap_or(given)[i][j]);
        Ok(Box::new(array::from_fn(|i| array::from_fn(|j| entry(i, j)))))
    });
    Ok(Some(Box::new(ViscousDamping {
        place: HullFrame { body, origin },
        linear: damping.vector(|damping| damping.linear_n_s_m.map(|c| c.get())),
        angular: damping.vector(|damping| damping.angular_n_m_s.map(|c| c.get())),
        matrix: matrix.transpose()?,
        current: current(scenario),
    })))
}

/// By how much the symmetric part of a matrix of damping may be negative, of its diagonal: rounding in what was printed.
const ROUNDING: f64 = 1e-6;

/// Damping takes energy from every motion: its matrix has a symmetric part without negative eigenvalues, whatever the
/// units of length.
fn check_heat(field: &str, matrix: &[[f64; 6]; 6]) -> Result<(), FieldError> {
    let size = |i: usize| if matrix[i][i] > 0.0 { libm::sqrt(matrix[i][i]) } else { 1.0 };
    let scaled = Matrix6::from_fn(|i, j| 0.5 * (matrix[i][j] + matrix[j][i]) / (size(i) * size(j)));
    let least =
        if scaled.iter().all(|entry| entry.is_finite()) { scaled.symmetric_eigenvalues().min() } else { f64::NAN };
    if least >= -ROUNDING {
        return Ok(());
    }
    let found = format!("a matrix whose symmetric part, its diagonal scaled to 1, has the eigenvalue {least:.3e}");
    Err(FieldError::new(
        field,
        found,
        "finite numbers, and no eigenvalue below 0: damping takes energy from every motion",
    ))
}

/// Quadratic damping, where it is on and its body there.
pub fn quadratic<S: Gathered>(
    scenario: &Reading<Scenario>,
    name: &str,
    model: &Model<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    let damping = scenario.part(|scenario| &scenario.forces[name]).kind(quadratic_damping_of);
    let given = damping.first();
    rigid(scenario.first(), format!("forces.{name}.quadratic_damping.body"), &given.body)?;
    let Some(body) = model.body(&given.body).filter(|_| given.enabled) else { return Ok(None) };
    let origin = from_centre(scenario, &given.body, damping.vector(|damping| damping.position_m));
    Ok(Some(Box::new(QuadraticDamping {
        place: HullFrame { body, origin },
        linear: damping.vector(|damping| damping.linear_n_s2_m2.map(|c| c.get())),
        angular: damping.vector(|damping| damping.angular_n_m_s2.map(|c| c.get())),
        current: current(scenario),
    })))
}

/// A point of a body's drawing frame, from the body's centre of mass.
pub(super) fn from_centre<S: Gathered>(scenario: &Reading<Scenario>, body: &str, point: Vector3<S>) -> Vector3<S> {
    point - scenario.part(|scenario| &scenario.bodies[body]).vector(|body| body.centre_of_mass_m)
}

/// Velocity of the water in the world, m/s.
pub(super) fn current<S: Gathered>(scenario: &Reading<Scenario>) -> Vector3<S> {
    let [x, y] = scenario.numbers(|scenario| scenario.sea.as_ref().map_or([0.0; 2], |sea| sea.current_m_s));
    Vector3::new(x, y, S::ZERO)
}

/// An error unless a body is there and rigid.
pub(super) fn rigid(scenario: &Scenario, field: String, body: &str) -> Result<(), FieldError> {
    known(&field, body, scenario.bodies.keys().map(|body| body.as_str()))?;
    if scenario.bodies.get(body).is_some_and(|body| body.flexible.is_some()) {
        return Err(FieldError::new(field, body, "a body that is not flexible"));
    }
    Ok(())
}

fn viscous_damping_of(force: &ForceSchema) -> Option<&schema::ViscousDamping> {
    if let ForceSchema::ViscousDamping(damping) = force { Some(damping) } else { None }
}

fn quadratic_damping_of(force: &ForceSchema) -> Option<&schema::QuadraticDamping> {
    if let ForceSchema::QuadraticDamping(damping) = force { Some(damping) } else { None }
}
