//! Batches of runs: variants of one scenario, computed in lanes and on threads.
//!
//! Variants with the same structure are computed in the [lanes](crate::scalar::Lanes) of SIMD registers, and
//! groups of them on threads. The result of every run is bitwise identical to that of the run alone, for
//! any other lanes and any number of threads.

mod copies;
mod members;
mod side_by_side;

pub use copies::{Asked, CopyError, Status, VectorEnsemble};
pub use members::Members;

use crate::elements::Layout;
use crate::plant::Form;
use crate::results::{Channel, Channels};
use crate::scalar::{LANES, Lanes};
use crate::scenario::{Files, ScenarioError};
use crate::simulation::{Run, SchemeName, Setup, Simulation};
use core::sync::atomic::{AtomicUsize, Ordering};
use indexmap::IndexMap;
use rayon::prelude::*;
use serde_json::Value;
use thiserror::Error;

/// Values that a run changes in the scenario: names of parameters or paths of fields, in order.
pub type Variant = Vec<(String, Value)>;

/// Reason why a batch did not run.
#[derive(Clone, Debug, Error)]
pub enum BatchError {
    /// A variant is not a valid scenario.
    #[error("run {run}: {error}")]
    Variant {
        /// Index of the run, from 0.
        run: usize,
        /// Error of the scenario.
        error: ScenarioError,
    },
    /// A variant has other bodies, joints or points than the first one: their rows have other columns.
    #[error("run {run}: found other result channels than those of run 0, allowed: the same bodies, joints and points")]
    Channels {
        /// Index of the run, from 0.
        run: usize,
    },
    /// The runs would record more values than allowed.
    #[error(
        "{runs} runs: found {:.1} GB of rows and models, allowed: {:.1} GB; record less often \
         (simulation.record_every_s), or fewer runs at once",
        *found as f64 / 1e9, *allowed as f64 / 1e9
    )]
    Memory {
        /// Number of runs.
        runs: usize,
        /// Bytes of all rows and models; before all models are built, bytes of the models alone, or an
        /// estimate from the first ones.
        found: u64,
        /// Allowed number of bytes.
        allowed: u64,
    },
    /// The threads could not be started.
    #[error("{0} threads could not be started")]
    Threads(usize),
    /// `progress` stopped the batch.
    #[error("stopped")]
    Stopped,
}

/// Runs of a batch, in the order of their variants.
#[derive(Clone, Debug)]
pub struct Batch {
    /// The channels of a row, the same in every run.
    pub channels: Vec<Channel>,
    /// The runs; a run that diverged has its error and the rows before it.
    pub runs: Vec<Run>,
}

/// Largest memory for the runs of a batch, bytes.
pub const MOST_BYTES: u64 = 4 << 30;
/// Memory of a model, bytes: the models of the gallery, whose meshes are shared, take 61 to 74 kB (measured).
const MODEL_BYTES: f64 = 65536.0;

/// Runs every variant of a scenario from start to end. If `threads` is 0, it uses all threads of the machine.
/// `progress` is called with the number of finished runs and stops the batch by returning false.
///
/// ```
/// use kingpost::scenario::Files;
/// let text = include_str!("../../../../scenarios/paper.yaml");
/// let variant = |x: f64| vec![("crane_x_m".to_owned(), x.into()), ("simulation.duration_s".to_owned(), 0.1.into())];
/// let batch = kingpost::batch::run(text, "paper.yaml", &Files::default(), &[variant(0.0), variant(-5.0)], 2, |_| true)?;
/// assert!(batch.runs.iter().all(|run| run.status.is_ok()));
/// # Ok::<(), kingpost::batch::BatchError>(())
/// ```
///
/// # Errors
/// A variant that does not read or build, or whose channels are not those of the first; more than [`MOST_BYTES`] of rows.
pub fn run(
    text: &str,
    file: &str,
    files: &Files,
    variants: &[Variant],
    threads: usize,
    progress: impl Fn(usize) -> bool + Sync,
) -> Result<Batch, BatchError> {
    run_within(text, file, files, variants, threads, MOST_BYTES, progress)
}

/// Computes all runs like [`run`], with `most_bytes` as the limit of memory.
///
/// # Errors
/// Those of [`run`].
pub fn run_within(
    text: &str,
    file: &str,
    files: &Files,
    variants: &[Variant],
    threads: usize,
    most_bytes: u64,
    progress: impl Fn(usize) -> bool + Sync,
) -> Result<Batch, BatchError> {
    let pool = pool(threads)?;
    pool.install(|| {
        let members = Members::within(text, file, files, variants, most_bytes)?;
        run_all(&members, most_bytes, &progress)
    })
}

/// Built runs, whatever their source; see [`run_built`].
pub trait Built: Sync {
    /// Returns the number of runs.
    fn count(&self) -> usize;

    /// Returns the setup of a run.
    fn setup(&self, run: usize) -> &Setup;

    /// Returns a text that is equal for runs that can share lanes.
    fn structure(&self, run: usize) -> &str;

    /// Returns a separate simulation of a run, at its start.
    fn simulation(&self, run: usize) -> Simulation {
        Simulation::new(self.setup(run).clone())
    }

    /// Returns one setup of a group's runs in lanes, at most as many runs as there are lanes; `None` if they
    /// cannot be run together.
    fn side_by_side(&self, group: &[usize]) -> Option<Setup<Lanes>>;
}

