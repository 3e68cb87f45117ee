//! Runs of a batch: variants of one text that are read and built.

use super::{BatchError, Built, MOST_BYTES, Variant, bytes, channels_of, check_count};
use crate::scalar::Lanes;
use crate::scenario::read::Parsed;
use crate::scenario::{Files, Scenario, side_by_side};
use crate::simulation::{Setup, Simulation};
use core::sync::atomic::{AtomicU64, Ordering::Relaxed};
use rayon::prelude::*;

/// Variants of one scenario, each read and built once: they can be run together by
/// [`run_built`](super::run_built), or each one alone.
///
/// ```
/// use kingpost::batch::{Built, Members, run_built};
/// use kingpost::scenario::Files;
/// let text = include_str!("../../../../scenarios/paper.yaml");
/// let variant = |x: f64| vec![("crane_x_m".to_owned(), x.into()), ("simulation.duration_s".to_owned(), 0.1.into())];
/// let members = Members::new(text, "paper.yaml", &Files::default(), &[variant(0.0), variant(-5.0)])?;
/// let together = run_built(&members, 1, |_| true)?;
/// assert_eq!(together.runs[1].rows, members.simulation(1).run(|_| true).rows);
/// # Ok::<(), kingpost::batch::BatchError>(())
/// ```
pub struct Members(Vec<Member>);

/// One variant, read and built.
#[derive(Debug)]
pub(super) struct Member {
    pub(super) scenario: Scenario,
    pub(super) setup: Setup,
    /// The scenario without its continuous numbers: see [`Scenario::structure`].
    structure: String,
}

impl Member {
    /// Reads and builds the variant of this run.
    pub(super) fn new(parsed: Parsed<'_>, run: usize, variant: &Variant, files: &Files) -> Result<Self, BatchError> {
        let wrong = |error| BatchError::Variant { run, error };
        let (scenario, setup) = parsed.read_and_build(variant, files).map_err(wrong)?;
        let structure = scenario.structure(&[]);
        Ok(Self { scenario, setup, structure })
    }

    /// Returns a separate simulation of the variant, at its start.
    pub(super) fn simulation(&self) -> Simulation {
        self.scenario.simulation_of(self.setup.clone()).unwrap_or_else(|_| Simulation::new(self.setup.clone()))
    }
}

impl Members {
    /// Reads and builds each variant of a text, which is parsed once.
    ///
    /// # Errors
    /// A variant that does not read or build; runs that would take more than [`MOST_BYTES`](super::MOST_BYTES).
    pub fn new(text: &str, file: &str, files: &Files, variants: &[Variant]) -> Result<Self, BatchError> {
        Self::within(text, file, files, variants, MOST_BYTES)
    }

    /// Builds the variants until their memory exceeds `most_bytes`, so that an excessive batch stops early.
    pub(super) fn within(
        text: &str,
        file: &str,
        files: &Files,
        variants: &[Variant],
        most_bytes: u64,
    ) -> Result<Self, BatchError> {
        let Some(first) = variants.first() else { return Ok(Self(Vec::new())) };
        check_count(variants.len(), most_bytes)?;
        let parsed = Parsed::new(text, file).map_err(|error| BatchError::Variant { run: 0, error })?;
        let first = Member::new(parsed.clone(), 0, first, files)?;
        let columns = channels_of(&first.setup).iter().map(|channel| channel.columns.len()).sum();
        let (built, taken) = (AtomicU64::new(1), AtomicU64::new(bytes(&first.setup, columns) as u64));
        let member = |(run, variant): (usize, &Variant)| {
            let member = Member::new(parsed.clone(), run, variant, files)?;
            let own = bytes(&member.setup, columns) as u64;
            let (count, sum) = (built.fetch_add(1, Relaxed) + 1, taken.fetch_add(own, Relaxed) + own);
            if sum > most_bytes {
                let found = (sum as f64 / count as f64 * variants.len() as f64) as u64;
                return Err(BatchError::Memory { runs: variants.len(), found, allowed: most_bytes });
            }
            Ok(member)
        };
        let rest = variants.par_iter().enumerate().skip(1).map(member);
        let rest: Vec<Member> = rest.collect::<Result<_, _>>()?;
        Ok(Self(core::iter::once(first).chain(rest).collect()))
    }
}

impl Built for Members {
    fn count(&self) -> usize {
        self.0.len()
    }

    fn setup(&self, run: usize) -> &Setup {
        &self.0[run].setup
    }

    fn structure(&self, run: usize) -> &str {
        &self.0[run].structure
    }

    fn simulation(&self, run: usize) -> Simulation {
        self.0[run].simulation()
    }

    fn side_by_side(&self, group: &[usize]) -> Option<Setup<Lanes>> {
        let scenarios: Vec<&Scenario> = group.iter().map(|&run| &self.0[run].scenario).collect();
        let setups: Vec<&Setup> = group.iter().map(|&run| &self.0[run].setup).collect();
        // If a number that determines the structure differs, each variant is run alone.
        side_by_side(&scenarios, &setups).ok()
    }
}
