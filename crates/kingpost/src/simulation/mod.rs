//! A run: the plant, an integrator and the state, stepped in time and recorded.

mod drawing;
mod errors;
mod events;
mod recording;
mod settle;
mod setup;

pub use crate::elements::Input;
pub use errors::{InputError, RunError};
pub use events::Happened;
pub use settle::{Equilibrium, Instability, NoEquilibrium};
pub use setup::{SchemeName, Settings, Setup};

use crate::dynamics::moving_frame::MovingFrame;
use crate::integrate::{Interval, Scheme, Stage, System};
use crate::model::{Mode, Model};
use crate::plant::{Number, Plant, Tangent};
use crate::results::{Channel, Channels, Sample};
use crate::scalar::Scalar;
use crate::spatial::{Frame, Quaternion};
use crate::state::{SnapshotError, State};
use errors::check_array;
use events::Watch;
pub(crate) use recording::Recording;

/// Steps after which a run reports progress even if no row is due.
pub const PROGRESS_STEPS: u64 = 10_000;

/// Edges closer than this share of a step are at the same time.
const EDGE_SLACK: f64 = 1e-9;

/// Closed loops of a state from outside may be open by less than this, m or rad: the next step
/// closes them.
const LARGEST_GAP_GIVEN: f64 = 1e-6;

/// Recorded rows, and how the run ended.
#[derive(Clone, Debug)]
pub struct Run<S = f64> {
    /// Rows one after another; the columns are those of [`Simulation::channels`].
    pub rows: Vec<S>,
    /// Entries in a row.
    pub columns: usize,
    /// What happened, in order of time.
    pub events: Vec<Happened>,
    /// An error leaves the rows that came before it.
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
    /// The state before the step under way: what is kept when that step diverges.
    last_good: State<S>,
    v_dot: Vec<S>,
    watch: Watch<S>,
    /// Of the setup: a snapshot carries it.
    fingerprint: u64,
}

impl<S: Scalar> Simulation<S> {
    /// Puts a simulation together at time 0, its equations in the recursive form, whatever the
    /// settings say: the other forms are for plain numbers.
    pub fn recursive(setup: Setup<S>) -> Self {
        let fingerprint = setup.fingerprint();
        let Setup { model, world, elements, settings, q, v, .. } = setup;
        let mut plant = Plant::new(model, world, elements);
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
        Self { plant, scheme, settings, channels, state, initial, last_good, v_dot, watch, fingerprint }
    }

    /// Time, s.
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

