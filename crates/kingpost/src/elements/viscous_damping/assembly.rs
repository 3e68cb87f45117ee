//! Assembly of viscous damping, with the check of its matrix.

use crate::elements::hull::HullFrame;
use crate::elements::{AnyElement, DampedAgainst, ViscousDamping};
use crate::model::Model;
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::assembly::rigid_bodies::{from_centre, rigid};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Scenario};
use crate::spatial::Vector3;
use core::array;
use nalgebra::Matrix6;

impl<S: Quantity> Assemble<S> for schema::ViscousDamping<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        Ok(viscous(at.scenario, name, self, at.model)?.into_iter().collect())
    }
}

/// Returns linear damping, if it is enabled and its body exists.
fn viscous<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::ViscousDamping<S>,
    model: &Model<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    rigid(scenario, format!("forces.{name}.viscous_damping.body"), &given.body)?;
    let Some(body) = model.body(&given.body).filter(|_| given.enabled) else { return Ok(None) };
    let origin = match given.position_m {
        Some(position) => from_centre(scenario, &given.body, Vector3(position)),
        None => Vector3::zero(),
    };
    let matrix = given.matrix.as_deref().map(|given| {
        check_heat(&format!("forces.{name}.viscous_damping.matrix"), given)?;
        Ok(Box::new(*given))
    });
    Ok(Some(Box::new(ViscousDamping {
        place: HullFrame { body, origin },
        relative_to: against(given.relative_to),
        linear: Vector3(given.linear_n_s_m.map(|c| c.get())),
        angular: Vector3(given.angular_n_m_s.map(|c| c.get())),
        matrix: matrix.transpose()?,
    })))
}

/// Returns the reference of a damping.
pub(crate) fn against(given: schema::DampedAgainst) -> DampedAgainst {
    match given {
        schema::DampedAgainst::Water => DampedAgainst::Water,
        schema::DampedAgainst::Earth => DampedAgainst::Earth,
    }
}

/// Tolerance of negative eigenvalues of a damping matrix's symmetric part, as a share of its diagonal: rounding of
/// printed numbers.
const ROUNDING: f64 = 1e-6;

/// Checks that damping adds no energy to any motion: the symmetric part of its matrix has no negative eigenvalue, in
/// any unit of length.
fn check_heat<S: Quantity>(field: &str, matrix: &[[S; 6]; 6]) -> Result<(), FieldError> {
    let entries: [S; 36] = array::from_fn(|k| matrix[k / 6][k % 6]);
    let [least] = S::from_values(entries, &|entries| {
        [least_eigenvalue(&array::from_fn(|i| array::from_fn(|j| entries[6 * i + j])))]
    });
    let Some(least) = least.outside(|least| least >= -ROUNDING) else { return Ok(()) };
    let found = format!("a matrix whose symmetric part, its diagonal scaled to 1, has the eigenvalue {least:.3e}");
    Err(FieldError::new(
        field,
        found,
        "finite numbers, and no eigenvalue below 0: damping takes energy from every motion",
    ))
}

/// Returns the smallest eigenvalue of the symmetric part, with its diagonal scaled to 1; NaN if an entry is NaN.
fn least_eigenvalue(matrix: &[[f64; 6]; 6]) -> f64 {
    let size = |i: usize| if matrix[i][i] > 0.0 { libm::sqrt(matrix[i][i]) } else { 1.0 };
    let scaled = Matrix6::from_fn(|i, j| 0.5 * (matrix[i][j] + matrix[j][i]) / (size(i) * size(j)));
    if scaled.iter().all(|entry| entry.is_finite()) { scaled.symmetric_eigenvalues().min() } else { f64::NAN }
}
