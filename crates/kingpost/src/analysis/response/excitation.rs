//! Effect of regular waves of unit amplitude on the free coordinates.

use super::wave_forces::{FORCES, WaveForces};
use super::{ResponseError, solved};
use crate::dynamics::Kinematics;
use crate::elements::{AnyElement, RegularWaves, WavePlace};
use crate::model::Model;
use crate::sea::waves::wave_number;
use crate::simulation::Simulation;
use crate::spatial::{Twist, Vector3, Wrench};
use nalgebra::{Complex, DMatrix};

/// Wave loads on all elements on which waves act.
pub(super) struct WaveLoads<'a> {
    loaded: Vec<Loaded<'a>>,
}

/// An element, and the response of the free coordinates to its forces.
struct Loaded<'a> {
    element: Box<dyn RegularWaves + 'a>,
    /// Index of the element among all elements.
    index: usize,
    /// Position and heading of the element at rest.
    place: WavePlace,
    /// Accelerations of the free coordinates per force: M*^-1 J^T.
    mobility: DMatrix<f64>,
}

impl<'a> WaveLoads<'a> {
    /// Creates the wave loads for a simulation at rest.
    pub(super) fn new(
        elements: &'a [AnyElement],
        rest: &mut Simulation,
        free: &[usize],
    ) -> Result<Self, ResponseError> {
        let twists = twists(rest.model(), &rest.state().q, free);
        let at_rest = kinematics(rest.model(), &rest.state().q);
        let matrices = rest.moving_frame();
        let bordered = bordered(&matrices.m_star, &matrices.j).lu();
        let mut loaded = Vec::new();
        let in_waves = elements.iter().enumerate().filter_map(|(i, element)| Some((i, element.regular_waves()?)));
        for (index, element) in in_waves {
            let rows: Vec<[f64; 6]> = twists.iter().map(|twists| element.along(&at_rest, twists)).collect();
            let forces = DMatrix::from_fn(rows.len(), FORCES, |row, mode| rows[row][mode]);
            let right = forces.resize_vertically(free.len() + matrices.j.nrows(), 0.0);
            let mobility = solved(&bordered, right).ok_or(ResponseError::NoHull)?;
            let mobility = mobility.rows(0, free.len()).into_owned();
            loaded.push(Loaded { place: element.place(&at_rest), element, index, mobility });
        }
        // A tank responds at any frequency; the data of a hull limit the known ones.
        loaded.sort_by_key(|loaded: &Loaded<'_>| loaded.element.frequencies_rad_s().is_empty());
        let known = loaded.first().is_some_and(|first| !first.element.frequencies_rad_s().is_empty());
        if known { Ok(Self { loaded }) } else { Err(ResponseError::NoHull) }
    }

    /// Returns the requested frequencies; if none are requested, those of the first element's data with three
    /// more in each interval, because resonances are narrower than the grid of the data. All must be within
    /// the data of all elements.
    pub(super) fn frequencies(&self, asked: &[f64]) -> Result<Vec<f64>, ResponseError> {
        let all = if asked.is_empty() { refined(self.loaded[0].element.frequencies_rad_s()) } else { asked.to_vec() };
        for grid in self.loaded.iter().map(|loaded| loaded.element.frequencies_rad_s()) {
            let (Some(lowest), Some(highest)) = (grid.first(), grid.last()) else { continue };
            if let Some(&found) = all.iter().find(|omega| !(lowest..=highest).contains(omega)) {
                let allowed = format!("{lowest:.4} to {highest:.4} rad/s, which the database covers");
                return Err(ResponseError::Wave { quantity: "frequencies_rad_s", found, allowed });
            }
        }
        Ok(all)
    }

    /// Returns the reference point of the phases: the first element's position.
    pub(super) fn reference_m(&self) -> [f64; 2] {
        self.loaded[0].place.position
    }

    /// Returns the heading of the first element, rad.
    pub(super) fn heading_rad(&self) -> f64 {
        self.loaded[0].place.heading
    }

    /// Returns the accelerations of the free coordinates in waves of unit amplitude, one column for each
    /// direction.
    pub(super) fn accelerations(&self, omega: f64, directions: &[f64]) -> DMatrix<Complex<f64>> {
        let of = |loaded: &Loaded<'_>| {
            loaded.mobility.map(|entry| Complex::new(entry, 0.0)) * self.forces_on(loaded, omega, directions)
        };
        let each = self.loaded.iter().map(of);
        each.reduce(|sum, next| sum + next).unwrap_or_else(|| DMatrix::zeros(0, directions.len()))
    }

    /// Returns all forces of waves of unit amplitude, [`FORCES`] rows for each element, one column for each
    /// direction.
    pub(super) fn forces(&self, omega: f64, directions: &[f64]) -> DMatrix<Complex<f64>> {
        let mut all = DMatrix::zeros(FORCES * self.loaded.len(), directions.len());
        for (i, loaded) in self.loaded.iter().enumerate() {
            all.rows_mut(FORCES * i, FORCES).copy_from(&self.forces_on(loaded, omega, directions));
        }
        all
    }

