//! Constraints that elements hold while their modes require it: they start with an impact and end by release.

use super::Plant;
use super::between_steps::instant;
use super::element_contexts::ElementContexts;
use crate::dynamics::loops::Projection;
use crate::dynamics::{LinkKinematics, TemporaryConstraint};
use crate::elements::{AnyElement, Context, Layout};
use crate::integrate::Stage;
use crate::model::Model;
use crate::scalar::Scalar;
use crate::state::State;
use crate::world::World;

impl<S: Scalar> Plant<S> {
    /// Returns whether loops or elements constrain the motion.
    pub(super) fn constrains(&self) -> bool {
        !self.model.loops.is_empty() || self.holds()
    }

    /// Returns whether an element holds a constraint, at the last evaluation of the loads.
    fn holds(&self) -> bool {
        self.loads.restraints.iter().any(|restraint| restraint.acts)
    }

    /// Returns the constraint of an element; the index counts the loops' constraints first, then the active ones of elements.
    pub fn holds_behind_loops(&self, constraint: usize) -> Option<&TemporaryConstraint<S>> {
        let place = constraint.checked_sub(self.model.constraint_count())?;
        let mut acting = self.loads.restraints.iter().filter(|restraint| restraint.acts);
        acting.nth(place)
    }

    /// Evaluates the constraints that elements hold at a stage, for the present kinematics.
    pub(super) fn evaluate_restraints(&mut self, at: Stage<'_, S>) {
        if self.layout.holding.is_empty() {
            return;
        }
        let Self { model, world, links, elements, layout, evaluation, loads, .. } = self;
        let mut contexts = ElementContexts::new(layout, world, model, links, *evaluation, at);
        for (i, places) in &layout.holding {
            let at = contexts.of(*i);
            let Some(holding) = elements[*i].holding_mut() else { continue };
            let (acts, restraints) = (holding.holds(at.modes), &mut loads.restraints[places.clone()]);
            restraints.iter_mut().for_each(|restraint| restraint.acts = acts);
            if acts {
                holding.restrain(at, restraints);
            }
        }
    }

    /// Passes to the elements the forces of their constraints, from the last solution for the accelerations.
    pub(super) fn hand_out_multipliers(&mut self) {
        let mut multipliers = self.loops.of_restraints();
        for (i, places) in &self.layout.holding {
            let of_own = multipliers.split_off(..acting(&self.loads.restraints[places.clone()]));
            if let Some(holding) = self.elements[*i].holding_mut() {
                holding.carry(of_own.unwrap_or_default());
            }
        }
    }

