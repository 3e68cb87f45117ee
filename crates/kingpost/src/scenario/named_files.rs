//! The contents of the files that a scenario names.

use crate::sea::database::Database;
use crate::sea::raos::RaoTable;
use crate::sea::waves::ElevationTable;
use indexmap::IndexMap;
use std::sync::Arc;

/// The contents of the files that a scenario names, by their names.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NamedFiles {
    pub(super) databases: IndexMap<String, Arc<Database>>,
    pub(super) records: IndexMap<String, Arc<ElevationTable>>,
    pub(super) raos: IndexMap<String, Arc<RaoTable>>,
    pub(super) texts: IndexMap<String, Arc<str>>,
    /// Digest of the text of each file.
    pub(super) digests: IndexMap<String, u64>,
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

    /// The text of a file that its kind reads.
    pub fn text(&self, name: &str) -> Option<&Arc<str>> {
        self.texts.get(name)
    }

    /// The displacement RAOs of a file.
    pub fn raos(&self, name: &str) -> Option<&Arc<RaoTable>> {
        self.raos.get(name)
    }
}
