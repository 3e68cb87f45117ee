//! Wind with its gusts, and current.

use super::super::schema::{self, CurrentProfile as CurrentSchema, PowerLaw, Scenario};
use super::FieldError;
use super::waves::amplitudes;
use crate::elements::{Anemometer, AnyElement};
use crate::model::Model;
use crate::scenario::leaf::Quantity;
use crate::spatial::Vector3;
use crate::world::{
    Current, CurrentProfile, CurrentTable, GustRealisation, GustSpectrum, Gusts, Wind, WindProfile, World,
};

/// Returns the wind of a scenario, with one realisation of its gusts.
pub fn wind<S: Quantity>(scenario: &Scenario<S>) -> Result<Option<Wind<S>>, FieldError> {
    let Some(given) = &scenario.wind else { return Ok(None) };
    let (sin, cos) = given.direction_rad.sin_cos();
    check_ten_metres(given)?;
    Ok(Some(Wind {
        speed: given.speed_m_s.get(),
        direction: [cos, sin],
        reference_height: given.reference_height_m.get(),
        profile: match given.profile {
            schema::WindProfile::Uniform => WindProfile::Uniform,
            schema::WindProfile::PowerLaw(PowerLaw { exponent }) => WindProfile::PowerLaw(exponent.get()),
            schema::WindProfile::Logarithmic(law) => WindProfile::Logarithmic(law.roughness_m.get()),
            schema::WindProfile::Npd => WindProfile::Npd,
        },
        gusts: gusts(given, scenario.simulation.seed)?,
        air_density: given.air_density_kg_m3.get(),
    }))
}

/// Returns an error unless the reference height is 10 m: the profile refers to the wind at 10 m.
fn check_ten_metres<S: Quantity>(given: &schema::Wind<S>) -> Result<(), FieldError> {
    let height = given.reference_height_m.get();
    if given.profile != schema::WindProfile::Npd || (height - S::constant(10.0)).vanishes() {
        return Ok(());
    }
    Err(FieldError::new("wind.reference_height_m", height, "10, to which the profile npd refers"))
}

/// Returns the anemometers, if there is wind: one on every floating body, or one in the world if no body
/// floats.
pub fn anemometers<S: Quantity>(world: &World<S>, model: &Model<S>, elements: &[AnyElement<S>]) -> Vec<AnyElement<S>> {
    let Some(wind) = &world.wind else { return Vec::new() };
    let mut bodies: Vec<Option<usize>> = Vec::new();
    for body in elements.iter().flat_map(|element| element.supports()).filter_map(|support| support.afloat()) {
        if !bodies.contains(&Some(body)) {
            bodies.push(Some(body));
        }
    }
    if bodies.is_empty() {
        bodies.push(None);
    }
    let gusts = wind.gusts_at_height(wind.reference_height);
    let of = |body: Option<usize>| -> AnyElement<S> {
        let label = body.map_or(schema::WORLD, |body| &model.bodies[body].name).to_owned();
        Box::new(Anemometer { label, body, gusts: gusts.clone() })
    };
    bodies.into_iter().map(of).collect()
}

fn gusts<S: Quantity>(given: &schema::Wind<S>, seed: u64) -> Result<Option<Gusts<S>>, FieldError> {
    let Some(given) = given.gusts.as_ref().filter(|gusts| gusts.enabled) else { return Ok(None) };
    let spectrum = match given.spectrum {
        schema::GustSpectrum::Npd => GustSpectrum::Npd,
        schema::GustSpectrum::Api(api) => GustSpectrum::Api { peak_coefficient: api.peak_coefficient.get() },
        schema::GustSpectrum::Kaimal(law) => GustSpectrum::Kaimal {
            turbulence_intensity: law.turbulence_intensity.get(),
            length_scale: law.length_scale_m.get(),
        },
    };
    let realisation = GustRealisation {
        seed,
        components: given.components,
        band_hz: [given.lowest_hz.get(), given.highest_hz.get()],
        amplitudes: amplitudes(given.amplitudes),
        ramp_s: given.ramp_s.get(),
    };
    let gusts = Gusts::new(spectrum, &realisation);
    gusts.map(Some).map_err(|error| FieldError::new(format!("wind.gusts.{}", error.field), error.found, error.allowed))
}

/// Returns the current of a sea.
pub fn current<S: Quantity>(sea: &schema::Sea<S>) -> Result<Current<S>, FieldError> {
    let [x, y] = sea.current_m_s;
    let of = |profile| Current { surface: Vector3::new(x, y, S::ZERO), profile };
    match &sea.current_profile {
        CurrentSchema::Uniform => Ok(of(CurrentProfile::Uniform)),
        CurrentSchema::PowerLaw(PowerLaw { exponent }) => Ok(of(CurrentProfile::PowerLaw(exponent.get()))),
        CurrentSchema::Table(given) => {
            if !sea.current_m_s.into_iter().all(Quantity::vanishes) {
                let found = format!("[{x}, {y}]");
                let allowed = "nothing: the table of sea.current_profile also gives the current at the surface";
                return Err(FieldError::new("sea.current_m_s", found, allowed));
            }
            let table = table(given, sea.depth_m.map(|depth| depth.get()))?;
            let [x, y] = table.velocities[0];
            Ok(Current { surface: Vector3::new(x, y, S::ZERO), profile: CurrentProfile::Table(table) })
        }
    }
}

fn table<S: Quantity>(given: &schema::CurrentTable<S>, depth: Option<S>) -> Result<CurrentTable<S>, FieldError> {
    let field = |name: &str| format!("sea.current_profile.table.{name}");
    let (depths, count) = (&given.depths_m, given.depths_m.len());
    for (name, column) in [("speeds_m_s", &given.speeds_m_s), ("directions_rad", &given.directions_rad)] {
        if column.len() != count {
            let allowed = format!("{count}, one for each depth");
            return Err(FieldError::new(field(name), format!("{} numbers", column.len()), allowed));
        }
    }
    if count < 2 {
        return Err(FieldError::new(field("depths_m"), format!("{count} numbers"), "2 depths or more"));
    }
    if depths[0] != 0.0 {
        return Err(FieldError::new(field("depths_m.0"), depths[0], "0, the surface"));
    }
    if let Some(row) = (1..count).find(|&row| !(depths[row] > depths[row - 1] && depths[row].is_finite())) {
        let allowed = format!("more than the depth before, {}", depths[row - 1]);
        return Err(FieldError::new(field(&format!("depths_m.{row}")), depths[row], allowed));
    }
    let last = depths[count - 1];
    if let Some(depth) = depth.filter(|depth| !depth.all(|depth| last <= depth)) {
        let allowed = format!("at most sea.depth_m, {depth}");
        return Err(FieldError::new(field(&format!("depths_m.{}", count - 1)), last, allowed));
    }
    let velocity = |(speed, direction): (&S, &S)| {
        let (sin, cos) = direction.sin_cos();
        [*speed * cos, *speed * sin]
    };
    let velocities = given.speeds_m_s.iter().zip(&given.directions_rad).map(velocity).collect();
    Ok(CurrentTable { depths: depths.clone(), velocities })
}