    /// Where the right-hand side stands: at the start of the next interval.
    pub fn stage(&self) -> Stage<'_, S> {
        stage(self.interval(), &self.state)
    }

    /// The next interval: to the end of the next step, or to where a law changes its form before.
    fn interval(&self) -> Interval {
        let start_s = self.time_s();
        let end_s = start_s + self.settings.step_s;
        Interval { start_s, end_s: self.next_edge_s(start_s, end_s).min(end_s) }
    }

    /// The next time after `start_s` at which a law changes its form or an element samples, s; infinite where there is
    /// none. One that is within rounding of `start_s` has passed, one that is so close to `end_s` falls on it.
    fn next_edge_s(&self, start_s: f64, end_s: f64) -> f64 {
        let slack_s = EDGE_SLACK * self.settings.step_s;
        let edge_s = self.plant.next_edge_s(start_s + slack_s, &self.state.m);
        if (edge_s - end_s).abs() <= slack_s { end_s } else { edge_s }
    }

    /// `q` moved by the local coordinates `xi`, as a scheme moves it.
    pub fn moved(&self, q: &[S], xi: &[S]) -> Vec<S> {
        let mut moved = q.to_vec();
        self.plant.retract(q, xi, &mut moved);
        moved
    }

    /// The complete state, to be moved to another of the same run.
    #[cfg(not(target_family = "wasm"))]
    pub(crate) fn state_mut(&mut self) -> &mut State<S> {
        &mut self.state
    }

    /// Evaluations of the right-hand side by the integrator since the simulation was made: what its
    /// steps cost. One over dual numbers counts as one, and one more for each direction.
    pub fn evaluations(&self) -> u64 {
        self.plant.evaluations
    }

    /// Closes the loops from here by the least change of q and v, as after each step.
    ///
    /// # Errors
    /// A loop that cannot be closed from here; q and v are then no motion of the model.
    pub fn close_loops(&mut self) -> Result<(), RunError> {
        let (time_s, State { q, v, .. }) = (self.state.steps as f64 * self.settings.step_s, &mut self.state);
        self.plant.close_loops(q, v).map_err(|fault| RunError::of_loop(time_s, &self.plant.model, fault))
    }

    /// The complete state.
    pub fn state(&self) -> &State<S> {
        &self.state
    }

    /// Back to time 0.
    pub fn reset(&mut self) {
        self.state.copy_from(&self.initial);
        self.watch.forget_after(0.0);
    }

    /// What has happened so far, in order of time.
    pub fn events(&self) -> &[Happened] {
        self.watch.happened()
    }

    /// Takes `n` steps; allocates nothing. On an error the state stays at the last good step.
    pub fn step(&mut self, n: usize) -> Result<(), RunError> {
        for _ in 0..n {
            self.last_good.copy_from(&self.state);
            let start = self.time_s();
            self.state.steps += 1;
            let end = self.time_s();
            let advanced = self.advance(start, end);
            if let Err(error) = advanced.and_then(|()| self.check(end)) {
                self.state.copy_from(&self.last_good);
                self.watch.forget_after(start);
                return Err(error);
            }
        }
        Ok(())
    }

    /// One step, cut where a law changes its form, an element samples or an event happens.
    fn advance(&mut self, start_s: f64, end_s: f64) -> Result<(), RunError> {
        let mut from = start_s;
        self.watch.begin_step();
        while from < end_s {
            let edge_s = self.next_edge_s(from, end_s);
            let interval = Interval { start_s: from, end_s: edge_s.min(end_s) };
            self.plant.prescribe(interval, &mut self.state.v);
            from = self.step_to_event(interval, edge_s)?;
            let State { q, v, .. } = &mut self.state;
            let closed = self.plant.close_loops(q, v);
            closed.map_err(|fault| RunError::of_loop(end_s, &self.plant.model, fault))?;
            self.plant.sample(from, &mut self.state);
        }
        Ok(())
    }

    /// Where a number stops being one, or a rate passes the limit.
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

    /// Steps to the end of the run, recording a row now, then at each recording time, and at the
    /// end. `progress` hears the time after each row, and at least every [`PROGRESS_STEPS`] steps;
    /// it may stop the run by returning false.
    pub fn run(&mut self, progress: impl FnMut(f64) -> bool) -> Run<S> {
        let mut rows = Vec::new();
        self.write_row(&mut rows);
        let recording = Recording::new(self.settings, self.time_s());
        self.finish(rows, recording, progress)
    }

    /// The rest of a run whose last row, where it stands, is written.
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
            let status = self.step(steps as usize);
            let written = rows[rows.len() - columns].value();
            if self.state.steps == due || (status.is_err() && written < self.time_s()) {
                self.write_row(&mut rows);
                recording.written(self.time_s());
            }
            if status.is_err() {
                return Run { rows, columns, events: self.events().to_vec(), status };
            }
            if !progress(self.time_s()) {
                break;
            }
        }
        Run { rows, columns, events: self.events().to_vec(), status: Ok(()) }
    }

    /// The channels of a row.
    pub fn channels(&self) -> &[Channel] {
        &self.channels.list
    }

    /// Entries in a row.
    pub fn columns(&self) -> usize {
        self.channels.columns()
    }

    /// Appends the values of all channels now.
    pub fn write_row(&mut self, out: &mut Vec<S>) {
        let at = stage(self.interval(), &self.state);
        let observed = self.plant.observe(at, &mut self.v_dot);
        let Stage { time_s, q, v, s, .. } = at;
        self.channels.write_row(&Sample { time_s, q, v, s, observed }, out);
    }
}

impl Simulation {
    /// Gives an implicit scheme exact derivatives, from the same setup over dual numbers; without,
    /// it takes differences.
    pub fn differentiate_with(&mut self, setup: Setup<Number>) {
        let Setup { model, world, elements, q, v, .. } = setup;
        let mut plant = Plant::new(model, world, elements);
        plant.watch_loops(&q, &v);
        self.plant.differentiate_with(Tangent::new(plant));
    }

    /// Puts a simulation together at time 0.
    pub fn new(setup: Setup) -> Self {
        let form = setup.settings.form;
        let mut simulation = Self::recursive(setup);
        simulation.plant.set_form(form);
        simulation
    }

    /// Position (m) and unit quaternion (w, x, y, z) of every body, world; seven numbers a body.
    pub fn poses(&mut self) -> Vec<f64> {
        let bodies = self.plant.body_kinematics(&self.state.q, &self.state.v);
        let pose = |frame: &Frame| {
            let [x, y, z] = frame.position.0;
            let [w, a, b, c] = Quaternion::from_matrix(&frame.rotation).0;
            [x, y, z, w, a, b, c]
        };
        bodies.world.iter().flat_map(pose).collect()
    }

    /// Elevation of the incident waves now, m, at every crossing of the lines x and y, world, m: along the first x first.
    pub fn surface(&self, x: &[f64], y: &[f64]) -> Vec<f64> {
        self.plant.world.elevations_m(x, y, self.time_s())
    }

