//! Small motions about the state of a simulation, by differences.

use super::{Simulation, stage};
use crate::elements::Situation;
use crate::integrate::{Stage, System};
use crate::ledger;
use nalgebra::DMatrix;

/// Displacement (m, rad) and change of rate (m/s, rad/s) of a central difference: the cube root of the rounding unit,
/// where its error is smallest (Nocedal & Wright, *Numerical Optimization*, 2nd ed., 2006, section 8.1).
const DIFFERENCE: f64 = 6e-6;
/// If rates change by less than this with a state of an element, it is rounding, 1/s^2: the change of the state is then
/// made ten times as large.
const SEEN: f64 = 1e-4;
/// The largest change of such a state.
const LARGEST: f64 = 1e6;

impl Simulation {
    /// A of `x' = A x` for small motions from here in still water, with prescribed coordinates held, by central
    /// differences: to about ten digits of its largest entries.
    ///
    /// The states are the local coordinates of the free coordinates, their rates, and the states of elements. At rest
    /// it equals A of [`Linearization`](crate::analysis::Linearization), which is exact but needs a second engine over
    /// dual numbers: too large for a browser.
    pub fn small_motions(&mut self) -> DMatrix<f64> {
        let free = self.plant.model.free_coordinates();
        let (n, extras) = (free.len(), self.plant.layout().states.len());
        let size = 2 * n + extras;
        let mut a = DMatrix::zeros(size, size);
        self.plant.set_situation(Situation::AtRest);
        for column in 0..size {
            let mut step = DIFFERENCE;
            loop {
                let [more, less] = [step, -step].map(|change| self.rates_beside_here(&free, column, change));
                let difference = (more - less) / (2.0 * step);
                if column < 2 * n || step >= LARGEST || difference.amax() * step > SEEN {
                    a.set_column(column, &difference);
                    break;
                }
                step *= 10.0;
            }
        }
        self.plant.set_situation(Situation::Running);
        a
    }

    /// Rates of the states with one of them changed.
    fn rates_beside_here(&mut self, free: &[usize], state: usize, change: f64) -> nalgebra::DVector<f64> {
        let n = free.len();
        let at = stage(self.interval(), &self.state);
        let (mut q, mut v, mut s) = (at.q.to_vec(), at.v.to_vec(), at.s.to_vec());
        let mut xi = vec![0.0; v.len()];
        match state.checked_sub(2 * n) {
            Some(extra) => s[ledger::COUNT + extra] += change,
            None if state < n => xi[free[state]] = change,
            None => v[free[state - n]] += change,
        }
        let from = q.clone();
        self.plant.retract(&from, &xi, &mut q);
        let (mut v_dot, mut s_dot) = (vec![0.0; v.len()], vec![0.0; s.len()]);
        self.plant.rates(Stage { q: &q, v: &v, s: &s, ..at }, &mut v_dot, &mut s_dot);
        let rates = free.iter().map(|&i| v[i]).chain(free.iter().map(|&i| v_dot[i]));
        let rates: Vec<f64> = rates.chain(s_dot[ledger::COUNT..].iter().copied()).collect();
        rates.into()
    }
}
