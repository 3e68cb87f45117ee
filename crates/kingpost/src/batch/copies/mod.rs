//! Copies of one scenario that a controller steps together: the engine of a vectorised environment.
//!
//! Each copy has separate numbers (sea, load, delay, seed), inputs and time. Four neighbouring copies are
//! stepped in lanes while their times are equal, and groups of four on threads. The result of every copy is
//! bitwise identical to that of a single simulation with the same inputs.

mod group;

use super::members::Member;
use super::{BatchError, Variant, fits_lanes, pool};
use crate::scalar::LANES;
use crate::scenario::Files;
use crate::scenario::read::Parsed;
use crate::simulation::{InputError, Limit, RunError, Simulation};
use crate::state::State;
use group::{Group, Slots};
use rayon::prelude::*;
use thiserror::Error;

/// Names of the inputs and columns of the copies.
#[derive(Clone, Debug, Default)]
pub struct Asked {
    /// Inputs of each copy that [`VectorEnsemble::advance`] sets, in this order.
    pub inputs: Vec<String>,
    /// Columns of each copy that [`VectorEnsemble::advance`] writes, in this order.
    pub columns: Vec<String>,
    /// Whether the scenario's limits are checked.
    pub limits: bool,
}

/// Reason why copies were not made, restarted or advanced. Nothing changes then.
#[derive(Clone, Debug, Error)]
pub enum CopyError {
    /// A copy cannot be built, or threads cannot be started.
    #[error(transparent)]
    Batch(#[from] BatchError),
    /// An input of a copy is not valid.
    #[error("copy {copy}: {error}")]
    Input {
        /// Index of the copy, from 0.
        copy: usize,
        /// Error of the input.
        error: InputError,
    },
    /// No column has this name.
    #[error("column {found}: no such column of results, allowed: those of the scenario's channels")]
    Column {
        /// The name that was given.
        found: String,
    },
    /// The copy to be marked has failed, or a state is to be resumed although none was marked.
    #[error("mark: found {found}, allowed: a copy that has not failed")]
    Mark {
        /// The copy's failure, or the missing mark.
        found: String,
    },
    /// An array has the wrong length, or an index is beyond the last copy.
    #[error("{what}: found {found}, allowed: {allowed}")]
    Count {
        /// Quantity that was counted.
        what: &'static str,
        /// The number found.
        found: usize,
        /// Number or range that is allowed.
        allowed: String,
    },
}

/// Status of a copy after it was advanced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// It can continue.
    Running,
    /// It has failed: see [`VectorEnsemble::failure`]. It stays at its last good step until it is restarted.
    Failed,
    /// It is beyond the limit with this index; it can continue.
    BeyondLimit(usize),
}

/// Copies of one scenario: see the [module](self).
///
/// ```
/// use kingpost::batch::{Asked, VectorEnsemble, Status};
/// let text = include_str!("../../../../../scenarios/paper.yaml");
/// let load = |mass_kg: f64| vec![("bodies.load.mass_kg".to_owned(), mass_kg.into())];
/// let columns = vec!["ship.roll".to_owned()];
/// let asked = Asked { columns, ..Asked::default() };
/// let mut copies = VectorEnsemble::new(text, "paper.yaml", Default::default(), vec![load(900.0), load(1100.0)], asked, 1)?;
/// let (mut roll, mut status) = ([0.0; 2], [Status::Failed; 2]);
/// copies.advance(50, &[], &mut roll, &mut status)?;
/// assert_eq!(status, [Status::Running; 2]);
/// assert_eq!(copies.time_s(1), 0.05);
/// # Ok::<(), kingpost::batch::CopyError>(())
/// ```
#[derive(Debug)]
pub struct VectorEnsemble {
    source: CopySource,
    asked: Asked,
    pool: Option<rayon::ThreadPool>,
    groups: Vec<Group>,
    count: usize,
    mark: Option<State>,
}

/// A group, and the arrays for its columns and status.
type Work<'a> = (&'a mut Group, (&'a mut [f64], &'a mut [Status]));

/// Source from which copies are built.
#[derive(Debug)]
struct CopySource {
    text: String,
    file: String,
    files: Files,
}

/// A copy that is built, with its simulation at its start.
#[derive(Debug)]
struct NewCopy {
    member: Member,
    simulation: Simulation,
}

