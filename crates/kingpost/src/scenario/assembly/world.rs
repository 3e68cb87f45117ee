//! The world: gravity, the sea with its waves, its current and the wind.

use crate::scenario::assembly::still_water::{gravity, water_of};
use crate::scenario::assembly::waves::{self, Wave};
use crate::scenario::assembly::{FieldError, wind_and_current};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Force as ForceSchema, Scenario};
use crate::sea::waves::{Stretching, WaveField};
use crate::world::World;

/// Builds the world of a scenario, with one realisation of its waves.
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

/// Returns the waves of the scenario's sea, if there are any. The water's density affects only their
/// pressure.
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
    let field = || WaveField::new(&components, water, sea.ramp_s.get()).with_stretching(stretching(sea.stretching));
    Ok((!components.is_empty()).then(field))
}

fn stretching(given: schema::Stretching) -> Stretching {
    match given {
        schema::Stretching::None => Stretching::None,
        schema::Stretching::Vertical => Stretching::Vertical,
        schema::Stretching::Wheeler => Stretching::Wheeler,
        schema::Stretching::Extrapolated => Stretching::Extrapolated,
    }
}

/// Returns whether the pressure of the waves acts on a hull.
fn press<S>(scenario: &Scenario<S>) -> bool {
    scenario.forces.values().any(|force| match force {
        ForceSchema::Hydrodynamics(given) => given.enabled && given.wave_pressure,
        _ => false,
    })
}
