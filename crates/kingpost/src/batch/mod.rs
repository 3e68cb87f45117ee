//! Many runs at once: variants of one scenario over lanes and threads.
//!
//! Variants with the same structure run in the [lanes](crate::scalar::Lanes) of SIMD registers, groups of them on
//! threads. Every run gives the same bits as it would alone, whatever the other lanes and the number of threads.

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

/// The values that one run changes in the scenario: names of parameters or paths of fields, in order.
pub type Variant = Vec<(String, Value)>;

/// Why a batch did not run at all.
#[derive(Clone, Debug, Error)]
pub enum BatchError {
    /// A variant that is not a valid scenario.
    #[error("run {run}: {error}")]
    Variant {
        /// Index of the run, from 0.
        run: usize,
        /// Its error.
        error: ScenarioError,
    },
    /// Variants with other bodies, joints or points than the first: their rows would not match.
    #[error("run {run}: found other result channels than those of run 0, allowed: the same bodies, joints and points")]
    Channels {
        /// Index of the run, from 0.
        run: usize,
    },
    /// More numbers would be recorded than are allowed.
    #[error(
        "{runs} runs: found {:.1} GB of rows and models, allowed: {:.1} GB; record less often \
         (simulation.record_every_s), or fewer runs at once",
        *found as f64 / 1e9, *allowed as f64 / 1e9
    )]
    Memory {
        /// How many runs there are.
        runs: usize,
        /// Bytes of all rows and models; before all are built, those of the models alone, or an estimate by the first ones.
        found: u64,
        /// Bytes that are allowed.
        allowed: u64,
    },
    /// The threads could not be started.
    #[error("{0} threads could not be started")]
    Threads(usize),
    /// `progress` said so.
    #[error("stopped")]
    Stopped,
}

/// Runs of one batch, in the order of their variants.
#[derive(Clone, Debug)]
pub struct Batch {
    /// The channels of a row, the same in every run.
    pub channels: Vec<Channel>,
    /// The runs; one that diverged has its error, and the rows before it.
    pub runs: Vec<Run>,
}

/// Memory that the runs of a batch may take, bytes.
pub const MOST_BYTES: u64 = 4 << 30;
/// Memory of a model, bytes: 61 to 74 kB were measured of the gallery's, whose meshes are shared.
const MODEL_BYTES: f64 = 65536.0;

/// Runs every variant of a scenario from start to end. `threads` 0 takes as many as the machine has. `progress` gets
/// the number of finished runs; it may stop the batch by returning false.
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

/// Computes all runs like [`run`], with this limit for the rows of all, bytes.
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
    /// Number of runs.
    fn count(&self) -> usize;

    /// The setup of a run.
    fn setup(&self, run: usize) -> &Setup;

    /// A text that is equal for runs that can share lanes.
    fn structure(&self, run: usize) -> &str;

    /// A run by itself, at its start.
    fn simulation(&self, run: usize) -> Simulation {
        Simulation::new(self.setup(run).clone())
    }

    /// The runs of a group in lanes, at most as many as there are lanes; `None` if they cannot run together.
    fn side_by_side(&self, group: &[usize]) -> Option<Setup<Lanes>>;
}

/// Computes built runs like [`run`].
///
/// # Errors
/// A run whose channels are not those of the first.
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

/// Checks that the models of so many runs fit, before any is built.
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

/// An error if the rows of all runs would not fit.
fn check_memory(built: &impl Built, channels: &[Channel], allowed: u64) -> Result<(), BatchError> {
    let columns: usize = channels.iter().map(|channel| channel.columns.len()).sum();
    let found = (0..built.count()).map(|run| bytes(built.setup(run), columns)).sum::<f64>();
    if found > allowed as f64 {
        return Err(BatchError::Memory { runs: built.count(), found: found as u64, allowed });
    }
    Ok(())
}

/// Memory that a run takes: its rows and its model, bytes.
fn bytes(setup: &Setup, columns: usize) -> f64 {
    setup.settings.rows() * (columns * size_of::<f64>()) as f64 + MODEL_BYTES
}

fn channels_of(Setup { model, elements, .. }: &Setup) -> Vec<Channel> {
    Channels::new(model, &Layout::new(elements, 0)).list
}

/// The channels that all runs have.
fn common_channels(built: &impl Built) -> Result<Vec<Channel>, BatchError> {
    let of = |run: usize| channels_of(built.setup(run));
    if built.count() == 0 {
        return Ok(Vec::new());
    }
    let first = of(0);
    let other = (0..built.count()).into_par_iter().position_first(|run| of(run) != first);
    other.map_or(Ok(first), |run| Err(BatchError::Channels { run }))
}

/// Groups of runs with the same structure, at most as many as there are lanes.
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

/// The runs of a group; `None` if `go_on` returned false.
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

/// Whether runs like this one can share lanes.
fn fits_lanes(setup: &Setup) -> bool {
    let Setup { settings, model, elements, .. } = setup;
    // The projection onto closed loops needs a different number of iterations in each lane.
    let alone_only = elements.iter().any(|element| element.declare().goes_alone);
    !alone_only && model.loops.is_empty() && settings.form == Form::Recursive && steps_lanes(settings.scheme)
}

/// Whether a scheme takes the same steps in every run: an explicit one of a fixed step.
fn steps_lanes(scheme: SchemeName) -> bool {
    use SchemeName::{ForwardEuler, MidpointEuler, RungeKutta4, SemiImplicitEuler};
    matches!(scheme, ForwardEuler | MidpointEuler | SemiImplicitEuler | RungeKutta4)
}
