//! Encoders, load cells, satellite receivers, and the errors of all sensors that sample.

use crate::elements::sensing::{DropOuts, PositionAid, Sampler, SensorNoise, SignalErrors};
use crate::elements::{AnyElement, Encoder, LoadCell, Rope, SatelliteReceiver, of_kind};
use crate::model::AxisMotion;
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::assembly::attachments::attachment;
use crate::scenario::assembly::axes::axes;
use crate::scenario::assembly::bodies::joint_name;
use crate::scenario::assembly::{FieldError, known, wires};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Force, Positive, Scenario, Sensor};
use crate::spatial::Vector3;

/// Largest delay of a sensor, in samples: each is a number in a snapshot.
const MOST_DELAY: usize = 1000;

/// Returns the sampling of a sensor, from its field, the errors of its signals, its period, its delay and its
/// drop-outs.
pub fn sampler<S: Quantity>(
    scenario: &Scenario<S>,
    [name, kind]: [&str; 2],
    errors: Vec<Option<SignalErrors<S>>>,
    (period_s, delay_samples): (Positive, usize),
    drop_outs: Option<schema::DropOuts>,
) -> Result<Sampler<S>, FieldError> {
    let field = |rest: &str| format!("sensors.{name}.{kind}.{rest}");
    if delay_samples > MOST_DELAY {
        let allowed = format!("a number from 0 to {MOST_DELAY}");
        return Err(FieldError::new(field("delay_samples"), delay_samples, allowed));
    }
    let period_s = period_s.get();
    let drop_outs = drop_outs.map(|given| {
        let times = [("mean_interval_s", given.mean_interval_s), ("mean_duration_s", given.mean_duration_s)];
        for (time, found) in times.map(|(time, found)| (time, found.get())) {
            if found < period_s {
                let allowed = format!("at least period_s, {period_s} s");
                return Err(FieldError::new(field(&format!("drop_outs.{time}")), found, allowed));
            }
        }
        let [mean_interval_s, mean_duration_s] = times.map(|(_, time)| time.get());
        Ok(DropOuts { mean_interval_s, mean_duration_s })
    });
    let noise = SensorNoise::new(scenario.simulation.seed, name);
    Ok(Sampler { errors, drop_outs: drop_outs.transpose()?, noise, period_s, delay_samples })
}

impl<S: Quantity> Assemble<S> for schema::Encoder<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        let errors = vec![self.errors.as_ref().map(of_angle)];
        let sampling = (self.period_s, self.delay_samples);
        let sampler = sampler(at.scenario, [name, "encoder"], errors, sampling, self.drop_outs)?;
        let field = format!("sensors.{name}.encoder.joint");
        of_joint(at, (name, &field), (&self.joint, self.enabled), AxisMotion::Rotation, sampler)
    }
}

impl<S: Quantity> Assemble<S> for schema::LinearEncoder<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        let errors = vec![self.errors.as_ref().map(of_length)];
        let sampling = (self.period_s, self.delay_samples);
        let sampler = sampler(at.scenario, [name, "linear_encoder"], errors, sampling, self.drop_outs)?;
        let field = format!("sensors.{name}.linear_encoder.joint");
        of_joint(at, (name, &field), (&self.joint, self.enabled), AxisMotion::Translation, sampler)
    }
}

fn of_joint<S: Quantity>(
    at: Surroundings<'_, S>,
    (name, field): (&str, &str),
    (joint, enabled): (&str, bool),
    motion: AxisMotion,
    sampler: Sampler<S>,
) -> Result<Vec<AnyElement<S>>, FieldError> {
    let of_body = |(name, body): (&schema::Name, &schema::Body<S>)| {
        let axes = axes(&body.joint).into_iter().filter(|axis| axis.motion == motion);
        axes.map(|axis| axis.coordinate_name(joint_name(name, body))).collect::<Vec<_>>()
    };
    let joints: Vec<String> = at.scenario.bodies.iter().flat_map(of_body).collect();
    known(field, joint, joints.iter().map(String::as_str))?;
    let Some(coordinate) = at.model.coordinate(joint).filter(|_| enabled) else { return Ok(Vec::new()) };
    let Some((_, position)) = at.model.axis_coordinate(coordinate) else { return Ok(Vec::new()) };
    Ok(vec![Box::new(Encoder { name: name.to_owned(), position, motion, sampler })])
}

