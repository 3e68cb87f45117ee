//! Up to four copies that are stepped in lanes while their times are equal.

use super::{Asked, Member, NewCopy, Status, fits_lanes};
use crate::plant::{Form, ObservedPart};
use crate::results::Readings;
use crate::scalar::{LANES, Lanes};
use crate::scenario::side_by_side;
use crate::simulation::{InputError, Limit, OPERATION_STEP, RunError, Simulation};
use crate::state::State;

/// Numbers of a group's copies, one copy after another.
pub(super) struct Slots<'a> {
    pub inputs: &'a [f64],
    pub columns: &'a mut [f64],
    pub status: &'a mut [Status],
}

/// Copies of a group. The state of a copy is in its lane while `in_lanes` is true, otherwise in its own
/// simulation.
#[derive(Debug)]
pub(super) struct Group {
    members: Vec<Member>,
    alone: Vec<Simulation>,
    in_lanes: Vec<bool>,
    failed: Vec<Option<RunError>>,
    lanes: SharedLanes,
    /// Indices of the inputs in d, and for each copy the bounds of its inputs.
    inputs: Vec<usize>,
    bounds: Vec<Vec<[f64; 2]>>,
    /// Requested columns, then the time and the columns of the limits; last the step of the operation if a limit is of steps.
    columns: Vec<String>,
    asked: usize,
    keeps_ledger: bool,
    watches: bool,
    readings: Readings<f64>,
    read: Vec<f64>,
}

#[derive(Debug)]
enum SharedLanes {
    NotBuilt,
    /// The copies do not fit into lanes.
    Impossible,
    Built(Box<Together>),
}

#[derive(Debug)]
struct Together {
    simulation: Simulation<Lanes>,
    readings: Readings<Lanes>,
    read: Vec<Lanes>,
}

/// Returns whether requested columns need the ledger, or all forces, which are computed only with the ledger.
pub(super) fn needs_ledger(first: &NewCopy, asked: &Asked) -> bool {
    let watched = first.member.setup.limits.iter().filter(|_| asked.limits).map(|limit| limit.column.clone());
    let columns: Vec<String> = asked.columns.iter().cloned().chain(watched).collect();
    *first.simulation.readings(&columns).extent() == ObservedPart::Everything
}

/// Returns the simulation of a copy at its start.
pub(super) fn simulation(member: &Member, keeps_ledger: bool) -> Simulation {
    let settings = &member.setup.settings;
    if settings.form == Form::Recursive && !settings.scheme.is_implicit() {
        return Simulation::recursive_with(member.setup.clone(), keeps_ledger);
    }
    member.simulation()
}

impl Group {
    pub(super) fn new(built: Vec<NewCopy>, asked: &Asked, keeps_ledger: bool) -> Self {
        let (members, alone): (Vec<Member>, Vec<Simulation>) =
            built.into_iter().map(|NewCopy { member, simulation }| (member, simulation)).unzip();
        let table = alone[0].inputs();
        let place = |name: &String| table.iter().position(|input| input.name == *name);
        let inputs = asked.inputs.iter().filter_map(place).collect();
        let limits = &members[0].setup.limits;
        let watched = limits.iter().filter(|_| asked.limits).map(|limit| limit.column.clone());
        let time = asked.limits.then(|| "time".to_owned());
        let by_steps = asked.limits && limits.iter().any(|limit| !limit.steps.is_empty());
        let step = by_steps.then(|| OPERATION_STEP.to_owned());
        let columns: Vec<String> = asked.columns.iter().cloned().chain(time).chain(watched).chain(step).collect();
        let readings = alone[0].readings(&columns);
        let mut group = Self {
            in_lanes: vec![false; alone.len()],
            failed: vec![None; alone.len()],
            lanes: SharedLanes::NotBuilt,
            bounds: vec![Vec::new(); alone.len()],
            read: Vec::with_capacity(columns.len()),
            asked: asked.columns.len(),
            watches: asked.limits,
            members,
            alone,
            inputs,
            columns,
            keeps_ledger,
            readings,
        };
        (0..group.alone.len()).for_each(|k| group.note_bounds(k));
        group
    }

    fn note_bounds(&mut self, k: usize) {
        let table = self.alone[k].inputs();
        self.bounds[k] = self.inputs.iter().map(|&input| [table[input].lower, table[input].upper]).collect();
    }

    pub(super) fn first(&self) -> &Simulation {
        &self.alone[0]
    }

    pub(super) fn keeps_ledger(&self) -> bool {
        self.keeps_ledger
    }

    pub(super) fn limits(&self) -> &[Limit] {
        if self.watches { &self.members[0].setup.limits } else { &[] }
    }

