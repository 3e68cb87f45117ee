//! Where a model rests: free coordinates, rates zero, at which nothing accelerates.

use super::{Linearization, Linearizer};
use crate::integrate::Stage;
use crate::scenario::{Scenario, ScenarioError};
use crate::simulation::{InputError, Simulation};
use nalgebra::{DMatrix, DVector};
use thiserror::Error;

/// Accelerations below this count as none, m/s^2 or rad/s^2.
const AT_REST: f64 = 1e-10;
/// Iterations before it is called hopeless.
const MOST_ITERATIONS: usize = 400;
/// The longest move of a coordinate in one iteration, m or rad.
const LONGEST_MOVE: f64 = 0.5;
/// The smallest share of the largest entry of A that is kept against drift along zero modes.
const SMALLEST_SHARE: f64 = 1e-9;

/// How an equilibrium was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Equilibrium {
    /// Newton's iterations.
    pub iterations: usize,
    /// Largest acceleration that is left, m/s^2 or rad/s^2.
    pub residual: f64,
}

/// Why none was found.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum NoEquilibrium {
    /// Something keeps accelerating.
    #[error(
        "no equilibrium within {iterations} iterations: {coordinate} still accelerates at {residual:.3e} \
         m/s^2 or rad/s^2, allowed: {allowed:e}"
    )]
    NotFound {
        /// Iterations made.
        iterations: usize,
        /// The free coordinate that accelerates most.
        coordinate: String,
        /// Its acceleration.
        residual: f64,
        /// What counts as none.
        allowed: f64,
    },
    /// The scenario does not build.
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
    /// A state that the simulation refuses.
    #[error(transparent)]
    State(#[from] InputError),
}

/// Moves a simulation of `scenario` to an equilibrium near where it stands, all rates zero, and
/// begins its ledger anew there.
///
/// Newton's iteration with exact Jacobian, led by pseudo-transient continuation (Kelley & Keyes,
/// SIAM J. Numer. Anal. 35, 1998): `(1/delta - A) dx = v'`, where delta grows as the accelerations
/// vanish. So it begins downhill, towards a stable equilibrium, and ends with Newton's own
/// convergence; along zero modes, such as the heading of a free ship, nothing moves.
///
/// # Errors
/// Nothing at which all accelerations vanish was found; the simulation stands where it stood.
pub fn settle(scenario: &Scenario, simulation: &mut Simulation) -> Result<Equilibrium, NoEquilibrium> {
    let mut linearizer = Linearizer::new(scenario)?;
    let (mut q, still) = (simulation.state().q.clone(), vec![0.0; simulation.state().v.len()]);
    let mut last: Option<LastMove> = None;
    let mut iterations = 0;
    loop {
        let linear = linearizer.about(Stage { q: &q, v: &still, ..simulation.stage() });
        let acceleration = linear.accelerations();
        let residual = acceleration.amax();
        if residual < AT_REST {
            simulation.set_state(&q, &still, None)?;
            return Ok(Equilibrium { iterations, residual });
        }
        iterations += 1;
        let next = if iterations < MOST_ITERATIONS { next_move(&linear, last) } else { None };
        let Some((xi, made)) = next else {
            let worst = acceleration.iamax();
            let (coordinate, residual) = (linear.states[worst].clone(), acceleration[worst].abs());
            return Err(NoEquilibrium::NotFound { iterations, coordinate, residual, allowed: AT_REST });
        };
        let mut everywhere = still.clone();
        linearizer.positions().zip(&xi).for_each(|(i, xi)| everywhere[i] = *xi);
        q = simulation.moved(&q, &everywhere);
        last = Some(made);
    }
}

/// The pseudo-time step of a move, and the accelerations that it began with.
#[derive(Clone, Copy)]
struct LastMove {
    delta: f64,
    acceleration: f64,
}

/// The next move of the free coordinates; `None` where the numbers give none.
fn next_move(linear: &Linearization, last: Option<LastMove>) -> Option<(DVector<f64>, LastMove)> {
    let (acceleration, stiffness) = (linear.accelerations(), linear.stiffness());
    let (size, norm) = (stiffness.norm().max(AT_REST), acceleration.norm());
    // Beyond the largest stiffness, so that an unstable direction leads downhill too.
    let grown = last.map_or(0.5 / size, |last| last.delta * last.acceleration / norm);
    let delta = grown.min(1.0 / (SMALLEST_SHARE * size));
    let n = acceleration.len();
    let xi = (DMatrix::identity(n, n) / delta - stiffness).lu().solve(&acceleration)?;
    let longest = xi.amax();
    let xi = if longest > LONGEST_MOVE { xi * (LONGEST_MOVE / longest) } else { xi };
    longest.is_finite().then_some((xi, LastMove { delta, acceleration: norm }))
}
