//! A run: the plant, an integrator and the state, stepped in time and recorded.

mod drawing;
mod errors;
mod events;
mod feedback;
mod from_outside;
mod limits;
mod live;
mod recording;
mod sampled_loops;
mod sea;
mod settle;
mod settling_moves;
mod setup;
#[cfg(not(target_family = "wasm"))]
mod side_by_side;
mod small_motions;
mod steering;
mod watching;

pub use crate::elements::{Input, Warning};
pub use errors::{InputError, RunError};
pub use events::EventRecord;
pub use feedback::GrowingMode;
#[cfg(not(target_family = "wasm"))]
pub(crate) use limits::OPERATION_STEP;
pub use limits::{Limit, LimitResult};
pub use settle::{Equilibrium, Instability, NoEquilibrium};
pub use setup::{SchemeName, Settings, Setup};
pub use steering::{LeverMove, ParameterSet};

use crate::elements::Layout;
use crate::elements::ropes::PARTING;
use crate::integrate::{Interval, Scheme, Stage, System};
use crate::model::Model;
use crate::plant::{ObservedPart, Plant};
use crate::results::{Channel, Channels, Readings, Sample};
use crate::scalar::Scalar;
use crate::state::State;
use events::Watch;
use limits::Limits;
pub(crate) use recording::Recording;
use steering::Steering;
use watching::Watching;

/// Number of steps after which a run reports progress even if no row is due.
pub const PROGRESS_STEPS: u64 = 1_000;

/// Largest number of free coordinates, or of states of as many motions, for which square matrices are
/// allocated: one such matrix takes 32 MB, and an analysis keeps a few dozen.
pub const MOST_DENSE: usize = 2_000;

/// Times closer to each other than this share of a step count as simultaneous.
const EDGE_SLACK: f64 = 1e-9;

/// Recorded rows, and how the run ended.
#[derive(Clone, Debug)]
pub struct Run<S = f64> {
    /// Rows in succession; the columns are those of [`Simulation::channels`].
    pub rows: Vec<S>,
    /// Number of entries in a row.
    pub columns: usize,
    /// The events, in order of time.
    pub events: Vec<EventRecord>,
    /// The warnings.
    pub warnings: Vec<Warning>,
    /// Results of the scenario's limits.
    pub limits: Vec<LimitResult>,
    /// How the run ended; after an error the rows before it are kept.
    pub status: Result<(), RunError>,
}

/// A simulation that can be stepped, watched, rewound and steered.
///
/// ```
/// let text = include_str!("../../../../scenarios/paper.yaml");
/// let scenario = kingpost::scenario::read(text, "paper.yaml", &[])?;
/// let mut simulation = kingpost::Simulation::new(scenario.setup()?);
/// simulation.step(10).expect("ten steps do not diverge");
/// assert_eq!(simulation.time_s(), 0.01);
/// # Ok::<(), kingpost::scenario::ScenarioError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Simulation<S: Scalar = f64> {
    plant: Plant<S>,
    scheme: Scheme<S>,
    settings: Settings,
    channels: Channels,
    state: State<S>,
    initial: State<S>,
    /// State before the present step; it is restored if the step diverges.
    last_good: State<S>,
    v_dot: Vec<S>,
    watch: Watch<S>,
    watching: Watching,
    limits: Limits,
    steering: Steering<S>,
    /// Fingerprint of the setup: a snapshot contains it.
    fingerprint: u64,
}

impl<S: Scalar> Simulation<S> {
    /// Creates a simulation at time 0 in the recursive form, whatever the settings: the other forms, and
    /// watchers, work with plain numbers only.
    pub fn recursive(setup: Setup<S>) -> Self {
        Self::recursive_with(setup, true)
    }

