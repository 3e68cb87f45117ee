//! Commands that are functions of time.

use crate::elements::{AnyElement, CubicSpline, DriveFunction};
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::assembly::finite::all_finite;
use crate::scenario::leaf::Quantity;
use crate::scenario::schema;

impl<S: Quantity> Assemble<S> for schema::DriveFunction<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        let field = |rest: &str| format!("controllers.{name}.drive_function.{rest}");
        let Some(to) = at.input(&self.to) else { return Ok(Vec::new()) };
        let times_s: Vec<f64> = self.time_s.iter().map(|time| time.get()).collect();
        let least = if self.period_s.is_some() { 3 } else { 2 };
        if times_s.len() < least {
            let found = format!("{} times", times_s.len());
            return Err(FieldError::new(field("time_s"), found, format!("at least {least} times")));
        }
        if self.command.len() != times_s.len() {
            let found = format!("{} commands", self.command.len());
            return Err(FieldError::new(field("command"), found, format!("{}, one for each time", times_s.len())));
        }
        if let Some(i) = (1..times_s.len()).find(|&i| times_s[i] <= times_s[i - 1]) {
            let allowed = format!("more than {}, the time before", times_s[i - 1]);
            return Err(FieldError::new(field(&format!("time_s.{i}")), times_s[i], allowed));
        }
        all_finite(&field("command"), &self.command)?;
        let lasts_s = times_s[times_s.len() - 1] - times_s[0];
        let period_s = self.period_s.map(|period| period.get());
        if let Some(period_s) = period_s.filter(|period_s| *period_s <= lasts_s) {
            let allowed = format!("more than {lasts_s}, from the first time to the last");
            return Err(FieldError::new(field("period_s"), period_s, allowed));
        }
        let commands = self.command.clone();
        let function = match period_s {
            Some(period_s) => CubicSpline::periodic(times_s, commands, period_s),
            None => CubicSpline::from_rest_to_rest(times_s, commands),
        };
        let function = self.enabled.then_some(function);
        let (name, ramp_s, step_s) = (name.to_owned(), self.ramp_s.get(), at.step_s());
        Ok(vec![Box::new(DriveFunction { name, to, function, ramp_s, step_s })])
    }
}
