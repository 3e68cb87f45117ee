//! Tanks with a free surface.

use super::super::schema::{self, Force as ForceSchema, Scenario};
use super::damping::{from_centre, rigid};
use super::reading::{Gathered, Reading};
use super::{FieldError, gravity_of};
use crate::elements::hull::HullFrame;
use crate::elements::{AnyElement, SlackTank};
use crate::model::Model;
use crate::scalar::Scalar;
use crate::sea::hull::BoxTank;

/// A slack tank, where it is on and its body there.
pub fn slack<S: Gathered>(
    scenario: &Reading<Scenario>,
    name: &str,
    model: &Model<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    let tank = scenario.part(|scenario| &scenario.forces[name]).kind(slack_tank_of);
    let (given, field) = (tank.first(), format!("forces.{name}.slack_tank"));
    rigid(scenario.first(), format!("{field}.body"), &given.body)?;
    let Some(body) = model.body(&given.body).filter(|_| given.enabled) else { return Ok(None) };
    check_body(scenario.first(), model, body, &format!("{field}.body"))?;
    if !scenario.first().forces.values().filter_map(gravity_of).any(|gravity| gravity.enabled) {
        return Err(FieldError::new(field, "a free surface, and no gravity", "gravity that is enabled"));
    }
    let position = tank.vector(|tank| tank.position_m);
    let densities: Vec<f64> =
        scenario.all().iter().zip(tank.all()).map(|(scenario, tank)| density(scenario, tank)).collect();
    Ok(Some(Box::new(SlackTank {
        name: name.to_owned(),
        place: HullFrame { body, origin: from_centre(scenario, &given.body, position) },
        tank: BoxTank {
            edges: tank.vector(|tank| [tank.length_m.get(), tank.breadth_m.get(), tank.height_m.get()]),
            filling: tank.number(|tank| tank.filling.get()),
        },
        density: tank.gathered(&densities),
        gravity: scenario.number(|scenario| {
            let acts = scenario.forces.values().filter_map(gravity_of).filter(|gravity| gravity.enabled);
            acts.map(|gravity| gravity.acceleration_m_s2.get()).sum()
        }),
    })))
}

/// A body with tanks moves, and is no lighter than what is in them.
fn check_body<S: Scalar>(scenario: &Scenario, model: &Model<S>, body: usize, field: &str) -> Result<(), FieldError> {
    let (name, mass_kg) = (&model.bodies[body].name, model.bodies[body].mass.value());
    if model.bodies[body].link.is_none() {
        return Err(FieldError::new(field, format!("{name}, which is fixed to the world"), "a body that moves"));
    }
    let tanks = scenario.forces.values().filter_map(slack_tank_of);
    let on_body = tanks.filter(|tank| tank.enabled && *tank.body == **name);
    let liquid = |tank: &schema::SlackTank| {
        density(scenario, tank) * tank.length_m.get() * tank.breadth_m.get() * tank.height_m.get() * tank.filling.get()
    };
    let liquid_kg: f64 = on_body.map(liquid).sum();
    if liquid_kg <= mass_kg {
        return Ok(());
    }
    let (mass_t, liquid_t) = (mass_kg / 1000.0, liquid_kg / 1000.0);
    let found = format!("{name} of {mass_t:.3} t, with {liquid_t:.3} t of liquid in its slack tanks");
    Err(FieldError::new(field, found, "a body whose mass is at least that of the liquid, which is part of it"))
}

/// Of a tank's liquid, kg/m^3.
fn density(scenario: &Scenario, tank: &schema::SlackTank) -> f64 {
    let of_sea = || scenario.sea.clone().unwrap_or_default().density_kg_m3;
    tank.density_kg_m3.unwrap_or_else(of_sea).get()
}

fn slack_tank_of(force: &ForceSchema) -> Option<&schema::SlackTank> {
    if let ForceSchema::SlackTank(tank) = force { Some(tank) } else { None }
}
