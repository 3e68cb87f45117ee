//! Hydrodynamic database of a hull, from potential theory; it is read from a file.
//!
//! The frame of the data has x forward, y to port, z up, and z = 0 on the water plane at the stated draught.
//! Six-vectors are force or translation x, y, z, then moment or rotation x, y, z about its origin. The time
//! factor is `e^(-i w t)`: a wave whose elevation at the origin is `Re{a e^(-i w t)}` exerts the force `Re{X
//! a e^(-i w t)}`. The data are for zero forward speed.

mod check;
mod drift;
mod error;
mod physical;
mod plausible;
mod several;

pub use error::DatabaseError;
pub use several::{CouplingBlock, HullCoupling, HullPlace, HydrodynamicData};

use serde::Deserialize;
use serde_json::Value;

/// Names of the six modes of motion.
pub const MODES: [&str; 6] = ["surge", "sway", "heave", "roll", "pitch", "yaw"];

/// A 6x6 matrix over the modes.
pub type SixBySix = [[f64; 6]; 6];

/// Hydrodynamic data of a hull.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Database {
    format: String,
    version: u32,
    /// Title of one line.
    pub title: String,
    /// Program and input data from which the database was made.
    #[serde(default)]
    pub provenance: Value,
    /// Water for which the data were computed.
    pub water: DatabaseWater,
    /// The hull at rest.
    pub hull: HullAtRest,
    /// Frequencies, rad/s, increasing.
    pub frequencies_rad_s: Vec<f64>,
    /// Propagation directions of the waves relative to the hull's x axis, rad: a regular grid of the full
    /// circle from 0.
    pub wave_directions_rad: Vec<f64>,
    /// Added mass A by frequency, kg, kg m, kg m^2.
    pub added_mass: Vec<SixBySix>,
    /// Radiation damping B by frequency, kg/s, kg m/s, kg m^2/s.
    pub radiation_damping: Vec<SixBySix>,
    /// Added mass A at infinite frequency.
    pub added_mass_infinite: SixBySix,
    /// Froude-Krylov excitation: the pressure of the incident wave, N/m, N m/m.
    pub froude_krylov: ExcitationTable,
    /// Diffraction excitation: the waves that the hull scatters.
    pub diffraction: ExcitationTable,
    /// Mean drift by frequency and direction: surge and sway force, yaw moment per amplitude squared, hull axes, N/m^2,
    /// N m/m^2.
    #[serde(default)]
    pub mean_drift: Option<Vec<Vec<[f64; 3]>>>,
    /// Loading for which the mean drift was computed, if the data contain it.
    #[serde(default)]
    pub mean_drift_loading: Option<DriftLoading>,
    /// Fitted state-space model of radiation.
    #[serde(default)]
    pub radiation: Option<RadiationModel>,
    /// Largest distance from the origin at which a hull of the same file scatters waves, m; 0 for one hull alone.
    #[serde(skip)]
    pub reach_m: f64,
}

/// Loading of a hull: the motion in waves depends on it, and so does the drift.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DriftLoading {
    /// Mass, kg.
    pub mass_kg: f64,
    /// KG, m.
    pub keel_to_gravity_m: f64,
    /// Radii of gyration in roll, pitch and yaw, about the centre of gravity, m.
    pub radii_of_gyration_m: [f64; 3],
    /// Viscous roll damping in the computation, as a share of the critical damping.
    pub roll_damping_ratio: f64,
}

/// Water.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DatabaseWater {
    /// Density, kg/m^3.
    pub density_kg_m3: f64,
    /// Acceleration of gravity, m/s^2.
    pub gravity_m_s2: f64,
    /// Depth, m; `None` if it is infinite.
    pub depth_m: Option<f64>,
}

/// A hull at rest.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HullAtRest {
    /// Draught, m.
    pub draught_m: f64,
    /// Length of the water line, m.
    pub length_m: f64,
    /// Beam of the water line, m.
    pub beam_m: f64,
    /// Displaced volume, m^3.
    pub volume_m3: f64,
    /// Centre of buoyancy, m.
    pub centre_of_buoyancy_m: [f64; 3],
    /// Waterplane.
    pub waterplane: WaterplaneMoments,
    /// Closed mesh of the whole hull with its deck.
    #[serde(default)]
    pub mesh: Option<Mesh>,
    /// Attitude of the hull for the coefficients, if it is not upright at the stated draught. All other data
    /// are for the upright hull.
    #[serde(default)]
    pub attitude: Option<Attitude>,
}

/// Pose of the upright hull's axes in the axes of the coefficients: rotated by `Ry(pitch) Rx(roll)`, with the
/// origin above or below that of the coefficients, which is on the waterplane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Attitude {
    /// Heel to starboard, rad.
    pub roll_rad: f64,
    /// Trim by the bow, rad.
    pub pitch_rad: f64,
    /// Height of the upright hull's origin above the waterplane, m.
    pub height_m: f64,
}

/// Moments of the waterplane's area about the origin.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WaterplaneMoments {
    /// Area, m^2.
    pub area_m2: f64,
    /// Integrals of x and y, m^3.
    pub first_moments_m3: [f64; 2],
    /// Integrals of x^2, x y, y^2, m^4.
    pub second_moments_m4: [f64; 3],
}

