//! Lines between two points: mooring lines, hawsers, tugger lines.

pub(crate) mod assembly;
mod catenary;
mod catenary_line;
pub(crate) mod fields;
mod left_out;
mod spring_line;

pub use catenary::{Catenary, EndForce, Span};
pub use catenary_line::CatenaryLine;
pub use spring_line::SpringLine;

use super::{Context, Declaration, DrawnLine, LineStyle, Output};
use crate::dynamics::{LinkKinematics, Loads};
use crate::model::{Attachment, Model};
use crate::scalar::Scalar;
use crate::spatial::{Vector3, Wrench};

/// Number of points through which a line is drawn.
const POINTS: usize = 49;

/// Returns the declaration of every line: its tensions and its drawn line.
pub(super) fn declaration_of_line(name: &str) -> Declaration {
    let drawn = DrawnLine::thin(name, LineStyle::Line, POINTS);
    Declaration { outputs: outputs(name), lines: vec![drawn], ..Declaration::default() }
}

/// Returns the shares of a line's length, from its first end, at which its points are drawn.
pub(super) fn shares<S: Scalar>() -> impl Iterator<Item = S> {
    (0..POINTS).map(|i| S::constant(i as f64 / (POINTS - 1) as f64))
}

/// Returns the outputs of every line: the tension at its first end or fairlead and at its second end or anchor, N; the
/// unstretched length on the seabed, m.
fn outputs(name: &str) -> Vec<Output> {
    let first = "tension at the first end of a line, or its fairlead";
    let second = "tension at the second end of a line, or its anchor";
    let grounded = "unstretched length of a line that lies on the seabed";
    vec![
        Output::number("line_tension", first, "line", name, &["N"]),
        Output::number("line_end_tension", second, "line", name, &["N"]),
        Output::number("line_grounded_length", grounded, "line", name, &["m"]),
    ]
}

/// Returns the position of an end in the world, m.
pub(super) fn place<S: Scalar>(end: &Attachment<S>, model: &Model<S>, links: &LinkKinematics<S>) -> Vector3<S> {
    let point = end.in_body.position;
    end.body.map_or(point, |body| links.body_frame(model, body).point(point))
}

/// Returns the velocity of an end in the world, m/s.
pub(super) fn velocity<S: Scalar>(end: &Attachment<S>, at: &Context<'_, S>) -> Vector3<S> {
    let Some(body) = end.body else { return Vector3::zero() };
    let twist = at.links.body_twist(at.model, body);
    let in_body = twist.linear + twist.angular.cross(end.in_body.position);
    at.links.body_frame(at.model, body).rotation * in_body
}

/// Returns the length and direction of a vector. At length 0 there is no direction, but then a line is slack.
pub(super) fn length_and_direction<S: Scalar>(way: Vector3<S>) -> (S, Vector3<S>) {
    let square = way.norm_squared();
    let there = |value: S| square.select_below(f64::MIN_POSITIVE, || S::ZERO, || value);
    let root = square.select_below(f64::MIN_POSITIVE, || S::ONE, || square).sqrt();
    (there(root), way * (S::ONE / root))
}

/// Adds a force, in world axes, at an end on a body; an end in the world gets none.
pub(super) fn pull_at<S: Scalar>(end: &Attachment<S>, pull: Vector3<S>, at: &Context<'_, S>, loads: &mut Loads<S>) {
    let Some(body) = end.body else { return };
    let force = at.links.to_body_axes(at.model, body, pull);
    loads.wrenches.push((body, Wrench { moment: end.in_body.position.cross(force), force }));
}
