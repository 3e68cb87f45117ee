//! Frequency response of the columns of the results to small regular waves.

use super::excitation::WaveLoads;
use super::not_linear::NotLinear;
use super::random_sea::{self, RandomSea};
use super::resonances::{Resonance, resolved, resonances};
use super::rows::Rows;
use super::{AtRest, ResponseError, WaveGrid, check_directions, smoothness};
use crate::elements::{AnyElement, ShownWaves};
use crate::scenario::{BuiltScenario, Scenario};
use crate::simulation::Simulation;
use nalgebra::{Complex, DMatrix};
use serde::Serialize;

/// Frequency response of columns of the results per metre of wave amplitude: complex amplitudes H about the
/// values at rest. As in [`WaveResponse`](super::WaveResponse), a column is `mean + Re{a H e^(-i w t)}`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ColumnResponse {
    /// Propagation directions of the waves, rad.
    pub directions_rad: Vec<f64>,
    /// Angular frequencies, rad/s.
    pub frequencies_rad_s: Vec<f64>,
    /// Reference point of the phases, world, m.
    pub reference_m: [f64; 2],
    /// Heading of the first hull at rest, from the world's x counter-clockwise, rad.
    pub heading_rad: f64,
    /// Names of the columns.
    pub columns: Vec<String>,
    /// SI unit of each column.
    pub units: Vec<&'static str>,
    /// Value of each column at rest.
    pub mean: Vec<f64>,
    /// Reason why a column has no H; `None` if it has one.
    pub not_linear: Vec<Option<NotLinear>>,
    /// Real and imaginary part of H by direction, frequency and column; NaN if there is no H.
    #[serde(skip)]
    pub amplitudes: Vec<[f64; 2]>,
    /// Natural frequencies that waves can excite, the lowest first.
    pub resonances: Vec<Resonance>,
    /// Names of the lines whose drag is linearised for the sea.
    pub linearised: Vec<String>,
    /// Warnings.
    pub warnings: Vec<String>,
}

/// Amplitude of the waves with which columns are tested for linearity, m: far above rounding, and so small
/// that a smooth column is linear.
const PROBED_M: f64 = 1e-3;
/// Test waves: direction relative to the heading, rad, and position within the range of frequencies, as a
/// share.
const PROBED: [[f64; 2]; 6] = [[0.7, 0.1], [0.7, 0.3], [0.7, 0.6], [2.3, 0.1], [2.3, 0.3], [2.3, 0.6]];

impl Scenario {
    /// Returns the frequency response of columns of the results of a simulation of this scenario, like
    /// [`BuiltScenario::column_response`].
    ///
    /// # Errors
    /// A scenario that does not build; as [`BuiltScenario::column_response`].
    pub fn column_response(
        &self,
        simulation: &Simulation,
        waves: &WaveGrid,
        columns: &[String],
        about_resonances: bool,
    ) -> Result<ColumnResponse, ResponseError> {
        self.clone().build()?.column_response(simulation, waves, columns, about_resonances, None)
    }
}

