//! Sensors, and the wires from their outputs.

use crate::elements::clearance::assembly as clearances;
use crate::elements::hull::HullFrame;
use crate::elements::inertial_unit::{Assumed, Design, Instruments};
use crate::elements::sensing::PositionAid;
use crate::elements::sensing::assembly as crane_sensors;
use crate::elements::{AnyElement, HeaveFilter, InertialUnit, Layout, MotionReferenceUnit};
use crate::model::Model;
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::rigid_bodies::{from_centre, rigid};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Drive, Scenario, Sensor};
use crate::scenario::wording::one_of_with_hint;
use crate::spatial::Vector3;

/// The sensors that are enabled, on bodies that exist; `elements` are those that they may measure.
pub fn build<S: Quantity>(
    scenario: &Scenario<S>,
    model: &Model<S>,
    elements: &[AnyElement<S>],
) -> Result<Vec<AnyElement<S>>, FieldError> {
    let mut sensors: Vec<AnyElement<S>> = Vec::new();
    for (name, sensor) in &scenario.sensors {
        sensors.extend(match sensor {
            Sensor::MotionReferenceUnit(given) => motion_reference_unit(scenario, name, given, model)?,
            Sensor::InertialUnit(given) => inertial_unit(scenario, name, given, model)?,
            Sensor::SwingEstimator(given) => crane_sensors::swing_estimator(scenario, name, given, model)?,
            Sensor::Encoder(given) => crane_sensors::encoder(scenario, name, given, model)?,
            Sensor::LinearEncoder(given) => crane_sensors::linear_encoder(scenario, name, given, model)?,
            Sensor::LoadCell(given) => crane_sensors::load_cell(scenario, name, given, elements)?,
            Sensor::SatelliteReceiver(given) => crane_sensors::satellite_receiver(scenario, name, given, model)?,
            Sensor::Clearance(given) => clearances::clearance(scenario, name, given, model)?,
            Sensor::AirGap(given) => clearances::air_gap(scenario, name, given, model)?,
        });
    }
    Ok(sensors)
}

fn motion_reference_unit<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::MotionReferenceUnit<S>,
    model: &Model<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    let field = |rest: &str| format!("sensors.{name}.motion_reference_unit.{rest}");
    rigid(scenario, field("body"), &given.body)?;
    let angle = given.angle_errors.as_ref().map(crane_sensors::of_angle);
    let rate = given.rate_errors.as_ref().map(crane_sensors::of_rate);
    let heave = given.heave_errors.as_ref().map(crane_sensors::of_length);
    let heave_rate = given.heave_rate_errors.as_ref().map(crane_sensors::of_speed);
    let mut errors =
        vec![angle, angle, heave, heave_rate, rate, rate, rate, heave, heave_rate, heave, heave_rate, angle];
    errors.truncate(MotionReferenceUnit::<S>::signals(given.horizontal_motion));
    let sampling = (given.period_s, given.delay_samples);
    let sampler = crane_sensors::sampler(scenario, [name, "motion_reference_unit"], errors, sampling, given.drop_outs)?;
    let receiver = given.heave_filter.as_ref().and_then(|filter| filter.receiver.as_ref());
    let on = (&given.body, given.position_m);
    let receiver = receiver.map(|receiver| position_aid(scenario, &field("heave_filter.receiver"), receiver, on));
    let receiver = receiver.transpose()?;
    let Some(body) = model.body(&given.body).filter(|_| given.enabled) else { return Ok(None) };
    let heave_filter = given.heave_filter.as_ref().map(|filter| HeaveFilter {
        cutoff: S::constant(core::f64::consts::TAU) / filter.cutoff_period_s.get(),
        damping_ratio: filter.damping_ratio.get(),
    });
    let place = HullFrame { body, origin: from_centre(scenario, &given.body, Vector3(given.position_m)) };
    let horizontal = given.horizontal_motion;
    let name = name.to_owned();
    Ok(Some(Box::new(MotionReferenceUnit { name, place, horizontal, sampler, heave_filter, receiver })))
}

fn inertial_unit<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::InertialUnit<S>,
    model: &Model<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    let field = |rest: &str| format!("sensors.{name}.inertial_unit.{rest}");
    rigid(scenario, field("body"), &given.body)?;
    let sampling = (given.period_s, given.delay_samples);
    let errors = vec![None; InertialUnit::<S>::SIGNALS];
    let sampler = crane_sensors::sampler(scenario, [name, "inertial_unit"], errors, sampling, given.drop_outs)?;
    let on = (&given.body, given.position_m);
    let receiver = given.receiver.as_ref().map(|receiver| position_aid(scenario, &field("receiver"), receiver, on));
    let receiver = receiver.transpose()?;
    let Some(body) = model.body(&given.body).filter(|_| given.enabled) else { return Ok(None) };
    let filter = &given.filter;
    crane_sensors::long_enough(field("filter.wave_period_s"), filter.wave_period_s, &sampler)?;
    let design = Design::new(&Assumed {
        period_s: sampler.period_s,
        acceleration_noise: filter.acceleration_noise_m_s2.get(),
        rate_noise: filter.rate_noise_rad_s.get(),
        heading_noise: filter.heading_noise_rad.get(),
        motion_m: filter.wave_motion_m.get(),
        motion_period_s: filter.wave_period_s.get(),
        receiver: receiver.as_ref().map(|receiver| [receiver.period_s, filter.position_noise_m.get()]),
    });
    crane_sensors::exists(field("filter"), design.is_finite())?;
    let instruments = Instruments {
        acceleration: given.acceleration_errors.as_ref().map(crane_sensors::of_acceleration),
        rate: given.rate_errors.as_ref().map(crane_sensors::of_rate),
        heading: given.heading_errors.as_ref().map(crane_sensors::of_angle),
    };
    let place = HullFrame { body, origin: from_centre(scenario, &given.body, Vector3(given.position_m)) };
    let name = name.to_owned();
    Ok(Some(Box::new(InertialUnit { name, place, instruments, sampler, design, receiver })))
}

