//! Assembly of an input shaper.

use crate::elements::{Input, InputShaper, ShaperKind, Swing, shaper_taps};
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::controller_reader::ControllerReader;
use crate::scenario::leaf::Quantity;
use crate::scenario::schema;

/// Most steps in the period of a shaper: each is a number in a snapshot.
const MOST_STEPS: f64 = 20_000.0;

impl<S: Quantity> ControllerReader<'_, S> {
    /// Assembles a shaper before the input that it sets.
    pub(crate) fn shaper(
        &self,
        name: &str,
        given: &schema::InputShaper<S>,
        to: Input,
    ) -> Result<InputShaper<S>, FieldError> {
        let field = |rest: &str| format!("controllers.{name}.input_shaper.{rest}");
        let step_s = self.step_s();
        let (period, damping_ratio) = (given.period_s.get(), given.damping_ratio.get());
        if let Some(found) = period.outside(|period| 2.0 * step_s < period && period <= MOST_STEPS * step_s) {
            let allowed = format!("more than two steps, {}, to {MOST_STEPS} steps", 2.0 * step_s);
            return Err(FieldError::new(field("period_s"), found, allowed));
        }
        if let Some(found) = damping_ratio.outside(|ratio| ratio < 1.0) {
            return Err(FieldError::new(field("damping_ratio"), found, "a number from 0 to below 1"));
        }
        let kind = match given.shaper {
            schema::ShaperKind::Zv => Some(ShaperKind::Zv),
            schema::ShaperKind::Zvd => Some(ShaperKind::Zvd),
            schema::ShaperKind::Ei => Some(ShaperKind::Ei),
            schema::ShaperKind::None => None,
        };
        let swing = Swing { period, damping_ratio, tolerance: given.tolerance.get() };
        let taps =
            kind.filter(|_| given.enabled).map_or_else(|| vec![(0, S::ONE)], |kind| shaper_taps(kind, swing, step_s));
        Ok(InputShaper { name: name.to_owned(), to, taps })
    }
}
