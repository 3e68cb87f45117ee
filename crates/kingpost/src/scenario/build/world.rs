//! What is outside: gravity, the sea with its waves, its current and the wind.

use super::super::schema::{self, Force as ForceSchema, Scenario};
use super::waves::{self, Wave};
use super::{FieldError, gravity_of, wind_and_current};
use crate::scenario::leaf::Quantity;
use crate::sea::waves::{Water, WaveField};
use crate::world::World;

/// The world of a scenario, its waves drawn.
pub fn build<S: Quantity>(scenario: &Scenario<S>) -> Result<World<S>, FieldError> {
    let sea = scenario.sea.clone().unwrap_or_default();
    Ok(World {
        gravity: gravity(scenario).map_or(S::ZERO, |(gravity, _)| gravity),
        water_density: sea.density_kg_m3.get(),
        depth: sea.depth_m.map(|depth| depth.get()),
        waves: incident_waves(scenario, &sea)?,
        current: wind_and_current::current(&sea)?,
        wind: wind_and_current::wind(scenario)?,
    })
}

/// The waves of the scenario's sea, where there are any. The water's density is that of their pressure alone.
fn incident_waves<S: Quantity>(
    scenario: &Scenario<S>,
    sea: &schema::Sea<S>,
) -> Result<Option<WaveField<S>>, FieldError> {
    if !sea.waves.values().any(schema::Waves::enabled) {
        return Ok(None);
    }
    let Ok(gravity) = gravity(scenario) else { return Ok(None) };
    let (density, field) = (sea.density_kg_m3.get(), "sea.density_kg_m3");
    let density = if press(scenario) { density.same(field)? } else { density.scaled(field)?.0 };
    let water = water_of(sea, density, &gravity)?;
    let components: Vec<_> = waves::build(scenario, &water)?.iter().map(Wave::component).collect();
    Ok((!components.is_empty()).then(|| WaveField::new(&components, water, sea.ramp_s.get())))
}

/// Whether the waves' own pressure acts on a hull.
fn press<S>(scenario: &Scenario<S>) -> bool {
    scenario.forces.values().any(|force| match force {
        ForceSchema::Hydrodynamics(given) => given.enabled && given.wave_pressure,
        _ => false,
    })
}

/// The sea's water, whose waves are the scenario's.
pub(super) fn water_of<S: Quantity>(
    sea: &schema::Sea<S>,
    density_kg_m3: f64,
    gravity: &(S, String),
) -> Result<Water, FieldError> {
    let depth = sea.depth_m.map(|depth| depth.get().same("sea.depth_m")).transpose()?;
    let water = Water::new(density_kg_m3, gravity.0.same(&gravity.1)?, depth);
    water.map_err(|error| FieldError::new(format!("sea.{}", error.field), error.found, error.allowed))
}

/// Gravity's acceleration, by which a sea is level, and the field of the first that acts.
pub(super) fn gravity<S: Quantity>(scenario: &Scenario<S>) -> Result<(S, String), FieldError> {
    let acting = scenario.forces.iter().filter_map(|(name, force)| {
        let gravity = gravity_of(force).filter(|gravity| gravity.enabled)?;
        Some((gravity.acceleration_m_s2.get(), format!("forces.{name}.gravity.acceleration_m_s2")))
    });
    let all = acting.reduce(|(sum, field), (next, _)| (sum + next, field));
    all.ok_or_else(|| FieldError::new("forces", "water on a hull, and no gravity", "gravity that is enabled"))
}