    /// Creates a simulation in the recursive form; without the ledger a step is cheaper, and only columns of motions
    /// and of elements can be read.
    pub(crate) fn recursive_with(setup: Setup<S>, keeps_ledger: bool) -> Self {
        let Setup { model, world, elements, watchers: _, limits, wires, settings, q, v, fingerprint } = setup;
        let mut plant = Plant::new(model, world, elements);
        plant.connect(&wires);
        plant.keep_ledger(keeps_ledger);
        let channels = Channels::new(&plant.model, plant.layout());
        let inputs: Vec<S> = plant.layout().inputs.iter().map(|input| S::constant(input.value)).collect();
        let v_dot = vec![S::ZERO; v.len()];
        let mut state = State { q, v, ..State::default() };
        plant.begin(0.0, &inputs, &mut state);
        plant.watch_loops(&state.q, &state.v);
        let scheme: Scheme<S> = settings.scheme.scheme(plant.sizes(), settings.step_s);
        state.memory = vec![S::ZERO; scheme.memory_len(state.d.len() + state.m.len())];
        let watch = Watch::new(plant.layout().watched.len(), &state);
        let (initial, last_good) = (state.clone(), state.clone());
        let (watching, steering) = (Watching::default(), Steering::new(plant.layout(), &channels));
        let limits = Limits::new(limits, &channels);
        Self {
            plant,
            scheme,
            settings,
            channels,
            state,
            initial,
            last_good,
            v_dot,
            watch,
            watching,
            limits,
            steering,
            fingerprint,
        }
    }

    /// Returns the time, s.
    pub fn time_s(&self) -> f64 {
        self.state.steps as f64 * self.settings.step_s
    }

    /// Time stepping and recording.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// The mechanical model.
    pub fn model(&self) -> &Model<S> {
        &self.plant.model
    }

