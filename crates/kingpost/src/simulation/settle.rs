//! Equilibrium of a model: free coordinates at which, with zero rates, all accelerations are zero.

use super::settling_moves::{AT_REST, LastMove, Linear, SMALLEST_SHARE, next_move};
use super::{InputError, MOST_DENSE, Simulation, stage};
use crate::dynamics::Kinematics;
use crate::elements::{EvaluationMode, HOLD_IT};
use crate::integrate::{Jacobian, System};
use crate::model::JointKind;
use crate::plant::Form;
use nalgebra::{DMatrix, DVector};
use thiserror::Error;

/// Allowed acceleration at rest, in rounding errors of a position: a spring's end is computed from positions
/// in a few operations.
const ROUNDINGS: f64 = 4.0;
/// Largest number of iterations.
const MOST_ITERATIONS: usize = 400;
/// Largest number of times that a move is halved if the loops cannot be closed at its end.
const MOST_HALVINGS: i32 = 12;
/// Smallest horizontal acceleration of a floating body that counts as a push, as a share of the largest
/// acceleration.
const SMALLEST_PUSH: f64 = 1e-3;

/// Largest deviation, m or rad, at which the transfer of the holding forces to the trims is complete.
const TAKEN_OVER: f64 = 1e-8;

/// Smallest square of a growth rate that counts: in 1/s^2, and as a share of the largest entry of A.
const GROWS: [f64; 2] = [1e-6, 1e-8];

/// Largest lean of a hull at rest, deg; beyond it the hull counts as capsized: ships are flooded at much
/// smaller angles.
const MOST_LEAN_DEG: f64 = 60.0;

/// An equilibrium of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct Equilibrium {
    /// Number of Newton iterations.
    pub iterations: usize,
    /// Largest remaining acceleration, m/s^2 or rad/s^2.
    pub residual: f64,
    /// Its instability, if it is unstable.
    pub instability: Option<Instability>,
}

/// Reason why an equilibrium is unstable or not acceptable.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum Instability {
    /// A small motion grows as `e^(t / T)` without damping.
    #[error("a displacement of {coordinate} grows by a factor of e every {time_s:.3} s")]
    Growth {
        /// The free coordinate with most of the kinetic energy of the fastest such motion.
        coordinate: String,
        /// T, s.
        time_s: f64,
    },
    /// A hull lies on its side or upside down: it would be flooded.
    #[error("{hull} leans {lean_deg:.1} deg there: it has capsized")]
    Capsized {
        /// The body.
        hull: String,
        /// Lean of its z axis from the vertical, deg.
        lean_deg: f64,
    },
}

/// Reason why no equilibrium was found.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum NoEquilibrium {
    /// The accelerations do not vanish within the allowed iterations.
    #[error(
        "no equilibrium within {iterations} iterations: {coordinate} still accelerates at {residual:.3e} \
         m/s^2 or rad/s^2, more than {allowed:e}{}",
         adrift.as_ref().map(in_words).unwrap_or_default()
    )]
    NotFound {
        /// Number of iterations.
        iterations: usize,
        /// The free coordinate with the largest acceleration.
        coordinate: String,
        /// Its acceleration.
        residual: f64,
        /// The largest acceleration that is allowed.
        allowed: f64,
        /// The floating body that is pushed horizontally and has no restoring force, if there is one.
        adrift: Option<String>,
    },
    /// There are too many free coordinates for a full matrix.
    #[error(
        "no equilibrium is sought: {found} free coordinates, allowed: at most {allowed}, because its matrix grows with the square of \
         their number"
    )]
    TooMany {
        /// Number of free coordinates.
        found: usize,
        /// Largest allowed number.
        allowed: usize,
    },
    /// The element that holds the model is too weak.
    #[error("no equilibrium: {name} would have to give {utilisation:.3} times its capacity, allowed: at most 1")]
    Overloaded {
        /// The element.
        name: String,
        /// Utilisation that its most loaded part would need.
        utilisation: f64,
    },
    /// A state that the simulation refuses.
    #[error(transparent)]
    State(#[from] InputError),
}

/// Returns the advice in a message for a body adrift.
fn in_words(body: &String) -> String {
    format!(
        "; nothing holds {body} against horizontal forces: {HOLD_IT}, or turn off the wind, the current or the other horizontal forces"
    )
}

