//! Derivatives of the rates with respect to positions, velocities and extra states.

use super::{Sizes, Stage, System, largest};
use crate::scalar::Scalar;

/// Relative change of a number in a forward difference, for displacements (rad, m) and rates (rad/s, m/s); it
/// is multiplied by one plus the number's magnitude. The square root of the rounding unit, where the error is
/// smallest (Nocedal & Wright, *Numerical Optimization*, 2nd ed., 2006, section 8.1).
const DIFFERENCE: f64 = 1.5e-8;

/// Derivatives of the rates r, which are v', then the active s', and working memory for differences. Each
/// matrix is stored by columns, entry (i, j) at `j * rows + i`.
#[derive(Clone, Debug)]
pub struct Jacobian<S = f64> {
    /// Number of rows of each matrix: entries of v, and active entries of s.
    pub rows: usize,
    /// Number of entries of s before the active ones.
    pub passive: usize,
    /// dr/d(xi).
    pub by_xi: Vec<S>,
    /// dr/d(v).
    pub by_v: Vec<S>,
    /// dr/d(s), for the active s.
    pub by_s: Vec<S>,
    xi: Vec<S>,
    q: Vec<S>,
    v: Vec<S>,
    s: Vec<S>,
    here: Rates<S>,
    moved: Rates<S>,
}

#[derive(Clone, Debug)]
struct Rates<S> {
    v_dot: Vec<S>,
    s_dot: Vec<S>,
}

impl<S: Scalar> Rates<S> {
    fn new(sizes: Sizes) -> Self {
        Self { v_dot: vec![S::ZERO; sizes.velocities], s_dot: vec![S::ZERO; sizes.extras] }
    }

    /// Returns the rates that are rows of a Jacobian.
    fn rows(&self, passive: usize) -> impl Iterator<Item = S> {
        self.v_dot.iter().chain(&self.s_dot[passive..]).copied()
    }
}

impl<S: Scalar> Jacobian<S> {
    /// Allocates the Jacobian of a system with these sizes.
    pub fn new(sizes: Sizes) -> Self {
        let (n, active) = (sizes.velocities, sizes.active());
        let rows = n + active;
        let [xi, v] = core::array::from_fn(|_| vec![S::ZERO; n]);
        let [by_xi, by_v] = core::array::from_fn(|_| vec![S::ZERO; rows * n]);
        let (by_s, q, s) = (vec![S::ZERO; rows * active], vec![S::ZERO; sizes.positions], vec![S::ZERO; sizes.extras]);
        let [here, moved] = core::array::from_fn(|_| Rates::new(sizes));
        Self { rows, passive: sizes.passive, by_xi, by_v, by_s, xi, q, v, s, here, moved }
    }

    /// Allocates the Jacobian of v' only, with respect to xi and v.
    pub fn of_motion(sizes: Sizes) -> Self {
        Self::new(Sizes { passive: sizes.extras, ..sizes })
    }

    /// Returns all matrices, one after another.
    pub(super) fn parts(&self) -> [&[S]; 3] {
        [&self.by_xi, &self.by_v, &self.by_s]
    }

    /// Returns all matrices for changes, one after another.
    pub(super) fn parts_mut(&mut self) -> [&mut [S]; 3] {
        [&mut self.by_xi, &mut self.by_v, &mut self.by_s]
    }

    /// Computes all three matrices by forward differences, to about eight digits; see [`System::jacobian`].
    pub fn by_differences<Y: System<S>>(&mut self, system: &mut Y, base: &[S], xi: &[S], at: Stage<'_, S>) {
        system.rates(at, &mut self.here.v_dot, &mut self.here.s_dot);
        self.xi.copy_from_slice(xi);
        self.v.copy_from_slice(at.v);
        self.s.copy_from_slice(at.s);
        for (j, &place) in xi.iter().enumerate() {
            if !system.is_free(j) {
                continue;
            }
            let step = step_from(place);
            self.xi[j] += step;
            system.retract(base, &self.xi, &mut self.q);
            self.xi[j] = place;
            system.rates(Stage { q: &self.q, ..at }, &mut self.moved.v_dot, &mut self.moved.s_dot);
            difference(&self.moved, &self.here, self.passive, step, &mut self.by_xi[j * self.rows..]);
            let step = step_from(at.v[j]);
            self.v[j] += step;
            system.rates(Stage { v: &self.v, ..at }, &mut self.moved.v_dot, &mut self.moved.s_dot);
            self.v[j] = at.v[j];
            difference(&self.moved, &self.here, self.passive, step, &mut self.by_v[j * self.rows..]);
        }
        for (j, k) in (self.passive..at.s.len()).enumerate() {
            let step = step_from(at.s[k]);
            self.s[k] += step;
            system.rates(Stage { s: &self.s, ..at }, &mut self.moved.v_dot, &mut self.moved.s_dot);
            self.s[k] = at.s[k];
            difference(&self.moved, &self.here, self.passive, step, &mut self.by_s[j * self.rows..]);
        }
    }
}

/// Returns a change that can be added to a number without rounding.
fn step_from<S: Scalar>(x: S) -> S {
    let step = S::constant(DIFFERENCE * (1.0 + largest(&[x])));
    (x + step) - x
}

fn difference<S: Scalar>(moved: &Rates<S>, here: &Rates<S>, passive: usize, step: S, column: &mut [S]) {
    for ((out, moved), here) in column.iter_mut().zip(moved.rows(passive)).zip(here.rows(passive)) {
        *out = (moved - here) / step;
    }
}
