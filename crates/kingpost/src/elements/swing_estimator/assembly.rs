//! Assembly of a swing estimator.

use crate::elements::sensing::assembly as sensing;
use crate::elements::{AnyElement, SwingEstimator, SwingFilter};
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::assembly::rigid_bodies::rigid;
use crate::scenario::leaf::Quantity;
use crate::scenario::schema;

impl<S: Quantity> Assemble<S> for schema::SwingEstimator<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        let field = |rest: &str| format!("sensors.{name}.swing_estimator.{rest}");
        rigid(at.scenario, field("body"), &self.body)?;
        let sampling = (self.period_s, self.delay_samples);
        let errors = vec![None; SwingEstimator::<S>::SIGNALS];
        let sampler = sensing::sampler(at.scenario, [name, "swing_estimator"], errors, sampling, self.drop_outs)?;
        let schema::SwingFilter { rate_noise_rad_s, swing_rad, swing_period_s } = self.filter;
        sensing::long_enough(field("filter.swing_period_s"), swing_period_s, &sampler)?;
        let [noise, swing, period] = [rate_noise_rad_s, swing_rad, swing_period_s].map(|number| number.get());
        let filter = SwingFilter::new(sampler.period_s, noise, swing, period);
        sensing::exists(field("filter"), filter.is_finite())?;
        let Some(body) = at.model.body(&self.body).filter(|_| self.enabled) else { return Ok(Vec::new()) };
        let rate_errors = self.rate_errors.as_ref().map(sensing::of_rate);
        Ok(vec![Box::new(SwingEstimator { name: name.to_owned(), body, rate_errors, sampler, filter })])
    }
}
