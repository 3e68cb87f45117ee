//! Closed loops by Lagrange's multipliers.
//!
//! The constraints phi(q) = 0 of the loops add wrenches to the equations of motion,
//!
//! ```text
//! | M*  J^T | |  q''    |   | F* - N* q' |
//! | J   0   | | -lambda | = | -J' q'     |
//! ```
//!
//! and the recursion solves them without forming M*: with a0 the accelerations of the open tree, `a = a0 + M*^-1 J^T
//! lambda` and `(J M*^-1 J^T) lambda = -(J a0 + J' v)`; a column of M*^-1 J^T is the open tree's [`Response`] to a pair
//! of unit wrenches. The equations satisfy the constraints to rounding, but a scheme does not. After each step q and v
//! are corrected by the smallest change in the norm of M*, so that phi and phi' vanish ([`LoopSolver::close`]). This
//! conserves the total momentum of two connected ships.
//!
//! The temporary constraints of elements, each a [`TemporaryConstraint`](super::TemporaryConstraint), follow the loops in the same system.

mod column;
mod project;
mod rows;

pub use project::{LARGEST_GAP, LoopFault, Projection};
pub use rows::{Row, hold, relative_pose};

pub use super::cholesky::{CholeskyFactor, SMALLEST_PIVOT};
use super::forward::{Response, Workspace};
use super::{LinkKinematics, Loads, TemporaryConstraint};
use crate::model::Model;
use crate::scalar::Scalar;
use column::ConstraintColumn;

/// Working memory for the loops of a model.
#[derive(Clone, Debug)]
pub struct LoopSolver<S = f64> {
    /// Constraints of the loops.
    rows: Vec<Row<S>>,
    /// Memory for all constraints: first those of the loops, then those of the active restraints.
    columns: Vec<ConstraintColumn<S>>,
    /// Number of active constraints.
    count: usize,
    factor: CholeskyFactor<S>,
    response: Response<S>,
    multipliers: Vec<S>,
    /// Lowest pivots of a step: of accepted evaluations, and of evaluations on trial.
    lowest: [Vec<S>; 2],
    begins: bool,
    /// Positions before a correction.
    q: Vec<S>,
    /// Local coordinates of a correction.
    xi: Vec<S>,
    v_dot: Vec<S>,
}

impl<S: Scalar> LoopSolver<S> {
    /// Allocates the memory for a model and this number of restraints.
    pub fn new(model: &Model<S>, restraints: usize) -> Self {
        let count = model.constraint_count() + restraints;
        Self {
            rows: Vec::with_capacity(model.constraint_count()),
            columns: vec![ConstraintColumn::new(); count],
            count: 0,
            factor: CholeskyFactor::new(count),
            response: Response::new(model),
            multipliers: vec![S::ZERO; count],
            lowest: [(); 2].map(|()| vec![S::constant(f64::INFINITY); count]),
            begins: false,
            q: vec![S::ZERO; model.position_count],
            xi: vec![S::ZERO; model.velocity_count],
            v_dot: vec![S::ZERO; model.velocity_count],
        }
    }

    /// Evaluates every constraint of the loops.
    pub fn update_rows(&mut self, model: &Model<S>, links: &LinkKinematics<S>) {
        rows::update(model, links, &mut self.rows);
    }

    /// Evaluates every constraint of the loops, followed by the active restraints.
    fn update_columns(&mut self, model: &Model<S>, links: &LinkKinematics<S>, restraints: &[TemporaryConstraint<S>]) {
        self.update_rows(model, links);
        let mut columns = self.columns.iter_mut();
        for (row, column) in self.rows.iter().zip(columns.by_ref()) {
            column.take_row(row);
        }
        let acting = restraints.iter().filter(|restraint| restraint.acts);
        self.count = self.rows.len();
        for (column, restraint) in columns.zip(acting) {
            column.take_restraint(model, links, restraint);
            self.count += 1;
        }
    }

    /// Returns the active constraints.
    fn acting(&self) -> &[ConstraintColumn<S>] {
        &self.columns[..self.count]
    }

    /// Returns every constraint of the loops at its last evaluation.
    pub fn rows(&self) -> &[Row<S>] {
        &self.rows
    }

    /// Returns the multipliers of the last accelerations: forces, N, and moments, N m, of the constraints on
    /// the second bodies; followed by those of the active restraints.
    pub fn multipliers(&self) -> &[S] {
        &self.multipliers[..self.count]
    }

    /// Returns the multipliers of the active restraints.
    pub fn of_restraints(&self) -> &[S] {
        self.multipliers().get(self.rows.len()..).unwrap_or_default()
    }

