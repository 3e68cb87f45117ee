//! Wind and current by coefficients.

use super::super::schema::{self, CurrentProfile, Force as ForceSchema, PowerLaw, Scenario, WindProfile};
use super::FieldError;
use super::damping::{current, from_centre, rigid};
use super::reading::{Gathered, Reading};
use crate::elements::flow::{DirectionTable, FlowLoad};
use crate::elements::{AnyElement, hull::HullFrame};
use crate::model::Model;
use crate::spatial::Vector3;

/// The wind on a body, where it is on and its body there.
pub fn wind<S: Gathered>(
    scenario: &Reading<Scenario>,
    name: &str,
    model: &Model<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    let load = scenario.part(|scenario| &scenario.forces[name]).kind(wind_load_of);
    let (given, field) = (load.first(), format!("forces.{name}.wind_load"));
    rigid(scenario.first(), format!("{field}.body"), &given.body)?;
    let coefficients = table(&format!("{field}.coefficients"), &given.coefficients)?;
    let Some(wind) = &scenario.first().wind else {
        return Err(FieldError::new(field, "the load of a wind, and no wind", "a wind, at the top of the scenario"));
    };
    let gain = speed_at(wind, given.height_m.get(), &field)?;
    let Some(body) = model.body(&given.body).filter(|_| given.enabled) else { return Ok(None) };
    let wind = scenario.kind(|scenario| scenario.wind.as_ref());
    let speed: S = wind.number::<S>(|wind| wind.speed_m_s.get()) * S::constant(gain);
    let (sin, cos) = wind.number::<S>(|wind| wind.direction_rad).sin_cos();
    let position = load.vector(|load| load.position_m);
    let density = wind.number(|wind| wind.air_density_kg_m3.get());
    Ok(Some(Box::new(FlowLoad {
        name: name.to_owned(),
        place: HullFrame { body, origin: from_centre(scenario, &given.body, position) },
        flow: Vector3::new(speed * cos, speed * sin, S::ZERO),
        scales: scales(density, &load.part(|load| &load.coefficients)),
        coefficients,
    })))
}

/// The current on a body, where it is on and its body there.
pub fn water<S: Gathered>(
    scenario: &Reading<Scenario>,
    name: &str,
    model: &Model<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    let load = scenario.part(|scenario| &scenario.forces[name]).kind(current_load_of);
    let (given, field) = (load.first(), format!("forces.{name}.current_load"));
    rigid(scenario.first(), format!("{field}.body"), &given.body)?;
    let coefficients = table(&format!("{field}.coefficients"), &given.coefficients)?;
    let gain = share_over_draught(scenario.first(), given, &field)?;
    let Some(body) = model.body(&given.body).filter(|_| given.enabled) else { return Ok(None) };
    let position = load.vector(|load| load.position_m);
    let density = scenario.number(|scenario| scenario.sea.clone().unwrap_or_default().density_kg_m3.get());
    Ok(Some(Box::new(FlowLoad {
        name: name.to_owned(),
        place: HullFrame { body, origin: from_centre(scenario, &given.body, position) },
        flow: current(scenario) * S::constant(gain),
        scales: scales(density, &load.part(|load| &load.coefficients)),
        coefficients,
    })))
}

/// rho/2 A_x, rho/2 A_y, rho/2 A_y L.
fn scales<S: Gathered>(density: S, coefficients: &Reading<schema::FlowCoefficients>) -> [S; 3] {
    let [x, y, length] = coefficients.numbers(|c| [c.frontal_area_m2.get(), c.lateral_area_m2.get(), c.length_m.get()]);
    let half: S = density * S::constant(0.5);
    [half * x, half * y, half * y * length]
}

fn table(field: &str, given: &schema::FlowCoefficients) -> Result<DirectionTable, FieldError> {
    let count = given.directions_rad.len();
    for (name, column) in [("surge", &given.surge), ("sway", &given.sway), ("yaw", &given.yaw)] {
        if column.len() != count {
            let allowed = format!("{count}, one for each direction");
            return Err(FieldError::new(format!("{field}.{name}"), format!("{} numbers", column.len()), allowed));
        }
    }
    let row = |i: usize| [given.surge[i], given.sway[i], given.yaw[i]];
    let rows: Vec<[f64; 3]> = (0..count).map(row).collect();
    DirectionTable::new(&given.directions_rad, &rows, given.symmetric).map_err(|error| {
        let field = format!("{field}.{}", error.column);
        let field = error.row.map_or(field.clone(), |row| format!("{field}.{row}"));
        FieldError::new(field, error.found, error.allowed)
    })
}

/// Speed of the wind at a height, of that at its reference height.
fn speed_at(wind: &schema::Wind, height: f64, field: &str) -> Result<f64, FieldError> {
    let reference = wind.reference_height_m.get();
    match wind.profile {
        WindProfile::Uniform => Ok(1.0),
        WindProfile::PowerLaw(PowerLaw { exponent }) => Ok(libm::pow(height / reference, exponent.get())),
        WindProfile::Logarithmic(law) => {
            let roughness = law.roughness_m.get();
            if roughness >= reference {
                let allowed = format!("less than wind.reference_height_m, {reference}");
                return Err(FieldError::new("wind.profile.logarithmic.roughness_m", roughness, allowed));
            }
            if height <= roughness {
                let allowed = format!("more than wind.profile.logarithmic.roughness_m, {roughness}");
                return Err(FieldError::new(format!("{field}.height_m"), height, allowed));
            }
            Ok(libm::log(height / roughness) / libm::log(reference / roughness))
        }
    }
}

/// The speed whose square is the mean of that of the current over the draught T, of the speed at the surface: by the
/// power law with the exponent n over the depth h, its square is h / T (1 - (1 - T / h)^(2 n + 1)) / (2 n + 1).
fn share_over_draught(scenario: &Scenario, load: &schema::CurrentLoad, field: &str) -> Result<f64, FieldError> {
    let Some(sea) = &scenario.sea else { return Ok(1.0) };
    let CurrentProfile::PowerLaw(PowerLaw { exponent }) = sea.current_profile else { return Ok(1.0) };
    let Some(depth) = sea.depth_m.map(|depth| depth.get()) else {
        let found = "power_law, over infinite depth";
        return Err(FieldError::new("sea.current_profile", found, "uniform, or a sea.depth_m"));
    };
    let Some(draught) = load.draught_m.map(|draught| draught.get()) else {
        let allowed = "a draught, for a current with a profile";
        return Err(FieldError::new(format!("{field}.draught_m"), "nothing", allowed));
    };
    if draught > depth {
        return Err(FieldError::new(format!("{field}.draught_m"), draught, format!("at most sea.depth_m, {depth}")));
    }
    let power = 2.0 * exponent.get() + 1.0;
    Ok(libm::sqrt(-libm::expm1(power * libm::log1p(-draught / depth)) * depth / draught / power))
}

fn wind_load_of(force: &ForceSchema) -> Option<&schema::WindLoad> {
    if let ForceSchema::WindLoad(load) = force { Some(load) } else { None }
}

fn current_load_of(force: &ForceSchema) -> Option<&schema::CurrentLoad> {
    if let ForceSchema::CurrentLoad(load) = force { Some(load) } else { None }
}
