//! Assembly of an input shaper.

use crate::elements::{AnyElement, InputShaper, ShaperKind, Swing, shaper_taps};
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema;

/// Largest number of steps in the period of a shaper: each step is a number in a snapshot.
const MOST_STEPS: f64 = 20_000.0;

impl<S: Quantity> Assemble<S> for schema::InputShaper<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        let field = |rest: &str| format!("controllers.{name}.input_shaper.{rest}");
        let Some(to) = at.input(&self.to) else { return Ok(Vec::new()) };
        let step_s = at.step_s();
        let (period, damping_ratio) = (self.period_s.get(), self.damping_ratio.get());
        if let Some(found) = period.outside(|period| 2.0 * step_s < period && period <= MOST_STEPS * step_s) {
            let allowed = format!("more than two steps, {}, to {MOST_STEPS} steps", 2.0 * step_s);
            return Err(FieldError::new(field("period_s"), found, allowed));
        }
        if let Some(found) = damping_ratio.outside(|ratio| ratio < 1.0) {
            return Err(FieldError::new(field("damping_ratio"), found, "a number from 0 to below 1"));
        }
        let kind = match self.shaper {
            schema::ShaperKind::Zv => Some(ShaperKind::Zv),
            schema::ShaperKind::Zvd => Some(ShaperKind::Zvd),
            schema::ShaperKind::Ei => Some(ShaperKind::Ei),
            schema::ShaperKind::None => None,
        };
        let swing = Swing { period, damping_ratio, tolerance: self.tolerance.get() };
        let taps =
            kind.filter(|_| self.enabled).map_or_else(|| vec![(0, S::ONE)], |kind| shaper_taps(kind, swing, step_s));
        Ok(vec![Box::new(InputShaper { name: name.to_owned(), to, taps })])
    }
}
