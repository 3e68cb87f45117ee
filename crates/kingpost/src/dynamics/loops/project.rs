//! Projection to phi = 0 and phi' = 0 by the smallest change of q and v in the norm of M*.
//!
//! A correction of the positions is one step of Newton's method with the M*-weighted inverse of J, `xi = -M*^-1
//! J^T (J M*^-1 J^T)^-1 phi`, retracted on the group; a correction of the velocities is `-M*^-1 J^T (J M*^-1
//! J^T)^-1 J v`, and one step is enough. (Gear, Leimkuhler & Gupta 1985; Hairer & Wanner, *Solving Ordinary
//! Differential Equations II*, 1996, sec. VII.2.) Coordinates that are held or prescribed do not move.

use super::column::ConstraintColumn;
use super::{LoopSolver, SMALLEST_PIVOT};
use crate::dynamics::forward::{Workspace, forward_dynamics};
use crate::dynamics::{LinkKinematics, Loads, TemporaryConstraint};
use crate::model::Model;
use crate::scalar::Scalar;

/// Largest error of a constraint, m or rad, at which corrections end.
const WANTED_GAP: f64 = 1e-12;

/// Largest error of a constraint in a closed loop, m or rad: rounding errors can reach it if the bodies are
/// far from the origin.
pub const LARGEST_GAP: f64 = 1e-10;

/// Largest number of corrections of a step. Newton's method doubles the number of correct digits.
const MOST_IN_A_STEP: usize = 8;

/// Largest number of corrections of an assembly, and largest correction along any coordinate, m or rad.
const MOST_IN_AN_ASSEMBLY: usize = 100;
const LONGEST_CORRECTION: f64 = 0.3;

/// Reason why a loop cannot be kept closed. Constraints are counted over all loops.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LoopFault {
    /// A constraint has become dependent on those before it, or no coordinate affects it: a dead centre.
    Singular {
        /// The constraint.
        constraint: usize,
        /// Ratio of its pivot to that at the start; it must be more than [`SMALLEST_PIVOT`].
        pivot: f64,
    },
    /// Newton's method cannot satisfy a constraint: it is out of reach.
    Open {
        /// The constraint.
        constraint: usize,
        /// Error of the constraint, m or rad; it must be less than [`LARGEST_GAP`].
        gap: f64,
    },
}

/// A limit below every gap: no lane counts as closed.
const NEVER: f64 = 0.0;

/// Data of a projection.
pub struct Projection<'a, S> {
    /// The model.
    pub model: &'a Model<S>,
    /// Kinematics of the model; afterwards that of the corrected state.
    pub links: &'a mut LinkKinematics<S>,
    /// Working memory of the recursion.
    pub work: &'a mut Workspace<S>,
    /// Loads, for their added inertia and their active restraints.
    pub loads: &'a mut Loads<S>,
    /// Evaluates the loads at positions and velocities.
    pub hold: &'a mut Hold<'a, S>,
}

/// Writes the active restraints for the kinematics, positions and velocities.
pub type Hold<'a, S> = dyn FnMut(&LinkKinematics<S>, &[S], &[S], &mut [TemporaryConstraint<S>]) + 'a;

impl<S: Scalar> LoopSolver<S> {
    /// Sets the diagonal of J M*^-1 J^T at this state as the reference of pivots.
    pub fn begin_at(&mut self, on: &mut Projection<'_, S>, q: &[S], v: &[S]) {
        self.look(on, q, v);
        self.begin();
        self.factor_anew(on);
    }

    /// Closes the loops after a step, and removes their opening velocity.
    ///
    /// # Errors
    /// The first constraint that came too close to depending on the others, at the end of the step or where
    /// it was evaluated since [`forget_pivots`](Self::forget_pivots), without rejected trials; otherwise one
    /// that Newton's method does not close. With lanes, in any lane.
    pub fn close(&mut self, on: &mut Projection<'_, S>, q: &mut [S], v: &mut [S]) -> Result<(), LoopFault> {
        self.look(on, q, v);
        for _ in 0..MOST_IN_A_STEP {
            if self.gap().all(|gap| gap < WANTED_GAP) {
                break;
            }
            self.correct_positions(on, q, v, WANTED_GAP);
        }
        self.correct_velocities(on, v);
        self.accept();
        self.fault().map_or(Ok(()), Err)
    }

    /// A NaN gap is caused by a diverging run, not by the loop.
    fn fault(&self) -> Option<LoopFault> {
        let weak = |(constraint, pivot): (usize, &S)| {
            let singular = LoopFault::Singular { constraint, pivot: pivot.value() };
            (!pivot.all(|pivot| pivot > SMALLEST_PIVOT)).then_some(singular)
        };
        let open = |(constraint, column): (usize, &ConstraintColumn<S>)| {
            let open = LoopFault::Open { constraint, gap: column.residual.value() };
            (!column.residual.all(|gap| gap.is_nan() || gap.abs() < LARGEST_GAP)).then_some(open)
        };
        let weak = self.lowest[0][..self.count].iter().enumerate().find_map(weak);
        weak.or_else(|| self.acting().iter().enumerate().find_map(open))
    }