/// Computes built runs like [`run`].
///
/// # Errors
/// A run with other channels than the first one.
pub fn run_built(
    built: &impl Built,
    threads: usize,
    progress: impl Fn(usize) -> bool + Sync,
) -> Result<Batch, BatchError> {
    pool(threads)?.install(|| run_all(built, MOST_BYTES, &progress))
}

fn pool(threads: usize) -> Result<rayon::ThreadPool, BatchError> {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().map_err(|_| BatchError::Threads(threads))
}

fn run_all(
    built: &impl Built,
    most_bytes: u64,
    progress: &(impl Fn(usize) -> bool + Sync),
) -> Result<Batch, BatchError> {
    let channels = common_channels(built)?;
    check_memory(built, &channels, most_bytes)?;
    let done = AtomicUsize::new(0);
    let run_group = |group: &[usize]| {
        let runs = run_group(group, built, &|| progress(done.load(Ordering::Relaxed)));
        done.fetch_add(group.len(), Ordering::Relaxed);
        (runs.is_some() && progress(done.load(Ordering::Relaxed))).then_some(runs).flatten().ok_or(BatchError::Stopped)
    };
    let groups = groups(built);
    let by_group: Vec<Vec<Run>> = groups.par_iter().map(|group| run_group(group)).collect::<Result<_, _>>()?;
    let mut runs: Vec<(usize, Run)> = groups.into_iter().flatten().zip(by_group.into_iter().flatten()).collect();
    runs.sort_by_key(|(run, _)| *run);
    Ok(Batch { channels, runs: runs.into_iter().map(|(_, run)| run).collect() })
}

/// Checks, before any model is built, that the models of all runs fit in memory.
///
/// # Errors
/// [`BatchError::Memory`].
pub fn check_count(runs: usize, most_bytes: u64) -> Result<(), BatchError> {
    let found = runs as f64 * MODEL_BYTES;
    if found > most_bytes as f64 {
        return Err(BatchError::Memory { runs, found: found as u64, allowed: most_bytes });
    }
    Ok(())
}

/// Returns an error if the rows of all runs do not fit in memory.
fn check_memory(built: &impl Built, channels: &[Channel], allowed: u64) -> Result<(), BatchError> {
    let columns: usize = channels.iter().map(|channel| channel.columns.len()).sum();
    let found = (0..built.count()).map(|run| bytes(built.setup(run), columns)).sum::<f64>();
    if found > allowed as f64 {
        return Err(BatchError::Memory { runs: built.count(), found: found as u64, allowed });
    }
    Ok(())
}

/// Returns the memory of a run, with its rows and its model, bytes.
fn bytes(setup: &Setup, columns: usize) -> f64 {
    setup.settings.rows() * (columns * size_of::<f64>()) as f64 + MODEL_BYTES
}

fn channels_of(Setup { model, elements, .. }: &Setup) -> Vec<Channel> {
    Channels::new(model, &Layout::new(elements, 0)).list
}

/// Returns the channels that all runs have in common.
fn common_channels(built: &impl Built) -> Result<Vec<Channel>, BatchError> {
    let of = |run: usize| channels_of(built.setup(run));
    if built.count() == 0 {
        return Ok(Vec::new());
    }
    let first = of(0);
    let other = (0..built.count()).into_par_iter().position_first(|run| of(run) != first);
    other.map_or(Ok(first), |run| Err(BatchError::Channels { run }))
}

/// Returns groups of runs with the same structure, at most as many runs in a group as there are lanes.
fn groups(built: &impl Built) -> Vec<Vec<usize>> {
    let mut by_structure: IndexMap<&str, Vec<usize>> = IndexMap::new();
    for run in 0..built.count() {
        by_structure.entry(built.structure(run)).or_default().push(run);
    }
    let mut groups: Vec<Vec<usize>> = by_structure
        .into_values()
        .flat_map(|runs| runs.chunks(LANES).map(<[usize]>::to_vec).collect::<Vec<_>>())
        .collect();
    groups.sort();
    groups
}

/// Computes the runs of a group; `None` if `go_on` returned false.
fn run_group(group: &[usize], built: &impl Built, go_on: &dyn Fn() -> bool) -> Option<Vec<Run>> {
    let alone: Vec<Simulation> = group.iter().map(|&run| built.simulation(run)).collect();
    if group.len() > 1
        && fits_lanes(built.setup(group[0]))
        && let Some(setup) = built.side_by_side(group)
    {
        return side_by_side::run(setup, alone, go_on);
    }
    let finish = |mut simulation: Simulation| {
        let mut stopped = false;
        let run = simulation.run(|_| {
            stopped = !go_on();
            !stopped
        });
        (!stopped).then_some(run)
    };
    alone.into_iter().map(finish).collect()
}

/// Returns whether runs with this setup can share lanes.
fn fits_lanes(setup: &Setup) -> bool {
    let Setup { settings, model, elements, .. } = setup;
    // The projection onto closed loops needs a different number of iterations in each lane.
    let alone_only = elements.iter().any(|element| element.declare().goes_alone);
    !alone_only && model.loops.is_empty() && settings.form == Form::Recursive && steps_lanes(settings.scheme)
}

/// Returns whether a scheme takes the same steps in every run: an explicit scheme with a fixed step.
fn steps_lanes(scheme: SchemeName) -> bool {
    use SchemeName::{ForwardEuler, MidpointEuler, RungeKutta4, SemiImplicitEuler};
    matches!(scheme, ForwardEuler | MidpointEuler | SemiImplicitEuler | RungeKutta4)
}
