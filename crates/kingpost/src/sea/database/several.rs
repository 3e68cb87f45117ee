//! Hydrodynamic data of several hulls that feel each other through the water: version 2 of the file.
//!
//! Every hull has the data of one hull, in its own axes and in the presence of the others, which are held: its excitation
//! contains the waves that they scatter. In addition, blocks of added mass and of the memory map the motion of each hull to
//! forces on the others.

use super::error::unless;
use super::physical::Coefficients;
use super::{
    Database, DatabaseError, DatabaseWater, DriftLoading, ExcitationTable, HullAtRest, MODES, Matrix, Memory,
    MemoryOfMode, RadiationMode, RadiationModel, SixBySix, check, physical, plausible, unreadable,
};
use serde::Deserialize;
use serde_json::Value;
use std::sync::Arc;

/// The hydrodynamic data of a file: of one hull, or of several with their coupling.
#[derive(Clone, Debug, PartialEq)]
pub struct HydrodynamicData {
    hulls: Vec<Arc<Database>>,
    coupling: Option<Arc<HullCoupling>>,
}

/// The coupling of several hulls.
#[derive(Clone, Debug, PartialEq)]
pub struct HullCoupling {
    /// The hulls, in the order of the blocks.
    pub places: Vec<HullPlace>,
    /// Coupling by the hull on which the force acts and by the hull that moves.
    pub blocks: Vec<Vec<CouplingBlock>>,
}

/// A hull's place among several, in calm water.
#[derive(Clone, Debug, PartialEq)]
pub struct HullPlace {
    /// Name of the hull in the file.
    pub name: String,
    /// Origin in the common frame, m.
    pub position_m: [f64; 2],
    /// Direction of its x axis in the common frame, rad.
    pub heading_rad: f64,
}

/// Force on one hull, in its axes about its origin, by the motion of a hull in that hull's axes about its origin.
#[derive(Clone, Debug, PartialEq)]
pub struct CouplingBlock {
    /// Added mass at infinite frequency.
    pub added_mass_infinite: SixBySix,
    /// The memory, if it is fitted.
    pub radiation: Option<RadiationModel>,
}

/// Fields that the hulls of a file share.
const SHARED: [&str; 3] = ["water", "frequencies_rad_s", "wave_directions_rad"];

#[derive(Deserialize)]
struct FileVersion {
    version: u32,
}

