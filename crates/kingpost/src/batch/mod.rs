//! Many runs at once: variants of one scenario over lanes and threads.
//!
//! Variants of one structure go side by side in the [lanes](crate::scalar::Lanes) of SIMD
//! registers, groups of them over threads. Every run has the bits that it would have alone,
//! whatever stands beside it and whatever the number of threads.

mod side_by_side;

use crate::elements::Layout;
use crate::plant::Form;
use crate::results::{Channel, Channels};
use crate::scalar::LANES;
use crate::scenario::read::read_and_build;
use crate::scenario::{Files, Scenario, ScenarioError, side_by_side};
use crate::simulation::{Run, SchemeName, Setup, Simulation};
use core::sync::atomic::{AtomicUsize, Ordering};
use indexmap::IndexMap;
use rayon::prelude::*;
use serde_json::Value;
use thiserror::Error;

/// What is set over the scenario in one run: names of parameters or paths of fields, in order.
pub type Variant = Vec<(String, Value)>;

/// Why a batch did not run at all.
#[derive(Clone, Debug, Error)]
pub enum BatchError {
    /// A variant that is no scenario.
    #[error("run {run}: {error}")]
    Variant {
        /// Which, from 0.
        run: usize,
        /// What is wrong with it.
        error: ScenarioError,
    },
    /// Variants with other bodies, joints or points than the first: their rows would not compare.
    #[error("run {run}: found other result channels than those of run 0, allowed: the same bodies, joints and points")]
    Channels {
        /// Which, from 0.
        run: usize,
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

/// Runs every variant of a scenario from start to end. `threads` 0 takes as many as the machine
/// has. `progress` hears how many runs are done; it may stop the batch by returning false.
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
/// A variant that does not read or build, or whose channels are not those of the first.
pub fn run(
    text: &str,
    file: &str,
    files: &Files,
    variants: &[Variant],
    threads: usize,
    progress: impl Fn(usize) -> bool + Sync,
) -> Result<Batch, BatchError> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.map_err(|_| BatchError::Threads(threads))?;
    pool.install(|| {
        let members = members(text, file, files, variants)?;
        let channels = members.first().map_or_else(Vec::new, Member::channels);
        let done = AtomicUsize::new(0);
        let run_group = |group: &[usize]| {
            let runs = run_group(group, &members, &|| progress(done.load(Ordering::Relaxed)));
            done.fetch_add(group.len(), Ordering::Relaxed);
            (runs.is_some() && progress(done.load(Ordering::Relaxed)))
                .then_some(runs)
                .flatten()
                .ok_or(BatchError::Stopped)
        };
        let groups = groups(&members);
        let by_group: Vec<Vec<Run>> = groups.par_iter().map(|group| run_group(group)).collect::<Result<_, _>>()?;
        let mut runs: Vec<(usize, Run)> = groups.into_iter().flatten().zip(by_group.into_iter().flatten()).collect();
        runs.sort_by_key(|(run, _)| *run);
        Ok(Batch { channels, runs: runs.into_iter().map(|(_, run)| run).collect() })
    })
}

/// One variant, read and built.
struct Member {
    scenario: Scenario,
    setup: Setup,
    /// The scenario without its continuous numbers: see [`Scenario::structure`].
    structure: String,
}

impl Member {
    fn channels(&self) -> Vec<Channel> {
        Channels::new(&self.setup.model, &Layout::new(&self.setup.elements, 0)).list
    }

    /// The run by itself.
    fn simulation(&self) -> Simulation {
        self.scenario.simulation_of(self.setup.clone()).unwrap_or_else(|_| Simulation::new(self.setup.clone()))
    }
}

fn members(text: &str, file: &str, files: &Files, variants: &[Variant]) -> Result<Vec<Member>, BatchError> {
    let member = |(run, variant): (usize, &Variant)| {
        let wrong = |error| BatchError::Variant { run, error };
        let (scenario, setup) = read_and_build(text, file, variant, files).map_err(wrong)?;
        let structure = scenario.structure();
        Ok(Member { scenario, setup, structure })
    };
    let members: Vec<Member> = variants.par_iter().enumerate().map(member).collect::<Result<_, _>>()?;
    if let Some(first) = members.first().map(Member::channels)
        && let Some(run) = members.par_iter().position_first(|member| member.channels() != first)
    {
        return Err(BatchError::Channels { run });
    }
    Ok(members)
}

/// Runs that go side by side: of one structure, as many as there are lanes.
fn groups(members: &[Member]) -> Vec<Vec<usize>> {
    let mut by_structure: IndexMap<&str, Vec<usize>> = IndexMap::new();
    for (run, member) in members.iter().enumerate() {
        by_structure.entry(&member.structure).or_default().push(run);
    }
    let mut groups: Vec<Vec<usize>> = by_structure
        .into_values()
        .flat_map(|runs| runs.chunks(LANES).map(<[usize]>::to_vec).collect::<Vec<_>>())
        .collect();
    groups.sort();
    groups
}

/// The runs of a group; `None` where `go_on` said no.
fn run_group(group: &[usize], members: &[Member], go_on: &dyn Fn() -> bool) -> Option<Vec<Run>> {
    let alone: Vec<Simulation> = group.iter().map(|&run| members[run].simulation()).collect();
    let settings = &members[group[0]].setup.settings;
    // The loops' projection takes as many iterations as each run needs: not the same in all lanes.
    let open = members[group[0]].setup.model.loops.is_empty();
    let fits = open && settings.form == Form::Recursive && steps_lanes(settings.scheme);
    if group.len() > 1 && fits {
        let scenarios: Vec<&Scenario> = group.iter().map(|&run| &members[run].scenario).collect();
        let setups: Vec<&Setup> = group.iter().map(|&run| &members[run].setup).collect();
        // Where a number that decides how a run is made up differs, each goes alone.
        if let Ok(setup) = side_by_side(&scenarios, &setups) {
            return side_by_side::run(setup, alone, go_on);
        }
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

/// Whether a scheme takes the same steps in every run: an explicit one of a fixed step.
fn steps_lanes(scheme: SchemeName) -> bool {
    use SchemeName::{ForwardEuler, MidpointEuler, RungeKutta4, SemiImplicitEuler};
    matches!(scheme, ForwardEuler | MidpointEuler | SemiImplicitEuler | RungeKutta4)
}
