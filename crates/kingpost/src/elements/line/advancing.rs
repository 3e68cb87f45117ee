//! A line in the stages of an explicit scheme.

use super::step::{Booked, CONVERGED, MOST_ITERATIONS};
use super::supply::Supplied;
use super::{DynamicLine, ENERGIES};
use crate::elements::{Advancing, Context, NotAdvanced};
use crate::scalar::Scalar;

impl<S: Scalar> DynamicLine<S> {
    /// Computes the forces on the nodes at the ends at a stage, to which the line was advanced; the water is that of the
    /// middle of the step.
    ///
    /// The rate of strain is that of the implicit rule at the ends too: the first positions of an explicit step are those of
    /// Euler's method, and the nodes between the ends follow them.
    pub(super) fn evaluate_ends(&mut self, at: &Context<'_, S>) -> Option<Supplied<S>> {
        let supplied = self.put_nodes(at, at.states);
        let by_rule = self.end_nodes().map(|node| self.step.has_advanced().then(|| self.step.velocity(node)));
        self.nodes.stretch_ends(&self.mesh, by_rule);
        self.book_ends(supplied.is_some(), at);
        for node in self.held_nodes() {
            let water = self.step.water_at(node, at.clock.time_s);
            self.nodes.load_end(node, &self.mesh, self.ground.as_ref(), water, at);
        }
        supplied
    }
}

impl<S: Scalar> Advancing<S> for DynamicLine<S> {
    fn begin_step(&mut self, at: &Context<'_, S>, states: &[S]) {
        let rate = self.put_nodes(at, states).map_or(S::ZERO, |supplied| supplied.rate);
        self.at_base = [states[self.motions()], states[self.motions() + 1]];
        self.step.begin(&self.nodes, &mut self.mesh, (self.ground.as_ref(), rate), at);
    }

    fn advance(&mut self, at: &Context<'_, S>, states: &mut [S]) -> Result<(), NotAdvanced> {
        self.supply(at);
        let ends = self.ends_now(at);
        self.step.advance(&self.mesh, self.ground.as_ref(), &ends, at.clock.time_s).map_err(|move_m| NotAdvanced {
            move_m,
            allowed_m: CONVERGED * self.mesh.shortest().value(),
            iterations: MOST_ITERATIONS,
        })?;
        let motions = self.motions();
        let (positions, velocities) = states[..motions].split_at_mut(motions / 2);
        for (k, (x, v)) in positions.chunks_exact_mut(3).zip(velocities.chunks_exact_mut(3)).enumerate() {
            self.step.position(k + 1).write_to(x);
            self.step.velocity(k + 1).write_to(v);
        }
        Ok(())
    }

    /// Writes the velocities of the ends by the implicit rule, with which the rate of strain at the ends is that of the nodes
    /// beside them. Returns heat and work of the water, J. The heat contains the energy that the scheme loses: the ends get the
    /// work of the tension by the scheme of the bodies, the line gives it by its implicit rule.
    fn end_step(&mut self, at: &Context<'_, S>, states: &mut [S]) -> [S; 2] {
        let gravity = at.world.gravity;
        let Booked { dissipated, outside, on_ends } = self.step.booked(&self.mesh, self.ground.as_ref(), gravity);
        let [worked, lost] = self.at_base;
        let motions = self.motions();
        let lost_now = on_ends - (states[motions] - worked);
        states[motions + 1] = lost + lost_now;
        self.put_nodes(at, states);
        for (k, node) in self.end_nodes().into_iter().enumerate() {
            let lag = self.step.velocity(node) - self.nodes.node(node).velocity;
            lag.write_to(&mut states[motions + ENERGIES + 3 * k..motions + ENERGIES + 3 * k + 3]);
        }
        [dissipated + lost_now, outside]
    }
}