impl<S: Quantity> Assemble<S> for schema::LoadCell<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        let errors = vec![self.errors.as_ref().map(of_force)];
        let sampling = (self.period_s, self.delay_samples);
        let sampler = sampler(at.scenario, [name, "load_cell"], errors, sampling, self.drop_outs)?;
        known(&format!("sensors.{name}.load_cell.rope"), &self.rope, ropes(at.scenario))?;
        let mut built = of_kind::<S, Rope<S>>(at.elements);
        if !self.enabled || !built.any(|rope| *rope.name == *self.rope) {
            return Ok(Vec::new());
        }
        let end = match self.end {
            schema::RopeEnd::First => "rope_first_tension",
            schema::RopeEnd::Last => "rope_tension",
        };
        Ok(vec![Box::new(LoadCell { name: name.to_owned(), column: format!("{}.{end}", self.rope), sampler })])
    }
}

/// Returns the names of all ropes.
pub fn ropes<S>(scenario: &Scenario<S>) -> impl Iterator<Item = &str> {
    scenario.forces.iter().filter_map(|(name, force)| matches!(force, Force::Rope(_)).then_some(name.as_str()))
}

impl<S: Quantity> Assemble<S> for schema::SatelliteReceiver<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        let [level, vertical] =
            [&self.horizontal_errors, &self.vertical_errors].map(|errors| errors.as_ref().map(of_length));
        let sampling = (self.period_s, self.delay_samples);
        let errors = vec![level, level, vertical];
        let sampler = sampler(at.scenario, [name, "satellite_receiver"], errors, sampling, self.drop_outs)?;
        let field = |rest: &str| format!("sensors.{name}.satellite_receiver.{rest}");
        known(&field("body"), &self.body, at.scenario.bodies.keys().map(|body| body.as_str()))?;
        if !self.enabled || at.model.body(&self.body).is_none() {
            return Ok(Vec::new());
        }
        let pin = schema::Pin { body: self.body.clone(), position_m: self.position_m };
        let antenna = attachment(at.scenario, at.model, &field("position_m"), &pin)?;
        Ok(vec![Box::new(SatelliteReceiver { name: name.to_owned(), antenna, sampler })])
    }
}

/// Returns the satellite receiver that corrects a unit at a point of a body.
pub fn position_aid<S: Quantity>(
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
        return Err(FieldError::new(field, name, wires::allowed(&names, name, "a satellite receiver that is enabled")));
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

pub fn of_angle<S: Quantity>(given: &schema::AngleErrors<S>) -> SignalErrors<S> {
    let (noise, resolution) = (given.noise_rad.get(), given.resolution_rad.get());
    SignalErrors { noise, bias: given.bias_rad, resolution }
}

pub fn of_length<S: Quantity>(given: &schema::LengthErrors<S>) -> SignalErrors<S> {
    let (noise, resolution) = (given.noise_m.get(), given.resolution_m.get());
    SignalErrors { noise, bias: given.bias_m, resolution }
}

pub fn of_speed<S: Quantity>(given: &schema::SpeedErrors<S>) -> SignalErrors<S> {
    let (noise, resolution) = (given.noise_m_s.get(), given.resolution_m_s.get());
    SignalErrors { noise, bias: given.bias_m_s, resolution }
}

pub fn of_rate<S: Quantity>(given: &schema::RateErrors<S>) -> SignalErrors<S> {
    let (noise, resolution) = (given.noise_rad_s.get(), given.resolution_rad_s.get());
    SignalErrors { noise, bias: given.bias_rad_s, resolution }
}

pub fn of_acceleration<S: Quantity>(given: &schema::AccelerationErrors<S>) -> SignalErrors<S> {
    let (noise, resolution) = (given.noise_m_s2.get(), given.resolution_m_s2.get());
    SignalErrors { noise, bias: given.bias_m_s2, resolution }
}

/// Checks that the period of an oscillation is long enough for a filter to follow it from sample to sample.
pub fn long_enough<S: Quantity>(field: String, found: Positive, sampler: &Sampler<S>) -> Result<(), FieldError> {
    let least = 4.0 * sampler.period_s;
    if found.get() >= least {
        return Ok(());
    }
    Err(FieldError::new(field, found.get(), format!("at least four times period_s, {least} s")))
}

/// Checks that a filter exists for its assumptions.
pub fn exists(field: String, is_finite: bool) -> Result<(), FieldError> {
    let allowed = "noise and motion with finite filter gains";
    if is_finite { Ok(()) } else { Err(FieldError::new(field, "numbers whose magnitudes differ too much", allowed)) }
}

fn of_force<S: Quantity>(given: &schema::ForceErrors<S>) -> SignalErrors<S> {
    let (noise, resolution) = (given.noise_n.get(), given.resolution_n.get());
    SignalErrors { noise, bias: given.bias_n, resolution }
}
