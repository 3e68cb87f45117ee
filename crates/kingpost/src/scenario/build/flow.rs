//! Wind and current by coefficients.

use super::super::schema::{self, Scenario};
use super::FieldError;
use super::damping::{from_centre, rigid};
use crate::elements::flow::{DirectionTable, Flow, FlowLoad};
use crate::elements::{AnyElement, hull::HullFrame};
use crate::model::Model;
use crate::scenario::leaf::Quantity;
use crate::spatial::Vector3;
use crate::world::World;

/// The wind on a body, where it is on and its body there.
pub fn wind<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::WindLoad<S>,
    model: &Model<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    let field = format!("forces.{name}.wind_load");
    rigid(scenario, format!("{field}.body"), &given.body)?;
    let coefficients = table(&format!("{field}.coefficients"), &given.coefficients)?;
    let Some(wind) = &scenario.wind else {
        return Err(FieldError::new(field, "the load of a wind, and no wind", "a wind, at the top of the scenario"));
    };
    check_height(wind, given.height_m.get(), &field)?;
    let Some(body) = model.body(&given.body).filter(|_| given.enabled) else { return Ok(None) };
    Ok(Some(Box::new(FlowLoad {
        name: name.to_owned(),
        place: HullFrame { body, origin: from_centre(scenario, &given.body, Vector3(given.position_m)) },
        flow: Flow::Wind(given.height_m.get()),
        sizes: sizes(&given.coefficients),
        coefficients,
    })))
}

/// The current on a body, where it is on and its body there.
pub fn water<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::CurrentLoad<S>,
    model: &Model<S>,
    world: &World<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    let field = format!("forces.{name}.current_load");
    rigid(scenario, format!("{field}.body"), &given.body)?;
    let coefficients = table(&format!("{field}.coefficients"), &given.coefficients)?;
    check_draught(world, given, &field)?;
    let Some(body) = model.body(&given.body).filter(|_| given.enabled) else { return Ok(None) };
    Ok(Some(Box::new(FlowLoad {
        name: name.to_owned(),
        place: HullFrame { body, origin: from_centre(scenario, &given.body, Vector3(given.position_m)) },
        flow: Flow::Current(given.draught_m.map(|draught| draught.get())),
        sizes: sizes(&given.coefficients),
        coefficients,
    })))
}

/// A_x, A_y, L.
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

/// An error unless the wind has a speed at a height.
fn check_height<S: Quantity>(wind: &schema::Wind<S>, height: S, field: &str) -> Result<(), FieldError> {
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

/// An error unless a current with a profile has a mean over the draught.
fn check_draught<S: Quantity>(world: &World<S>, load: &schema::CurrentLoad<S>, field: &str) -> Result<(), FieldError> {
    if world.current.exponent.is_none() {
        return Ok(());
    }
    let Some(depth) = world.depth else {
        let found = "power_law, over infinite depth";
        return Err(FieldError::new("sea.current_profile", found, "uniform, or a sea.depth_m"));
    };
    let Some(draught) = load.draught_m.map(|draught| draught.get()) else {
        let allowed = "a draught, for a current with a profile";
        return Err(FieldError::new(format!("{field}.draught_m"), "nothing", allowed));
    };
    if (depth - draught).all(|room| room >= 0.0) {
        return Ok(());
    }
    Err(FieldError::new(format!("{field}.draught_m"), draught, format!("at most sea.depth_m, {depth}")))
}
