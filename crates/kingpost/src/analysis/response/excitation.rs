//! What regular waves of unit amplitude do to the free coordinates.

use super::ResponseError;
use crate::dynamics::Kinematics;
use crate::elements::hull::{ByHeading, SeaAxes, SlowFrame};
use crate::elements::{Hull, of_kind};
use crate::model::Model;
use crate::scenario::{Scenario, schema};
use crate::sea::database::Database;
use crate::sea::waves::{Water, wave_number};
use crate::simulation::Simulation;
use crate::spatial::{Frame, Twist};
use nalgebra::{Complex, DMatrix};

/// The wave loads on all hulls.
pub(super) struct WaveLoads<'a> {
    hulls: Vec<LoadedHull<'a>>,
}

/// One hull: its data, and how its body's free coordinates answer forces on it.
struct LoadedHull<'a> {
    database: &'a Database,
    water: Water,
    /// Where it is and heads, at rest.
    place: SlowFrame,
    /// Accelerations of the free coordinates by force and moment about the data's origin in the axes of
    /// its heading: M*^-1 J^T.
    mobility: DMatrix<f64>,
}

impl<'a> WaveLoads<'a> {
    /// Of a simulation at rest.
    pub(super) fn new(scenario: &'a Scenario, rest: &mut Simulation, free: &[usize]) -> Result<Self, ResponseError> {
        let setup = scenario.setup()?;
        let hulls = of_kind::<f64, Hull>(&setup.elements);
        let twists = twists(rest.model(), &rest.state().q, free);
        let matrices = rest.moving_frame();
        let bordered = bordered(&matrices.m_star, &matrices.j).lu();
        let mut found = Vec::new();
        for hull in hulls {
            let Some(database) = scenario.waves_on(&hull.name) else { continue };
            let at_rest = kinematics(rest.model(), &rest.state().q);
            let frame = at_rest.world[hull.frame.body].times(&Frame::translation(hull.frame.origin));
            let place = SlowFrame::of(&frame);
            let forces = generalized_forces(hull, &frame, &place, &twists);
            let right = forces.resize_vertically(free.len() + matrices.j.nrows(), 0.0);
            let mobility = bordered.solve(&right).ok_or(ResponseError::NoHull)?;
            let mobility = mobility.rows(0, free.len()).into_owned();
            let given = database.water;
            let water = Water { gravity_m_s2: given.gravity_m_s2, depth_m: given.depth_m, ..Water::default() };
            found.push(LoadedHull { database, water, place, mobility });
        }
        if found.is_empty() { Err(ResponseError::NoHull) } else { Ok(Self { hulls: found }) }
    }

    /// The frequencies asked for, or those of the first database with three between each two, since
    /// resonances are narrower than what a database needs; all within all databases.
    pub(super) fn frequencies(&self, asked: &[f64]) -> Result<Vec<f64>, ResponseError> {
        let all = if asked.is_empty() { refined(&self.hulls[0].database.frequencies_rad_s) } else { asked.to_vec() };
        for hull in &self.hulls {
            if let Some(&found) = all.iter().find(|omega| !hull.database.covers(**omega)) {
                let grid = &hull.database.frequencies_rad_s;
                let allowed = format!("{:.4} to {:.4} rad/s, which the database covers", grid[0], grid[grid.len() - 1]);
                return Err(ResponseError::Wave { quantity: "frequencies_rad_s", found, allowed });
            }
        }
        Ok(all)
    }

    /// The place that phases are about: the first hull's.
    pub(super) fn reference_m(&self) -> [f64; 2] {
        self.hulls[0].place.position
    }

    /// The heading of the first hull, rad.
    pub(super) fn heading_rad(&self) -> f64 {
        self.hulls[0].place.heading
    }

    /// Accelerations of the free coordinates under waves of unit amplitude, a column for each direction.
    pub(super) fn accelerations(&self, omega: f64, directions: &[f64]) -> DMatrix<Complex<f64>> {
        let reference = self.reference_m();
        let each = self.hulls.iter().map(|hull| hull.accelerations(omega, directions, reference));
        each.reduce(|sum, next| sum + next).unwrap_or_else(|| DMatrix::zeros(0, directions.len()))
    }
}

