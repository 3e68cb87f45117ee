//! Parameters that change while a run goes on.

use serde_json::Value;
use thiserror::Error;

use super::error::ScenarioError;
use super::schema::Scenario;
use super::{read, wording};
use crate::elements::drives::WaveMotion;
use crate::elements::of_kind;
use crate::simulation::Simulation;

/// Settings that can be set during a run like a parameter that is `live`: another integrator moves the same model on.
pub const LIVE_SETTINGS: [&str; 1] = ["simulation.integrator"];

/// A parameter that cannot be set during a run.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum ParameterError {
    /// No parameter of this name.
    #[error("parameter {found}: no such parameter, allowed: {allowed}")]
    Unknown {
        /// What was asked for.
        found: String,
        /// Those that may be set during a run.
        allowed: String,
    },
    /// One that is not `live`.
    #[error("parameter {name}: takes effect where a run begins, allowed during a run: {allowed}")]
    AtReset {
        /// The parameter.
        name: String,
        /// Those that may be set during a run.
        allowed: String,
    },
    /// A value that the run cannot go on with.
    #[error("parameter {name}: found {found}, {why}; allowed: a restart with it")]
    Restart {
        /// The parameter.
        name: String,
        /// The value.
        found: String,
        /// What it does.
        why: &'static str,
    },
    /// A value that the scenario cannot have.
    #[error(transparent)]
    Scenario(#[from] Box<ScenarioError>),
}

impl Scenario {
    /// Sets a parameter that is `live`, or one of [`LIVE_SETTINGS`], and lets a simulation of this scenario go on with it: time, motion, states and
    /// inputs stay, what the change does to energy is booked in the ledger. The integrator begins anew, so that the run
    /// goes on as one of the other scenario that begins from here; a reset leads to the start of that one.
    ///
    /// Snapshots from before the change belong to the scenario as it was: they come back once the value does.
    ///
    /// # Errors
    /// A name that is no live parameter, a value that it may not have, and one that changes the structure of the run: its
    /// name, and that it needs a restart. Nothing has changed then.
    pub fn set_parameter(
        &mut self,
        simulation: &mut Simulation,
        name: &str,
        value: &Value,
    ) -> Result<(), ParameterError> {
        self.check_live(name)?;
        let next = read::changed(self, name, value).map_err(Box::new)?;
        let restart = |why| ParameterError::Restart { name: name.to_owned(), found: wording::found(value), why };
        if !LIVE_SETTINGS.contains(&name) && next.structure() != self.structure() {
            return Err(restart("which changes the structure of the run"));
        }
        let changed = next.simulation().map_err(Box::new)?;
        if carried(simulation, simulation.time_s()) != carried(&changed, simulation.time_s()) {
            return Err(restart("which moves a body to another place in the waves"));
        }
        simulation.go_on_as(changed, name).map_err(restart)?;
        *self = next;
        Ok(())
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

/// Where the waves carry the bodies that move as they say.
fn carried(simulation: &Simulation, time_s: f64) -> Vec<[f64; 6]> {
    let motions = of_kind::<f64, WaveMotion>(simulation.elements());
    motions.map(|motion| motion.at(simulation.world(), time_s).positions).collect()
}
