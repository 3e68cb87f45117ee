//! Encoders, load cells, satellite receivers, and the errors of all sensors that sample.

use crate::elements::sensing::{DropOuts, Sampler, SensorNoise, SignalErrors};
use crate::elements::{AnyElement, Encoder, LoadCell, Rope, SatelliteReceiver, SwingEstimator, SwingFilter, of_kind};
use crate::model::{AxisMotion, Model};
use crate::scenario::assembly::attachments::attachment;
use crate::scenario::assembly::axes::axes;
use crate::scenario::assembly::bodies::joint_name;
use crate::scenario::assembly::rigid_bodies::rigid;
use crate::scenario::assembly::{FieldError, known};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Force, Positive, Scenario};

/// Largest delay of a sensor, in samples: each is a number in a snapshot.
const MOST_DELAY: usize = 1000;

/// The sampling of a sensor: its field, the errors of its signals, its period, its delay, its failures.
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

/// An encoder of a joint that turns.
pub fn encoder<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::Encoder<S>,
    model: &Model<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    let errors = vec![given.errors.as_ref().map(of_angle)];
    let sampling = (given.period_s, given.delay_samples);
    let sampler = sampler(scenario, [name, "encoder"], errors, sampling, given.drop_outs)?;
    let field = format!("sensors.{name}.encoder.joint");
    of_joint(scenario, (name, &field), (&given.joint, given.enabled), AxisMotion::Rotation, (model, sampler))
}

/// An encoder of a joint that slides.
pub fn linear_encoder<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::LinearEncoder<S>,
    model: &Model<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    let errors = vec![given.errors.as_ref().map(of_length)];
    let sampling = (given.period_s, given.delay_samples);
    let sampler = sampler(scenario, [name, "linear_encoder"], errors, sampling, given.drop_outs)?;
    let field = format!("sensors.{name}.linear_encoder.joint");
    of_joint(scenario, (name, &field), (&given.joint, given.enabled), AxisMotion::Translation, (model, sampler))
}

fn of_joint<S: Quantity>(
    scenario: &Scenario<S>,
    (name, field): (&str, &str),
    (joint, enabled): (&str, bool),
    motion: AxisMotion,
    (model, sampler): (&Model<S>, Sampler<S>),
) -> Result<Option<AnyElement<S>>, FieldError> {
    let of_body = |(name, body): (&schema::Name, &schema::Body<S>)| {
        let axes = axes(&body.joint).into_iter().filter(|axis| axis.motion == motion);
        axes.map(|axis| axis.coordinate_name(joint_name(name, body))).collect::<Vec<_>>()
    };
    let joints: Vec<String> = scenario.bodies.iter().flat_map(of_body).collect();
    known(field, joint, joints.iter().map(String::as_str))?;
    let Some(coordinate) = model.coordinate(joint).filter(|_| enabled) else { return Ok(None) };
    let Some((_, position)) = model.axis_coordinate(coordinate) else { return Ok(None) };
    Ok(Some(Box::new(Encoder { name: name.to_owned(), position, motion, sampler })))
}

/// A load cell, if its rope exists.
pub fn load_cell<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::LoadCell<S>,
    elements: &[AnyElement<S>],
) -> Result<Option<AnyElement<S>>, FieldError> {
    let errors = vec![given.errors.as_ref().map(of_force)];
    let sampling = (given.period_s, given.delay_samples);
    let sampler = sampler(scenario, [name, "load_cell"], errors, sampling, given.drop_outs)?;
    known(&format!("sensors.{name}.load_cell.rope"), &given.rope, ropes(scenario))?;
    let mut built = of_kind::<S, Rope<S>>(elements);
    if !given.enabled || !built.any(|rope| *rope.name == *given.rope) {
        return Ok(None);
    }
    let end = match given.end {
        schema::RopeEnd::First => "rope_first_tension",
        schema::RopeEnd::Last => "rope_tension",
    };
    Ok(Some(Box::new(LoadCell { name: name.to_owned(), column: format!("{}.{end}", given.rope), sampler })))
}

/// Names of all ropes.
pub fn ropes<S>(scenario: &Scenario<S>) -> impl Iterator<Item = &str> {
    scenario.forces.iter().filter_map(|(name, force)| matches!(force, Force::Rope(_)).then_some(name.as_str()))
}

/// A satellite receiver, if its body exists.
pub fn satellite_receiver<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::SatelliteReceiver<S>,
    model: &Model<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    let [level, vertical] =
        [&given.horizontal_errors, &given.vertical_errors].map(|errors| errors.as_ref().map(of_length));
    let sampling = (given.period_s, given.delay_samples);
    let errors = vec![level, level, vertical];
    let sampler = sampler(scenario, [name, "satellite_receiver"], errors, sampling, given.drop_outs)?;
    let field = |rest: &str| format!("sensors.{name}.satellite_receiver.{rest}");
    known(&field("body"), &given.body, scenario.bodies.keys().map(|body| body.as_str()))?;
    if !given.enabled || model.body(&given.body).is_none() {
        return Ok(None);
    }
    let pin = schema::Pin { body: given.body.clone(), position_m: given.position_m };
    let antenna = attachment(scenario, model, &field("position_m"), &pin)?;
    Ok(Some(Box::new(SatelliteReceiver { name: name.to_owned(), antenna, sampler })))
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

/// A swing estimator.
pub fn swing_estimator<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::SwingEstimator<S>,
    model: &Model<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    let field = |rest: &str| format!("sensors.{name}.swing_estimator.{rest}");
    rigid(scenario, field("body"), &given.body)?;
    let sampling = (given.period_s, given.delay_samples);
    let errors = vec![None; SwingEstimator::<S>::SIGNALS];
    let sampler = sampler(scenario, [name, "swing_estimator"], errors, sampling, given.drop_outs)?;
    let schema::SwingFilter { rate_noise_rad_s, swing_rad, swing_period_s } = given.filter;
    long_enough(field("filter.swing_period_s"), swing_period_s, &sampler)?;
    let [noise, swing, period] = [rate_noise_rad_s, swing_rad, swing_period_s].map(|number| number.get());
    let filter = SwingFilter::new(sampler.period_s, noise, swing, period);
    exists(field("filter"), filter.is_finite())?;
    let Some(body) = model.body(&given.body).filter(|_| given.enabled) else { return Ok(None) };
    let rate_errors = given.rate_errors.as_ref().map(of_rate);
    Ok(Some(Box::new(SwingEstimator { name: name.to_owned(), body, rate_errors, sampler, filter })))
}

/// The middle period of an oscillation that a filter follows from sample to sample.
pub fn long_enough<S: Quantity>(field: String, found: Positive, sampler: &Sampler<S>) -> Result<(), FieldError> {
    let least = 4.0 * sampler.period_s;
    if found.get() >= least {
        return Ok(());
    }
    Err(FieldError::new(field, found.get(), format!("at least four times period_s, {least} s")))
}

/// Whether there is a filter for what it assumes.
pub fn exists(field: String, is_finite: bool) -> Result<(), FieldError> {
    let allowed = "noises and motions from which gains of finite size follow";
    if is_finite { Ok(()) } else { Err(FieldError::new(field, "numbers too far apart", allowed)) }
}

fn of_force<S: Quantity>(given: &schema::ForceErrors<S>) -> SignalErrors<S> {
    let (noise, resolution) = (given.noise_n.get(), given.resolution_n.get());
    SignalErrors { noise, bias: given.bias_n, resolution }
}
