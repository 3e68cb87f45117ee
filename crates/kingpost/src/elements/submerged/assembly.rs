//! The water on lifted objects.

use crate::elements::flow::assembly as flow;
use crate::elements::hull::HullFrame;
use crate::elements::submerged::{AddedMassGrowth, AddedMassOf, Drag, EntrainedWater, Slamming, Waters, WindOnDry};
use crate::elements::{AnyElement, Submerged};
use crate::model::Model;
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::assembly::rigid_bodies::{from_centre, rigid};
use crate::scenario::assembly::{FieldError, still_water};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, PrincipalAxis, Scenario, SubmergedShape};
use crate::sea::hull::Solid;
use crate::spatial::Vector3;
use crate::world::{CurrentProfile, World};

/// Largest share of open area for which the reduction of added mass was fitted.
const LARGEST_PERFORATION: f64 = 0.5;
/// Relative rounding within which a volume equals the solid's.
const ROUNDING: f64 = 1e-9;

impl<S: Quantity> Assemble<S> for schema::Submerged<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        Ok(build(at.scenario, name, self, at.model, at.world)?.into_iter().collect())
    }
}

/// Returns an object, if it is enabled and its body exists.
fn build<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::Submerged<S>,
    model: &Model<S>,
    world: &World<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    let field = format!("forces.{name}.submerged");
    rigid(scenario, format!("{field}.body"), &given.body)?;
    let solid = solid(&given.shape);
    let displaced = displaced(&field, given, &solid)?;
    let added_mass = added_mass(&format!("{field}.added_mass"), &given.added_mass, &solid, world)?;
    let areas = |given: &Option<[schema::Positive<S>; 3]>| {
        given.map_or(solid.projected_areas(), |areas| areas.map(|area| area.get()))
    };
    let of = |coefficients: &[schema::NonNegative<S>; 3], areas: [S; 3]| {
        Vector3(core::array::from_fn(|k| coefficients[k].get() * areas[k]))
    };
    let drag = Drag {
        areas: of(&given.drag.coefficients, areas(&given.drag.areas_m2)),
        linear: Vector3(given.drag.linear_n_s_m.map(|c| c.get())),
    };
    let slamming = given.slamming.as_ref().map(|slamming| {
        let area = slamming.area_m2.map_or(solid.projected_areas()[2], |area| area.get());
        Slamming { area: slamming.coefficient.get() * area }
    });
    let wind = given.wind.as_ref().map(|wind| {
        check_wind(scenario, &format!("{field}.wind"), wind)?;
        let height = wind.height_m.get();
        let gusts = world.wind.as_ref().and_then(|wind| wind.gusts_at_height(height));
        Ok(WindOnDry { areas: of(&wind.coefficients, areas(&wind.areas_m2)), height, gusts })
    });
    let wind = wind.transpose()?;
    let entrained = entrained(&field, given, &solid, displaced)?;
    check_world(scenario, &field, world)?;
    let Some(body) = model.body(&given.body).filter(|_| given.enabled) else { return Ok(None) };
    let origin = given.position_m.map_or(Vector3::zero(), |point| from_centre(scenario, &given.body, Vector3(point)));
    let place = HullFrame { body, origin };
    let (name, waters) = (name.to_owned(), Waters::new(world));
    Ok(Some(Box::new(Submerged { name, place, solid, displaced, added_mass, slamming, drag, wind, entrained, waters })))
}

fn solid<S: Quantity>(shape: &SubmergedShape<S>) -> Solid<S> {
    match shape {
        SubmergedShape::Box(given) => {
            Solid::Box { edges: Vector3([given.length_m, given.width_m, given.height_m].map(|edge| edge.get())) }
        }
        SubmergedShape::Cylinder(given) => Solid::Cylinder {
            radius: given.radius_m.get(),
            length: given.length_m.get(),
            axis: match given.axis {
                PrincipalAxis::X => 0,
                PrincipalAxis::Y => 1,
                PrincipalAxis::Z => 2,
            },
        },
        SubmergedShape::Sphere(given) => Solid::Sphere { radius: given.radius_m.get() },
    }
}

/// Returns V over the solid's volume.
fn displaced<S: Quantity>(field: &str, given: &schema::Submerged<S>, solid: &Solid<S>) -> Result<S, FieldError> {
    let (Some(volume), whole) = (given.displaced_volume_m3, solid.volume()) else { return Ok(S::ONE) };
    let share = volume.get() / whole;
    if !share.all(|share| share <= 1.0 + ROUNDING) {
        let allowed = format!("at most the volume of the solid, {whole:.6} m3");
        return Err(FieldError::new(format!("{field}.displaced_volume_m3"), volume.get(), allowed));
    }
    Ok(share)
}

/// Returns the inner space, which with the displaced volume must fit into the solid.
fn entrained<S: Quantity>(
    field: &str,
    given: &schema::Submerged<S>,
    solid: &Solid<S>,
    displaced: S,
) -> Result<Option<EntrainedWater<S>>, FieldError> {
    let Some(inside) = &given.entrained_water else { return Ok(None) };
    let field = |rest: &str| format!("{field}.entrained_water.{rest}");
    let (volume, height) = (inside.volume_m3.get(), inside.height_m.get());
    let room = solid.volume() * (S::ONE - displaced);
    if !(volume - room).all(|beyond| beyond <= ROUNDING) {
        let allowed = format!("at most the volume of the solid less displaced_volume_m3, {room:.6} m3");
        return Err(FieldError::new(field("volume_m3"), volume, allowed));
    }
    let whole = solid.reach(Vector3([S::ZERO, S::ZERO, S::ONE])) * S::constant(2.0);
    if !(height - whole).all(|beyond| beyond <= ROUNDING) {
        let allowed = format!("at most the height of the solid, {whole:.6} m");
        return Err(FieldError::new(field("height_m"), height, allowed));
    }
    Ok(Some(EntrainedWater {
        area: volume / height,
        height,
        hole: inside.hole_area_m2.get() * inside.discharge_coefficient.get(),
        filling: inside.initial_filling.map(|filling| filling.get()),
    }))
}

