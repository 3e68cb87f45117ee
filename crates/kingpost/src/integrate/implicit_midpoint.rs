//! The implicit midpoint rule.

use super::newton::{ImplicitStage, Newton, RotationBy};
use super::{Interval, Sizes, StepError, System, accumulate};
use crate::scalar::Scalar;
use crate::state::State;

/// With `vm = (v0 + v1) / 2`, `sm = (s0 + s1) / 2` and the position at the middle of the step,
///
/// ```text
/// qm = q0 retracted by 1/2 xi,   q1 = q0 retracted by xi
/// v1 = v0 + h v'(t0 + h/2, qm, vm, sm),   s1 = s0 + h s'(t0 + h/2, qm, vm, sm)
/// ```
///
/// `xi` is `h vm`, on rotations the vector of the Cayley transform of `h vm`: about `vm` by `2 atan(h |vm| / 2)`.
/// Symmetric, order 2, stable at any step on linear oscillations. Quadratic invariants of v are conserved to rounding
/// (Hairer, Lubich & Wanner, *Geometric Numerical Integration*, 2006, theorem IV.2.1), and with the Cayley transform
/// the angular momentum of a free body in the world is conserved as well: `J (w1 - w0) = h (J wm) x wm` is `R1 J w1 =
/// R0 J w0` (Simo & Wong 1991, Austin, Krishnaprasad & Wang 1993).
#[derive(Clone, Debug)]
pub struct ImplicitMidpoint<S = f64> {
    newton: Newton<S>,
}

impl<S: Scalar> ImplicitMidpoint<S> {
    /// Creates a scheme for arrays of these sizes.
    pub fn new(sizes: Sizes) -> Self {
        Self { newton: Newton::new(sizes) }
    }

    /// Returns the number of entries in the state's memory: derivatives, kept from step to step.
    pub fn memory_len(&self) -> usize {
        self.newton.memory_len()
    }

    /// Moves the state over the interval.
    pub fn step<Y: System<S>>(
        &mut self,
        system: &mut Y,
        interval: Interval,
        state: &mut State<S>,
    ) -> Result<(), StepError> {
        let newton = &mut self.newton;
        let h = interval.end_s - interval.start_s;
        newton.v_dot.fill(S::ZERO);
        newton.s_dot.fill(S::ZERO);
        newton.v_start.copy_from_slice(&state.v);
        newton.s_start.copy_from_slice(&state.s);
        newton.xi_start.fill(S::ZERO);
        accumulate(&mut newton.xi_start, 0.5 * h, &state.v);
        let place = ImplicitStage {
            time_s: interval.start_s + 0.5 * h,
            interval,
            xi_slope: 0.25 * h * h,
            slope: 0.5 * h,
            rotation: RotationBy::HalfCayley,
        };
        newton.recall(&state.memory);
        newton.solve(system, state, place)?;
        newton.keep(&mut state.memory);
        let two = S::constant(2.0);
        newton.xi.iter_mut().for_each(|xi| *xi = two * *xi);
        system.retract(&state.q, &newton.xi, &mut newton.q);
        state.q.copy_from_slice(&newton.q);
        accumulate(&mut state.v, h, &newton.v_dot);
        accumulate(&mut state.s, h, &newton.s_dot);
        Ok(())
    }
}