    /// Closes the loops at the start from their present state, however large their gaps, and sets the
    /// diagonal of J M*^-1 J^T there as the reference of pivots. The last correction does not change the
    /// values, but gives the derivatives of a dual number. Returns whether the loops are closed in every
    /// lane.
    pub fn assemble(&mut self, on: &mut Projection<'_, S>, q: &mut [S], v: &mut [S]) -> bool {
        self.look(on, q, v);
        for _ in 0..MOST_IN_AN_ASSEMBLY {
            if self.gap().all(|gap| gap < WANTED_GAP) {
                break;
            }
            self.begin();
            self.correct_positions(on, q, v, WANTED_GAP);
        }
        self.begin();
        self.correct_positions(on, q, v, NEVER);
        self.begin();
        self.correct_velocities(on, v);
        self.gap().all(|gap| gap < LARGEST_GAP)
    }

    /// Evaluates the constraints at a state.
    fn look(&mut self, on: &mut Projection<'_, S>, q: &[S], v: &[S]) {
        on.links.update(on.model, q, v);
        (on.hold)(on.links, q, v, &mut on.loads.restraints);
        self.update_columns(on.model, on.links, &on.loads.restraints);
    }

    /// Returns the largest absolute phi, m or rad.
    fn gap(&self) -> S {
        self.acting().iter().fold(S::ZERO, |largest, column| larger(largest, column.residual))
    }

    /// Factors J M*^-1 J^T at the present state, with newly computed articulated inertias.
    fn factor_anew(&mut self, on: &mut Projection<'_, S>) {
        forward_dynamics(on.model, on.links, on.loads, on.work, &mut self.v_dot);
        self.factor_here(on.model, on.links, on.work);
    }

    /// Corrects the positions once. A lane whose gap is below `closed` is not changed, even if other lanes
    /// are.
    fn correct_positions(&mut self, on: &mut Projection<'_, S>, q: &mut [S], v: &[S], closed: f64) {
        self.factor_anew(on);
        for (right, column) in self.multipliers.iter_mut().zip(&self.columns[..self.count]) {
            *right = -column.residual;
        }
        self.respond(on.model, on.links, on.work);
        let longest = self.response.rates().iter().fold(S::ZERO, |longest, rate| larger(longest, *rate));
        let (limit, gap) = (S::constant(LONGEST_CORRECTION), self.gap());
        let share = limit.select_less(longest, || limit / longest, || S::ONE);
        for (xi, rate) in self.xi.iter_mut().zip(self.response.rates()) {
            *xi = *rate * share;
        }
        on.model.links.retract(q, &self.xi, &mut self.q);
        for (q, corrected) in q.iter_mut().zip(&self.q) {
            *q = gap.select_below(closed, || *q, || *corrected);
        }
        self.look(on, q, v);
    }

    /// Corrects positions of closed loops once, to give the derivatives of a dual number.
    pub fn follow(&mut self, on: &mut Projection<'_, S>, q: &mut [S], v: &[S]) {
        self.look(on, q, v);
        self.correct_positions(on, q, v, NEVER);
    }

    /// Removes the opening velocity of all constraints, as an impact does; returns the impulses p of the active restraints,
    /// N s or N m s, and the heat -p . phi' / 2, J.
    pub fn strike(&mut self, on: &mut Projection<'_, S>, q: &[S], v: &mut [S]) -> (&[S], S) {
        self.look(on, q, v);
        self.correct_velocities(on, v);
        let both = self.multipliers().iter().zip(self.acting());
        let heat = both.fold(S::ZERO, |sum, (impulse, column)| sum - *impulse * column.rate * S::constant(0.5));
        (self.of_restraints(), heat)
    }

    /// Corrects the velocities: the equations are linear, so one correction is enough.
    fn correct_velocities(&mut self, on: &mut Projection<'_, S>, v: &mut [S]) {
        self.factor_anew(on);
        for (right, column) in self.multipliers.iter_mut().zip(&self.columns[..self.count]) {
            *right = -column.rate;
        }
        self.respond(on.model, on.links, on.work);
        for (v, rate) in v.iter_mut().zip(self.response.rates()) {
            *v += *rate;
        }
    }
}

/// Returns the larger of a number and the absolute value of another; NaN stays NaN.
fn larger<S: Scalar>(largest: S, other: S) -> S {
    let size = other.select_below(0.0, || -other, || other);
    size.select_less(largest, || largest, || size)
}
