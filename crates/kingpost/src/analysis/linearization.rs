//! Linearised system about a state: `x' = A x + B u`, with A and B exact to rounding.

use crate::elements::{EvaluationMode, Input, StateDeclaration};
use crate::integrate::Stage;
use crate::ledger;
use crate::model::MotionType;
use crate::plant::{Along, DIRECTIONS, Number, Plant, Tangent};
use crate::scenario::{BuiltScenario, Scenario, ScenarioError};
use crate::simulation::{Setup, Simulation};
use nalgebra::{DMatrix, DVector};
use serde::Serialize;

/// A and B about a state, and the rates at this state.
///
/// The states x are small motions from the state: first the local coordinates of the free coordinates (m;
/// rad, for a rotation in space the rotation vector in body axes), then their rates as in v, then the states
/// of forces and drives. Held and prescribed coordinates are not states; prescribed coordinates keep their
/// motion. With closed loops x contains all coordinates of the tree, and only motions with J x = 0 are
/// possible, with J of [`MovingFrame::j`](crate::dynamics::moving_frame::MovingFrame::j); about a state at
/// rest, A maps a possible motion to a possible motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Linearization {
    /// Names of the states: `slew`, ..., `slew.rate`, ..., and the states of drives, as `luffing.wanted_length`.
    pub states: Vec<String>,
    /// SI unit of each state.
    pub units: Vec<&'static str>,
    /// Whether each state is only a memory, as an element [declares](crate::elements::ElementState) it.
    pub remembers: Vec<bool>,
    /// Whether explicit schemes leave each state to its element, which advances it implicitly.
    pub advanced: Vec<bool>,
    /// Names of the inputs.
    pub inputs: Vec<String>,
    /// Unit of each input.
    pub input_units: Vec<&'static str>,
    /// A: derivative of the rate of the row's state with respect to the column's state.
    pub a: DMatrix<f64>,
    /// B: derivative of the rate of the row's state with respect to the column's input.
    pub b: DMatrix<f64>,
    /// The rates at the state itself; zero at an equilibrium.
    pub rates: Vec<f64>,
    /// The time of the state, s.
    pub time_s: f64,
    /// Names of the prescribed coordinates that move or accelerate at that time.
    pub moving: Vec<String>,
}

/// Names and units of a [`Linearization`], for programs in other languages.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LinearNames<'a> {
    /// Names of the states.
    pub states: &'a [String],
    /// SI unit of each state.
    pub units: &'a [&'static str],
    /// Whether each state is only a memory.
    pub remembers: &'a [bool],
    /// Whether explicit schemes leave each state to its element.
    pub advanced: &'a [bool],
    /// Names of the inputs.
    pub inputs: &'a [String],
    /// Unit of each input.
    pub input_units: &'a [&'static str],
    /// See [`Linearization::warning`].
    pub warning: Option<String>,
}

impl Linearization {
    /// Returns the names and units.
    pub fn names(&self) -> LinearNames<'_> {
        let Self { states, units, remembers, advanced, inputs, input_units, .. } = self;
        LinearNames { states, units, remembers, advanced, inputs, input_units, warning: self.warning() }
    }

    /// Returns a warning if a prescribed coordinate moves: A is then valid for one instant only, and
    /// eigenvalues can show growth or damping that only the forces of this motion cause.
    pub fn warning(&self) -> Option<String> {
        let names = self.moving.join(", ");
        let verbs = if self.moving.len() == 1 { "moves or accelerates" } else { "move or accelerate" };
        (!self.moving.is_empty()).then(|| {
            format!(
                "{names} {verbs} as prescribed at {} s: the matrices are valid for that instant only; damping ratios and growth may come from the prescribed motion alone",
                self.time_s
            )
        })
    }

    /// Returns the number of free coordinates: the states start with these coordinates, followed by their
    /// rates.
    fn free(&self) -> usize {
        self.states.iter().filter(|state| state.ends_with(RATE)).count()
    }

    /// Returns the accelerations of the free coordinates at the state itself, m/s^2 or rad/s^2.
    pub fn accelerations(&self) -> DVector<f64> {
        let n = self.free();
        DVector::from_column_slice(&self.rates[n..2 * n])
    }

    /// Returns the derivatives of the accelerations of the free coordinates with respect to these
    /// coordinates: a block of A.
    pub fn stiffness(&self) -> DMatrix<f64> {
        let n = self.free();
        self.a.view((n, 0), (n, n)).into_owned()
    }
}

/// Ending of the name of a coordinate's rate.
const RATE: &str = ".rate";

/// Linearises the simulations of one scenario.
#[derive(Clone, Debug)]
pub struct Linearizer {
    tangent: Tangent,
    states: Vec<StateDeclaration>,
    inputs: Vec<Input>,
    /// Variable of each state.
    along: Vec<Along>,
    /// The prescribed coordinates, with their names.
    prescribed: Vec<(usize, String)>,
}

impl Linearizer {
    /// Creates a linearizer for simulations of a scenario. The equations have the recursive form.
    ///
    /// # Errors
    /// A scenario that does not build.
    pub fn new(scenario: &Scenario) -> Result<Self, ScenarioError> {
        Ok(Self::of_setup(scenario.setup_over::<Number>()?))
    }

