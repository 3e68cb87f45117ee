//! A mooring line to an anchor, by the quasi-static catenary.

use super::catenary::{Catenary, EndForce, Span};
use super::{declaration_of_line, place, pull_at, shares};
use crate::dynamics::{LinkKinematics, Loads};
use crate::elements::{Context, Declaration, DrawnSeabed, Element, Support};
use crate::model::{Attachment, Model};
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// A [`Catenary`] from a fairlead on a body to an anchor in the world: quasi-static, always in its shape at rest,
/// without inertia and drag. It pulls with H towards the anchor and with V downwards, and the energy of its weight and
/// stretch is potential energy.
#[derive(Clone, Debug)]
pub struct CatenaryLine<S = f64> {
    /// Name in the results.
    pub name: String,
    /// Its upper end, on a body.
    pub fairlead: Attachment<S>,
    /// Its lower end in the world, m.
    pub anchor: Vector3<S>,
    /// The catenary between them.
    pub line: Catenary<S>,
}

/// Horizontal distance between fairlead and anchor, as a share of the length, below which H is proportional to the
/// distance.
const NEAREST: f64 = 1e-6;

impl<S: Scalar> Element<S> for CatenaryLine<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let mut declared = declaration_of_line(&self.name);
        declared.lines[0].seabed =
            self.line.on_seabed.then(|| DrawnSeabed { height_m: self.anchor[2].value(), gradient: [0.0; 2] });
        declared
    }

    /// Adds the pull at the fairlead.
    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        let (way, span) = self.way(at.model, at.links);
        let EndForce { horizontal, vertical } = self.line.force(&span);
        let per_length = horizontal / span.across;
        let pull = Vector3::new(per_length * way[0], per_length * way[1], -vertical);
        pull_at(&self.fairlead, pull, at, loads);
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let (_, span) = self.way(at.model, at.links);
        out.extend(self.line.tensions(&self.line.force(&span)));
    }

    fn draw(&mut self, at: &Context<'_, S>, points: &mut Vec<S>) {
        let (way, span) = self.way(at.model, at.links);
        let force = self.line.force(&span);
        for share in shares::<S>() {
            let Span { across, up } = self.line.place(&force, &span, S::ONE - share);
            let from_anchor = across / span.across;
            points.extend([
                self.anchor[0] - from_anchor * way[0],
                self.anchor[1] - from_anchor * way[1],
                self.anchor[2] + up,
            ]);
        }
    }

    fn supports(&self) -> Vec<Support> {
        let ends = [self.fairlead.body, None];
        let ties = self.fairlead.body.map(Support::Tie);
        [Support::Carries(ends), Support::Station(ends)].into_iter().chain(ties).collect()
    }

    fn left_out(&mut self, at: &Context<'_, S>, _loads: &Loads<S>) -> Option<String> {
        self.dynamics_left_out(at)
    }

    /// Returns the energy of its weight and stretch, J.
    fn potential_energy(&mut self, at: &Context<'_, S>) -> S {
        let (way, span) = self.way(at.model, at.links);
        let force = self.line.force(&span);
        let nearer = way[0] * way[0] + way[1] * way[1] - span.across * span.across;
        self.line.potential_energy(&span, &force) + force.horizontal / span.across * nearer * S::constant(0.5)
    }
}

impl<S: Scalar> CatenaryLine<S> {
    /// Returns the vector from the anchor to the fairlead, m.
    pub fn span(&self, model: &Model<S>, links: &LinkKinematics<S>) -> Span<S> {
        self.way(model, links).1
    }

    /// Returns the vector from the fairlead to the anchor in the world, and the span of the line, m.
    pub(super) fn way(&self, model: &Model<S>, links: &LinkKinematics<S>) -> (Vector3<S>, Span<S>) {
        let way = self.anchor - place(&self.fairlead, model, links);
        let square = way[0] * way[0] + way[1] * way[1];
        let nearest = self.line.unstretched_length * S::constant(NEAREST);
        let across = square.select_less(nearest * nearest, || nearest, || square.sqrt());
        (way, Span { across, up: -way[2] })
    }
}