fn added_mass<S: Quantity>(
    field: &str,
    given: &schema::SubmergedAddedMass<S>,
    solid: &Solid<S>,
    world: &World<S>,
) -> Result<AddedMassOf<S>, FieldError> {
    let perforation = given.perforation.get();
    if !perforation.all(|perforation| perforation <= LARGEST_PERFORATION) {
        let allowed = format!("a number from 0 to {LARGEST_PERFORATION}");
        return Err(FieldError::new(format!("{field}.perforation"), perforation, allowed));
    }
    let growth =
        given.growth.as_ref().map_or(Ok(AddedMassGrowth::in_proportion()), |given| growth(field, given, solid))?;
    let volume = given.reference_volume_m3.map_or(solid.volume(), |volume| volume.get());
    let scale = volume * left_by_perforation(perforation);
    Ok(AddedMassOf {
        linear: Vector3(given.coefficients.map(|coefficient| coefficient.get() * scale)),
        angular: Vector3(given.moments_kg_m2.map(|moment| moment.get() / world.water_density)),
        growth,
    })
}

fn growth<S: Quantity>(
    field: &str,
    given: &schema::SubmergedGrowth<S>,
    solid: &Solid<S>,
) -> Result<AddedMassGrowth<S>, FieldError> {
    let shares = match (&given.shares[..], &given.depths_m[..]) {
        (shares, []) => shares.iter().map(|share| S::constant(*share)).collect(),
        ([], depths) => shares_of(&format!("{field}.growth.depths_m"), depths, solid)?,
        _ => return Err(FieldError::new(format!("{field}.growth"), "shares and depths_m", "one of the two")),
    };
    AddedMassGrowth::new(&shares, &given.factors).map_err(|error| {
        let field = format!("{field}.growth.{}", error.column);
        FieldError::new(error.row.map_or(field.clone(), |row| format!("{field}.{row}")), error.found, error.allowed)
    })
}

/// Returns the shares of an upright solid's volume that are under water at depths of its bottom.
fn shares_of<S: Quantity>(field: &str, depths: &[f64], solid: &Solid<S>) -> Result<Vec<S>, FieldError> {
    let up = Vector3([S::ZERO, S::ZERO, S::ONE]);
    let (half, last) = (solid.reach(up), depths.len() - 1);
    let height = half + half;
    for (row, depth) in depths.iter().enumerate() {
        let is_end = match row {
            0 => *depth == 0.0,
            _ if row == last => ((S::constant(*depth) - height) / height).all(|beyond| beyond.abs() <= ROUNDING),
            _ => true,
        };
        if !is_end || !(row == 0 || *depth > depths[row - 1]) {
            let allowed = format!("increasing numbers, the first 0, the last the height of the solid, {height:.6}");
            return Err(FieldError::new(format!("{field}.{row}"), depth, allowed));
        }
    }
    let share = |(row, depth): (usize, &f64)| match row {
        0 => S::ZERO,
        _ if row == last => S::ONE,
        _ => solid.below(up, S::constant(*depth) - half).volume / solid.volume(),
    };
    Ok(depths.iter().enumerate().map(share).collect())
}

/// Returns the factor on the added mass for an open area of p percent: 1 up to 5, 0.7 + 0.3 cos(pi (p - 5) / 34) to 34,
/// exp((10 - p) / 28) from there to 50 (DNV-RP-N103, sec. 4.6, on the effect of perforation).
fn left_by_perforation<S: Quantity>(perforation: S) -> S {
    let percent = perforation * S::constant(100.0);
    let wave = || {
        let angle = (percent - S::constant(5.0)) * S::constant(core::f64::consts::PI / 34.0);
        S::constant(0.7) + S::constant(0.3) * angle.sin_cos().1
    };
    let tail = || ((S::constant(10.0) - percent) / S::constant(28.0)).exp();
    percent.select_below(5.0, || S::ONE, || percent.select_below(34.0, wave, tail))
}

fn check_wind<S: Quantity>(
    scenario: &Scenario<S>,
    field: &str,
    given: &schema::SubmergedWind<S>,
) -> Result<(), FieldError> {
    let Some(wind) = &scenario.wind else {
        return Err(FieldError::new(field, "wind drag, but no wind", "a wind, at the top of the scenario"));
    };
    flow::check_height(wind, given.height_m.get(), field)
}

/// Checks that there is gravity, and that a power-law current has a finite depth.
fn check_world<S: Quantity>(scenario: &Scenario<S>, field: &str, world: &World<S>) -> Result<(), FieldError> {
    if still_water::gravity(scenario).is_err() {
        return Err(FieldError::new(field, "buoyancy, but no gravity", "gravity that is enabled"));
    }
    check_current(world)
}

/// Returns an error unless the current is defined at each depth.
pub(crate) fn check_current<S: Quantity>(world: &World<S>) -> Result<(), FieldError> {
    if matches!(world.current.profile, CurrentProfile::PowerLaw(_)) && world.depth.is_none() {
        let found = "power_law, over infinite depth";
        return Err(FieldError::new("sea.current_profile", found, "uniform, or a sea.depth_m"));
    }
    Ok(())
}
