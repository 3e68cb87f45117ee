//! The stretch of a rope, and its tension.

use super::drum::PaidOut;
use super::release::is_off;
use super::{BY_STRETCH, PARTED, PARTS, PathLength, RELEASED, Rope, SHORTEST, SLACK, TAUT};
use crate::elements::{Context, ElementState};
use crate::scalar::Scalar;

/// A rope at a moment.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stretched<S> {
    /// L, m, including the rope that the drum has paid out.
    pub unstretched: S,
    pub paid_out: PaidOut<S>,
    /// e, m, and its rate, m/s.
    pub stretch: S,
    pub rate: S,
    /// k e and T without the weight of the rope, N; both 0 if the rope is slack.
    pub elastic: S,
    pub tension: S,
    /// (k e)^2 / (2 EA), N: strain energy per length of the rope that is wound on the drum.
    pub carried: S,
    /// rad.
    pub range_left: S,
}

impl<S: Scalar> Rope<S> {
    /// Returns the mode of the rope; at rest the mode follows from the stretch, unless the rope is released or parted.
    pub(super) fn condition(&self, at: &Context<'_, S>) -> i64 {
        let begins = if self.begins_released { RELEASED } else { BY_STRETCH };
        let mode = at.modes.first().copied().unwrap_or(begins);
        if at.evaluation.runs() || is_off(mode) { mode } else { BY_STRETCH }
    }

    /// Returns a length, m, that is positive if both the spring and the spring with its damper pull.
    pub(super) fn pull_length(&self, now: &Stretched<S>) -> S {
        now.stretch + self.damping_time * now.rate.select_below(0.0, || now.rate, || S::ZERO)
    }

    /// Sets the reference of the drum's wrap and of the rope paid out, at the start of a run before an equilibrium is
    /// sought. Returns the length of the path, m.
    pub fn begin_at(&mut self, at: &Context<'_, S>) -> S {
        self.path.begin(at);
        if let Some(drum) = &mut self.drum {
            drum.start = at.q[drum.position];
        }
        self.path.extent(at).length
    }

    /// Returns the tension at a stretch at rest, N; negative for a negative stretch.
    pub fn tension_at_rest(&self, stretch: S) -> S {
        stretch / (self.unstretched_length / self.axial_stiffness + self.series_compliance)
    }

    /// Sets the mode of a rope by its lever and its present stretch.
    pub(super) fn hang(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        let now = self.stretched(at);
        let pull = self.pull_length(&now);
        own.modes[0] = match (pull.all(|pull| pull >= 0.0), pull.all(|pull| pull < 0.0)) {
            _ if at.is_let_go() => RELEASED,
            _ if self.inextensible.is_some() => self.held_at_start(at),
            (true, _) => TAUT,
            (_, true) => SLACK,
            _ => BY_STRETCH,
        };
    }

    /// Sets the mode of a rope that begins to pull: taut, or parted if its tension, from the damper alone as it comes
    /// taut, exceeds the breaking load.
    pub(super) fn pull_or_part(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        own.modes[0] = TAUT;
        if self.inextensible.is_some() {
            return;
        }
        let now = self.stretched(&Context { modes: &[TAUT], ..*at });
        let largest = self.tensions(at, &now).1;
        if self.breaking_load.is_some_and(|load| (largest - load).all(|beyond| beyond > 0.0)) {
            own.modes[0] = PARTED;
            own.also = Some(PARTS);
        }
    }

    /// Returns the largest tension on its path at the present positions, N.
    pub fn tension_here(&mut self, at: &Context<'_, S>) -> S {
        let now = self.stretched(at);
        self.tensions(at, &now).1
    }

    /// Returns its geometry and stretch, without tension.
    pub(super) fn laid(&mut self, at: &Context<'_, S>) -> Stretched<S> {
        let PathLength { length, rate, range_left } = self.path.extent(at);
        let no_drum =
            PaidOut { length: S::ZERO, per_angle: S::ZERO, rate: S::ZERO, bias_acceleration: S::ZERO, left: S::ONE };
        let paid_out = self.drum.map_or(no_drum, |drum| drum.paid_out(at));
        let unstretched = self.unstretched_length + paid_out.length;
        let (stretch, rate) = (length - unstretched, rate - paid_out.rate);
        let [elastic, tension, carried] = [S::ZERO; 3];
        Stretched { unstretched, paid_out, stretch, rate, elastic, tension, carried, range_left }
    }

    pub(super) fn stretched(&mut self, at: &Context<'_, S>) -> Stretched<S> {
        let laid = self.laid(at);
        let Stretched { unstretched, stretch, rate, .. } = laid;
        if let Some(own) = &self.inextensible {
            let tension = if self.condition(at) == TAUT { own.tension } else { S::ZERO };
            return Stretched { tension, ..laid };
        }
        let shortest = self.shortest();
        let elastic_length = unstretched.select_less(shortest, || shortest, || unstretched);
        let stiffness = S::ONE / (elastic_length / self.axial_stiffness + self.series_compliance);
        let spring = |stretch: S| stiffness * stretch;
        let pulling = |force: S| force.select_below(0.0, || S::ZERO, || force);
        let (elastic, pull) = (spring(stretch), spring(stretch + self.damping_time * rate));
        let where_longer = |force: S| stretch.select_below(0.0, || S::ZERO, || force);
        let (elastic, tension) = match self.condition(at) {
            TAUT => (elastic, pull),
            // Without a damper a slack rope is stretched by rounding only, which would falsify the energy of a step.
            SLACK if self.damping_time.all(|time| time == 0.0) => (S::ZERO, S::ZERO),
            SLACK => (where_longer(elastic), S::ZERO),
            PARTED | RELEASED => (S::ZERO, S::ZERO),
            _ => (where_longer(elastic), pulling(where_longer(pull))),
        };
        let strain_energy = || elastic * elastic / (self.axial_stiffness + self.axial_stiffness);
        let carried = unstretched.select_less(shortest, || S::ZERO, strain_energy);
        Stretched { elastic, tension, carried, ..laid }
    }

    /// Returns the tensions at its first and its last end, and the largest on its path, N.
    pub(super) fn tensions(&self, at: &Context<'_, S>, now: &Stretched<S>) -> ([S; 2], S) {
        let [first, _] = self.path.pull(now.tension, now.rate, |_, _| {});
        self.with_weight(at, now, [first, now.tension])
    }

    pub(super) fn shortest(&self) -> S {
        self.unstretched_length * S::constant(SHORTEST)
    }
}
