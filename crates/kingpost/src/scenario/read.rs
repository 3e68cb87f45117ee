//! Conversion of text to a scenario: parses, renames units, applies parameters and overrides, converts to
//! types, and builds once to validate.

use serde_json::Value;

#[cfg(not(target_family = "wasm"))]
use crate::plant::Number;
use crate::scenario::error::{Fault, ScenarioError};
use crate::scenario::files::Files;
use crate::scenario::parameters::{self, Override, OverrideTarget};
use crate::scenario::schema::{Parameter, Scenario};
use crate::scenario::tree::{ScenarioNode, segments};
use crate::simulation::{Setup, Simulation};

use super::writing::ToValue;
use crate::scenario::reading::{self, check_version};
use crate::scenario::{parse, parts, unit_conversion, wording};

/// Reads a scenario from YAML or JSON.
///
/// `file` is the name that errors carry. `overrides` are names of parameters or dotted paths of fields, each with its
/// value; they are applied in their order, after the defaults of the parameters.
///
/// # Errors
/// The first error, with its place: syntax, an unknown field, a wrong type, a value out of range, or bodies, joints and
/// drives that do not fit together.
pub fn read(text: &str, file: &str, overrides: &[(String, Value)]) -> Result<Scenario, ScenarioError> {
    read_with(text, file, overrides, &Files::default())
}

/// Reads a scenario that names files; see [`file_names`].
///
/// # Errors
/// As [`read`], and a file that is missing or has the wrong contents.
pub fn read_with(
    text: &str,
    file: &str,
    overrides: &[(String, Value)],
    files: &Files,
) -> Result<Scenario, ScenarioError> {
    read_and_build(text, file, overrides, files).map(|(scenario, _)| scenario)
}

/// Reads a scenario and builds the setup of its simulation.
fn read_and_build(
    text: &str,
    file: &str,
    overrides: &[(String, Value)],
    files: &Files,
) -> Result<(Scenario, Setup), ScenarioError> {
    Parsed::new(text, file)?.read_and_build(overrides, files)
}

/// A parsed text, which is read with one set of overrides after another.
#[derive(Clone)]
pub(crate) struct Parsed<'a> {
    file: &'a str,
    tree: ScenarioNode,
    /// Scenario as written, for parameters and overrides; if the text has parts, it depends on the overrides.
    as_written: Option<AsWritten>,
}

/// The scenario before parameters and overrides are applied.
#[derive(Clone)]
struct AsWritten {
    parameters: Vec<Parameter>,
    /// The whole scenario, with every default.
    whole: Value,
}

impl<'a> Parsed<'a> {
    /// # Errors
    /// Those of [`read_with`] that no override changes.
    pub(crate) fn new(text: &str, file: &'a str) -> Result<Self, ScenarioError> {
        let parsed = || {
            let mut tree = parse::parse(text)?;
            check_version(&tree)?;
            let as_written = match tree.field("parts") {
                // In a file with parts, units are converted during mounting.
                Some(_) => None,
                None => {
                    unit_conversion::to_si(&mut tree)?;
                    Some(AsWritten::of(&tree)?)
                }
            };
            Ok(Self { file, tree, as_written })
        };
        parsed().map_err(|fault: Fault| fault.in_file(file))
    }

    /// # Errors
    /// Those of [`read_with`].
    pub(crate) fn read_and_build(
        self,
        overrides: &[(String, Value)],
        files: &Files,
    ) -> Result<(Scenario, Setup), ScenarioError> {
        let file = self.file;
        let (mut scenario, tree) = self.resolved(overrides, files).map_err(|fault| fault.in_file(file))?;
        let built = scenario.take_files(files).and_then(|()| super::assembly::build(&scenario));
        match built {
            Ok(setup) => Ok((scenario, setup)),
            Err(error) => Err(Fault { place: tree.place_of(&segments(&error.field)), error }.in_file(file)),
        }
    }

    fn resolved(self, overrides: &[(String, Value)], files: &Files) -> Result<(Scenario, ScenarioNode), Fault> {
        let Self { file, mut tree, as_written } = self;
        let overrides = from_outside(overrides);
        if let Some(as_written) = as_written {
            return Ok((as_written.resolved(&mut tree, &overrides)?, tree));
        }
        let (mounted, overrides) = parts::mount(&mut tree, file, overrides, files, false)?;
        let mut scenario = resolved(&mut tree, &overrides)?;
        scenario.parts = mounted.parts;
        Ok((scenario, tree))
    }
}

fn from_outside(overrides: &[(String, Value)]) -> Vec<Override<'_>> {
    overrides.iter().map(Override::from_outside).collect()
}