impl BuiltScenario {
    /// Returns the frequency response of columns of the results of a simulation, in regular waves as in
    /// [`wave_response`](Self::wave_response); of all columns if `columns` is empty. `about_resonances` adds
    /// frequencies about each resonance that is narrower than the steps between the requested frequencies.
    ///
    /// With the states' amplitudes x and the forces f of waves of 1 m, `H = C x + D f + E`: C and D are the
    /// exact derivatives of a row of results at rest with respect to the states and to forces on the hulls (D
    /// because accelerations and joint loads depend directly on the forces); E is the direct contribution of
    /// the waves to a column, such as their elevation. A column without such a derivative has no H, but a
    /// reason.
    ///
    /// In a random sea, elements with [random drag](crate::elements::RandomDrag) have the linear drag of the mean square error that
    /// is least in the response itself, which is found by iteration; their nodes are states then, and the water at them is a further
    /// part of f.
    ///
    /// # Errors
    /// The errors of [`wave_response`](Self::wave_response), a column that does not exist, and drag that is not found.
    pub fn column_response(
        &self,
        simulation: &Simulation,
        waves: &WaveGrid,
        columns: &[String],
        about_resonances: bool,
        sea: Option<&RandomSea>,
    ) -> Result<ColumnResponse, ResponseError> {
        let elements = self.elements_in_waves()?;
        let drags = sea.map_or(Ok(None), |sea| random_sea::find(self, simulation, sea))?;
        let mut at = AtRest::new(self, simulation, drags)?;
        let loads = WaveLoads::new(elements, &mut at.rest, &at.free)?;
        let frequencies_rad_s = loads.frequencies(&waves.frequencies_rad_s)?;
        check_directions(&waves.directions_rad)?;
        let resonances = resonances(&at.linear.a);
        let frequencies_rad_s =
            if about_resonances { resolved(&frequencies_rad_s, &resonances) } else { frequencies_rad_s };
        let mut rows = Rows::new(self, &at, &loads)?;
        let shown = Shown::new(elements, &at, &loads, &mut rows);
        smoothness::mark(&mut rows, &probes(&at, &loads, &frequencies_rad_s)?);
        let chosen = chosen(&rows, columns)?;

        let count = waves.directions_rad.len() * frequencies_rad_s.len();
        let mut amplitudes = vec![[f64::NAN; 2]; count * chosen.len()];
        let of_chosen = DMatrix::from_fn(chosen.len(), rows.derivatives.ncols(), |row, by| {
            Complex::new(rows.derivatives[(chosen[row].place, by)], 0.0)
        });
        for (k, &omega) in frequencies_rad_s.iter().enumerate() {
            let moved = moved(&at, &loads, omega, &waves.directions_rad)?;
            let mut h = &of_chosen * moved;
            shown.add(&loads, omega, &waves.directions_rad, &chosen, &mut h);
            for direction in 0..waves.directions_rad.len() {
                let first = (direction * frequencies_rad_s.len() + k) * chosen.len();
                for (row, _) in chosen.iter().enumerate().filter(|(_, column)| column.not_linear.is_none()) {
                    let Complex { re, im } = h[(row, direction)];
                    amplitudes[first + row] = [re, im];
                }
            }
        }
        Ok(ColumnResponse {
            directions_rad: waves.directions_rad.clone(),
            frequencies_rad_s,
            reference_m: loads.reference_m(),
            heading_rad: loads.heading_rad(),
            columns: chosen.iter().map(|column| column.name.clone()).collect(),
            units: chosen.iter().map(|column| column.unit).collect(),
            mean: chosen.iter().map(|column| rows.mean[column.place]).collect(),
            not_linear: chosen.iter().map(|column| column.not_linear).collect(),
            amplitudes,
            resonances,
            linearised: linearised(&at, elements),
            warnings: warnings(&at, elements, &rows),
        })
    }
}

/// Returns warnings of an unstable equilibrium, of elements that are left out at rest, and of inputs that are held.
fn warnings(at: &AtRest, elements: &[AnyElement], rows: &Rows) -> Vec<String> {
    let unstable = at.instability.as_ref().map(|why| format!("the equilibrium is not stable: {why}"));
    let left_out = elements.iter().filter(|element| !is_linearised(at, element)).filter_map(|element| {
        let (name, text) = (element.name(), element.left_out_at_rest()?);
        Some(if name.is_empty() { text.to_owned() } else { format!("{name}: {text}") })
    });
    let held = rows.layout().inputs.iter().filter_map(|input| {
        let signal = input.signal.as_ref()?;
        Some(format!("{}: held at its present value; in a run it follows the signal {signal}", input.name))
    });
    let mut all: Vec<String> = Vec::new();
    for warning in unstable.into_iter().chain(left_out).chain(held) {
        if !all.contains(&warning) {
            all.push(warning);
        }
    }
    all
}

/// Returns the names of the lines whose drag is linearised for a random sea.
fn linearised(at: &AtRest, elements: &[AnyElement]) -> Vec<String> {
    let lines =
        elements.iter().filter(|element| is_linearised(at, element)).flat_map(|element| element.declare().lines);
    lines.map(|line| line.name).collect()
}

/// Whether the drag of an element is linearised for a random sea.
fn is_linearised(at: &AtRest, element: &AnyElement) -> bool {
    at.drags.is_some() && element.random_drag().is_some()
}

/// A column of the response.
struct Chosen {
    place: usize,
    name: String,
    unit: &'static str,
    not_linear: Option<NotLinear>,
}