/// The receiver that helps a unit at a point of a body.
fn position_aid<S: Quantity>(
    scenario: &Scenario<S>,
    field: &str,
    name: &str,
    (body, position_m): (&schema::Name, [S; 3]),
) -> Result<PositionAid<S>, FieldError> {
    let enabled = scenario.sensors.iter().filter_map(|(name, sensor)| match sensor {
        Sensor::SatelliteReceiver(receiver) if receiver.enabled => Some((name.as_str(), receiver)),
        _ => None,
    });
    let receivers: Vec<(&str, &schema::SatelliteReceiver<S>)> = enabled.collect();
    let Some((_, receiver)) = receivers.iter().find(|(enabled, _)| *enabled == name) else {
        let names: Vec<&str> = receivers.iter().map(|(name, _)| *name).collect();
        return Err(FieldError::new(field, name, allowed(&names, name, "a satellite receiver that is enabled")));
    };
    if receiver.body != *body {
        let found = format!("{name}, which is on {}", receiver.body);
        return Err(FieldError::new(field, found, format!("a satellite receiver on {body}")));
    }
    let [unit, antenna] = [position_m, receiver.position_m].map(Vector3);
    let period_s = receiver.period_s.get();
    Ok(PositionAid {
        receiver: name.to_owned(),
        arm: antenna - unit,
        period_s,
        age_s: period_s * receiver.delay_samples as f64,
        has_status: receiver.drop_outs.is_some(),
    })
}

/// The input that a servo adds to its target; it exists if a wire leads to it.
pub fn offset_of(drive: &str) -> String {
    format!("{drive}.target_offset")
}

/// Whether a wire or a controller leads to an input.
pub fn leads_to<S>(scenario: &Scenario<S>, input: &str) -> bool {
    let wired = || scenario.wires.values().any(|wire| wire.enabled && *wire.to == *input);
    scenario.controllers.values().any(|one| one.targets().iter().any(|(_, to)| *to == input)) || wired()
}

/// The wires that are enabled, as an input and the signal that it takes.
pub fn wires<S: Quantity>(
    scenario: &Scenario<S>,
    elements: &[AnyElement<S>],
) -> Result<Vec<(String, String)>, FieldError> {
    let layout = Layout::new(elements, 0);
    let signals = layout.signals();
    let mut wires: Vec<(String, String)> = Vec::new();
    for (name, wire) in scenario.wires.iter().filter(|(_, wire)| wire.enabled) {
        let field = |end: &str| format!("wires.{name}.{end}");
        let Some(signal) = signals.iter().find(|signal| signal.name == *wire.from) else {
            let names: Vec<&str> = signals.iter().map(|signal| signal.name.as_str()).collect();
            return Err(FieldError::new(field("from"), &wire.from, allowed(&names, &wire.from, "an enabled sensor")));
        };
        let Some(place) = layout.inputs.iter().position(|input| input.name == *wire.to) else {
            return Err(no_input(scenario, &layout, field("to"), &wire.to));
        };
        if let Some(controller) = layout.set_by(place) {
            let found = format!("{}, which {controller} sets", wire.to);
            return Err(FieldError::new(field("to"), found, "an input that no controller sets"));
        }
        let input = &layout.inputs[place];
        if input.unit != signal.unit {
            let found = format!("{}, in {}", wire.from, signal.unit);
            return Err(FieldError::new(field("from"), found, format!("a signal in {}, as {}", input.unit, wire.to)));
        }
        if wires.iter().any(|(taken, _)| *taken == *wire.to) {
            return Err(FieldError::new(field("to"), format!("{} a second time", wire.to), "one wire to each input"));
        }
        wires.push((wire.to.to_string(), wire.from.to_string()));
    }
    Ok(wires)
}

/// An error for the name of an input that does not exist.
pub fn no_input<S>(scenario: &Scenario<S>, layout: &Layout, field: String, found: &str) -> FieldError {
    let offsets: Vec<String> = scenario.drives.iter().filter_map(|(name, drive)| offset(name, drive)).collect();
    let inputs = layout.inputs.iter().map(|input| &input.name).filter(|input| !offsets.contains(input));
    let names: Vec<&str> = inputs.chain(&offsets).map(String::as_str).collect();
    FieldError::new(field, found, allowed(&names, found, "a drive with an input"))
}

/// Returns the words for the names that are allowed; `none` is what the scenario lacks if there are no names.
pub fn allowed(names: &[&str], found: &str, none: &str) -> String {
    if names.is_empty() { format!("none: the scenario does not have {none}") } else { one_of_with_hint(names, found) }
}

/// The offset input of a servo that is enabled.
fn offset<S>(name: &str, drive: &Drive<S>) -> Option<String> {
    let acts = match drive {
        Drive::Servo(servo) => servo.enabled,
        Drive::LinearServo(servo) => servo.enabled,
        _ => false,
    };
    acts.then(|| offset_of(name))
}