    /// Creates a linearizer for simulations of a scenario that is built.
    ///
    /// # Errors
    /// Fails where [`Scenario::setup_over`] does.
    pub fn of_built(built: &BuiltScenario) -> Result<Self, ScenarioError> {
        Ok(Self::of_setup(built.dual_setup()?.clone()))
    }

    fn of_setup(setup: Setup<Number>) -> Self {
        Self::of_plant(Plant::new(setup.model, setup.world, setup.elements))
    }

    /// Creates a linearizer for simulations of this plant.
    pub fn of_plant(plant: Plant<Number>) -> Self {
        let inputs = plant.layout().inputs.clone();
        let (states, along) = states(&plant);
        let prescribed = prescribed(&plant);
        Self { tangent: Tangent::new(plant), states, inputs, along, prescribed }
    }

    /// Returns the linearizer for rest: without waves, and with prescribed coordinates held.
    pub fn at_rest(mut self) -> Self {
        self.tangent.set_evaluation_mode(EvaluationMode::AtRest);
        self
    }

    /// Returns the linearizer for the same state in calm water, which costs less.
    pub fn in_calm_water(mut self) -> Self {
        self.tangent.calm();
        self
    }

    /// Returns the indices in v of the free coordinates, in the order of the states.
    pub fn positions(&self) -> impl Iterator<Item = usize> + '_ {
        self.along.iter().filter_map(|along| if let Along::Position(i) = along { Some(*i) } else { None })
    }

    /// Returns the variable of each state.
    pub(super) fn along(&self) -> &[Along] {
        &self.along
    }

    /// Returns A and B at the present state of a simulation of the scenario.
    pub fn at(&mut self, simulation: &Simulation) -> Linearization {
        self.about(simulation.stage())
    }

    /// Returns A and B at a stage.
    pub fn about(&mut self, at: Stage<'_>) -> Linearization {
        let (n, m) = (self.states.len(), self.inputs.len());
        let mut derivatives = DMatrix::zeros(n, n + m);
        let mut rates = vec![0.0; n];
        let still = vec![0.0; at.v.len()];
        self.tangent.watch_loops(at.q);
        let all: Vec<Along> = self.along.iter().copied().chain((0..m).map(Along::Input)).collect();
        for (chunk, directions) in all.chunks(DIRECTIONS).enumerate() {
            self.tangent.evaluate(at.q, &still, at, directions);
            for (row, state) in self.along.iter().enumerate() {
                let rate = self.tangent.rate(*state);
                rates[row] = rate.value;
                for k in 0..directions.len() {
                    derivatives[(row, chunk * DIRECTIONS + k)] = rate.derivative[k];
                }
            }
        }
        let moving = self.moving(at);
        Linearization {
            states: self.states.iter().map(|state| state.name.clone()).collect(),
            units: self.states.iter().map(|state| state.unit).collect(),
            remembers: self.states.iter().map(|state| state.remembers).collect(),
            advanced: self.states.iter().map(|state| state.advanced).collect(),
            inputs: self.inputs.iter().map(|input| input.name.clone()).collect(),
            input_units: self.inputs.iter().map(|input| input.unit).collect(),
            a: derivatives.columns(0, n).into_owned(),
            b: derivatives.columns(n, m).into_owned(),
            rates,
            time_s: at.time_s,
            moving,
        }
    }

    /// Returns the names of the prescribed coordinates with a rate or an acceleration at a stage.
    fn moving(&mut self, at: Stage<'_>) -> Vec<String> {
        let (rates, accelerations) = self.tangent.prescribed(at.interval, at.v.len());
        let moves = |i: usize| at.v[i] != 0.0 || rates[i] != 0.0 || accelerations[i] != 0.0;
        self.prescribed.iter().filter(|(i, _)| moves(*i)).map(|(_, name)| name.clone()).collect()
    }
}

/// Returns the prescribed coordinates of a plant, with their names.
fn prescribed(plant: &Plant<Number>) -> Vec<(usize, String)> {
    let names = plant.model.coordinate_names().into_iter().enumerate();
    names.filter(|(i, _)| plant.model.modes[*i] == MotionType::Prescribed).collect()
}

/// Returns the states of a plant with their names and units, and the variable of each; the states of drives
/// and forces follow the ledger's entries in s.
fn states(plant: &Plant<Number>) -> (Vec<StateDeclaration>, Vec<Along>) {
    let (model, names, turns) = (&plant.model, plant.model.coordinate_names(), plant.model.turning_coordinates());
    let unit = |units: [&'static str; 2], i: usize| units[usize::from(turns[i])];
    let free = model.free_coordinates();
    let positions =
        free.iter().map(|&i| (StateDeclaration::new(names[i].clone(), unit(["m", "rad"], i)), Along::Position(i)));
    let rate = |&i: &usize| StateDeclaration::new(format!("{}{RATE}", names[i]), unit(["m/s", "rad/s"], i));
    let rates = free.iter().map(|i| (rate(i), Along::Velocity(*i)));
    let extras = plant.layout().states.iter().cloned().enumerate();
    let extras = extras.map(|(i, state)| (state, Along::Extra(ledger::COUNT + i)));
    positions.chain(rates).chain(extras).unzip()
}