impl Simulation {
    /// Moves to a nearby equilibrium with zero rates, without waves and with prescribed coordinates held, and
    /// restarts the ledger there.
    ///
    /// Newton's iteration with pseudo-transient continuation (Kelley & Keyes, SIAM J. Numer. Anal. 35, 1998):
    /// `(1/delta - A) dx = v'`, where delta grows as the accelerations vanish. The first moves go downhill,
    /// towards a stable equilibrium; the last ones have the convergence of Newton's method. Zero modes, such
    /// as the heading of a free ship, do not move. With closed loops the moves are tangent to the
    /// constraints, `J dx = 0` by multipliers, and the loops are closed after each move. Inextensible ropes
    /// are treated in the same way while they are taut and pull.
    ///
    /// A body held by integral action rests at its target: the holding force is found by the method of multipliers
    /// (each time the model is at rest, the force is transferred to the integral).
    ///
    /// # Errors
    /// No state was found at which all accelerations vanish; the simulation is unchanged.
    pub fn settle(&mut self) -> Result<Equilibrium, NoEquilibrium> {
        self.settle_with_trims().map(|(found, _)| found)
    }

    /// Finds an equilibrium like [`settle`](Self::settle); also returns the trims of the elements that hold the model,
    /// as [`Plant::trims`](crate::plant::Plant::trims).
    ///
    /// # Errors
    /// As [`settle`](Self::settle).
    pub fn settle_with_trims(&mut self) -> Result<(Equilibrium, Vec<Vec<f64>>), NoEquilibrium> {
        let mut there = self.at_rest();
        let found = there.settle_at_rest()?;
        self.set_state(&there.state.q, &there.state.v, Some(&there.state.s))?;
        Ok((found, there.plant.trims()))
    }

    /// Returns a copy whose elements act as at rest. All forms of the equations agree at rest, and the
    /// recursive one is the fastest.
    fn at_rest(&self) -> Self {
        let mut there = self.clone();
        there.plant.set_evaluation_mode(EvaluationMode::Settling);
        there.plant.set_form(Form::Recursive);
        there
    }

    fn settle_at_rest(&mut self) -> Result<Equilibrium, NoEquilibrium> {
        let still = vec![0.0; self.state.v.len()];
        let kept = self.kept_states();
        self.set_state(&self.state.q.clone(), &still, None)?;
        self.restore_kept(&kept);
        let (names, free) = (self.coordinates(), self.plant.model.free_coordinates());
        if free.len() > MOST_DENSE {
            return Err(NoEquilibrium::TooMany { found: free.len(), allowed: MOST_DENSE });
        }
        let mut last: Option<LastMove> = None;
        let mut iterations = 0;
        loop {
            let linear = self.linear_here(&free);
            let residual = if free.is_empty() { 0.0 } else { linear.acceleration.amax() };
            let allowed = self.allowed(&linear);
            let rests = linear.rests(&allowed, last);
            if rests && iterations < MOST_ITERATIONS && self.plant.let_go_at_rest(&mut self.state) {
                last = None;
                iterations += 1;
                continue;
            }
            if rests && iterations < MOST_ITERATIONS && self.take_over(&still) {
                last = Some(LastMove::anew(linear.largest_delta()));
                iterations += 1;
                continue;
            }
            if rests {
                self.check_utilisation(&still)?;
                self.set_state(&self.state.q.clone(), &still, None)?;
                self.restore_kept(&kept);
                let instability = self.capsized().or_else(|| linear.growth(&self.mass_and_constraints(), &names));
                return Ok(Equilibrium { iterations, residual, instability });
            }
            iterations += 1;
            let next = if iterations < MOST_ITERATIONS {
                next_move(&linear, &self.mass_and_constraints().1, last)
            } else {
                None
            };
            let moved = next.is_some_and(|(xi, made)| {
                last = Some(made);
                let mut everywhere = still.clone();
                free.iter().zip(&xi).for_each(|(i, xi)| everywhere[*i] = *xi);
                self.go(&everywhere)
            });
            if !moved {
                let worst = linear.acceleration.component_div(&allowed).iamax();
                let (coordinate, residual) = (names[worst].clone(), linear.acceleration[worst].abs());
                let (allowed, adrift) = (allowed[worst], self.adrift(&linear, &free));
                return Err(NoEquilibrium::NotFound { iterations, coordinate, residual, allowed, adrift });
            }
        }
    }

