//! Closed loops by Lagrange's multipliers.
//!
//! The constraints phi(q) = 0 of the loops add wrenches to the equations of motion,
//!
//! ```text
//! | M*  J^T | |  q''    |   | F* - N* q' |
//! | J   0   | | -lambda | = | -J' q'     |
//! ```
//!
//! and the recursion solves them without forming M*: with a0 the accelerations of the open tree,
//! `a = a0 + M^-1 J^T lambda` and `(J M^-1 J^T) lambda = -(J a0 + J' v)`; a column of M^-1 J^T is
//! the open tree's [`Response`] to a pair of unit wrenches. What the equations hold to rounding, a
//! scheme does not: after each step q and v are moved back by the least change that M knows, so
//! that phi and phi' vanish ([`LoopSolver::close`]). Two ships that are tied keep their common
//! momentum through it.

mod factor;
mod project;
mod rows;

pub use factor::{Factor, SMALLEST_PIVOT};
pub use project::{LARGEST_GAP, LoopFault, Projection};
pub use rows::Row;

use super::forward::{Response, Workspace};
use super::{LinkKinematics, Loads};
use crate::model::Model;
use crate::scalar::Scalar;

/// Working memory for the loops of a model.
#[derive(Clone, Debug)]
pub struct LoopSolver<S = f64> {
    rows: Vec<Row<S>>,
    factor: Factor<S>,
    response: Response<S>,
    multipliers: Vec<S>,
    /// The lowest pivots of a step: of the evaluations that belong to it, and of those under trial.
    lowest: [Vec<S>; 2],
    begins: bool,
    /// Positions before a correction.
    q: Vec<S>,
    /// Local coordinates of a correction.
    xi: Vec<S>,
    v_dot: Vec<S>,
}

impl<S: Scalar> LoopSolver<S> {
    /// Room for a model.
    pub fn new(model: &Model<S>) -> Self {
        let count = model.constraint_count();
        Self {
            rows: Vec::with_capacity(count),
            factor: Factor::new(count),
            response: Response::new(model),
            multipliers: vec![S::ZERO; count],
            lowest: [(); 2].map(|()| vec![S::constant(f64::INFINITY); count]),
            begins: false,
            q: vec![S::ZERO; model.position_count],
            xi: vec![S::ZERO; model.velocity_count],
            v_dot: vec![S::ZERO; model.velocity_count],
        }
    }

    /// Evaluates every constraint.
    pub fn update_rows(&mut self, model: &Model<S>, links: &LinkKinematics<S>) {
        rows::update(model, links, &mut self.rows);
    }

    /// Every constraint where it was evaluated last.
    pub fn rows(&self) -> &[Row<S>] {
        &self.rows
    }

    /// The multipliers of the last accelerations: forces, N, and moments, N m, that the constraints
    /// put on the second bodies.
    pub fn multipliers(&self) -> &[S] {
        &self.multipliers
    }

    /// Takes over the multipliers that another form of the equations has found.
    pub fn take_over(&mut self, model: &Model<S>, links: &LinkKinematics<S>, multipliers: impl Iterator<Item = S>) {
        self.update_rows(model, links);
        self.multipliers.iter_mut().zip(multipliers).for_each(|(own, given)| *own = given);
    }

    /// Measures pivots against the diagonal of the next J M^-1 J^T: that of the setup, which is the same for
    /// every state of a run.
    pub fn begin(&mut self) {
        self.begins = true;
        self.forget_pivots();
    }

    /// Begins to look for the lowest pivots anew: at the begin of each step, so that none outlives it.
    pub fn forget_pivots(&mut self) {
        self.lowest.iter_mut().for_each(|lowest| lowest.fill(S::constant(f64::INFINITY)));
    }

    /// What was evaluated since the last call, or that of [`reject`](Self::reject), belongs to the step.
    pub fn accept(&mut self) {
        let [kept, trial] = &mut self.lowest;
        for (kept, trial) in kept.iter_mut().zip(trial) {
            *kept = trial.select_less(*kept, || *trial, || *kept);
            *trial = S::constant(f64::INFINITY);
        }
    }

    /// What was evaluated since then was a trial that the step does not take.
    pub fn reject(&mut self) {
        self.lowest[1].fill(S::constant(f64::INFINITY));
    }

    /// The factor of J M^-1 J^T.
    pub fn factor(&self) -> &Factor<S> {
        &self.factor
    }

    /// Corrects the accelerations of the open tree, as [`forward_dynamics`](super::forward) left
    /// them, so that the loops stay closed.
    pub fn accelerate(
        &mut self,
        model: &Model<S>,
        links: &LinkKinematics<S>,
        work: &mut Workspace<S>,
        v_dot: &mut [S],
    ) {
        self.update_rows(model, links);
        self.factor_here(model, links, work);
        for (right, row) in self.multipliers.iter_mut().zip(&self.rows) {
            *right = -(row.times(|link| work.acceleration(links, link)) + row.drift);
        }
        self.respond(model, links, work);
        self.response.add_to(work, v_dot);
    }

    /// Factors J M^-1 J^T over the articulated inertias that stand, a column at a time.
    fn factor_here(&mut self, model: &Model<S>, links: &LinkKinematics<S>, work: &Workspace<S>) {
        for (k, row) in self.rows.iter().enumerate() {
            self.response.clear();
            self.response.add(row.first, &row.on_first);
            self.response.add(row.second, &row.on_second);
            self.response.update(model, links, work);
            for (j, other) in self.rows.iter().enumerate().skip(k) {
                self.factor.set(j, k, other.times(|link| *self.response.acceleration(link)));
            }
        }
        if core::mem::take(&mut self.begins) {
            for (k, row) in self.rows.iter().enumerate() {
                self.factor.take_reference(k, row.motion(model, links));
            }
        }
        self.factor.factor();
        for (lowest, pivot) in self.lowest[1].iter_mut().zip(self.factor.pivots()) {
            *lowest = pivot.select_less(*lowest, || *pivot, || *lowest);
        }
    }

    /// From the right-hand side in `multipliers`: the multipliers, and the response to them.
    fn respond(&mut self, model: &Model<S>, links: &LinkKinematics<S>, work: &Workspace<S>) {
        self.factor.solve(&mut self.multipliers);
        self.response.clear();
        for (row, lambda) in self.rows.iter().zip(&self.multipliers) {
            self.response.add(row.first, &(row.on_first * *lambda));
            self.response.add(row.second, &(row.on_second * *lambda));
        }
        self.response.update(model, links, work);
    }

    /// Adds what the loops carry to the loads: no work, but joints and momentum feel it.
    pub fn apply(&self, model: &Model<S>, links: &LinkKinematics<S>, loads: &mut Loads<S>) {
        let constraints = model.loops.iter().flat_map(|closed| closed.constraints.iter().map(move |_| closed));
        for ((closed, row), lambda) in constraints.zip(&self.rows).zip(&self.multipliers) {
            for (attachment, in_root) in [(&closed.first, &row.on_first), (&closed.second, &row.on_second)] {
                loads.add_on_link(model, links, attachment.body, &(*in_root * *lambda));
            }
        }
    }
}
