//! Files that a scenario names: their texts come from the host, for the engine reads no disk.

use super::error::FieldError;
use super::schema::{Force, Hydrodynamics, Joint, Scenario, Waves};
use crate::sea::database::Database;
use crate::sea::raos::RaoTable;
use crate::sea::waves::ElevationTable;
use crate::state::digest;
use indexmap::IndexMap;
use std::borrow::Cow;
use std::fmt;
use std::sync::{Arc, Mutex, PoisonError};

/// Who has the texts of files: the engine reads no disk.
///
/// A name that begins with `gallery:` is of a file below the gallery's folder (`gallery:parts/pedestal_crane.yaml`), any
/// other is a path from the folder of the scenario's own file.
///
/// ```
/// use kingpost::scenario::{Files, Host, read_with};
/// use std::borrow::Cow;
/// #[derive(Debug)]
/// struct Shelf;
/// impl Host for Shelf {
///     fn text(&self, name: &str) -> Option<Cow<'_, str>> {
///         let crate_ = "{version: 1, title: A crate, bodies: {crate: {mass_kg: 5, shape: {sphere: {radius_m: 1}}, \
///             joint: {fixed: {}}}}}";
///         (name == "gallery:parts/crate.yaml").then_some(Cow::Borrowed(crate_))
///     }
/// }
/// let text = "{version: 1, title: A crate on a cart, parts: {cargo: {part: crate, on: cart, position_m: [0, 0, 2]}}, \
///     bodies: {cart: {mass_kg: 9, shape: {sphere: {radius_m: 1}}, joint: {prismatic: {axis: [1, 0, 0]}}}}}";
/// let scenario = read_with(text, "cart.yaml", &[], &Files::of(Shelf))?;
/// assert_eq!(scenario.bodies["cargo_crate"].parent, "cart");
/// # Ok::<(), kingpost::scenario::ScenarioError>(())
/// ```
pub trait Host: fmt::Debug + Send + Sync {
    /// The text of a file, where there is one.
    fn text(&self, name: &str) -> Option<Cow<'_, str>>;
}

/// Texts by their names.
impl Host for IndexMap<String, String> {
    fn text(&self, name: &str) -> Option<Cow<'_, str>> {
        self.get(name).map(|text| Cow::Borrowed(text.as_str()))
    }
}

/// The files of a host. A hydrodynamic database is read once.
#[derive(Debug)]
pub struct Files {
    host: Box<dyn Host>,
    digests: Mutex<IndexMap<String, u64>>,
    databases: Mutex<IndexMap<String, Arc<Database>>>,
}

impl Default for Files {
    fn default() -> Self {
        Self::new([])
    }
}

impl Files {
    /// These files.
    pub fn new(texts: impl IntoIterator<Item = (String, String)>) -> Self {
        Self::of(texts.into_iter().collect::<IndexMap<_, _>>())
    }

    /// Those that a host has.
    pub fn of(host: impl Host + 'static) -> Self {
        Self { host: Box::new(host), digests: Mutex::default(), databases: Mutex::default() }
    }

    /// The text of a file of this name.
    pub(super) fn text_of(&self, name: &str) -> Option<Cow<'_, str>> {
        self.host.text(name)
    }

    /// The text of a file, which is one of these, that `field` names.
    fn text(&self, field: &str, name: &str, what: &str) -> Result<Cow<'_, str>, FieldError> {
        let text = self.host.text(name);
        text.ok_or_else(|| FieldError::new(field, format!("no file {name}"), format!("{what} that is there")))
    }

    /// A number that two texts share only if they are the same.
    fn digest(&self, name: &str) -> u64 {
        let mut known = self.digests.lock().unwrap_or_else(PoisonError::into_inner);
        let of_text = || self.text_of(name).map_or(0, |text| digest(text.as_bytes()));
        *known.entry(name.to_owned()).or_insert_with(of_text)
    }

    fn database(&self, field: &str, name: &str) -> Result<Arc<Database>, FieldError> {
        let mut known = self.databases.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(database) = known.get(name) {
            return Ok(Arc::clone(database));
        }
        let text = self.text(field, name, "a hydrodynamic database")?;
        let database = Database::read(&text).map_err(|error| {
            FieldError::new(field, format!("{name}: {}: {}", error.field, error.found), error.allowed)
        })?;
        let database = Arc::new(database);
        known.insert(name.to_owned(), Arc::clone(&database));
        Ok(database)
    }

    fn record(&self, field: &str, name: &str) -> Result<Arc<ElevationTable>, FieldError> {
        let table = ElevationTable::read_csv(&self.text(field, name, "a record of the elevation")?);
        let table = table.map_err(|error| {
            FieldError::new(field, format!("{name}: {}: {}", error.field, error.found), error.allowed)
        });
        Ok(Arc::new(table?))
    }

    fn raos(&self, field: &str, name: &str) -> Result<Arc<RaoTable>, FieldError> {
        let table = RaoTable::read(&self.text(field, name, "a file of RAOs")?);
        let table = table.map_err(|error| {
            FieldError::new(field, format!("{name}: {}: {}", error.field, error.found), error.allowed)
        });
        Ok(Arc::new(table?))
    }
}

