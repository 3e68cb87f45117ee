//! The engine for a browser: conversions and thrown objects only.
//!
//! Arrays are passed as typed arrays, structured data as JSON.

mod thrown;

use kingpost::analysis;
use kingpost::scenario::{self, BuiltScenario, Files};
use serde_json::{Map, Value};
use std::collections::HashMap;
use wasm_bindgen::prelude::*;

/// A simulation of one scenario; a new one is at time 0.
#[wasm_bindgen]
pub struct Simulation {
    built: BuiltScenario,
    inner: kingpost::Simulation,
}

#[wasm_bindgen]
impl Simulation {
    /// Reads a scenario's text; `file` is its name in errors, `overrides_json` an object of values by parameter name or
    /// field path, `files_json` an object of texts by the names of [`file_names`].
    #[wasm_bindgen(constructor)]
    pub fn new(text: &str, file: &str, overrides_json: &str, files_json: &str) -> Result<Simulation, JsValue> {
        let files: HashMap<String, String> = serde_json::from_str(files_json).map_err(thrown::input)?;
        let (overrides, files) = (overrides(overrides_json)?, Files::new(files));
        let built = BuiltScenario::read(text, file, &overrides, &files).map_err(thrown::scenario)?;
        let inner = built.simulation().map_err(thrown::scenario)?;
        Ok(Self { built, inner })
    }

    /// Takes `n` steps. If a step diverges, throws the error and restores the state before that step.
    pub fn step(&mut self, n: u32) -> Result<(), JsValue> {
        self.inner.step(n as usize).map_err(thrown::run)
    }

    /// Goes back to time 0.
    pub fn reset(&mut self) {
        self.inner.reset();
    }

    /// Returns the natural modes about the equilibrium nearest to the present state: coordinate, period and damping
    /// ratio of each, in order of decreasing period.
    pub fn natural_modes_json(&self) -> Result<String, JsValue> {
        json(&analysis::natural_modes(&self.inner).map_err(thrown::input)?)
    }

    /// Returns the time, s.
    pub fn time_s(&self) -> f64 {
        self.inner.time_s()
    }

    /// Returns the step, s.
    pub fn step_s(&self) -> f64 {
        self.inner.settings().step_s
    }

    /// Returns the channels of a row, each with its columns, their units and labels, its offset and its length.
    pub fn channels_json(&self) -> Result<String, JsValue> {
        json(self.inner.channels())
    }

    /// Returns the present values of all channels.
    pub fn row(&mut self) -> Box<[f64]> {
        let mut row = Vec::with_capacity(self.inner.columns());
        self.inner.write_row(&mut row);
        row.into()
    }

    /// Returns the position (m) and unit quaternion (w, x, y, z) of every body, world: seven numbers per body.
    pub fn poses(&mut self) -> Box<[f64]> {
        self.inner.poses().into()
    }

    /// Returns the present elevation of the sea, m, at every grid point of x and y, world, m: all y of the first x,
    /// then of the next.
    pub fn surface(&self, x: &[f64], y: &[f64]) -> Box<[f64]> {
        self.inner.surface(x, y).into()
    }

    /// Returns the amplitudes of the regular waves that compose the sea, m; empty in calm water.
    pub fn wave_amplitudes_m(&self) -> Box<[f64]> {
        self.inner.waves().iter().map(|wave| wave.amplitude_m).collect()
    }

    /// Returns the phases of these waves at the world's origin at time 0, rad.
    pub fn wave_phases_rad(&self) -> Box<[f64]> {
        self.inner.waves().iter().map(|wave| wave.phase_rad).collect()
    }

    /// Returns the complex elevation of each of these waves at a point of the world, m, and a time, s, with the ramp:
    /// the real parts, then the imaginary parts. The sum of the real parts is the elevation of the sea.
    pub fn wave_phasors(&self, x_m: f64, y_m: f64, time_s: f64) -> Box<[f64]> {
        self.inner.wave_phasors([x_m, y_m], time_s).concat().into()
    }

    /// Replaces the amplitudes and phases of the waves; their frequencies and directions stay.
    pub fn set_waves(&mut self, amplitudes_m: &[f64], phases_rad: &[f64]) -> Result<(), JsValue> {
        self.inner.set_waves(amplitudes_m, phases_rad).map_err(thrown::input)
    }

    /// Returns the warnings of the rows so far: time, name and text of each.
    pub fn warnings_json(&self) -> Result<String, JsValue> {
        json(&self.inner.warnings())
    }

    /// Returns the events of the run so far in order of time, without the first `first`: time, element and text of
    /// each.
    pub fn events_json(&self, first: usize) -> Result<String, JsValue> {
        json(self.inner.events().get(first..).unwrap_or_default())
    }