/// A triangle mesh.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mesh {
    /// Vertices, m.
    pub vertices_m: Vec<[f64; 3]>,
    /// Indices of vertices, counter-clockwise seen from the water.
    pub triangles: Vec<[usize; 3]>,
}

/// Complex excitation per wave amplitude, by frequency, direction and mode.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ExcitationTable {
    /// Real part.
    pub real: Vec<Vec<[f64; 6]>>,
    /// Imaginary part.
    pub imaginary: Vec<Vec<[f64; 6]>>,
}

/// Poles and residues of the retardation functions' transforms: `K_ij(s) = sum r_ij / (s - p) + conjugate` over the
/// poles of mode j; without the conjugate for a real pole.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RadiationModel {
    /// Memory by the mode of the motion.
    pub modes: [RadiationMode; 6],
    /// Largest relative error of the fit.
    pub fit_error: f64,
}

/// Radiation memory of the motion in one mode.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RadiationMode {
    /// Poles, real and imaginary part; of a conjugate pair, the pole with a positive imaginary part.
    pub poles_rad_s: Vec<[f64; 2]>,
    /// Residues by pole and by the mode of the force: real and imaginary part.
    pub residues: Vec<[[f64; 2]; 6]>,
}

/// A square matrix over the modes of one or several hulls, by rows.
type Matrix = Vec<Vec<f64>>;

/// The memory of one or several hulls, by the mode of the motion.
type Memory = Vec<MemoryOfMode>;

/// Radiation memory of the motion in one mode, with residues for the modes of one or several hulls.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct MemoryOfMode {
    poles_rad_s: Vec<[f64; 2]>,
    residues: Vec<Vec<[f64; 2]>>,
}

impl From<&RadiationMode> for MemoryOfMode {
    fn from(mode: &RadiationMode) -> Self {
        let residues = mode.residues.iter().map(|row| row.to_vec()).collect();
        Self { poles_rad_s: mode.poles_rad_s.clone(), residues }
    }
}

/// Returns a message of the JSON parser without its position, which an error shows before the message, and
/// without the names of Rust types.
fn in_words(message: &str) -> String {
    let message = message.rsplit_once(" at line ").map_or(message, |(words, _)| words);
    message.replace("expected f64", "expected a number").replace("invalid type: ", "").replace("invalid length ", "")
}

fn unreadable(error: &serde_json::Error) -> DatabaseError {
    DatabaseError {
        field: format!("line {}, column {}", error.line(), error.column()),
        found: in_words(&error.to_string()),
        allowed: "a whole hydrodynamic database, as kingpost hydro writes it".to_owned(),
    }
}

impl Database {
    /// Reads and checks a database's text.
    ///
    /// # Errors
    /// The first error: another format, a truncated file, or impossible numbers.
    pub fn read(text: &str) -> Result<Self, DatabaseError> {
        let database: Self = serde_json::from_str(text).map_err(|error| unreadable(&error))?;
        check::check(&database)?;
        Ok(database)
    }

    /// Returns the complex excitation at a frequency, interpolated linearly: by Froude-Krylov pressure and
    /// diffraction together, or by diffraction alone; real and imaginary part by direction and mode.
    pub fn excitation(&self, omega_rad_s: f64, froude_krylov: bool) -> Vec<[[f64; 2]; 6]> {
        let (below, share) = self.bracket(omega_rad_s);
        let part = |k: usize, direction: usize, mode: usize| {
            let of = |x: &ExcitationTable| [x.real[k][direction][mode], x.imaginary[k][direction][mode]];
            let (own, scattered) = (of(&self.froude_krylov), of(&self.diffraction));
            if froude_krylov { [own[0] + scattered[0], own[1] + scattered[1]] } else { scattered }
        };
        let at = |direction: usize| {
            core::array::from_fn(|mode| {
                let (a, b) = (part(below, direction, mode), part(below + 1, direction, mode));
                [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])]
            })
        };
        (0..self.wave_directions_rad.len()).map(at).collect()
    }

    /// Returns whether Froude-Krylov and diffraction excitation are separate.
    pub fn has_froude_krylov(&self) -> bool {
        self.froude_krylov.real.iter().flatten().flatten().any(|force| *force != 0.0)
    }

    /// Returns whether a frequency is within the grid.
    pub fn covers(&self, omega_rad_s: f64) -> bool {
        let [lowest, highest] = self.band_rad_s();
        (lowest..=highest).contains(&omega_rad_s)
    }

    /// Returns the lowest and the highest frequency, rad/s.
    pub fn band_rad_s(&self) -> [f64; 2] {
        [self.frequencies_rad_s[0], self.frequencies_rad_s[self.frequencies_rad_s.len() - 1]]
    }

    /// Returns the interval of the grid that contains a frequency, and the position within it; outside the
    /// grid, the nearest end.
    fn bracket(&self, omega_rad_s: f64) -> (usize, f64) {
        let grid = &self.frequencies_rad_s;
        let below = grid.partition_point(|omega| *omega <= omega_rad_s).clamp(1, grid.len() - 1) - 1;
        let share = (omega_rad_s - grid[below]) / (grid[below + 1] - grid[below]);
        (below, share.clamp(0.0, 1.0))
    }
}
