//! Linearization of small motions about the state of a simulation, by differences.

use super::{Simulation, stage};
use crate::elements::EvaluationMode;
use crate::integrate::{Stage, System};
use crate::ledger;
use nalgebra::{DMatrix, DVector};

/// Change of a coordinate (m, rad) or rate (m/s, rad/s) in a central difference: the cube root of the
/// rounding unit, where the error is smallest (Nocedal & Wright, *Numerical Optimization*, 2nd ed., 2006,
/// section 8.1).
pub(super) const DIFFERENCE: f64 = 6e-6;
/// Smallest change of the rates, per change of an element's state or an input, that is not rounding, 1/s^2;
/// below it the change is made ten times as large.
const SEEN: f64 = 1e-4;
/// Largest change in a difference.
const LARGEST: f64 = 1e6;

/// The variable that is changed in a difference.
#[derive(Clone, Copy, Debug)]
pub(super) enum Changed {
    /// A state: a local coordinate, a rate or a state of an element.
    State(usize),
    /// An input.
    Input(usize),
}

impl Simulation {
    /// Returns A of `x' = A x` for small motions about the present state in still water, with prescribed
    /// coordinates held, by central differences: accurate to about ten digits of its largest entries.
    ///
    /// The states are the local coordinates of the free coordinates, their rates, and the states of elements. At rest
    /// it equals A of [`Linearization`](crate::analysis::Linearization), which is exact but needs a second engine over
    /// dual numbers: too large for a browser.
    pub fn small_motions(&mut self) -> DMatrix<f64> {
        let size = 2 * self.plant.model.free_coordinates().len() + self.plant.layout().states.len();
        self.plant.set_evaluation_mode(EvaluationMode::AtRest);
        self.plant.elements_mut().iter_mut().for_each(|element| element.move_about_rest(true));
        let columns: Vec<DVector<f64>> = (0..size).map(|state| self.rates_by(Changed::State(state))).collect();
        self.plant.elements_mut().iter_mut().for_each(|element| element.move_about_rest(false));
        self.plant.set_evaluation_mode(EvaluationMode::Running);
        let mut a = DMatrix::zeros(size, size);
        columns.into_iter().enumerate().for_each(|(state, column)| a.set_column(state, &column));
        a
    }

    /// Returns the derivatives of the states' rates with respect to a state or an input, in the present
    /// evaluation mode.
    pub(super) fn rates_by(&mut self, changed: Changed) -> DVector<f64> {
        let of_motion = 2 * self.plant.model.free_coordinates().len();
        let once = matches!(changed, Changed::State(state) if state < of_motion);
        let mut step = DIFFERENCE;
        loop {
            let [more, less] = [step, -step].map(|change| self.rates_beside_here(changed, change));
            let difference = (more - less) / (2.0 * step);
            if once || step >= LARGEST || difference.amax() * step > SEEN {
                return difference;
            }
            step *= 10.0;
        }
    }

    /// Returns the rates of the states after a change of a state or an input.
    fn rates_beside_here(&mut self, changed: Changed, change: f64) -> DVector<f64> {
        let [mut q, mut v, mut s] = [&self.state.q, &self.state.v, &self.state.s].map(Clone::clone);
        let mut d = self.state.d.clone();
        match changed {
            Changed::State(state) => [q, v, s] = self.displaced(state, change),
            Changed::Input(input) => d[input] += change,
        }
        let at = Stage { q: &q, v: &v, s: &s, d: &d, ..stage(self.interval(), &self.state) };
        let (mut v_dot, mut s_dot) = (vec![0.0; v.len()], vec![0.0; s.len()]);
        self.plant.rates(at, &mut v_dot, &mut s_dot);
        let free = self.plant.model.free_coordinates();
        let rates = free.iter().map(|&i| v[i]).chain(free.iter().map(|&i| v_dot[i]));
        let rates: Vec<f64> = rates.chain(s_dot[ledger::COUNT..].iter().copied()).collect();
        rates.into()
    }

    /// Returns q, v and s after a change of a state.
    pub(super) fn displaced(&self, state: usize, change: f64) -> [Vec<f64>; 3] {
        let free = self.plant.model.free_coordinates();
        let (n, from) = (free.len(), &self.state.q);
        let (mut q, mut v, mut s) = (from.clone(), self.state.v.clone(), self.state.s.clone());
        let mut xi = vec![0.0; v.len()];
        match state.checked_sub(2 * n) {
            Some(extra) => s[ledger::COUNT + extra] += change,
            None if state < n => xi[free[state]] = change,
            None => v[free[state - n]] += change,
        }
        self.plant.retract(from, &xi, &mut q);
        [q, v, s]
    }
}
