//! The response of ship and crane to small regular waves: response amplitude operators.

mod columns;
mod excitation;
mod not_linear;
mod output;
mod resonances;
mod rows;
mod smoothness;
mod wave_forces;

pub use columns::ColumnResponse;
pub use not_linear::NotLinear;
pub use resonances::Resonance;

use super::{Linearization, Linearizer};
use crate::elements::AnyElement;
use crate::plant::Along;
use crate::scenario::{BuiltScenario, Scenario, ScenarioError};
use crate::simulation::{Instability, NoEquilibrium, Simulation};
use excitation::WaveLoads;
use nalgebra::{Complex, ComplexField, DMatrix, Dyn, LU};
use output::Outputs;
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// Regular waves.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct WaveGrid {
    /// Directions that they go to, from the world's x counter-clockwise, rad.
    pub directions_rad: Vec<f64>,
    /// Angular frequencies, rad/s; empty for those of the first hull's database with three more in each interval.
    pub frequencies_rad_s: Vec<f64>,
}

/// Motions of ship and crane per metre of wave amplitude, as complex amplitudes H: under the wave elevation `Re{a e^(-i
/// w t)}` at the reference point a motion is `Re{a H e^(-i w t)}`, so that the argument of H is its lag behind the
/// crest there.
///
/// Motions are small, about the equilibrium in still water, with held and prescribed coordinates at their present
/// values. The reference point is the origin of the first hull's database, on the waterplane.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct WaveResponse {
    /// Directions that the waves go to, rad.
    pub directions_rad: Vec<f64>,
    /// Angular frequencies, rad/s.
    pub frequencies_rad_s: Vec<f64>,
    /// Reference point of the phases, world, m.
    pub reference_m: [f64; 2],
    /// Heading of that hull at rest, from the world's x counter-clockwise, rad.
    pub heading_rad: f64,
    /// Bodies, at their centres of mass, then named points as `arm.tip`.
    pub places: Vec<String>,
    /// Their positions at rest, world, m.
    pub places_m: Vec<[f64; 3]>,
    /// Bodies whose angles are given.
    pub bodies: Vec<String>,
    /// Free coordinates.
    pub coordinates: Vec<String>,
    /// Names of the states, as in a [`Linearization`](super::Linearization).
    pub states: Vec<String>,
    /// Real parts of H, by direction, frequency and row. Rows are x, y, z of each place (world, m/m),
    /// roll, pitch, yaw of each body (rad/m), then the local coordinates of the free coordinates.
    pub real: Vec<f64>,
    /// Imaginary parts, alike.
    pub imaginary: Vec<f64>,
    /// The states themselves: real and imaginary parts by direction, frequency and state.
    #[serde(skip)]
    pub of_states: Vec<[f64; 2]>,
    /// Warnings.
    pub warnings: Vec<String>,
}

/// Why there is no response.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum ResponseError {
    /// A scenario that does not build.
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
    /// There is no equilibrium.
    #[error(transparent)]
    NoEquilibrium(#[from] NoEquilibrium),
    /// No waves act.
    #[error("forces: found no hull that waves act on, allowed: a hydrodynamics force with excitation on")]
    NoHull,
    /// A column that no row of the results has.
    #[error("columns: found {0:?}, allowed: columns of the results")]
    Column(String),
    /// A direction or frequency.
    #[error("{quantity}: found {found}, allowed: {allowed}")]
    Wave {
        /// `directions_rad` or `frequencies_rad_s`.
        quantity: &'static str,
        /// The value.
        found: f64,
        /// Range that is allowed.
        allowed: String,
    },
    /// A frequency at which an undamped motion is unbounded.
    #[error("frequencies_rad_s: found {found}, allowed: one away from the resonances of undamped motions")]
    Resonance {
        /// The frequency, rad/s.
        found: f64,
    },
}

impl Scenario {
    /// The response of a simulation of it to regular waves, as [`BuiltScenario::wave_response`].
    ///
    /// # Errors
    /// A scenario that does not build; as [`BuiltScenario::wave_response`].
    pub fn wave_response(&self, simulation: &Simulation, waves: &WaveGrid) -> Result<WaveResponse, ResponseError> {
        self.clone().build()?.wave_response(simulation, waves)
    }
}