impl VectorEnsemble {
    /// Creates one copy for each variant, at its start. If `threads` is 0, it uses all threads of the
    /// machine.
    ///
    /// # Errors
    /// A variant that is not a valid scenario, or has other columns or inputs than the first; a name that does not exist.
    pub fn new(
        text: &str,
        file: &str,
        files: Files,
        variants: Vec<Variant>,
        asked: Asked,
        threads: usize,
    ) -> Result<Self, CopyError> {
        let source = CopySource { text: text.to_owned(), file: file.to_owned(), files };
        let count = variants.len();
        check_count("copies", count, count > 0, "1 or more")?;
        check_count("columns", asked.columns.len(), !asked.columns.is_empty(), "1 or more")?;
        let pool = (threads != 1).then(|| pool(threads)).transpose()?;
        let which: Vec<(usize, Variant)> = variants.into_iter().enumerate().collect();
        let first = source.build(which[0].0, &which[0].1)?;
        check_names(&first.simulation, &asked)?;
        let keeps_ledger = group::needs_ledger(&first, &asked);
        let built = source.build_all(pool.as_ref(), &which, &first.simulation, keeps_ledger)?;
        let (mut groups, mut built) = (Vec::new(), built.into_iter().peekable());
        while built.peek().is_some() {
            groups.push(Group::new(built.by_ref().take(LANES).collect(), &asked, keeps_ledger));
        }
        Ok(Self { source, asked, pool, groups, count, mark: None })
    }

    /// Returns the number of copies.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Returns the copy's time, s.
    ///
    /// # Panics
    /// If the copy does not exist.
    pub fn time_s(&self, copy: usize) -> f64 {
        self.groups[copy / LANES].time_s(copy % LANES)
    }

    /// Returns the error of a copy that has failed, otherwise `None`.
    ///
    /// # Panics
    /// If the copy does not exist.
    pub fn failure(&self, copy: usize) -> Option<&RunError> {
        self.groups[copy / LANES].failure(copy % LANES)
    }

    /// Returns the limits that are checked, with the bounds of the first copy.
    pub fn limits(&self) -> &[Limit] {
        self.groups[0].limits()
    }

    /// Sets the inputs of every copy and takes this number of steps; then writes the columns and the status
    /// of every copy. `inputs` and `columns` hold one copy after another, each in the order of [`Asked`].
    /// With 0 steps it only reads, and the inputs can be omitted. It allocates nothing unless a copy was
    /// restarted or has an event.
    ///
    /// # Errors
    /// Arrays of other lengths; an input beyond its bounds, or NaN.
    pub fn advance(
        &mut self,
        steps: usize,
        inputs: &[f64],
        columns: &mut [f64],
        status: &mut [Status],
    ) -> Result<(), CopyError> {
        let (wide, high) = (self.asked.inputs.len(), self.asked.columns.len());
        let left_out = steps == 0 && inputs.is_empty();
        for (what, found, allowed) in [
            ("inputs", inputs.len(), if left_out { 0 } else { self.count * wide }),
            ("columns", columns.len(), self.count * high),
            ("status", status.len(), self.count),
        ] {
            check_count(what, found, found == allowed, &allowed.to_string())?;
        }
        self.check_inputs(inputs)?;
        let of_group = |i: usize| inputs.get(LANES * wide * i..).unwrap_or_default();
        let one = |(i, (group, (columns, status))): (usize, Work<'_>)| {
            group.advance(steps, Slots { inputs: of_group(i), columns, status });
        };
        match &self.pool {
            Some(pool) => {
                let slots = columns.par_chunks_mut(LANES * high).zip(status.par_chunks_mut(LANES));
                pool.install(|| self.groups.par_iter_mut().zip(slots).enumerate().for_each(one));
            }
            None => {
                let slots = columns.chunks_mut(LANES * high).zip(status.chunks_mut(LANES));
                self.groups.iter_mut().zip(slots).enumerate().for_each(one);
            }
        }
        Ok(())
    }

    /// Returns these copies to their start; a copy with a variant is first rebuilt from it, like in
    /// [`VectorEnsemble::new`].
    ///
    /// # Errors
    /// Those of [`VectorEnsemble::new`]; no copy has changed then.
    pub fn restart(&mut self, which: Vec<(usize, Option<Variant>)>) -> Result<(), CopyError> {
        for (copy, _) in &which {
            self.check_copy(*copy)?;
        }
        let (anew, back): (Vec<_>, Vec<_>) = which.into_iter().partition(|(_, variant)| variant.is_some());
        let anew: Vec<(usize, Variant)> =
            anew.into_iter().filter_map(|(copy, variant)| Some((copy, variant?))).collect();
        let (like, keeps_ledger) = (self.groups[0].first(), self.groups[0].keeps_ledger());
        let built = self.source.build_all(self.pool.as_ref(), &anew, like, keeps_ledger)?;
        for ((copy, _), built) in anew.iter().zip(built) {
            self.groups[copy / LANES].replace(copy % LANES, built);
        }
        for (copy, _) in back {
            self.groups[copy / LANES].reset(copy % LANES);
        }
        Ok(())
    }

