//! How the accelerations depend on positions and velocities.

use super::{Sizes, Stage, System, largest};
use crate::scalar::Scalar;

/// Displacement (rad, m) and change of rate (rad/s, m/s) for differences, times one and the size of
/// what is changed: the root of the rounding unit, where the error of a forward difference is least
/// (Nocedal & Wright, *Numerical Optimization*, 2nd ed., 2006, section 8.1).
const DIFFERENCE: f64 = 1.5e-8;

/// d(v')/d(xi) and d(v')/d(v), with the working memory to take differences.
#[derive(Clone, Debug)]
pub struct Jacobian<S = f64> {
    /// d(v')/d(xi) by columns: entry (i, j) at `j * velocities + i`, 1/s^2.
    pub by_xi: Vec<S>,
    /// d(v')/d(v) by columns, 1/s.
    pub by_v: Vec<S>,
    xi: Vec<S>,
    q: Vec<S>,
    v: Vec<S>,
    here: Vec<S>,
    moved: Vec<S>,
    s_dot: Vec<S>,
}

impl<S: Scalar> Jacobian<S> {
    /// Room for a system of these sizes.
    pub fn new(sizes: Sizes) -> Self {
        let n = sizes.velocities;
        let [xi, v, here, moved] = core::array::from_fn(|_| vec![S::ZERO; n]);
        let (by_xi, by_v) = (vec![S::ZERO; n * n], vec![S::ZERO; n * n]);
        Self { by_xi, by_v, xi, q: vec![S::ZERO; sizes.positions], v, here, moved, s_dot: vec![S::ZERO; sizes.extras] }
    }

    /// Both matrices by forward differences, to about eight digits; see [`System::jacobian`].
    pub fn by_differences<Y: System<S>>(&mut self, system: &mut Y, base: &[S], xi: &[S], at: Stage<'_, S>) {
        let Self { by_xi, by_v, xi: moved_xi, q, v, here, moved, s_dot } = self;
        let n = xi.len();
        system.rates(at, here, s_dot);
        moved_xi.copy_from_slice(xi);
        v.copy_from_slice(at.v);
        for j in 0..n {
            if !system.is_free(j) {
                continue;
            }
            let step = step_from(xi[j]);
            moved_xi[j] += step;
            system.retract(base, moved_xi, q);
            moved_xi[j] = xi[j];
            system.rates(Stage { q, ..at }, moved, s_dot);
            difference(moved, here, step, &mut by_xi[j * n..][..n]);
            let step = step_from(at.v[j]);
            v[j] += step;
            system.rates(Stage { v, ..at }, moved, s_dot);
            v[j] = at.v[j];
            difference(moved, here, step, &mut by_v[j * n..][..n]);
        }
    }
}

/// A change of a number that the number can hold without rounding.
fn step_from<S: Scalar>(x: S) -> S {
    let step = S::constant(DIFFERENCE * (1.0 + largest(&[x])));
    (x + step) - x
}

fn difference<S: Scalar>(moved: &[S], here: &[S], step: S, column: &mut [S]) {
    for ((out, moved), here) in column.iter_mut().zip(moved).zip(here) {
        *out = (*moved - *here) / step;
    }
}
