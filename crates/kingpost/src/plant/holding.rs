//! Constraints that elements hold while their modes say so: they act one way, come with an impact and let go.

use super::Plant;
use super::between_steps::instant;
use super::scene::Scene;
use crate::dynamics::loops::Projection;
use crate::dynamics::{LinkKinematics, Restraint};
use crate::elements::{AnyElement, Context, Layout};
use crate::integrate::Stage;
use crate::model::Model;
use crate::scalar::Scalar;
use crate::state::State;
use crate::world::World;

impl<S: Scalar> Plant<S> {
    /// Whether anything is constrained, by loops or by elements.
    pub(super) fn constrains(&self) -> bool {
        !self.model.loops.is_empty() || self.holds()
    }

    /// Whether an element holds, as the loads were evaluated last.
    fn holds(&self) -> bool {
        self.loads.restraints.iter().any(|restraint| restraint.acts)
    }

    /// The name of the element that holds a constraint, counted over the loops' constraints and then those that act.
    pub fn holds_behind_loops(&self, constraint: usize) -> Option<&str> {
        let place = constraint.checked_sub(self.model.constraint_count())?;
        let mut acting = self.loads.restraints.iter().filter(|restraint| restraint.acts);
        acting.nth(place).map(|restraint| restraint.name.as_str())
    }

    /// Evaluates the constraints that elements hold at a stage, where the kinematics stands.
    pub(super) fn evaluate_restraints(&mut self, at: Stage<'_, S>) {
        if self.layout.holding.is_empty() {
            return;
        }
        let Self { model, world, links, elements, layout, situation, loads, .. } = self;
        let mut scene = Scene::new(layout, world, model, links, *situation, at);
        for (&i, restraint) in layout.holding.iter().zip(&mut loads.restraints) {
            let at = scene.of(i);
            let Some(holding) = elements[i].holding_mut() else { continue };
            restraint.acts = holding.holds(at.modes);
            if restraint.acts {
                holding.restrain(at, restraint);
            }
        }
    }

    /// Hands the elements what they carry, as the accelerations were found last.
    pub(super) fn hand_out_multipliers(&mut self) {
        let mut multipliers = self.loops.of_restraints().iter();
        for (&i, restraint) in self.layout.holding.iter().zip(&self.loads.restraints) {
            let carried = if restraint.acts { multipliers.next().copied() } else { None };
            if let Some(holding) = self.elements[i].holding_mut() {
                holding.carry(carried.unwrap_or(S::ZERO));
            }
        }
    }

    /// Closes every constraint that acts by `work` with the solver; the kinematics stands at the corrected state then.
    pub(super) fn project<R>(
        &mut self,
        work: impl FnOnce(&mut super::LoopSolver<S>, &mut Projection<'_, S>) -> R,
    ) -> R {
        let Self { model, world, links, work: memory, loads, loops, elements, layout, .. } = self;
        let mut hold = |links: &LinkKinematics<S>, q: &[S], v: &[S], restraints: &mut [Restraint<S>]| {
            hold(elements, layout, world, model, links, (q, v), restraints);
        };
        work(loops, &mut Projection { model, links, work: memory, loads, hold: &mut hold })
    }

    /// Where modes were changed at a time: what has come taut strikes, and what would carry less than nothing lets go.
    pub(super) fn take_hold(&mut self, time_s: f64, state: &mut State<S>) {
        if self.layout.holding.is_empty() {
            return;
        }
        // With the inertia of the water, which an impact moves too.
        self.evaluate_loads(instant(time_s, state));
        if !self.holds() {
            self.hand_out_multipliers();
            return;
        }
        self.loops.forget_pivots();
        loop {
            let mut struck = state.v.clone();
            let impulses = self.project(|solver, on| solver.strike(on, &state.q, &mut struck).to_vec());
            if !self.let_go_of_least(&impulses, state) {
                state.v = struck;
                break;
            }
            self.evaluate_loads(instant(time_s, state));
        }
        loop {
            let mut v_dot = vec![S::ZERO; state.v.len()];
            self.acceleration(instant(time_s, state), None, &mut v_dot);
            let carried = self.loops.of_restraints().to_vec();
            if !self.let_go_of_least(&carried, state) {
                break;
            }
        }
        self.loops.forget_pivots();
    }

    /// Lets the element go that carries least, where that is less than nothing; returns whether one did.
    fn let_go_of_least(&mut self, carried: &[S], state: &mut State<S>) -> bool {
        let acting = self.layout.holding.iter().zip(&self.loads.restraints).filter(|(_, restraint)| restraint.acts);
        let least = acting.zip(carried).min_by(|(_, a), (_, b)| a.value().total_cmp(&b.value()));
        let Some(((&element, _), _)) = least.filter(|(_, carried)| carried.value() < 0.0) else { return false };
        let modes = self.layout.shares[element].modes.clone();
        if let Some(holding) = self.elements[element].holding_mut() {
            holding.let_go(&mut state.m[modes]);
        }
        true
    }

    /// While an equilibrium is sought: what held goes on to hold, and what has come taut begins to.
    pub fn keep_hold(&mut self, before: &[i64], state: &mut State<S>) {
        for &i in &self.layout.holding {
            let modes = self.layout.shares[i].modes.clone();
            if self.elements[i].holding().is_some_and(|holding| holding.holds(&before[modes.clone()])) {
                state.m[modes.clone()].copy_from_slice(&before[modes]);
            }
        }
        self.links.update(&self.model, &state.q, &state.v);
        self.evaluate_restraints(instant(0.0, state));
    }

    /// At rest: lets the element go that carries least, where that is less than nothing, as the accelerations were found
    /// last; returns whether one did.
    pub fn let_go_at_rest(&mut self, state: &mut State<S>) -> bool {
        let carried = self.loops.of_restraints().to_vec();
        self.let_go_of_least(&carried, state)
    }

    /// Moves q by what the constraints that elements hold make of its derivatives; its values are closed already.
    pub fn follow_restraints(&mut self, time_s: f64, state: &State<S>, q: &mut [S]) {
        self.evaluate_loads(instant(time_s, state));
        if self.holds() {
            self.project(|solver, on| solver.follow(on, q, &state.v));
        }
    }

    /// What the constraints carry at a stage, handed to the elements that watch it.
    pub(super) fn load_restraints(&mut self, at: Stage<'_, S>) {
        if self.layout.holding.is_empty() {
            return;
        }
        let mut v_dot = core::mem::take(&mut self.scratch);
        v_dot.resize(at.v.len(), S::ZERO);
        self.acceleration(at, None, &mut v_dot);
        self.scratch = v_dot;
    }
}

/// Writes the restraints that act; where that is said needs no entries of an element.
fn hold<S: Scalar>(
    elements: &mut [AnyElement<S>],
    layout: &Layout,
    world: &World<S>,
    model: &Model<S>,
    links: &LinkKinematics<S>,
    motion: (&[S], &[S]),
    restraints: &mut [Restraint<S>],
) {
    let at = Context::at_rest(world, model, links, motion);
    for (&i, restraint) in layout.holding.iter().zip(restraints) {
        if let Some(holding) = elements[i].holding_mut().filter(|_| restraint.acts) {
            holding.restrain(&at, restraint);
        }
    }
}
