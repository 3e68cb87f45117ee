//! Files that a scenario names: the host provides their texts, because the engine reads no files.

use super::error::FieldError;
use super::named_files::NamedFiles;
use super::reading::{FileKind, FromNode, TextKind};
use super::schema::{Force, Hydrodynamics, Scenario};
use super::writing::ToValue;
use crate::sea::database::{Database, HydrodynamicData};
use crate::sea::raos::RaoTable;
use crate::sea::waves::ElevationTable;
use crate::state::digest;
use indexmap::{IndexMap, IndexSet};
use serde_json::Value;
use std::borrow::Cow;
use std::fmt;
use std::sync::{Arc, Mutex, PoisonError};

/// The source of the texts of files: the engine itself reads no files.
///
/// A name that begins with `gallery:` is a file below the gallery's folder (`gallery:parts/pedestal_crane.yaml`), any
/// other name is a path from the folder of the scenario's own file.
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
    /// Returns the text of a file, if it exists.
    fn text(&self, name: &str) -> Option<Cow<'_, str>>;
}

/// Texts by their names.
impl Host for IndexMap<String, String> {
    fn text(&self, name: &str) -> Option<Cow<'_, str>> {
        self.get(name).map(|text| Cow::Borrowed(text.as_str()))
    }
}

/// The files of a host. Each hydrodynamic database is read only once.
#[derive(Debug)]
pub struct Files {
    host: Box<dyn Host>,
    digests: Mutex<IndexMap<String, u64>>,
    databases: Mutex<IndexMap<String, Arc<HydrodynamicData>>>,
}

impl Default for Files {
    fn default() -> Self {
        Self::new([])
    }
}

impl Files {
    /// Creates files from their texts.
    pub fn new(texts: impl IntoIterator<Item = (String, String)>) -> Self {
        Self::of(texts.into_iter().collect::<IndexMap<_, _>>())
    }

    /// Creates files from a host.
    pub fn of(host: impl Host + 'static) -> Self {
        Self { host: Box::new(host), digests: Mutex::default(), databases: Mutex::default() }
    }

    /// Returns the text of the file with this name.
    pub(super) fn text_of(&self, name: &str) -> Option<Cow<'_, str>> {
        self.host.text(name)
    }

    /// Returns the text of the file that `field` names; `what` describes the expected content.
    fn text(&self, field: &str, name: &str, what: &str) -> Result<Cow<'_, str>, FieldError> {
        let text = self.host.text(name);
        text.ok_or_else(|| FieldError::new(field, format!("no file {name}"), format!("{what} that exists")))
    }

    /// Returns a digest of the text: equal only for equal texts.
    fn digest(&self, name: &str) -> u64 {
        let mut known = self.digests.lock().unwrap_or_else(PoisonError::into_inner);
        let of_text = || self.text_of(name).map_or(0, |text| digest(text.as_bytes()));
        *known.entry(name.to_owned()).or_insert_with(of_text)
    }

    fn database(&self, field: &str, name: &str) -> Result<Arc<HydrodynamicData>, FieldError> {
        let mut known = self.databases.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(database) = known.get(name) {
            return Ok(Arc::clone(database));
        }
        let text = self.text(field, name, "a hydrodynamic database")?;
        let database = HydrodynamicData::read(&text).map_err(|error| {
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

impl Scenario {
    /// Returns the hydrodynamic data of the force with this name.
    pub(crate) fn hydrodynamics(&self, force: &str) -> Option<&Hydrodynamics> {
        let (_, force) = self.forces.iter().find(|(name, _)| name.as_str() == force)?;
        if let Force::Hydrodynamics(given) = force { Some(given) } else { None }
    }

    /// Returns the database of the force with this name.
    pub(crate) fn database_of(&self, force: &str) -> Option<&Database> {
        let given = self.hydrodynamics(force)?;
        self.files.database(&given.database, given.name_in_database()).map(|database| &**database)
    }

    /// Returns the names of the files that the scenario uses, in order, each once.
    pub fn file_names(&self) -> Vec<String> {
        let names: IndexSet<String> = self.file_fields().into_iter().map(|(_, name, _)| name).collect();
        names.into_iter().collect()
    }

    /// Returns a digest that is equal only for scenarios that, with their files, describe the same run;
    /// title, description and parameters do not count.
    pub(super) fn fingerprint(&self) -> u64 {
        let Self {
            simulation,
            bodies,
            loops,
            sea,
            wind,
            forces,
            drives,
            sensors,
            controllers,
            wires,
            operation,
            task,
            files,
            ..
        } = self;
        let run = (
            simulation,
            bodies,
            loops,
            sea,
            wind,
            forces,
            drives,
            sensors,
            controllers,
            wires,
            (operation, task),
            &files.digests,
        );
        serde_json::to_vec(&run).map_or(0, |text| digest(&text))
    }

    /// Loads the files that the scenario names.
    pub(super) fn take_files(&mut self, files: &Files) -> Result<(), FieldError> {
        let mut taken = NamedFiles::default();
        for (field, name, kind) in self.file_fields() {
            match kind {
                FileKind::Database => drop(taken.databases.insert(name.clone(), files.database(&field, &name)?)),
                FileKind::ElevationRecord => drop(taken.records.insert(name.clone(), files.record(&field, &name)?)),
                FileKind::Raos => drop(taken.raos.insert(name.clone(), files.raos(&field, &name)?)),
                FileKind::Text => drop(taken.texts.insert(name.clone(), files.text(&field, &name, "a file")?.into())),
            }
            taken.digests.insert(name.clone(), files.digest(&name));
        }
        self.files = taken;
        Ok(())
    }

    /// Returns the fields of enabled entries that name files, the names, and the kinds of content.
    fn file_fields(&self) -> Vec<(String, String, FileKind)> {
        let mut found = Vec::new();
        walk(&self.to_value(), &mut Vec::new(), &mut found);
        found
    }
}

fn walk(value: &Value, path: &mut Vec<String>, found: &mut Vec<(String, String, FileKind)>) {
    let mut inside = |segment: String, value: &Value| {
        path.push(segment);
        walk(value, path, found);
        path.pop();
    };
    match value {
        Value::Object(fields) if fields.get("enabled") == Some(&Value::Bool(false)) => {}
        Value::Object(fields) => fields.iter().for_each(|(name, field)| inside(name.clone(), field)),
        Value::Array(entries) => entries.iter().enumerate().for_each(|(k, entry)| inside(k.to_string(), entry)),
        Value::String(text) => {
            let segments: Vec<&str> = path.iter().map(String::as_str).collect();
            if let Some(TextKind::File(kind)) = Scenario::text_at(&segments) {
                found.push((path.join("."), text.clone(), kind));
            }
        }
        _ => {}
    }
}
