//! The watchers of a run.

use crate::elements::{AnyWatcher, Warning};
use crate::results::Channels;
use crate::scalar::Scalar;

/// Watchers, each with the indices of its columns in a row.
#[derive(Clone, Debug, Default)]
pub(super) struct Watching {
    watched: Vec<(Vec<usize>, AnyWatcher)>,
    /// Copies of the watchers before the first row.
    fresh: Vec<(Vec<usize>, AnyWatcher)>,
    values: Vec<f64>,
}

impl Watching {
    /// Creates the set of watchers whose columns all exist.
    pub(super) fn new(watchers: Vec<AnyWatcher>, channels: &Channels) -> Self {
        let placed = |watcher: AnyWatcher| {
            let places: Option<Vec<usize>> = watcher.columns().iter().map(|column| channels.place(column)).collect();
            Some((places?, watcher))
        };
        let watched: Vec<_> = watchers.into_iter().filter_map(placed).collect();
        Self { fresh: watched.clone(), watched, values: Vec::new() }
    }

    /// Passes a row to the watchers.
    pub(super) fn see<S: Scalar>(&mut self, row: &[S]) {
        let Self { watched, values, .. } = self;
        for (places, watcher) in watched {
            values.clear();
            values.extend(places.iter().map(|&place| row[place].value()));
            watcher.see(row[0].value(), values);
        }
    }

    /// Resets the watchers to before the first row.
    pub(super) fn begin_anew(&mut self) {
        self.watched.clone_from(&self.fresh);
    }

    /// Returns the warnings so far.
    pub(super) fn warnings(&self) -> impl Iterator<Item = Warning> {
        self.watched.iter().flat_map(|(_, watcher)| watcher.warnings())
    }
}