impl BuiltScenario {
    /// The response of a simulation of it to regular waves, about its equilibrium in still water.
    ///
    /// With A of the linearised system, whose states hold the memory of radiation, and the wave loads' accelerations b
    /// = M*^-1 J^T X, `(-i w - A) x = b a`: for a hull alone `(-w^2 (M + A(w)) - i w B(w) + C) xi = X a` (Newman,
    /// *Marine Hydrodynamics*, 1977, sec. 6.17), with A(w) and B(w) of the fitted radiation. X is that of the database,
    /// for the heading of the hull and with the phase of its position. Quadratic damping has no effect, since it is 0
    /// at rest.
    ///
    /// # Errors
    /// No equilibrium, no hull, a frequency that a database does not cover.
    pub fn wave_response(&self, simulation: &Simulation, waves: &WaveGrid) -> Result<WaveResponse, ResponseError> {
        let elements = self.elements_in_waves()?;
        let mut at_rest = AtRest::new(self, simulation)?;
        let loads = WaveLoads::new(elements, &mut at_rest.rest, &at_rest.free)?;
        let frequencies_rad_s = loads.frequencies(&waves.frequencies_rad_s)?;
        check_directions(&waves.directions_rad)?;
        let AtRest { rest, free, linear, .. } = &at_rest;
        let outputs = Outputs::new(rest, free);

        let (states, directions) = (linear.states.len(), waves.directions_rad.len());
        let width = outputs.rows();
        let numbers = directions * frequencies_rad_s.len();
        let (mut real, mut imaginary) = (vec![0.0; numbers * width], vec![0.0; numbers * width]);
        let mut of_states = vec![[0.0; 2]; numbers * states];
        for (k, &omega) in frequencies_rad_s.iter().enumerate() {
            let x = at_rest.states(&loads, omega, &waves.directions_rad)?;
            for direction in 0..directions {
                let at = direction * frequencies_rad_s.len() + k;
                let x = x.column(direction);
                for (to, x) in of_states[at * states..].iter_mut().zip(x.iter()) {
                    *to = [x.re, x.im];
                }
                let motions = outputs.of(&x.rows(0, free.len()).into_owned());
                for (row, h) in motions.iter().enumerate() {
                    (real[at * width + row], imaginary[at * width + row]) = (h.re, h.im);
                }
            }
        }
        Ok(WaveResponse {
            directions_rad: waves.directions_rad.clone(),
            frequencies_rad_s,
            reference_m: loads.reference_m(),
            heading_rad: loads.heading_rad(),
            places: outputs.places,
            places_m: outputs.places_m,
            bodies: outputs.bodies,
            coordinates: rest.coordinates(),
            states: linear.states.clone(),
            real,
            imaginary,
            of_states,
            warnings: self.hydrostatic_report_at(rest).map_or_else(|_| Vec::new(), |report| report.warnings),
        })
    }

    /// Its elements, among which are some that waves act on.
    fn elements_in_waves(&self) -> Result<&[AnyElement], ResponseError> {
        let elements = &self.setup().elements;
        let in_waves = elements.iter().any(|element| element.regular_waves().is_some());
        if in_waves { Ok(elements) } else { Err(ResponseError::NoHull) }
    }
}

/// A simulation at rest in still water, linearised there.
struct AtRest {
    rest: Simulation,
    linear: Linearization,
    /// Indices in v of the free coordinates.
    free: Vec<usize>,
    /// Variable of each state.
    along: Vec<Along>,
    /// Why nothing stays there, if it does not.
    instability: Option<Instability>,
}

impl AtRest {
    fn new(scenario: &BuiltScenario, simulation: &Simulation) -> Result<Self, ResponseError> {
        let mut rest = simulation.clone();
        let instability = rest.settle()?.instability;
        let mut linearizer = Linearizer::of_built(scenario)?.at_rest();
        let free: Vec<usize> = linearizer.positions().collect();
        let linear = linearizer.at(&rest);
        Ok(Self { rest, linear, free, along: linearizer.along().to_vec(), instability })
    }

    /// Amplitudes of the states in waves of 1 m, a column for each direction: `(-i w - A) x = b`.
    fn states(
        &self,
        loads: &WaveLoads<'_>,
        omega: f64,
        directions: &[f64],
    ) -> Result<DMatrix<Complex<f64>>, ResponseError> {
        let (states, free) = (self.linear.states.len(), self.free.len());
        let mut right = DMatrix::<Complex<f64>>::zeros(states, directions.len());
        right.view_mut((free, 0), (free, directions.len())).copy_from(&loads.accelerations(omega, directions));
        let system = DMatrix::from_fn(states, states, |i, j| {
            Complex::new(-self.linear.a[(i, j)], if i == j { -omega } else { 0.0 })
        });
        solved(&system.lu(), right).ok_or(ResponseError::Resonance { found: omega })
    }
}

/// The solution of a system, which has no unknowns if nothing can move: nalgebra's panics on it.
fn solved<T: ComplexField>(factors: &LU<T, Dyn, Dyn>, right: DMatrix<T>) -> Option<DMatrix<T>> {
    if right.nrows() == 0 { Some(right) } else { factors.solve(&right) }
}

fn check_directions(directions_rad: &[f64]) -> Result<(), ResponseError> {
    let wrong = directions_rad.iter().find(|direction| !direction.is_finite());
    let allowed = "finite numbers".to_owned();
    wrong.map_or(Ok(()), |&found| Err(ResponseError::Wave { quantity: "directions_rad", found, allowed }))
}