    /// Returns the largest acceleration that counts as rest, for each free coordinate: the rounding error of
    /// the positions of a spring's ends, times stiffness over mass, which is the entry of A.
    fn allowed(&mut self, linear: &Linear) -> DVector<f64> {
        let Self { plant, state, .. } = self;
        let places = plant.body_kinematics(&state.q, &state.v).world.iter().flat_map(|frame| frame.position.0);
        let farthest = places.fold(1.0, |farthest: f64, place| farthest.max(place.abs()));
        let rounding = ROUNDINGS * f64::EPSILON * farthest;
        let of_row = |row: usize| AT_REST + rounding * linear.stiffness.row(row).lp_norm(1);
        DVector::from_fn(linear.acceleration.len(), |row, _| of_row(row))
    }

    /// Returns M* and J over the free coordinates at the present state.
    fn mass_and_constraints(&mut self) -> (DMatrix<f64>, DMatrix<f64>) {
        let at = stage(self.interval(), &self.state);
        self.plant.mass_and_constraints(at)
    }

    /// Transfers the holding forces to the elements' trims; returns whether one had to change.
    fn take_over(&mut self, still: &[f64]) -> bool {
        let before = self.plant.trims();
        let off = self.plant.take_over(&self.state.q, still, &self.state.s);
        off > TAKEN_OVER && self.plant.trims() != before
    }

    fn check_utilisation(&mut self, still: &[f64]) -> Result<(), NoEquilibrium> {
        let overloaded = self.plant.overloaded(&self.state.q, still, &self.state.s);
        overloaded.map_or(Ok(()), |(name, utilisation)| Err(NoEquilibrium::Overloaded { name, utilisation }))
    }

    /// Returns the first hull that has capsized.
    fn capsized(&mut self) -> Option<Instability> {
        let Self { plant, state, .. } = self;
        let mut at = Kinematics::new(&plant.model.tree);
        at.update(&plant.model.tree, &state.q, &state.v);
        let mut afloat = plant.elements().iter().flat_map(|element| element.supports()).filter_map(|own| own.afloat());
        afloat.find_map(|body| {
            let upwards = at.world[body].rotation.column(2)[2];
            let lean_deg = libm::acos(upwards.clamp(-1.0, 1.0)).to_degrees();
            let hull = plant.model.bodies[body].name.clone();
            (lean_deg > MOST_LEAN_DEG).then_some(Instability::Capsized { hull, lean_deg })
        })
    }

    /// Returns the entries of s that are not changed, because a user has moved these elements to them.
    fn kept_states(&self) -> Vec<(usize, f64)> {
        let layout = self.plant.layout();
        let kept = (0..layout.slices.len()).filter(|&element| layout.slices[element].keeps_states);
        kept.flat_map(|element| layout.states_of(element)).map(|i| (i, self.state.s[i])).collect()
    }

    fn restore_kept(&mut self, kept: &[(usize, f64)]) {
        kept.iter().for_each(|&(i, value)| self.state.s[i] = value);
    }

    /// Returns the accelerations of the free coordinates at the present state, and their derivatives with
    /// respect to these coordinates.
    fn linear_here(&mut self, free: &[usize]) -> Linear {
        let interval = self.interval();
        let Self { plant, state, v_dot, .. } = self;
        let (at, evaluations) = (stage(interval, state), plant.evaluations);
        let (mut jacobian, still) = (Jacobian::of_motion(plant.sizes()), vec![0.0; at.v.len()]);
        plant.jacobian(at.q, &still, at, &mut jacobian);
        plant.rates(at, v_dot, &mut vec![0.0; at.s.len()]);
        plant.evaluations = evaluations;
        let entry = |i: usize, j: usize| jacobian.by_xi[free[j] * jacobian.rows + free[i]];
        Linear {
            acceleration: DVector::from_iterator(free.len(), free.iter().map(|i| v_dot[*i])),
            stiffness: DMatrix::from_fn(free.len(), free.len(), entry),
        }
    }

