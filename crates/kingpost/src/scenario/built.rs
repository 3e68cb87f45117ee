//! A scenario with the setup that its check made.

use std::sync::OnceLock;

use serde_json::Value;

use super::describe::Description;
use super::error::ScenarioError;
use super::files::Files;
use super::read::Parsed;
use super::schema::Scenario;
use crate::plant::Number;
use crate::simulation::{Setup, Simulation};

/// A scenario that is read and built once, for all that is made of it: simulations, its description, hydrostatics and
/// analyses. None of them changes it, or another of them.
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
    /// The setup over dual numbers, once something has asked for it.
    dual: OnceLock<Setup<Number>>,
    /// The description, once something has asked for it.
    description: OnceLock<Description>,
}

impl BuiltScenario {
    /// Reads a scenario as [`read_with`](super::read_with), and keeps the setup that validates it.
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

    /// The scenario.
    pub fn scenario(&self) -> &Scenario {
        &self.scenario
    }

    /// Its setup.
    pub fn setup(&self) -> &Setup {
        &self.setup
    }

    /// Its setup over dual numbers, all of them constant.
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

    /// A simulation at time 0, as [`Scenario::simulation`].
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

    /// The description, as [`Scenario::describe`].
    pub fn describe(&self) -> &Description {
        self.description.get_or_init(|| self.scenario.description_of(&self.setup))
    }
}

impl Scenario {
    /// The scenario with its setup.
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
