//! Hydraulic cylinders: their pins, and whether they start within their stroke.

use super::super::schema::{self, CylinderTarget, Scenario};
use super::flexible::carrier_in_model;
use super::reading::{Gathered, Reading};
use super::{FieldError, known};
use crate::dynamics::LinkKinematics;
use crate::elements::drives::{Aim, Cylinder};
use crate::elements::of_kind_mut;
use crate::model::{Attachment, Model};
use crate::scalar::Scalar;
use crate::simulation::Setup;
use crate::spatial::Frame;

/// One cylinder, where it is on and between bodies that are there.
pub fn build<S: Gathered>(
    scenario: &Reading<Scenario>,
    name: &str,
    model: &Model<S>,
) -> Result<Option<Cylinder<S>>, FieldError> {
    let drive = scenario.part(|scenario| &scenario.drives[name]);
    let given = drive.kind(cylinder_of);
    check(scenario.first(), name, given.first())?;
    let pins = [given.part(|given| &given.first), given.part(|given| &given.second)];
    let there = |pin: &Reading<schema::Pin>| pin.first().named_body().is_none_or(|body| model.body(body).is_some());
    if !given.first().enabled || !pins.iter().all(there) {
        return Ok(None);
    }
    let [first, second] = pins.map(|pin| attachment(scenario, model, &pin));
    let aim = match given.first().target {
        CylinderTarget::Hold => Aim::Hold,
        CylinderTarget::Length(_) => Aim::Length(given.number(target_length)),
        CylinderTarget::Lever => Aim::Lever,
    };
    Ok(Some(Cylinder {
        name: name.to_owned(),
        first,
        second,
        stiffness: given.number(|c| c.stiffness_n_per_m.get()),
        damping: given.number(|c| c.damping_n_s_per_m.get()),
        push_limit: given.number(|c| c.push_limit_n.get()),
        pull_limit: given.number(|c| c.pull_limit_n.get()),
        stroke: given.numbers(|c| [c.shortest_m.get(), c.longest_m.get()]),
        stop_stiffness: given.number(|c| c.stop_stiffness_n_per_m.get()),
        stop_dissipation: given.number(|c| c.stop_dissipation_s_per_m.get()),
        speed_limit: given.number(|c| c.speed_limit_m_s.get()),
        aim,
        start: S::ZERO,
        arrival_s: None,
    }))
}

fn cylinder_of(drive: &schema::Drive) -> Option<&schema::Cylinder> {
    if let schema::Drive::Cylinder(cylinder) = drive { Some(cylinder) } else { None }
}

fn target_length(cylinder: &schema::Cylinder) -> f64 {
    if let CylinderTarget::Length(target) = cylinder.target { target.length_m.get() } else { 0.0 }
}

/// The bodies exist, the stroke is one, and the target lies in it.
fn check(scenario: &Scenario, name: &str, given: &schema::Cylinder) -> Result<(), FieldError> {
    let field = |rest: &str| format!("drives.{name}.cylinder.{rest}");
    for (pin, which) in [(&given.first, "first.body"), (&given.second, "second.body")] {
        let bodies = scenario.bodies.keys().map(|body| body.as_str());
        known(&field(which), &pin.body, bodies.chain([schema::WORLD]))?;
    }
    let (shortest, longest) = (given.shortest_m.get(), given.longest_m.get());
    if longest <= shortest {
        return Err(FieldError::new(field("longest_m"), longest, format!("more than shortest_m, {shortest}")));
    }
    let target = target_length(given);
    if matches!(given.target, CylinderTarget::Length(_)) && !(shortest..=longest).contains(&target) {
        let allowed = format!("a length within the stroke, {shortest} to {longest}");
        return Err(FieldError::new(field("target.length.length_m"), target, allowed));
    }
    Ok(())
}

/// A pin seen from the centre of mass of its body.
fn attachment<S: Gathered>(
    scenario: &Reading<Scenario>,
    model: &Model<S>,
    pin: &Reading<schema::Pin>,
) -> Attachment<S> {
    let first = pin.first();
    let (body, centre) = carrier_in_model(scenario, model, first.named_body(), first.position_m);
    let in_body = Frame::translation(pin.vector(|pin| pin.position_m) - centre);
    model.attachment(body, in_body)
}

/// Takes the lengths where the run begins, its loops closed.
///
/// # Errors
/// A length outside of the stroke; pins that coincide have the length 0.
pub fn begin<S: Scalar>(setup: &mut Setup<S>) -> Result<(), FieldError> {
    let Setup { model, elements, q, v, .. } = setup;
    let mut links = LinkKinematics::new(model);
    links.update(model, q, v);
    for cylinder in of_kind_mut::<S, Cylinder<S>>(elements) {
        cylinder.start_at(model, &links);
        let (start, [shortest, longest]) = (cylinder.start, cylinder.stroke);
        let inside = (start - shortest).all(|beyond| beyond >= 0.0) && (longest - start).all(|left| left >= 0.0);
        if !inside {
            let found = format!("pins {:.4} m apart at the start", start.value());
            let allowed = format!("a length within the stroke, {} to {} m", shortest.value(), longest.value());
            return Err(FieldError::new(format!("drives.{}.cylinder", cylinder.name), found, allowed));
        }
    }
    Ok(())
}