    /// Returns the floating body that accelerates horizontally although no acceleration depends on its
    /// horizontal position.
    fn adrift(&self, linear: &Linear, free: &[usize]) -> Option<String> {
        let model = &self.plant.model;
        let pushed = |body: &usize| {
            let node = &model.tree.nodes[*body];
            let place = |i: usize| free.iter().position(|velocity| *velocity == node.velocities + i);
            let [Some(x), Some(y)] = [0, 1].map(place) else { return false };
            let held = [x, y].iter().any(|i| linear.stiffness.column(*i).amax() > SMALLEST_SHARE * linear.size());
            let across = [x, y].map(|i| linear.acceleration[i].abs());
            !held && across[0].max(across[1]) > SMALLEST_PUSH * linear.acceleration.amax()
        };
        let floats = |body: &usize| matches!(model.joints[*body].kind, JointKind::Floating(_));
        (0..model.joints.len()).filter(floats).find(pushed).map(|body| model.bodies[body].name.clone())
    }

    /// Returns the shift of the present equilibrium per acceleration, without waves and with prescribed
    /// coordinates held: the matrix of the last Newton move, by rows and columns of the free coordinates;
    /// `None` if it is singular.
    pub fn compliance(&self) -> Option<DMatrix<f64>> {
        let mut there = self.at_rest();
        let free = there.plant.model.free_coordinates();
        let (linear, (_, j)) = (there.linear_here(&free), there.mass_and_constraints());
        let inverse = linear.bordered(&j, linear.largest_delta()).try_inverse()?;
        Some(inverse.view((0, 0), (free.len(), free.len())).into_owned())
    }

    /// Moves along `xi` with the loops closed; if they cannot be closed, along a half, a quarter and so on.
    /// Returns whether a move was possible.
    fn go(&mut self, xi: &[f64]) -> bool {
        let (from, still) = (self.state.clone(), vec![0.0; xi.len()]);
        (0..MOST_HALVINGS).any(|halvings| {
            let share = 0.5_f64.powi(halvings);
            let part: Vec<f64> = xi.iter().map(|xi| share * xi).collect();
            let q = self.moved(&from.q, &part);
            if self.set_state(&q, &still, Some(&from.s)).is_err() {
                return false;
            }
            self.plant.keep_hold(&from.m, &mut self.state);
            self.close_loops().is_ok()
        })
    }
}

impl Linear {
    /// Returns the fastest-growing motion tangent to the loops' J: v' = A x with an eigenvalue 1 / T^2 of A.
    fn growth(&self, (mass, j): &(DMatrix<f64>, DMatrix<f64>), names: &[String]) -> Option<Instability> {
        let tangents = tangents(j, names.len());
        if tangents.ncols() == 0 {
            return None;
        }
        let a = tangents.transpose() * &self.stiffness * &tangents;
        let size = a.amax();
        let squares = a.clone().try_schur(f64::EPSILON, 0)?.complex_eigenvalues();
        let fastest = squares.iter().map(|square| square.re).max_by(f64::total_cmp)?;
        if fastest < GROWS[0].max(GROWS[1] * size) {
            return None;
        }
        // One step of inverse iteration, shifted from the eigenvalue by 1e-6 of the matrix's size so that it is not singular.
        let beside = a - DMatrix::identity(tangents.ncols(), tangents.ncols()) * (fastest + 1e-6 * size);
        let motion = tangents * beside.lu().solve(&DVector::from_element(squares.len(), 1.0))?;
        let energies = motion.component_mul(&(mass * &motion));
        Some(Instability::Growth { coordinate: names[energies.imax()].clone(), time_s: 1.0 / fastest.sqrt() })
    }
}

/// Returns unit columns that span the null space of J.
fn tangents(j: &DMatrix<f64>, count: usize) -> DMatrix<f64> {
    if j.nrows() == 0 {
        return DMatrix::identity(count, count);
    }
    let eigen = (j.transpose() * j).symmetric_eigen();
    let largest = eigen.eigenvalues.amax();
    // Eigenvalues are squares: directions in which the constraints are weaker than 1e-6 of the strongest
    // count as free.
    let passed: Vec<_> = (0..count).filter(|&k| eigen.eigenvalues[k] <= 1e-12 * largest).collect();
    eigen.eigenvectors.select_columns(&passed)
}
