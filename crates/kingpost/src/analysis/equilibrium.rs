//! Where a model rests: free coordinates, rates zero, at which nothing accelerates.

use super::{Linearization, Linearizer};
use crate::ledger;
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
/// How often a move is halved where the loops cannot be closed at its end.
const MOST_HALVINGS: i32 = 12;
/// Least growth of the pseudo-time step while accelerations fall.
const LEAST_GROWTH: f64 = 2.0;
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
/// convergence; along zero modes, such as the heading of a free ship, nothing moves. Where there are
/// closed loops the moves are tangent to them, `J dx = 0` by multipliers, and each ends with the
/// loops closed.
///
/// # Errors
/// Nothing at which all accelerations vanish was found; the simulation stands where it stood.
pub fn settle(scenario: &Scenario, simulation: &mut Simulation) -> Result<Equilibrium, NoEquilibrium> {
    let mut linearizer = Linearizer::new(scenario)?;
    let still = vec![0.0; simulation.state().v.len()];
    // Of the extra states those of the drives stay: they say where a lever has led them.
    let kept = simulation.state().s.clone();
    let mut there = simulation.clone();
    there.set_state(&simulation.state().q, &still, Some(&kept))?;
    let mut last: Option<LastMove> = None;
    let mut iterations = 0;
    loop {
        let linear = linearizer.at(&there);
        let acceleration = linear.accelerations();
        let residual = if acceleration.is_empty() { 0.0 } else { acceleration.amax() };
        if residual < AT_REST {
            simulation.set_state(&there.state().q, &still, None)?;
            let mut s = simulation.state().s.clone();
            s[ledger::COUNT..].copy_from_slice(&kept[ledger::COUNT..]);
            simulation.set_state(&there.state().q, &still, Some(&s))?;
            return Ok(Equilibrium { iterations, residual });
        }
        iterations += 1;
        let next = if iterations < MOST_ITERATIONS { next_move(&linear, &there.moving_frame().j, last) } else { None };
        let moved = next.is_some_and(|(xi, made)| {
            last = Some(made);
            let mut everywhere = still.clone();
            linearizer.positions().zip(&xi).for_each(|(i, xi)| everywhere[i] = *xi);
            go(&mut there, &everywhere)
        });
        if !moved {
            let worst = acceleration.iamax();
            let (coordinate, residual) = (linear.states[worst].clone(), acceleration[worst].abs());
            return Err(NoEquilibrium::NotFound { iterations, coordinate, residual, allowed: AT_REST });
        }
    }
}

/// The pseudo-time step of a move, and the accelerations that it began with.
#[derive(Clone, Copy)]
struct LastMove {
    delta: f64,
    acceleration: f64,
}

/// The next move of the free coordinates, tangent to the loops' J; `None` where the numbers give none.
fn next_move(linear: &Linearization, j: &DMatrix<f64>, last: Option<LastMove>) -> Option<(DVector<f64>, LastMove)> {
    let (acceleration, stiffness) = (linear.accelerations(), linear.stiffness());
    let (size, norm) = (stiffness.norm().max(AT_REST), acceleration.norm());
    // Beyond the largest stiffness, so that an unstable direction leads downhill too.
    let grown = last.map_or(0.5 / size, |last| last.delta * growth(last.acceleration / norm));
    let delta = grown.min(1.0 / (SMALLEST_SHARE * size));
    let (n, constraints) = (acceleration.len(), j.nrows());
    let mut bordered = DMatrix::zeros(n + constraints, n + constraints);
    bordered.view_mut((0, 0), (n, n)).copy_from(&(DMatrix::identity(n, n) / delta - stiffness));
    bordered.view_mut((0, n), (n, constraints)).copy_from(&j.transpose());
    bordered.view_mut((n, 0), (constraints, n)).copy_from(j);
    let right = acceleration.resize_vertically(n + constraints, 0.0);
    let xi = bordered.lu().solve(&right)?.rows(0, n).into_owned();
    let longest = xi.amax();
    let xi = if longest > LONGEST_MOVE { xi * (LONGEST_MOVE / longest) } else { xi };
    longest.is_finite().then_some((xi, LastMove { delta, acceleration: norm }))
}

/// By how much the pseudo-time step grows where the accelerations have fallen by a factor, or
/// shrinks where they have risen. What is stiff rests long before what is soft begins to move: the
/// step has to grow meanwhile.
fn growth(fallen_by: f64) -> f64 {
    if fallen_by < 1.0 { fallen_by } else { fallen_by.max(LEAST_GROWTH) }
}

/// Moves a simulation along `xi` with its loops closed, or a half, a quarter of the way where they
/// cannot be. Returns whether it moved.
fn go(simulation: &mut Simulation, xi: &[f64]) -> bool {
    let (from, still) = (simulation.state().clone(), vec![0.0; xi.len()]);
    (0..MOST_HALVINGS).any(|halvings| {
        let share = 0.5_f64.powi(halvings);
        let part: Vec<f64> = xi.iter().map(|xi| share * xi).collect();
        let q = simulation.moved(&from.q, &part);
        simulation.set_state(&q, &still, Some(&from.s)).is_ok() && simulation.close_loops().is_ok()
    })
}
