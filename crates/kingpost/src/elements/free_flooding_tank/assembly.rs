//! Free-flooding tanks: the water as a body on a prismatic joint, its weight, pressures and stops.

use crate::elements::free_flooding_tank::drawn::room;
use crate::elements::free_flooding_tank::{ATMOSPHERE_PA, AirPump, FloodedColumn};
use crate::elements::{AnyElement, DrawnTank, FreeFloodingTank};
use crate::model::joint::Prismatic;
use crate::model::{JointKind, Model};
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::assembly::liquids::{self, LiquidBody};
use crate::scenario::assembly::rigid_bodies::{from_centre, rigid};
use crate::scenario::assembly::{FieldError, still_water};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Force as ForceSchema, Scenario};
use crate::spatial::{Frame, Matrix3, Vector3};
use crate::world::World;

/// Returns the free-flooding tanks of a scenario.
fn of<S>(scenario: &Scenario<S>) -> impl Iterator<Item = (&schema::Name, &schema::FreeFloodingTank<S>)> {
    scenario.forces.iter().filter_map(|(name, force)| match force {
        ForceSchema::FreeFloodingTank(tank) => Some((name, &**tank)),
        _ => None,
    })
}

/// Returns the water of the tanks as bodies, for parents at the indices that `place` returns; a tank whose carrier is
/// disabled has none.
pub(crate) fn bodies<S: Quantity>(
    scenario: &Scenario<S>,
    place: impl Fn(&str) -> Option<usize>,
) -> Result<Vec<LiquidBody<S>>, FieldError> {
    let mut found = Vec::new();
    for (name, given) in of(scenario) {
        let field = format!("forces.{name}.free_flooding_tank");
        rigid(scenario, format!("{field}.body"), &given.body)?;
        liquids::check_name(scenario, name)?;
        check(given, &field)?;
        let Some(parent) = place(&given.body) else { continue };
        let column = column(scenario, given);
        let centre = Vector3([S::ZERO, S::ZERO, column.level * S::constant(0.5)]);
        let opening = from_centre(scenario, &given.body, Vector3(given.position_m));
        let placement = Frame { rotation: Matrix3::identity(), position: opening + centre };
        let along = Vector3([S::ZERO, S::ZERO, S::ONE]);
        let kind = JointKind::Prismatic(Prismatic::new(placement, along, Vector3::zero()));
        found.push(LiquidBody {
            definition: liquids::definition(name, parent, kind, given.enabled, (column.mass(), column.inertia())),
            position: if given.enabled { given.initial_rise_m } else { S::ZERO },
            rotor_inertia: column.rotor_inertia(),
        });
    }
    Ok(found)
}

impl<S: Quantity> Assemble<S> for schema::FreeFloodingTank<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        build(at.scenario, name, self, at.model, at.world)
    }

    fn tank(&self, name: &str, scenario: &Scenario<S>) -> Option<DrawnTank> {
        let place = from_centre(scenario, &self.body, Vector3(self.position_m));
        let room = room(name, place, &column(scenario, self));
        Some(DrawnTank { name: name.to_owned(), body: self.body.to_string(), rooms: vec![room] })
    }
}

/// Returns the weight, pressures, losses and stops of a tank.
fn build<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::FreeFloodingTank<S>,
    model: &Model<S>,
    world: &World<S>,
) -> Result<Vec<AnyElement<S>>, FieldError> {
    let bodies = model.body(&given.body).zip(model.body(name));
    let Some((carrier, body)) = bodies else { return Ok(Vec::new()) };
    let field = format!("forces.{name}.free_flooding_tank");
    let Ok((gravity, _)) = still_water::gravity(scenario) else {
        return Err(FieldError::new(field, "a free surface, but no gravity", "gravity that is enabled"));
    };
    let column = column(scenario, given);
    let node = &model.tree.nodes[body];
    let stiffness = column.stiffness(gravity);
    let critical = (stiffness * (column.mass() + column.rotor_inertia())).sqrt() * S::constant(2.0);
    let ends = [-column.level, column.edges[2] - column.level];
    let tank = FreeFloodingTank {
        name: name.to_owned(),
        carrier,
        body,
        open: given.enabled,
        position: node.positions,
        coordinate: node.velocities,
        opening: from_centre(scenario, &given.body, Vector3(given.position_m)),
        column,
        linear_damping: given.damping_ratio.get() * critical,
        loss_coefficient: given.loss_coefficient.get(),
        pump: given.air_pump.as_ref().map(|pump| AirPump {
            pressure_limit: pump.pressure_limit_pa.get(),
            flow_limit: pump.flow_limit_m3_s.get(),
            response_time: pump.response_time_s.get(),
        }),
        water: world.plain_water(),
    };
    let stops = liquids::stops(node, ends, stiffness, S::ONE);
    Ok(core::iter::once(Box::new(tank) as AnyElement<S>).chain(stops).collect())
}

fn column<S: Quantity>(scenario: &Scenario<S>, given: &schema::FreeFloodingTank<S>) -> FloodedColumn<S> {
    FloodedColumn {
        edges: [given.length_m, given.breadth_m, given.height_m].map(|edge| edge.get()),
        level: given.level_m.get(),
        opening_area: given.opening_area_m2.get(),
        passage_length: given.passage_length_m.get(),
        density: scenario.sea.clone().unwrap_or_default().density_kg_m3.get(),
    }
}

/// Checks that level, opening and pump fit the tank.
fn check<S: Quantity>(given: &schema::FreeFloodingTank<S>, field: &str) -> Result<(), FieldError> {
    let (level, top, rise) = (given.level_m.get(), given.height_m.get(), given.initial_rise_m);
    let less = |at: &str, value, limit, what: &str| liquids::less(&format!("{field}.{at}"), value, limit, what);
    less("level_m", level, top, "height_m")?;
    less("initial_rise_m", rise, top - level, "the room above the level")?;
    less("initial_rise_m", -rise, level, "the depth down to the opening")?;
    let (opening, bottom) = (given.opening_area_m2.get(), given.length_m.get() * given.breadth_m.get());
    if !(bottom - opening).all(|left| left >= 0.0) {
        let allowed = format!("at most length_m times breadth_m, {bottom}");
        return Err(FieldError::new(format!("{field}.opening_area_m2"), opening, allowed));
    }
    let Some(pump) = &given.air_pump else { return Ok(()) };
    let limit = S::constant(ATMOSPHERE_PA);
    less("air_pump.pressure_limit_Pa", pump.pressure_limit_pa.get(), limit, "the pressure of the atmosphere")
}
