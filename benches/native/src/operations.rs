//! What is measured.

use crate::Outcome;
use kingpost::drives::{Clock, Drive};
use kingpost::dynamics::{Kinematics, Loads, forward};
use kingpost::integrate::{Interval, Scheme, System};
use kingpost::model::Model;
use kingpost::plant::Plant;
use kingpost::scenario;
use kingpost::simulation::{Setup, Simulation};
use kingpost::state::State;

const STEP_S: f64 = 1e-3;

/// One operation on one fixed state.
pub trait Operation {
    /// Back to the fixed state.
    fn reset(&mut self) -> Outcome<()>;
    /// Does it once.
    fn once(&mut self) -> Outcome<()>;
    /// What came out: an acceleration, or q and v.
    fn result(&self) -> Vec<f64>;
}

/// A model at a state.
pub struct Task {
    setup: Setup,
    q: Vec<f64>,
    v: Vec<f64>,
}

impl Task {
    /// Reads `PATH.json` and `PATH.txt`.
    pub fn read(path: &str) -> Outcome<Self> {
        let (scenario_file, state_file) = (format!("{path}.json"), format!("{path}.txt"));
        let setup = scenario::read(&std::fs::read_to_string(&scenario_file)?, &scenario_file, &[])?
            .setup()?;
        let text = std::fs::read_to_string(state_file)?;
        Ok(Self { setup, q: numbers(&text, "q")?, v: numbers(&text, "v")? })
    }
}

/// The numbers of the line that begins with this word.
fn numbers(text: &str, word: &str) -> Outcome<Vec<f64>> {
    let line = text.lines().find_map(|line| line.strip_prefix(word)?.strip_prefix(' '));
    let line = line.ok_or_else(|| format!("the state has no line {word}"))?;
    Ok(line.split_whitespace().map(str::parse).collect::<Result<_, _>>()?)
}

/// Forward dynamics under constant loads: sine and cosine, kinematics, accelerations.
pub struct Forward {
    model: Model,
    links: Kinematics,
    loads: Loads,
    work: forward::Workspace,
    q: Vec<f64>,
    v: Vec<f64>,
    v_dot: Vec<f64>,
}

impl Forward {
    /// The loads are those of the drives at time zero.
    pub fn new(Task { setup, q, v }: Task) -> Self {
        let Setup { model, drives, .. } = setup;
        let mut loads = Loads::new(&model);
        let clock = Clock { time_s: 0.0, middle_s: 0.0 };
        drives.iter().for_each(|drive: &Drive| drive.apply(clock, &q, &v, &[], &mut loads));
        let links = Kinematics::new(&model.links);
        let work = forward::Workspace::new(&model);
        let v_dot = vec![0.0; v.len()];
        Self { model, links, loads, work, q, v, v_dot }
    }
}

impl Operation for Forward {
    fn reset(&mut self) -> Outcome<()> {
        Ok(())
    }

    #[inline]
    fn once(&mut self) -> Outcome<()> {
        let Self { model, links, loads, work, q, v, v_dot } = self;
        links.update(&model.links, q, v);
        forward::forward_dynamics(model, links, v, loads, work, v_dot);
        Ok(())
    }

    fn result(&self) -> Vec<f64> {
        self.v_dot.clone()
    }
}

/// One RK4 step of the plant without its ledger.
pub struct Step {
    plant: Plant,
    scheme: Scheme,
    start: State,
    state: State,
}

impl Step {
    /// The plant with its forces and drives.
    pub fn new(Task { setup, q, v }: Task) -> Self {
        let mut plant = Plant::new(setup.model, setup.forces, setup.drives, &q);
        plant.keeps_ledger = false;
        let scheme = Scheme::runge_kutta_4(plant.sizes());
        let start = State { q, v, ..State::default() };
        Self { plant, scheme, state: start.clone(), start }
    }
}

impl Operation for Step {
    fn reset(&mut self) -> Outcome<()> {
        self.state.clone_from(&self.start);
        Ok(())
    }

    #[inline]
    fn once(&mut self) -> Outcome<()> {
        let start_s = self.state.steps as f64 * STEP_S;
        self.state.steps += 1;
        let interval = Interval { start_s, end_s: self.state.steps as f64 * STEP_S };
        self.scheme.step(&mut self.plant, interval, &mut self.state);
        Ok(())
    }

    fn result(&self) -> Vec<f64> {
        [self.state.q.as_slice(), &self.state.v].concat()
    }
}

/// One step as it ships: with the ledger, the limits checked, the last good state kept.
pub struct Shipped {
    simulation: Simulation,
    q: Vec<f64>,
    v: Vec<f64>,
}

impl Shipped {
    /// The scenario's simulation.
    pub fn new(Task { setup, q, v }: Task) -> Outcome<Self> {
        Ok(Self { simulation: Simulation::new(setup), q, v })
    }
}

impl Operation for Shipped {
    fn reset(&mut self) -> Outcome<()> {
        self.simulation.reset();
        Ok(self.simulation.set_state(&self.q, &self.v, None)?)
    }

    #[inline]
    fn once(&mut self) -> Outcome<()> {
        Ok(self.simulation.step(1)?)
    }

    fn result(&self) -> Vec<f64> {
        let state = self.simulation.state();
        [state.q.as_slice(), &state.v].concat()
    }
}