    /// Stores the state of a copy, from which [`VectorEnsemble::resume`] lets all copies continue.
    ///
    /// # Errors
    /// The copy does not exist, or has failed.
    pub fn mark(&mut self, copy: usize) -> Result<(), CopyError> {
        self.check_copy(copy)?;
        if self.failure(copy).is_some() {
            return Err(CopyError::Mark { found: format!("copy {copy}, which has failed") });
        }
        let state = self.groups[copy / LANES].state(copy % LANES);
        match &mut self.mark {
            Some(mark) => mark.copy_from(state),
            None => self.mark = Some(state.clone()),
        }
        Ok(())
    }

    /// Sets all copies to the state that was marked last, with its time and inputs. The numbers of each copy
    /// do not change: a copy with another sea meets other waves from then on. A copy with the same numbers as
    /// the marked copy continues bitwise identically.
    ///
    /// # Errors
    /// No copy was marked before.
    pub fn resume(&mut self) -> Result<(), CopyError> {
        let nothing = || CopyError::Mark { found: "no marked copy".to_owned() };
        let mark = self.mark.as_ref().ok_or_else(nothing)?;
        self.groups.iter_mut().for_each(|group| group.resume(mark));
        Ok(())
    }

    fn check_copy(&self, copy: usize) -> Result<(), CopyError> {
        check_count("copy", copy, copy < self.count, &format!("at most {}, the last copy", self.count - 1))
    }

    fn check_inputs(&self, inputs: &[f64]) -> Result<(), CopyError> {
        let wide = self.asked.inputs.len();
        if wide == 0 {
            return Ok(());
        }
        let mut copies = inputs.chunks(wide).enumerate();
        let wrong = copies.find_map(|(copy, values)| {
            let error = self.groups[copy / LANES].wrong_input(copy % LANES, values)?;
            Some(CopyError::Input { copy, error })
        });
        wrong.map_or(Ok(()), Err)
    }
}

impl CopySource {
    fn parsed(&self) -> Result<Parsed<'_>, BatchError> {
        Parsed::new(&self.text, &self.file).map_err(|error| BatchError::Variant { run: 0, error })
    }

    fn build(&self, copy: usize, variant: &Variant) -> Result<NewCopy, CopyError> {
        let member = Member::new(self.parsed()?, copy, variant, &self.files)?;
        let simulation = Simulation::recursive(member.setup.clone());
        Ok(NewCopy { member, simulation })
    }

    /// Builds copies, all with the columns and inputs of another copy.
    fn build_all(
        &self,
        pool: Option<&rayon::ThreadPool>,
        which: &[(usize, Variant)],
        like: &Simulation,
        keeps_ledger: bool,
    ) -> Result<Vec<NewCopy>, CopyError> {
        let parsed = self.parsed()?;
        let one = |(copy, variant): &(usize, Variant)| {
            let member = Member::new(parsed.clone(), *copy, variant, &self.files)?;
            let simulation = group::simulation(&member, keeps_ledger);
            let names = |of: &Simulation| of.inputs().into_iter().map(|input| input.name).collect::<Vec<_>>();
            if simulation.channels() != like.channels() || names(&simulation) != names(like) {
                return Err(BatchError::Channels { run: *copy }.into());
            }
            Ok(NewCopy { member, simulation })
        };
        match pool {
            Some(pool) => pool.install(|| which.par_iter().map(one).collect()),
            None => which.iter().map(one).collect(),
        }
    }
}

fn check_count(what: &'static str, found: usize, right: bool, allowed: &str) -> Result<(), CopyError> {
    if right { Ok(()) } else { Err(CopyError::Count { what, found, allowed: allowed.to_owned() }) }
}

/// Returns an error unless all names exist and no wire sets an input.
fn check_names(simulation: &Simulation, asked: &Asked) -> Result<(), CopyError> {
    let mut trial = simulation.clone();
    for name in &asked.inputs {
        let now = trial.inputs().into_iter().find(|input| input.name == *name).map_or(0.0, |input| input.value);
        trial.set_input(name, now).map_err(|error| CopyError::Input { copy: 0, error })?;
    }
    let known = |column: &String| simulation.channels().iter().any(|channel| channel.columns.contains(column));
    let unknown = asked.columns.iter().find(|column| !known(column));
    unknown.map_or(Ok(()), |found| Err(CopyError::Column { found: found.clone() }))
}
