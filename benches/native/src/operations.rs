//! Measured operations.

use crate::Outcome;
use kingpost::elements::AnyElement;
use kingpost::elements::drives::Motor;
use kingpost::integrate::{Interval, Scheme, Sizes, Stage, System};
use kingpost::plant::Plant;
use kingpost::scalar::{LANES, Lanes, Scalar};
use kingpost::scenario::{self, Files, Scenario};
use kingpost::simulation::{Setup, Simulation};
use kingpost::state::State;
use std::collections::BTreeMap;
use std::hint::black_box;
use std::time::Instant;

const STEP_S: f64 = 1e-3;

/// One operation on one fixed state.
pub trait Operation {
    /// Returns to the fixed state.
    fn reset(&mut self) -> Outcome<()>;
    /// Repeats the operation a number of times.
    fn repeat(&mut self, times: usize) -> Outcome<()>;
    /// Returns the result: an acceleration, or q and v.
    fn result(&self) -> Vec<f64>;
    /// Returns the time per repetition, for a number of repetitions from the fixed state.
    fn time(&mut self, times: usize) -> Outcome<f64> {
        self.reset()?;
        let start = Instant::now();
        self.repeat(times)?;
        Ok(start.elapsed().as_nanos() as f64 / times as f64)
    }
}

/// A model at a state.
pub struct Task {
    scenario: Scenario,
    setup: Setup,
    q: Vec<f64>,
    v: Vec<f64>,
    force: Vec<f64>,
}

impl Task {
    /// Reads a resolved scenario, the files that it names as a JSON object of texts, and a state with the
    /// lines `q ...`, `v ...` and `force ...`.
    pub fn read(scenario: &str, files: &str, state: &str) -> Outcome<Self> {
        let files = serde_json::from_str::<BTreeMap<String, String>>(files)?;
        let scenario = scenario::read_with(scenario, "kingpost.json", &[], &Files::new(files))?;
        let setup = scenario.setup()?;
        let [q, v, force] = ["q", "v", "force"].map(|word| numbers(state, word));
        Ok(Self { scenario, setup, q: q?, v: v?, force: force? })
    }

    /// Returns the operation of that name on this task.
    pub fn operation(self, name: &str) -> Outcome<Box<dyn Operation>> {
        match name {
            "forward" => Ok(Box::new(Forward::new(self))),
            "euler_step" => Ok(Box::new(Step::new(self, Scheme::forward_euler))),
            "rk4_step" => Ok(Box::new(Step::new(self, Scheme::runge_kutta_4))),
            "lanes_euler" => Ok(Box::new(SideBySide::new(self, Scheme::forward_euler)?)),
            "lanes_rk4" => Ok(Box::new(SideBySide::new(self, Scheme::runge_kutta_4)?)),
            "rk4_step_ledger" => Ok(Box::new(Shipped::new(self))),
            other => Err(format!("unknown operation {other}").into()),
        }
    }
}

/// Returns the numbers of the line that begins with this word.
fn numbers(text: &str, word: &str) -> Outcome<Vec<f64>> {
    let line = text.lines().find_map(|line| line.strip_prefix(word)?.strip_prefix(' '));
    let line = line.ok_or_else(|| format!("the state has no line {word}"))?;
    Ok(line.split_whitespace().map(str::parse).collect::<Result<_, _>>()?)
}

/// Forward dynamics under the scenario's forces and a given force along each coordinate: sine and cosine,
/// kinematics, accelerations.
struct Forward {
    plant: Plant,
    q: Vec<f64>,
    v: Vec<f64>,
    force: Vec<f64>,
    v_dot: Vec<f64>,
}

impl Forward {
    /// The force replaces the drives.
    fn new(Task { setup, q, v, force, .. }: Task) -> Self {
        let is_motor = |element: &AnyElement| (**element).as_any().is::<Motor>();
        let elements = setup.elements.into_iter().filter(|element| !is_motor(element)).collect();
        let mut plant = Plant::new(setup.model, setup.world, elements);
        plant.keep_ledger(false);
        let v_dot = vec![0.0; v.len()];
        Self { plant, q, v, force, v_dot }
    }
}

impl Operation for Forward {
    fn reset(&mut self) -> Outcome<()> {
        Ok(())
    }

