//! Gradients of results with respect to parameters, by dual numbers through the whole run.

use crate::dynamics::moving_frame::Variation;
use crate::plant::{DIRECTIONS, Form};
use crate::results::Channel;
use crate::scenario::{BuiltScenario, FieldError, Scenario, ScenarioError};
use crate::simulation::{RunError, Setup, Simulation};

/// A run and its derivatives.
#[derive(Clone, Debug)]
pub struct Gradient {
    /// The channels of a row.
    pub channels: Vec<Channel>,
    /// Rows in succession.
    pub rows: Vec<f64>,
    /// Derivatives of the rows with respect to each parameter, in the order of the names.
    pub derivatives: Vec<Vec<f64>>,
    /// Number of entries in a row.
    pub columns: usize,
    /// How the run ended; after an error the rows before it are kept.
    pub status: Result<(), RunError>,
}

impl Gradient {
    /// Removes all entries of the rows after the first `entries`.
    fn keep(&mut self, entries: usize) {
        self.rows.truncate(entries);
        self.derivatives.iter_mut().for_each(|rows| rows.truncate(entries));
    }
}

/// Runs a scenario from start to end with the derivative of every result with respect to every parameter (or
/// path of a number) in `names`. The derivatives are exact for the scheme and step: they are those of the
/// computed numbers, not of the exact motion. Only the derivative of an event's time is computed from the
/// rates of the motion, with the error of a step. `progress` is called with the time and stops the run by
/// returning false: the rows up to that time are kept.
///
/// # Errors
/// A name without a derivative: see [`Scenario::setup_along`]. Equations in the form without D.
pub fn gradient(
    scenario: &Scenario,
    names: &[&str],
    progress: impl FnMut(f64) -> bool,
) -> Result<Gradient, ScenarioError> {
    gradient_of(scenario, &scenario.setup()?, names, progress)
}

impl BuiltScenario {
    /// Returns a run with its derivatives, like [`gradient`].
    ///
    /// # Errors
    /// Fails for the same names as [`gradient`].
    pub fn gradient(&self, names: &[&str], progress: impl FnMut(f64) -> bool) -> Result<Gradient, ScenarioError> {
        gradient_of(self.scenario(), self.setup(), names, progress)
    }
}

/// Computes [`gradient`] with the setup `plain` that is already built.
fn gradient_of(
    scenario: &Scenario,
    plain: &Setup,
    names: &[&str],
    mut progress: impl FnMut(f64) -> bool,
) -> Result<Gradient, ScenarioError> {
    if plain.settings.form == Form::MovingFrame(Variation::Naive) {
        let allowed = "recursive or moving_frame, for a gradient";
        return Err(FieldError::new("simulation.form", "moving_frame_without_d", allowed).into());
    }
    let mut gradient: Option<Gradient> = None;
    let mut stopped = false;
    for chunk in names.chunks(DIRECTIONS) {
        let mut simulation = Simulation::recursive(scenario.setup_along_with(plain, chunk)?);
        let run = simulation.run(|time_s| {
            stopped = !progress(time_s);
            !stopped
        });
        let all = gradient.get_or_insert_with(|| Gradient {
            channels: simulation.channels().to_vec(),
            rows: run.rows.iter().map(|x| x.value).collect(),
            derivatives: Vec::with_capacity(names.len()),
            columns: run.columns,
            status: run.status.clone(),
        });
        for k in 0..chunk.len() {
            all.derivatives.push(run.rows.iter().map(|x| x.derivative[k]).collect());
        }
        if stopped {
            all.keep(run.rows.len());
            break;
        }
    }
    gradient.ok_or_else(|| FieldError::new("parameters", "none", "at least one name, for a gradient").into())
}
