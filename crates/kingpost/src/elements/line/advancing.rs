//! A line in the stages of an explicit scheme.

use super::bend::LineEnds;
use super::step::{Booked, CONVERGED, MOST_ITERATIONS};
use super::strand::{Strand, shortest};
use super::supply::Supplied;
use super::{DynamicLine, ENERGIES, ends_by_rule};
use crate::elements::{Advancing, Context, NotAdvanced};
use crate::scalar::Scalar;
use crate::spatial::Vector3;

impl<S: Scalar> DynamicLine<S> {
    /// Computes the forces on the nodes at the ends on bodies at a stage, to which the lines were advanced; the water is that of the
    /// middle of the step.
    ///
    /// The rate of strain is that of the implicit rule at the ends too: the first positions of an explicit step are those of
    /// Euler's method, and the nodes between the ends follow them.
    pub(super) fn evaluate_ends(&mut self, at: &Context<'_, S>) -> Option<Supplied<S>> {
        let supplied = self.put_nodes(at, at.states);
        for (k, strand) in self.strands.iter_mut().enumerate() {
            let nodes = [0, strand.last()];
            let by_rule = nodes.map(|node| self.step.velocity(k, node));
            strand.nodes.stretch_ends(&strand.mesh, |point| self.step.tension(k, point), by_rule);
            strand.pulls = strand.nodes.pull_ends(strand.returned);
            for (pull, _) in strand.pulls.iter_mut().zip(&strand.ends).filter(|(_, end)| end.is_none()) {
                *pull = Vector3::zero();
            }
        }
        self.book_ends(supplied.is_some(), at);
        let Strand { pulls, nodes, .. } = &mut self.strands[0];
        pulls[0] -= nodes.feed().taken_up;
        for (k, strand) in self.strands.iter_mut().enumerate() {
            for (node, _) in [0, strand.last()].into_iter().zip(strand.ends).filter(|(_, end)| end.is_some()) {
                let water = self.step.water_at(k, node, at.clock.time_s);
                strand.nodes.load_end(node, &strand.mesh, strand.ground.as_ref(), water, at);
            }
        }
        supplied
    }
}

impl<S: Scalar> DynamicLine<S> {
    /// Advances the lines to the middle of the step, with the ends where their present velocities take them: the first stage has
    /// the mean damping of this interval. An iteration that does not converge is that of the next stage, which reports it.
    fn foresee(&mut self, at: &Context<'_, S>) {
        let half = S::constant(at.clock.middle_s - at.clock.time_s);
        let ends = self.strands.iter().map(|strand| {
            let LineEnds { places, directions } = strand.ends_now(at);
            let velocities = strand.end_velocities(at);
            LineEnds { places: [0, 1].map(|end| places[end] + velocities[end] * half), directions }
        });
        if self.step.advance(&self.strands, ends, at.clock.middle_s).is_ok() {
            self.step.pull(&self.strands, true);
        }
    }
}

impl<S: Scalar> Advancing<S> for DynamicLine<S> {
    fn begin_step(&mut self, at: &Context<'_, S>, states: &[S]) {
        let rate = self.put_nodes(at, states).map_or(S::ZERO, |supplied| supplied.rate);
        let energies = self.motions();
        self.at_base = [states[energies], states[energies + 1]];
        let per_s = S::constant(0.5 / (at.clock.middle_s - at.clock.time_s));
        let mut owed = states[energies + self.owed()..].chunks_exact(3);
        for (k, strand) in self.strands.iter_mut().enumerate() {
            for (end, owed) in strand.returned.iter_mut().take(ends_by_rule(k)).zip(&mut owed) {
                *end = Vector3::from_slice(owed) * per_s;
            }
        }
        self.step.begin(&mut self.strands, rate, at);
        self.foresee(at);
    }

    fn advance(&mut self, at: &Context<'_, S>, states: &mut [S]) -> Result<(), NotAdvanced> {
        self.supply(at);
        let ends = self.strands.iter().map(|strand| strand.ends_now(at));
        self.step.advance(&self.strands, ends, at.clock.time_s).map_err(|move_m| NotAdvanced {
            move_m,
            allowed_m: CONVERGED * shortest(&self.strands).value(),
            iterations: MOST_ITERATIONS,
        })?;
        let mut rest = states;
        for (strand, of) in self.strands.iter().enumerate() {
            let (motions, others) = rest.split_at_mut(of.motions());
            let (positions, velocities) = motions.split_at_mut(motions.len() / 2);
            for (k, (x, v)) in positions.chunks_exact_mut(3).zip(velocities.chunks_exact_mut(3)).enumerate() {
                self.step.position(strand, k + 1).write_to(x);
                self.step.velocity(strand, k + 1).write_to(v);
            }
            rest = others;
        }
        Ok(())
    }

    /// Writes the velocities of the ends by the implicit rule, with which the rate of strain at the ends is that of the nodes
    /// beside them. Returns heat and work of the water, J. The heat contains the energy that the scheme loses: the ends get the
    /// work of the tension by the scheme of the bodies, the line gives it by its implicit rule.
    fn end_step(&mut self, at: &Context<'_, S>, states: &mut [S]) -> [S; 2] {
        let Booked { dissipated, outside, on_ends } = self.step.booked(&self.strands, at.world.gravity);
        let [worked, lost] = self.at_base;
        let motions = self.motions();
        let lost_now = on_ends - (states[motions] - worked);
        states[motions + 1] = lost + lost_now;
        self.put_nodes(at, states);
        let mut by_rule = states[motions + ENERGIES..].chunks_exact_mut(3);
        for (strand, of) in self.strands.iter().enumerate() {
            for (node, lag) in [0, of.last()].into_iter().take(ends_by_rule(strand)).zip(&mut by_rule) {
                (self.step.velocity(strand, node) - of.nodes.node(node).velocity).write_to(lag);
            }
        }
        let mut owed = states[motions + self.owed()..].chunks_exact_mut(3);
        for strand in 0..self.strands.len() {
            for (end, owed) in (0..ends_by_rule(strand)).zip(&mut owed) {
                (Vector3::from_slice(owed) + self.step.impulse(strand, end)).write_to(owed);
            }
        }
        [dissipated + lost_now, outside]
    }
}
