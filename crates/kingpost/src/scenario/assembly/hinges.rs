//! Revolute joints that a scenario names: of a drum or a slewing crane.

use super::super::schema::{self, Scenario};
use super::{FieldError, known};
use crate::model::{JointKind, Model, Node, joint::Revolute};
use crate::scenario::leaf::Quantity;

/// A body's node and its revolute joint.
type Hinged<'a, S> = (&'a Node<S>, &'a Revolute<S>);

/// Returns the revolute joint of a drum or a slewing crane with this name; `None` if it does not exist.
pub(crate) fn hinge<'a, S: Quantity>(
    scenario: &Scenario<S>,
    field: &str,
    joint: &str,
    model: &'a Model<S>,
) -> Result<Option<Hinged<'a, S>>, FieldError> {
    let revolute = |(_, body): &(&schema::Name, &schema::Body<S>)| matches!(body.joint, schema::Joint::Revolute(_));
    let joints = scenario.bodies.iter().filter(revolute).map(|(name, body)| super::bodies::joint_name(name, body));
    known(field, joint, joints)?;
    let owner = model.coordinate(joint).and_then(|coordinate| model.owner(coordinate));
    Ok(owner.and_then(|(body, _)| {
        let node = &model.tree.nodes[body];
        if let JointKind::Revolute(hinge) = &node.kind { Some((node, hinge)) } else { None }
    }))
}
