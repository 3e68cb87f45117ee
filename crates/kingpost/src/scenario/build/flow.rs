//! Wind and current by coefficients.

use super::super::schema::{self, CurrentProfile, PowerLaw, Scenario, WindProfile};
use super::FieldError;
use super::damping::{current, from_centre, rigid};
use crate::elements::flow::{DirectionTable, FlowLoad};
use crate::elements::{AnyElement, hull::HullFrame};
use crate::model::Model;
use crate::scenario::leaf::Quantity;
use crate::spatial::Vector3;

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
    let gain = speed_at(wind, given.height_m.get(), &field)?;
    let Some(body) = model.body(&given.body).filter(|_| given.enabled) else { return Ok(None) };
    let speed = wind.speed_m_s.get() * gain;
    let (sin, cos) = wind.direction_rad.sin_cos();
    Ok(Some(Box::new(FlowLoad {
        name: name.to_owned(),
        place: HullFrame { body, origin: from_centre(scenario, &given.body, Vector3(given.position_m)) },
        flow: Vector3::new(speed * cos, speed * sin, S::ZERO),
        scales: scales(wind.air_density_kg_m3.get(), &given.coefficients),
        coefficients,
    })))
}

/// The current on a body, where it is on and its body there.
pub fn water<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::CurrentLoad<S>,
    model: &Model<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    let field = format!("forces.{name}.current_load");
    rigid(scenario, format!("{field}.body"), &given.body)?;
    let coefficients = table(&format!("{field}.coefficients"), &given.coefficients)?;
    let gain = share_over_draught(scenario, given, &field)?;
    let Some(body) = model.body(&given.body).filter(|_| given.enabled) else { return Ok(None) };
    let density = scenario.sea.clone().unwrap_or_default().density_kg_m3.get();
    Ok(Some(Box::new(FlowLoad {
        name: name.to_owned(),
        place: HullFrame { body, origin: from_centre(scenario, &given.body, Vector3(given.position_m)) },
        flow: current(scenario) * gain,
        scales: scales(density, &given.coefficients),
        coefficients,
    })))
}

/// rho/2 A_x, rho/2 A_y, rho/2 A_y L.
fn scales<S: Quantity>(density: S, coefficients: &schema::FlowCoefficients<S>) -> [S; 3] {
    let schema::FlowCoefficients { frontal_area_m2, lateral_area_m2, length_m, .. } = coefficients;
    let [x, y, length] = [frontal_area_m2, lateral_area_m2, length_m].map(|size| size.get());
    let half = density * S::constant(0.5);
    [half * x, half * y, half * y * length]
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

/// Speed of the wind at a height, of that at its reference height.
fn speed_at<S: Quantity>(wind: &schema::Wind<S>, height: S, field: &str) -> Result<S, FieldError> {
    let reference = wind.reference_height_m.get();
    match wind.profile {
        WindProfile::Uniform => Ok(S::ONE),
        WindProfile::PowerLaw(PowerLaw { exponent }) => Ok((height / reference).pow(exponent.get())),
        WindProfile::Logarithmic(law) => {
            let roughness = law.roughness_m.get();
            if !(reference - roughness).all(|room| room > 0.0) {
                let allowed = format!("less than wind.reference_height_m, {reference}");
                return Err(FieldError::new("wind.profile.logarithmic.roughness_m", roughness, allowed));
            }
            if !(height - roughness).all(|room| room > 0.0) {
                let allowed = format!("more than wind.profile.logarithmic.roughness_m, {roughness}");
                return Err(FieldError::new(format!("{field}.height_m"), height, allowed));
            }
            Ok((height / roughness).ln() / (reference / roughness).ln())
        }
    }
}

/// The speed whose square is the mean of that of the current over the draught T, of the speed at the surface: by the
/// power law with the exponent n over the depth h, its square is h / T (1 - (1 - T / h)^(2 n + 1)) / (2 n + 1).
fn share_over_draught<S: Quantity>(
    scenario: &Scenario<S>,
    load: &schema::CurrentLoad<S>,
    field: &str,
) -> Result<S, FieldError> {
    let Some(sea) = &scenario.sea else { return Ok(S::ONE) };
    let CurrentProfile::PowerLaw(PowerLaw { exponent }) = sea.current_profile else { return Ok(S::ONE) };
    let Some(depth) = sea.depth_m.map(|depth| depth.get()) else {
        let found = "power_law, over infinite depth";
        return Err(FieldError::new("sea.current_profile", found, "uniform, or a sea.depth_m"));
    };
    let Some(draught) = load.draught_m.map(|draught| draught.get()) else {
        let allowed = "a draught, for a current with a profile";
        return Err(FieldError::new(format!("{field}.draught_m"), "nothing", allowed));
    };
    if !(depth - draught).all(|room| room >= 0.0) {
        return Err(FieldError::new(format!("{field}.draught_m"), draught, format!("at most sea.depth_m, {depth}")));
    }
    let power = S::constant(2.0) * exponent.get() + S::ONE;
    let over_part = || (power * (-draught / depth).ln_1p()).exp_m1();
    let left = (depth - draught).select_below(f64::MIN_POSITIVE, || -S::ONE, over_part);
    Ok((-left * depth / draught / power).sqrt())
}
