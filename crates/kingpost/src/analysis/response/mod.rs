//! Response of ship and crane to small regular waves: response amplitude operators.

mod columns;
mod excitation;
mod not_linear;
mod output;
mod random_drags;
mod random_sea;
mod resonances;
mod rows;
mod smoothness;
mod wave_forces;

pub use columns::ColumnResponse;
pub use not_linear::NotLinear;
pub use random_sea::RandomSea;
pub use resonances::Resonance;

use super::{Linearization, Linearizer};
use crate::elements::AnyElement;
use crate::plant::{Along, Number, Plant};
use crate::scenario::{BuiltScenario, Scenario, ScenarioError};
use crate::simulation::{Instability, NoEquilibrium, Setup, Simulation};
use excitation::WaveLoads;
use nalgebra::{Complex, ComplexField, DMatrix, Dyn, LU};
use output::Outputs;
use random_drags::{RandomDrags, WaterAtNodes};
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// Directions and frequencies of regular waves.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct WaveGrid {
    /// Propagation directions, from the world's x counter-clockwise, rad.
    pub directions_rad: Vec<f64>,
    /// Angular frequencies, rad/s; if empty, those of the first hull's database with three more in each
    /// interval.
    pub frequencies_rad_s: Vec<f64>,
}

/// Motions of ship and crane per metre of wave amplitude, as complex amplitudes H: for the wave elevation
/// `Re{a e^(-i w t)}` at the reference point a motion is `Re{a H e^(-i w t)}`, so the argument of H is the
/// phase lag of the motion behind the wave crest.
///
/// Motions are small, about the equilibrium in still water, with held and prescribed coordinates at their present
/// values. The reference point is the origin of the first hull's database, on the waterplane.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct WaveResponse {
    /// Propagation directions of the waves, rad.
    pub directions_rad: Vec<f64>,
    /// Angular frequencies, rad/s.
    pub frequencies_rad_s: Vec<f64>,
    /// Reference point of the phases, world, m.
    pub reference_m: [f64; 2],
    /// Heading of the first hull at rest, from the world's x counter-clockwise, rad.
    pub heading_rad: f64,
    /// Names of the bodies, for their centres of mass, then of the points, such as `arm.tip`.
    pub places: Vec<String>,
    /// Positions of these at rest, world, m.
    pub places_m: Vec<[f64; 3]>,
    /// Bodies whose roll, pitch and yaw are given.
    pub bodies: Vec<String>,
    /// Free coordinates.
    pub coordinates: Vec<String>,
    /// Names of the states, as in a [`Linearization`](super::Linearization).
    pub states: Vec<String>,
    /// Real parts of H, by direction, frequency and row. Rows are x, y, z of each place (world, m/m),
    /// roll, pitch, yaw of each body (rad/m), then the local coordinates of the free coordinates.
    pub real: Vec<f64>,
    /// Imaginary parts of H, in the same order.
    pub imaginary: Vec<f64>,
    /// Complex amplitudes of the states: real and imaginary parts by direction, frequency and state.
    #[serde(skip)]
    pub of_states: Vec<[f64; 2]>,
    /// Warnings.
    pub warnings: Vec<String>,
}

/// Reason why there is no response.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum ResponseError {
    /// The scenario does not build.
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
    /// There is no equilibrium.
    #[error(transparent)]
    NoEquilibrium(#[from] NoEquilibrium),
    /// Waves act on no element.
    #[error("forces: found no hull that waves act on, allowed: a hydrodynamics force with excitation on")]
    NoHull,
    /// The results have no column with this name.
    #[error("columns: found {0:?}, allowed: columns of the results")]
    Column(String),
    /// A direction or frequency is not valid.
    #[error("{quantity}: found {found}, allowed: {allowed}")]
    Wave {
        /// `directions_rad` or `frequencies_rad_s`.
        quantity: &'static str,
        /// The value.
        found: f64,
        /// Range that is allowed.
        allowed: String,
    },
    /// The iteration for the drag in a random sea does not converge.
    #[error(
        "the drag in this sea is not found within {iterations} iterations: the variance of a relative velocity still changes by a share \
         of {change:.3e}, allowed: {allowed:e}"
    )]
    Drag {
        /// Number of iterations.
        iterations: usize,
        /// The largest change, as a share.
        change: f64,
        /// The largest change that is allowed.
        allowed: f64,
    },
    /// At this frequency an undamped motion is unbounded.
    #[error("frequencies_rad_s: found {found}, allowed: a frequency away from the resonances of undamped motions")]
    Resonance {
        /// The frequency, rad/s.
        found: f64,
    },
}

