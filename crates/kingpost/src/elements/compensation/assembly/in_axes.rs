//! Compensation in several axes by chains of driven joints.

use crate::elements::compensation::assembly::hoists::{drive, driving, hung};
use crate::elements::compensation::assembly::{MotionSource, check, estimator, unit};
use crate::elements::compensation::{DrivenChain, DrivenJoint, Hoist};
use crate::elements::drives::ControlledDrive;
use crate::elements::{AnyElement, PlatformCompensation, ThreeAxisCompensation};
use crate::model::Model;
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::assembly::attachments::attachment;
use crate::scenario::leaf::Quantity;
use crate::scenario::schema;

impl<S: Quantity> Assemble<S> for schema::ThreeAxisCompensation<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        let lead = format!("controllers.{name}.three_axis_compensation");
        check(at.scenario, name, &lead, self.period_s.get())?;
        if !self.enabled {
            return Ok(Vec::new());
        }
        let rope = hung((at.scenario, at.model), &lead, [&self.rope, &self.drive], at.elements)?;
        let Hoist::Drum(drum) = rope.hoist else {
            let allowed = format!("the drive of the drum of {}", self.rope);
            return Err(FieldError::new(format!("{lead}.drive"), driving(at.scenario, &self.drive), allowed));
        };
        let joints = Joints { lead: &lead, given: &self.joints, least: 2, moves: "the tip of the crane" };
        let mut drives = joints.drives(at.elements)?;
        let chain = DrivenChain {
            joints: joints.below(at.model, rope.tip.link, &drives)?,
            damped_below: self.damped_below_m_s.get(),
        };
        drives.push(rope.drive);
        let source =
            MotionSource { sensor: self.sensor.as_ref(), horizontal: true, prediction: self.prediction.as_ref() };
        Ok(vec![Box::new(ThreeAxisCompensation {
            name: name.to_owned(),
            estimator: estimator(&lead, &source, self.period_s.get(), (at.elements, &drives))?.with_measured_arms(),
            chain,
            tip: rope.tip,
            falls: rope.falls,
            drum,
            winch: rope.drive.name.clone(),
            winch_speed: rope.speed,
            winch_limit: rope.drive.limits.speed,
            feed_forward: self.feed_forward.get(),
            gain: self.position_gain_per_s.get(),
            begins_on: self.begins_on,
        })])
    }
}

impl<S: Quantity> Assemble<S> for schema::PlatformCompensation<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        let lead = format!("controllers.{name}.platform_compensation");
        check(at.scenario, name, &lead, self.period_s.get())?;
        if !self.enabled {
            return Ok(Vec::new());
        }
        let pin = schema::Pin { body: self.body.clone(), position_m: self.position_m };
        let top = attachment(at.scenario, at.model, &format!("{lead}.position_m"), &pin)?;
        let joints = Joints { lead: &lead, given: &self.joints, least: 3, moves: &self.body };
        let drives = joints.drives(at.elements)?;
        let chain = DrivenChain { joints: joints.below(at.model, top.link, &drives)?, damped_below: S::ZERO };
        let source =
            MotionSource { sensor: self.sensor.as_ref(), horizontal: false, prediction: self.prediction.as_ref() };
        Ok(vec![Box::new(PlatformCompensation {
            name: name.to_owned(),
            base: unit(&lead, &source, at.elements)?.map(|unit| unit.place.body),
            estimator: estimator(&lead, &source, self.period_s.get(), (at.elements, &drives))?.with_measured_arms(),
            chain,
            top,
            feed_forward: self.feed_forward.get(),
            gain: self.position_gain_per_s.get(),
            begins_on: self.begins_on,
        })])
    }
}

/// The driven joints of a compensation.
struct Joints<'a> {
    lead: &'a str,
    given: &'a [schema::CompensationDrive],
    least: usize,
    /// The moved part, as text for an error.
    moves: &'a str,
}

impl Joints<'_> {
    fn field(&self, k: usize) -> String {
        format!("{}.joints.{k}.drive", self.lead)
    }

    fn drives<'a, S: Quantity>(
        &self,
        elements: &'a [AnyElement<S>],
    ) -> Result<Vec<&'a ControlledDrive<S>>, FieldError> {
        let count = self.given.len();
        if count < self.least {
            let allowed = format!("at least {} drives", self.least);
            return Err(FieldError::new(format!("{}.joints", self.lead), count, allowed));
        }
        let each = self.given.iter().enumerate();
        each.map(|(k, joint)| drive(&self.field(k), &joint.drive, elements)).collect()
    }

    /// Returns the joints of the drives; each must carry this link.
    fn below<S: Quantity>(
        &self,
        model: &Model<S>,
        end: Option<usize>,
        drives: &[&ControlledDrive<S>],
    ) -> Result<Vec<DrivenJoint<S>>, FieldError> {
        let way: Vec<usize> = core::iter::successors(end, |link| model.links.nodes[*link].parent).collect();
        let each = drives.iter().enumerate().map(|(k, drive)| {
            let owns = |link: &&usize| model.plan[**link].velocities == drive.coordinate;
            let Some(link) = way.iter().find(owns) else {
                let found = format!("{}, which drives {}", drive.name, model.coordinate_names()[drive.coordinate]);
                return Err(FieldError::new(
                    self.field(k),
                    found,
                    format!("the drive of a joint that carries {}", self.moves),
                ));
            };
            let set_point = drive.value;
            Ok(DrivenJoint {
                drive: drive.name.clone(),
                link: *link,
                coordinate: drive.coordinate,
                set_point,
                limit: drive.limits.speed,
            })
        });
        each.collect()
    }
}
