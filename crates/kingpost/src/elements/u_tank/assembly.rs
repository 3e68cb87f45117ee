//! U-tanks: the liquid as a body on a hinge, its weight, losses, pump and stops.

use crate::elements::u_tank::drawn::rooms;
use crate::elements::u_tank::{UTankGeometry, UTankLiquid};
use crate::elements::{AnyElement, DrawnTank, UTank};
use crate::model::joint::Revolute;
use crate::model::{BodyDefinition, JointKind, Model};
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::assembly::liquids::{self, LiquidBody};
use crate::scenario::assembly::rigid_bodies::{from_centre, rigid};
use crate::scenario::assembly::{FieldError, still_water};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Force as ForceSchema, Scenario};
use crate::spatial::{Frame, Matrix3, Vector3};

/// Returns the U-tanks of a scenario.
fn of<S>(scenario: &Scenario<S>) -> impl Iterator<Item = (&schema::Name, &schema::UTank<S>)> {
    scenario.forces.iter().filter_map(|(name, force)| match force {
        ForceSchema::UTank(tank) => Some((name, &**tank)),
        _ => None,
    })
}

/// Returns the liquid of each U-tank as a body, whose parent is the index that `place` returns for the tank's body. A
/// tank whose body is disabled is left out.
pub(crate) fn bodies<S: Quantity>(
    scenario: &Scenario<S>,
    place: impl Fn(&str) -> Option<usize>,
) -> Result<Vec<LiquidBody<S>>, FieldError> {
    let mut found = Vec::new();
    for (name, given) in of(scenario) {
        let field = format!("forces.{name}.u_tank");
        rigid(scenario, format!("{field}.body"), &given.body)?;
        liquids::check_name(scenario, name)?;
        check(given, &field)?;
        let Some(parent) = place(&given.body) else { continue };
        let liquid = geometry(scenario, given).liquid();
        let rotor_inertia = liquid.rotor_inertia();
        if !rotor_inertia.all(|inertia| inertia >= 0.0) {
            let allowed = "a path of flow that carries all of the liquid: longer columns or a longer duct";
            return Err(FieldError::new(format!("{field}.column_distance_m"), given.column_distance_m.get(), allowed));
        }
        let position = given.initial_rise_m * liquid.turn;
        let definition = definition(scenario, name, given, parent, &liquid);
        found.push(LiquidBody { definition, position, rotor_inertia });
    }
    Ok(found)
}

fn definition<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::UTank<S>,
    parent: usize,
    liquid: &UTankLiquid<S>,
) -> BodyDefinition<S> {
    let up = |height: S| Vector3([S::ZERO, S::ZERO, height]);
    let duct = from_centre(scenario, &given.body, Vector3(given.position_m));
    let placement = Frame { rotation: Matrix3::identity(), position: duct + up(liquid.centre + liquid.arm) };
    let along = Vector3([S::ONE, S::ZERO, S::ZERO]);
    let kind = JointKind::Revolute(Revolute::new(placement, along, up(-liquid.arm)));
    liquids::definition(name, parent, kind, given.enabled, (liquid.mass, liquid.inertia))
}

impl<S: Quantity> Assemble<S> for schema::UTank<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        build(at.scenario, name, self, at.model)
    }

    fn tank(&self, name: &str, scenario: &Scenario<S>) -> Option<DrawnTank> {
        let place = from_centre(scenario, &self.body, Vector3(self.position_m));
        let rooms = rooms(name, place, &geometry(scenario, self), self.column_height_m.get(), self.enabled);
        Some(DrawnTank { name: name.to_owned(), body: self.body.to_string(), rooms })
    }
}

/// Returns weight, losses, pump and stops of a tank whose liquid flows.
fn build<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::UTank<S>,
    model: &Model<S>,
) -> Result<Vec<AnyElement<S>>, FieldError> {
    let bodies = model.body(&given.body).zip(model.body(name));
    let Some((carrier, body)) = bodies.filter(|_| given.enabled) else { return Ok(Vec::new()) };
    let Ok((gravity, _)) = still_water::gravity(scenario) else {
        let allowed = "gravity that is enabled";
        return Err(FieldError::new(format!("forces.{name}.u_tank"), "a free surface, but no gravity", allowed));
    };
    let node = &model.tree.nodes[body];
    let (position, coordinate) = (node.positions, node.velocities);
    let geometry = geometry(scenario, given);
    let liquid = geometry.liquid();
    let critical = (liquid.stiffness(gravity) * liquid.flow_mass).sqrt() * S::constant(2.0);
    let [top, duct] = [given.column_height_m.get(), given.duct_height_m.get() * S::constant(0.5)];
    let room = [top - geometry.level, geometry.level - duct];
    let room = room[0].select_less(room[1], || room[0], || room[1]);
    let tank = UTank {
        name: name.to_owned(),
        carrier,
        position,
        coordinate,
        geometry,
        liquid,
        linear_damping: given.damping_ratio.get() * critical,
        loss_coefficient: given.loss_coefficient.get(),
        pump: given.pump.as_ref().map(|pump| [pump.pressure_limit_pa.get(), pump.flow_limit_m3_s.get()]),
        ends: [top, duct],
    };
    let stops = liquids::stops(node, [-room, room], tank.liquid.stiffness(gravity), tank.liquid.turn);
    Ok(core::iter::once(Box::new(tank) as AnyElement<S>).chain(stops).collect())
}

fn geometry<S: Quantity>(scenario: &Scenario<S>, given: &schema::UTank<S>) -> UTankGeometry<S> {
    let of_sea = || scenario.sea.clone().unwrap_or_default().density_kg_m3;
    UTankGeometry {
        distance: given.column_distance_m.get(),
        column: [given.column_length_m, given.column_breadth_m].map(|edge| edge.get()),
        level: given.level_m.get(),
        duct: [given.duct_length_m.unwrap_or(given.column_length_m), given.duct_height_m].map(|edge| edge.get()),
        density: given.density_kg_m3.unwrap_or_else(of_sea).get(),
    }
}

/// Checks that the dimensions of columns and duct are consistent.
fn check<S: Quantity>(given: &schema::UTank<S>, field: &str) -> Result<(), FieldError> {
    let less = |at: &str, value, limit, what: &str| liquids::less(&format!("{field}.{at}"), value, limit, what);
    let duct_top = given.duct_height_m.get() * S::constant(0.5);
    let (level, top) = (given.level_m.get(), given.column_height_m.get());
    less("column_breadth_m", given.column_breadth_m.get(), given.column_distance_m.get(), "column_distance_m")?;
    less("level_m", level, top, "column_height_m")?;
    less("duct_height_m", duct_top + duct_top, level + level, "twice level_m")?;
    let rise = given.initial_rise_m;
    let size = rise.select_below(0.0, || -rise, || rise);
    less("initial_rise_m", size, top - level, "the room above the level")?;
    less("initial_rise_m", size, level - duct_top, "the depth down to the duct")
}
