//! The forces at a spot: the normal force, and friction that holds or slides.

use super::friction::{FrictionForce, Rubbing};
use super::length::length;
use super::sides::{Met, Sides};
use super::{
    BEGINS_TO_SLIDE, BY_DEPTH, Contact, ContactSolid, DIRECTION_M, EVENTS, Friction, HOLDS, JUST_HOLDS, LEAVES, OPEN,
    ROUNDING_M, SLIDES, TOUCHES,
};
use crate::elements::{Context, Crossing, ElementState, EvaluationMode, hunt_crossley};
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// The normal force of a spot.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pressed<S> {
    /// N, N.
    pub(super) normal: S,
    /// Stored, J.
    pub(super) energy: S,
    /// W.
    pub(super) heat: S,
}

/// Returns the mode of a spot; while an equilibrium is sought, the mode that follows from the depth.
pub(super) fn condition<S>(i: usize, at: &Context<'_, S>) -> i64 {
    if at.evaluation.runs() { at.modes.get(i).copied().unwrap_or(BY_DEPTH) } else { BY_DEPTH }
}

impl<S: Scalar> Contact<S> {
    /// Sets the bristles straight at the present positions, at the start of a run before the equilibrium is sought.
    pub fn begin_at(&mut self, at: &Context<'_, S>) {
        let sides = self.sides_at(at);
        self.anchors = (0..self.spots.len()).map(|i| self.met(i, &sides).middle).collect();
    }

    /// Returns the depth of the deepest spot at the present positions, m; negative without contact.
    pub fn depth(&self, at: &Context<'_, S>) -> S {
        let sides = self.sides_at(at);
        let depths = (0..self.spots.len()).map(|i| self.met(i, &sides).depth);
        depths.fold(S::constant(f64::MIN), |most, depth| most.select_less(depth, || depth, || most))
    }

    pub(super) fn events_of_a_spot(&self) -> usize {
        if self.friction.is_some() { EVENTS.len() } else { BEGINS_TO_SLIDE }
    }

    pub(super) fn sides_at(&self, at: &Context<'_, S>) -> Sides<S> {
        Sides::new(&self.sides, at)
    }

    pub(super) fn met(&self, i: usize, sides: &Sides<S>) -> Met<S> {
        let (facing, spot) = &self.spots[i];
        let solid = self.solids[1 - *facing as usize].as_ref();
        sides.met(*facing, spot, solid.unwrap_or(&ContactSolid::Sphere { radius: S::ZERO }))
    }

    /// Returns the forces of a spot that touches.
    pub(super) fn acting(
        &self,
        i: usize,
        sides: &Sides<S>,
        at: &Context<'_, S>,
    ) -> Option<(Met<S>, Pressed<S>, FrictionForce<S>)> {
        let mode = condition(i, at);
        if mode == OPEN {
            return None;
        }
        let met = self.met(i, sides);
        if mode == BY_DEPTH && met.depth.all(|depth| depth < 0.0) {
            return None;
        }
        let pressed = self.pressed(mode, &met);
        let drag = self.friction.map_or(
            FrictionForce { force: Vector3::zero(), rate: Vector3::zero(), heat: S::ZERO },
            |own| {
                let rubbing = self.rubbing(&own, &met, pressed.normal, self.bristle(i, &met, at));
                match mode {
                    HOLDS => own.holding(&rubbing),
                    SLIDES => own.sliding(&rubbing),
                    _ => own.up_to_its_limit(&rubbing),
                }
            },
        );
        Some((met, pressed, drag))
    }

    /// Returns the indicator of an event of a spot.
    pub(super) fn indicator(&self, event: usize, i: usize, met: &Met<S>, at: &Context<'_, S>) -> S {
        let mode = condition(i, at);
        let never = if EVENTS[event].crossing == Crossing::Rising { -S::ONE } else { S::ONE };
        let is_watched = match event {
            TOUCHES => matches!(mode, OPEN | BY_DEPTH),
            LEAVES => mode != OPEN,
            BEGINS_TO_SLIDE => matches!(mode, HOLDS | BY_DEPTH),
            _ => mode == SLIDES,
        };
        if !is_watched {
            return never;
        }
        match (event, self.friction) {
            (LEAVES, _) if mode != BY_DEPTH => met.depth + S::constant(ROUNDING_M),
            (TOUCHES | LEAVES, _) | (_, None) => met.depth,
            (BEGINS_TO_SLIDE, Some(friction)) => {
                let rubbing = self.rubbing(&friction, met, self.pressed(mode, met).normal, self.bristle(i, met, at));
                length(friction.holding(&rubbing).force) - rubbing.limit
            }
            _ => {
                let along = met.along(self.bristle(i, met, at));
                along.dot(met.slip()) / length(along)
            }
        }
    }