    /// Returns the first row of an element, given by its index among all elements; `None` if waves do not act
    /// on it.
    pub(super) fn first_force_on(&self, element: usize) -> Option<usize> {
        Some(FORCES * self.loaded.iter().position(|loaded| loaded.index == element)?)
    }

    /// Returns the elevation at a position, world, m, of waves whose elevation at the reference point is 1.
    pub(super) fn elevation(&self, omega: f64, direction: f64, place: [f64; 2]) -> Complex<f64> {
        let k = wave_number(omega, &self.loaded[0].element.water());
        phase(k, direction, [0, 1].map(|axis| place[axis] - self.reference_m()[axis]))
    }

    fn forces_on(&self, loaded: &Loaded<'_>, omega: f64, directions: &[f64]) -> DMatrix<Complex<f64>> {
        let k = wave_number(omega, &loaded.element.water());
        let off = [0, 1].map(|axis| loaded.place.position[axis] - self.reference_m()[axis]);
        let amplitudes = loaded.element.amplitudes(omega, directions, &loaded.place);
        let mut force = DMatrix::from_fn(FORCES, directions.len(), |mode, wave| {
            let [re, im] = amplitudes[wave][mode];
            Complex::new(re, im)
        });
        for (mut column, &direction) in force.column_iter_mut().zip(directions) {
            column *= phase(k, direction, off);
        }
        force
    }

    /// Returns elements for a model at rest that apply the wave forces and have them as inputs.
    pub(super) fn as_inputs(&self, rest: &Simulation) -> Vec<WaveForces> {
        let bodies = rest.model().bodies.len();
        let at_rest = kinematics(rest.model(), &rest.state().q);
        let unit = |body: usize, entry: usize| {
            let mut twists = vec![Twist::zero(); bodies];
            let of = if entry < 3 { &mut twists[body].linear } else { &mut twists[body].angular };
            of.0[entry % 3] = 1.0;
            twists
        };
        let of = |loaded: &Loaded<'_>| {
            let on = |body: usize| {
                let along: [[f64; FORCES]; 6] =
                    core::array::from_fn(|entry| loaded.element.along(&at_rest, &unit(body, entry)));
                let wrench = |mode: usize| {
                    let part = |first: usize| core::array::from_fn(|axis| along[first + axis][mode]);
                    Wrench { force: Vector3(part(0)), moment: Vector3(part(3)) }
                };
                (body, core::array::from_fn(wrench))
            };
            WaveForces::new((0..bodies).map(on))
        };
        self.loaded.iter().map(of).collect()
    }
}

/// Returns the phase factor of waves of this direction at the offset `[x, y]`, m.
fn phase(k: f64, direction: f64, [x, y]: [f64; 2]) -> Complex<f64> {
    let (sin, cos) = libm::sincos(direction);
    let (sin, cos) = libm::sincos(k * (x * cos + y * sin));
    Complex::new(cos, sin)
}

/// Returns a grid with three more points in each interval.
fn refined(grid: &[f64]) -> Vec<f64> {
    let between = |pair: &[f64]| core::array::from_fn::<f64, 4, _>(|k| pair[0] + 0.25 * k as f64 * (pair[1] - pair[0]));
    grid.windows(2).flat_map(between).chain(grid.last().copied()).collect()
}

/// Returns M*, bordered by the loops' J.
fn bordered(m_star: &DMatrix<f64>, j: &DMatrix<f64>) -> DMatrix<f64> {
    let (n, constraints) = (m_star.nrows(), j.nrows());
    let mut bordered = DMatrix::zeros(n + constraints, n + constraints);
    bordered.view_mut((0, 0), (n, n)).copy_from(m_star);
    bordered.view_mut((0, n), (n, constraints)).copy_from(&j.transpose());
    bordered.view_mut((n, 0), (constraints, n)).copy_from(j);
    bordered
}

/// Returns the kinematics at rest.
pub(super) fn kinematics(model: &Model, q: &[f64]) -> Kinematics {
    let mut at = Kinematics::new(&model.tree);
    at.update(&model.tree, q, &vec![0.0; model.velocity_count]);
    at
}

/// Returns the twists of all bodies for unit rates of the free coordinates, one after another.
pub(super) fn twists(model: &Model, q: &[f64], free: &[usize]) -> Vec<Vec<Twist>> {
    let mut at = Kinematics::new(&model.tree);
    let by_unit_rate = |&i: &usize| {
        let mut v = vec![0.0; model.velocity_count];
        v[i] = 1.0;
        at.update(&model.tree, q, &v);
        at.twist.clone()
    };
    free.iter().map(by_unit_rate).collect()
}