    pub(super) fn failure(&self, k: usize) -> Option<&RunError> {
        self.failed[k].as_ref()
    }

    pub(super) fn time_s(&self, k: usize) -> f64 {
        match &self.lanes {
            SharedLanes::Built(together) if self.in_lanes[k] => together.simulation.time_s(),
            _ => self.alone[k].time_s(),
        }
    }

    /// Returns the first input of a copy that is outside its bounds.
    pub(super) fn wrong_input(&self, k: usize, values: &[f64]) -> Option<InputError> {
        let mut pairs = values.iter().zip(&self.bounds[k]).enumerate();
        let (i, (found, [lower, upper])) =
            pairs.find(|(_, (value, [lower, upper]))| !(lower..=upper).contains(value))?;
        let name = self.alone[k].layout().inputs[self.inputs[i]].name.clone();
        Some(InputError::Range { name, found: *found, lower: *lower, upper: *upper })
    }

    pub(super) fn replace(&mut self, k: usize, built: NewCopy) {
        self.leave_lanes();
        (self.members[k], self.alone[k], self.failed[k]) = (built.member, built.simulation, None);
        self.lanes = SharedLanes::NotBuilt;
        self.note_bounds(k);
    }

    pub(super) fn reset(&mut self, k: usize) {
        self.alone[k].reset();
        (self.in_lanes[k], self.failed[k]) = (false, None);
    }

    /// Returns the state of a copy.
    pub(super) fn state(&mut self, k: usize) -> &State {
        self.take_from_lane(k);
        self.alone[k].state()
    }

    /// Copies the state of a copy from its lane, if it is in one, to its own simulation.
    fn take_from_lane(&mut self, k: usize) {
        if let SharedLanes::Built(together) = &self.lanes
            && self.in_lanes[k]
        {
            self.alone[k].take_lane(&together.simulation, k);
        }
    }

    /// Sets the state of all copies.
    pub(super) fn resume(&mut self, state: &State) {
        for (alone, failed) in self.alone.iter_mut().zip(&mut self.failed) {
            alone.take_state(state);
            *failed = None;
        }
        self.in_lanes.fill(false);
    }

    pub(super) fn advance(&mut self, steps: usize, slots: Slots<'_>) {
        if steps > 0 {
            self.join();
            let before: [bool; LANES] = core::array::from_fn(|k| self.in_lanes.get(k) == Some(&true));
            let left = self.step_lanes(steps, slots.inputs);
            for (k, &was_in_lanes) in before.iter().enumerate().take(self.alone.len()) {
                if self.in_lanes[k] || self.failed[k].is_some() {
                    continue;
                }
                if !was_in_lanes {
                    for (i, &input) in self.inputs.iter().enumerate() {
                        self.alone[k].put_input(input, slots.inputs[k * self.inputs.len() + i]);
                    }
                }
                self.failed[k] = self.alone[k].step(if was_in_lanes { left } else { steps }).err();
            }
        }
        self.read(slots.columns, slots.status);
    }

    /// Steps the copies that are in lanes. If one of them fails or has an event, all leave the lanes at the
    /// last step that all have completed; returns the number of remaining steps.
    fn step_lanes(&mut self, steps: usize, inputs: &[f64]) -> usize {
        let SharedLanes::Built(together) = &mut self.lanes else { return 0 };
        let Some(first) = self.in_lanes.iter().position(|&it| it) else { return 0 };
        let (wide, last) = (self.inputs.len(), self.alone.len() - 1);
        let source: [usize; LANES] =
            core::array::from_fn(|lane| if self.in_lanes[lane.min(last)] { lane.min(last) } else { first });
        for (i, &input) in self.inputs.iter().enumerate() {
            together.simulation.put_input(input, Lanes::new(source.map(|k| inputs[k * wide + i])));
        }
        let start = together.simulation.state().steps;
        if together.simulation.step(steps).is_ok() {
            return 0;
        }
        let taken = (together.simulation.state().steps - start) as usize;
        self.leave_lanes();
        steps - taken
    }

    fn leave_lanes(&mut self) {
        (0..self.alone.len()).for_each(|k| self.take_from_lane(k));
        self.in_lanes.fill(false);
    }