    fn repeat(&mut self, times: usize) -> Outcome<()> {
        for _ in 0..times {
            let Self { plant, q, v, force, v_dot } = black_box(&mut *self);
            let interval = Interval { start_s: 0.0, end_s: STEP_S };
            let stage = Stage { time_s: 0.0, interval, q, v, s: &[], d: &[], m: &[] };
            plant.acceleration(stage, Some(force), v_dot);
        }
        Ok(())
    }

    fn result(&self) -> Vec<f64> {
        self.v_dot.clone()
    }
}

/// One step of the plant without its ledger.
struct Step {
    plant: Plant,
    scheme: Scheme,
    start: State,
    state: State,
}

impl Step {
    /// Makes the plant with its forces and drives.
    fn new(Task { setup, q, v, .. }: Task, scheme: fn(Sizes) -> Scheme) -> Self {
        let mut plant = Plant::new(setup.model, setup.world, setup.elements);
        plant.keep_ledger(false);
        let scheme = scheme(plant.sizes());
        let start = State { q, v, ..State::default() };
        Self { plant, scheme, state: start.clone(), start }
    }
}

impl Operation for Step {
    fn reset(&mut self) -> Outcome<()> {
        self.state.clone_from(&self.start);
        Ok(())
    }

    fn repeat(&mut self, times: usize) -> Outcome<()> {
        for _ in 0..times {
            let Self { plant, scheme, state, .. } = black_box(&mut *self);
            let start_s = state.steps as f64 * STEP_S;
            state.steps += 1;
            let interval = Interval { start_s, end_s: state.steps as f64 * STEP_S };
            scheme.step(plant, interval, f64::INFINITY, state)?;
        }
        Ok(())
    }

    fn result(&self) -> Vec<f64> {
        [self.state.q.as_slice(), &self.state.v].concat()
    }
}

/// One step of as many runs as there are lanes; no ledger.
struct SideBySide {
    plant: Plant<Lanes>,
    scheme: Scheme<Lanes>,
    start: State<Lanes>,
    state: State<Lanes>,
}

impl SideBySide {
    /// Starts all lanes from one state, with a velocity larger by a thousandth in each lane.
    fn new(Task { scenario, q, v, .. }: Task, scheme: fn(Sizes) -> Scheme<Lanes>) -> Outcome<Self> {
        let setup = scenario.setup_over::<Lanes>()?;
        let mut plant = Plant::new(setup.model, setup.world, setup.elements);
        plant.keep_ledger(false);
        let scheme = scheme(plant.sizes());
        let q = q.into_iter().map(Lanes::constant).collect();
        let faster = |v: f64| Lanes::new(std::array::from_fn(|k| v * (1.0 + 1e-3 * k as f64)));
        let start = State { q, v: v.into_iter().map(faster).collect(), ..State::default() };
        Ok(Self { plant, scheme, state: start.clone(), start })
    }
}

impl Operation for SideBySide {
    fn reset(&mut self) -> Outcome<()> {
        self.state.clone_from(&self.start);
        Ok(())
    }

    fn repeat(&mut self, times: usize) -> Outcome<()> {
        for _ in 0..times / LANES {
            let Self { plant, scheme, state, .. } = black_box(&mut *self);
            let start_s = state.steps as f64 * STEP_S;
            state.steps += 1;
            let interval = Interval { start_s, end_s: state.steps as f64 * STEP_S };
            scheme.step(plant, interval, f64::INFINITY, state)?;
        }
        Ok(())
    }

    fn result(&self) -> Vec<f64> {
        self.state.q.iter().chain(&self.state.v).map(|x| x.value()).collect()
    }
}

/// One step of the released engine: with the ledger, the limits checked, the last good state kept.
struct Shipped {
    simulation: Simulation,
    q: Vec<f64>,
    v: Vec<f64>,
}

impl Shipped {
    /// The scenario's simulation.
    fn new(Task { setup, q, v, .. }: Task) -> Self {
        Self { simulation: Simulation::new(setup), q, v }
    }
}

impl Operation for Shipped {
    fn reset(&mut self) -> Outcome<()> {
        self.simulation.reset();
        Ok(self.simulation.set_state(&self.q, &self.v, None)?)
    }

    fn repeat(&mut self, times: usize) -> Outcome<()> {
        Ok(self.simulation.step(times)?)
    }

    fn result(&self) -> Vec<f64> {
        let state = self.simulation.state();
        [state.q.as_slice(), &state.v].concat()
    }
}
