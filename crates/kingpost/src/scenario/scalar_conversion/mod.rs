//! Conversion of a scenario to another scalar: with derivatives, or several scenarios in lanes.
//! [`OverScalar`] converts the numbers.

mod derivatives;
#[cfg(not(target_family = "wasm"))]
mod lanes;
mod structure;

#[cfg(not(target_family = "wasm"))]
pub(crate) use lanes::side_by_side;

use serde_json::Value;

use super::assembly::assemble;
use super::error::ScenarioError;
use super::leaf::Quantity;
use super::over::{Numbers, OverScalar};
use super::schema::Scenario;
use super::writing::ToValue;
use crate::plant::{DIRECTIONS, Number};
use crate::simulation::Setup;
use derivatives::NumberTangents;

/// Makes each number a constant.
struct Constants;

impl<S: Quantity> Numbers<S> for Constants {
    fn number(&mut self, value: f64) -> S {
        S::literal(value)
    }
}

impl Scenario {
    /// Returns the setup of a simulation over another scalar, with all numbers constant.
    ///
    /// # Errors
    /// As [`setup`](Self::setup).
    pub fn setup_over<S: Quantity>(&self) -> Result<Setup<S>, ScenarioError> {
        self.setup_over_with(&self.setup()?)
    }

    /// Returns the setup of a simulation over another scalar, with all numbers constant; `alone` is the scenario's own
    /// setup.
    pub(crate) fn setup_over_with<S: Quantity>(&self, alone: &Setup) -> Result<Setup<S>, ScenarioError> {
        Ok(assemble(&self.over(&mut Constants), &vec![alone; S::SCENARIOS])?)
    }

    /// Returns the setup of a simulation with derivatives with respect to parameters: direction k is
    /// `names[k]`, a parameter or the path of a number, in the unit of that path.
    ///
    /// A parameter refers to all fields that it writes. The derivative of each field is the factor of its
    /// unit; values computed from the fields have derivatives by the chain rule.
    ///
    /// ```
    /// # let text = include_str!("../../../../../scenarios/paper.yaml");
    /// let scenario = kingpost::scenario::read(text, "paper.yaml", &[])?;
    /// let setup = scenario.setup_along(&["bodies.arm.mass_kg"])?;
    /// let arm = setup.model.body("arm").unwrap();
    /// assert_eq!(setup.model.bodies[arm].mass.derivative[0], 1.0);
    /// # Ok::<(), kingpost::scenario::ScenarioError>(())
    /// ```
    ///
    /// # Errors
    /// A name that is neither a parameter nor the path of a number, or a number that determines the
    /// structure, the switching times of laws, or the stepping of the run.
    ///
    /// # Panics
    /// When there are more than [`DIRECTIONS`] names.
    pub fn setup_along(&self, names: &[&str]) -> Result<Setup<Number>, ScenarioError> {
        self.setup_along_with(&self.setup()?, names)
    }

    /// Returns the setup of [`setup_along`](Self::setup_along); `alone` is the scenario's own setup.
    pub(crate) fn setup_along_with(&self, alone: &Setup, names: &[&str]) -> Result<Setup<Number>, ScenarioError> {
        assert!(names.len() <= DIRECTIONS, "at most as many names as directions");
        let mut tangents = NumberTangents::of(self, names);
        let scenario = self.over(&mut tangents);
        tangents.check(self)?;
        Ok(assemble(&scenario, &[alone]).map_err(|error| tangents.refused(error))?)
    }

    /// Returns the paths that a parameter writes; for any other name, the name itself.
    fn paths_of(&self, name: &str) -> Vec<String> {
        let parameter = self.parameters.iter().find(|parameter| parameter.name == name);
        parameter.map_or_else(|| vec![name.to_owned()], |parameter| parameter.writes.clone())
    }

    /// Returns the resolved scenario as a tree of values.
    pub(super) fn written(&self) -> Value {
        self.to_value()
    }
}
