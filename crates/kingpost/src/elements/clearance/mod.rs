//! The clearance between two points or solids.

pub(crate) mod assembly;
pub(crate) mod fields;

use crate::elements::contact::ContactSolid;
use crate::elements::{Context, Declaration, Element, Output};
use crate::model::Attachment;
use crate::scalar::Scalar;

/// Outputs the distance between two solids, m; a point is a sphere of radius 0. Of a point x from a solid it is d = |x - c|,
/// with c the nearest point of its surface; negative inside, where it is the distance to the nearest face.
#[derive(Clone, Debug)]
pub struct Clearance<S = f64> {
    /// Name in the results.
    pub name: String,
    /// Centres and axes of both.
    pub places: [Attachment<S>; 2],
    /// The first solid; `None` for a point.
    pub first: Option<ContactSolid<S>>,
    /// The solid from which the distance is measured.
    pub second: ContactSolid<S>,
}

impl<S: Scalar> Element<S> for Clearance<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let what = "distance between two points or solids; negative: a point inside a solid, or solids that overlap";
        let outputs = vec![Output::number("clearance", what, "clearance_sensor", &self.name, &["m"])];
        Declaration { outputs, ..Declaration::default() }
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let [own, from] = self.places.each_ref().map(|place| at.links.attachment_frame(at.model, place));
        let distance = match &self.first {
            None => self.second.distance(from.rotation.transpose_times(own.position - from.position)).0,
            Some(first) => self.second.distance_to(first, &from.inverse().times(&own)),
        };
        out.push(distance);
    }
}
