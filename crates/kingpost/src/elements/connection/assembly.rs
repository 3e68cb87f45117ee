//! Assembly of connections from the loops of a scenario.

use super::fields::Engagement;
use super::{Connection, PoseTolerance};
use crate::dynamics::LinkKinematics;
use crate::elements::{AnyElement, Layout, of_kind, of_kind_mut};
use crate::model::{Constraint, Loop, Model};
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::loops::{Ends, constraints, ends, rest_in_loops};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Scenario};
use crate::simulation::Setup;

/// Returns the connections of a scenario, which are its loops with `connection`.
///
/// # Errors
/// A distance among the constraints.
pub(crate) fn build<S: Quantity>(scenario: &Scenario<S>, model: &Model<S>) -> Result<Vec<AnyElement<S>>, FieldError> {
    let mut elements: Vec<AnyElement<S>> = Vec::new();
    for (name, given) in &scenario.loops {
        let Some(connection) = &given.connection else { continue };
        check(name, given)?;
        if let Some(Ends { first, second }) = ends(scenario, model, name, given)? {
            let ends = [first, second].map(|end| model.attachment(end.body, end.in_body));
            let tolerance = tolerance(&connection.engages);
            let begins_released = connection.begins_released;
            elements.push(Box::new(Connection::new(name, ends, constraints(given), tolerance, begins_released)));
        }
    }
    Ok(elements)
}

/// Takes the positions at the start of a run as those at which connections that engage where they are hold, and removes the
/// velocities with which they would open.
///
/// # Errors
/// A constraint that depends on others or that no coordinate affects.
pub(crate) fn begin<S: Quantity>(setup: &mut Setup<S>) -> Result<(), FieldError> {
    let Setup { model, elements, q, v, .. } = setup;
    let mut links = LinkKinematics::new(model);
    links.update(model, q, v);
    of_kind_mut::<S, Connection<S>>(elements).for_each(|connection| connection.take_start(model, &links));
    let held = |connection: &Connection<S>| {
        let [first, second] = connection.held_at_start()?;
        let named = |(name, constraint): &(&str, Constraint<S>)| ((*name).to_owned(), *constraint);
        let constraints = connection.constraints.iter().map(named).collect();
        Some(Loop { name: connection.name.clone(), first, second, constraints })
    };
    let held: Vec<Loop<S>> = of_kind(elements).filter_map(held).collect();
    if held.is_empty() {
        return Ok(());
    }
    let all = model.loops.iter().cloned().chain(held).collect();
    rest_in_loops(&model.clone().with_loops(all), q, v)
}

/// Checks that no other element has an input with the name of a connection.
///
/// # Errors
/// A name that two inputs have.
pub(crate) fn check_inputs<S: Quantity>(elements: &[AnyElement<S>]) -> Result<(), FieldError> {
    let inputs = Layout::new(elements, 0).inputs;
    let twice = |connection: &&Connection<S>| inputs.iter().filter(|input| input.name == connection.name).count() > 1;
    let Some(Connection { name, .. }) = of_kind(elements).find(twice) else { return Ok(()) };
    let found = format!("{name}, the name of another input");
    Err(FieldError::new(format!("loops.{name}"), found, "a name that no force, drive or controller with an input has"))
}

fn tolerance<S: Quantity>(given: &Engagement<S>) -> Option<PoseTolerance<S>> {
    match given {
        Engagement::Within(within) => {
            Some(PoseTolerance { distance: within.distance_m.get(), angle: within.angle_rad.get() })
        }
        Engagement::WhereItIs => None,
    }
}

fn check<S: Quantity>(name: &str, given: &schema::Loop<S>) -> Result<(), FieldError> {
    let distance = |constraint: &schema::Constraint<S>| matches!(constraint, schema::Constraint::Distance(_));
    let Some(place) = given.constraints.iter().position(distance) else { return Ok(()) };
    Err(FieldError::new(
        format!("loops.{name}.constraints.{place}"),
        "distance, in a loop with connection",
        "x, y, z, roll, pitch and yaw; for a rod that lets go, a rope with can_be_released",
    ))
}
