//! Conversion of the engine's typed errors to plain objects: `kind`, `message` and further fields.

use kingpost::hydrostatics::HydrostaticsError;
use kingpost::scenario::ScenarioError;
use kingpost::simulation::RunError;
use serde_json::{Value, json};
use wasm_bindgen::prelude::*;

/// Returns the error of a scenario that cannot be read, with the place of the error.
pub fn scenario(error: ScenarioError) -> JsValue {
    object(&json!({
        "kind": "scenario",
        "message": error.to_string(),
        "file": error.file,
        "line": error.line,
        "column": error.column,
        "field": error.field,
        "found": error.found,
        "allowed": error.allowed,
    }))
}

/// Returns the error of hulls that do not float.
pub fn hydrostatics(error: HydrostaticsError) -> JsValue {
    match error {
        HydrostaticsError::Scenario(error) => scenario(error),
        HydrostaticsError::Hull { .. } => input(error),
    }
}

/// Returns the error of a run that cannot continue.
pub fn run(error: RunError) -> JsValue {
    let (message, time_s) = (error.to_string(), error.time_s());
    let kind = match error {
        RunError::Diverged { .. } | RunError::NoNumber { .. } => "diverged",
        RunError::SingularLoop { .. } => "singular_loop",
        RunError::OpenLoop { .. } => "open_loop",
        RunError::UndeterminedRope { .. } | RunError::ShortRope { .. } => "rope_constraint",
        RunError::Steering { .. } => "operation",
        RunError::Step(_) | RunError::TooManyEvents { .. } | RunError::EventNotAlone { .. } => "step",
    };
    let Some((body, coordinate, value, limit)) = error.place() else {
        return object(&json!({ "kind": kind, "message": message, "time_s": time_s }));
    };
    object(&json!({
        "kind": kind,
        "message": message,
        "time_s": time_s,
        "body": body,
        "coordinate": coordinate,
        "value": value,
        "limit": limit,
    }))
}

/// Returns the error for an argument that the engine refuses.
pub fn input(error: impl ToString) -> JsValue {
    object(&json!({ "kind": "input", "message": error.to_string() }))
}

fn object(value: &Value) -> JsValue {
    parse(&value.to_string())
}

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(js_namespace = JSON)]
    fn parse(text: &str) -> JsValue;
}