    /// Calls `work` with the solver to project onto every active constraint; the kinematics must be that of
    /// the corrected state.
    pub(super) fn project<R>(
        &mut self,
        work: impl FnOnce(&mut super::LoopSolver<S>, &mut Projection<'_, S>) -> R,
    ) -> R {
        let Self { model, world, links, work: memory, loads, loops, elements, layout, .. } = self;
        let mut hold = |links: &LinkKinematics<S>, q: &[S], v: &[S], restraints: &mut [TemporaryConstraint<S>]| {
            hold(elements, layout, world, model, links, (q, v), restraints);
        };
        work(loops, &mut Projection { model, links, work: memory, loads, hold: &mut hold })
    }

    /// Updates the constraints after modes changed at a time: elements that have begun to hold cause an impact, and one-sided
    /// ones with a negative force release. Returns the heat of the impact, J.
    pub(super) fn take_hold(&mut self, time_s: f64, state: &mut State<S>) -> S {
        if self.layout.holding.is_empty() {
            return S::ZERO;
        }
        // The loads are evaluated with the added mass, because an impact moves it too.
        self.evaluate_loads(instant(time_s, state));
        if !self.holds() {
            self.hand_out_multipliers();
            return S::ZERO;
        }
        self.loops.forget_pivots();
        let heat = loop {
            let mut struck = state.v.clone();
            let (impulses, heat) = self.project(|solver, on| {
                let (impulses, heat) = solver.strike(on, &state.q, &mut struck);
                (impulses.to_vec(), heat)
            });
            if !self.let_go_of_least(&impulses, state) {
                state.v = struck;
                self.hand_out_impulses(&impulses, state);
                break heat;
            }
            self.evaluate_loads(instant(time_s, state));
        };
        loop {
            let mut v_dot = vec![S::ZERO; state.v.len()];
            self.acceleration(instant(time_s, state), None, &mut v_dot);
            let carried = self.loops.of_restraints().to_vec();
            if !self.let_go_of_least(&carried, state) {
                break;
            }
        }
        self.loops.forget_pivots();
        heat
    }

    /// Passes to the elements the impulses of their constraints in an impact.
    fn hand_out_impulses(&mut self, mut impulses: &[S], state: &mut State<S>) {
        for (i, places) in &self.layout.holding {
            let of_own = impulses.split_off(..acting(&self.loads.restraints[places.clone()]));
            let numbers = self.layout.slices[*i].numbers.clone();
            if let (Some(holding), Some(of_own)) = (self.elements[*i].holding_mut(), of_own) {
                holding.strike(of_own, &mut state.d[numbers]);
            }
        }
    }

    /// Releases the element of the one-sided constraint with the most negative force, if there is one; returns whether an
    /// element was released.
    fn let_go_of_least(&mut self, carried: &[S], state: &mut State<S>) -> bool {
        let holding = self.layout.holding.iter().flat_map(|(element, places)| places.clone().map(move |_| *element));
        let acting = holding.zip(&self.loads.restraints).filter(|(_, restraint)| restraint.acts);
        let one_sided = acting.zip(carried).filter(|((_, restraint), _)| restraint.is_one_sided);
        let least = one_sided.min_by(|(_, a), (_, b)| a.value().total_cmp(&b.value()));
        let Some(((element, _), _)) = least.filter(|(_, carried)| carried.value() < 0.0) else { return false };
        let modes = self.layout.slices[element].modes.clone();
        if let Some(holding) = self.elements[element].holding_mut() {
            holding.let_go(&mut state.m[modes]);
        }
        true
    }

    /// Updates the constraints during the search for an equilibrium: elements that held continue to hold, and
    /// elements that have become taut start to hold.
    pub fn keep_hold(&mut self, before: &[i64], state: &mut State<S>) {
        for &(i, _) in &self.layout.holding {
            let modes = self.layout.slices[i].modes.clone();
            if self.elements[i].holding().is_some_and(|holding| holding.holds(&before[modes.clone()])) {
                state.m[modes.clone()].copy_from_slice(&before[modes]);
            }
        }
        self.links.update(&self.model, &state.q, &state.v);
        self.evaluate_restraints(instant(0.0, state));
    }

    /// Releases, at rest, the element with the most negative force in the last solution for the
    /// accelerations, if there is one; returns whether an element was released.
    pub fn let_go_at_rest(&mut self, state: &mut State<S>) -> bool {
        let carried = self.loops.of_restraints().to_vec();
        self.let_go_of_least(&carried, state)
    }

    /// Corrects the derivatives of q for the constraints that elements hold; the values of q already satisfy
    /// them.
    pub fn follow_restraints(&mut self, time_s: f64, state: &State<S>, q: &mut [S]) {
        self.evaluate_loads(instant(time_s, state));
        if self.holds() {
            self.project(|solver, on| solver.follow(on, q, &state.v));
        }
    }

    /// Starts to monitor the closed loops: the distance from a singular position is measured relative to the
    /// present position.
    pub fn watch_loops(&mut self, q: &[S], v: &[S]) {
        if !self.model.loops.is_empty() {
            self.loads.clear();
            self.project(|solver, on| solver.begin_at(on, q, v));
        }
    }

    /// Returns the constraint with the largest error at a state, and the error, m or rad; `None` without
    /// loops.
    pub fn loop_gap(&mut self, q: &[S], v: &[S]) -> Option<(usize, f64)> {
        self.links.update(&self.model, q, v);
        self.loops.update_rows(&self.model, &self.links);
        let gaps = self.loops.rows().iter().map(|row| row.residual.value().abs()).enumerate();
        gaps.max_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// Computes the forces of the constraints at a stage and passes them to their elements.
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

/// Writes the active restraints; this does not need the entries of the elements.
fn hold<S: Scalar>(
    elements: &mut [AnyElement<S>],
    layout: &Layout,
    world: &World<S>,
    model: &Model<S>,
    links: &LinkKinematics<S>,
    motion: (&[S], &[S]),
    restraints: &mut [TemporaryConstraint<S>],
) {
    let at = Context::at_rest(world, model, links, motion);
    for (i, places) in &layout.holding {
        let restraints = &mut restraints[places.clone()];
        if let Some(holding) = elements[*i].holding_mut().filter(|_| acting(restraints) > 0) {
            holding.restrain(&at, restraints);
        }
    }
}

/// Returns the number of restraints that are active.
fn acting<S>(restraints: &[TemporaryConstraint<S>]) -> usize {
    restraints.iter().filter(|restraint| restraint.acts).count()
}
