//! Heave compensation.

use super::super::super::schema::{self, Drive, Scenario};
use super::super::{FieldError, sensors};
use crate::elements::drives::{ControlledDrive, SetPoint};
use crate::elements::heave_compensation::{Dynamics, FilterBank, Measurement, PeriodBand, Prediction};
use crate::elements::{AnyElement, HeaveCompensation, MotionReferenceUnit, Rope, of_kind};
use crate::scenario::leaf::Quantity;

/// An enabled entry among these, or an error that lists them.
fn named<T>(field: &str, found: &str, (all, names): (Vec<(&str, T)>, &str)) -> Result<T, FieldError> {
    let listed: Vec<&str> = all.iter().map(|(name, _)| *name).collect();
    let allowed = sensors::allowed(&listed, found, &format!("{names} that is enabled"));
    let one = all.into_iter().find(|(name, _)| *name == found);
    one.map(|(_, one)| one).ok_or_else(|| FieldError::new(field, found, allowed))
}

/// The controller, if it is enabled.
pub fn build<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::HeaveCompensation<S>,
    elements: &[AnyElement<S>],
) -> Result<Option<AnyElement<S>>, FieldError> {
    let field = |rest: &str| format!("controllers.{name}.heave_compensation.{rest}");
    let (step_s, period_s) = (scenario.simulation.step_s.get(), given.period_s.get());
    if period_s < step_s {
        let allowed = format!("at least simulation.step_s, {step_s} s");
        return Err(FieldError::new(field("period_s"), period_s, allowed));
    }
    check_inputs(scenario, name, &field(""))?;
    if !given.enabled {
        return Ok(None);
    }
    let built = of_kind::<S, Rope<S>>(elements).map(|rope| (rope.name.as_str(), rope)).collect();
    let rope = named(&field("rope"), &given.rope, (built, "a rope"))?;
    let drive = drive(&field("drive"), given, elements)?;
    let ControlledDrive { value: drive_speed, .. } = *drive;
    let stations = rope.path.stations();
    let Some(drum) = rope.drum.filter(|drum| drum.coordinate == drive.coordinate) else {
        return Err(not_its_drum(scenario, &field("drive"), given, rope.drum.is_some()));
    };
    let unit = given.sensor.as_ref().map(|sensor| {
        let built = of_kind::<S, MotionReferenceUnit<S>>(elements).map(|unit| (unit.name.as_str(), unit)).collect();
        named(&field("sensor"), sensor, (built, "a motion reference unit"))
    });
    let unit = unit.transpose()?;
    let prediction = given
        .prediction
        .as_ref()
        .map(|with| prediction(&field("prediction"), with, period_s, (unit, drive.response_time)));
    Ok(Some(Box::new(HeaveCompensation {
        name: name.to_owned(),
        period_s,
        measurement: unit.map_or(Measurement::Ideal, |unit| Measurement::Unit {
            name: unit.name.clone(),
            place: unit.place,
            has_status: unit.sampler.drop_outs.is_some(),
        }),
        prediction: prediction.transpose()?,
        tip: stations[stations.len() - 2].centre,
        falls: stations[stations.len() - 1].falls,
        drum,
        drive: drive.name.clone(),
        drive_speed,
        drive_limit: drive.limits.speed,
        feed_forward: given.feed_forward.get(),
        gain: given.position_gain_per_s.get(),
        begins_on: given.begins_on,
    })))
}

/// Its inputs have its name: no drive and no rope may have it.
fn check_inputs<S>(scenario: &Scenario<S>, name: &str, field: &str) -> Result<(), FieldError> {
    if scenario.drives.contains_key(name) || scenario.forces.contains_key(name) || scenario.sensors.contains_key(name) {
        let field = field.trim_end_matches('.');
        return Err(FieldError::new(field, format!("the name {name} of another entry"), "a name of its own"));
    }
    Ok(())
}

