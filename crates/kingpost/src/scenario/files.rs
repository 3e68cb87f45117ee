//! Files that a scenario names: their texts come from the host, for the engine reads no disk.

use super::error::FieldError;
use super::schema::{Force, Scenario};
use crate::sea::database::Database;
use indexmap::IndexMap;
use std::sync::{Arc, Mutex, PoisonError};

/// Texts of files by the names that scenarios give them. A hydrodynamic database is read once.
#[derive(Debug, Default)]
pub struct Files {
    texts: IndexMap<String, String>,
    databases: Mutex<IndexMap<String, Arc<Database>>>,
}

impl Files {
    /// These files.
    pub fn new(texts: impl IntoIterator<Item = (String, String)>) -> Self {
        Self { texts: texts.into_iter().collect(), databases: Mutex::default() }
    }

    /// The database of a file that `field` names.
    fn database(&self, field: &str, name: &str) -> Result<Arc<Database>, FieldError> {
        let mut known = self.databases.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(database) = known.get(name) {
            return Ok(Arc::clone(database));
        }
        let Some(text) = self.texts.get(name) else {
            return Err(FieldError::new(field, format!("no file {name}"), "a hydrodynamic database that is there"));
        };
        let database = Database::read(text).map_err(|error| {
            FieldError::new(field, format!("{name}: {}: {}", error.field, error.found), error.allowed)
        })?;
        let database = Arc::new(database);
        known.insert(name.to_owned(), Arc::clone(&database));
        Ok(database)
    }
}

/// The hydrodynamic databases that a scenario names, by file name.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Databases(IndexMap<String, Arc<Database>>);

impl Databases {
    /// The database of a file.
    pub fn get(&self, name: &str) -> Option<&Arc<Database>> {
        self.0.get(name)
    }
}

impl Scenario {
    /// Names of the files that it stands on, in the order of the forces, each once.
    pub fn file_names(&self) -> Vec<&str> {
        let mut names = Vec::new();
        for (_, name) in self.database_fields() {
            if !names.contains(&name) {
                names.push(name);
            }
        }
        names
    }

    /// Takes over the files that it names.
    pub(super) fn take_files(&mut self, files: &Files) -> Result<(), FieldError> {
        let named = self.database_fields().into_iter();
        let read = named.map(|(field, name)| Ok((name.to_owned(), files.database(&field, name)?)));
        self.databases = Databases(read.collect::<Result<_, _>>()?);
        Ok(())
    }

    /// Fields that name databases, of forces that act, and the names.
    fn database_fields(&self) -> Vec<(String, &str)> {
        let mut fields = Vec::new();
        for (name, force) in &self.forces {
            if let Force::Hydrodynamics(water) = force
                && water.enabled
            {
                fields.push((format!("forces.{name}.hydrodynamics.database"), water.database.as_str()));
            }
        }
        fields
    }
}
