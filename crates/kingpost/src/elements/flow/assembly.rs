//! Wind and current by coefficients.

use crate::elements::AnyElement;
use crate::elements::flow::{DirectionTable, Flow, FlowLoad};
use crate::elements::hull::HullFrame;
use crate::model::Model;
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::assembly::rigid_bodies::{from_centre, rigid};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Scenario};
use crate::spatial::Vector3;
use crate::world::{CurrentAt, CurrentProfile, World};

impl<S: Quantity> Assemble<S> for schema::WindLoad<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        Ok(wind(at.scenario, name, self, at.model, at.world)?.into_iter().collect())
    }
}

/// Returns the wind on a body, if it is enabled and its body exists.
fn wind<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::WindLoad<S>,
    model: &Model<S>,
    world: &World<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    let field = format!("forces.{name}.wind_load");
    rigid(scenario, format!("{field}.body"), &given.body)?;
    let coefficients = table(&format!("{field}.coefficients"), &given.coefficients)?;
    let Some(wind) = &scenario.wind else {
        return Err(FieldError::new(field, "a wind load, but no wind", "a wind, at the top of the scenario"));
    };
    check_height(wind, given.height_m.get(), &field)?;
    let Some(body) = model.body(&given.body).filter(|_| given.enabled) else { return Ok(None) };
    Ok(Some(Box::new(FlowLoad {
        name: name.to_owned(),
        place: HullFrame { body, origin: from_centre(scenario, &given.body, Vector3(given.position_m)) },
        flow: Flow::Wind(given.height_m.get()),
        gusts: world.wind.as_ref().and_then(|wind| wind.gusts_at_height(given.height_m.get())),
        sizes: sizes(&given.coefficients),
        coefficients,
    })))
}

impl<S: Quantity> Assemble<S> for schema::CurrentLoad<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        Ok(water(at.scenario, name, self, at.model, at.world)?.into_iter().collect())
    }
}

/// Returns the current on a body, if it is enabled and its body exists.
fn water<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::CurrentLoad<S>,
    model: &Model<S>,
    world: &World<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    let field = format!("forces.{name}.current_load");
    rigid(scenario, format!("{field}.body"), &given.body)?;
    let coefficients = table(&format!("{field}.coefficients"), &given.coefficients)?;
    let counts = current_at(world, given, &field)?;
    let Some(body) = model.body(&given.body).filter(|_| given.enabled) else { return Ok(None) };
    Ok(Some(Box::new(FlowLoad {
        name: name.to_owned(),
        place: HullFrame { body, origin: from_centre(scenario, &given.body, Vector3(given.position_m)) },
        flow: Flow::Current(counts),
        gusts: None,
        sizes: sizes(&given.coefficients),
        coefficients,
    })))
}

/// Returns A_x, A_y and L.
fn sizes<S: Quantity>(coefficients: &schema::FlowCoefficients<S>) -> [S; 3] {
    let schema::FlowCoefficients { frontal_area_m2, lateral_area_m2, length_m, .. } = coefficients;
    [frontal_area_m2, lateral_area_m2, length_m].map(|size| size.get())
}

fn table<S: Quantity>(field: &str, given: &schema::FlowCoefficients<S>) -> Result<DirectionTable<S>, FieldError> {
    let count = given.directions_rad.len();
    for (name, column) in [("surge", &given.surge), ("sway", &given.sway), ("yaw", &given.yaw)] {
        if column.len() != count {
            let allowed = format!("{count}, one for each direction");
            return Err(FieldError::new(format!("{field}.{name}"), format!("{} numbers", column.len()), allowed));
        }
    }
    let row = |i: usize| [given.surge[i], given.sway[i], given.yaw[i]];
    let rows: Vec<[S; 3]> = (0..count).map(row).collect();
    DirectionTable::new(&given.directions_rad, &rows, given.symmetric).map_err(|error| {
        let field = format!("{field}.{}", error.column);
        let field = error.row.map_or(field.clone(), |row| format!("{field}.{row}"));
        FieldError::new(field, error.found, error.allowed)
    })
}

/// Smallest height of the NPD profile, m: below it the wind speed would reach 0.
const LEAST_NPD_M: f64 = 1.0;

/// Returns an error unless the wind's profile is valid at a height.
pub(crate) fn check_height<S: Quantity>(wind: &schema::Wind<S>, height: S, field: &str) -> Result<(), FieldError> {
    if wind.profile == schema::WindProfile::Npd && !height.all(|height| height >= LEAST_NPD_M) {
        return Err(FieldError::new(
            format!("{field}.height_m"),
            height,
            format!("at least {LEAST_NPD_M} m, by the profile npd"),
        ));
    }
    let schema::WindProfile::Logarithmic(law) = wind.profile else { return Ok(()) };
    let (reference, roughness) = (wind.reference_height_m.get(), law.roughness_m.get());
    if !(reference - roughness).all(|room| room > 0.0) {
        let allowed = format!("less than wind.reference_height_m, {reference}");
        return Err(FieldError::new("wind.profile.logarithmic.roughness_m", roughness, allowed));
    }
    if !(height - roughness).all(|room| room > 0.0) {
        let allowed = format!("more than wind.profile.logarithmic.roughness_m, {roughness}");
        return Err(FieldError::new(format!("{field}.height_m"), height, allowed));
    }
    Ok(())
}

/// Returns the velocity of the current that a load uses; an error if the profile is not defined over the draught or at
/// the depth.
fn current_at<S: Quantity>(
    world: &World<S>,
    load: &schema::CurrentLoad<S>,
    field: &str,
) -> Result<CurrentAt<S>, FieldError> {
    match (&world.current.profile, world.depth) {
        (CurrentProfile::Uniform, _) => return Ok(CurrentAt::Surface),
        (CurrentProfile::PowerLaw(_), None) => {
            let found = "power_law, over infinite depth";
            return Err(FieldError::new("sea.current_profile", found, "uniform, or a sea.depth_m"));
        }
        _ => {}
    }
    let reaches = |name: &str, below: S| match world.depth {
        Some(depth) if !(depth - below).all(|room| room >= 0.0) => {
            Err(FieldError::new(format!("{field}.{name}"), below, format!("at most sea.depth_m, {depth}")))
        }
        _ => Ok(below),
    };
    let draught = || {
        let allowed = "a draught, for a current with a profile";
        let given = load.draught_m.map(|draught| draught.get());
        let given = given.ok_or_else(|| FieldError::new(format!("{field}.draught_m"), "nothing", allowed))?;
        reaches("draught_m", given)
    };
    match load.speed {
        schema::CurrentSpeed::MeanSquare => draught().map(CurrentAt::MeanSquareOver),
        schema::CurrentSpeed::Mean => draught().map(CurrentAt::MeanOver),
        schema::CurrentSpeed::AtDepth(at) => reaches("speed.at_depth.depth_m", at.depth_m.get()).map(CurrentAt::Depth),
    }
}