fn chosen(rows: &Rows, names: &[String]) -> Result<Vec<Chosen>, ResponseError> {
    let all = rows.channels().list.iter().flat_map(|channel| {
        let each = channel.columns.iter().zip(&channel.units).enumerate();
        each.map(|(k, (name, unit))| (channel.offset + k, name, *unit))
    });
    let all: Vec<Chosen> = all
        .map(|(place, name, unit)| Chosen { place, name: name.clone(), unit, not_linear: rows.not_linear[place] })
        .collect();
    if names.is_empty() {
        return Ok(all);
    }
    let place = |name: &String| rows.channels().place(name).ok_or_else(|| ResponseError::Column(name.clone()));
    let places = names.iter().map(place).collect::<Result<Vec<_>, _>>()?;
    Ok(places.into_iter().map(|place| Chosen { name: all[place].name.clone(), ..all[place] }).collect())
}

/// Returns the amplitudes of the states, followed by those of the wave forces and of the water at nodes; one column for each
/// direction.
fn moved(
    at: &AtRest,
    loads: &WaveLoads<'_>,
    omega: f64,
    directions: &[f64],
) -> Result<DMatrix<Complex<f64>>, ResponseError> {
    let (x, f) = (at.states(loads, omega, directions)?, loads.forces(omega, directions));
    let (states, forces) = (x.nrows(), f.nrows());
    let components = at.water_components();
    let mut all = x.resize_vertically(states + forces + components, Complex::ZERO);
    all.rows_mut(states, forces).copy_from(&f);
    if let Some(water) = &at.water {
        all.rows_mut(states + forces, components).copy_from(&water.amplitudes(loads, omega, directions));
    }
    Ok(all)
}

/// Returns the changes of the states and forces in small test waves, at two times a quarter of a period
/// apart.
fn probes(at: &AtRest, loads: &WaveLoads<'_>, frequencies: &[f64]) -> Result<Vec<Vec<f64>>, ResponseError> {
    let mut probes = Vec::new();
    for [beside, share] in PROBED {
        let omega = frequencies[(share * frequencies.len() as f64) as usize];
        let moved = moved(at, loads, omega, &[loads.heading_rad() + beside])?;
        probes.push(moved.iter().map(|x| PROBED_M * x.re).collect());
        probes.push(moved.iter().map(|x| PROBED_M * x.im).collect());
    }
    Ok(probes)
}

/// Columns to which the waves contribute directly.
struct Shown {
    /// For each: index in a row, index of the first force on its element, and the contribution.
    each: Vec<(usize, Option<usize>, ShownWaves)>,
}

impl Shown {
    /// Collects the direct contributions of the waves to outputs of elements at rest; marks columns that are
    /// not proportional to the waves.
    fn new(elements: &[AnyElement], at: &AtRest, loads: &WaveLoads<'_>, rows: &mut Rows) -> Self {
        let bodies = super::excitation::kinematics(at.rest.model(), &at.rest.state().q);
        let (mut each, mut first) = (Vec::new(), 0);
        for (index, element) in elements.iter().enumerate() {
            for (number, shown) in element.shown_waves(&bodies) {
                let place = rows.channels().place_of_output(first + number);
                match shown {
                    ShownWaves::NotLinear => rows.not_linear[place] = Some(NotLinear::SecondOrder),
                    shown => each.push((place, loads.first_force_on(index), shown)),
                }
            }
            first += rows.layout().written_by(index);
        }
        Self { each }
    }

    /// Adds the contributions to amplitudes; one row for each chosen column, one column for each direction.
    fn add(
        &self,
        loads: &WaveLoads<'_>,
        omega: f64,
        directions: &[f64],
        chosen: &[Chosen],
        h: &mut DMatrix<Complex<f64>>,
    ) {
        let forces = loads.forces(omega, directions);
        for (row, column) in chosen.iter().enumerate() {
            for (_, first, shown) in self.each.iter().filter(|(place, ..)| *place == column.place) {
                for (wave, &direction) in directions.iter().enumerate() {
                    h[(row, wave)] += match (shown, first) {
                        (ShownWaves::Elevation { place, times }, _) => {
                            loads.elevation(omega, direction, *place) * *times
                        }
                        (ShownWaves::Force(mode), Some(first)) => forces[(first + mode, wave)],
                        _ => Complex::ZERO,
                    };
                }
            }
        }
    }
}
