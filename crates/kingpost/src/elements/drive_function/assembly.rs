//! Commands that are functions of time.

use crate::elements::{CubicSpline, DriveFunction, Input};
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::controller_reader::all_finite;
use crate::scenario::leaf::Quantity;
use crate::scenario::schema;

/// A drive function; `step_s` is the length of a step.
pub fn drive_function<S: Quantity>(
    name: &str,
    given: &schema::DriveFunction<S>,
    to: Input,
    step_s: f64,
) -> Result<DriveFunction<S>, FieldError> {
    let field = |rest: &str| format!("controllers.{name}.drive_function.{rest}");
    let times_s: Vec<f64> = given.time_s.iter().map(|time| time.get()).collect();
    let least = if given.period_s.is_some() { 3 } else { 2 };
    if times_s.len() < least {
        let found = format!("{} of them", times_s.len());
        return Err(FieldError::new(field("time_s"), found, format!("at least {least} times")));
    }
    if given.command.len() != times_s.len() {
        let found = format!("{} commands", given.command.len());
        return Err(FieldError::new(field("command"), found, format!("{}, one for each time", times_s.len())));
    }
    if let Some(i) = (1..times_s.len()).find(|&i| times_s[i] <= times_s[i - 1]) {
        let allowed = format!("more than {}, the time before", times_s[i - 1]);
        return Err(FieldError::new(field(&format!("time_s.{i}")), times_s[i], allowed));
    }
    all_finite(&field("command"), &given.command)?;
    let lasts_s = times_s[times_s.len() - 1] - times_s[0];
    let period_s = given.period_s.map(|period| period.get());
    if let Some(period_s) = period_s.filter(|period_s| *period_s <= lasts_s) {
        let allowed = format!("more than {lasts_s}, from the first time to the last");
        return Err(FieldError::new(field("period_s"), period_s, allowed));
    }
    let commands = given.command.clone();
    let function = match period_s {
        Some(period_s) => CubicSpline::periodic(times_s, commands, period_s),
        None => CubicSpline::from_rest_to_rest(times_s, commands),
    };
    let function = given.enabled.then_some(function);
    Ok(DriveFunction { name: name.to_owned(), to, function, ramp_s: given.ramp_s.get(), step_s })
}
