//! Lines that pull: mooring lines, hawsers, tugger lines.

mod catenary;
mod catenary_line;
mod spring_line;

pub use catenary::{Catenary, EndForce, Span};
pub use catenary_line::CatenaryLine;
pub use spring_line::SpringLine;

use super::{Moment, Output};
use crate::dynamics::{LinkKinematics, Loads};
use crate::model::{Attachment, Model};
use crate::scalar::Scalar;
use crate::spatial::{Vector3, Wrench};

/// What every line shows: the tension at its first end, or its fairlead, and at its second, or its anchor, N; how much of
/// its unstretched length lies on the seabed, m.
fn outputs(name: &str) -> Vec<Output> {
    let first = "tension of a line at its first end, or its fairlead";
    let second = "tension of a line at its second end, or its anchor";
    let grounded = "unstretched length of a line that lies on the seabed";
    vec![
        Output::number("line_tension", first, "line", name, &["N"]),
        Output::number("line_end_tension", second, "line", name, &["N"]),
        Output::number("line_grounded_length", grounded, "line", name, &["m"]),
    ]
}

/// Where an end is in the world, m.
fn place<S: Scalar>(end: &Attachment<S>, model: &Model<S>, links: &LinkKinematics<S>) -> Vector3<S> {
    let point = end.in_body.position;
    end.body.map_or(point, |body| links.body_frame(model, body).point(point))
}

/// How an end moves in the world, m/s.
fn velocity<S: Scalar>(end: &Attachment<S>, at: &Moment<'_, S>) -> Vector3<S> {
    let Some(body) = end.body else { return Vector3::zero() };
    let twist = at.links.body_twist(at.model, body);
    let in_body = twist.linear + twist.angular.cross(end.in_body.position);
    at.links.body_frame(at.model, body).rotation * in_body
}

/// Adds a force in world axes at an end; on the world itself nothing is added.
fn pull_at<S: Scalar>(end: &Attachment<S>, pull: Vector3<S>, at: &Moment<'_, S>, loads: &mut Loads<S>) {
    let Some(body) = end.body else { return };
    let force = at.links.to_body_axes(at.model, body, pull);
    loads.wrenches.push((body, Wrench { moment: end.in_body.position.cross(force), force }));
}