/// What is in the files that a scenario names, by their names.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NamedFiles {
    databases: IndexMap<String, Arc<Database>>,
    records: IndexMap<String, Arc<ElevationTable>>,
    raos: IndexMap<String, Arc<RaoTable>>,
    /// Of the text of each.
    digests: IndexMap<String, u64>,
}

impl NamedFiles {
    /// The hydrodynamic database of a file.
    pub fn database(&self, name: &str) -> Option<&Arc<Database>> {
        self.databases.get(name)
    }

    /// The record of the sea's elevation of a file.
    pub fn record(&self, name: &str) -> Option<&Arc<ElevationTable>> {
        self.records.get(name)
    }

    /// The displacement RAOs of a file.
    pub fn raos(&self, name: &str) -> Option<&Arc<RaoTable>> {
        self.raos.get(name)
    }
}

/// What a file is to the scenario that names it.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Database,
    Record,
    Raos,
}

impl Scenario {
    /// The water on the hull of a force of this name.
    pub(crate) fn hydrodynamics(&self, force: &str) -> Option<&Hydrodynamics> {
        let (_, force) = self.forces.iter().find(|(name, _)| name.as_str() == force)?;
        if let Force::Hydrodynamics(given) = force { Some(given) } else { None }
    }

    /// The database of that hull.
    pub(crate) fn database_of(&self, force: &str) -> Option<&Database> {
        self.files.database(&self.hydrodynamics(force)?.database).map(|database| &**database)
    }

    /// Names of the files that it stands on, in its order, each once.
    pub fn file_names(&self) -> Vec<&str> {
        let mut names = Vec::new();
        for (_, name, _) in self.file_fields() {
            if !names.contains(&name) {
                names.push(name);
            }
        }
        names
    }

    /// A number that two scenarios share only if they and their files describe the same run; title, description and
    /// parameters are no part of it.
    pub(super) fn fingerprint(&self) -> u64 {
        let Self { simulation, bodies, loops, sea, wind, forces, drives, sensors, wires, operation, files, .. } = self;
        let run = (simulation, bodies, loops, sea, wind, forces, drives, sensors, wires, operation, &files.digests);
        serde_json::to_vec(&run).map_or(0, |text| digest(&text))
    }

    /// Takes over the files that it names.
    pub(super) fn take_files(&mut self, files: &Files) -> Result<(), FieldError> {
        let mut taken = NamedFiles::default();
        for (field, name, kind) in self.file_fields() {
            match kind {
                Kind::Database => drop(taken.databases.insert(name.to_owned(), files.database(&field, name)?)),
                Kind::Record => drop(taken.records.insert(name.to_owned(), files.record(&field, name)?)),
                Kind::Raos => drop(taken.raos.insert(name.to_owned(), files.raos(&field, name)?)),
            }
            taken.digests.insert(name.to_owned(), files.digest(name));
        }
        self.files = taken;
        Ok(())
    }

    /// Fields that name files, of what is enabled, and the names.
    fn file_fields(&self) -> Vec<(String, &str, Kind)> {
        let mut fields = Vec::new();
        for (name, waves) in self.sea.iter().flat_map(|sea| &sea.waves) {
            if let Waves::Record(record) = waves
                && record.enabled
            {
                fields.push((format!("sea.waves.{name}.record.file"), record.file.as_str(), Kind::Record));
            }
        }
        for (name, body) in &self.bodies {
            if let Joint::MovedByWaves(joint) = &body.joint
                && body.enabled
            {
                let field = format!("bodies.{name}.joint.moved_by_waves.raos");
                fields.push((field, joint.raos.as_str(), Kind::Raos));
            }
        }
        for (name, force) in &self.forces {
            if let Force::Hydrodynamics(water) = force
                && water.enabled
            {
                let field = format!("forces.{name}.hydrodynamics.database");
                fields.push((field, water.database.as_str(), Kind::Database));
            }
        }
        fields
    }
}