    /// Returns the lines to draw in addition to the bodies: name, style, radius and number of points of each.
    pub fn lines_json(&self) -> Result<String, JsValue> {
        json(&self.inner.lines())
    }

    /// Returns the present points of the drawn lines, line by line: x, y, z, m, world.
    pub fn line_points(&mut self) -> Box<[f64]> {
        self.inner.line_points().into()
    }

    /// Returns the complete state as bytes.
    pub fn snapshot(&self) -> Box<[u8]> {
        self.inner.snapshot().into()
    }

    /// Continues from a snapshot, bit by bit as the original run.
    pub fn restore(&mut self, snapshot: &[u8]) -> Result<(), JsValue> {
        self.inner.restore(snapshot).map_err(thrown::input)
    }

    /// Returns the inputs: name, unit, limits and value of each.
    pub fn inputs_json(&self) -> Result<String, JsValue> {
        json(&self.inner.inputs())
    }

    /// Sets an input from the next step on.
    pub fn set_input(&mut self, name: &str, value: f64) -> Result<(), JsValue> {
        self.inner.set_input(name, value).map_err(thrown::input)
    }

    /// Returns the user's moves so far: time, input and value of each.
    pub fn lever_moves_json(&self) -> Result<String, JsValue> {
        json(&self.inner.lever_moves())
    }

    /// Returns the parameters set since the start of the run: time and name of each. A replay does not contain them.
    pub fn parameters_set_json(&self) -> Result<String, JsValue> {
        json(&self.inner.parameters_set())
    }

    /// Returns the resolved scenario with the user's moves as its operation.
    pub fn replay_json(&self) -> Result<String, JsValue> {
        Ok(self.built.scenario().replay(&self.inner).map_err(thrown::input)?.to_json())
    }

    /// Sets a live parameter to a value in JSON, from the next step on.
    pub fn set_parameter(&mut self, name: &str, value_json: &str) -> Result<(), JsValue> {
        let value = serde_json::from_str(value_json).map_err(thrown::input)?;
        self.built = self.built.set_parameter(&mut self.inner, name, &value).map_err(thrown::input)?;
        Ok(())
    }

    /// Returns the description of the model: title, bodies with their shapes, joints, parameters, settings.
    pub fn model_json(&self) -> Result<String, JsValue> {
        json(self.built.describe())
    }

    /// Returns the hydrostatics of the hulls at rest with the crane in its present position: draught, heel, trim, GM,
    /// righting arms.
    pub fn hydrostatics_json(&self) -> Result<String, JsValue> {
        json(&self.built.hydrostatic_report_at(&self.inner).map_err(thrown::hydrostatics)?)
    }

    /// Returns the present matrices of the moving frame method, with labels, units and formulas.
    pub fn equations_json(&mut self) -> Result<String, JsValue> {
        json(&self.inner.equations())
    }

    /// Returns the scenario with defaults, parameters and overrides applied; reading it gives the same scenario.
    pub fn resolved_json(&self) -> String {
        self.built.scenario().to_json()
    }
}

/// Returns a list of the files that a scenario needs, as far as the files in `files_json` name them; repeat the call
/// until no new name appears.
#[wasm_bindgen]
pub fn file_names(text: &str, file: &str, overrides_json: &str, files_json: &str) -> Result<String, JsValue> {
    let files: HashMap<String, String> = serde_json::from_str(files_json).map_err(thrown::input)?;
    let names = scenario::file_names(text, file, &overrides(overrides_json)?, &Files::new(files));
    json(&names.map_err(thrown::scenario)?)
}

/// Reads a scenario without building it and returns it resolved, in the format of [`Simulation::resolved_json`], with
/// its title and its description.
#[wasm_bindgen]
pub fn resolved(text: &str, file: &str, overrides_json: &str, files_json: &str) -> Result<String, JsValue> {
    let files: HashMap<String, String> = serde_json::from_str(files_json).map_err(thrown::input)?;
    let read = scenario::read_with(text, file, &overrides(overrides_json)?, &Files::new(files));
    Ok(read.map_err(thrown::scenario)?.to_json())
}

fn overrides(json: &str) -> Result<Vec<(String, Value)>, JsValue> {
    let overrides: Map<String, Value> = serde_json::from_str(json).map_err(thrown::input)?;
    Ok(overrides.into_iter().collect())
}

fn json<T: serde::Serialize + ?Sized>(value: &T) -> Result<String, JsValue> {
    serde_json::to_string(value).map_err(thrown::input)
}
