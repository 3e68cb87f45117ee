//! Gangways: their ends and limits.

use super::{Gangway, OperatingRange};
use crate::elements::AnyElement;
use crate::scalar::Scalar;
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::assembly::attachments::attachment;
use crate::scenario::assembly::{FieldError, known};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Pin, WORLD};
use crate::spatial::{Frame, Vector3, rotation_from_roll_pitch_yaw};

impl<S: Quantity> Assemble<S> for schema::Gangway<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        let field = |rest: &str| format!("sensors.{name}.gangway.{rest}");
        let limits = [
            ("stroke_limits_m", self.stroke_limits_m),
            ("luff_limits_rad", self.luff_limits_rad),
            ("slew_limits_rad", self.slew_limits_rad),
        ];
        for (which, [least, most]) in limits {
            if !(most - least).all(|range| range > 0.0) {
                let found = format!("[{least}, {most}]");
                return Err(FieldError::new(field(which), found, "the smaller limit, then the larger"));
            }
        }
        if self.pedestal.body == self.landing.body {
            let allowed = format!("another body than pedestal.body, {}", self.pedestal.body);
            return Err(FieldError::new(field("landing.body"), &self.landing.body, allowed));
        }
        for (which, pin) in [("pedestal", &self.pedestal), ("landing", &self.landing)] {
            let bodies = at.scenario.bodies.keys().map(|body| body.as_str()).chain([WORLD]);
            known(&field(&format!("{which}.body")), &pin.body, bodies)?;
        }
        let is_there = |pin: &Pin<S>| pin.named_body().is_none_or(|body| at.model.body(body).is_some());
        if !self.enabled || !is_there(&self.pedestal) || !is_there(&self.landing) {
            return Ok(Vec::new());
        }
        let pedestal = attachment(at.scenario, at.model, &field("pedestal.position_m"), &self.pedestal)?;
        let landing = attachment(at.scenario, at.model, &field("landing.position_m"), &self.landing)?;
        let rotation = rotation_from_roll_pitch_yaw(Vector3([S::ZERO, S::ZERO, self.heading_rad]));
        let in_body = Frame { rotation, ..pedestal.in_body };
        Ok(vec![Box::new(Gangway {
            name: name.to_owned(),
            pedestal: at.model.attachment(pedestal.body, in_body),
            landing,
            length: self.length_m.get(),
            range: OperatingRange::new(name, limits.map(|(_, limits)| limits.map(Scalar::value))),
        })])
    }
}