impl Scenario {
    /// Returns the response of a simulation of this scenario to regular waves, like
    /// [`BuiltScenario::wave_response`].
    ///
    /// # Errors
    /// A scenario that does not build; as [`BuiltScenario::wave_response`].
    pub fn wave_response(&self, simulation: &Simulation, waves: &WaveGrid) -> Result<WaveResponse, ResponseError> {
        self.clone().build()?.wave_response(simulation, waves)
    }
}

impl BuiltScenario {
    /// Returns the response of a simulation of this scenario to regular waves, about its equilibrium in still
    /// water.
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
        let mut at_rest = AtRest::new(self, simulation, None)?;
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

    /// Returns the elements of the scenario; an error if waves act on none of them.
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
    /// Instability of the equilibrium, if it is unstable.
    instability: Option<Instability>,
    /// Drag of the elements that respond to a random sea, and the water at their nodes; `None` if none does.
    drags: Option<RandomDrags>,
    water: Option<WaterAtNodes>,
}

impl AtRest {
    /// Settles a simulation and linearises it there, with this drag in a random sea.
    fn new(
        scenario: &BuiltScenario,
        simulation: &Simulation,
        drags: Option<RandomDrags>,
    ) -> Result<Self, ResponseError> {
        let mut rest = simulation.clone();
        if let Some(drags) = &drags {
            rest.set_spreads(&drags.at_rest);
        }
        let instability = rest.settle()?.instability;
        let Setup { model, world, elements, .. } = setup_of(scenario, drags.as_ref())?;
        let plant = Plant::new(model, world, elements);
        let mut linearizer = Linearizer::of_plant(plant.clone()).at_rest();
        let free: Vec<usize> = linearizer.positions().collect();
        let (linear, along) = (linearizer.at(&rest), linearizer.along().to_vec());
        let water = drags.as_ref().map(|drags| WaterAtNodes::new(plant, rest.stage(), &along, drags));
        Ok(Self { rest, linear, free, along, instability, drags, water })
    }

    /// Returns the rates of the states by waves of 1 m, one column for each direction.
    fn forcing(&self, loads: &WaveLoads<'_>, omega: f64, directions: &[f64]) -> DMatrix<Complex<f64>> {
        let (states, free) = (self.linear.states.len(), self.free.len());
        let mut rates = DMatrix::<Complex<f64>>::zeros(states, directions.len());
        rates.view_mut((free, 0), (free, directions.len())).copy_from(&loads.accelerations(omega, directions));
        if let Some(water) = &self.water {
            rates += water.forcing(loads, omega, directions);
        }
        rates
    }

    /// Returns the amplitudes of the states in waves of 1 m, one column for each direction: `(-i w - A) x =
    /// b`.
    fn states(
        &self,
        loads: &WaveLoads<'_>,
        omega: f64,
        directions: &[f64],
    ) -> Result<DMatrix<Complex<f64>>, ResponseError> {
        let (states, right) = (self.linear.states.len(), self.forcing(loads, omega, directions));
        let system = DMatrix::from_fn(states, states, |i, j| {
            Complex::new(-self.linear.a[(i, j)], if i == j { -omega } else { 0.0 })
        });
        solved(&system.lu(), right).ok_or(ResponseError::Resonance { found: omega })
    }
}

/// Returns the setup over dual numbers, whose elements have this drag in a random sea.
fn setup_of(scenario: &BuiltScenario, drags: Option<&RandomDrags>) -> Result<Setup<Number>, ScenarioError> {
    let mut setup = scenario.dual_setup()?.clone();
    if let Some(drags) = drags {
        drags.put_into(&mut setup.elements);
    }
    Ok(setup)
}

/// Returns the solution of a linear system; also of one without unknowns, if no coordinate can move, for
/// which nalgebra panics.
fn solved<T: ComplexField>(factors: &LU<T, Dyn, Dyn>, right: DMatrix<T>) -> Option<DMatrix<T>> {
    if right.nrows() == 0 { Some(right) } else { factors.solve(&right) }
}

fn check_directions(directions_rad: &[f64]) -> Result<(), ResponseError> {
    let wrong = directions_rad.iter().find(|direction| !direction.is_finite());
    let allowed = "finite numbers".to_owned();
    wrong.map_or(Ok(()), |&found| Err(ResponseError::Wave { quantity: "directions_rad", found, allowed }))
}
