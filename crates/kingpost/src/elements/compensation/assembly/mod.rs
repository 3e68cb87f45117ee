//! Heave compensation, and the parts common to all compensations.

pub(crate) mod forecast;
pub(crate) mod hoists;
pub(crate) mod in_axes;

use crate::elements::compensation::{Dynamics, Estimator, FilterBank, Measurement, PeriodBand, Prediction};
use crate::elements::drives::ControlledDrive;
use crate::elements::hull::HullFrame;
use crate::elements::sensing::Sampler;
use crate::elements::{AnyElement, HeaveCompensation, InertialUnit, MotionReferenceUnit, of_kind};
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Scenario};
use hoists::{hung, named};

impl<S: Quantity> Assemble<S> for schema::HeaveCompensation<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        let lead = format!("controllers.{name}.heave_compensation");
        check(at.scenario, name, &lead, self.period_s.get())?;
        if !self.enabled {
            return Ok(Vec::new());
        }
        let rope = hung((at.scenario, at.model), &lead, [&self.rope, &self.drive], at.elements)?;
        let source =
            MotionSource { sensor: self.sensor.as_ref(), horizontal: false, prediction: self.prediction.as_ref() };
        Ok(vec![Box::new(HeaveCompensation {
            name: name.to_owned(),
            estimator: estimator(&lead, &source, self.period_s.get(), (at.elements, &[rope.drive]))?,
            tip: rope.tip,
            falls: rope.falls,
            hoist: rope.hoist,
            drive: rope.drive.name.clone(),
            drive_speed: rope.speed,
            drive_limit: rope.drive.limits.speed,
            feed_forward: self.feed_forward.get(),
            gain: self.position_gain_per_s.get(),
            begins_on: self.begins_on,
        })])
    }
}

/// Checks the sampling period, and that no drive and no rope has the compensation's name, which is the name of its
/// inputs.
pub fn check<S>(scenario: &Scenario<S>, name: &str, lead: &str, period_s: f64) -> Result<(), FieldError> {
    let step_s = scenario.simulation.step_s.get();
    if period_s < step_s {
        let allowed = format!("at least simulation.step_s, {step_s} s");
        return Err(FieldError::new(format!("{lead}.period_s"), period_s, allowed));
    }
    if scenario.drives.contains_key(name) || scenario.forces.contains_key(name) || scenario.sensors.contains_key(name) {
        return Err(FieldError::new(
            lead,
            format!("the name {name} of another entry"),
            "a name that no other entry has",
        ));
    }
    Ok(())
}

/// Source of the motion that a compensation uses.
pub struct MotionSource<'a, S> {
    /// The unit.
    pub sensor: Option<&'a schema::Name>,
    /// Whether the unit must measure horizontal motion.
    pub horizontal: bool,
    /// The prediction.
    pub prediction: Option<&'a schema::HeavePrediction<S>>,
}

/// The motion sensor of a compensation: a motion reference unit or an inertial unit.
pub struct MotionUnit<S> {
    name: String,
    /// Its body and place.
    pub place: HullFrame<S>,
    horizontal: bool,
    has_status: bool,
    /// Age of its outputs, s.
    age_s: f64,
    /// Cut-off frequency (rad/s) and damping ratio of its heave's high-pass filter; `None` without a filter.
    high_pass: Option<[S; 2]>,
}

impl<S: Quantity> MotionUnit<S> {
    fn new(name: &str, (place, horizontal): (HullFrame<S>, bool), sampler: &Sampler<S>) -> Self {
        let age_s = sampler.period_s * sampler.delay_samples as f64;
        Self {
            name: name.to_owned(),
            place,
            horizontal,
            has_status: sampler.drop_outs.is_some(),
            age_s,
            high_pass: None,
        }
    }
}

impl<S> MotionUnit<S> {
    /// Returns the measurement by this unit.
    fn measurement(self) -> Measurement<S> {
        let Self { name, place, horizontal, has_status, .. } = self;
        Measurement::Unit { name, place, horizontal, has_status }
    }
}

impl<S: Quantity> From<&MotionReferenceUnit<S>> for MotionUnit<S> {
    fn from(unit: &MotionReferenceUnit<S>) -> Self {
        // An inertial unit with a satellite receiver has no high-pass filter.
        let filter = unit.heave_filter.filter(|_| unit.receiver.is_none());
        let high_pass = filter.map(|filter| [filter.cutoff, filter.damping_ratio]);
        Self { high_pass, ..Self::new(&unit.name, (unit.place, unit.horizontal), &unit.sampler) }
    }
}

impl<S: Quantity> From<&InertialUnit<S>> for MotionUnit<S> {
    fn from(unit: &InertialUnit<S>) -> Self {
        Self::new(&unit.name, (unit.place, true), &unit.sampler)
    }
}