impl LoadedHull<'_> {
    fn accelerations(&self, omega: f64, directions: &[f64], reference: [f64; 2]) -> DMatrix<Complex<f64>> {
        let k = wave_number(omega, &self.water);
        let [x, y] = [0, 1].map(|axis| self.place.position[axis] - reference[axis]);
        let mut force = self.excitation(omega, directions);
        for (mut column, &direction) in force.column_iter_mut().zip(directions) {
            let (sin, cos) = libm::sincos(direction);
            let (sin, cos) = libm::sincos(k * (x * cos + y * sin));
            column *= Complex::new(cos, sin);
        }
        self.mobility.map(|entry| Complex::new(entry, 0.0)) * force
    }

    /// X at the hull's heading, a column for each direction.
    fn excitation(&self, omega: f64, directions: &[f64]) -> DMatrix<Complex<f64>> {
        let on_grid = self.database.excitation(omega, true);
        let part = |part: usize, _| on_grid.iter().map(|x| x[part / 2][part % 2]).collect();
        let mut table = ByHeading::new(PARTS, directions, part);
        let values = table.at(self.place.heading);
        let at = |part: usize, wave: usize| values[part * directions.len() + wave];
        DMatrix::from_fn(6, directions.len(), |mode, wave| Complex::new(at(2 * mode, wave), at(2 * mode + 1, wave)))
    }
}

/// A grid with three points more in each interval.
fn refined(grid: &[f64]) -> Vec<f64> {
    let between = |pair: &[f64]| core::array::from_fn::<f64, 4, _>(|k| pair[0] + 0.25 * k as f64 * (pair[1] - pair[0]));
    grid.windows(2).flat_map(between).chain(grid.last().copied()).collect()
}

/// Real and imaginary part of six modes.
const PARTS: usize = 12;

impl Scenario {
    /// Whether waves act on any hull.
    pub(super) fn has_wave_loads(&self) -> bool {
        self.forces.keys().any(|name| self.waves_on(name).is_some())
    }

    /// The database of a force, where waves act by it.
    fn waves_on(&self, force: &str) -> Option<&Database> {
        let (_, force) = self.forces.iter().find(|(name, _)| name.as_str() == force)?;
        let schema::Force::Hydrodynamics(given) = force else { return None };
        let database = self.files.database(&given.database)?;
        (given.enabled && given.excitation).then_some(&**database)
    }
}

/// J^T: forces of the free coordinates by the loads of the sea.
fn generalized_forces(hull: &Hull, frame: &Frame, place: &SlowFrame, twists: &[Vec<Twist>]) -> DMatrix<f64> {
    let axes = SeaAxes::of(frame, place);
    let rows: Vec<[f64; 6]> = twists.iter().map(|twist| hull.along(&axes, &twist[hull.frame.body])).collect();
    DMatrix::from_fn(rows.len(), 6, |row, mode| rows[row][mode])
}

/// M*, bordered by the loops' J.
fn bordered(m_star: &DMatrix<f64>, j: &DMatrix<f64>) -> DMatrix<f64> {
    let (n, constraints) = (m_star.nrows(), j.nrows());
    let mut bordered = DMatrix::zeros(n + constraints, n + constraints);
    bordered.view_mut((0, 0), (n, n)).copy_from(m_star);
    bordered.view_mut((0, n), (n, constraints)).copy_from(&j.transpose());
    bordered.view_mut((n, 0), (constraints, n)).copy_from(j);
    bordered
}

/// Where everything is, at rest.
pub(super) fn kinematics(model: &Model, q: &[f64]) -> Kinematics {
    let mut at = Kinematics::new(&model.tree);
    at.update(&model.tree, q, &vec![0.0; model.velocity_count]);
    at
}

/// Twists of all bodies by unit rates of the free coordinates, one after another.
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
