//! Water of the sea, and the gravity that keeps its surface level.

use crate::elements::gravity::assembly::gravity_of;
use crate::scenario::assembly::FieldError;
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Scenario};
use crate::sea::waves::Water;

/// Returns the water of the sea and its waves.
pub(crate) fn water_of<S: Quantity>(
    sea: &schema::Sea<S>,
    density_kg_m3: f64,
    gravity: &(S, String),
) -> Result<Water, FieldError> {
    let depth = sea.depth_m.map(|depth| depth.get().same("sea.depth_m")).transpose()?;
    let water = Water::new(density_kg_m3, gravity.0.same(&gravity.1)?, depth);
    water.map_err(|error| FieldError::new(format!("sea.{}", error.field), error.found, error.allowed))
}

/// Returns the acceleration of gravity, which a sea needs, and the field of the first enabled `gravity`.
pub(crate) fn gravity<S: Quantity>(scenario: &Scenario<S>) -> Result<(S, String), FieldError> {
    let acting = scenario.forces.iter().filter_map(|(name, force)| {
        let gravity = gravity_of(force).filter(|gravity| gravity.enabled)?;
        Some((gravity.acceleration_m_s2.get(), format!("forces.{name}.gravity.acceleration_m_s2")))
    });
    let all = acting.reduce(|(sum, field), (next, _)| (sum + next, field));
    all.ok_or_else(|| FieldError::new("forces", "water on a hull, but no gravity", "gravity that is enabled"))
}
