//! Contacts, and the check that a load does not start inside its surface.

mod shapes;
pub(crate) mod solids;
mod touching;

use crate::dynamics::LinkKinematics;
use crate::elements::contact::{Friction, dissipation};
use crate::elements::ropes::assembly::at_start::at_rest;
use crate::elements::{AnyElement, Contact, of_kind, of_kind_mut};
use crate::model::Model;
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::assembly::attachments::attachment;
use crate::scenario::assembly::rigid_bodies::rigid;
use crate::scenario::assembly::{FieldError, known};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Scenario};
use crate::simulation::Setup;
use crate::spatial::{Frame, Vector3, rotation_from_roll_pitch_yaw};

/// Smallest restitution: below it the rebound is not visible.
const LEAST_RESTITUTION: f64 = 0.1;

impl<S: Quantity> Assemble<S> for schema::Contact<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        Ok(build(at.scenario, name, self, at.model)?.into_iter().collect())
    }
}

/// One contact, if it is enabled and both bodies exist.
fn build<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::Contact<S>,
    model: &Model<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    let field = |rest: &str| format!("forces.{name}.contact.{rest}");
    let schema::Contact { load, surface, .. } = given;
    check_bodies(scenario, given, &field)?;
    if !given.restitution.get().all(|e| e >= LEAST_RESTITUTION) {
        let allowed = format!("a number from {LEAST_RESTITUTION} to 1");
        return Err(FieldError::new(field("restitution"), given.restitution, allowed));
    }
    let (spots, solids) = shapes::shapes(load, surface, &field)?;
    let place = |which: &str, body: &schema::Name, position_m: [S; 3], orientation_rad: [S; 3]| {
        let pin = schema::Pin { body: body.clone(), position_m };
        if pin.named_body().is_some_and(|body| model.body(body).is_none()) {
            return Ok(None);
        }
        let at = attachment(scenario, model, &field(&format!("{which}.position_m")), &pin)?;
        let rotation = rotation_from_roll_pitch_yaw(Vector3(orientation_rad));
        Ok(Some(model.attachment(at.body, Frame { rotation, ..at.in_body })))
    };
    let of_load = place("load", &load.body, load.position_m, load.orientation_rad)?;
    let of_surface = place("surface", &surface.body, surface.position_m, surface.orientation_rad)?;
    let (Some(of_load), Some(of_surface), true) = (of_load, of_surface, given.enabled) else { return Ok(None) };
    let stiffness = given.stiffness_n_per_m.get();
    let coefficient = given.friction_coefficient.get();
    let along = given.friction_stiffness_n_per_m.map_or(stiffness, |along| along.get());
    Ok(Some(Box::new(Contact {
        name: name.to_owned(),
        sides: [of_load, of_surface],
        anchors: vec![Vector3::zero(); spots.len()],
        spots,
        solids,
        stiffness,
        dissipation: dissipation(given.restitution.get(), given.restitution_speed_m_s.get()),
        friction: (!coefficient.vanishes()).then_some(Friction { coefficient, stiffness: along }),
        tolerance: given.penetration_tolerance_m.get(),
        settles: false,
    })))
}

/// Checks that both bodies exist, are rigid and are different.
fn check_bodies<S: Quantity>(
    scenario: &Scenario<S>,
    given: &schema::Contact<S>,
    field: &impl Fn(&str) -> String,
) -> Result<(), FieldError> {
    let (load, surface) = (&given.load.body, &given.surface.body);
    rigid(scenario, field("load.body"), load)?;
    let bodies = scenario.bodies.keys().map(|body| body.as_str());
    known(&field("surface.body"), surface, bodies.chain([schema::WORLD]))?;
    if scenario.bodies.contains_key(surface) {
        rigid(scenario, field("surface.body"), surface)?;
    }
    if load == surface {
        let allowed = format!("another body than load.body, {load}");
        return Err(FieldError::new(field("surface.body"), surface, allowed));
    }
    Ok(())
}

/// Sets the bristles straight at the start of a run, with loops closed.
///
/// # Errors
/// A load that penetrates its surface by more than the tolerance.
pub fn begin<S: Quantity>(setup: &mut Setup<S>) -> Result<(), FieldError> {
    let Setup { model, world, elements, q, v, .. } = setup;
    let mut links = LinkKinematics::new(model);
    links.update(model, q, v);
    at_rest(world, model, &links, (q, v), |at| {
        of_kind_mut::<S, Contact<S>>(elements).try_for_each(|contact| {
            contact.begin_at(at);
            check_depth(contact, contact.depth(at), "where the run begins")
        })
    })
}

/// Checks that a load at rest is no deeper than the tolerance.
pub fn check_rest(setup: &Setup) -> Result<(), FieldError> {
    let Setup { model, world, elements, q, v, .. } = setup;
    let mut links = LinkKinematics::new(model);
    links.update(model, q, v);
    at_rest(world, model, &links, (q, v), |at| {
        of_kind::<f64, Contact>(elements)
            .try_for_each(|contact| check_depth(contact, contact.depth(at), "at rest: make the contact stiffer"))
    })
}

fn check_depth<S: Quantity>(contact: &Contact<S>, depth: S, place: &str) -> Result<(), FieldError> {
    if (depth - contact.tolerance).all(|beyond| beyond <= 0.0) {
        return Ok(());
    }
    let field = format!("forces.{}.contact.load", contact.name);
    let allowed = format!("at most its penetration_tolerance_m, {} m, {place}", contact.tolerance);
    Err(FieldError::new(field, format!("a load {depth:.4} m inside its surface"), allowed))
}
