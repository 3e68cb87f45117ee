//! Assembly of connections from the loops of a scenario.

use super::fields::Engagement;
use super::{Connection, PoseTolerance};
use crate::dynamics::LinkKinematics;
use crate::elements::{AnyElement, of_kind_mut};
use crate::model::Model;
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::loops::{Ends, constraints, ends};
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

/// Takes the positions at the start of a run as those at which connections that engage where they are hold.
pub(crate) fn begin<S: Quantity>(setup: &mut Setup<S>) {
    let Setup { model, elements, q, v, .. } = setup;
    let mut links = LinkKinematics::new(model);
    links.update(model, q, v);
    of_kind_mut::<S, Connection<S>>(elements).for_each(|connection| connection.take_start(model, &links));
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
