//! The contents of the files that a scenario names.

use crate::sea::database::{Database, HydrodynamicData};
use crate::sea::raos::RaoTable;
use crate::sea::waves::ElevationTable;
use indexmap::IndexMap;
use std::sync::Arc;

/// The contents of the files that a scenario names, by their names.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NamedFiles {
    pub(super) databases: IndexMap<String, Arc<HydrodynamicData>>,
    pub(super) records: IndexMap<String, Arc<ElevationTable>>,
    pub(super) raos: IndexMap<String, Arc<RaoTable>>,
    pub(super) texts: IndexMap<String, Arc<str>>,
    /// Digest of the text of each file.
    pub(super) digests: IndexMap<String, u64>,
}

impl NamedFiles {
    /// Returns the hydrodynamic data in a file, of one hull or of several.
    pub fn hydrodynamic_data(&self, name: &str) -> Option<&Arc<HydrodynamicData>> {
        self.databases.get(name)
    }

    /// Returns the database of a hull; `None` if its file has no hull of this name.
    pub fn database(&self, file: &str, hull: &str) -> Option<&Arc<Database>> {
        Some(self.databases.get(file)?.hull(hull)?.1)
    }

    /// Returns the record of the sea's elevation in a file.
    pub fn record(&self, name: &str) -> Option<&Arc<ElevationTable>> {
        self.records.get(name)
    }

    /// Returns the text of a file whose format the kind of its entry defines.
    pub fn text(&self, name: &str) -> Option<&Arc<str>> {
        self.texts.get(name)
    }

    /// Returns the displacement RAOs in a file.
    pub fn raos(&self, name: &str) -> Option<&Arc<RaoTable>> {
        self.raos.get(name)
    }
}