    /// Replaces q, v and, where given, s. Without s the ledger begins anew here. The rate of a
    /// prescribed coordinate holds until the next step, which sets it as prescribed.
    pub fn set_state(&mut self, q: &[f64], v: &[f64], s: Option<&[f64]>) -> Result<(), InputError> {
        let mut next = self.state.clone();
        next.q = q.to_vec();
        next.v = v.to_vec();
        self.check_motion(&next)?;
        for first in self.plant.model.quaternions() {
            let quaternion = &mut next.q[first..first + 4];
            let unit = Quaternion::from_slice(quaternion).normalized();
            quaternion.copy_from_slice(&unit.0);
        }
        if let Some((constraint, found)) = self.plant.loop_gap(&next.q, v).filter(|(_, gap)| *gap >= LARGEST_GAP_GIVEN)
        {
            let constraint = self.plant.model.constraint_names().swap_remove(constraint);
            return Err(InputError::OpenLoop { constraint, found, allowed: LARGEST_GAP_GIVEN });
        }
        let inputs = self.state.d[..self.plant.layout().inputs.len()].to_vec();
        self.plant.begin(self.time_s(), &inputs, &mut next);
        if let Some(s) = s {
            check_array("s", s, self.state.s.len())?;
            next.s.copy_from_slice(s);
        }
        next.memory.fill(0.0);
        self.state = next;
        Ok(())
    }

    /// An error unless q and v are a motion of this model.
    fn check_motion(&self, state: &State) -> Result<(), InputError> {
        let State { q, v, .. } = state;
        let model = &self.plant.model;
        check_array("q", q, model.position_count)?;
        check_array("v", v, model.velocity_count)?;
        let entry = |name, index, found, allowed| Err(InputError::Entry { name, index, found, allowed });
        if let Some(i) = (0..v.len()).find(|&i| model.modes[i] == Mode::Held && v[i] != 0.0) {
            return entry("v", i, v[i], "0, for a coordinate that is held");
        }
        for first in model.quaternions() {
            let norm = libm::sqrt(q[first..first + 4].iter().map(|x| x * x).sum());
            if (norm - 1.0).abs() > 1e-6 {
                return entry("length of the quaternion that begins at q", first, norm, "1");
            }
        }
        Ok(())
    }

    /// The state as bytes.
    pub fn snapshot(&self) -> Vec<u8> {
        self.state.snapshot(self.fingerprint)
    }

    /// Continues from a snapshot of a simulation with the same setup, to the same bits; on an error
    /// nothing changes.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<(), SnapshotError> {
        let mut next = self.state.clone();
        next.restore(bytes, self.fingerprint)?;
        self.state = next;
        self.watch.forget_after(self.time_s());
        Ok(())
    }

    /// The table of inputs with their values now.
    pub fn inputs(&self) -> Vec<Input> {
        let now = |(input, value): (&Input, &f64)| Input { value: *value, ..input.clone() };
        self.plant.layout().inputs.iter().zip(&self.state.d).map(now).collect()
    }

    /// Sets an input from the next step on.
    pub fn set_input(&mut self, name: &str, value: f64) -> Result<(), InputError> {
        let inputs = &self.plant.layout().inputs;
        let Some(i) = inputs.iter().position(|input| input.name == name) else {
            let names: Vec<&str> = inputs.iter().map(|input| input.name.as_str()).collect();
            let allowed = if names.is_empty() { "none: no drive has a lever".to_owned() } else { names.join(", ") };
            return Err(InputError::Unknown { found: name.to_owned(), allowed });
        };
        let Input { lower, upper, .. } = inputs[i];
        if !(lower..=upper).contains(&value) {
            return Err(InputError::Range { name: name.to_owned(), found: value, lower, upper });
        }
        self.state.d[i] = value;
        Ok(())
    }

    /// Names of the free coordinates: the rows of M*, N* and F*.
    pub fn coordinates(&self) -> Vec<String> {
        let names = self.plant.model.coordinate_names();
        self.plant.model.free_coordinates().into_iter().map(|i| names[i].clone()).collect()
    }

    /// Accelerations of the free coordinates now, with `tau` (N or N m by free coordinate) added.
    pub fn acceleration(&mut self, tau: Option<&[f64]>) -> Result<Vec<f64>, InputError> {
        let free = self.plant.model.free_coordinates();
        let mut everywhere = vec![0.0; self.state.v.len()];
        if let Some(tau) = tau {
            check_array("tau", tau, free.len())?;
            free.iter().zip(tau).for_each(|(&i, tau)| everywhere[i] = *tau);
        }
        let at = stage(self.interval(), &self.state);
        self.plant.acceleration(at, Some(&everywhere), &mut self.v_dot);
        Ok(free.iter().map(|&i| self.v_dot[i]).collect())
    }

    /// Every matrix of the moving frame method now.
    pub fn moving_frame(&mut self) -> MovingFrame {
        let at = stage(self.interval(), &self.state);
        self.plant.matrices(at)
    }

    /// M* by rows (kg, kg m, kg m^2).
    pub fn mass_matrix(&mut self) -> Vec<f64> {
        self.moving_frame().m_star.as_slice().to_vec()
    }

    /// N* q': the velocity terms (N, N m).
    pub fn bias_force(&mut self) -> Vec<f64> {
        self.moving_frame().bias_force().as_slice().to_vec()
    }
}

/// The right-hand side at the start of an interval.
fn stage<S>(interval: Interval, state: &State<S>) -> Stage<'_, S> {
    let State { q, v, s, d, m, .. } = state;
    Stage { time_s: interval.start_s, interval, q, v, s, d, m }
}
