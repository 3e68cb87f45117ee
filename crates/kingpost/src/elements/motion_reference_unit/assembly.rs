//! Assembly of a motion reference unit.

use crate::elements::hull::HullFrame;
use crate::elements::sensing::assembly as sensing;
use crate::elements::{AnyElement, HeaveFilter, MotionReferenceUnit};
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::assembly::rigid_bodies::{from_centre, rigid};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema;
use crate::spatial::Vector3;

impl<S: Quantity> Assemble<S> for schema::MotionReferenceUnit<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        let field = |rest: &str| format!("sensors.{name}.motion_reference_unit.{rest}");
        rigid(at.scenario, field("body"), &self.body)?;
        let angle = self.angle_errors.as_ref().map(sensing::of_angle);
        let rate = self.rate_errors.as_ref().map(sensing::of_rate);
        let heave = self.heave_errors.as_ref().map(sensing::of_length);
        let heave_rate = self.heave_rate_errors.as_ref().map(sensing::of_speed);
        let mut errors =
            vec![angle, angle, heave, heave_rate, rate, rate, rate, heave, heave_rate, heave, heave_rate, angle];
        errors.truncate(MotionReferenceUnit::<S>::signals(self.horizontal_motion));
        let sampling = (self.period_s, self.delay_samples);
        let sampler = sensing::sampler(at.scenario, [name, "motion_reference_unit"], errors, sampling, self.drop_outs)?;
        let receiver = self.heave_filter.as_ref().and_then(|filter| filter.receiver.as_ref());
        let on = (&self.body, self.position_m);
        let receiver =
            receiver.map(|receiver| sensing::position_aid(at.scenario, &field("heave_filter.receiver"), receiver, on));
        let receiver = receiver.transpose()?;
        let Some(body) = at.model.body(&self.body).filter(|_| self.enabled) else { return Ok(Vec::new()) };
        let heave_filter = self.heave_filter.as_ref().map(|filter| HeaveFilter {
            cutoff: S::constant(core::f64::consts::TAU) / filter.cutoff_period_s.get(),
            damping_ratio: filter.damping_ratio.get(),
        });
        let place = HullFrame { body, origin: from_centre(at.scenario, &self.body, Vector3(self.position_m)) };
        let horizontal = self.horizontal_motion;
        let name = name.to_owned();
        Ok(vec![Box::new(MotionReferenceUnit { name, place, horizontal, sampler, heave_filter, receiver })])
    }
}