    /// Puts copies with equal time and equal modes into lanes.
    fn join(&mut self) {
        let waits = |group: &Self, k: usize| !group.in_lanes[k] && group.failed[k].is_none();
        let count = self.alone.len();
        if count < 2 || matches!(self.lanes, SharedLanes::Impossible) || !(0..count).any(|k| waits(self, k)) {
            return;
        }
        if self.in_lanes.iter().filter(|&&it| it).count() < 2 {
            self.leave_lanes();
        }
        let leader = match &self.lanes {
            SharedLanes::Built(together) if self.in_lanes.contains(&true) => {
                let joins = |k: usize| waits(self, k) && self.alone[k].is_level_with(&together.simulation);
                if !(0..count).any(joins) {
                    return;
                }
                self.in_lanes.iter().position(|&it| it)
            }
            _ => self.leader(),
        };
        let Some(leader) = leader else { return };
        self.leave_lanes();
        self.build_lanes();
        let SharedLanes::Built(together) = &mut self.lanes else { return };
        for k in 0..count {
            self.in_lanes[k] = self.failed[k].is_none() && self.alone[k].is_level_with(&self.alone[leader]);
        }
        // Empty lanes, and the lane of a copy at another time, repeat a copy that is in the lanes.
        let source = |lane: usize| if self.in_lanes[lane.min(count - 1)] { lane.min(count - 1) } else { leader };
        together.simulation.fill_lanes(core::array::from_fn(|lane| &self.alone[source(lane)]));
    }

    /// Returns a copy whose time equals that of as many others as possible; `None` if all times differ.
    fn leader(&self) -> Option<usize> {
        let count = self.alone.len();
        let level = |k: usize| {
            let with = |&other: &usize| self.failed[other].is_none() && self.alone[k].is_level_with(&self.alone[other]);
            (0..count).filter(with).count()
        };
        let running = (0..count).filter(|&k| self.failed[k].is_none()).map(|k| (level(k), count - k));
        running.max().filter(|(others, _)| *others > 1).map(|(_, k)| count - k)
    }

    fn build_lanes(&mut self) {
        if !matches!(self.lanes, SharedLanes::NotBuilt) {
            return;
        }
        self.lanes = SharedLanes::Impossible;
        let fits = self.members.iter().all(|member| fits_lanes(&member.setup));
        if !fits || self.inputs.iter().any(|&input| self.alone[0].switches_modes(input)) {
            return;
        }
        let scenarios: Vec<_> = self.members.iter().map(|member| &member.scenario).collect();
        let setups: Vec<_> = self.members.iter().map(|member| &member.setup).collect();
        let Ok(setup) = side_by_side(&scenarios, &setups) else { return };
        let simulation = Simulation::recursive_with(setup, self.keeps_ledger);
        let readings = simulation.readings(&self.columns);
        let read = Vec::with_capacity(self.columns.len());
        self.lanes = SharedLanes::Built(Box::new(Together { simulation, readings, read }));
    }

    /// Writes the columns and the status of every copy.
    fn read(&mut self, columns: &mut [f64], status: &mut [Status]) {
        if let SharedLanes::Built(together) = &mut self.lanes
            && self.in_lanes.contains(&true)
        {
            together.simulation.read(&mut together.readings, &mut together.read);
        }
        let own = columns.chunks_mut(self.asked).zip(status);
        for (k, (own, status)) in own.enumerate().take(self.alone.len()) {
            match &self.lanes {
                SharedLanes::Built(together) if self.in_lanes[k] => {
                    self.read.clear();
                    self.read.extend(together.read.iter().map(|value| value.to_array()[k]));
                }
                _ => self.alone[k].read(&mut self.readings, &mut self.read),
            }
            own.copy_from_slice(&self.read[..self.asked]);
            if self.failed[k].is_none() {
                self.check_read(k);
            }
            *status = if self.failed[k].is_some() { Status::Failed } else { self.beyond_limit(k) };
        }
    }

    /// Marks a copy as failed if its columns are not finite.
    fn check_read(&mut self, k: usize) {
        let Some(bad) = self.read.iter().position(|value| !value.is_finite()) else { return };
        let (time_s, column) = (self.time_s(k), self.columns[bad].clone());
        self.take_from_lane(k);
        self.in_lanes[k] = false;
        self.failed[k] = Some(RunError::NoNumber { time_s, column, value: self.read[bad] });
    }

    fn beyond_limit(&self, k: usize) -> Status {
        if !self.watches {
            return Status::Running;
        }
        let (limits, time_s) = (&self.members[k].setup.limits, self.read[self.asked]);
        let (values, step) = self.read[self.asked + 1..].split_at(limits.len());
        let mut beyond = limits.iter().zip(values).enumerate().filter(|(_, (limit, value))| {
            limit.is_of_each_row()
                && limit.applies(time_s, step.first().copied())
                && limit.margin(**value / limit.unit.1) < 0.0
        });
        beyond.next().map_or(Status::Running, |(i, _)| Status::BeyondLimit(i))
    }
}