/// Returns the unit of a compensation, if it has one.
pub fn unit<S: Quantity>(
    lead: &str,
    source: &MotionSource<'_, S>,
    elements: &[AnyElement<S>],
) -> Result<Option<MotionUnit<S>>, FieldError> {
    let Some(sensor) = source.sensor else { return Ok(None) };
    let field = format!("{lead}.sensor");
    let units = of_kind::<S, MotionReferenceUnit<S>>(elements).map(|unit| (unit.name.as_str(), MotionUnit::from(unit)));
    let inertial = of_kind::<S, InertialUnit<S>>(elements).map(|unit| (unit.name.as_str(), MotionUnit::from(unit)));
    let unit = named(&field, sensor, (units.chain(inertial).collect(), "a motion reference unit or an inertial unit"))?;
    if source.horizontal && !unit.horizontal {
        let found = format!("{}, which measures no horizontal motion", sensor.as_str());
        let allowed = "a motion reference unit with horizontal_motion: true, or an inertial unit";
        return Err(FieldError::new(field, found, allowed));
    }
    Ok(Some(unit))
}

/// Builds the motion estimator of a compensation for these drives.
pub fn estimator<S: Quantity>(
    lead: &str,
    source: &MotionSource<'_, S>,
    period_s: f64,
    (elements, drives): (&[AnyElement<S>], &[&ControlledDrive<S>]),
) -> Result<Estimator<S>, FieldError> {
    let unit = unit(lead, source, elements)?;
    let responses: Vec<S> = drives.iter().map(|drive| drive.response_time).collect();
    let field = format!("{lead}.prediction");
    let prediction = source.prediction.map(|with| prediction(&field, with, period_s, (unit.as_ref(), &responses)));
    let measurement = unit.map_or(Measurement::Ideal, MotionUnit::measurement);
    Ok(Estimator { measurement, prediction: prediction.transpose()?, period_s })
}

fn prediction<S: Quantity>(
    field: &str,
    given: &schema::HeavePrediction<S>,
    period_s: f64,
    (unit, responses_s): (Option<&MotionUnit<S>>, &[S]),
) -> Result<Prediction<S>, FieldError> {
    let noise_share = given.noise_share.get();
    let band = band(field, [given.shortest_period_s.get(), given.longest_period_s.get()], noise_share, period_s)?;
    let bank = FilterBank::new(band);
    let age = unit.map_or(0.0, |unit| unit.age_s);
    let delay = S::constant(age) + given.extra_delay_s.get();
    let high_pass = unit.and_then(|unit| unit.high_pass);
    let position = Dynamics { high_pass, delay, lag: S::ZERO };
    let of_drive = |response_s: &S| {
        let lag = given.drive_response_s.map_or(*response_s, |time| time.get());
        Dynamics { delay: delay + S::constant(0.5 * period_s), lag, ..position }
    };
    // The high-pass filter acts on heave only, not on roll and pitch.
    let both = |of: Dynamics<S>| [of, Dynamics { high_pass: None, ..of }];
    let weights = |of: Dynamics<S>| both(of).map(|of| bank.velocity_weights(|frequency| of.velocity(frequency)));
    Ok(Prediction {
        results: responses_s.iter().map(|response_s| weights(of_drive(response_s))).collect(),
        position: both(position).map(|of| bank.position_weights(|frequency| of.position(frequency))).to_vec(),
        age: S::constant(age),
        fades: bank.fades(),
        correction: if unit.is_some() { bank.correction_rad_s() } else { 0.0 },
        bank,
    })
}

/// Returns the band of a prediction between two periods, s, which must suit the sampling period.
pub fn band(
    field: &str,
    [shortest_period_s, longest_period_s]: [f64; 2],
    noise_share: f64,
    period_s: f64,
) -> Result<PeriodBand, FieldError> {
    if shortest_period_s < 4.0 * period_s {
        let allowed = format!("at least four times period_s, {} s", 4.0 * period_s);
        return Err(FieldError::new(format!("{field}.shortest_period_s"), shortest_period_s, allowed));
    }
    if longest_period_s <= shortest_period_s || longest_period_s > MOST_SAMPLES * period_s {
        let most_s = MOST_SAMPLES * period_s;
        let allowed = format!("above shortest_period_s, {shortest_period_s} s, and at most {most_s} s");
        return Err(FieldError::new(format!("{field}.longest_period_s"), longest_period_s, allowed));
    }
    let (sampling_period_s, peak_period_s) = (period_s, None);
    Ok(PeriodBand { shortest_period_s, longest_period_s, noise_share, sampling_period_s, peak_period_s })
}

/// Largest number of samples in the longest period: it limits the sums that give the weights.
const MOST_SAMPLES: f64 = 1e4;
