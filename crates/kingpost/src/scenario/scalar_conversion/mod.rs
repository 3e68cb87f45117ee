//! A scenario over another scalar: with derivatives, or several scenarios in lanes.
//!
//! A resolved scenario is written out, and some numbers in it become lists of parts: one for each lane, or the value
//! and its derivatives. The types read it back. A plain field refuses a list.

#[cfg(not(target_family = "wasm"))]
mod side_by_side;
mod structure;

#[cfg(not(target_family = "wasm"))]
pub(crate) use side_by_side::side_by_side;

use serde::Deserialize;
use serde_json::Value;

use super::build::assemble;
use super::error::{FieldError, ScenarioError};
use super::leaf::{Leaf, Quantity};
use super::schema::Scenario;
use super::tree::segments;
use super::{units, wording};
use crate::plant::{DIRECTIONS, Number};
use crate::simulation::Setup;

impl Scenario {
    /// The setup of a simulation over another scalar, with all numbers constant.
    ///
    /// # Errors
    /// As [`setup`](Self::setup).
    pub fn setup_over<S: Quantity>(&self) -> Result<Setup<S>, ScenarioError> {
        self.setup_over_with(&self.setup()?)
    }

    /// The same; `alone` is the scenario's own setup.
    pub(crate) fn setup_over_with<S: Quantity>(&self, alone: &Setup) -> Result<Setup<S>, ScenarioError> {
        let scenario = self.over::<S>(&self.written()).map_err(|error| untyped(&error))?;
        Ok(assemble(&scenario, &vec![alone; S::SCENARIOS])?)
    }

    /// The setup of a simulation with derivatives along parameters: direction k is the parameter, or the path of a
    /// number, `names[k]`, in the unit of its path.
    ///
    /// A name stands for the fields that it writes. The derivative of each field is the factor of its unit; everything
    /// computed from them has the derivative of the formula.
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
    /// A name that is no parameter and no path of a number, or a number that decides the structure, the switching times
    /// of laws, or the stepping of the run.
    ///
    /// # Panics
    /// When there are more than [`DIRECTIONS`] names.
    pub fn setup_along(&self, names: &[&str]) -> Result<Setup<Number>, ScenarioError> {
        self.setup_along_with(&self.setup()?, names)
    }

    /// The same; `alone` is the scenario's own setup.
    pub(crate) fn setup_along_with(&self, alone: &Setup, names: &[&str]) -> Result<Setup<Number>, ScenarioError> {
        assert!(names.len() <= DIRECTIONS, "at most as many names as directions");
        let (mut written, mut seeds) = (self.written(), Vec::new());
        for (direction, name) in names.iter().enumerate() {
            for path in self.paths_of(name) {
                let (path, factor) = units::si_path(&segments(&path));
                let dotted = path.join(".");
                let seeded = seeds.iter().any(|(known, _)| *known == dotted);
                seed(&mut written, &path, seeded, (direction, factor))
                    .ok_or_else(|| FieldError::new(*name, wording::NO_NUMBER, wording::CONTINUOUS))?;
                seeds.push((dotted, *name));
            }
        }
        let scenario = self.over(&written).map_err(|error| self.refused_by_types(&seeds, &error))?;
        Ok(assemble(&scenario, &[alone]).map_err(|error| refused(&seeds, error))?)
    }

    /// The paths that a parameter writes; for any other name, the name itself.
    fn paths_of(&self, name: &str) -> Vec<String> {
        let parameter = self.parameters.iter().find(|parameter| parameter.name == name);
        parameter.map_or_else(|| vec![name.to_owned()], |parameter| parameter.writes.clone())
    }

    /// The resolved scenario as a tree of values.
    pub(super) fn written(&self) -> Value {
        serde_json::to_value(self).unwrap_or_default()
    }

    /// The scenario over another scalar. Its error has no path: a reader that keeps one would have the compiler make all
    /// types over once more for each scalar.
    pub(super) fn over<S: Leaf>(&self, written: &Value) -> Result<Scenario<S>, serde_json::Error> {
        Ok(Scenario { files: self.files.clone(), ..Scenario::deserialize(written)? })
    }

    /// The error of a plain field with derivatives, reported for the name that gave them.
    fn refused_by_types(&self, seeds: &[(String, &str)], error: &serde_json::Error) -> FieldError {
        let is_plain = |path: &str| {
            let mut written = self.written();
            seed(&mut written, &segments(path), false, (0, 1.0));
            self.over::<Number>(&written).is_err()
        };
        match seeds.iter().find(|(path, _)| is_plain(path)) {
            Some((_, name)) => FieldError::new(*name, wording::NO_DERIVATIVE, wording::CONTINUOUS),
            None => untyped(error),
        }
    }
}

pub(super) fn untyped(error: &serde_json::Error) -> FieldError {
    FieldError::new("", error, wording::REQUIRED)
}

/// An error of a field with derivatives, reported for the name that gave them; other errors unchanged.
fn refused(seeds: &[(String, &str)], error: FieldError) -> FieldError {
    let seeded = seeds.iter().find(|(path, _)| *path == error.field);
    let within = || seeds.iter().find(|(path, _)| !error.field.is_empty() && path.starts_with(&error.field));
    match seeded.or_else(within) {
        Some((_, name)) => FieldError::new(*name, wording::NO_DERIVATIVE, wording::CONTINUOUS),
        None => error,
    }
}

/// Gives the number at a path derivatives, unless it has them, and adds the derivative along a direction. `None` if
/// there is no number.
fn seed(written: &mut Value, path: &[String], seeded: bool, (direction, factor): (usize, f64)) -> Option<()> {
    let slot = written.pointer_mut(&format!("/{}", path.join("/")))?;
    if !seeded {
        let value = slot.is_number().then(|| slot.take())?;
        let parts = core::iter::once(value).chain((0..DIRECTIONS).map(|_| Value::from(0.0)));
        *slot = parts.collect();
    }
    let derivative = slot.as_array_mut()?.get_mut(1 + direction)?;
    *derivative = Value::from(derivative.as_f64()? + factor);
    Some(())
}