/// A file of version 2.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SeveralHulls {
    format: String,
    version: u32,
    title: String,
    #[serde(default)]
    provenance: Value,
    water: DatabaseWater,
    hulls: Vec<HullRecord>,
    frequencies_rad_s: Vec<f64>,
    wave_directions_rad: Vec<f64>,
    added_mass: Vec<Matrix>,
    radiation_damping: Vec<Matrix>,
    added_mass_infinite: Matrix,
    #[serde(default)]
    radiation: Option<JointMemory>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct HullRecord {
    name: String,
    place: PlaceRecord,
    hull: HullAtRest,
    froude_krylov: ExcitationTable,
    diffraction: ExcitationTable,
    #[serde(default)]
    mean_drift: Option<Vec<Vec<[f64; 3]>>>,
    #[serde(default)]
    mean_drift_loading: Option<DriftLoading>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PlaceRecord {
    x_m: f64,
    y_m: f64,
    heading_rad: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct JointMemory {
    modes: Memory,
    fit_error: f64,
}

impl HydrodynamicData {
    /// Reads and checks a file's text: one hull, or several.
    ///
    /// # Errors
    /// The first error: another format, a truncated file, impossible numbers, or hulls that are not told apart.
    pub fn read(text: &str) -> Result<Self, DatabaseError> {
        match serde_json::from_str(text) {
            Ok(FileVersion { version: 2 }) => Self::read_several(text),
            Err(error) if error.is_syntax() || error.is_eof() => Err(unreadable(&error)),
            _ => Ok(Self { hulls: vec![Arc::new(Database::read(text)?)], coupling: None }),
        }
    }

    fn read_several(text: &str) -> Result<Self, DatabaseError> {
        let file: SeveralHulls = serde_json::from_str(text).map_err(|error| unreadable(&error))?;
        check::check_format(&file.format, file.version, 2)?;
        file.check_shapes()?;
        let hulls: Vec<Database> = (0..file.hulls.len()).map(|hull| file.of(hull)).collect();
        for (record, database) in file.hulls.iter().zip(&hulls) {
            let in_record = |error: DatabaseError| {
                let is_shared = SHARED.iter().any(|field| error.field.starts_with(field));
                let path = if is_shared { error.field } else { format!("hulls.{}.{}", record.name, error.field) };
                DatabaseError { field: path, ..error }
            };
            check::check_hull(database).and_then(|()| plausible::check(database)).map_err(in_record)?;
        }
        file.check_physics(&hulls)?;
        let coupling = file.coupling();
        Ok(Self { hulls: hulls.into_iter().map(Arc::new).collect(), coupling: Some(Arc::new(coupling)) })
    }

    /// Returns a hull by its name, with its place among the hulls; the hull of a file of one has every name.
    pub fn hull(&self, name: &str) -> Option<(usize, &Arc<Database>)> {
        let place = match &self.coupling {
            None => Some(0),
            Some(coupling) => coupling.places.iter().position(|place| place.name == name),
        };
        place.map(|place| (place, &self.hulls[place]))
    }

    /// Returns the coupling of the hulls; `None` for one hull.
    pub fn coupling(&self) -> Option<&Arc<HullCoupling>> {
        self.coupling.as_ref()
    }
}

/// Returns whether a scenario can name it.
fn is_name(name: &str) -> bool {
    let is_part = |letter: char| letter.is_ascii_lowercase() || letter.is_ascii_digit() || letter == '_';
    name.starts_with(|first: char| first.is_ascii_lowercase()) && name.chars().all(is_part)
}

impl SeveralHulls {
    fn check_shapes(&self) -> Result<(), DatabaseError> {
        let (count, size) = (self.hulls.len(), 6 * self.hulls.len());
        unless(count > 1, "hulls", format!("{count} hulls"), "two hulls or more: a file of version 1 is of one hull")?;
        for (k, record) in self.hulls.iter().enumerate() {
            let PlaceRecord { x_m, y_m, heading_rad } = record.place;
            let is_finite = [x_m, y_m, heading_rad].iter().all(|x| x.is_finite());
            unless(is_finite, &format!("hulls.{k}.place"), "a number that is not finite", "finite numbers")?;
            let is_new = self.hulls[..k].iter().all(|other| other.name != record.name);
            let allowed = "a name for each hull, each once, of small letters, digits and _, a letter first";
            unless(is_new && is_name(&record.name), &format!("hulls.{k}.name"), &record.name, allowed)?;
        }
        let fits = |matrix: &Matrix| {
            matrix.len() == size
                && matrix.iter().all(|row| row.len() == size && row.iter().all(|entry| entry.is_finite()))
        };
        let allowed = format!("finite numbers, {size} rows of {size} for {count} hulls, at each frequency");
        for (field, matrices) in [("added_mass", &self.added_mass), ("radiation_damping", &self.radiation_damping)] {
            let fine = matrices.len() == self.frequencies_rad_s.len() && matrices.iter().all(fits);
            unless(fine, field, "another shape", &allowed)?;
        }
        unless(fits(&self.added_mass_infinite), "added_mass_infinite", "another shape", &allowed)?;
        let Some(memory) = &self.radiation else { return Ok(()) };
        let fine = memory.modes.len() == size
            && memory.modes.iter().flat_map(|mode| &mode.residues).all(|residues| residues.len() == size);
        unless(fine, "radiation.modes", "another shape", &format!("{size} modes, each with residues for {size} forces"))
    }

    /// Returns the block of a matrix for a force on one hull by the motion of another.
    fn block(matrix: &Matrix, on: usize, by: usize) -> SixBySix {
        core::array::from_fn(|i| core::array::from_fn(|j| matrix[6 * on + i][6 * by + j]))
    }

    /// Returns the memory of the motions of one hull in the forces on another.
    fn radiation(&self, on: usize, by: usize) -> Option<RadiationModel> {
        let memory = self.radiation.as_ref()?;
        let mode = |mode: usize| {
            let MemoryOfMode { poles_rad_s, residues } = &memory.modes[6 * by + mode];
            let of_hull = |row: &Vec<[f64; 2]>| core::array::from_fn(|i| row[6 * on + i]);
            RadiationMode { poles_rad_s: poles_rad_s.clone(), residues: residues.iter().map(of_hull).collect() }
        };
        Some(RadiationModel { modes: core::array::from_fn(mode), fit_error: memory.fit_error })
    }

    /// Returns the data of one hull among the others.
    fn of(&self, place: usize) -> Database {
        let record = &self.hulls[place];
        let own = |matrices: &[Matrix]| matrices.iter().map(|matrix| Self::block(matrix, place, place)).collect();
        Database {
            format: self.format.clone(),
            version: self.version,
            title: format!("{}: {}", self.title, record.name),
            provenance: self.provenance.clone(),
            water: self.water,
            hull: record.hull.clone(),
            frequencies_rad_s: self.frequencies_rad_s.clone(),
            wave_directions_rad: self.wave_directions_rad.clone(),
            added_mass: own(&self.added_mass),
            radiation_damping: own(&self.radiation_damping),
            added_mass_infinite: Self::block(&self.added_mass_infinite, place, place),
            froude_krylov: record.froude_krylov.clone(),
            diffraction: record.diffraction.clone(),
            mean_drift: record.mean_drift.clone(),
            mean_drift_loading: record.mean_drift_loading,
            radiation: self.radiation(place, place),
            reach_m: self.reach_m(place),
        }
    }

    /// Returns the largest distance from the origin of a hull to the rim of any hull, m.
    fn reach_m(&self, from: usize) -> f64 {
        let here = &self.hulls[from].place;
        let to = |record: &HullRecord| {
            let half = 0.5 * libm::hypot(record.hull.length_m, record.hull.beam_m);
            libm::hypot(record.place.x_m - here.x_m, record.place.y_m - here.y_m) + half
        };
        self.hulls.iter().map(to).fold(0.0, f64::max)
    }

    fn check_physics(&self, hulls: &[Database]) -> Result<(), DatabaseError> {
        let of = |record: &HullRecord| MODES.map(|mode| format!("{} of {}", mode, record.name));
        let modes: Vec<String> = self.hulls.iter().flat_map(of).collect();
        let (added_mass, damping) = (&self.added_mass, &self.radiation_damping);
        let given = Coefficients { added_mass, damping, infinite: &self.added_mass_infinite, modes: &modes };
        physical::check_matrices(&given, &hulls.iter().collect::<Vec<_>>())?;
        let Some(memory) = &self.radiation else { return Ok(()) };
        check::check_memory(&memory.modes, &self.frequencies_rad_s, &modes)
    }

    fn coupling(&self) -> HullCoupling {
        let place = |record: &HullRecord| HullPlace {
            name: record.name.clone(),
            position_m: [record.place.x_m, record.place.y_m],
            heading_rad: record.place.heading_rad,
        };
        let block = |on: usize, by: usize| CouplingBlock {
            added_mass_infinite: Self::block(&self.added_mass_infinite, on, by),
            radiation: self.radiation(on, by),
        };
        let count = self.hulls.len();
        let row = |on: usize| (0..count).map(|by| block(on, by)).collect();
        HullCoupling { places: self.hulls.iter().map(place).collect(), blocks: (0..count).map(row).collect() }
    }
}