    pub(super) fn pressed(&self, mode: i64, met: &Met<S>) -> Pressed<S> {
        match mode {
            OPEN => Pressed { normal: S::ZERO, energy: S::ZERO, heat: S::ZERO },
            BY_DEPTH => self.by_depth(met),
            _ => self.at_depth(met.depth, met),
        }
    }

    pub(super) fn by_depth(&self, met: &Met<S>) -> Pressed<S> {
        self.at_depth(met.depth.select_below(0.0, || S::ZERO, || met.depth), met)
    }

    fn at_depth(&self, depth: S, met: &Met<S>) -> Pressed<S> {
        let (normal, heat) = hunt_crossley(self.stiffness, self.dissipation, depth, met.rate());
        Pressed { normal: normal * met.gain, energy: self.stiffness * depth * depth * S::constant(0.5), heat }
    }

    pub(super) fn rubbing(&self, friction: &Friction<S>, met: &Met<S>, normal: S, bristle: Vector3<S>) -> Rubbing<S> {
        let limit = friction.coefficient * normal.select_below(0.0, || S::ZERO, || normal);
        let depth = met.depth.select_below(0.0, || S::ZERO, || met.depth);
        let damping_time = self.dissipation * depth;
        Rubbing { limit, bristle, along: met.along(bristle), slip: met.slip(), damping_time }
    }

    /// Returns the bristle of a spot; while an equilibrium is sought, its displacement since the search began.
    pub(super) fn bristle(&self, i: usize, met: &Met<S>, at: &Context<'_, S>) -> Vector3<S> {
        let own = 3 * i..3 * i + 3;
        if at.evaluation == EvaluationMode::Settling {
            let anchor = at.numbers.get(own).map_or(self.anchors[i], Vector3::from_slice);
            return met.along(met.middle - anchor);
        }
        let has_states = self.friction.is_some() && !at.states.is_empty();
        if has_states { Vector3::from_slice(&at.states[own]) } else { Vector3::zero() }
    }

    pub(super) fn let_go(&self, i: usize, own: &mut ElementState<'_, S>) {
        own.modes[i] = OPEN;
        if self.friction.is_some() {
            own.states[3 * i..3 * i + 3].fill(S::ZERO);
        }
    }

    /// Starts contact at a spot: it holds, unless its friction would grow faster than its limit.
    pub(super) fn touch(&self, i: usize, friction: &Friction<S>, met: &Met<S>, own: &mut ElementState<'_, S>) {
        let (slip, stiffest) = (met.slip(), friction.coefficient * self.stiffness * met.rate());
        let slides = (friction.stiffness * length(slip) - stiffest).all(|beyond| beyond > 0.0);
        own.modes[i] = if slides { SLIDES } else { HOLDS };
        let size = if slides { S::constant(DIRECTION_M) } else { S::ZERO };
        (slip * (size / length(slip))).write_to(&mut own.states[3 * i..]);
    }

    /// Lets a spot in contact hold if its bristle can hold it. Otherwise the spot slides, and the bristle turns to a
    /// direction between friction and slip, with the same length and energy. A bristle that pushes along the motion
    /// while the normal force falls is released.
    pub(super) fn hold_or_slide(
        &self,
        i: usize,
        friction: &Friction<S>,
        met: &Met<S>,
        bristle: Vector3<S>,
        own: &mut ElementState<'_, S>,
    ) {
        // At the surface, where both friction and its limit are 0, their rates decide.
        if met.depth.all(|depth| depth <= 0.0) {
            return self.touch(i, friction, met, own);
        }
        let rubbing = self.rubbing(friction, met, self.pressed(HOLDS, met).normal, bristle);
        let force = friction.holding(&rubbing).force;
        let size = length(force);
        let holds = (size - rubbing.limit * S::constant(JUST_HOLDS)).all(|beyond| beyond <= 0.0);
        let pushes = force.dot(rubbing.slip).all(|power| power <= 0.0);
        let is_straight = bristle.0.iter().all(|x| x.all(|x| x == 0.0));
        if !holds && pushes && !is_straight {
            let half = rubbing.along * S::constant(0.5);
            let none = length(half).select_below(DIRECTION_M, || S::ZERO, || S::ONE);
            return self.hold_or_slide(i, friction, met, half * none, own);
        }
        let holds = holds || pushes;
        own.modes[i] = if holds { HOLDS } else { SLIDES };
        let long = length(rubbing.along);
        let long = long.select_below(DIRECTION_M, || S::constant(DIRECTION_M), || long);
        // A direction between friction and slip, so that the spot does not hold again at once.
        let between = force * (S::ONE / size) + rubbing.slip * (S::ONE / length(rubbing.slip));
        let bristle = if holds { bristle } else { between * (long / length(between)) };
        bristle.write_to(&mut own.states[3 * i..]);
    }
}