/// Returns the names of the files that a scenario needs, as far as the given `files` show: its parts, and the
/// files that its forces, joints and sea name. A part can name further files, so a host repeats the call
/// until there is no new name.
///
/// ```
/// use kingpost::scenario::{Files, file_names};
/// let text = "{version: 1, title: x, parts: {crane: {part: pedestal_crane}}}";
/// let names = file_names(text, "x.yaml", &[], &Files::default())?;
/// assert_eq!(names, ["gallery:parts/pedestal_crane.yaml"]);
/// # Ok::<(), kingpost::scenario::ScenarioError>(())
/// ```
///
/// # Errors
/// As [`read`], except for bodies, joints and drives that do not fit together, and for missing files.
pub fn file_names(
    text: &str,
    file: &str,
    overrides: &[(String, Value)],
    files: &Files,
) -> Result<Vec<String>, ScenarioError> {
    let names = || {
        let mut tree = parse::parse(text)?;
        check_version(&tree)?;
        let (mounted, overrides) = parts::mount(&mut tree, file, from_outside(overrides), files, true)?;
        let mut names = mounted.files;
        if !mounted.incomplete {
            let scenario = resolved(&mut tree, &overrides)?;
            let more = scenario.file_names().into_iter().filter(|name| !names.iter().any(|known| known == name));
            let more: Vec<String> = more.collect();
            names.extend(more);
        }
        Ok(names)
    };
    names().map_err(|fault: Fault| fault.in_file(file))
}

/// Returns a resolved scenario with another value of a parameter.
pub(super) fn changed(scenario: &Scenario, name: &str, value: &Value) -> Result<Scenario, ScenarioError> {
    let pair = (name.to_owned(), value.clone());
    let given = Override::from_outside(&pair);
    let mut tree = ScenarioNode::from_value(&scenario.written(), &given.place);
    let resolved = resolved(&mut tree, &[given]).map_err(|fault| ScenarioError::from(fault.error))?;
    Ok(Scenario { parts: scenario.parts.clone(), files: scenario.files.clone(), ..resolved })
}

/// Reads the scenario of a tree without parts, after parameters and overrides are applied.
fn resolved(tree: &mut ScenarioNode, overrides: &[Override<'_>]) -> Result<Scenario, Fault> {
    AsWritten::of(tree)?.resolved(tree, overrides)
}

impl AsWritten {
    fn of(tree: &ScenarioNode) -> Result<Self, Fault> {
        let scenario: Scenario = reading::read(tree)?;
        if tree.field("bodies").is_none() {
            return Err(Fault::new(&tree.place, "bodies", wording::NOTHING, wording::FIELDS));
        }
        let whole = scenario.to_value();
        Ok(Self { parameters: scenario.parameters, whole })
    }

    /// Applies parameters and overrides to a tree and reads the scenario.
    fn resolved(&self, tree: &mut ScenarioNode, overrides: &[Override<'_>]) -> Result<Scenario, Fault> {
        let target = OverrideTarget { tree, whole: &self.whole };
        let overwritten = parameters::apply(target, &self.parameters, overrides)?;
        let mut scenario: Scenario = reading::read(tree)?;
        scenario.overwritten = overwritten;
        for parameter in &mut scenario.parameters {
            parameter.default = None;
        }
        Ok(scenario)
    }
}

impl Scenario {
    /// Returns the resolved scenario as JSON, with every default; its parameters have no defaults, because
    /// the fields hold their values. Reading it gives the same scenario.
    pub fn to_json(&self) -> String {
        serde_json::to_string_pretty(self).unwrap_or_default()
    }

    /// Returns the setup of a simulation.
    ///
    /// # Errors
    /// Bodies, joints, forces, drives or settings that do not fit together; the error has a field but no place.
    pub fn setup(&self) -> Result<Setup, ScenarioError> {
        Ok(super::assembly::build(self)?)
    }

    /// Returns a simulation at time 0; an implicit scheme has exact derivatives.
    ///
    /// ```
    /// let text = include_str!("../../../../scenarios/paper.yaml");
    /// let scenario = kingpost::scenario::read(text, "paper.yaml", &[])?;
    /// assert_eq!(scenario.simulation()?.time_s(), 0.0);
    /// # Ok::<(), kingpost::scenario::ScenarioError>(())
    /// ```
    ///
    /// # Errors
    /// As [`setup`](Self::setup).
    pub fn simulation(&self) -> Result<Simulation, ScenarioError> {
        self.simulation_of(self.setup()?)
    }

    /// Returns a simulation of the scenario with its own setup.
    pub(crate) fn simulation_of(&self, setup: Setup) -> Result<Simulation, ScenarioError> {
        #[cfg(not(target_family = "wasm"))]
        let exact = self.exact_derivatives(&setup)?;
        #[cfg_attr(target_family = "wasm", expect(unused_mut))]
        let mut simulation = Simulation::new(setup);
        #[cfg(not(target_family = "wasm"))]
        if let Some(exact) = exact {
            simulation.differentiate_with(exact);
        }
        Ok(simulation)
    }

    #[cfg(not(target_family = "wasm"))]
    fn exact_derivatives(&self, setup: &Setup) -> Result<Option<Setup<Number>>, ScenarioError> {
        setup.settings.wants_derivatives().then(|| self.setup_over_with(setup)).transpose()
    }
}