    /// Copies the multipliers from another form of the equations.
    pub fn take_over(
        &mut self,
        model: &Model<S>,
        links: &LinkKinematics<S>,
        loads: &Loads<S>,
        multipliers: impl Iterator<Item = S>,
    ) {
        self.update_columns(model, links, &loads.restraints);
        self.multipliers.iter_mut().zip(multipliers).for_each(|(own, given)| *own = given);
    }

    /// Sets the diagonal of the next J M*^-1 J^T as the reference of pivots: at the setup, so that it is equal
    /// for every state of a run.
    pub fn begin(&mut self) {
        self.begins = true;
        self.forget_pivots();
    }

    /// Resets the lowest pivots; called at the start of each step.
    pub fn forget_pivots(&mut self) {
        self.lowest.iter_mut().for_each(|lowest| lowest.fill(S::constant(f64::INFINITY)));
    }

    /// Accepts the evaluations since the last call of this function or of [`reject`](Self::reject).
    pub fn accept(&mut self) {
        let [kept, trial] = &mut self.lowest;
        for (kept, trial) in kept.iter_mut().zip(trial) {
            *kept = trial.select_less(*kept, || *trial, || *kept);
            *trial = S::constant(f64::INFINITY);
        }
    }

    /// Rejects the evaluations since the last call of [`accept`](Self::accept) or of this function: they were
    /// a trial.
    pub fn reject(&mut self) {
        self.lowest[1].fill(S::constant(f64::INFINITY));
    }

    /// Returns the factor of J M*^-1 J^T.
    pub fn factor(&self) -> &CholeskyFactor<S> {
        &self.factor
    }

    /// Corrects the accelerations of the open tree, from [`forward_dynamics`](super::forward), so that the
    /// loops stay closed.
    pub fn accelerate(
        &mut self,
        model: &Model<S>,
        links: &LinkKinematics<S>,
        loads: &Loads<S>,
        work: &mut Workspace<S>,
        v_dot: &mut [S],
    ) {
        self.update_columns(model, links, &loads.restraints);
        self.factor_here(model, links, work);
        for (right, column) in self.multipliers.iter_mut().zip(&self.columns[..self.count]) {
            *right = -column.acceleration(|link| work.acceleration(links, link), v_dot);
        }
        self.respond(model, links, work);
        self.response.add_to(work, v_dot);
    }

    /// Factors J M*^-1 J^T with the present articulated inertias, one column at a time.
    fn factor_here(&mut self, model: &Model<S>, links: &LinkKinematics<S>, work: &Workspace<S>) {
        let columns = &self.columns[..self.count];
        self.factor.begin(columns.len());
        for (k, column) in columns.iter().enumerate() {
            self.response.clear();
            column.press(S::ONE, &mut self.response);
            self.response.update(model, links, work);
            let response = &self.response;
            for (j, other) in columns.iter().enumerate().skip(k) {
                self.factor.set(j, k, other.times(|link| *response.acceleration(link), response.rates()));
            }
        }
        // A restraint is temporary: its own diagonal is its reference.
        let first = if core::mem::take(&mut self.begins) { 0 } else { self.rows.len() };
        for (k, column) in columns.iter().enumerate().skip(first) {
            self.factor.take_reference(k, column.motion(model, links));
        }
        self.factor.factor();
        for (lowest, pivot) in self.lowest[1].iter_mut().zip(self.factor.pivots()) {
            *lowest = pivot.select_less(*lowest, || *pivot, || *lowest);
        }
    }

    /// Computes the multipliers from the right-hand side in `multipliers`, and the response to them.
    fn respond(&mut self, model: &Model<S>, links: &LinkKinematics<S>, work: &Workspace<S>) {
        self.factor.solve(&mut self.multipliers[..self.count]);
        self.response.clear();
        for (column, lambda) in self.columns[..self.count].iter().zip(&self.multipliers) {
            column.press(*lambda, &mut self.response);
        }
        self.response.update(model, links, work);
    }

    /// Adds the forces of loops and restraints to the loads: they do no work, but contribute to joint loads
    /// and momentum.
    pub fn apply(&self, model: &Model<S>, links: &LinkKinematics<S>, loads: &mut Loads<S>) {
        let constraints = model.loops.iter().flat_map(|closed| closed.constraints.iter().map(move |_| closed));
        for ((closed, row), lambda) in constraints.zip(&self.rows).zip(&self.multipliers) {
            for (attachment, in_root) in [(&closed.first, &row.on_first), (&closed.second, &row.on_second)] {
                loads.add_on_link(model, links, attachment.body, &(*in_root * *lambda));
            }
        }
        loads.carry(self.of_restraints());
    }
}
