//! Assembly of an inertial unit.

use crate::elements::hull::HullFrame;
use crate::elements::inertial_unit::{Assumed, Design, Instruments};
use crate::elements::sensing::assembly as sensing;
use crate::elements::{AnyElement, InertialUnit};
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::assembly::rigid_bodies::{from_centre, rigid};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema;
use crate::spatial::Vector3;

impl<S: Quantity> Assemble<S> for schema::InertialUnit<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        let field = |rest: &str| format!("sensors.{name}.inertial_unit.{rest}");
        rigid(at.scenario, field("body"), &self.body)?;
        let sampling = (self.period_s, self.delay_samples);
        let errors = vec![None; InertialUnit::<S>::SIGNALS];
        let sampler = sensing::sampler(at.scenario, [name, "inertial_unit"], errors, sampling, self.drop_outs)?;
        let on = (&self.body, self.position_m);
        let receiver =
            self.receiver.as_ref().map(|receiver| sensing::position_aid(at.scenario, &field("receiver"), receiver, on));
        let receiver = receiver.transpose()?;
        let Some(body) = at.model.body(&self.body).filter(|_| self.enabled) else { return Ok(Vec::new()) };
        let filter = &self.filter;
        sensing::long_enough(field("filter.wave_period_s"), filter.wave_period_s, &sampler)?;
        let design = Design::new(&Assumed {
            period_s: sampler.period_s,
            acceleration_noise: filter.acceleration_noise_m_s2.get(),
            rate_noise: filter.rate_noise_rad_s.get(),
            heading_noise: filter.heading_noise_rad.get(),
            motion_m: filter.wave_motion_m.get(),
            motion_period_s: filter.wave_period_s.get(),
            receiver: receiver.as_ref().map(|receiver| [receiver.period_s, filter.position_noise_m.get()]),
        });
        sensing::exists(field("filter"), design.is_finite())?;
        let instruments = Instruments {
            acceleration: self.acceleration_errors.as_ref().map(sensing::of_acceleration),
            rate: self.rate_errors.as_ref().map(sensing::of_rate),
            heading: self.heading_errors.as_ref().map(sensing::of_angle),
        };
        let place = HullFrame { body, origin: from_centre(at.scenario, &self.body, Vector3(self.position_m)) };
        let name = name.to_owned();
        Ok(vec![Box::new(InertialUnit { name, place, instruments, sampler, design, receiver })])
    }
}
