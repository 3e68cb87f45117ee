//! A scenario together with its setup.

use std::sync::OnceLock;

use serde_json::Value;

use super::describe::Description;
use super::error::ScenarioError;
use super::files::Files;
use super::read::Parsed;
use super::schema::Scenario;
use crate::plant::Number;
use crate::simulation::{Setup, Simulation};

/// A scenario that is read and built once, and from which simulations, the description, hydrostatics and
/// analyses are made. They do not change it and do not affect each other.
///
/// ```
/// use kingpost::scenario::{BuiltScenario, Files};
/// let text = include_str!("../../../../scenarios/paper.yaml");
/// let built = BuiltScenario::read(text, "paper.yaml", &[], &Files::default())?;
/// let (mut one, other) = (built.simulation()?, built.simulation()?);
/// one.step(10).expect("ten steps do not diverge");
/// assert_eq!((one.time_s(), other.time_s()), (0.01, 0.0));
/// assert_eq!(built.describe().bodies.len(), 3);
/// # Ok::<(), kingpost::scenario::ScenarioError>(())
/// ```
#[derive(Debug)]
pub struct BuiltScenario {
    scenario: Scenario,
    setup: Setup,
    /// Setup over dual numbers; built at first use.
    dual: OnceLock<Setup<Number>>,
    /// Description; made at first use.
    description: OnceLock<Description>,
}

impl BuiltScenario {
    /// Reads a scenario like [`read_with`](super::read_with), and keeps the setup that it builds for
    /// validation.
    ///
    /// # Errors
    /// Fails where [`read_with`](super::read_with) does.
    pub fn read(text: &str, file: &str, overrides: &[(String, Value)], files: &Files) -> Result<Self, ScenarioError> {
        let (scenario, setup) = Parsed::new(text, file)?.read_and_build(overrides, files)?;
        Ok(Self::of(scenario, setup))
    }

    fn of(scenario: Scenario, setup: Setup) -> Self {
        Self { scenario, setup, dual: OnceLock::new(), description: OnceLock::new() }
    }

    /// Returns the scenario.
    pub fn scenario(&self) -> &Scenario {
        &self.scenario
    }

    /// Returns the setup.
    pub fn setup(&self) -> &Setup {
        &self.setup
    }

    /// Returns the setup over dual numbers, all of them constant.
    ///
    /// # Errors
    /// Fails where [`Scenario::setup_over`] does.
    pub fn dual_setup(&self) -> Result<&Setup<Number>, ScenarioError> {
        if let Some(made) = self.dual.get() {
            return Ok(made);
        }
        let made = self.scenario.setup_over_with(&self.setup)?;
        Ok(self.dual.get_or_init(|| made))
    }

    /// Returns a simulation at time 0, like [`Scenario::simulation`].
    ///
    /// # Errors
    /// Fails where [`Scenario::simulation`] does.
    pub fn simulation(&self) -> Result<Simulation, ScenarioError> {
        #[cfg_attr(target_family = "wasm", expect(unused_mut))]
        let mut simulation = Simulation::new(self.setup.clone());
        #[cfg(not(target_family = "wasm"))]
        if self.setup.settings.wants_derivatives() {
            simulation.differentiate_with(self.dual_setup()?.clone());
        }
        Ok(simulation)
    }

    /// Returns the description, like [`Scenario::describe`].
    pub fn describe(&self) -> &Description {
        self.description.get_or_init(|| self.scenario.description_of(&self.setup))
    }
}

impl Scenario {
    /// Returns the scenario with its setup.
    ///
    /// # Errors
    /// Fails where [`setup`](Self::setup) does.
    pub fn build(self) -> Result<BuiltScenario, ScenarioError> {
        let setup = self.setup()?;
        Ok(BuiltScenario::of(self, setup))
    }
}

impl From<BuiltScenario> for Scenario {
    fn from(built: BuiltScenario) -> Self {
        built.scenario
    }
}
