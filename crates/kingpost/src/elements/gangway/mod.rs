//! A gangway between two bodies: its stroke and angles, and its operating range.

pub(crate) mod assembly;
pub(crate) mod fields;
mod range;

pub use range::OperatingRange;

use crate::elements::{AnyWatcher, Context, Declaration, Element, Output};
use crate::model::Attachment;
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// Outputs stroke, luff and slew of a gangway: with r the way from the pedestal to the landing point in the axes of the pedestal,
/// x along the gangway at slew 0,
///
/// ```text
/// stroke = |r| - length,    luff = atan2(z, sqrt(x^2 + y^2)),    slew = atan2(y, x)
/// ```
#[derive(Clone, Debug)]
pub struct Gangway<S = f64> {
    /// Name in the results.
    pub name: String,
    /// The pedestal, with its axes.
    pub pedestal: Attachment<S>,
    /// The landing point.
    pub landing: Attachment<S>,
    /// Length at stroke 0, m.
    pub length: S,
    /// The watcher of its limits.
    pub range: OperatingRange,
}

impl<S: Scalar> Gangway<S> {
    /// Returns the way from the pedestal to the landing point, pedestal axes, m, and its rate.
    fn way(&self, at: &Context<'_, S>) -> [Vector3<S>; 2] {
        let pedestal = at.links.attachment_frame(at.model, &self.pedestal);
        let [there, here] = [&self.landing, &self.pedestal].map(|end| {
            let frame = at.links.attachment_frame(at.model, end);
            let moving = end.body.map_or(Vector3::zero(), |body| {
                let twist = at.links.body_twist(at.model, body);
                let rotation = at.links.body_frame(at.model, body).rotation;
                rotation * (twist.linear + twist.angular.cross(end.in_body.position))
            });
            (frame.position, moving)
        });
        let turning = self.pedestal.body.map_or(Vector3::zero(), |body| {
            at.links.body_frame(at.model, body).rotation * at.links.body_twist(at.model, body).angular
        });
        let way = there.0 - here.0;
        [way, there.1 - here.1 - turning.cross(way)].map(|vector| pedestal.rotation.transpose_times(vector))
    }
}

impl<S: Scalar> Element<S> for Gangway<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let number = |variable, what, unit| Output::number(variable, what, "gangway", &self.name, unit);
        let outputs = vec![
            number("gangway_stroke", "stroke of a gangway's telescope from its length at rest", &["m"]),
            number("gangway_stroke_rate", "rate of a gangway's stroke", &["m/s"]),
            number("gangway_luff", "luff angle of a gangway, up from the deck of its pedestal", &["rad"]),
            number("gangway_slew", "slew angle of a gangway, counter-clockwise", &["rad"]),
        ];
        Declaration { outputs, ..Declaration::default() }
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let [way, rate] = self.way(at);
        // At 0 the square roots have no derivative.
        let root = |square: S| (square + S::constant(f64::MIN_POSITIVE)).sqrt();
        let [x, y, z] = way.0;
        let (long, level) = (root(way.norm_squared()), root(x * x + y * y));
        out.extend([long - self.length, way.dot(rate) / long, z.atan2(level), y.atan2(x)]);
    }

    fn watchers(&self) -> Vec<AnyWatcher> {
        vec![Box::new(self.range.clone())]
    }
}
