//! Histories of motors' efforts and of prescribed motions over time.

use core::f64::consts::TAU;

use crate::elements::AnyElement;
use crate::elements::drives::{Oscillation, PrescribedMotion, Pulse, TimeFunction};
use crate::model::Model;
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::axes::{GivenMotion, axes};
use crate::scenario::assembly::flexible::owner;
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, History, HistoryList, Scenario};

/// Returns the history of a motor, which may jump; `field` is its path.
pub fn of_motor<S: Quantity>(
    field: &str,
    history: History,
    pulse: Option<&schema::Pulse>,
    list: Option<&HistoryList<S>>,
) -> Result<TimeFunction<S>, FieldError> {
    match history {
        History::Constant | History::Lever => Ok(TimeFunction::constant()),
        History::Pulse => {
            let pulse = pulse.ok_or_else(|| no_pulse(field))?;
            let [start_s, rise_s, hold_s, reverse_s] =
                [pulse.start_s, pulse.rise_s, pulse.hold_s, pulse.reverse_s].map(schema::NonNegative::get);
            Ok(TimeFunction::pulse(Pulse { start_s, rise_s, hold_s, reverse_s }))
        }
        History::List => listed(field, list.ok_or_else(|| no_list(field))?),
    }
}

/// Returns the prescribed motions of the coordinates that exist.
pub fn given_motions<S: Quantity>(scenario: &Scenario<S>, model: &Model<S>) -> Result<Vec<AnyElement<S>>, FieldError> {
    let mut motions = Vec::new();
    for (i, body) in model.bodies.iter().enumerate() {
        let (name, 0) = owner(&body.name) else { continue };
        let Some(joint) = scenario.bodies.get(name).map(|body| &body.joint) else { continue };
        for (k, axis) in axes(joint).iter().enumerate() {
            let Some(given) = &axis.given else { continue };
            let path = format!("bodies.{}.joint.{}", body.name, joint.kind());
            let coordinate = model.tree.nodes[i].velocities + k;
            let field = |mode: &str| format!("{path}.{}", axis.field(&format!("mode.{mode}")));
            motions.push(given_motion(field, given, coordinate)?);
        }
    }
    Ok(motions)
}

/// Returns the prescribed motion of one coordinate; `field` returns the path of its mode.
fn given_motion<S: Quantity>(
    field: impl Fn(&str) -> String,
    given: &GivenMotion<S>,
    coordinate: usize,
) -> Result<AnyElement<S>, FieldError> {
    let (rate, profile) = match given {
        GivenMotion::Rate { full, .. } => (*full, of_rate(&field("prescribed"), given)?),
        GivenMotion::Travel { way, start_s, duration_s, ramp_s } => {
            let profile = of_travel(&field("travel"), *start_s, *duration_s, *ramp_s)?;
            (*way / S::constant(duration_s - ramp_s), profile)
        }
        &GivenMotion::Oscillation { amplitude, period_s, phase_rad, ramp_s } => {
            let frequency_rad_s = S::constant(TAU) / period_s;
            return Ok(Box::new(Oscillation { coordinate, amplitude, frequency_rad_s, phase_rad, ramp_s }));
        }
    };
    Ok(Box::new(PrescribedMotion { coordinate, rate, profile }))
}

/// Returns the history of a prescribed rate, which has no lever and no jump.
fn of_rate<S: Quantity>(field: &str, given: &GivenMotion<S>) -> Result<TimeFunction<S>, FieldError> {
    let GivenMotion::Rate { history, pulse, list, .. } = given else { return Ok(TimeFunction::constant()) };
    match history {
        History::Constant => Ok(TimeFunction::constant()),
        History::Lever => {
            let allowed = "constant, pulse or list, for a prescribed motion";
            Err(FieldError::new(format!("{field}.history"), "lever", allowed))
        }
        History::Pulse => {
            let pulse = pulse.as_ref().ok_or_else(|| no_pulse(field))?;
            let (start_s, rise_s) = (pulse.start_s.get(), pulse.rise_s.get());
            let (hold_s, reverse_s) = (pulse.hold_s.get(), pulse.reverse_s.get());
            Ok(TimeFunction::pulse(Pulse { start_s, rise_s, hold_s, reverse_s }))
        }
        History::List => {
            let list = list.as_ref().ok_or_else(|| no_list(field))?;
            let profile = listed(field, list)?;
            check_no_jump(field, list)?;
            Ok(profile)
        }
    }
}

/// Returns a trapezoidal history from rest to rest.
fn of_travel<S: Quantity>(
    field: &str,
    start_s: f64,
    duration_s: f64,
    ramp_s: f64,
) -> Result<TimeFunction<S>, FieldError> {
    let hold_s = duration_s - 2.0 * ramp_s;
    if hold_s < 0.0 {
        let allowed = format!("at most {}, half of duration_s", 0.5 * duration_s);
        return Err(FieldError::new(format!("{field}.ramp_s"), ramp_s, allowed));
    }
    Ok(TimeFunction::pulse(Pulse { start_s, rise_s: ramp_s, hold_s, reverse_s: 0.0 }))
}

/// Returns a listed history: times that do not decrease, with a share for each.
fn listed<S: Quantity>(field: &str, list: &HistoryList<S>) -> Result<TimeFunction<S>, FieldError> {
    let times_s: Vec<f64> = list.time_s.iter().map(|time| time.get()).collect();
    if times_s.is_empty() {
        return Err(FieldError::new(format!("{field}.list.time_s"), "an empty list", "one time or more"));
    }
    if list.share.len() != times_s.len() {
        let allowed = format!("{}, one for each time", times_s.len());
        return Err(FieldError::new(format!("{field}.list.share"), format!("{} shares", list.share.len()), allowed));
    }
    if let Some(i) = (1..times_s.len()).find(|&i| times_s[i] < times_s[i - 1]) {
        let allowed = format!("{} or more, the time before", times_s[i - 1]);
        return Err(FieldError::new(format!("{field}.list.time_s.{i}"), times_s[i], allowed));
    }
    Ok(TimeFunction::list(&times_s, &list.share))
}

/// Checks that a prescribed rate does not jump: a jump would need an infinite force.
fn check_no_jump<S: Quantity>(field: &str, list: &HistoryList<S>) -> Result<(), FieldError> {
    let (times, shares) = (&list.time_s, &list.share);
    if times[0].get() > 0.0 && !shares[0].all(|share| share == 0.0) {
        let allowed = "0 where the motion begins after time 0: a rate cannot jump";
        return Err(FieldError::new(format!("{field}.list.share.0"), shares[0], allowed));
    }
    match (1..times.len()).find(|&i| times[i] == times[i - 1] && shares[i] != shares[i - 1]) {
        Some(i) => {
            let allowed = format!("more than {}, the time before: a rate cannot jump", times[i - 1]);
            Err(FieldError::new(format!("{field}.list.time_s.{i}"), times[i], allowed))
        }
        None => Ok(()),
    }
}

fn no_pulse(field: &str) -> FieldError {
    let allowed = "rise_s and hold_s, and optionally start_s and reverse_s, for the history pulse";
    FieldError::new(format!("{field}.pulse"), "nothing", allowed)
}

fn no_list(field: &str) -> FieldError {
    FieldError::new(format!("{field}.list"), "nothing", "time_s and share, for the history list")
}
