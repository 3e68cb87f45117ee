//! A weightless line between two points: a mooring hawser, a towline, a tugger line.

use super::{declaration_of_line, length_and_direction, place, pull_at, shares, velocity};
use crate::dynamics::Loads;
use crate::elements::{Context, Declaration, Element, PresentSupport, Support, hunt_crossley};
use crate::model::Attachment;
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// A spring that only pulls. At the stretch s = L - L0 beyond the unstretched length L0,
///
/// ```text
/// T = EA / L0 s max(1 + a L', 0),   and 0 where s <= 0
/// ```
///
/// so the tension is continuous when the line comes taut, and the line never pushes (the law of [`hunt_crossley`]). The
/// energy EA / L0 s^2 / 2 is stored, the rest becomes heat.
#[derive(Clone, Debug)]
pub struct SpringLine<S = f64> {
    /// Name in the results.
    pub name: String,
    /// Its first end, on a body.
    pub first: Attachment<S>,
    /// Its second end, on another body or in the world.
    pub second: Attachment<S>,
    /// L0, m.
    pub unstretched_length: S,
    /// EA, N.
    pub axial_stiffness: S,
    /// a, s/m.
    pub dissipation: S,
}

impl<S: Scalar> Element<S> for SpringLine<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        declaration_of_line(&self.name)
    }

    /// Adds the pull at both ends and the line's heat.
    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        let (way, rate) = self.way(at);
        let (length, direction) = length_and_direction(way);
        let (tension, heat) = self.tension(length, direction.dot(rate));
        loads.power.dissipated += heat;
        let pull = direction * tension;
        pull_at(&self.first, pull, at, loads);
        pull_at(&self.second, -pull, at, loads);
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let (way, rate) = self.way(at);
        let (length, direction) = length_and_direction(way);
        let (tension, _) = self.tension(length, direction.dot(rate));
        out.extend([tension, tension, S::ZERO]);
    }

    /// Draws the line: straight if taut, with a sag if slack. A flat parabola that is longer than its chord d by e has
    /// the sag sqrt(3/8 d e).
    fn draw(&mut self, at: &Context<'_, S>, points: &mut Vec<S>) {
        let first = place(&self.first, at.model, at.links);
        let way = place(&self.second, at.model, at.links) - first;
        let (length, _) = length_and_direction(way);
        let longer = self.unstretched_length - length;
        let longer = longer.select_below(0.0, || S::ZERO, || longer);
        let sag = (S::constant(0.375) * length * longer).sqrt();
        for share in shares::<S>() {
            let point = first + way * share;
            let hangs = S::constant(4.0) * share * (S::ONE - share) * sag;
            points.extend([point[0], point[1], point[2] - hangs]);
        }
    }

    fn supports(&self) -> Vec<Support> {
        let ends = [self.first.body, self.second.body];
        vec![Support::Carries(ends), Support::Station(ends)]
    }

    fn present_supports(&mut self, _at: &Context<'_, S>) -> Vec<PresentSupport<S>> {
        vec![PresentSupport::Line([self.first, self.second])]
    }

    /// Returns the stored energy, J.
    fn potential_energy(&mut self, at: &Context<'_, S>) -> S {
        let way = self.way(at).0;
        let stretch = self.stretch(length_and_direction(way).0);
        self.stiffness() * stretch * stretch * S::constant(0.5)
    }
}

impl<S: Scalar> SpringLine<S> {
    /// Returns the vector from the first end to the second in the world, m, and its rate, m/s.
    fn way(&self, at: &Context<'_, S>) -> (Vector3<S>, Vector3<S>) {
        let way = place(&self.second, at.model, at.links) - place(&self.first, at.model, at.links);
        (way, velocity(&self.second, at) - velocity(&self.first, at))
    }

    fn tension(&self, length: S, rate: S) -> (S, S) {
        hunt_crossley(self.stiffness(), self.dissipation, self.stretch(length), rate)
    }

    fn stiffness(&self) -> S {
        self.axial_stiffness / self.unstretched_length
    }

    fn stretch(&self, length: S) -> S {
        let beyond = length - self.unstretched_length;
        beyond.select_below(0.0, || S::ZERO, || beyond)
    }
}
