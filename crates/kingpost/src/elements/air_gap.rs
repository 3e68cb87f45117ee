//! The height of a point above the surface of the sea.

use super::lines::place;
use super::{Context, Declaration, Element, Output, ShownWaves};
use crate::dynamics::Kinematics;
use crate::model::Attachment;
use crate::scalar::Scalar;

/// Outputs z - zeta(x, y, t), m: the height z of a point above the elevation zeta of the incident waves at that point,
/// or above the still water in a sea without waves; negative under water. (The air gap of DNV-OTG-13, without radiated
/// and diffracted waves, and with linear crests.)
#[derive(Clone, Debug)]
pub struct AirGap<S = f64> {
    /// Name in the results.
    pub name: String,
    /// The point.
    pub point: Attachment<S>,
}

impl<S: Scalar> Element<S> for AirGap<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let what = "height of a point above the surface of the incident waves; negative: under water";
        let outputs = vec![Output::number("air_gap", what, "air_gap_sensor", &self.name, &["m"])];
        Declaration { outputs, ..Declaration::default() }
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let [x, y, z] = place(&self.point, at.model, at.links).0;
        let waves = at.world.waves.as_ref().filter(|_| at.evaluation.has_waves());
        out.push(z - waves.map_or(S::ZERO, |waves| waves.elevation_m([x, y], at.clock.time_s)));
    }

    fn shown_waves(&self, bodies: &Kinematics<S>) -> Vec<(usize, ShownWaves<S>)> {
        let point = self.point.in_body.position;
        let [x, y, _] = self.point.body.map_or(point, |body| bodies.world[body].point(point)).0;
        vec![(0, ShownWaves::Elevation { place: [x, y], times: -S::ONE })]
    }
}
