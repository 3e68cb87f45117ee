//! The clearance of a point from another point or from a solid.

pub(crate) mod assembly;
pub(crate) mod fields;

use crate::elements::contact::ContactSolid;
use crate::elements::lines::place;
use crate::elements::{Context, Declaration, Element, Output};
use crate::model::Attachment;
use crate::scalar::Scalar;

/// Outputs the distance of a point x from a solid, m: d = |x - c|, with c the nearest point of its surface; negative
/// inside, where it is the distance to the nearest face. A second point is a sphere of radius 0.
#[derive(Clone, Debug)]
pub struct Clearance<S = f64> {
    /// Name in the results.
    pub name: String,
    /// The point.
    pub point: Attachment<S>,
    /// The solid's centre and axes.
    pub place: Attachment<S>,
    /// The solid from which the distance is measured.
    pub solid: ContactSolid<S>,
}

impl<S: Scalar> Element<S> for Clearance<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let what = "distance of a point from another point, or from the surface of a solid; negative: inside the solid";
        let outputs = vec![Output::number("clearance", what, "clearance_sensor", &self.name, &["m"])];
        Declaration { outputs, ..Declaration::default() }
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let (point, solid) = (place(&self.point, at.model, at.links), at.links.attachment_frame(at.model, &self.place));
        let (distance, _) = self.solid.distance(solid.rotation.transpose_times(point - solid.position));
        out.push(distance);
    }
}