/// The controlled drive, which follows a speed.
fn drive<'a, S: Quantity>(
    field: &str,
    given: &schema::HeaveCompensation<S>,
    elements: &'a [AnyElement<S>],
) -> Result<&'a ControlledDrive<S>, FieldError> {
    let built = of_kind::<S, ControlledDrive<S>>(elements).map(|drive| (drive.name.as_str(), drive)).collect();
    let drive = named(field, &given.drive, (built, "a controlled drive"))?;
    let mode = match drive.set_point {
        SetPoint::Speed => return Ok(drive),
        SetPoint::Effort => "torque",
        SetPoint::Position => "position",
    };
    let found = format!("{}, whose set-point is a {mode}", given.drive);
    Err(FieldError::new(field, found, "a drive with set_point: {speed: {}}"))
}

fn not_its_drum<S: Quantity>(
    scenario: &Scenario<S>,
    field: &str,
    given: &schema::HeaveCompensation<S>,
    has_drum: bool,
) -> FieldError {
    if !has_drum {
        let field = format!("{}rope", field.trim_end_matches("drive"));
        return FieldError::new(
            field,
            format!("{}, which has no drum", given.rope),
            "a rope whose path begins at a drum",
        );
    }
    let joint = |drive: &Drive<S>| match drive {
        Drive::ControlledDrive(drive) => drive.joint.to_string(),
        _ => String::new(),
    };
    let joint = scenario.drives.get(&given.drive).map(joint).unwrap_or_default();
    let allowed = format!("the drive of the drum of {}", given.rope);
    FieldError::new(field, format!("{}, which drives {joint}", given.drive), allowed)
}

fn prediction<S: Quantity>(
    field: &str,
    given: &schema::HeavePrediction<S>,
    period_s: f64,
    (unit, response_s): (Option<&MotionReferenceUnit<S>>, S),
) -> Result<Prediction<S>, FieldError> {
    let (shortest, longest) = (given.shortest_period_s.get(), given.longest_period_s.get());
    if shortest < 4.0 * period_s {
        let allowed = format!("at least four times period_s, {} s", 4.0 * period_s);
        return Err(FieldError::new(format!("{field}.shortest_period_s"), shortest, allowed));
    }
    if longest <= shortest || longest > MOST_SAMPLES * period_s {
        let allowed = format!("above shortest_period_s, {shortest} s, and at most {} s", MOST_SAMPLES * period_s);
        return Err(FieldError::new(format!("{field}.longest_period_s"), longest, allowed));
    }
    let band = PeriodBand {
        shortest_period_s: shortest,
        longest_period_s: longest,
        noise_share: given.noise_share.get(),
        sampling_period_s: period_s,
    };
    let bank = FilterBank::new(band);
    let age = unit.map_or(0.0, |unit| unit.sampler.period_s * unit.sampler.delay_samples as f64);
    let filter = unit.and_then(|unit| unit.heave_filter);
    let position = Dynamics {
        high_pass: filter.map(|filter| [filter.cutoff, filter.damping_ratio]),
        delay: S::constant(age) + given.extra_delay_s.get(),
        lag: given.drive_response_s.map_or(response_s, |time| time.get()),
    };
    let velocity = Dynamics { delay: position.delay + S::constant(0.5 * period_s), ..position };
    // Roll and pitch come without the filter of heave.
    let unfiltered = |dynamics: Dynamics<S>| Dynamics { high_pass: None, ..dynamics };
    Ok(Prediction {
        velocity: [velocity, unfiltered(velocity)].map(|of| bank.velocity_weights(|frequency| of.velocity(frequency))),
        position: [position, unfiltered(position)].map(|of| bank.position_weights(|frequency| of.position(frequency))),
        fades: libm::exp(-period_s * band.middle_rad_s()),
        correction: if unit.is_some() { band.correction_rad_s() } else { 0.0 },
        bank,
    })
}

/// Samples in the longest period, at most: the weights are found from sums over some of it.
const MOST_SAMPLES: f64 = 1e4;
