//! Place and angles of a load on its surface, and the speeds of its touches.

use super::length::length;
use crate::dynamics::loops::relative_pose;
use crate::elements::{Components, Context, Output, VectorFrame};
use crate::model::Attachment;
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// Numbers of a contact behind those of its points.
pub(super) const NUMBERS: [&str; 2] = ["impact_speed", "largest_impact_speed"];

/// Returns the outputs of a contact with this name, in the order of [`values`].
pub(super) fn outputs(name: &str) -> [Output; 5] {
    let number = |variable, what, unit| Output::number(variable, what, "contact", name, unit);
    let place = number("contact_position", "centre of a load's shape in the axes of its surface", &["m"]);
    [
        number(
            "contact_impact_speed",
            "relative normal speed at the latest touch of a load that did not touch; 0 before the first",
            &["m/s"],
        ),
        number(
            "contact_largest_impact_speed",
            "largest relative normal speed at a touch of any point of a load so far",
            &["m/s"],
        ),
        Output { components: Components::Axis, frame: VectorFrame::Surface, ..place },
        number("contact_tilt", "angle of a load's z axis from that of its surface", &["rad"]),
        number(
            "contact_heading",
            "angle of a load's x axis about the z axis of its surface, from its x axis",
            &["rad"],
        ),
    ]
}

/// Returns the outputs for the shapes of a load and a surface.
pub(super) fn values<S: Scalar>(at: &Context<'_, S>, [load, surface]: &[Attachment<S>; 2]) -> [S; 7] {
    let pose = relative_pose(at.model, at.links, [surface, load]);
    let [x, z] = [0, 2].map(|axis| pose.rotation.column(axis));
    let tilt = length(Vector3([z[0], z[1], S::ZERO])).atan2(z[2]);
    let of_touches = |which: usize| {
        let first = at.numbers.len().checked_sub(NUMBERS.len());
        first.map_or(S::ZERO, |first| at.numbers[first + which])
    };
    let Vector3([along, across, above]) = pose.position;
    [of_touches(0), of_touches(1), along, across, above, tilt, x[1].atan2(x[0])]
}

/// Records a touch with a relative normal speed, of a load that did not touch before or did.
pub(super) fn record<S: Scalar>(numbers: &mut [S], speed: S, is_alone: bool) {
    let [.., latest, largest] = numbers else { return };
    if is_alone {
        *latest = speed;
    }
    *largest = largest.select_less(speed, || speed, || *largest);
}
