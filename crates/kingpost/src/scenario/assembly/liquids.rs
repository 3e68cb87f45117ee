//! Parts that U-tanks and free-flooding tanks share: the liquid is a body, although the scenario gives the
//! tank as a force.

use crate::elements::{AnyElement, JointStop, StopSide};
use crate::model::{BodyDefinition, Joint, JointKind, MotionType, Node};
use crate::scenario::assembly::FieldError;
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Scenario};
use crate::spatial::SpatialInertia;

/// Stiffness of the stop at the end of a tank, as a ratio to the stiffness of the levels.
const STOP: f64 = 50.0;
/// Dissipation of this stop, s/m.
const STOP_DISSIPATION: f64 = 0.5;

/// The liquid of a tank for the tree of bodies.
pub(crate) struct LiquidBody<S> {
    pub definition: BodyDefinition<S>,
    /// Position of its joint at the start of the run.
    pub position: S,
    pub rotor_inertia: S,
}

/// Returns the liquid of the tank as a body on a joint, both with the tank's name; if the liquid is frozen,
/// the joint is held.
pub(crate) fn definition<S: Quantity>(
    name: &str,
    parent: usize,
    kind: JointKind<S>,
    flows: bool,
    (mass, inertia): (S, SpatialInertia<S>),
) -> BodyDefinition<S> {
    let mode = if flows { MotionType::Free } else { MotionType::Held };
    let joint = Joint { name: name.to_owned(), kind, mode };
    BodyDefinition { name: name.to_owned(), parent: Some(parent), joint, mass, inertia, points: Vec::new() }
}

/// Returns the stops at the lower and the upper end of the levels, m; `stiffness` is that of the levels, N/m,
/// and `turn` the joint's coordinate per metre of level.
pub(crate) fn stops<S: Quantity>(node: &Node<S>, ends: [S; 2], stiffness: S, turn: S) -> [AnyElement<S>; 2] {
    let stop = |side: StopSide, end: S| -> AnyElement<S> {
        Box::new(JointStop {
            position: node.positions,
            coordinate: node.velocities,
            side,
            limit: end * turn,
            stiffness: stiffness * S::constant(STOP) / (turn * turn),
            dissipation: S::constant(STOP_DISSIPATION) / turn,
        })
    };
    [stop(StopSide::Lower, ends[0]), stop(StopSide::Upper, ends[1])]
}

/// Checks that no body and no joint has the tank's name.
pub(crate) fn check_name<S: Quantity>(scenario: &Scenario<S>, name: &str) -> Result<(), FieldError> {
    let named = |(body, given): (&schema::Name, &schema::Body<S>)| {
        **body == *name || given.joint.name().is_some_and(|joint| joint.as_str() == name)
    };
    if scenario.bodies.iter().any(named) {
        let allowed = "a name that no body and no joint has: the liquid is a body with the tank's name";
        return Err(FieldError::new(format!("forces.{name}"), name, allowed));
    }
    Ok(())
}

/// Returns an error unless a value is less than its limit.
pub(crate) fn less<S: Quantity>(field: &str, value: S, limit: S, what: &str) -> Result<(), FieldError> {
    if (limit - value).all(|left| left > 0.0) {
        return Ok(());
    }
    Err(FieldError::new(field, value, format!("less than {what}, {limit}")))
}
