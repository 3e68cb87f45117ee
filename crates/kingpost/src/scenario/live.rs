//! Changes of parameters during a run.

use serde_json::Value;
use thiserror::Error;

use crate::elements::AnyElement;
use crate::scenario::built::BuiltScenario;
use crate::scenario::error::ScenarioError;
use crate::scenario::schema::{LIVE_SETTINGS, Scenario, Shape};
use crate::scenario::{read, wording};
use crate::simulation::Simulation;

/// A parameter that cannot be set during a run.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum ParameterError {
    /// There is no parameter with this name.
    #[error("parameter {found}: no such parameter, allowed: {allowed}")]
    Unknown {
        /// The name that was given.
        found: String,
        /// The parameters that can be set during a run.
        allowed: String,
    },
    /// The parameter is not `live`.
    #[error("parameter {name}: takes effect at the start of a run, allowed during a run: {allowed}")]
    AtReset {
        /// The parameter.
        name: String,
        /// The parameters that can be set during a run.
        allowed: String,
    },
    /// The run cannot continue with this value.
    #[error("parameter {name}: found {found}, {why}; allowed: a restart with it")]
    Restart {
        /// The parameter.
        name: String,
        /// The value.
        found: String,
        /// Reason for the restart.
        why: &'static str,
    },
    /// The scenario refuses the value.
    #[error(transparent)]
    Scenario(#[from] Box<ScenarioError>),
}

impl Scenario {
    /// Sets a `live` parameter, or one of [`LIVE_SETTINGS`], and lets a simulation of this scenario continue
    /// with it: time, motion, states and inputs are kept, and the change of energy is entered in the ledger.
    /// The integrator restarts, so the run continues like a run of the changed scenario from this state; a
    /// reset returns to the start of the changed scenario.
    ///
    /// Snapshots from before the change are valid only for the old scenario: setting the old value makes them
    /// valid again.
    ///
    /// # Errors
    /// The name is not a live parameter, the value is not allowed, or it changes the structure of the run,
    /// which needs a restart. Nothing changes then.
    pub fn set_parameter(
        &mut self,
        simulation: &mut Simulation,
        name: &str,
        value: &Value,
    ) -> Result<(), ParameterError> {
        *self = self.go_on_with(simulation, name, value)?.into();
        Ok(())
    }

    /// Sets a live parameter in a simulation, and returns the changed scenario with its setup. It builds the
    /// whole setup, with the equilibrium at the start: this finds every error, and numbers of the setup can
    /// depend on the start.
    fn go_on_with(
        &self,
        simulation: &mut Simulation,
        name: &str,
        value: &Value,
    ) -> Result<BuiltScenario, ParameterError> {
        self.check_live(name)?;
        let next = read::changed(self, name, value).map_err(Box::new)?;
        let restart = |why| ParameterError::Restart { name: name.to_owned(), found: wording::found(value), why };
        let switches = self.switches(name);
        let structure = |of: &Self| of.structure(&switches);
        if !LIVE_SETTINGS.contains(&name) && structure(&next) != structure(self) {
            return Err(restart("which changes the structure of the run"));
        }
        if self.shapes() != next.shapes() {
            return Err(restart("which changes the shape of a body"));
        }
        let next = next.build().map_err(Box::new)?;
        let changed = next.simulation().map_err(Box::new)?;
        if carried(simulation, simulation.time_s()) != carried(&changed, simulation.time_s()) {
            return Err(restart("which moves a body to another place in the waves"));
        }
        simulation.go_on_as(changed, name).map_err(restart)?;
        Ok(next)
    }

    /// Returns the switches of forces and drives that a parameter sets. A run continues with them if columns, states and
    /// inputs remain.
    fn switches(&self, name: &str) -> Vec<&str> {
        let writes = self.parameters.iter().filter(|parameter| parameter.name == name).flat_map(|one| &one.writes);
        let is_switch =
            |path: &&str| (path.starts_with("forces.") || path.starts_with("drives.")) && path.ends_with(".enabled");
        writes.map(String::as_str).filter(is_switch).collect()
    }

    /// Returns the shapes, which views draw only once.
    fn shapes(&self) -> Vec<Option<&Shape>> {
        self.bodies.values().map(|body| body.shape.as_ref()).collect()
    }

    fn check_live(&self, name: &str) -> Result<(), ParameterError> {
        if LIVE_SETTINGS.contains(&name) {
            return Ok(());
        }
        let live = self.parameters.iter().filter(|p| p.live).map(|p| p.name.as_str());
        let allowed = || live.chain(LIVE_SETTINGS).collect::<Vec<_>>().join(", ");
        match self.parameters.iter().find(|parameter| parameter.name == name) {
            Some(parameter) if parameter.live => Ok(()),
            Some(_) => Err(ParameterError::AtReset { name: name.to_owned(), allowed: allowed() }),
            None => Err(ParameterError::Unknown { found: name.to_owned(), allowed: allowed() }),
        }
    }
}

impl BuiltScenario {
    /// Sets a parameter in a simulation of this scenario, like [`Scenario::set_parameter`], and returns the
    /// changed scenario.
    ///
    /// # Errors
    /// Fails where [`Scenario::set_parameter`] does.
    pub fn set_parameter(
        &self,
        simulation: &mut Simulation,
        name: &str,
        value: &Value,
    ) -> Result<Self, ParameterError> {
        self.scenario().go_on_with(simulation, name, value)
    }
}

/// Returns the positions of the bodies whose motion follows the waves.
fn carried(simulation: &Simulation, time_s: f64) -> Vec<[f64; 6]> {
    let given = |element: &AnyElement| element.given_positions(simulation.world(), time_s);
    simulation.elements().iter().filter_map(given).map(|(_, positions)| positions).collect()
}
