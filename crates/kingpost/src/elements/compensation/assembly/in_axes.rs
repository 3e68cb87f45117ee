//! Compensation in several axes by chains of driven joints.

use crate::elements::compensation::assembly::hoists::{drive, driving, hung};
use crate::elements::compensation::assembly::{MotionSource, check, estimator, unit};
use crate::elements::compensation::{DrivenChain, DrivenJoint, Hoist};
use crate::elements::drives::ControlledDrive;
use crate::elements::{AnyElement, PlatformCompensation, ThreeAxisCompensation};
use crate::model::Model;
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::attachments::attachment;
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Scenario};

/// The compensation in three axes, if it is enabled.
pub fn three_axis<S: Quantity>(
    (scenario, model): (&Scenario<S>, &Model<S>),
    name: &str,
    given: &schema::ThreeAxisCompensation<S>,
    elements: &[AnyElement<S>],
) -> Result<Option<AnyElement<S>>, FieldError> {
    let lead = format!("controllers.{name}.three_axis_compensation");
    check(scenario, name, &lead, given.period_s.get())?;
    if !given.enabled {
        return Ok(None);
    }
    let rope = hung((scenario, model), &lead, [&given.rope, &given.drive], elements)?;
    let Hoist::Drum(drum) = rope.hoist else {
        let allowed = format!("the drive of the drum of {}", given.rope);
        return Err(FieldError::new(format!("{lead}.drive"), driving(scenario, &given.drive), allowed));
    };
    let joints = Joints { lead: &lead, given: &given.joints, least: 2, moves: "the tip of the crane" };
    let mut drives = joints.drives(elements)?;
    let chain = DrivenChain {
        joints: joints.below(model, rope.tip.link, &drives)?,
        damped_below: given.damped_below_m_s.get(),
    };
    drives.push(rope.drive);
    let source =
        MotionSource { sensor: given.sensor.as_ref(), horizontal: true, prediction: given.prediction.as_ref() };
    Ok(Some(Box::new(ThreeAxisCompensation {
        name: name.to_owned(),
        estimator: estimator(&lead, &source, given.period_s.get(), (elements, &drives))?.with_measured_arms(),
        chain,
        tip: rope.tip,
        falls: rope.falls,
        drum,
        winch: rope.drive.name.clone(),
        winch_speed: rope.speed,
        winch_limit: rope.drive.limits.speed,
        feed_forward: given.feed_forward.get(),
        gain: given.position_gain_per_s.get(),
        begins_on: given.begins_on,
    })))
}

/// The platform's compensation, if it is enabled and its body exists.
pub fn platform<S: Quantity>(
    (scenario, model): (&Scenario<S>, &Model<S>),
    name: &str,
    given: &schema::PlatformCompensation<S>,
    elements: &[AnyElement<S>],
) -> Result<Option<AnyElement<S>>, FieldError> {
    let lead = format!("controllers.{name}.platform_compensation");
    check(scenario, name, &lead, given.period_s.get())?;
    if !given.enabled {
        return Ok(None);
    }
    let pin = schema::Pin { body: given.body.clone(), position_m: given.position_m };
    let top = attachment(scenario, model, &lead, &pin)?;
    let joints = Joints { lead: &lead, given: &given.joints, least: 3, moves: &given.body };
    let drives = joints.drives(elements)?;
    let chain = DrivenChain { joints: joints.below(model, top.link, &drives)?, damped_below: S::ZERO };
    let source =
        MotionSource { sensor: given.sensor.as_ref(), horizontal: false, prediction: given.prediction.as_ref() };
    Ok(Some(Box::new(PlatformCompensation {
        name: name.to_owned(),
        base: unit(&lead, &source, elements)?.map(|unit| unit.place.body),
        estimator: estimator(&lead, &source, given.period_s.get(), (elements, &drives))?.with_measured_arms(),
        chain,
        top,
        feed_forward: given.feed_forward.get(),
        gain: given.position_gain_per_s.get(),
        begins_on: given.begins_on,
    })))
}

/// The driven joints of a compensation.
struct Joints<'a> {
    lead: &'a str,
    given: &'a [schema::CompensationDrive],
    least: usize,
    /// Part that they move, in words.
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

    /// The joints of the drives, all on the way to this link.
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
