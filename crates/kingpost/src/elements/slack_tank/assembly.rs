//! Tanks with a free surface.

use crate::elements::hull::HullFrame;
use crate::elements::{AnyElement, SlackTank};
use crate::model::Model;
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::assembly::rigid_bodies::{from_centre, rigid};
use crate::scenario::assembly::{FieldError, still_water};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Force as ForceSchema, Scenario};
use crate::sea::hull::BoxTank;
use crate::spatial::Vector3;

impl<S: Quantity> Assemble<S> for schema::SlackTank<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        Ok(slack(at.scenario, name, self, at.model)?.into_iter().collect())
    }
}

/// Returns a slack tank, if it is enabled and its body exists.
fn slack<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::SlackTank<S>,
    model: &Model<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    let field = format!("forces.{name}.slack_tank");
    rigid(scenario, format!("{field}.body"), &given.body)?;
    let Some(body) = model.body(&given.body).filter(|_| given.enabled) else { return Ok(None) };
    check_body(scenario, model, body, &format!("{field}.body"))?;
    if still_water::gravity(scenario).is_err() {
        return Err(FieldError::new(field, "a free surface, but no gravity", "gravity that is enabled"));
    }
    Ok(Some(Box::new(SlackTank {
        name: name.to_owned(),
        place: HullFrame { body, origin: from_centre(scenario, &given.body, Vector3(given.position_m)) },
        tank: BoxTank {
            edges: Vector3([given.length_m, given.breadth_m, given.height_m].map(|edge| edge.get())),
            filling: given.filling.get(),
        },
        density: density(scenario, given),
    })))
}

/// Checks that a body with tanks can move and is at least as heavy as their liquid.
fn check_body<S: Quantity>(
    scenario: &Scenario<S>,
    model: &Model<S>,
    body: usize,
    field: &str,
) -> Result<(), FieldError> {
    let (name, mass_kg) = (&model.bodies[body].name, model.bodies[body].mass);
    if model.bodies[body].link.is_none() {
        return Err(FieldError::new(field, format!("{name}, which is fixed to the world"), "a body that moves"));
    }
    let tanks = scenario.forces.values().filter_map(slack_tank_of);
    let on_body = tanks.filter(|tank| tank.enabled && *tank.body == **name);
    let liquid = |tank: &schema::SlackTank<S>| {
        density(scenario, tank) * tank.length_m.get() * tank.breadth_m.get() * tank.height_m.get() * tank.filling.get()
    };
    let liquid_kg = on_body.map(liquid).fold(S::ZERO, |sum, liquid| sum + liquid);
    if (mass_kg - liquid_kg).all(|rest| rest >= 0.0) {
        return Ok(());
    }
    let [mass_t, liquid_t] = [mass_kg, liquid_kg].map(|mass| mass / S::constant(1000.0));
    let found = format!("{name} of {mass_t:.3} t, with {liquid_t:.3} t of liquid in its slack tanks");
    Err(FieldError::new(field, found, "a body whose mass is at least that of the liquid, which is part of it"))
}

/// Returns the density of a tank's liquid, kg/m^3.
fn density<S: Quantity>(scenario: &Scenario<S>, tank: &schema::SlackTank<S>) -> S {
    let of_sea = || scenario.sea.clone().unwrap_or_default().density_kg_m3;
    tank.density_kg_m3.unwrap_or_else(of_sea).get()
}

fn slack_tank_of<S>(force: &ForceSchema<S>) -> Option<&schema::SlackTank<S>> {
    if let ForceSchema::SlackTank(tank) = force { Some(tank) } else { None }
}