    /// Returns the stage at the start of the next interval.
    pub fn stage(&self) -> Stage<'_, S> {
        stage(self.interval(), &self.state)
    }

    /// Returns the next interval: to the end of the next step, or to an earlier time at which a law changes
    /// form.
    fn interval(&self) -> Interval {
        let start_s = self.time_s();
        let end_s = start_s + self.settings.step_s;
        Interval { start_s, end_s: self.next_edge_s(start_s, end_s).min(end_s) }
    }

    /// Returns the next time after `start_s` at which a law changes form or an element samples, s; infinity
    /// if there is none. A time equal to `start_s` within rounding counts as past; one equal to `end_s`
    /// within rounding is replaced by `end_s`.
    fn next_edge_s(&self, start_s: f64, end_s: f64) -> f64 {
        let slack_s = EDGE_SLACK * self.settings.step_s;
        let edge_s = self.plant.next_edge_s(start_s + slack_s, &self.state.m);
        if (edge_s - end_s).abs() <= slack_s { end_s } else { edge_s }
    }

    /// Returns `q` moved by the local coordinates `xi`, as in a scheme.
    pub fn moved(&self, q: &[S], xi: &[S]) -> Vec<S> {
        let mut moved = q.to_vec();
        self.plant.retract(q, xi, &mut moved);
        moved
    }

    /// Returns the number of evaluations of the right-hand side since the simulation was created: the cost of
    /// its steps. An evaluation over dual numbers counts as one plus one for each direction.
    pub fn evaluations(&self) -> u64 {
        self.plant.evaluations
    }

    /// Closes the loops by the smallest change of q and v, as after each step.
    ///
    /// # Errors
    /// A loop that cannot be closed; q and v are then not a valid motion of the model.
    pub fn close_loops(&mut self) -> Result<(), RunError> {
        let (time_s, State { q, v, .. }) = (self.state.steps as f64 * self.settings.step_s, &mut self.state);
        self.plant.begin_step();
        self.plant.close_loops(q, v).map_err(|fault| RunError::of_loop(time_s, &self.plant, fault))
    }

    /// Returns the complete state.
    pub fn state(&self) -> &State<S> {
        &self.state
    }

    /// Returns to time 0.
    pub fn reset(&mut self) {
        self.state.copy_from(&self.initial);
        self.watch.forget_after(0);
        self.watching.begin_anew();
        self.limits.begin_anew();
        self.steering = Steering::new(self.plant.layout(), &self.channels);
    }

    /// Returns the indices of everything that the elements declare.
    pub fn layout(&self) -> &Layout {
        self.plant.layout()
    }

    /// Returns the events so far, in order of time.
    pub fn events(&self) -> &[EventRecord] {
        self.watch.records()
    }

    /// Returns the warnings in order of time: of parted ropes, and of the rows since the start of the run, or
    /// since its state was set from outside.
    pub fn warnings(&self) -> Vec<Warning> {
        let parted = self.events().iter().filter(|record| record.code == PARTING);
        let parted = parted.map(|EventRecord { time_s, element, .. }| Warning {
            time_s: *time_s,
            code: PARTING,
            name: element.clone(),
            value: None,
            bound: None,
            unit: "N",
            text: "parts: its tension has reached its breaking load".to_owned(),
        });
        let mut warnings: Vec<Warning> = parted.chain(self.watching.warnings()).collect();
        warnings.sort_by(|one, other| one.time_s.total_cmp(&other.time_s));
        warnings
    }

    /// Returns the results of the limits for the rows since the start of the run, or since its state was set
    /// from outside.
    pub fn limits(&self) -> Vec<LimitResult> {
        self.limits.results()
    }

    /// Takes `n` steps; before each, steering elements set their inputs. The steps allocate nothing. On an error the
    /// state stays at the last good step.
    pub fn step(&mut self, n: usize) -> Result<(), RunError> {
        for _ in 0..n {
            self.last_good.copy_from(&self.state);
            if let Err(error) = self.one_step() {
                self.state.copy_from(&self.last_good);
                self.watch.forget_after(self.state.steps);
                return Err(error);
            }
        }
        Ok(())
    }

    fn one_step(&mut self) -> Result<(), RunError> {
        self.update_controls()?;
        let start_s = self.time_s();
        self.state.steps += 1;
        let end_s = self.time_s();
        self.advance(start_s, end_s)?;
        self.check(end_s)
    }

    /// Takes one step, divided where a law changes form, an element samples or an event occurs.
    fn advance(&mut self, start_s: f64, end_s: f64) -> Result<(), RunError> {
        let mut from = start_s;
        self.watch.begin_step();
        while from < end_s {
            let edge_s = self.next_edge_s(from, end_s);
            let interval = Interval { start_s: from, end_s: edge_s.min(end_s) };
            self.plant.begin_step();
            self.plant.prescribe(interval, &mut self.state.v);
            from = self.step_to_event(interval, edge_s)?;
            let State { q, v, .. } = &mut self.state;
            let closed = self.plant.close_loops(q, v);
            closed.map_err(|fault| RunError::of_loop(end_s, &self.plant, fault))?;
            self.plant.sample(from, &mut self.state);
        }
        Ok(())
    }

    /// Checks that all numbers are finite and no rate exceeds the limit.
    fn check(&self, time_s: f64) -> Result<(), RunError> {
        let limit = self.settings.rate_limit;
        for (body, node) in self.plant.model.tree.nodes.iter().enumerate() {
            let rates = &self.state.v[node.velocities..][..node.kind.velocity_count()];
            let positions = &self.state.q[node.positions..][..node.kind.position_count()];
            let fast = rates.iter().position(|rate| !rate.all(|rate| rate.abs() <= limit));
            let lost = positions.iter().position(|x| !x.all(f64::is_finite));
            let (quantity, i, value) = match (fast, lost) {
                (Some(i), _) => ("rate", i, rates[i].value()),
                (None, Some(i)) => ("position", i.min(rates.len() - 1), positions[i].value()),
                (None, None) => continue,
            };
            return Err(RunError::Diverged {
                time_s,
                body: self.plant.model.bodies[body].name.clone(),
                coordinate: self.plant.model.joints[body].coordinate_names().swap_remove(i),
                quantity,
                value,
                limit,
            });
        }
        Ok(())
    }

    /// Steps to the end of the run, recording a row at the start, at each recording time, and at the end.
    /// `progress` is called with the time after each row, and at least every [`PROGRESS_STEPS`] steps; it
    /// stops the run by returning false.
    pub fn run(&mut self, progress: impl FnMut(f64) -> bool) -> Run<S> {
        let mut rows = Vec::new();
        self.write_row(&mut rows);
        if let Err(error) = self.check_row(&rows) {
            return self.ended(rows, Err(error));
        }
        let recording = Recording::new(self.settings, self.time_s());
        self.finish(rows, recording, progress)
    }

    /// Continues a run whose row at the present state is recorded, to its end.
    pub(crate) fn finish(
        &mut self,
        mut rows: Vec<S>,
        mut recording: Recording,
        mut progress: impl FnMut(f64) -> bool,
    ) -> Run<S> {
        let columns = self.columns();
        while !recording.is_over(self.state.steps) {
            let due = recording.due(self.state.steps);
            let steps = (due - self.state.steps).min(PROGRESS_STEPS);
            let mut status = self.step(steps as usize);
            let written = rows[rows.len() - columns].value();
            if self.state.steps == due || (status.is_err() && written < self.time_s()) {
                let there = rows.len();
                self.write_row(&mut rows);
                if let Err(error) = self.check_row(&rows[there..]) {
                    rows.truncate(there);
                    status = status.and(Err(error));
                }
                recording.written(self.time_s());
            }
            if status.is_err() {
                return self.ended(rows, status);
            }
            if !progress(self.time_s()) {
                break;
            }
        }
        self.ended(rows, Ok(()))
    }

    /// Returns the run with these rows and this status.
    pub(crate) fn ended(&self, rows: Vec<S>, status: Result<(), RunError>) -> Run<S> {
        let (columns, events) = (self.columns(), self.events().to_vec());
        Run { rows, columns, events, warnings: self.warnings(), limits: self.limits(), status }
    }

    /// Checks that all numbers of a row are finite: loads and accelerations can be infinite or NaN although
    /// the state is finite.
    pub(crate) fn check_row(&self, row: &[S]) -> Result<(), RunError> {
        let Some(place) = row.iter().position(|x| !x.all(f64::is_finite)) else { return Ok(()) };
        let mut columns = self.channels.list.iter().flat_map(|channel| &channel.columns);
        let column = columns.nth(place).cloned().unwrap_or_default();
        Err(RunError::NoNumber { time_s: self.time_s(), column, value: row[place].value() })
    }

    /// Returns the channels of a row.
    pub fn channels(&self) -> &[Channel] {
        &self.channels.list
    }

    /// Returns the number of entries in a row.
    pub fn columns(&self) -> usize {
        self.channels.columns()
    }

    /// Returns readings of these columns only, which cost less than a full row; columns that do not exist are
    /// ignored.
    pub fn readings(&self, columns: &[String]) -> Readings<S> {
        Readings::new(columns, &self.channels, self.plant.layout())
    }

    /// Writes the present values of the readings, in their order.
    pub fn read(&mut self, readings: &mut Readings<S>, out: &mut Vec<S>) {
        let at = self.steering.shown(&self.plant, stage(self.interval(), &self.state));
        let observed = self.plant.observe(at, readings.extent(), &mut self.v_dot);
        let Stage { time_s, q, v, s, .. } = at;
        readings.read(&Sample { time_s, q, v, s, observed }, &self.channels, out);
    }

    /// Appends the present values of all channels.
    pub fn write_row(&mut self, out: &mut Vec<S>) {
        let at = self.steering.shown(&self.plant, stage(self.interval(), &self.state));
        let observed = self.plant.observe(at, &ObservedPart::Everything, &mut self.v_dot);
        let Stage { time_s, q, v, s, .. } = at;
        let first = out.len();
        self.channels.write_row(&Sample { time_s, q, v, s, observed }, out);
        let row = &out[first..];
        // A row with a number that is not finite is not recorded.
        if row.iter().all(|value| value.all(f64::is_finite)) {
            self.watching.see(row);
            self.limits.see(row);
        }
    }
}

/// Returns the right-hand side at the start of an interval.
fn stage<S>(interval: Interval, state: &State<S>) -> Stage<'_, S> {
    let State { q, v, s, d, m, .. } = state;
    Stage { time_s: interval.start_s, interval, q, v, s, d, m }
}
